/**
 * @file
 * @brief "The transparent sphere is right": an acceptance list of eight points, each in every
 *        engine, at three sizes and three distances from the origin; what Fresnel, media and
 *        shadows do besides.
 *
 * Prints a table: the point, the engine, size, offset, what was measured and the most allowed. The
 * marks are those of a scene of size 1 at the origin, in all worlds: a scene W times its size away
 * may be worse by a share of W roundings, no more.
 */
#include "glass_scenes.h"

/** Index of the glass. */
#define GLASS 1.5

/** What was measured. */
typedef struct Measurement {
    double worst; /**< The worst. */
    double limit; /**< The most that is allowed. */
} Measurement;

/**
 * @return A mark in a world.
 * @param single  In float at the origin.
 */
static double error_limit(const Engine *engine, Placement placement, double single, double better) {
    double mark = engine->mantissa_bits == 24 ? single : better;
    return mark * (1 + placement.offset * (double)roundoff(engine));
}

/* --- a: a ball of air in air is not there ------------------------------------------------------
 */

/** Size of the pictures. */
enum { WIDTH = 32, HEIGHT = 24, PIXELS = WIDTH * HEIGHT };

/** @return How many times smaller an engine's pictures are: quad is slow. */
static int picture_divisor(const Engine *engine) {
    return engine->mantissa_bits > 64 ? 3 : 1;
}

/** A sky, a chequered wall that shines, a floor in lamplight. @return It. */
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
 * @return Pixels of two pictures that differ by half a step or more.
 * @param count  How many numbers each has.
 */
static int count_different_pixels(const double *a, const double *b, int count) {
    int different = 0;
    for (int i = 0; i < count; i++) {
        different += !(fabs(srgb_steps(a[i]) - srgb_steps(b[i])) < 0.5);
    }
    return different;
}

/** Index 1 and no tint: the picture without the ball. @return Numbers that are off by a step. */
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

/* --- b, c: which way rays leave a ball ---------------------------------------------------------
 */

/** @return How far a ray passes from the ball's middle. */
static double impact_parameter(const Scene *scene, Placement placement) {
    Vec3d center = placed_point(placement, (Vec3d){0, 0, 0}), eye = scene->camera.position;
    Vec3d direction = scene->camera.direction;
    double y = (center.y - eye.y) / placement.scale, z = (center.z - eye.z) / placement.scale;
    return fabs(y * direction.z - z * direction.y);
}

/** @return How far a ball of glass turns a ray: 2 (i - r). @param b How far it passes from the
 *  middle, in radii. */
static double deviation(double b) {
    return 2 * (asin(b) - asin(b / GLASS));
}

/**
 * A ray that passes below the middle of a ball leaves it upwards. The sky shows which way: it is as
 * bright as its y; what the ball mirrors goes down, where it is black.
 * @return How far the brightness is off, as an angle.
 * @param tilt  How far downwards the ray comes, radians: so that it leaves at a small angle.
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

/** Every ray leaves at 2 (i - r). @return The largest error, radians. */
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
 * A ball with half a wall behind it that shines, and a ray below the middle.
 * @return The scene.
 * @param below  How far below it comes.
 * @param away  How far the wall is.
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

/** @return Whether the ray meets the upper half, though it comes from below. */
static bool image_is_inverted(const Engine *engine, Scene *scene, Placement placement) {
    double kept = 1 - fresnel_closed_form(impact_parameter(scene, placement), 1, GLASS);
    double light = center_radiance(engine, scene, 2) / (kept * kept);
    scene_destroy(scene);
    assert_true(light < 1e-5 || fabs(light - 1) < 1e-5);
    return light > 0.5;
}

/**
 * @return How far from the ball's middle something is, along z and as the scene has it.
 * @param away  How far it should be.
 */
