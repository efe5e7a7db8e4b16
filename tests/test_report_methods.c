/**
 * @file
 * @brief Tests of what the reports did in their own way: rays through the corners of pixels, light
 *        modes, and the methods of reports A to D, each against its closed form.
 */
#include "bvh_queries.h"
#include "pictures.h"

/** Pixels of a row of the small pictures here. */
enum { SMALL = 24 };

/** @return A tracer with methods of the reports; to be destroyed. */
static Tracer *create_methods_tracer(const Engine *engine, const Scene *scene, MethodSet set,
                                     PixelPoint point) {
    Error error = {0};
    RenderSettings settings = {.trace = {.depth = scene->image.depth,
                                         .samples = 1,
                                         .pixel_point = point,
                                         .offset = OFFSET_BOUND}};
    method_set_apply(set, &settings);
    Tracer *tracer = engine->create_tracer(scene, &settings.trace, &error);
    assert_non_null(tracer);
    return tracer;
}

/** Traces the one pixel of a scene. @param[out] rgb Its colour. @return The rays. */
static RayCounts trace_by_methods(const Engine *engine, const Scene *scene, MethodSet set,
                                  double rgb[3]) {
    RayCounts counts = {0};
    PixelGrid grid = {.columns = 1, .rows = 1, .stride = 1};
    Tracer *tracer = create_methods_tracer(engine, scene, set, PIXEL_CENTER);
    engine->set_view(tracer, scene, 1, 1);
    engine->trace(tracer, &grid, rgb, &counts);
    engine->destroy(tracer);
    return counts;
}

/** Fails unless a channel is a number, to the roundings of an engine. */
static void assert_light(const Engine *engine, double measured, double truth, const char *what) {
    double unit = engine->mantissa_bits == 24 ? 0x1p-24 : 0x1p-53;
    assert_at_most(fabs(measured - truth), 64 * unit * fmax(1, fabs(truth)), "%s: %.9g, in %s",
                   what, truth, engine->name);
}

/** Adds a material, which the shapes after it have. */
static void paint(Scene *scene, SceneMaterial material) {
    Error error = {0};
    assert_true(scene_add_material(scene, &material, &error));
}

/** @return A material that glows, and reflects a share. */
static SceneMaterial glow(double emission, double reflectivity) {
    SceneMaterial material = *(const SceneMaterial *)scene_material_keyword.defaults;
    material.color = (Rgbd){0, 0, 0};
    material.emission = (Rgbd){emission, emission, emission};
    material.reflectivity = (Rgbd){reflectivity, reflectivity, reflectivity};
    return material;
}

/** Adds a white lamp. @param radius 0: a point. */
static void add_lamp(Scene *scene, Vec3d position, double radius) {
    Error error = {0};
    SceneLight light = *(const SceneLight *)scene_light_keyword.defaults;
    light.position = position;
    light.radius = radius;
    assert_true(scene_add_light(scene, &light, &error));
}

/* --- pixels ----------------------------------------------------------------------------------- */

/**
 * Of a picture of 4 x 3 pixels with a field of view of 90 degrees, the ray of pixel (x, y) meets
 * the plane z = -1 at ((x - 2 + 0.5) / 2, (1.5 - y - 0.5) / 2): at (-0.75, 0.5) for (0, 0). Without
 * the 0.5 of report A it is (-1, 0.75).
 */
