/**
 * @file
 * @brief Tests of ray trees: the recorded rays are those of the picture, bit for bit. They add up
 *        to the pixel, operation by operation; angles and weights equal closed forms.
 */
#include "fixtures.h"
#include "glass_scenes.h"
#include "pictures.h"

#include "render/orbit_camera.h"
#include "view/panels/ray_view.h"

#include <glob.h>

/* --- recomputing a tree ----------------------------------------------------------------------- */

/**
 * @return A number, rounded as by the engine. For +, - and * of floats this is exact in double,
 *         because 53 bits are more than 2 * 24 + 2.
 */
static double round_to_engine(const Engine *engine, double x) {
    return engine->mantissa_bits == 24 ? round_to_float(x) : x;
}

/** @return a + b. */
static Rgbd rounded_sum(const Engine *e, Rgbd a, Rgbd b) {
    return (Rgbd){round_to_engine(e, a.red + b.red), round_to_engine(e, a.green + b.green),
                  round_to_engine(e, a.blue + b.blue)};
}

/** @return a times b. */
static Rgbd rounded_product(const Engine *e, Rgbd a, Rgbd b) {
    return (Rgbd){round_to_engine(e, a.red * b.red), round_to_engine(e, a.green * b.green),
                  round_to_engine(e, a.blue * b.blue)};
}

/** @return A grey colour: one number in all channels. */
static Rgbd grey_color(double x) {
    return (Rgbd){x, x, x};
}

/** Fails unless two colours are bitwise equal. */
static void assert_same_color(Rgbd a, Rgbd b, const char *what, size_t index) {
    if (a.red != b.red || a.green != b.green || a.blue != b.blue) {
        fail_msg("%s of ray %zu: %a %a %a, not %a %a %a", what, index, a.red, a.green, a.blue,
                 b.red, b.green, b.blue);
    }
}

/**
 * @return The diffuse colour of a surface, recomputed.
 * @param index  The ray that hit it.
 */
static Rgbd expected_diffuse(const Engine *e, const RayTree *tree, size_t index) {
    const RayTreeSurface *s = &tree->nodes[index].surface;
    Rgbd diffuse = grey_color(0), shine = grey_color(0);
    for (size_t i = index + 1; i < tree->count; i++) {
        const RayTreeNode *ray = &tree->nodes[i];
        if (ray->parent == (int)index && ray->kind == RAY_SHADOW) {
            diffuse = rounded_sum(e, diffuse, ray->diffuse);
            shine = rounded_sum(e, shine, ray->specular);
        }
    }
    if (s->is_overridden) {
        return grey_color(0);
    }
    Rgbd light = rounded_sum(e, s->ambient, rounded_product(e, diffuse, grey_color(s->diffuse)));
    Rgbd color = rounded_sum(e, s->emission, rounded_product(e, s->albedo, light));
    return rounded_sum(e, color, rounded_product(e, s->specular, shine));
}

/** @return A ray's colour, recomputed. */
static Rgbd expected_color(const Engine *e, const RayTree *tree, size_t index) {
    Rgbd color = tree->nodes[index].local_color;
    for (size_t i = index + 1; i < tree->count; i++) {
        const RayTreeNode *ray = &tree->nodes[i];
        if (ray->parent == (int)index && ray->kind != RAY_SHADOW) {
            color = rounded_sum(e, color, rounded_product(e, ray->weight, ray->color));
        }
    }
    return color;
}

/** @return The largest channel. */
static double largest_channel(Rgbd color) {
    return fmax(color.red, fmax(color.green, color.blue));
}

/** @return The product of the weights from the pixel to a ray, rounded as the engine does. */
static Rgbd path_weight(const Engine *e, const RayTree *tree, int index) {
    const RayTreeNode *ray = &tree->nodes[index];
    if (ray->parent < 0) {
        return (Rgbd){1, 1, 1};
    }
    return rounded_product(e, path_weight(e, tree, ray->parent), ray->weight);
}

