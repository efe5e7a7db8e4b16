/**
 * @file
 * @brief Acceptance tests of a transparent sphere: eight points, each in every engine, at three
 *        sizes and three distances from the origin. They cover Fresnel reflectance, media and
 *        shadows, too.
 *
 * Prints a table: point, engine, size, offset, measured value, limit. The limits are those of a
 * scene of size 1 at the origin. A scene at W times its size from the origin may be worse by W
 * rounding errors, no more.
 */
#include "glass_scenes.h"

/** Index of refraction of the glass. */
#define GLASS 1.5

/** A measurement. */
typedef struct Measurement {
    double worst; /**< The worst value. */
    double limit; /**< The limit. */
} Measurement;

/**
 * @return The limit of an error at a placement.
 * @param single  The limit in float at the origin.
 */
static double error_limit(const Engine *engine, Placement placement, double single, double better) {
    double mark = engine->mantissa_bits == 24 ? single : better;
    return mark * (1 + placement.offset * (double)roundoff(engine));
}

/* --- a: a sphere of index 1 is invisible ------------------------------------------------------ */

/** Size of the pictures. */
enum { WIDTH = 32, HEIGHT = 24, PIXELS = WIDTH * HEIGHT };

/** @return Divisor of the size of an engine's pictures: quad is slow. */
static int picture_divisor(const Engine *engine) {
    return engine->mantissa_bits > 64 ? 3 : 1;
}

/** A sky, a chequered emissive wall, a lit floor. @return The scene. */
static Scene *checker_scene(Placement placement) {
    Error error = {0};
    Scene *scene = create_empty_scene();
    scene->sky.horizon = (Rgbd){0.3, 0.4, 0.5};
    scene->sky.zenith = (Rgbd){0.9, 0.2, 0.7};
    SceneLight light = *(const SceneLight *)scene_light_keyword.defaults;
    light.position = placed_point(placement, (Vec3d){0.5, 4, 0.5});
    assert_true(scene_add_light(scene, &light, &error));
    use_material(scene, *(const SceneMaterial *)scene_material_keyword.defaults);
    add_placed_plane(scene, placement, (Vec3d){0, -1.5, 0}, (Vec3d){0, 1, 0});
    use_material(scene, emissive_material((Rgbd){0.6, 0.1, 0.3}));
    for (int i = 0; i < 16; i++) {
        if ((i + i / 4) % 2 == 0) {
            Vec3d corner = {-2 + i % 4, -1 + i / 4, -3};
            add_placed_quad(scene, placement, corner, (Vec3d){1, 0, 0}, (Vec3d){0, 1, 0});
        }
    }
    set_camera(scene, placement, (Vec3d){0.1, 0.2, 4}, (Vec3d){0, -0.1, -1});
    return scene;
}

/**
 * @return Number of values of two pictures that differ by half a step or more.
 * @param count  Number of values of each.
 */
static int count_different_pixels(const double *a, const double *b, int count) {
    int different = 0;
    for (int i = 0; i < count; i++) {
        different += !(fabs(srgb_steps(a[i]) - srgb_steps(b[i])) < 0.5);
    }
    return different;
}

/**
 * With index 1 and no tint, the picture equals that without the sphere.
 * @return Number of values that differ by a step.
 */
static Measurement check_air_sphere(const Engine *engine, Placement placement) {
    static double without[3 * PIXELS], with[3 * PIXELS];
    Scene *scene = checker_scene(placement);
    int small = picture_divisor(engine), width = WIDTH / small, height = HEIGHT / small;
    trace_picture(engine, scene, (TraceLimits){8, 0}, width, height, without);
    use_material(scene, glass_material(1));
    add_placed_sphere(scene, placement, (Vec3d){0, 0, 0}, 1);
    RayCounts counts = trace_picture(engine, scene, (TraceLimits){8, 0}, width, height, with);
    assert_true((int)counts.refraction > width * height / 8);
    assert_int_equal(counts.reflection, 0);
    scene_destroy(scene);
    return (Measurement){count_different_pixels(without, with, 3 * width * height), 0};
}

/* --- b, c: directions of rays that leave a sphere --------------------------------------------- */