static void check_pixel_points(const Engine *engine) {
    Scene *scene = create_empty_scene();
    scene->camera.fov = 90;
    add_shape(scene, "plane", &(PlaneParameters){{0, 0, -1}, {0, 0, 1}});
    for (int corner = 0; corner < 2; corner++) {
        double half = corner ? 0 : 0.5;
        Tracer *tracer = create_methods_tracer(engine, scene, METHODS_OWN, (PixelPoint)corner);
        engine->set_view(tracer, scene, 4, 3);
        for (int pixel = 0; pixel < 12; pixel++) {
            double rgb[3];
            RayCounts counts = {0};
            RayTree tree = {0};
            PixelGrid grid = {.x = pixel % 4, .y = pixel / 4, .columns = 1, .rows = 1, .stride = 1};
            grid.ray_tree = &tree;
            engine->trace(tracer, &grid, rgb, &counts);
            assert_int_equal(tree.count, 1);
            assert_light(engine, tree.nodes[0].point.x, (pixel % 4 - 2 + half) / 2, "x");
            assert_light(engine, tree.nodes[0].point.y, (1.5 - pixel / 4 - half) / 2, "y");
            ray_tree_deinit(&tree);
        }
        engine->destroy(tracer);
    }
    // A selected pixel has the ray of that pixel.
    double all[3 * 12], one[3];
    const uint16_t selected[] = {6};
    RayCounts counts = {0};
    scene->ambient = (Rgbd){1, 1, 1};
    Tracer *tracer = create_methods_tracer(engine, scene, METHODS_OWN, PIXEL_CORNER);
    engine->set_view(tracer, scene, 4, 3);
    PixelGrid grid = {.columns = 4, .rows = 3, .stride = 1};
    engine->trace(tracer, &grid, all, &counts);
    grid.selected = selected;
    grid.selected_count = 1;
    engine->trace(tracer, &grid, one, &counts);
    assert_true(one[0] == all[6]);
    engine->destroy(tracer);
    scene_destroy(scene);
}

/** See #check_pixel_points. */
static void test_pixel_points(void **state) {
    (void)state;
    for_every_engine(check_pixel_points);
}

/**
 * The picture through the corners is the picture through the centres, half a pixel to the right and
 * down: of twice as many pixels, those of odd columns and rows are the centres, the others the
 * corners.
 */
static void test_corners_are_shifted(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/figure-07.lua");
    RenderSettings settings = small_settings(scene, "f64x1", 1);
    settings.samples = 1;
    settings.width = settings.height = SMALL;
    settings.trace.pixel_point = PIXEL_CORNER;
    Picture corners = draw_picture(scene, &settings);
    settings.width = settings.height = 2 * SMALL;
    Picture fine = draw_picture(scene, &settings);
    settings.width = settings.height = SMALL;
    settings.trace.pixel_point = PIXEL_CENTER;
    Picture centres = draw_picture(scene, &settings);
    int differing = 0;
    for (int y = 0; y < SMALL; y++) {
        for (int x = 0; x < SMALL; x++) {
            size_t at = 3 * (size_t)(y * SMALL + x);
            const uint8_t *corner = fine.pixels + 3 * (size_t)(2 * y * 2 * SMALL + 2 * x);
            const uint8_t *centre = corner + 3 * (size_t)(2 * SMALL + 1);
            assert_memory_equal(corners.pixels + at, corner, 3);
            assert_memory_equal(centres.pixels + at, centre, 3);
            differing += memcmp(corner, centre, 3) != 0;
        }
    }
    assert_true(differing > 4);
    picture_deinit(&corners);
    picture_deinit(&fine);
    picture_deinit(&centres);
    scene_destroy(scene);
}

/* --- light modes ------------------------------------------------------------------------------ */

/** @return The linear colour of the middle pixel in a lighting mode. */
static double middle_in_mode(const Engine *engine, const Scene *scene, LightingMode mode,
                             RayCounts *rays) {
    Error error = {0};
    Picture picture;
    RenderSettings settings = render_settings_default(scene);
    settings.engine = engine;
    settings.threads = settings.width = settings.height = settings.samples = 1;
    settings.lighting = mode;
    assert_true(picture_init(&picture, 1, 1, &error) && picture_allocate_linear(&picture, &error));
    Renderer *renderer = create_renderer(scene, &settings);
    *rays = renderer_render(renderer, NULL, &picture).rays;
    double light = (double)picture.linear[0];
    renderer_destroy(renderer);
    picture_deinit(&picture);
    return light;
}