/** Checks a ray's position in the tree. */
static void check_tree_links(const Engine *e, const RayTree *tree, size_t i) {
    const RayTreeNode *ray = &tree->nodes[i];
    assert_int_equal(ray->kind == RAY_CAMERA, i == 0);
    if (i == 0) {
        assert_true(ray->parent == -1 && ray->depth == 0 && ray->throughput == 1);
        return;
    }
    assert_in_range(ray->parent, 0, i - 1);
    const RayTreeNode *parent = &tree->nodes[ray->parent];
    assert_int_equal(ray->depth, parent->depth + 1);
    assert_true(parent->shape >= 0 && parent->kind != RAY_SHADOW);
    assert_true(ray->throughput == largest_channel(path_weight(e, tree, (int)i)));
    assert_at_most(fabs(vec3d_length(ray->direction) - 1), 1e-6, "length of a direction");
}

/** Checks that a tree adds up. @param counts The ray counts of the tracer. */
static void check_sums(const Engine *e, const RayTree *tree, const RayCounts *counts) {
    RayCounts seen = {0};
    for (size_t i = 0; i < tree->count; i++) {
        const RayTreeNode *ray = &tree->nodes[i];
        check_tree_links(e, tree, i);
        seen.camera += ray->kind == RAY_CAMERA;
        seen.shadow += ray->kind == RAY_SHADOW;
        seen.reflection += ray->kind == RAY_REFLECTION;
        seen.refraction += ray->kind == RAY_REFRACTION;
        seen.total_reflection += ray->kind != RAY_SHADOW && ray->surface.is_total;
        if (ray->shape >= 0 && ray->kind != RAY_SHADOW) {
            assert_same_color(ray->local_color, expected_diffuse(e, tree, i), "own colour", i);
        }
        assert_same_color(ray->color, expected_color(e, tree, i), "colour", i);
    }
    assert_true(seen.camera == counts->camera && seen.shadow == counts->shadow &&
                seen.reflection == counts->reflection && seen.refraction == counts->refraction &&
                seen.total_reflection == counts->total_reflection);
}

/* --- all scenes --------------------------------------------------------------------------------
 */

/**
 * Pixels per side of a square that is traced in one call, so that packets are full, as in a
 * picture.
 */
enum { PATCH_SIZE = 16 };

/** The tracer under test. */
typedef struct QueryRun {
    const Engine *engine; /**< The engine. */
    Tracer *tracer;       /**< Its tracer. */
    uint64_t random;      /**< State of the random generator. */
    size_t rays;          /**< Number of rays recorded so far. */
} QueryRun;

/** Probes the pixels of a square. */
static void probe_patch(QueryRun *run, int pixels) {
    double patch[3 * PATCH_SIZE * PATCH_SIZE];
    RayCounts counts = {0};
    PixelGrid all = {.x = (int)(random_unit_double(&run->random) * (WIDTH - PATCH_SIZE)),
                     .y = (int)(random_unit_double(&run->random) * (HEIGHT - PATCH_SIZE)),
                     .columns = PATCH_SIZE,
                     .rows = PATCH_SIZE,
                     .stride = 1};
    run->engine->trace(run->tracer, &all, patch, &counts);
    RayTree tree = {0};
    for (int i = 0; i < pixels; i++) {
        int x = (int)(random_unit_double(&run->random) * PATCH_SIZE);
        int y = (int)(random_unit_double(&run->random) * PATCH_SIZE), index = y * PATCH_SIZE + x;
        double light[3];
        RayCounts one = {0};
        PixelGrid pixel = {.x = all.x + x,
                           .y = all.y + y,
                           .columns = 1,
                           .rows = 1,
                           .stride = 1,
                           .ray_tree = &tree};
        tree.count = 0;
        run->engine->trace(run->tracer, &pixel, light, &one);
        Rgbd seen = {patch[index], patch[index + PATCH_SIZE * PATCH_SIZE],
                     patch[index + 2 * PATCH_SIZE * PATCH_SIZE]};
        assert_false(tree.is_truncated);
        assert_same_color(tree.nodes[0].color, seen, "the pixel's colour", 0);
        assert_same_color((Rgbd){light[0], light[1], light[2]}, seen, "the traced colour", 0);
        check_sums(run->engine, &tree, &one);
        run->rays += tree.count;
    }
    ray_tree_deinit(&tree);
}

