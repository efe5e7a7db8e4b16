/**
 * @file
 * @brief The probe: the rays that it notes are those of the picture, bit for bit; they add up to
 *        the pixel, operation by operation; angles and shares are those of closed forms.
 */
#include "fixtures.h"
#include "glass_scenes.h"
#include "pictures.h"

#include "dioptre/ray_view.h"
#include "view/inspector.h"

#include <glob.h>

/* --- replaying a tree --------------------------------------------------------------------------
 */

/** @return A number, rounded as the engine would. For +, - and * that is exact in double, as 53
 * bits are more than twice 24 and 2. @param engine The engine. @param x It. */
static double rounded(const Engine *engine, double x) {
    return engine->mantissa_bits == 24 ? as_float(x) : x;
}

/** @return a + b. @param e The engine. @param a Light. @param b More. */
static Color plus(const Engine *e, Color a, Color b) {
    return (Color){rounded(e, a.red + b.red), rounded(e, a.green + b.green),
                   rounded(e, a.blue + b.blue)};
}

/** @return a times b. @param e The engine. @param a Light. @param b Shares. */
static Color times(const Engine *e, Color a, Color b) {
    return (Color){rounded(e, a.red * b.red), rounded(e, a.green * b.green),
                   rounded(e, a.blue * b.blue)};
}

/** @return The same in all primaries. @param x A number. */
static Color grey(double x) {
    return (Color){x, x, x};
}

/** Fails unless two colours are the same to the bit. @param a One. @param b The other.
 *  @param what What they are. @param place Of which ray. */
static void assert_same_color(Color a, Color b, const char *what, size_t place) {
    if (a.red != b.red || a.green != b.green || a.blue != b.blue) {
        fail_msg("%s of ray %zu: %a %a %a, not %a %a %a", what, place, a.red, a.green, a.blue,
                 b.red, b.green, b.blue);
    }
}

/** @return What the body of a surface sends back, worked out again. @param e The engine.
 *  @param probe The tree. @param place The ray that met it. */
static Color body_again(const Engine *e, const Probe *probe, size_t place) {
    const ProbeSurface *s = &probe->rays[place].surface;
    Color matt = grey(0), shine = grey(0);
    for (size_t i = place + 1; i < probe->count; i++) {
        const ProbeRay *ray = &probe->rays[i];
        if (ray->parent == (int)place && ray->kind == PROBE_SHADOW) {
            matt = plus(e, matt, ray->matt);
            shine = plus(e, shine, ray->shine);
        }
    }
    if (s->is_hidden) {
        return grey(0);
    }
    Color light = plus(e, s->ambient, times(e, matt, grey(s->diffuse)));
    Color color = plus(e, s->emission, times(e, s->body, light));
    return plus(e, color, times(e, s->highlight, shine));
}

/** @return A ray's colour, worked out again. @param e The engine. @param probe The tree.
 *  @param place Which ray. */
static Color color_again(const Engine *e, const Probe *probe, size_t place) {
    Color color = probe->rays[place].own;
    for (size_t i = place + 1; i < probe->count; i++) {
        const ProbeRay *ray = &probe->rays[i];
        if (ray->parent == (int)place && ray->kind != PROBE_SHADOW) {
            color = plus(e, color, times(e, ray->share, ray->color));
        }
    }
    return color;
}

/** @return The largest primary. @param color A colour. */
static double largest(Color color) {
    return fmax(color.red, fmax(color.green, color.blue));
}

/** Checks a ray's place in the tree. @param e The engine. @param probe The tree. @param i Which. */
static void check_place(const Engine *e, const Probe *probe, size_t i) {
    const ProbeRay *ray = &probe->rays[i];
    assert_int_equal(ray->kind == PROBE_CAMERA, i == 0);
    if (i == 0) {
        assert_true(ray->parent == -1 && ray->depth == 0 && ray->weight == 1);
        return;
    }
    assert_in_range(ray->parent, 0, i - 1);
    const ProbeRay *parent = &probe->rays[ray->parent];
    assert_int_equal(ray->depth, parent->depth + 1);
    assert_true(parent->shape >= 0 && parent->kind != PROBE_SHADOW);
    double weight = rounded(e, parent->weight * largest(ray->share));
    assert_true(ray->weight == weight);
    assert_at_most(fabs(vector3_length(ray->direction) - 1), 1e-6, "length of a direction");
}