/**
 * Report D's modes. Light alone: the sky is black, and so is ambient light. None: shapes have their
 * own colour, glowing balls and what emits light still glow, and no shadow ray is traced.
 */
static void check_light_modes(const Engine *engine) {
    // What the camera looks at, and what it sees with light and ambient, with light alone, with
    // none.
    static const struct {
        const char *name;
        double expected[LIGHTING_MODE_COUNT];
    } cases[] = {{"the sky", {0.5, 0, 0.5}},
                 {"a glowing ball", {0.75, 0.75, 0.75}},
                 {"a shape that emits light", {0.25, 0.25, 0.25}},
                 {"a matt shape", {0.5 * (0.25 + 0.75), 0.5 * 0.75, 0.5}},
                 {"a mirror of the sky", {0.5, 0, 0.5}}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Scene *scene = create_empty_scene();
        SceneMaterial matt = *(const SceneMaterial *)scene_material_keyword.defaults;
        matt.color = (Rgbd){0.5, 0.5, 0.5};
        scene->sky = (SceneSky){.horizon = {0.5, 0.5, 0.5}, .zenith = {0.5, 0.5, 0.5}};
        scene->ambient = (Rgbd){0.25, 0.25, 0.25};
        add_lamp(scene, i == 1 ? (Vec3d){0, 0, -9} : (Vec3d){0, 0, 0}, i == 1 ? 1 : 0);
        scene->lights[0].intensity = 0.75;
        if (i > 1) {
            paint(scene, i == 2 ? glow(0.25, 0) : i == 3 ? matt : glow(0, 1));
            add_shape(scene, "plane", &(PlaneParameters){{0, 0, -4}, {0, 0, 1}});
        }
        for (int mode = 0; mode < LIGHTING_MODE_COUNT; mode++) {
            RayCounts rays;
            double light = middle_in_mode(engine, scene, (LightingMode)mode, &rays);
            assert_at_most(fabs(light - cases[i].expected[mode]), 1e-6, "%s, mode %d, in %s",
                           cases[i].name, mode, engine->name);
            assert_true(mode != LIGHTING_UNLIT || rays.shadow == 0);
        }
        scene_destroy(scene);
    }
}

/** See #check_light_modes. */
static void test_light_modes(void **state) {
    (void)state;
    for_every_engine(check_light_modes);
}

/* --- spheres ---------------------------------------------------------------------------------- */

/** @return The square root of a number near 1, in quad (Heron). */
static Quadruple root_near_one(Quadruple square) {
    Quadruple root = 1;
    for (int i = 0; i < 10; i++) {
        root = (root + square / root) / 2;
    }
    return root;
}

/** @return The distance along -z or z from an eye to a sphere of radius 1, by the methods of a
 *  report; -1: none. */
static Quadruple sphere_distance(const Engine *engine, MethodSet set, Vec3d eye, Vec3d center,
                                 int direction) {
    RayResult result;
    Scene *scene = create_empty_scene();
    // A second shape keeps the origin of the tracer's coordinates at zero.
    add_shape(scene, "sphere", &(SphereParameters){center, 1});
    add_shape(scene, "sphere", &(SphereParameters){{9, 0, -center.z}, 1e-3});
    Tracer *tracer = create_methods_tracer(engine, scene, set, PIXEL_CENTER);
    RayQueryQuad query = {{eye.x, eye.y, eye.z}, {0, 0, direction}};
    engine->intersect(tracer, 1, &query, &result);
    engine->destroy(tracer);
    scene_destroy(scene);
    return result.shape == 0 ? result.distance : -1;
}

/**
 * Each formula is right but for roundings. At 512 radii the quadratics of A and C are off by over
 * 32 of them, in float and in double, and ours by a few. D's projection misses a sphere that the
 * ray starts in, looking away from its centre.
 */