/**
 * Probes pixels of a scene.
 * @param samples  Rays per pixel: with more than one, shadows are soft.
 * @return Number of rays recorded.
 */
static size_t probe_scene(const Scene *scene, const char *name, int samples, int pixels) {
    /** Pixels of a square that are probed. */
    const int share = 8;
    Error error = {0};
    RenderSettings settings = render_settings_default(scene);
    settings.trace.samples = samples;
    QueryRun run = {.engine = engine_find(name, &error), .random = 20261121};
    if (!run.engine) {
        return 0;
    }
    run.tracer = run.engine->create_tracer(scene, &settings.trace, &error);
    assert_non_null(run.tracer);
    run.engine->set_view(run.tracer, scene, WIDTH, HEIGHT);
    for (int done = 0; done < pixels; done += share) {
        probe_patch(&run, pixels - done < share ? pixels - done : share);
    }
    run.engine->destroy(run.tracer);
    return run.rays;
}

/**
 * In every scene, the recorded rays of a pixel are those of the picture, and add up to it.
 * PROBE_PIXELS in the environment is the number of pixels per scene.
 */
static void test_sums(void **state) {
    (void)state;
    glob_t scenes;
    size_t rays = 0;
    const char *message = getenv("PROBE_PIXELS");
    int pixels = message ? atoi(message) : 130;
    assert_int_equal(glob("scenes/*.lua", 0, NULL, &scenes), 0);
    symlink_plugin("dioptre-meshes.so");
    symlink_plugin("dioptre-images.so");
    for (size_t i = 0; i < scenes.gl_pathc; i++) {
        Scene *scene = load_scene(scenes.gl_pathv[i]);
        rays += probe_scene(scene, "f32x8", 1, pixels);
        rays += probe_scene(scene, "f64x4", 4, pixels);
        scene_destroy(scene);
    }
    print_message("  pixels probed: %d a scene and engine, %zu scenes, %zu rays\n", pixels,
                  scenes.gl_pathc, rays);
    globfree(&scenes);
}

/* --- closed forms ------------------------------------------------------------------------------
 */

/** Pixels per side of a small picture: odd, so that the central pixel is at the centre. */
enum { SMALL_SIZE = 33 };

/** Tolerance relative to closed forms, half ulps of 1. */
#define ROUNDINGS 16

/** @return An engine by its name. */
static const Engine *engine_named(const char *name) {
    Error error = {0};
    return engine_find(name, &error);
}

/** Probes the centre of a scene's picture. @return The tree. */
static RayTree probe_middle(const Engine *engine, const Scene *scene, TraceSettings trace) {
    Error error = {0};
    RayTree tree = {0};
    double light[3];
    RayCounts counts = {0};
    trace.depth = scene->image.depth;
    Tracer *tracer = engine->create_tracer(scene, &trace, &error);
    assert_non_null(tracer);
    engine->set_view(tracer, scene, SMALL_SIZE, SMALL_SIZE);
    PixelGrid middle = {.x = SMALL_SIZE / 2,
                        .y = SMALL_SIZE / 2,
                        .columns = 1,
                        .rows = 1,
                        .stride = 1,
                        .ray_tree = &tree};
    engine->trace(tracer, &middle, light, &counts);
    engine->destroy(tracer);
    check_sums(engine, &tree, &counts);
    return tree;
}

/** Fails unless a number equals a closed form. @param truth The closed form, of magnitude 1. */
static void assert_closed_form(const Engine *engine, double x, double truth, const char *what) {
    assert_at_most(fabs(x - truth), ROUNDINGS * (double)roundoff(engine), "%s", what);
}

/** Fails unless a vector equals a closed form. */
static void assert_vector(const Engine *engine, Vec3d v, Vec3d truth, const char *what) {
    assert_closed_form(engine, v.x, truth.x, what);
    assert_closed_form(engine, v.y, truth.y, what);
    assert_closed_form(engine, v.z, truth.z, what);
}