/** @return Distance of a ray from the sphere's centre. */
static double impact_parameter(const Scene *scene, Placement placement) {
    Vec3d center = placed_point(placement, (Vec3d){0, 0, 0}), eye = scene->camera.position;
    Vec3d direction = scene->camera.direction;
    double y = (center.y - eye.y) / placement.scale, z = (center.z - eye.z) / placement.scale;
    return fabs(y * direction.z - z * direction.y);
}

/**
 * @return Deviation of a ray by a glass sphere: 2 (i - r).
 * @param b Its distance from the centre, in radii.
 */
static double deviation(double b) {
    return 2 * (asin(b) - asin(b / GLASS));
}

/**
 * A ray that passes below the centre of a sphere leaves it upwards. The sky shows its direction:
 * its brightness is y. The reflected part goes down, where the sky is black.
 * @return The error of the brightness, as an angle.
 * @param tilt  Downward angle of the incoming ray, radians, so that it leaves at a small angle.
 */
static double exit_error(const Engine *engine, Placement placement, double b, double tilt) {
    Scene *scene = create_empty_scene();
    scene->sky.zenith = (Rgbd){1, 1, 1};
    use_material(scene, glass_material(GLASS));
    add_placed_sphere(scene, placement, (Vec3d){0, 0, 0}, 1);
    Vec3d direction = {0, -sin(tilt), -cos(tilt)}, below = {0, -cos(tilt), sin(tilt)};
    Vec3d eye = vec3d_add(vec3d_scale(below, b), vec3d_scale(direction, -2));
    set_camera(scene, placement, eye, direction);
    double sine = impact_parameter(scene, placement),
           kept = 1 - fresnel_closed_form(sine, 1, GLASS);
    double truth = kept * kept * sin(deviation(sine) - tilt);
    double error = fabs(center_radiance(engine, scene, 2) - truth);
    scene_destroy(scene);
    return error / (kept * kept * cos(deviation(sine) - tilt));
}

/** Every ray is deviated by 2 (i - r). @return The largest error, radians. */
static Measurement max_exit_error(const Engine *engine, Placement placement) {
    double worst = 0;
    for (int i = 1; i <= 32; i++) {
        double b = 0.99 * i / 32;
        double tilt = deviation(b) > 1 ? 0.75 : 0;
        worst = fmax(worst, exit_error(engine, placement, b, tilt));
    }
    return (Measurement){worst, error_limit(engine, placement, 1e-5, 1e-13)};
}

/**
 * A sphere with an emissive half wall behind it, and a ray below the centre.
 * @return The scene.
 * @param below  Distance of the ray below the centre.
 * @param away  Distance of the wall.
 */
static Scene *half_wall_scene(Placement placement, double below, double away) {
    Scene *scene = create_empty_scene();
    use_material(scene, glass_material(GLASS));
    add_placed_sphere(scene, placement, (Vec3d){0, 0, 0}, 1);
    use_material(scene, emissive_material((Rgbd){1, 1, 1}));
    add_placed_quad(scene, placement, (Vec3d){-1, 0, -away}, (Vec3d){2, 0, 0}, (Vec3d){0, 1, 0});
    set_camera(scene, placement, (Vec3d){0, -below, 2}, (Vec3d){0, 0, -1});
    return scene;
}

/** @return Whether the ray hits the upper half, although it starts below. */
static bool image_is_inverted(const Engine *engine, Scene *scene, Placement placement) {
    double kept = 1 - fresnel_closed_form(impact_parameter(scene, placement), 1, GLASS);
    double light = center_radiance(engine, scene, 2) / (kept * kept);
    scene_destroy(scene);
    assert_true(light < 1e-5 || fabs(light - 1) < 1e-5);
    return light > 0.5;
}

/**
 * @return Distance from the sphere's centre along z, as rounded in the scene.
 * @param away  The exact distance.
 */
static double depth_of(Placement placement, double away) {
    double here = placed_point(placement, (Vec3d){0, 0, -away}).z;
    return (placed_point(placement, (Vec3d){0, 0, 0}).z - here) / placement.scale;
}

/**
 * A sphere inverts images beyond its focal point, n R / (2 (n - 1)) behind the centre for rays near
 * the axis.
 * @return The error of the focal point.
 */
