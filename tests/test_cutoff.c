/**
 * @file
 * @brief Rays end by what they could still add: random scenes of glass and mirrors against a cutoff
 *        far finer, bright lights in weak mirrors, mirrors without end, hidden surfaces.
 */
#include "glass_scenes.h"

#include "base/encoding.h"

/** Size of a picture. */
enum { COLUMNS = 16, ROWS = 12, VALUES = 3 * COLUMNS * ROWS };

/** Where shapes are placed: as given. */
static const Placement here = {1, 0};

/** @return The next random number, 0 to 1 (Knuth's linear congruential generator). */
static double random_unit(uint64_t *state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) * 0x1p-53;
}

/** @return A grey mirror that also has a colour. @param reflectivity Its share of mirrored light.
 */
static SceneMaterial mirror_material(double reflectivity) {
    SceneMaterial material = *(const SceneMaterial *)scene_material_keyword.defaults;
    material.reflectivity = (Rgbd){reflectivity, reflectivity, reflectivity};
    material.color = (Rgbd){0.8, 0.3, 0.1};
    return material;
}

/** @return A scene of three or four balls and boxes of glass and mirror, which may overlap. */
static Scene *random_scene(uint64_t seed) {
    Error error = {0};
    Scene *scene = create_empty_scene();
    SceneLight light = *(const SceneLight *)scene_light_keyword.defaults;
    light.position = (Vec3d){3, 4, 5};
    light.intensity = 0.5 + 3 * random_unit(&seed);
    assert_true(scene_add_light(scene, &light, &error));
    scene->sky.horizon = scene->sky.zenith = (Rgbd){0.3, 0.4 * random_unit(&seed), 0.9};
    scene->ambient = (Rgbd){0.2, 0.2, 0.2};
    use_material(scene, mirror_material(0.1 * random_unit(&seed)));
    add_placed_plane(scene, here, (Vec3d){0, 0, -3}, (Vec3d){0, 0, 1});
    for (int i = 0; i < 4; i++) {
        Vec3d at = {2 * random_unit(&seed) - 1, 2 * random_unit(&seed) - 1,
                    2 * random_unit(&seed) - 1};
        bool is_mirror = random_unit(&seed) < 0.3;
        use_material(scene, is_mirror ? mirror_material(0.9 * random_unit(&seed))
                                      : glass_material(1 + random_unit(&seed)));
        double size = 0.3 + 0.5 * random_unit(&seed);
        if (random_unit(&seed) < 0.6) {
            add_placed_sphere(scene, here, at, size);
        } else {
            add_placed_box(scene, here, at, vec3d_add(at, (Vec3d){size, size, size}));
        }
    }
    set_camera(scene, here, (Vec3d){0.1, 0.2, 5}, (Vec3d){0, 0, -1});
    return scene;
}

/** @return The largest difference of two pictures, 8-bit steps of sRGB. */
static double worst_steps(const double *a, const double *b) {
    double worst = 0;
    for (int i = 0; i < VALUES; i++) {
        double steps = encoding_encode(ENCODING_SRGB, fmin(a[i], 1)) -
                       encoding_encode(ENCODING_SRGB, fmin(b[i], 1));
        worst = fmax(worst, fabs(steps));
    }
    return worst;
}

/** No pixel of a picture whose rays are all resolved lacks more than the cutoff. */
static void test_random_scenes(void **state) {
    (void)state;
    const Engine *engine = engine_find("f64x1", NULL);
    double worst = 0;
    int resolved = 0;
    for (uint64_t seed = 1; seed <= 60; seed++) {
        double usual[VALUES], finer[VALUES];
        Scene *scene = random_scene(seed);
        RayCounts counts =
            trace_picture(engine, scene, (TraceLimits){DEPTH_MAXIMUM, 0}, COLUMNS, ROWS, usual);
        trace_picture(engine, scene, (TraceLimits){DEPTH_MAXIMUM, CUTOFF_DEFAULT / 64}, COLUMNS,
                      ROWS, finer);
        if (counts.unresolved == 0) {
            worst = fmax(worst, worst_steps(usual, finer));
            resolved++;
        }
        scene_destroy(scene);
    }
    print_message("worst pixel of %d resolved scenes: %.3g steps\n", resolved, worst);
    assert_true(resolved >= 30);
    assert_true(worst > 0 && worst <= CUTOFF_DEFAULT);
}