/** @return A child of a ray. */
static const RayTreeNode *child_of(const RayTree *tree, int parent, RayType kind, int number) {
    for (size_t i = 0; i < tree->count; i++) {
        const RayTreeNode *ray = &tree->nodes[i];
        if (ray->parent == parent && ray->kind == kind && number-- == 0) {
            return ray;
        }
    }
    fail_msg("ray %d has no such child", parent);
    return NULL;
}

/**
 * @return A glass sphere of radius 1 at the origin in uniform white light.
 * @param eye  Camera position; it looks along -z.
 */
static Scene *glass_sphere_scene(Vec3d eye) {
    const Placement here = {1, 0};
    Scene *scene = create_empty_scene();
    scene->camera.position = eye;
    scene->sky.horizon = scene->sky.zenith = grey_color(1);
    use_material(scene, glass_material(1.5));
    add_placed_sphere(scene, here, (Vec3d){0, 0, 0}, 1);
    return scene;
}

/**
 * At an angle of incidence of 30 degrees, angles follow Snell's law and weights Fresnel's
 * equations.
 */
static void check_glass(const Engine *engine) {
    Scene *scene = glass_sphere_scene((Vec3d){0.5, 0, 5});
    RayTree tree = probe_middle(engine, scene, (TraceSettings){.offset = OFFSET_BOUND});
    const RayTreeNode *camera = &tree.nodes[0];
    const RayTreeSurface *met = &camera->surface;
    double in = sqrt(0.75), out = sqrt(8.0) / 3;
    assert_closed_form(engine, camera->distance, 5 - in, "distance to the ball");
    assert_vector(engine, camera->normal, (Vec3d){0.5, 0, in}, "normal");
    assert_closed_form(engine, met->cosine, in, "cosine of incidence");
    assert_true(met->is_transparent && !met->is_inside && !met->is_total && !met->is_overridden);
    assert_true(met->ior_from == 1 && met->ior_to == 1.5);
    double across = (in - 1.5 * out) / (in + 1.5 * out);
    double along = (1.5 * in - out) / (1.5 * in + out);
    double reflectance = (across * across + along * along) / 2;
    assert_closed_form(engine, met->fresnel, reflectance, "Fresnel's share");
    const RayTreeNode *reflected = child_of(&tree, 0, RAY_REFLECTION, 0);
    assert_vector(engine, reflected->direction, (Vec3d){in, 0, 0.5}, "mirrored direction");
    assert_closed_form(engine, reflected->throughput, reflectance, "weight of the mirrored ray");
    assert_true(!reflected->is_hit && isinf(reflected->distance) && reflected->color.red == 1);
    const RayTreeNode *inside = child_of(&tree, 0, RAY_REFRACTION, 0);
    assert_closed_form(engine, -vec3d_dot(inside->direction, camera->normal), out,
                       "refracted cosine");
    assert_closed_form(engine, inside->throughput, 1 - reflectance, "weight of the refracted ray");
    double chord = vec3d_length(vec3d_subtract(inside->point, camera->point));
    assert_closed_form(engine, chord, 2 * out, "way through the ball");
    assert_closed_form(engine, inside->surface.cosine, out, "cosine inside");
    assert_true(inside->surface.is_inside && inside->surface.ior_from == 1.5 &&
                inside->surface.ior_to == 1);
    ray_tree_deinit(&tree);
    scene_destroy(scene);
}

/** From inside at an angle of sine 0.9, all light is reflected. */
static void check_total(const Engine *engine) {
    Scene *scene = glass_sphere_scene((Vec3d){0.9, 0, 0});
    RayTree tree = probe_middle(engine, scene, (TraceSettings){.offset = OFFSET_BOUND});
    const RayTreeSurface *met = &tree.nodes[0].surface;
    assert_true(met->is_inside && met->is_total && met->fresnel == 1 && met->ior_from == 1.5);
    assert_closed_form(engine, met->cosine, sqrt(1 - 0.81), "cosine inside");
    assert_true(child_of(&tree, 0, RAY_REFLECTION, 0)->throughput == 1);
    for (size_t i = 0; i < tree.count; i++) {
        assert_true(tree.nodes[i].kind != RAY_REFRACTION || tree.nodes[i].parent != 0);
    }
    ray_tree_deinit(&tree);
    scene_destroy(scene);
}