/** Checks that a tree adds up. @param e The engine. @param probe The tree. @param counts The rays
 *  that the tracer counted. */
static void check_sums(const Engine *e, const Probe *probe, const RayCounts *counts) {
    RayCounts seen = {0};
    for (size_t i = 0; i < probe->count; i++) {
        const ProbeRay *ray = &probe->rays[i];
        check_place(e, probe, i);
        seen.camera += ray->kind == PROBE_CAMERA;
        seen.shadow += ray->kind == PROBE_SHADOW;
        seen.mirror += ray->kind == PROBE_MIRROR;
        seen.refract += ray->kind == PROBE_REFRACT;
        seen.total += ray->kind != PROBE_SHADOW && ray->surface.is_total;
        if (ray->shape >= 0 && ray->kind != PROBE_SHADOW) {
            assert_same_color(ray->own, body_again(e, probe, i), "own colour", i);
        }
        assert_same_color(ray->color, color_again(e, probe, i), "colour", i);
    }
    assert_true(seen.camera == counts->camera && seen.shadow == counts->shadow &&
                seen.mirror == counts->mirror && seen.refract == counts->refract &&
                seen.total == counts->total);
}

/* --- all scenes --------------------------------------------------------------------------------
 */

/** Pixels of a patch that is traced at once, each way: packets are full then, and travel as in a
 *  picture. */
enum { PATCH = 16 };

/** A tracer that is asked. */
typedef struct Asked {
    const Engine *engine; /**< The engine. */
    Tracer *tracer;       /**< Its tracer. */
    uint64_t random;      /**< A generator. */
    size_t rays;          /**< Rays that were noted so far. */
} Asked;

/** Probes pixels of a patch. @param asked Who is asked. @param pixels How many. */
static void probe_patch(Asked *asked, int pixels) {
    double patch[3 * PATCH * PATCH];
    RayCounts counts = {0};
    PixelGrid all = {.x = (int)(random_share(&asked->random) * (WIDTH - PATCH)),
                     .y = (int)(random_share(&asked->random) * (HEIGHT - PATCH)),
                     .columns = PATCH,
                     .rows = PATCH,
                     .stride = 1};
    asked->engine->trace(asked->tracer, &all, patch, &counts);
    Probe probe = {0};
    for (int i = 0; i < pixels; i++) {
        int x = (int)(random_share(&asked->random) * PATCH);
        int y = (int)(random_share(&asked->random) * PATCH), place = y * PATCH + x;
        double light[3];
        RayCounts one = {0};
        PixelGrid pixel = {
            .x = all.x + x, .y = all.y + y, .columns = 1, .rows = 1, .stride = 1, .probe = &probe};
        probe.count = 0;
        asked->engine->trace(asked->tracer, &pixel, light, &one);
        Color seen = {patch[place], patch[place + PATCH * PATCH], patch[place + 2 * PATCH * PATCH]};
        assert_false(probe.is_short);
        assert_same_color(probe.rays[0].color, seen, "the pixel's colour", 0);
        assert_same_color((Color){light[0], light[1], light[2]}, seen, "the traced colour", 0);
        check_sums(asked->engine, &probe, &one);
        asked->rays += probe.count;
    }
    probe_release(&probe);
}

/** Probes pixels of a scene. @param scene The scene. @param name An engine. @param samples Rays a
 *  pixel: with more than one, shadows are soft. @param pixels How many. @return Rays noted. */
static size_t probe_scene(const Scene *scene, const char *name, int samples, int pixels) {
    /** Pixels of a patch that are probed. */
    const int share = 8;
    Error error = {0};
    RenderSettings settings = render_settings_default(scene);
    settings.trace.samples = samples;
    Asked asked = {.engine = engine_find(name, &error), .random = 20261121};
    if (!asked.engine) {
        return 0;
    }
    asked.tracer = asked.engine->prepare(scene, &settings.trace, &error);
    assert_non_null(asked.tracer);
    asked.engine->look(asked.tracer, scene, WIDTH, HEIGHT);
    for (int done = 0; done < pixels; done += share) {
        probe_patch(&asked, pixels - done < share ? pixels - done : share);
    }
    asked.engine->release(asked.tracer);
    return asked.rays;
}