static void check_spheres(const Engine *engine) {
    double worst[METHODS_COUNT] = {0};
    uint64_t random = 7;
    for (int power = 2; power < 10; power++) {
        for (int i = 0; i < 8; i++) {
            double numbers[6];
            for (int k = 0; k < 6; k++) {
                double number = random_unit_double(&random);
                numbers[k] = engine->mantissa_bits == 24 ? round_to_float(number) : number;
            }
            Vec3d center = {numbers[0] / 2, numbers[1] / 2, -(numbers[2] + 1) * (1 << power)};
            Vec3d eye = {numbers[3] / 2, numbers[4] / 2, numbers[5]};
            Quadruple x = (Quadruple)eye.x - center.x, y = (Quadruple)eye.y - center.y;
            Quadruple truth = (Quadruple)eye.z - center.z - root_near_one(1 - x * x - y * y);
            for (int set = METHODS_OWN; set < METHODS_COUNT; set++) {
                Quadruple found = sphere_distance(engine, (MethodSet)set, eye, center, -1);
                double error = fabs((double)(found / truth - 1)) / (double)roundoff(engine);
                double scale =
                    set == METHODS_OWN || set == METHODS_REPORT_B ? 1 : center.z * center.z;
                assert_at_most(error, 16 * scale, "set %d, %g away, in %s", set, -center.z,
                               engine->name);
                worst[set] = power == 9 ? fmax(worst[set], error) : 0;
            }
        }
    }
    assert_true(worst[METHODS_REPORT_A] > 32 && worst[METHODS_REPORT_C] > 32);
    const Vec3d eye = {0, 0, 0}, center = {0, 0, -0.5};
    assert_true(sphere_distance(engine, METHODS_OWN, eye, center, 1) > 0);
    assert_true(sphere_distance(engine, METHODS_REPORT_A, eye, center, 1) > 0);
    assert_true(sphere_distance(engine, METHODS_REPORT_D, eye, center, 1) < 0);
    assert_true(sphere_distance(engine, METHODS_REPORT_D, eye, center, -1) > 0);
}

/** See #check_spheres. */
static void test_spheres(void **state) {
    (void)state;
    for_every_engine(check_spheres);
}

/* --- report A --------------------------------------------------------------------------------- */

/** @return A mirror at z = -4 that shows a glowing wall at z = 3; the camera is at 0. */
static Scene *mirror_scene(double reflectivity) {
    Scene *scene = create_empty_scene();
    paint(scene, glow(0.125, reflectivity));
    add_shape(scene, "plane", &(PlaneParameters){{0, 0, -4}, {0, 0, 1}});
    paint(scene, glow(0.5, 0));
    add_shape(scene, "plane", &(PlaneParameters){{0, 0, 3}, {0, 0, -1}});
    return scene;
}

/** What a mirror shows fades with 1 / d^2, twice in two mirrors, and what it does not meet is
 *  black. */
static void check_fading(const Engine *engine) {
    double rgb[3];
    Scene *scene = mirror_scene(0.5);
    trace_by_methods(engine, scene, METHODS_OWN, rgb);
    assert_light(engine, rgb[0], 0.125 + 0.5 * 0.5, "a mirror");
    trace_by_methods(engine, scene, METHODS_REPORT_A, rgb);
    // A fixed epsilon of 1e-4 shortens the way from the mirror.
    double way = 7 - 1e-4;
    assert_at_most(fabs(rgb[0] - (0.125 + 0.5 * 0.5 / (way * way))), 1e-6, "a fading mirror, in %s",
                   engine->name);
    scene->materials[2].reflectivity = (Rgbd){0.25, 0.25, 0.25};
    scene->image.depth = 2;
    trace_by_methods(engine, scene, METHODS_REPORT_A, rgb);
    double fading = 1 / (way * way), last = 0.25 * 0.125 * fading;
    assert_at_most(fabs(rgb[0] - (0.125 + 0.5 * fading * (0.5 + last))), 1e-6,
                   "two fading mirrors, in %s", engine->name);
    scene_destroy(scene);
    scene = create_empty_scene();
    scene->sky = (SceneSky){.horizon = {1, 1, 1}, .zenith = {1, 1, 1}};
    paint(scene, glow(0.125, 0.5));
    add_shape(scene, "plane", &(PlaneParameters){{0, 0, -4}, {0, 0, 1}});
    trace_by_methods(engine, scene, METHODS_OWN, rgb);
    assert_light(engine, rgb[0], 0.625, "the sky in a mirror");
    trace_by_methods(engine, scene, METHODS_REPORT_A, rgb);
    assert_light(engine, rgb[0], 0.125, "no sky in report A's mirror");
    scene->camera.direction = (Vec3d){0, 0, 1};
    trace_by_methods(engine, scene, METHODS_REPORT_A, rgb);
    assert_light(engine, rgb[0], 1, "the sky itself");
    scene_destroy(scene);
}