/**
 * @return A mirror at a distance of 4 from the camera, two lights at 5 from the hit point, and a
 *         sphere that hides the second.
 */
static Scene *mirror_and_lights_scene(void) {
    const Placement here = {1, 0};
    Error error = {0};
    Scene *scene = create_empty_scene();
    SceneLight light = *(const SceneLight *)scene_light_keyword.defaults;
    SceneMaterial mirror = *(const SceneMaterial *)scene_material_keyword.defaults;
    mirror.color = grey_color(0.5);
    mirror.reflectivity = (Rgbd){0.25, 0.5, 0.125};
    mirror.ambient = mirror.specular = 0;
    mirror.diffuse = 1;
    use_material(scene, mirror);
    add_placed_plane(scene, here, (Vec3d){0, 0, -4}, (Vec3d){0, 0, 1});
    add_placed_sphere(scene, here, (Vec3d){-1.5, 0, -2}, 0.5);
    for (int side = 1; side >= -1; side -= 2) {
        light.position = (Vec3d){3 * side, 0, 0};
        assert_true(scene_add_light(scene, &light, &error));
    }
    return scene;
}

/**
 * A mirror reflects straight back. A light at 5 with cosine 0.8 gives its irradiance; one behind a
 * sphere gives nothing.
 */
static void check_mirror(const Engine *engine) {
    Scene *scene = mirror_and_lights_scene();
    double epsilon = 0x1p-10;
    RayTree tree =
        probe_middle(engine, scene, (TraceSettings){.offset = OFFSET_FIXED, .epsilon = epsilon});
    const RayTreeNode *camera = &tree.nodes[0];
    assert_true(camera->shape == 0 && camera->distance == 4 && camera->surface.cosine == 1);
    assert_true(camera->surface.epsilon == epsilon);
    assert_true(camera->surface.ulps == ldexp(epsilon, engine->mantissa_bits - 3));
    const RayTreeNode *lit = child_of(&tree, 0, RAY_SHADOW, 0);
    double near = hypot(3, 4 - epsilon);
    assert_true(!lit->is_hit && lit->light == 0 && lit->shape == -1);
    assert_closed_form(engine, lit->limit, near, "way to the lamp");
    assert_true(lit->origin.z == -4 + epsilon);
    assert_closed_form(engine, lit->diffuse.red, 0.8, "light of the lamp");
    assert_closed_form(engine, lit->color.green, 0.5 * 0.5 * 0.8, "what it adds");
    const RayTreeNode *dark = child_of(&tree, 0, RAY_SHADOW, 1);
    assert_true(dark->is_hit && dark->light == 1 && dark->shape == 1 &&
                largest_channel(dark->color) == 0);
    assert_at_most(fabs(dark->distance - 2), 2 * epsilon, "way to the ball");
    const RayTreeNode *reflected = child_of(&tree, 0, RAY_REFLECTION, 0);
    assert_true(reflected->direction.z == 1 && reflected->throughput == 0.5 && !reflected->is_hit);
    assert_same_color(reflected->weight, (Rgbd){0.25, 0.5, 0.125}, "share", 1);
    ray_tree_deinit(&tree);
    scene_destroy(scene);
}

/** Angles, weights and distances equal closed forms. */
static void test_closed_forms(void **state) {
    (void)state;
    static const char *const names[] = {"f32x1", "f32x8", "f64x1", "f64x4"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const Engine *engine = engine_named(names[i]);
        if (engine) {
            check_glass(engine);
            check_total(engine);
            check_mirror(engine);
        }
    }
}