static double depth_of(Placement placement, double away) {
    double here = placed_point(placement, (Vec3d){0, 0, -away}).z;
    return (placed_point(placement, (Vec3d){0, 0, 0}).z - here) / placement.scale;
}

/** A ball turns pictures upside down behind its focus, n R / (2 (n - 1)) behind the middle for rays
 *  near the axis. @return How far the focus is off. */
static Measurement focus(const Engine *engine, Placement placement) {
    // Such a ray passes the middle on the way out as far as on the way in.
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

/* --- d: total reflection -----------------------------------------------------------------------
 */

/** No ray that came from outside is reflected totally in a ball. @return How many are. */
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
    // Rays that just touch the ball, where roundings count most.
    for (int i = 3; i < 24; i++) {
        set_camera(scene, placement, (Vec3d){0, 1 - pow(2, -i), 2}, (Vec3d){0, 0, -1});
        counts.total_reflection +=
            trace_picture(engine, scene, (TraceLimits){12, 1e-12}, 1, 1, rgb).total_reflection;
    }
    scene_destroy(scene);
    return (Measurement){(double)counts.total_reflection, 0};
}

/** In glass, a bubble mirrors all light that comes beyond 2/3 of its radius. @return How far from
 *  there it begins to. */
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
    // A pixel, where a radius is 300 of them.
    return (Measurement){fabs(inner - 1 / GLASS),
                         error_limit(engine, placement, 1.0 / 300, 1.0 / 300)};
}

/* --- e: hollow balls ---------------------------------------------------------------------------
 */

/** @return How far a hollow ball turns a ray. @param b How far it passes from the middle.
 *  @param hole Radius of the hole. */
static double hollow_deviation(double b, double hole) {
    return 2 * (asin(b) - asin(b / GLASS) + asin(b / (GLASS * hole)) - asin(b / hole));
}

/**
 * A hole is a ball of air after the glass. The ray comes upwards, and what is mirrored goes down.
 * @return How far the ray behind is off, radians.
 * @param hole  Radius of the hole.
 * @param b  How far below the middle.
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

/** Hollow balls, from thick ones to those that are hardly there and turn nothing. @return The
 *  largest error, radians. */
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

/** Where light 1 comes from everywhere, glass is not seen: no light is lost and none made. @return
 *  The largest error of a pixel. */
static Measurement furnace_test(const Engine *engine, Placement placement) {
    static double rgb[3 * PIXELS];
    Scene *scene = create_empty_scene();
    scene->sky.horizon = scene->sky.zenith = (Rgbd){1, 1, 1};
    use_material(scene, glass_material(GLASS));
    add_placed_sphere(scene, placement, (Vec3d){-1.1, 0, 0}, 1);
    add_placed_sphere(scene, placement, (Vec3d){1.1, 0, 0}, 1);
    use_material(scene, glass_material(1));
    // In the middle: a bubble beside it turns rays that then never leave.
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

/** What is missing in the furnace at a depth: the orders that were not followed, (1 - F) F^(d - 1).
 *  @return The largest error against that. */
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

/** A point of the list. */
typedef struct AcceptancePoint {
    const char *name;                                              /**< What it says. */
    Measurement (*measure)(const Engine *engine, Placement world); /**< How it is measured. */
} AcceptancePoint;

/** The list; the eighth point is that each holds in all of #placements. */
static const AcceptancePoint points[] = {{"a ball of air: steps off", check_air_sphere},
                                         {"b focus: lengths off", focus},
                                         {"c exit angles: radians off", max_exit_error},
                                         {"d total reflections in a ball", count_total_reflections},
                                         {"d ring of a bubble: radii off", bubble_ring},
                                         {"e hollow balls: radians off", hollow_sphere_error},
                                         {"f white furnace: light off", furnace_test},
                                         {"g depth: light off", depths}};

/** Measures the list. */
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

/** @return Status. */
int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_acceptance)};
    return cmocka_run_group_tests_name("glass", tests, NULL, NULL);
}
