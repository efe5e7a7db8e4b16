/**
 * @file
 * @brief The estimate of float's errors, in both directions, against whole pictures in double.
 */
#include "load_scene.h"
#include "testing.h"

#include "base/encoding.h"
#include "dioptre/renderer.h"
#include "dioptre/script.h"
#include "render/precision_estimate.h"
#include "render/roundoff.h"

#include <math.h>
#include <stdlib.h>

/** Size of the pictures. */
enum { WIDTH = 160, HEIGHT = 120, PIXELS = WIDTH * HEIGHT };

/** Largest fraction of wrong pixels in a picture for which float is chosen. */
#define FRACTION_ALLOWED 5e-4

/** Throughput below which rays end: both pictures lose the same light. */
#define CUTOFF 1.5e-4

/** A scene and its estimate. */
typedef struct Expectation {
    const char *path;     /**< Its file. */
    bool is_float;        /**< Whether float is chosen. */
    PrecisionCause cause; /**< If not: why. */
} Expectation;

/** Scenes that must be drawn in double, and their harmless neighbours. */
static const Expectation expectations[] = {
    {"tests/scenes/overlapping-balls.lua", false, PRECISION_TRAPPED_LIGHT},
    {"tests/scenes/bubbles.lua", false, PRECISION_TRAPPED_LIGHT},
    {"tests/scenes/ellipsoids.lua", false, PRECISION_TRAPPED_LIGHT},
    {"tests/scenes/glass-cones.lua", false, PRECISION_TRAPPED_LIGHT},
    {"tests/scenes/round-glass.lua", false, PRECISION_TRAPPED_LIGHT},
    {"tests/scenes/mirror-in-glass.lua", false, PRECISION_TRAPPED_LIGHT},
    {"tests/scenes/regular-glass.lua", true, 0},
    {"tests/scenes/mirror-room.lua", false, PRECISION_RAY_DIVERGENCE},
    {"tests/scenes/touching-balls.lua", true, 0},
    {"scenes/glass-sphere.lua", true, 0},
    {"scenes/figure-18.lua", true, 0},
    {"scenes/melting.lua", true, 0},
    {"tests/scenes/telescope.lua", true, 0},
    {"tests/scenes/telescope-aslant.lua", false, PRECISION_DISTANCE}};

/** @return A scene from its file, in the size of the pictures. */
static Scene *load_small_scene(const char *path) {
    Scene *scene = load_scene(path);
    scene->image.width = WIDTH;
    scene->image.height = HEIGHT;
    return scene;
}

/** Traces a picture of a scene. */
static void trace_scene(const char *engine_name, const Scene *scene, double *rgb) {
    Error error = {0};
    const Engine *engine = engine_find(engine_name, &error);
    assert_non_null(engine);
    TraceSettings settings = render_settings_default(scene).trace;
    settings.cutoff = CUTOFF;
    settings.samples = 1;
    Tracer *tracer = engine->create_tracer(scene, &settings, &error);
    assert_non_null(tracer);
    PixelGrid grid = {.columns = WIDTH, .rows = HEIGHT, .stride = 1};
    RayCounts counts = {0};
    engine->set_view(tracer, scene, WIDTH, HEIGHT);
    engine->trace(tracer, &grid, rgb, &counts);
    engine->destroy(tracer);
}

/** @return The fraction of the pixels that an engine draws wrongly by more than a step.
 *  @param reference The engine that is right. */
static double wrong_fraction_of(const char *engine_name, const Scene *scene,
                                const char *reference) {
    static double single[3 * PIXELS], exact[3 * PIXELS];
    trace_scene(engine_name, scene, single);
    trace_scene(reference, scene, exact);
    int wrong = 0;
    for (int i = 0; i < PIXELS; i++) {
        double worst = 0;
        for (int channel = 0; channel < 3; channel++) {
            size_t at = (size_t)(channel * PIXELS + i);
            worst = fmax(worst, fabs(encoding_encode(ENCODING_SRGB, single[at]) -
                                     encoding_encode(ENCODING_SRGB, exact[at])));
        }
        wrong += worst > 1;
    }
    return (double)wrong / PIXELS;
}