static Measurement focus(const Engine *engine, Placement placement) {
    // Such a ray leaves at the same distance from the centre as it enters.
    const double below = 0.125, truth = below / sin(deviation(below));
    double closed = GLASS / (2 * (GLASS - 1));
    assert_at_most(fabs(0.01 / sin(deviation(0.01)) - closed), 1e-3, "closed form");
    double near = 1.001, far = 3;
    for (int i = 0; i < 24; i++) {
        double middle = (near + far) / 2;
        bool turned =
            image_is_inverted(engine, half_wall_scene(placement, below, middle), placement);
        near = turned ? near : middle;
        far = turned ? middle : far;
    }
    double early = depth_of(placement, near) - truth, late = truth - depth_of(placement, far);
    return (Measurement){fmax(0, fmax(early, late)), error_limit(engine, placement, 2e-6, 1e-12)};
}

/* --- d: total internal reflection ------------------------------------------------------------- */

/** A ray from outside is never totally reflected inside a sphere. @return Number of violations. */
static Measurement count_total_reflections(const Engine *engine, Placement placement) {
    static double rgb[3 * 4 * PIXELS];
    Scene *scene = create_empty_scene();
    use_material(scene, glass_material(GLASS));
    add_placed_sphere(scene, placement, (Vec3d){0, 0, 0}, 1);
    set_camera(scene, placement, (Vec3d){0, 0, 2.5}, (Vec3d){0, 0, -1});
    scene->camera.fov = 50;
    int small = picture_divisor(engine);
    RayCounts counts = trace_picture(engine, scene, (TraceLimits){12, 0}, 2 * WIDTH / small,
                                     2 * HEIGHT / small, rgb);
    assert_true(counts.refraction > 100);
    // Rays that just touch the sphere, where rounding errors are largest.
    for (int i = 3; i < 24; i++) {
        set_camera(scene, placement, (Vec3d){0, 1 - pow(2, -i), 2}, (Vec3d){0, 0, -1});
        counts.total_reflection +=
            trace_picture(engine, scene, (TraceLimits){12, 1e-12}, 1, 1, rgb).total_reflection;
    }
    scene_destroy(scene);
    return (Measurement){(double)counts.total_reflection, 0};
}

/**
 * In glass, a bubble reflects all light beyond 2/3 of its radius.
 * @return The error of that radius.
 */
static Measurement bubble_ring(const Engine *engine, Placement placement) {
    double inner = 0, outer = 1;
    for (int i = 0; i < 24; i++) {
        double middle = (inner + outer) / 2, rgb[3];
        Scene *scene = create_empty_scene();
        use_material(scene, glass_material(GLASS));
        add_placed_box(scene, placement, (Vec3d){-4, -4, -4}, (Vec3d){4, 4, 4});
        use_material(scene, glass_material(1));
        add_placed_sphere(scene, placement, (Vec3d){0, 0, 0}, 1);
        set_camera(scene, placement, (Vec3d){0, middle, 3}, (Vec3d){0, 0, -1});
        bool is_total =
            trace_picture(engine, scene, (TraceLimits){1, 0}, 1, 1, rgb).total_reflection > 0;
        inner = is_total ? inner : middle;
        outer = is_total ? middle : outer;
        scene_destroy(scene);
    }
    // One pixel, where the radius is 300 pixels.
    return (Measurement){fabs(inner - 1 / GLASS),
                         error_limit(engine, placement, 1.0 / 300, 1.0 / 300)};
}

/* --- e: hollow spheres ------------------------------------------------------------------------ */

/**
 * @return Deviation of a ray by a hollow sphere.
 * @param b  Its distance from the centre.
 * @param hole  Radius of the hole.
 */
static double hollow_deviation(double b, double hole) {
    return 2 * (asin(b) - asin(b / GLASS) + asin(b / (GLASS * hole)) - asin(b / hole));
}

/**
 * The hole is a sphere of index 1 after the glass. The ray points up; the reflected part goes down.
 * @return The error of the transmitted direction, radians.
 * @param hole  Radius of the hole.
 * @param b  Distance of the ray below the centre.
 */