/** Points are in scene coordinates, also if the tracer uses another origin. */
static void test_far_away(void **state) {
    (void)state;
    const Placement far = {1, 1e6};
    const Engine *engine = engine_named("f32x1");
    Scene *scene = create_empty_scene();
    scene->camera.position = placed_point(far, (Vec3d){0.5, 0, 5});
    add_placed_sphere(scene, far, (Vec3d){0, 0, 0}, 1);
    RayTree tree = probe_middle(engine, scene, (TraceSettings){.offset = OFFSET_BOUND});
    Vec3d met = placed_point(far, (Vec3d){0.5, 0, sqrt(0.75)});
    Vec3d start = vec3d_subtract(tree.nodes[0].origin, scene->camera.position);
    assert_at_most(vec3d_length(start), 1e-6, "origin of the camera's ray");
    assert_at_most(vec3d_length(vec3d_subtract(tree.nodes[0].point, met)), 1e-6, "point");
    ray_tree_deinit(&tree);
    scene_destroy(scene);
}

/** The index of a visible light is recorded. */
static void test_visible_light(void **state) {
    (void)state;
    Error error = {0};
    Scene *scene = create_empty_scene();
    SceneLight light = *(const SceneLight *)scene_light_keyword.defaults;
    light.position = (Vec3d){5, 5, 5};
    assert_true(scene_add_light(scene, &light, &error));
    light.position = (Vec3d){0, 0, -3};
    light.radius = 1;
    assert_true(scene_add_light(scene, &light, &error));
    add_placed_sphere(scene, (Placement){1, 0}, (Vec3d){0, 0, -9}, 1);
    RayTree tree =
        probe_middle(engine_named("f64x1"), scene, (TraceSettings){.offset = OFFSET_BOUND});
    const RayTreeNode *camera = &tree.nodes[0];
    assert_int_equal(tree.count, 1);
    assert_true(camera->is_hit && camera->shape == -1 && camera->light == 1);
    assert_true(camera->distance == 2 && largest_channel(camera->color) > 0);
    ray_tree_deinit(&tree);
    scene_destroy(scene);
}

/* --- views of the rays ------------------------------------------------------------------------ */

/** A camera projects the hit point of a ray onto the centre of the ray's pixel. */
static void test_projection(void **state) {
    (void)state;
    Error error = {0};
    RayTree tree = {0};
    uint64_t random = 7;
    Scene *scene = load_scene("scenes/box.lua");
    RenderSettings settings = small_settings(scene, "f64x1", 1);
    Renderer *renderer = create_renderer(scene, &settings);
    ProjectedView projected = {scene->camera, WIDTH, HEIGHT};
    for (int i = 0; i < 100; i++) {
        double x, y;
        int column = (int)(random_unit_double(&random) * WIDTH),
            row = (int)(random_unit_double(&random) * HEIGHT);
        assert_true(renderer_record_ray_tree(renderer, column, row, &tree, &error));
        if (tree.nodes[0].is_hit) {
            assert_true(projected_view_point(&projected, tree.nodes[0].point, &x, &y));
            assert_at_most(fabs(x - (column + 0.5)), 1e-9, "column");
            assert_at_most(fabs(y - (row + 0.5)), 1e-9, "row");
        }
    }
    double x, y;
    Vec3d behind = vec3d_subtract(scene->camera.position, scene->camera.direction);
    assert_false(projected_view_point(&projected, behind, &x, &y));
    ray_tree_deinit(&tree);
    renderer_destroy(renderer);
    scene_destroy(scene);
}

/**
 * The second camera has the first camera and the first hit in its picture, for any aspect ratio.
 */
static void test_view(void **state) {
    (void)state;
    static const char *const paths[] = {"scenes/box.lua", "scenes/glass-sphere.lua",
                                        "scenes/chess.lua"};
    symlink_plugin("dioptre-meshes.so");
    for (size_t i = 0; i < sizeof paths / sizeof *paths; i++) {
        Error error = {0};
        RayTree tree = {0};
        Scene *scene = load_scene(paths[i]);
        RenderSettings settings = small_settings(scene, "auto", 1);
        Renderer *renderer = create_renderer(scene, &settings);
        assert_true(renderer_record_ray_tree(renderer, WIDTH / 2, HEIGHT / 2, &tree, &error));
        for (int width = 200; width <= 800; width *= 4) {
            double x, y;
            OrbitCamera view =
                orbit_camera_fit(renderer, scene, &(CutAway){0}, &tree, 0, width, 400);
            ProjectedView projected = orbit_camera_project(&view, width, 400);
            const Vec3d points[] = {tree.nodes[0].origin, tree.nodes[0].point};
            for (int p = 0; p < 2; p++) {
                assert_true(projected_view_point(&projected, points[p], &x, &y));
                assert_true(x > 0 && x < width && y > 0 && y < 400);
            }
        }
        ray_tree_deinit(&tree);
        renderer_destroy(renderer);
        scene_destroy(scene);
    }
}