/** @return The fraction of the pixels that float draws wrongly by more than a step. */
static double wrong_fraction(const Scene *scene) {
    return wrong_fraction_of("auto", scene, "f64x1");
}

/** The estimate says double where float draws pixels wrongly, and float where it does not. */
static void test_estimates(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof expectations / sizeof *expectations; i++) {
        const Expectation *row = &expectations[i];
        Scene *scene = load_small_scene(row->path);
        PrecisionEstimate estimate = precision_estimate_of(scene);
        double fraction = wrong_fraction(scene);
        printf("%-38s estimate %.2g steps, %.3g %% wrong in float\n", row->path,
               precision_estimate_error(&estimate), 100 * fraction);
        if ((precision_estimate_error(&estimate) < PRECISION_VISIBLE_ERROR) != row->is_float) {
            fail_msg("%s: estimate %g", row->path, precision_estimate_error(&estimate));
        }
        if (row->is_float) {
            assert_at_most(fraction, FRACTION_ALLOWED, "%s: wrong in float", row->path);
        } else {
            assert_int_equal((int)estimate.cause, (int)row->cause);
            assert_true(fraction > 0);
        }
        scene_destroy(scene);
    }
}

/** At few turns, light in overlapping glass is exact in float: double is not chosen. */
static void test_shallow_glass_needs_no_double(void **state) {
    (void)state;
    Scene *scene = load_small_scene("tests/scenes/overlapping-balls.lua");
    scene->image.depth = 8;
    PrecisionEstimate estimate = precision_estimate_of(scene);
    assert_true(precision_estimate_error(&estimate) < PRECISION_VISIBLE_ERROR);
    assert_at_most(wrong_fraction(scene), 0, "wrong at depth 8");
    scene_destroy(scene);
}

/* --- z-fighting ------------------------------------------------------------------------------- */

/** Points the camera of a scene, with a field of view of 40 degrees. */
static void look_from(Scene *scene, Vec3d position) {
    /** The bit of `look_at` among the given fields. */
    enum { GIVES_LOOK_AT = 1 << 1 };
    Error error = {0};
    scene->camera.position = position;
    scene->camera.look_at = (Vec3d){0, 0, 0};
    scene->camera.fov = 40;
    assert_true(scene_camera_keyword.finish(&scene->camera, GIVES_LOOK_AT, &error));
}

/** @return A scene with ambient light, seen from a distance; to be destroyed. */
static Scene *create_bright_scene(double distance) {
    Scene *scene = create_empty_scene();
    scene->image.width = WIDTH;
    scene->image.height = HEIGHT;
    scene->ambient = (Rgbd){1, 1, 1};
    look_from(scene, (Vec3d){0, distance / 6, distance});
    return scene;
}

/** Adds a material, for the shapes that follow. */
static void add_color(Scene *scene, Rgbd color, double reflectivity) {
    Error error = {0};
    SceneMaterial material = *(const SceneMaterial *)scene_material_keyword.defaults;
    material.color = color;
    material.reflectivity = (Rgbd){reflectivity, reflectivity, reflectivity};
    assert_true(scene_add_material(scene, &material, &error));
}

/** Adds a red material. */
static void add_red(Scene *scene) {
    add_color(scene, (Rgbd){0.8, 0.1, 0.1}, 0);
}

/** Adds a blue material. */
static void add_blue(Scene *scene) {
    add_color(scene, (Rgbd){0.1, 0.1, 0.9}, 0);
}

/** Rotates the newest shape, about all axes. */
static void rotate_newest(Scene *scene) {
    Error error = {0};
    Transform how = *(const Transform *)transform_keyword.defaults;
    how.rotate = (Vec3d){11, 23, 7};
    assert_true(transform_keyword.finish(&how, 0, &error));
    assert_true(scene_set_last_transform(scene, &how, &error));
}