/** See #check_fading. */
static void test_fading(void **state) {
    (void)state;
    for_every_engine(check_fading);
}

/** A wall behind the lamp throws a shadow in report A, and none in ours. */
static void check_shadow_beyond(const Engine *engine) {
    double rgb[3];
    Scene *scene = create_empty_scene();
    add_shape(scene, "plane", &(PlaneParameters){{0, 0, -4}, {0, 0, 1}});
    add_lamp(scene, (Vec3d){0, 0, -1}, 0);
    add_shape(scene, "plane", &(PlaneParameters){{0, 0, 5}, {0, 0, 1}});
    trace_by_methods(engine, scene, METHODS_OWN, rgb);
    assert_light(engine, rgb[0], 1, "a wall behind the lamp");
    trace_by_methods(engine, scene, METHODS_REPORT_A, rgb);
    assert_true(rgb[0] == 0);
    scene_destroy(scene);
}

/** See #check_shadow_beyond. */
static void test_shadow_beyond(void **state) {
    (void)state;
    for_every_engine(check_shadow_beyond);
}

/** Behind the first surface of report A, reflected rays are only reflected, refracted ones only
 *  refracted; the weights are the material's. Ours do both. */
static void check_chains(const Engine *engine) {
    Scene *scene = load_scene("scenes/report-d-glass.lua");
    scene->image.depth = 6;
    int mixed[2] = {0, 0}, deep = 0;
    for (int set = METHODS_OWN; set <= METHODS_REPORT_A; set++) {
        Tracer *tracer = create_methods_tracer(engine, scene, (MethodSet)set, PIXEL_CENTER);
        engine->set_view(tracer, scene, SMALL, SMALL / 2);
        for (int pixel = 0; pixel < SMALL * SMALL / 2; pixel += 7) {
            double rgb[3];
            RayCounts counts = {0};
            RayTree tree = {0};
            PixelGrid grid = {.x = pixel % SMALL,
                              .y = pixel / SMALL,
                              .columns = 1,
                              .rows = 1,
                              .stride = 1,
                              .ray_tree = &tree};
            engine->trace(tracer, &grid, rgb, &counts);
            for (size_t i = 1; i < tree.count; i++) {
                const RayTreeNode *ray = &tree.nodes[i], *parent = &tree.nodes[ray->parent];
                if (ray->kind != RAY_SHADOW && parent->kind != RAY_CAMERA) {
                    mixed[set] += ray->kind != parent->kind;
                    deep += set == METHODS_REPORT_A;
                }
            }
            ray_tree_deinit(&tree);
        }
        engine->destroy(tracer);
    }
    assert_true(mixed[METHODS_OWN] > 10 && deep > 10);
    assert_int_equal(mixed[METHODS_REPORT_A], 0);
    scene_destroy(scene);
}

/** See #check_chains. */
static void test_chains(void **state) {
    (void)state;
    for_every_engine(check_chains);
}

/* --- report C --------------------------------------------------------------------------------- */