/** @return Whether a drawing numbers a ray. */
static bool is_numbered(const RayDrawing *drawing, size_t ray) {
    RayLabel labels[RAY_LABELS_MAXIMUM];
    LabelBox boxes[RAY_LABELS_MAXIMUM];
    size_t count = ray_drawing_labels(drawing, labels, boxes);
    for (size_t i = 0; i < count; i++) {
        if (labels[i].ray == ray) {
            return true;
        }
    }
    return false;
}

/** Of many rays only the chosen one has its number, with those that it comes from, begins and has
 *  beside it; and the one under the mouse. */
static void test_numbers(void **state) {
    (void)state;
    Error error = {0};
    RayTree tree = {0};
    Scene *scene = load_scene("scenes/glass-sphere.lua");
    RenderSettings settings = small_settings(scene, "auto", 1);
    Renderer *renderer = create_renderer(scene, &settings);
    assert_true(renderer_record_ray_tree(renderer, WIDTH / 2, HEIGHT / 2, &tree, &error));
    assert_true(tree.count > 12);
    OrbitCamera orbit = orbit_camera_fit(renderer, scene, &(CutAway){0}, &tree, 0, 800, 600);
    RayDrawing drawing = {
        .tree = &tree, .orbit = &orbit, .view = orbit_camera_project(&orbit, 800, 600)};
    size_t last = tree.count - 1, numbered = 0;
    drawing.selected = last;
    for (size_t i = 0; i < tree.count; i++) {
        bool is_parent = (int)i == tree.nodes[last].parent, is_first = i == 0;
        bool is_beside = i > 0 && tree.nodes[i].parent == tree.nodes[last].parent;
        numbered += is_numbered(&drawing, i);
        assert_true(is_numbered(&drawing, i) || !(is_parent || is_first || is_beside));
    }
    assert_true(numbered < tree.count / 2);
    for (size_t i = 0; i < tree.count; i++) {
        ProjectedRay line;
        drawing.hovered = i + 1;
        assert_true(is_numbered(&drawing, i) || !ray_drawing_project(&drawing, i, &line));
    }
    drawing.hovered = 0;
    drawing.selected = RAY_DRAWING_UNSELECTED;
    assert_true(is_numbered(&drawing, 1) && is_numbered(&drawing, tree.count / 2));
    ray_tree_deinit(&tree);
    renderer_destroy(renderer);
    scene_destroy(scene);
}

/** Choosing rays: by steps, in flight, at a point of the picture; hidden kinds are passed over.
 *  @param input Shows a pixel with shadow rays. */