static double hollow_error(const Engine *engine, Placement placement, double hole, double b) {
    const double tilt = -0.5;
    Scene *scene = create_empty_scene();
    scene->sky.zenith = (Rgbd){1, 1, 1};
    use_material(scene, glass_material(GLASS));
    add_placed_sphere(scene, placement, (Vec3d){0, 0, 0}, 1);
    use_material(scene, glass_material(1));
    add_placed_sphere(scene, placement, (Vec3d){0, 0, 0}, hole);
    Vec3d direction = {0, -sin(tilt), -cos(tilt)}, below = {0, -cos(tilt), sin(tilt)};
    set_camera(scene, placement, vec3d_add(vec3d_scale(below, b), vec3d_scale(direction, -2)),
               direction);
    double sine = impact_parameter(scene, placement);
    double kept = (1 - fresnel_closed_form(sine, 1, GLASS)) *
                  (1 - fresnel_closed_form(sine / (GLASS * hole), GLASS, 1));
    double out = hollow_deviation(sine, hole) - tilt;
    double error = fabs(center_radiance(engine, scene, 4) - kept * kept * sin(out));
    scene_destroy(scene);
    return error / (kept * kept * cos(out));
}

/**
 * Hollow spheres, from thick ones to very thin ones without deviation.
 * @return The largest error, radians.
 */
static Measurement hollow_sphere_error(const Engine *engine, Placement placement) {
    double worst = 0;
    static const double holes[] = {0.7, 0.99, 0.9999};
    for (int i = 0; i < 33; i++) {
        worst = fmax(worst, hollow_error(engine, placement, holes[i % 3], 0.05 * (1 + i / 3)));
    }
    assert_at_most(fabs(hollow_deviation(0.5, 0.9999)), 1e-4, "closed form");
    return (Measurement){worst, error_limit(engine, placement, 1e-5, 1e-13)};
}

/* --- f: the white furnace ----------------------------------------------------------------------
 */

/**
 * Under uniform light of radiance 1, glass is invisible: energy is conserved.
 * @return The largest error of a pixel.
 */
static Measurement furnace_test(const Engine *engine, Placement placement) {
    static double rgb[3 * PIXELS];
    Scene *scene = create_empty_scene();
    scene->sky.horizon = scene->sky.zenith = (Rgbd){1, 1, 1};
    use_material(scene, glass_material(GLASS));
    add_placed_sphere(scene, placement, (Vec3d){-1.1, 0, 0}, 1);
    add_placed_sphere(scene, placement, (Vec3d){1.1, 0, 0}, 1);
    use_material(scene, glass_material(1));
    // At the centre: a bubble off the centre traps some rays.
    add_placed_sphere(scene, placement, (Vec3d){1.1, 0, 0}, 0.6);
    set_camera(scene, placement, (Vec3d){0.03, 0.02, 4}, (Vec3d){0, 0, -1});
    int small = picture_divisor(engine), width = WIDTH / small, height = HEIGHT / small;
    trace_picture(engine, scene, (TraceLimits){96, 1e-9}, width, height, rgb);
    double worst = 0;
    for (int i = 0; i < 3 * width * height; i++) {
        worst = fmax(worst, fabs(rgb[i] - 1));
    }
    scene_destroy(scene);
    return (Measurement){worst, error_limit(engine, placement, 1e-5, 1e-5)};
}

/* --- g: depth ----------------------------------------------------------------------------------
 */

/**
 * The energy missing in the furnace at a depth: that of the omitted reflections, (1 - F) F^(d - 1).
 * @return The largest error relative to that.
 */
static Measurement depths(const Engine *engine, Placement placement) {
    double worst = 0;
    for (int depth = 1; depth <= 8; depth++) {
        for (int i = 0; i < 8; i++) {
            Scene *scene = create_empty_scene();
            scene->sky.horizon = scene->sky.zenith = (Rgbd){1, 1, 1};
            use_material(scene, glass_material(GLASS));
            add_placed_sphere(scene, placement, (Vec3d){0, 0, 0}, 1);
            set_camera(scene, placement, (Vec3d){0, 0.1 * i, 2}, (Vec3d){0, 0, -1});
            double fraction = fresnel_closed_form(impact_parameter(scene, placement), 1, GLASS);
            double missing = (1 - fraction) * pow(fraction, depth - 1);
            worst = fmax(worst, fabs(1 - missing - center_radiance(engine, scene, depth)));
            assert_true(depth < 5 || missing < 1e-4);
            scene_destroy(scene);
        }
    }
    return (Measurement){worst, error_limit(engine, placement, 2e-6, 1e-14)};
}

/** A point of the acceptance list. */
typedef struct AcceptancePoint {
    const char *name;                                              /**< Its statement. */
    Measurement (*measure)(const Engine *engine, Placement world); /**< Measures it. */
} AcceptancePoint;