/** Adds a square at a height. @param half Half its side. */
static void add_level_quad(Scene *scene, double half, double y) {
    add_shape(scene, "quad",
              &(QuadParameters){{-half, y, -half}, {0, 0, 2 * half}, {2 * half, 0, 0}});
}

/** Two surfaces that are a gap apart. */
typedef struct NearPair {
    const char *name; /**< Its name. */
    double distance;  /**< Distance of the eye from the middle, about. */
    double height;    /**< That from the surfaces. */
    bool is_said;     /**< Whether it is said if they coincide: they are flat and opaque. */
    void (*add)(Scene *scene, double gap); /**< Adds it. */
} NearPair;

/** Adds a disk above a sloping plane. */
static void add_disk_on_plane(Scene *scene, double gap) {
    const Vec3d normal = {0.3, 1, 0.2};
    double along = gap / vec3d_length(normal);
    add_red(scene);
    add_shape(scene, "plane", &(PlaneParameters){{0, -1, 0}, normal});
    add_blue(scene);
    add_shape(scene, "disk",
              &(DiskParameters){{0.3 * along, -1 + along, 0.2 * along}, normal, 1.2});
}

/** Adds a quad above a box. */
static void add_quad_on_box(Scene *scene, double gap) {
    add_red(scene);
    add_shape(scene, "box", &(BoxParameters){{-2, -1.5, -2}, {2, -1, 2}});
    add_blue(scene);
    add_level_quad(scene, 1, -1 + gap);
}

/** Adds two rotated quads. */
static void add_rotated_quads(Scene *scene, double gap) {
    add_red(scene);
    add_level_quad(scene, 3, -1);
    rotate_newest(scene);
    add_blue(scene);
    add_level_quad(scene, 2, -1 + gap);
    rotate_newest(scene);
}

/** Adds two rotated boxes, a thousandth of a unit small. */
static void add_small_boxes(Scene *scene, double gap) {
    add_red(scene);
    add_shape(scene, "box", &(BoxParameters){{-2e-3, -2e-3, -2e-3}, {2e-3, -1e-3, 2e-3}});
    rotate_newest(scene);
    add_blue(scene);
    add_shape(scene, "box", &(BoxParameters){{-1e-3, -2e-3, -1e-3}, {1e-3, -1e-3 + gap, 1e-3}});
    rotate_newest(scene);
}

/** Adds a disk above a plane, ten thousand units away. */
static void add_far_disk(Scene *scene, double gap) {
    add_red(scene);
    add_shape(scene, "plane", &(PlaneParameters){{0, -1, 0}, {0, 1, 0}});
    add_blue(scene);
    add_shape(scene, "disk", &(DiskParameters){{0, -1 + gap, 0}, {0, 1, 0}, 2000});
}

/** Adds two triangles. */
static void add_triangles(Scene *scene, double gap) {
    add_red(scene);
    add_shape(scene, "triangle",
              &(TriangleParameters){.corners = {{-2, -1, 1}, {2, -1, 1}, {0, 1, -2}}});
    add_blue(scene);
    add_shape(
        scene, "triangle",
        &(TriangleParameters){.corners = {{-2, -1, 1 + gap}, {2, -1, 1 + gap}, {0, 1, -2 + gap}}});
}

/** Adds a mesh above a plane. */
static void add_mesh_on_plane(Scene *scene, double gap) {
    const Vec3d positions[] = {{-2, -1 + gap, 2}, {2, -1 + gap, 2}, {0, -1 + gap, -2}};
    add_red(scene);
    add_shape(scene, "plane", &(PlaneParameters){{0, -1, 0}, {0, 1, 0}});
    add_blue(scene);
    add_mesh(scene, positions, 3, &(MeshTriangle){{0, 1, 2}}, 1, NORMALS_FLAT);
}