/** All lanes decide alike, also in further passes. */
static void test_lanes(void **state) {
    (void)state;
    const char *const pairs[][2] = {{"f32x8", "f32x1"}, {"f64x4", "f64x1"}};
    for (int pair = 0; pair < 2; pair++) {
        Error error = {0};
        const Engine *wide = engine_find(pairs[pair][0], &error);
        const Engine *narrow = engine_find(pairs[pair][1], &error);
        for (uint64_t seed = 1; wide && narrow && seed <= 12; seed++) {
            double a[VALUES], b[VALUES];
            Scene *scene = random_scene(seed);
            TraceLimits limits = {DEPTH_MAXIMUM, 0};
            RayCounts one = trace_picture(wide, scene, limits, COLUMNS, ROWS, a);
            RayCounts other = trace_picture(narrow, scene, limits, COLUMNS, ROWS, b);
            assert_memory_equal(a, b, sizeof a);
            assert_true(one.reflection == other.reflection && one.refraction == other.refraction);
            assert_true(one.unresolved == other.unresolved);
            scene_destroy(scene);
        }
    }
}

/** A panel of 5000 is seen in a floor that mirrors a ten-thousandth: 0.5 of light. */
static void check_weak_mirror(const Engine *engine) {
    double rgb[3];
    Scene *scene = create_empty_scene();
    SceneMaterial floor = mirror_material(0.0001);
    floor.color = (Rgbd){0, 0, 0};
    use_material(scene, floor);
    add_placed_plane(scene, here, (Vec3d){0, 0, 0}, (Vec3d){0, 0, 1});
    use_material(scene, emissive_material((Rgbd){5000, 5000, 5000}));
    add_placed_quad(scene, here, (Vec3d){-99, -99, 9}, (Vec3d){198, 0, 0}, (Vec3d){0, 198, 0});
    set_camera(scene, here, (Vec3d){0, 0, 5}, (Vec3d){0, 0, -1});
    trace_picture(engine, scene, (TraceLimits){DEPTH_MAXIMUM, 0}, 1, 1, rgb);
    assert_at_most(fabs(rgb[0] - 0.5), 1e-4, "weak mirror in %s", engine->name);
    scene_destroy(scene);
}

/** @param state Not used. */
static void test_bright_lights(void **state) {
    (void)state;
    for_every_engine(check_weak_mirror);
}

/** A closed box of perfect mirrors ends, and is counted; a depth that is asked for is not. */
static void check_closed_mirrors(const Engine *engine) {
    double rgb[VALUES];
    Scene *scene = create_empty_scene();
    scene->sky.horizon = scene->sky.zenith = (Rgbd){1, 1, 1};
    use_material(scene, mirror_material(1));
    add_placed_box(scene, here, (Vec3d){-1, -1, -1}, (Vec3d){1, 1, 1});
    set_camera(scene, here, (Vec3d){0.1, 0.2, 0.3}, (Vec3d){0.3, 0.1, -1});
    RayCounts counts =
        trace_picture(engine, scene, (TraceLimits){DEPTH_MAXIMUM, 0}, COLUMNS, ROWS, rgb);
    assert_int_equal((int)counts.unresolved, COLUMNS * ROWS);
    assert_true(counts.unresolved_steps > 100);
    assert_int_equal((int)counts.reflection, COLUMNS * ROWS * DEPTH_MAXIMUM);
    counts = trace_picture(engine, scene, (TraceLimits){9, 0}, COLUMNS, ROWS, rgb);
    assert_true(counts.unresolved == 0 && counts.unresolved_steps == 0);
    assert_int_equal((int)counts.reflection, COLUMNS * ROWS * 9);
    scene_destroy(scene);
}

/** @param state Not used. */
static void test_guard(void **state) {
    (void)state;
    for_every_engine(check_closed_mirrors);
}

/** Ten balls that a later ball of air hides count no turn: the picture is that without them. */
static void check_hidden_surfaces(const Engine *engine) {
    double pictures[2][3];
    for (int hidden = 0; hidden < 2; hidden++) {
        Scene *scene = create_empty_scene();
        scene->sky.horizon = scene->sky.zenith = (Rgbd){1, 1, 1};
        for (int i = 0; i < (hidden ? 10 : 0); i++) {
            use_material(scene, glass_material(1.5));
            add_placed_sphere(scene, here, (Vec3d){0, 0, 0.8 - 0.16 * i}, 0.05);
        }
        use_material(scene, glass_material(1.3));
        add_placed_sphere(scene, here, (Vec3d){0, 0, 0}, 1);
        set_camera(scene, here, (Vec3d){0, 0, 3}, (Vec3d){0, 0, -1});
        RayCounts counts =
            trace_picture(engine, scene, (TraceLimits){2, 0}, 1, 1, pictures[hidden]);
        assert_true(counts.refraction >= (hidden ? 22 : 2));
        scene_destroy(scene);
    }
    assert_true(pictures[0][0] > 0.9);
    assert_at_most(fabs(pictures[0][0] - pictures[1][0]), 1e-5, "hidden balls in %s", engine->name);
}

/** @param state Not used. */
static void test_hidden_surfaces(void **state) {
    (void)state;
    for_every_engine(check_hidden_surfaces);
}

/** @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_scenes),   cmocka_unit_test(test_lanes),
        cmocka_unit_test(test_bright_lights),   cmocka_unit_test(test_guard),
        cmocka_unit_test(test_hidden_surfaces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