static void check_choosing(RayView *ray_view, const RayViewInput *input) {
    Error error = {0};
    size_t found = 0, shadow = 0;
    ray_view_choose_ray(ray_view, 0);
    ray_view_fly(ray_view, 10);
    assert_int_equal(ray_view->selected, 1);
    assert_true(ray_view_flight(ray_view, 10.1) > 0 && ray_view_flight(ray_view, 10.1) < 1);
    assert_true(ray_view_timeout(ray_view, 10.1) < 0.1);
    RayViewInput later = *input;
    later.now = 11;
    assert_true(ray_view_update(ray_view, &later, NULL, &error));
    assert_true(ray_view_flight(ray_view, 11) == 1 && ray_view->flight_start == 0);
    while (ray_view->ray_tree.nodes[shadow].kind != RAY_SHADOW) {
        shadow++;
    }
    ray_view_toggle_kind(ray_view, RAY_SHADOW);
    for (size_t i = 0; i < ray_view->ray_tree.count; i++) {
        ray_view_select_ray(ray_view, 1);
        assert_true(ray_view->ray_tree.nodes[ray_view->selected].kind != RAY_SHADOW);
    }
    SDL_Rect view = ray_view_layout(ray_view, &input->area).view;
    RayDrawing drawing = ray_view_drawing(ray_view, &view);
    ProjectedRay line;
    assert_false(ray_drawing_project(&drawing, shadow, &line));
    ray_view_toggle_kind(ray_view, RAY_SHADOW);
    drawing = ray_view_drawing(ray_view, &view);
    assert_true(ray_drawing_project(&drawing, shadow, &line));
    assert_true(ray_view_ray_at(ray_view, view.x + line.x[0] + 0.9 * (line.x[1] - line.x[0]),
                                view.y + line.y[0] + 0.9 * (line.y[1] - line.y[0]), &input->area,
                                &found));
    assert_int_equal(found, shadow);
    assert_false(ray_view_ray_at(ray_view, view.x - 5.0, view.y, &input->area, &found));
    ray_view_choose_ray(ray_view, SIZE_MAX);
    assert_int_equal(ray_view->selected, ray_view->ray_tree.count - 1);
    ray_view_choose_ray(ray_view, 0);
}

/** The window's numbers equal those of the pixel, and follow the light. */
static void test_ray_view(void **state) {
    (void)state;
    Error error = {0};
    RayView ray_view = {0};
    Scene *scene = load_scene("scenes/box.lua");
    RenderSettings settings = small_settings(scene, "auto", 1);
    Renderer *renderer = create_renderer(scene, &settings);
    Viewport viewport = {
        .renderer = renderer, .settings = settings, .width = WIDTH, .height = HEIGHT};
    const RayViewInput input = {&viewport, scene, 0, 0, {0, 0, WIDTH, HEIGHT}};
    assert_true(ray_view_update(&ray_view, &input, NULL, &error));
    assert_false(ray_view.needs_present);
    assert_true(ray_view_timeout(&ray_view, 0) > 1);
    ray_view_pick(&ray_view, 63.5 / WIDTH, 112.5 / HEIGHT);
    assert_true(ray_view_timeout(&ray_view, 0) <= 0); // No event may come after a button's.
    assert_true(ray_view_update(&ray_view, &input, NULL, &error));
    assert_true(ray_view.needs_present && ray_view.ray_tree.count >= 4);
    assert_non_null(strstr(ray_view.heading, "(63, 112)"));
    ray_view_step_pixel(&ray_view, -1, 2);
    assert_true(ray_view_update(&ray_view, &input, NULL, &error));
    assert_non_null(strstr(ray_view.heading, "(62, 114)"));
    ray_view_select_ray(&ray_view, -1);
    assert_int_equal(ray_view.selected, ray_view.ray_tree.count - 1);
    ray_view_select_ray(&ray_view, 1);
    assert_int_equal(ray_view.selected, 0);
    check_choosing(&ray_view, &input);
    Rgbd before = ray_view.ray_tree.nodes[0].color;
    scene->lights[0].position.x += 1;
    assert_true(renderer_start(renderer, scene, WIDTH, HEIGHT, NULL, NULL, &error));
    ray_view_invalidate(&ray_view);
    assert_true(ray_view_update(&ray_view, &input, NULL, &error));
    assert_true(largest_channel(ray_view.ray_tree.nodes[0].color) != largest_channel(before));
    ray_view_toggle(&ray_view);
    assert_false(ray_view.is_open);
    ray_view_deinit(&ray_view);
    renderer_destroy(renderer);
    scene_destroy(scene);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_closed_forms),  cmocka_unit_test(test_far_away),
        cmocka_unit_test(test_visible_light), cmocka_unit_test(test_projection),
        cmocka_unit_test(test_view),          cmocka_unit_test(test_ray_view),
        cmocka_unit_test(test_sums),          cmocka_unit_test(test_numbers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