/** Adds two spheres around each other. */
static void add_spheres(Scene *scene, double gap) {
    add_red(scene);
    add_shape(scene, "sphere", &(SphereParameters){{0, 0, 0}, 1});
    add_blue(scene);
    add_shape(scene, "sphere", &(SphereParameters){{0, 0, 0}, 1 + gap});
}

/** Adds a ring around a cylinder. */
static void add_cylinders(Scene *scene, double gap) {
    add_red(scene);
    add_shape(scene, "cylinder", &(CylinderParameters){{0, -1, 0}, {0, 1, 0}, 1, true});
    add_blue(scene);
    add_shape(scene, "cylinder", &(CylinderParameters){{0, -0.5, 0}, {0, 0.5, 0}, 1 + gap, false});
}

/** Scales the newest shape and rotates it about z. */
static void stretch_newest(Scene *scene, Vec3d scale) {
    Error error = {0};
    Transform how = *(const Transform *)transform_keyword.defaults;
    how.scale = scale;
    how.rotate = (Vec3d){0, 0, 30};
    assert_true(transform_keyword.finish(&how, 0, &error));
    assert_true(scene_set_last_transform(scene, &how, &error));
}

/** Adds two ellipsoids around each other. The gap is that between their short axes. */
static void add_ellipsoids(Scene *scene, double gap) {
    const Vec3d scale = {1.5, 1, 1.2};
    add_red(scene);
    add_shape(scene, "sphere", &(SphereParameters){{0, 0, 0}, 1});
    stretch_newest(scene, scale);
    add_blue(scene);
    add_shape(scene, "sphere", &(SphereParameters){{0, 0, 0}, 2});
    stretch_newest(scene, vec3d_scale(scale, (1 + gap) / 2));
}

/** Adds a ring around a cone of the same slope. */
static void add_cones(Scene *scene, double gap) {
    add_red(scene);
    add_shape(scene, "cone", &(ConeParameters){{0, -1, 0}, {0, 1, 0}, 1, 0.2, true});
    add_blue(scene);
    add_shape(scene, "cone",
              &(ConeParameters){{0, -0.5, 0}, {0, 0.5, 0}, 0.8 + gap, 0.4 + gap, false});
}

/** Adds a disk above the top of a cone. */
static void add_disk_on_cone(Scene *scene, double gap) {
    add_red(scene);
    add_shape(scene, "cone", &(ConeParameters){{0, -2, 0}, {0, -1, 0}, 2, 1.5, true});
    add_blue(scene);
    add_shape(scene, "disk", &(DiskParameters){{0, -1 + gap, 0}, {0, 1, 0}, 1.2});
}

/** Adds a light that is a square of side 1, upright. @param corner Its lowest corner. */
static void add_panel(Scene *scene, Vec3d corner) {
    Error error = {0};
    size_t kind = 0;
    while (strcmp(scene_light_classes[kind]->keyword->name, "rectangle_light") != 0) {
        kind++;
    }
    SceneLight light = *(const SceneLight *)scene_light_classes[kind]->keyword->defaults;
    const double edges[] = {1, 0, 0, 0, 1, 0};
    memcpy(light.own, edges, sizeof edges);
    light.class_index = kind;
    light.position = corner;
    assert_true(scene_add_light(scene, &light, &error));
}

/** Adds a glowing panel before a wall. */
static void add_panel_on_wall(Scene *scene, double gap) {
    add_panel(scene, (Vec3d){-0.5, -0.5, -2 + gap});
    add_red(scene);
    add_shape(scene, "quad", &(QuadParameters){{-3, -3, -2}, {6, 0, 0}, {0, 6, 0}});
}

/** Adds a disk before a wall behind the eye, which a mirror shows. */
static void add_mirrored_disk(Scene *scene, double gap) {
    add_color(scene, (Rgbd){0, 0, 0}, 0.9);
    add_shape(scene, "quad", &(QuadParameters){{-3, -3, -3}, {6, 0, 0}, {0, 6, 0}});
    add_red(scene);
    add_shape(scene, "box", &(BoxParameters){{-3, -3, 7}, {3, 3, 8}});
    add_blue(scene);
    add_shape(scene, "disk", &(DiskParameters){{0, 0, 7 - gap}, {0, 0, -1}, 2});
}