/** The list. The eighth point is that each holds at all of #placements. */
static const AcceptancePoint points[] = {{"a ball of air: steps off", check_air_sphere},
                                         {"b focus: lengths off", focus},
                                         {"c exit angles: radians off", max_exit_error},
                                         {"d total reflections in a ball", count_total_reflections},
                                         {"d ring of a bubble: radii off", bubble_ring},
                                         {"e hollow balls: radians off", hollow_sphere_error},
                                         {"f white furnace: light off", furnace_test},
                                         {"g depth: light off", depths}};

/** Measures all points. */
static void acceptance(const Engine *engine) {
    for (size_t p = 0; p < sizeof points / sizeof *points; p++) {
        for (int w = 0; w < PLACEMENT_COUNT; w++) {
            Measurement m = points[p].measure(engine, placements[w]);
            printf("%-32s %-7s scale %-6g offset %-6g %10.3g of %.3g\n", points[p].name,
                   engine->name, placements[w].scale, placements[w].offset, m.worst, m.limit);
            assert_at_most(m.worst, m.limit, "%s in %s, scale %g, offset %g", points[p].name,
                           engine->name, placements[w].scale, placements[w].offset);
        }
    }
}

/** @param state Not used. */
static void test_acceptance(void **state) {
    (void)state;
    for_every_engine(acceptance);
}

/* --- total reflection -------------------------------------------------------------------------
 */

/** Total reflections of the test's ray. */
enum { TOTAL_REFLECTIONS = 60 };

/** Largest change of the distance from the centre, half ulps: a few per turn, in both directions.
 *  Origins off their line by their offset would add up to a thousand. */
#define DRIFT_LIMIT 100

/** @return The distance of a ray's line from the origin. */
static double line_distance(const RayTreeNode *node) {
    const Vec3d o = node->origin, d = node->direction;
    Vec3d cross = {o.y * d.z - o.z * d.y, o.z * d.x - o.x * d.z, o.x * d.y - o.y * d.x};
    return vec3d_length(cross) / vec3d_length(d);
}

/**
 * A totally reflected ray in a ball passes the centre at the same distance for ever. In float,
 * errors that have one sign would reach other pixels after some dozen turns.
 */
static void check_total_reflections(const Engine *engine) {
    const Placement here = {1, 0};
    Error error = {0};
    Scene *scene = create_empty_scene();
    use_material(scene, glass_material(GLASS));
    add_placed_sphere(scene, here, (Vec3d){0, 0, 0}, 1);
    set_camera(scene, here, (Vec3d){0.75, 0, 0}, (Vec3d){0.125, 1, 0.25});
    TraceSettings settings = {.depth = TOTAL_REFLECTIONS, .cutoff = 1e-5, .offset = OFFSET_BOUND};
    Tracer *tracer = engine->create_tracer(scene, &settings, &error);
    assert_non_null(tracer);
    RayTree tree = {0};
    PixelGrid grid = {.columns = 1, .rows = 1, .stride = 1, .ray_tree = &tree};
    RayCounts counts = {0};
    double rgb[3], worst = 0;
    engine->set_view(tracer, scene, 1, 1);
    engine->trace(tracer, &grid, rgb, &counts);
    assert_int_equal((int)tree.count, TOTAL_REFLECTIONS + 1);
    for (size_t i = 1; i < tree.count; i++) {
        assert_int_equal((int)tree.nodes[i].kind, RAY_REFLECTION);
        worst = fmax(worst, fabs(line_distance(&tree.nodes[i]) - line_distance(&tree.nodes[0])));
    }
    // The tree is in double.
    double u = fmax((double)roundoff(engine), 0x1p-53);
    printf("%d total reflections in %s: %.3g half ulps off\n", TOTAL_REFLECTIONS, engine->name,
           worst / u);
    assert_at_most(worst, DRIFT_LIMIT * u, "total reflections in %s", engine->name);
    ray_tree_deinit(&tree);
    engine->destroy(tracer);
    scene_destroy(scene);
}

/** @param state Not used. */
static void test_total_reflections(void **state) {
    (void)state;
    for_every_engine(check_total_reflections);
}

/** @return 0 if all tests pass. */
int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_acceptance),
                                       cmocka_unit_test(test_total_reflections)};
    return cmocka_run_group_tests_name("glass", tests, NULL, NULL);
}