/** In every scene, the rays noted of a pixel are those of the picture, and add up to it.
 *  PROBE_PIXELS in the environment says how many pixels of each scene. @param state Not used. */
static void test_sums(void **state) {
    (void)state;
    glob_t scenes;
    size_t rays = 0;
    const char *asked = getenv("PROBE_PIXELS");
    int pixels = asked ? atoi(asked) : 130;
    assert_int_equal(glob("scenes/*.lua", 0, NULL, &scenes), 0);
    link_module("dioptre-meshes.so");
    link_module("dioptre-images.so");
    for (size_t i = 0; i < scenes.gl_pathc; i++) {
        Scene *scene = load(scenes.gl_pathv[i]);
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

/** Pixels of a small picture, each way: odd, so that one's centre is the middle. */
enum { SMALL = 33 };

/** Roundings that closed forms are allowed, in halves of an ulp of 1. */
#define ROUNDINGS 16

/** @return The engine that is asked for closed forms. @param name Its name. */
static const Engine *engine_named(const char *name) {
    Error error = {0};
    return engine_find(name, &error);
}

/** Probes the middle of a scene's picture. @param engine The engine. @param scene The scene.
 *  @param trace How. @return The tree. */
static Probe probe_middle(const Engine *engine, const Scene *scene, TraceSettings trace) {
    Error error = {0};
    Probe probe = {0};
    double light[3];
    RayCounts counts = {0};
    trace.depth = scene->image.depth;
    Tracer *tracer = engine->prepare(scene, &trace, &error);
    assert_non_null(tracer);
    engine->look(tracer, scene, SMALL, SMALL);
    PixelGrid middle = {
        .x = SMALL / 2, .y = SMALL / 2, .columns = 1, .rows = 1, .stride = 1, .probe = &probe};
    engine->trace(tracer, &middle, light, &counts);
    engine->release(tracer);
    check_sums(engine, &probe, &counts);
    return probe;
}

/** Fails unless a number is a closed form's. @param engine Who computed it. @param x The number.
 *  @param truth The closed form's, of the size of 1. @param what What it is. */
static void assert_form(const Engine *engine, double x, double truth, const char *what) {
    assert_at_most(fabs(x - truth), ROUNDINGS * (double)roundoff(engine), "%s", what);
}

/** Fails unless a vector is a closed form's. @param engine Who computed it. @param v The vector.
 *  @param truth The closed form's. @param what What it is. */
static void assert_vector(const Engine *engine, Vector3 v, Vector3 truth, const char *what) {
    assert_form(engine, v.x, truth.x, what);
    assert_form(engine, v.y, truth.y, what);
    assert_form(engine, v.z, truth.z, what);
}

/** @return A child of a ray. @param probe The tree. @param parent The ray. @param kind Of which
 *  kind. @param number Which of them. */
static const ProbeRay *child_of(const Probe *probe, int parent, ProbeKind kind, int number) {
    for (size_t i = 0; i < probe->count; i++) {
        const ProbeRay *ray = &probe->rays[i];
        if (ray->parent == parent && ray->kind == kind && number-- == 0) {
            return ray;
        }
    }
    fail_msg("ray %d has no such child", parent);
    return NULL;
}

/** @return A white world around a ball of glass of radius 1 at the origin, seen from a point.
 *  @param eye The point; it looks along -z. */
static Scene *glass_ball(Vector3 eye) {
    const World here = {1, 0};
    Scene *scene = empty_scene();
    scene->camera.position = eye;
    scene->sky.horizon = scene->sky.zenith = grey(1);
    use(scene, glass_of(1.5));
    add_ball(scene, here, (Vector3){0, 0, 0}, 1);
    return scene;
}

/** Where glass is met at 30 degrees, angles are Snell's and shares Fresnel's. @param engine Who is
 *  asked. */
static void check_glass(const Engine *engine) {
    Scene *scene = glass_ball((Vector3){0.5, 0, 5});
    Probe probe = probe_middle(engine, scene, (TraceSettings){.offset = OFFSET_BOUND});
    const ProbeRay *camera = &probe.rays[0];
    const ProbeSurface *met = &camera->surface;
    double in = sqrt(0.75), out = sqrt(8.0) / 3;
    assert_form(engine, camera->distance, 5 - in, "distance to the ball");
    assert_vector(engine, camera->normal, (Vector3){0.5, 0, in}, "normal");
    assert_form(engine, met->cosine, in, "cosine of incidence");
    assert_true(met->is_transparent && !met->is_inside && !met->is_total && !met->is_hidden);
    assert_true(met->before == 1 && met->behind == 1.5);
    double across = (in - 1.5 * out) / (in + 1.5 * out);
    double along = (1.5 * in - out) / (1.5 * in + out);
    double fresnel = (across * across + along * along) / 2;
    assert_form(engine, met->fresnel, fresnel, "Fresnel's share");
    const ProbeRay *mirrored = child_of(&probe, 0, PROBE_MIRROR, 0);
    assert_vector(engine, mirrored->direction, (Vector3){in, 0, 0.5}, "mirrored direction");
    assert_form(engine, mirrored->weight, fresnel, "weight of the mirrored ray");
    assert_true(!mirrored->is_hit && isinf(mirrored->distance) && mirrored->color.red == 1);
    const ProbeRay *inside = child_of(&probe, 0, PROBE_REFRACT, 0);
    assert_form(engine, -vector3_dot(inside->direction, camera->normal), out, "refracted cosine");
    assert_form(engine, inside->weight, 1 - fresnel, "weight of the refracted ray");
    double chord = vector3_length(vector3_subtract(inside->point, camera->point));
    assert_form(engine, chord, 2 * out, "way through the ball");
    assert_form(engine, inside->surface.cosine, out, "cosine inside");
    assert_true(inside->surface.is_inside && inside->surface.before == 1.5 &&
                inside->surface.behind == 1);
    probe_release(&probe);
    scene_destroy(scene);
}

/** From inside at an angle of sine 0.9 all is mirrored. @param engine Who is asked. */
static void check_total(const Engine *engine) {
    Scene *scene = glass_ball((Vector3){0.9, 0, 0});
    Probe probe = probe_middle(engine, scene, (TraceSettings){.offset = OFFSET_BOUND});
    const ProbeSurface *met = &probe.rays[0].surface;
    assert_true(met->is_inside && met->is_total && met->fresnel == 1 && met->before == 1.5);
    assert_form(engine, met->cosine, sqrt(1 - 0.81), "cosine inside");
    assert_true(child_of(&probe, 0, PROBE_MIRROR, 0)->weight == 1);
    for (size_t i = 0; i < probe.count; i++) {
        assert_true(probe.rays[i].kind != PROBE_REFRACT || probe.rays[i].parent != 0);
    }
    probe_release(&probe);
    scene_destroy(scene);
}

/** @return A mirror 4 before the eye, two lamps at 5 from where it is met, and a ball before the
 *  second. */
static Scene *mirror_and_lamps(void) {
    const World here = {1, 0};
    Error error = {0};
    Scene *scene = empty_scene();
    Light lamp = *(const Light *)light_keyword.defaults;
    Material mirror = *(const Material *)material_keyword.defaults;
    mirror.color = grey(0.5);
    mirror.reflectivity = (Color){0.25, 0.5, 0.125};
    mirror.ambient = mirror.specular = 0;
    mirror.diffuse = 1;
    use(scene, mirror);
    add_plane(scene, here, (Vector3){0, 0, -4}, (Vector3){0, 0, 1});
    add_ball(scene, here, (Vector3){-1.5, 0, -2}, 0.5);
    for (int side = 1; side >= -1; side -= 2) {
        lamp.position = (Vector3){3 * side, 0, 0};
        assert_true(scene_add_light(scene, &lamp, &error));
    }
    return scene;
}

/** A mirror sends straight back; a lamp at 5 with cosine 0.8 gives that, one behind a ball nothing.
 *  @param engine Who is asked. */
static void check_mirror(const Engine *engine) {
    Scene *scene = mirror_and_lamps();
    double epsilon = 0x1p-10;
    Probe probe =
        probe_middle(engine, scene, (TraceSettings){.offset = OFFSET_FIXED, .epsilon = epsilon});
    const ProbeRay *camera = &probe.rays[0];
    assert_true(camera->shape == 0 && camera->distance == 4 && camera->surface.cosine == 1);
    assert_true(camera->surface.epsilon == epsilon);
    assert_true(camera->surface.ulps == ldexp(epsilon, engine->mantissa_bits - 3));
    const ProbeRay *lit = child_of(&probe, 0, PROBE_SHADOW, 0);
    double near = hypot(3, 4 - epsilon);
    assert_true(!lit->is_hit && lit->lamp == 0 && lit->shape == -1);
    assert_form(engine, lit->limit, near, "way to the lamp");
    assert_true(lit->origin.z == -4 + epsilon);
    assert_form(engine, lit->matt.red, 0.8, "light of the lamp");
    assert_form(engine, lit->color.green, 0.5 * 0.5 * 0.8, "what it adds");
    const ProbeRay *dark = child_of(&probe, 0, PROBE_SHADOW, 1);
    assert_true(dark->is_hit && dark->lamp == 1 && dark->shape == 1 && largest(dark->color) == 0);
    assert_at_most(fabs(dark->distance - 2), 2 * epsilon, "way to the ball");
    const ProbeRay *mirrored = child_of(&probe, 0, PROBE_MIRROR, 0);
    assert_true(mirrored->direction.z == 1 && mirrored->weight == 0.5 && !mirrored->is_hit);
    assert_same_color(mirrored->share, (Color){0.25, 0.5, 0.125}, "share", 1);
    probe_release(&probe);
    scene_destroy(scene);
}

/** Angles, shares, distances and weights are those of closed forms. @param state Not used. */
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

/** Places are the scene's, also where the tracer counts from elsewhere. @param state Not used. */
static void test_far_away(void **state) {
    (void)state;
    const World far = {1, 1e6};
    const Engine *engine = engine_named("f32x1");
    Scene *scene = empty_scene();
    scene->camera.position = place_in(far, (Vector3){0.5, 0, 5});
    add_ball(scene, far, (Vector3){0, 0, 0}, 1);
    Probe probe = probe_middle(engine, scene, (TraceSettings){.offset = OFFSET_BOUND});
    Vector3 met = place_in(far, (Vector3){0.5, 0, sqrt(0.75)});
    Vector3 start = vector3_subtract(probe.rays[0].origin, scene->camera.position);
    assert_at_most(vector3_length(start), 1e-6, "origin of the camera's ray");
    assert_at_most(vector3_length(vector3_subtract(probe.rays[0].point, met)), 1e-6, "point");
    probe_release(&probe);
    scene_destroy(scene);
}

/** A lamp that is seen is named. @param state Not used. */
static void test_lamp_seen(void **state) {
    (void)state;
    Error error = {0};
    Scene *scene = empty_scene();
    Light lamp = *(const Light *)light_keyword.defaults;
    lamp.position = (Vector3){5, 5, 5};
    assert_true(scene_add_light(scene, &lamp, &error));
    lamp.position = (Vector3){0, 0, -3};
    lamp.radius = 1;
    assert_true(scene_add_light(scene, &lamp, &error));
    add_ball(scene, (World){1, 0}, (Vector3){0, 0, -9}, 1);
    Probe probe =
        probe_middle(engine_named("f64x1"), scene, (TraceSettings){.offset = OFFSET_BOUND});
    const ProbeRay *camera = &probe.rays[0];
    assert_int_equal(probe.count, 1);
    assert_true(camera->is_hit && camera->shape == -1 && camera->lamp == 1);
    assert_true(camera->distance == 2 && largest(camera->color) > 0);
    probe_release(&probe);
    scene_destroy(scene);
}

/* --- looking at the rays -----------------------------------------------------------------------
 */

/** A camera sees what its ray hits in the middle of the ray's pixel. @param state Not used. */
static void test_projection(void **state) {
    (void)state;
    Error error = {0};
    Probe probe = {0};
    uint64_t random = 7;
    Scene *scene = load("scenes/box.lua");
    RenderSettings settings = small_settings(scene, "f64x1", 1);
    Renderer *renderer = create(scene, &settings);
    RaySight sight = {scene->camera, WIDTH, HEIGHT};
    for (int i = 0; i < 100; i++) {
        double x, y;
        int column = (int)(random_share(&random) * WIDTH),
            row = (int)(random_share(&random) * HEIGHT);
        assert_true(renderer_probe(renderer, column, row, &probe, &error));
        if (probe.rays[0].is_hit) {
            assert_true(ray_sight_point(&sight, probe.rays[0].point, &x, &y));
            assert_at_most(fabs(x - (column + 0.5)), 1e-9, "column");
            assert_at_most(fabs(y - (row + 0.5)), 1e-9, "row");
        }
    }
    double x, y;
    Vector3 behind = vector3_subtract(scene->camera.position, scene->camera.direction);
    assert_false(ray_sight_point(&sight, behind, &x, &y));
    probe_release(&probe);
    renderer_destroy(renderer);
    scene_destroy(scene);
}

/** The second camera has the eye and the first hit in its picture, whatever its shape.
 *  @param state Not used. */
static void test_view(void **state) {
    (void)state;
    static const char *const paths[] = {"scenes/box.lua", "scenes/glass-sphere.lua",
                                        "scenes/chess.lua"};
    link_module("dioptre-meshes.so");
    for (size_t i = 0; i < sizeof paths / sizeof *paths; i++) {
        Error error = {0};
        Probe probe = {0};
        Scene *scene = load(paths[i]);
        RenderSettings settings = small_settings(scene, "auto", 1);
        Renderer *renderer = create(scene, &settings);
        assert_true(renderer_probe(renderer, WIDTH / 2, HEIGHT / 2, &probe, &error));
        for (int width = 200; width <= 800; width *= 4) {
            double x, y;
            RayView view = ray_view_choose(renderer, &scene->camera, &probe, width, 400);
            RaySight sight = ray_view_sight(&view, width, 400);
            const Vector3 points[] = {probe.rays[0].origin, probe.rays[0].point};
            for (int p = 0; p < 2; p++) {
                assert_true(ray_sight_point(&sight, points[p], &x, &y));
                assert_true(x > 0 && x < width && y > 0 && y < 400);
            }
        }
        probe_release(&probe);
        renderer_destroy(renderer);
        scene_destroy(scene);
    }
}

/** The window's numbers are those of the pixel, and follow the light. @param state Not used. */
static void test_inspector(void **state) {
    (void)state;
    Error error = {0};
    Inspector inspector = {0};
    Scene *scene = load("scenes/box.lua");
    RenderSettings settings = small_settings(scene, "auto", 1);
    Renderer *renderer = create(scene, &settings);
    Sight sight = {.renderer = renderer, .settings = settings, .width = WIDTH, .height = HEIGHT};
    const Inspected inspected = {&sight, scene, 0, 0};
    assert_true(inspector_update(&inspector, &inspected, NULL, &error));
    assert_false(inspector.has_news);
    inspector_pick(&inspector, 63.5 / WIDTH, 112.5 / HEIGHT);
    assert_true(inspector_update(&inspector, &inspected, NULL, &error));
    assert_true(inspector.has_news && inspector.probe.count >= 4);
    assert_non_null(strstr(inspector.texts[0], "63 112"));
    inspector_walk(&inspector, -1, 2);
    assert_true(inspector_update(&inspector, &inspected, NULL, &error));
    assert_non_null(strstr(inspector.texts[0], "62 114"));
    inspector_choose(&inspector, -1);
    assert_int_equal(inspector.chosen, inspector.probe.count - 1);
    inspector_choose(&inspector, 1);
    assert_int_equal(inspector.chosen, 0);
    Color before = inspector.probe.rays[0].color;
    scene->lights[0].position.x += 1;
    assert_true(renderer_start(renderer, scene, WIDTH, HEIGHT, NULL, NULL, &error));
    inspector_outdate(&inspector);
    assert_true(inspector_update(&inspector, &inspected, NULL, &error));
    assert_true(largest(inspector.probe.rays[0].color) != largest(before));
    inspector_toggle(&inspector);
    assert_false(inspector.is_open);
    inspector_release(&inspector);
    renderer_destroy(renderer);
    scene_destroy(scene);
}

/** Runs the tests. @return How many failed. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_closed_forms), cmocka_unit_test(test_far_away),
        cmocka_unit_test(test_lamp_seen),    cmocka_unit_test(test_projection),
        cmocka_unit_test(test_view),         cmocka_unit_test(test_inspector),
        cmocka_unit_test(test_sums),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