/** Adds two planes that cross at a small angle. */
static void add_crossing_planes(Scene *scene, double gap) {
    add_red(scene);
    add_shape(scene, "plane", &(PlaneParameters){{0, -1, 0}, {0, 1, 0}});
    add_blue(scene);
    add_shape(scene, "plane", &(PlaneParameters){{0.3, -1, 0}, {gap, 1, 0}});
}

/** Adds a block of glass above a floor. Total reflection at its underside depends on the gap. */
static void add_glass_on_floor(Scene *scene, double gap) {
    Error error = {0};
    SceneMaterial glass = *(const SceneMaterial *)scene_material_keyword.defaults;
    glass.color = (Rgbd){0, 0, 0};
    glass.transparency = (Rgbd){1, 1, 1};
    glass.ior = 1.5;
    scene->sky.horizon = scene->sky.zenith = (Rgbd){0.8, 0.85, 0.9};
    add_red(scene);
    add_shape(scene, "plane", &(PlaneParameters){{0, -1, 0}, {0, 1, 0}});
    assert_true(scene_add_material(scene, &glass, &error));
    add_shape(scene, "cylinder", &(CylinderParameters){{0, -1 + gap, 0}, {0, 0.5, 0}, 1, true});
}

/** Pairs of surfaces of all kinds, at all scales. */
static const NearPair near_pairs[] = {{"disk on plane", 6, 3.2, true, add_disk_on_plane},
                                      {"quad on box", 6, 2, true, add_quad_on_box},
                                      {"rotated quads", 6, 3, true, add_rotated_quads},
                                      {"small rotated boxes", 6e-3, 3e-3, true, add_small_boxes},
                                      {"far disk on plane", 1e4, 1700, true, add_far_disk},
                                      {"triangles", 6, 4.5, true, add_triangles},
                                      {"mesh on plane", 6, 2, true, add_mesh_on_plane},
                                      {"spheres", 6, 5, false, add_spheres},
                                      {"cylinders", 6, 5, false, add_cylinders},
                                      {"ellipsoids", 6, 5, false, add_ellipsoids},
                                      {"cones", 6, 5, false, add_cones},
                                      {"disk on cone", 6, 2, true, add_disk_on_cone},
                                      {"panel on wall", 6, 8, false, add_panel_on_wall},
                                      {"disk in a mirror", 6, 10, true, add_mirrored_disk},
                                      {"glass on floor", 6, 2, false, add_glass_on_floor}};

/**
 * Surfaces at gaps from half a rounding of their distance to 64. Double is chosen where float is
 * wrong, and float where the gap is wide. Quad decides whether double is right.
 */
static void test_near_surfaces(void **state) {
    (void)state;
    const double gaps[] = {0.5, 1, 2, 4, 8, 64};
    const char *fastest = engine_with_role(ENGINE_FASTEST)->name;
    for (size_t i = 0; i < sizeof near_pairs / sizeof *near_pairs; i++) {
        const NearPair *pair = &near_pairs[i];
        for (size_t k = 0; k < sizeof gaps / sizeof *gaps; k++) {
            Scene *scene = create_bright_scene(pair->distance);
            pair->add(scene, gaps[k] * FLOAT_ROUNDOFF * pair->height);
            PrecisionEstimate estimate = precision_estimate_of(scene);
            const char *chosen = precision_estimate_engine(&estimate)->name;
            double in_float = wrong_fraction(scene);
            printf("%-20s gap %3g roundings: %s, %.2g %% wrong in float\n", pair->name, gaps[k],
                   chosen, 100 * in_float);
            if (strcmp(chosen, fastest) == 0) {
                assert_at_most(in_float, FRACTION_ALLOWED, "%s, gap %g", pair->name, gaps[k]);
            } else if (k == 1) {
                assert_at_most(wrong_fraction_of(chosen, scene, "f128x1"), FRACTION_ALLOWED,
                               "%s in double", pair->name);
            }
            if (k == 0) {
                assert_true(in_float > FRACTION_ALLOWED);
                assert_int_equal((int)estimate.cause, PRECISION_Z_FIGHTING);
            } else if (gaps[k] == 64) {
                assert_string_equal(chosen, fastest);
            }
            scene_destroy(scene);
        }
    }
}