/** In report C ambient light is only in the shadow: a point that light grazes is darker. */
static void check_ambient_in_shadow(const Engine *engine) {
    // The lamp: in front; beside, at a cosine of 1/8; hidden behind a shape; behind the surface.
    static const struct {
        Vec3d lamp;
        bool is_hidden;
        double own, report;
    } cases[] = {{{0, 0, -1}, false, 1.25, 1},
                 {{3 * 7.9372539331937718, 0, -1}, false, 0.375, 0.125},
                 {{0, 3, -1}, true, 0.25, 0.25},
                 {{0, 0, -5}, false, 0.25, 0.25}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double rgb[3];
        Scene *scene = create_empty_scene();
        scene->ambient = (Rgbd){0.25, 0.25, 0.25};
        add_shape(scene, "plane", &(PlaneParameters){{0, 0, -4}, {0, 0, 1}});
        if (cases[i].is_hidden) {
            add_shape(scene, "sphere", &(SphereParameters){{0, 1.5, -2.5}, 0.5});
        }
        add_lamp(scene, cases[i].lamp, 0);
        trace_by_methods(engine, scene, METHODS_OWN, rgb);
        assert_light(engine, rgb[0], cases[i].own, "ambient light everywhere");
        trace_by_methods(engine, scene, METHODS_REPORT_C, rgb);
        assert_light(engine, rgb[0], cases[i].report, "ambient light in the shadow");
        scene_destroy(scene);
    }
}

/** See #check_ambient_in_shadow. */
static void test_ambient_in_shadow(void **state) {
    (void)state;
    for_every_engine(check_ambient_in_shadow);
}

/* --- report D --------------------------------------------------------------------------------- */

/** White light of 5 cos / (2 + d) is added to the colour; alone it is multiplied. A shape in
 * between throws a shadow, the shape itself none: although rays start on it without an offset. */
static void check_added_light(const Engine *engine) {
    for (int i = 0; i < 4; i++) {
        double rgb[3], color = 0.125;
        Scene *scene = create_empty_scene();
        bool is_alone = i % 2, is_hidden = i / 2;
        scene->materials[0].color = (Rgbd){color, color, color};
        scene->ambient = is_alone ? (Rgbd){0, 0, 0} : (Rgbd){0.5, 0.5, 0.5};
        add_shape(scene, "sphere", &(SphereParameters){{0, 0, -5}, 1});
        add_lamp(scene, (Vec3d){0, 0, -1}, 0);
        scene->lights[0].color = (Rgbd){0.1, 0.2, 0.3}; // The report's lamps are white.
        if (is_hidden) {
            scene->camera.position = (Vec3d){0, 0, -2};
            add_shape(scene, "disk", &(DiskParameters){{0, 0, -1.5}, {0, 0, 1}, 0.25});
        }
        trace_by_methods(engine, scene, METHODS_REPORT_D, rgb);
        double light = is_hidden ? 0 : 5.0 / (2 + 3);
        assert_light(engine, rgb[0], is_alone ? color * light : color + light, "white light");
        assert_true(rgb[0] == rgb[1] && rgb[1] == rgb[2]);
        scene_destroy(scene);
    }
}

/** See #check_added_light. */
static void test_added_light(void **state) {
    (void)state;
    for_every_engine(check_added_light);
}