/** Adds a floor of tiles that touch edge to edge. @param is_rotated Whether they lie aslant. */
static void add_tiles(Scene *scene, bool is_rotated) {
    for (int i = 0; i < 24 * 24; i++) {
        i % 2 ? add_red(scene) : add_blue(scene);
        Vec3d corner = {(i / 24 - 12) * 0.7, -1, (i % 24 - 12) * 0.7};
        add_shape(scene, "quad", &(QuadParameters){corner, {0, 0, 0.7}, {0.7, 0, 0}});
        if (is_rotated) {
            rotate_newest(scene);
        }
    }
}

/** Adds tiles along the axes. @param unused Not used. */
static void add_level_tiles(Scene *scene, double unused) {
    (void)unused;
    add_tiles(scene, false);
}

/** Adds tiles that lie aslant. @param unused Not used. */
static void add_rotated_tiles(Scene *scene, double unused) {
    (void)unused;
    add_tiles(scene, true);
}

/** Adds boxes that stand on one another and on a floor. @param gap Between them. */
static void add_stack(Scene *scene, double gap) {
    add_red(scene);
    add_shape(scene, "plane", &(PlaneParameters){{0, -1, 0}, {0, 1, 0}});
    for (int i = 0; i < 4; i++) {
        i % 2 ? add_red(scene) : add_blue(scene);
        BoxParameters box = {{-1, -1 + 0.3 * i + gap, -1}, {1, -1 + 0.3 * (i + 1), 1}};
        add_shape(scene, "box", &box);
    }
}

/** Adds boxes of one height side by side. @param gap Not used. */
static void add_row(Scene *scene, double gap) {
    (void)gap;
    for (int i = 0; i < 9; i++) {
        i % 2 ? add_red(scene) : add_blue(scene);
        add_shape(scene, "box", &(BoxParameters){{0.1 * i, -1, 0}, {0.1 * (i + 1), -0.7, 1}});
    }
}

/** Adds two near quads that only a part of space outside the picture shows. @param gap Between
 *  them. */
static void add_beside_picture(Scene *scene, double gap) {
    add_red(scene);
    add_shape(scene, "quad", &(QuadParameters){{-10, 0, 20}, {20, 0, 0}, {0, 10, 0}});
    add_blue(scene);
    add_shape(scene, "quad", &(QuadParameters){{-10, 0, 20 - gap}, {20, 0, 0}, {0, 10, 0}});
}

/** A scene whose surfaces touch or lie near each other, but do not fight. */
typedef struct HarmlessScene {
    const char *name; /**< Its name. */
    double gap;       /**< Gap between the surfaces, scene units; negative: they overlap. */
    void (*add)(Scene *scene, double gap); /**< Adds them. */
} HarmlessScene;

/** Scenes that look alike, where float is right. */
static const HarmlessScene harmless_scenes[] = {{"tiles edge to edge", 0, add_level_tiles},
                                                {"rotated tiles", 0, add_rotated_tiles},
                                                {"stacked boxes", 0, add_stack},
                                                {"boxes a trace above", 1e-8, add_stack},
                                                {"boxes in each other", -1e-8, add_stack},
                                                {"row of boxes", 0, add_row},
                                                {"beside the picture", 1e-7, add_beside_picture},
                                                {"a cornea", 4e-5, add_spheres}};

/** Faces that touch in an edge, or that rays cannot reach, do not count: float is chosen, and
 *  right. */