/** All of a sphere that faces the lamp is lit in report D, without any offset: no acne. */
static void check_shadow_by_shape(const Engine *engine) {
    Scene *scene = create_empty_scene();
    double rgb[3 * SMALL * SMALL];
    RayCounts counts = {0};
    PixelGrid grid = {.columns = SMALL, .rows = SMALL, .stride = 1};
    scene->camera.fov = 30;
    add_shape(scene, "sphere", &(SphereParameters){{0, 0, -5}, 1});
    add_lamp(scene, (Vec3d){0, 0, 0}, 0);
    for (int set = METHODS_REPORT_D; set >= METHODS_OWN; set -= METHODS_REPORT_D) {
        int lit = 0, dark = 0;
        Error error = {0};
        RenderSettings settings = {.trace = {.samples = 1}};
        method_set_apply((MethodSet)set, &settings);
        settings.trace.offset = OFFSET_NONE;
        Tracer *tracer = engine->create_tracer(scene, &settings.trace, &error);
        engine->set_view(tracer, scene, SMALL, SMALL);
        engine->trace(tracer, &grid, rgb, &counts);
        for (int i = 0; i < SMALL * SMALL; i++) {
            double x = (i % SMALL + 0.5) / SMALL * 2 - 1, y = (i / SMALL + 0.5) / SMALL * 2 - 1;
            double away = hypot(x, y) * tan(M_PI / 12);
            if (away < 0.19) { // The sphere's edge is at the tangent 1 / sqrt(24).
                lit += rgb[i] > 0.01;
                dark += rgb[i] <= 0.01;
            }
        }
        assert_true(lit + dark > SMALL * SMALL / 4);
        assert_true(set == METHODS_REPORT_D ? dark == 0 : engine->mantissa_bits > 24 || dark > 0);
        engine->destroy(tracer);
    }
    scene_destroy(scene);
}

/** See #check_shadow_by_shape. */
static void test_shadow_by_shape(void **state) {
    (void)state;
    for_every_engine(check_shadow_by_shape);
}

/** A pixel of report D is the mean of at most four rays, whatever their weights: of a mirror and a
 *  wall, of four turns between two mirrors, of the first four rays in a slab of glass. */
static void check_mean_of_rays(const Engine *engine) {
    double rgb[3];
    Scene *scene = mirror_scene(0.25);
    RayCounts counts = trace_by_methods(engine, scene, METHODS_REPORT_D, rgb);
    assert_light(engine, rgb[0], (0.125 + 0.5) / 2, "a mirror and a wall");
    assert_int_equal(counts.reflection, 1);
    scene->materials[2].reflectivity = (Rgbd){1, 1, 1};
    scene->image.depth = 50;
    counts = trace_by_methods(engine, scene, METHODS_REPORT_D, rgb);
    assert_light(engine, rgb[0], (0.125 + 0.5) / 2, "two mirrors");
    assert_int_equal(counts.reflection, 3);
    scene_destroy(scene);
    // Through a slab: into it, and out to the wall behind; one ray back to the wall in front.
    scene = create_empty_scene();
    scene->image.depth = 50;
    SceneMaterial glass = glow(0.0625, 0);
    glass.transparency = (Rgbd){1, 1, 1};
    glass.ior = 1.5;
    paint(scene, glass);
    add_shape(scene, "box", &(BoxParameters){{-9, -9, -3}, {9, 9, -2}});
    paint(scene, glow(0.5, 0));
    add_shape(scene, "plane", &(PlaneParameters){{0, 0, -8}, {0, 0, 1}});
    paint(scene, glow(0.25, 0));
    add_shape(scene, "plane", &(PlaneParameters){{0, 0, 5}, {0, 0, -1}});
    // With an offset: without one, the ray that goes in meets the front face again.
    Error error = {0};
    RenderSettings settings = {.trace = {.samples = 1, .depth = 50}};
    method_set_apply(METHODS_REPORT_D, &settings);
    settings.trace.offset = OFFSET_BOUND;
    Tracer *tracer = engine->create_tracer(scene, &settings.trace, &error);
    engine->set_view(tracer, scene, 1, 1);
    PixelGrid grid = {.columns = 1, .rows = 1, .stride = 1};
    counts = (RayCounts){0};
    engine->trace(tracer, &grid, rgb, &counts);
    engine->destroy(tracer);
    assert_light(engine, rgb[0], (0.0625 + 0.25 + 0.0625 + 0.5) / 4, "a slab of glass");
    assert_int_equal(counts.reflection, 1);
    assert_int_equal(counts.refraction, 2);
    scene_destroy(scene);
}

/** See #check_mean_of_rays. */
static void test_mean_of_rays(void **state) {
    (void)state;
    for_every_engine(check_mean_of_rays);
}