static void test_harmless_neighbours(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof harmless_scenes / sizeof *harmless_scenes; i++) {
        const char *name = harmless_scenes[i].name;
        Scene *scene = create_bright_scene(6);
        harmless_scenes[i].add(scene, harmless_scenes[i].gap);
        PrecisionEstimate estimate = precision_estimate_of(scene);
        assert_at_most(estimate.errors[PRECISION_Z_FIGHTING], PRECISION_VISIBLE_ERROR / 10, "%s",
                       name);
        assert_at_most(wrong_fraction(scene), FRACTION_ALLOWED, "%s: wrong in float", name);
        scene_destroy(scene);
    }
}

/** Planes that cross fight around the line where they meet: the smaller the angle, the wider. */
static void test_crossing_planes(void **state) {
    (void)state;
    const double slopes[] = {1e-6, 1e-5, 1e-2};
    for (size_t i = 0; i < sizeof slopes / sizeof *slopes; i++) {
        Scene *scene = create_bright_scene(6);
        add_crossing_planes(scene, slopes[i]);
        PrecisionEstimate estimate = precision_estimate_of(scene);
        bool is_double = precision_estimate_error(&estimate) >= PRECISION_VISIBLE_ERROR;
        double in_float = wrong_fraction(scene);
        printf("planes at a slope of %g: estimate %.2g steps, %.2g %% wrong in float\n", slopes[i],
               precision_estimate_error(&estimate), 100 * in_float);
        assert_true(is_double == (slopes[i] < 1e-3));
        assert_true(is_double == (in_float > FRACTION_ALLOWED));
        scene_destroy(scene);
    }
}

/** Flat surfaces that coincide exactly are no reason for double, which cannot tell them apart
 *  either. It is said where they are opaque and look different. */
static void test_coincident_surfaces(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof near_pairs / sizeof *near_pairs; i++) {
        Scene *scene = create_bright_scene(near_pairs[i].distance);
        near_pairs[i].add(scene, 0);
        ZFighting found = z_fighting_of(scene);
        assert_at_most(found.fraction, 0, "%s", near_pairs[i].name);
        assert_true((found.coincident >= Z_FIGHTING_COINCIDENT_SAID) == near_pairs[i].is_said);
        scene_destroy(scene);
    }
    for (size_t i = 0; i < sizeof harmless_scenes / sizeof *harmless_scenes; i++) {
        Scene *scene = create_bright_scene(6);
        harmless_scenes[i].add(scene, harmless_scenes[i].gap);
        assert_at_most(z_fighting_of(scene).coincident, Z_FIGHTING_COINCIDENT_SAID / 2, "%s",
                       harmless_scenes[i].name);
        scene_destroy(scene);
    }
}

/** Adds a wall of balls whose boxes begin at the same x. @param side Balls along its sides. */
static void add_wall_of_balls(Scene *scene, int side) {
    for (int i = 0; i < side * side; i++) {
        Vec3d center = {0, (i / side - side / 2) * 0.05, (i % side - side / 2) * 0.05};
        add_shape(scene, "sphere", &(SphereParameters){center, 0.02});
    }
}

/** In a wall of balls few pairs are compared, and one that fights is found. */
static void test_wall_of_balls(void **state) {
    (void)state;
    /** Balls along a side: about 20,000 in all. */
    enum { SIDE = 141, BALLS = SIDE * SIDE };
    Scene *scene = create_bright_scene(6);
    add_red(scene);
    add_wall_of_balls(scene, SIDE);
    ZFighting found = z_fighting_of(scene);
    assert_at_most((double)found.pairs, 10.0 * BALLS, "pairs of %d balls", BALLS);
    assert_at_most(found.fraction, 0, "balls that are apart");
    add_blue(scene);
    add_shape(scene, "sphere", &(SphereParameters){{0, 0, 0}, 0.02 + 1e-8});
    assert_true(z_fighting_of(scene).fraction > 0);
    scene_destroy(scene);
}