/* --- all sets --------------------------------------------------------------------------------- */

/** @return The engine with as many bits and one lane that is built; NULL: none. */
static const Engine *single_lane(int bits) {
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if ((*engine)->mantissa_bits == bits && (*engine)->lanes == 1) {
            return *engine;
        }
    }
    return NULL;
}

/** Each set of methods gives the same bits for any number of lanes and threads, and another picture
 *  than ours. The layer of errors compares it with our own methods. */
static void test_same_bits(void **state) {
    (void)state;
    static const char *const scenes[] = {"scenes/report-d-glass.lua", "scenes/box.lua",
                                         "scenes/lamps.lua"};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        Scene *scene = load_scene(scenes[i]);
        for (const Engine *const *engine = engine_list(); *engine; engine++) {
            const Engine *single = single_lane((*engine)->mantissa_bits);
            if ((*engine)->lanes == 1 || !single || !engine_is_supported(*engine)) {
                continue;
            }
            Picture own = {0};
            for (int set = METHODS_OWN; set < METHODS_COUNT; set++) {
                RenderSettings settings = small_settings(scene, (*engine)->name, 2);
                settings.samples = 1;
                settings.width = 67;
                settings.height = 43;
                method_set_apply((MethodSet)set, &settings);
                Picture wide = draw_picture(scene, &settings);
                settings.engine = single;
                settings.threads = 1;
                assert_same_picture(&wide, draw_picture(scene, &settings));
                if (set == METHODS_OWN) {
                    own = wide;
                    continue;
                }
                // Report B differs from us in the marching of fields alone.
                double off = (double)picture_compare(&own, &wide, NULL).max_difference;
                assert_true((off > 0) == (set != METHODS_REPORT_B));
                picture_deinit(&wide);
            }
            picture_deinit(&own);
        }
        scene_destroy(scene);
    }
}

/** The layer of errors measures the reports against our own methods: A's mirrors are wrong, ours
 *  are not. Changing back restores all settings. */
static void test_error_layer(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/box.lua");
    const RenderSettings own = small_settings(scene, "f64x1", 2);
    for (int set = METHODS_COUNT - 1; set >= METHODS_OWN; set--) {
        Error error = {0};
        RenderStats report = {0};
        RenderSettings settings = own;
        const struct timespec pause = {.tv_nsec = 1000000};
        method_set_apply((MethodSet)set, &settings);
        settings.samples = 1;
        Renderer *renderer = create_renderer(scene, &settings);
        renderer_set_layer(renderer, LAYER_ERROR);
        assert_true(renderer_start(renderer, scene, SMALL, SMALL, NULL, NULL, &error));
        while (!renderer_copy_latest(renderer, &report, NULL, 0) || !report.is_finished) {
            nanosleep(&pause, NULL);
        }
        bool is_own = set == METHODS_OWN || set == METHODS_REPORT_B;
        assert_true(is_own ? report.layer.artifact_pixels == 0
                           : report.layer.artifact_pixels > SMALL * SMALL / 16);
        renderer_destroy(renderer);
        method_set_apply(METHODS_OWN, &settings);
        settings.samples = own.samples;
        assert_memory_equal(&settings, &own, sizeof own);
    }
    scene_destroy(scene);
}

/** Runs the tests. @return 0 if all pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixel_points), cmocka_unit_test(test_corners_are_shifted),
        cmocka_unit_test(test_light_modes),  cmocka_unit_test(test_spheres),
        cmocka_unit_test(test_fading),       cmocka_unit_test(test_shadow_beyond),
        cmocka_unit_test(test_chains),       cmocka_unit_test(test_ambient_in_shadow),
        cmocka_unit_test(test_added_light),  cmocka_unit_test(test_shadow_by_shape),
        cmocka_unit_test(test_mean_of_rays), cmocka_unit_test(test_same_bits),
        cmocka_unit_test(test_error_layer),
    };
    return cmocka_run_group_tests_name("report methods", tests, NULL, NULL);
}