/** Adds balls at the same place. */
static void add_nested_balls(Scene *scene) {
    for (int i = 0; i < 2000; i++) {
        add_shape(scene, "sphere", &(SphereParameters){{0, 0, 0}, 1 + 1e-9 * i});
    }
}

/** Adds squares, and planes that none of them touches. */
static void add_planes_and_quads(Scene *scene) {
    for (int i = 0; i < 1200; i++) {
        add_level_quad(scene, 0.1, -1 - i);
        add_shape(scene, "plane", &(PlaneParameters){{0, i + 1, 0}, {0, 1, 0}});
    }
}

/** Adds squares, and panels that give light and touch none of them. */
static void add_lights_and_quads(Scene *scene) {
    for (int i = 0; i < 1200; i++) {
        add_panel(scene, (Vec3d){0, 2 * i + 1, 0});
        add_level_quad(scene, 0.1, -1 - i);
    }
}

/** However shapes stand, a limited number of pairs is compared. */
static void test_limit_of_pairs(void **state) {
    (void)state;
    void (*const adds[])(Scene *) = {add_nested_balls, add_planes_and_quads, add_lights_and_quads};
    for (size_t i = 0; i < sizeof adds / sizeof *adds; i++) {
        Scene *scene = create_bright_scene(6);
        add_red(scene);
        adds[i](scene);
        assert_int_equal(z_fighting_of(scene).pairs, Z_FIGHTING_PAIRS_MAXIMUM);
        scene_destroy(scene);
    }
}

/** A mesh of very many vertices on a floor does not hide a small one that fights with it. */
static void test_huge_mesh(void **state) {
    (void)state;
    /** More vertices than the search looks at. */
    enum { VERTICES = (1 << 22) + 64 };
    Vec3d *positions = calloc(VERTICES, sizeof *positions);
    assert_non_null(positions);
    positions[0] = (Vec3d){0, -1, 0};
    positions[1] = (Vec3d){0, 1, 1};
    Scene *scene = create_bright_scene(6);
    add_red(scene);
    add_mesh(scene, positions, VERTICES, &(MeshTriangle){{0, 1, 2}}, 1, NORMALS_FLAT);
    add_mesh_on_plane(scene, FLOAT_ROUNDOFF);
    assert_true(z_fighting_of(scene).fraction > 0);
    scene_destroy(scene);
    free(positions);
}

/** The estimate's error is its largest, whichever cause is named. */
static void test_error_is_largest(void **state) {
    (void)state;
    PrecisionEstimate estimate = {.cause = PRECISION_THIN_GLASS};
    estimate.errors[PRECISION_THIN_GLASS] = PRECISION_VISIBLE_ERROR;
    estimate.errors[PRECISION_Z_FIGHTING] = 4;
    assert_true(precision_estimate_error(&estimate) == 4);
    Scene *scene = create_bright_scene(6);
    add_glass_on_floor(scene, FLOAT_ROUNDOFF);
    estimate = precision_estimate_of(scene);
    for (int cause = 0; cause < PRECISION_CAUSE_COUNT; cause++) {
        assert_true(estimate.errors[cause] <= precision_estimate_error(&estimate));
    }
    assert_true(estimate.z_fighting.fraction == z_fighting_of(scene).fraction);
    scene_destroy(scene);
}

/** @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_estimates),
                                       cmocka_unit_test(test_shallow_glass_needs_no_double),
                                       cmocka_unit_test(test_near_surfaces),
                                       cmocka_unit_test(test_harmless_neighbours),
                                       cmocka_unit_test(test_crossing_planes),
                                       cmocka_unit_test(test_coincident_surfaces),
                                       cmocka_unit_test(test_wall_of_balls),
                                       cmocka_unit_test(test_limit_of_pairs),
                                       cmocka_unit_test(test_huge_mesh),
                                       cmocka_unit_test(test_error_is_largest)};
    return cmocka_run_group_tests_name("precision estimate", tests, NULL, NULL);
}
