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
    const Engine *engine = engine_with_role(ENGINE_DOUBLE);
    assert_non_null(engine);
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

/** Where a lamp is nearer than 1, a falloff brightens: a panel beside it is seen in a floor that
 *  mirrors a hundred-thousandth. */
static void check_near_lamp(const Engine *engine) {
    static const Falloff falloffs[] = {FALLOFF_INVERSE_LINEAR, FALLOFF_INVERSE_SQUARE};
    for (int i = 0; i < 2; i++) {
        double usual[3], finer[3];
        Error error = {0};
        Scene *scene = create_empty_scene();
        SceneMaterial floor = mirror_material(0.00001);
        floor.color = (Rgbd){0, 0, 0};
        floor.specular = 0;
        use_material(scene, floor);
        add_placed_plane(scene, here, (Vec3d){0, 0, 0}, (Vec3d){0, 0, 1});
        SceneMaterial panel = *(const SceneMaterial *)scene_material_keyword.defaults;
        panel.color = (Rgbd){1, 1, 1};
        use_material(scene, panel);
        add_placed_quad(scene, here, (Vec3d){-1, -1, 0.01}, (Vec3d){2, 0, 0}, (Vec3d){0, 2, 0});
        SceneLight lamp = *(const SceneLight *)scene_light_keyword.defaults;
        lamp.position = (Vec3d){0.0001, 0, 0.0098};
        lamp.falloff = falloffs[i];
        lamp.falloff_constant = 0;
        assert_true(scene_add_light(scene, &lamp, &error));
        set_camera(scene, here, (Vec3d){0, 0, 0.005}, (Vec3d){0, 0, -1});
        trace_picture(engine, scene, (TraceLimits){DEPTH_MAXIMUM, 0}, 1, 1, usual);
        trace_picture(engine, scene, (TraceLimits){DEPTH_MAXIMUM, 1e-9}, 1, 1, finer);
        assert_true(finer[0] > 0.01);
        assert_at_most(fabs(usual[0] - finer[0]), 0, "near lamp, falloff %d in %s", i,
                       engine->name);
        scene_destroy(scene);
    }
}

/** @param state Not used. */
static void test_bright_lights(void **state) {
    (void)state;
    for_every_engine(check_weak_mirror);
    for_every_engine(check_near_lamp);
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

/** How the rays of a picture are traced. */
typedef enum TraceWay {
    TRACE_WAVEFRONTS,  /**< As usual: many camera rays together. */
    TRACE_ONE_BY_ONE,  /**< Each camera ray for itself: packets with one live ray. */
    TRACE_RECURSIVELY, /**< Packet by packet, recursively, as where paths are recorded. */
    TRACE_WAY_COUNT
} TraceWay;

/** Traces a picture of #COLUMNS by #ROWS rays. @return The number of rays. */
static RayCounts trace_in_a_way(const Engine *engine, const Scene *scene, TraceLimits limits,
                                TraceWay way, double *rgb) {
    Error error = {0};
    uint64_t path_hashes[COLUMNS * ROWS];
    const TraceSettings settings = {
        .depth = limits.depth, .cutoff = limits.cutoff, .offset = OFFSET_BOUND};
    Tracer *tracer = engine->create_tracer(scene, &settings, &error);
    RayCounts counts = {0};
    assert_non_null(tracer);
    engine->set_view(tracer, scene, COLUMNS, ROWS);
    PixelGrid grid = {.columns = COLUMNS, .rows = ROWS, .stride = 1};
    grid.path_hashes = way == TRACE_RECURSIVELY ? path_hashes : NULL;
    if (way != TRACE_ONE_BY_ONE) {
        engine->trace(tracer, &grid, rgb, &counts);
    }
    for (uint16_t pixel = 0; way == TRACE_ONE_BY_ONE && pixel < COLUMNS * ROWS; pixel++) {
        double one[3];
        grid.selected = &pixel;
        grid.selected_count = 1;
        engine->trace(tracer, &grid, one, &counts);
        for (int channel = 0; channel < 3; channel++) {
            rgb[channel * COLUMNS * ROWS + pixel] = one[channel];
        }
    }
    engine->destroy(tracer);
    return counts;
}

/** The numbers of secondary rays in each way. */
typedef struct WayRays {
    uint64_t rays[TRACE_WAY_COUNT]; /**< Reflected and refracted rays, also of groups that found no
                                         room and were traced again. */
} WayRays;

/** Checks that a scene gives the same bits in all ways. */
static WayRays check_ways(const Engine *engine, const Scene *scene, TraceLimits limits) {
    double pictures[TRACE_WAY_COUNT][VALUES];
    WayRays result;
    uint64_t unresolved[TRACE_WAY_COUNT];
    for (TraceWay way = 0; way < TRACE_WAY_COUNT; way++) {
        RayCounts counts = trace_in_a_way(engine, scene, limits, way, pictures[way]);
        result.rays[way] = counts.reflection + counts.refraction;
        unresolved[way] = counts.unresolved;
        assert_memory_equal(pictures[way], pictures[0], sizeof pictures[0]);
        assert_true(unresolved[way] == unresolved[0]);
    }
    return result;
}

/** @return Balls that mirror a half and let the other half through, close together. */
static Scene *half_mirror_scene(void) {
    Scene *scene = create_empty_scene();
    SceneMaterial material = glass_material(1.5);
    material.transparency = material.reflectivity = (Rgbd){0.5, 0.5, 0.5};
    scene->sky.horizon = scene->sky.zenith = (Rgbd){0.8, 0.85, 0.9};
    use_material(scene, material);
    for (int i = 1; i <= 12; i++) {
        Vec3d at = {0.6 * sin(i * 2.1), 0.4 * cos(i * 1.3), 0.5 * sin(i * 0.9)};
        add_placed_sphere(scene, here, at, 0.4);
    }
    set_camera(scene, here, (Vec3d){0.1, 0.2, 4}, (Vec3d){0, 0, -1});
    return scene;
}

/** @return A ball in a perfectly mirroring ball that glows a little. @param material Of the ball
 *          inside. */
static Scene *ball_in_mirror_scene(SceneMaterial material) {
    Scene *scene = create_empty_scene();
    use_material(scene, material);
    add_placed_sphere(scene, here, (Vec3d){0, 0, 0}, 2);
    SceneMaterial mirror = mirror_material(1);
    mirror.emission = (Rgbd){0.01, 0.02, 0.03};
    use_material(scene, mirror);
    add_placed_sphere(scene, here, (Vec3d){0, 0, 0}, 4);
    set_camera(scene, here, (Vec3d){0.1, 0.2, 3}, (Vec3d){0, 0, -1});
    return scene;
}

/** Packets with one live ray give the bits of full ones, and wavefronts those of the recursion;
 * also where rays are too many for the memory of a wavefront, and a group of camera rays is
 * divided. */
static void check_wavefronts(const Engine *engine) {
    uint64_t kept = 0;
    if (engine->mantissa_bits > 64) {
        return;
    }
    for (uint64_t seed = 1; seed <= 6; seed++) {
        Scene *scene = random_scene(seed);
        WayRays ways = check_ways(engine, scene, (TraceLimits){DEPTH_MAXIMUM, CUTOFF_DEFAULT});
        // Each of these camera rays finds room; what its first pass kept is not traced again.
        assert_true(ways.rays[TRACE_ONE_BY_ONE] <= ways.rays[TRACE_RECURSIVELY]);
        kept += ways.rays[TRACE_RECURSIVELY] - ways.rays[TRACE_ONE_BY_ONE];
        scene_destroy(scene);
    }
    assert_true(kept > 0);
    Scene *scene = half_mirror_scene();
    WayRays ways = check_ways(engine, scene, (TraceLimits){DEPTH_MAXIMUM, CUTOFF_DEFAULT / 20});
    // A group that found no room is divided, and its rays are traced again.
    assert_true(ways.rays[TRACE_WAVEFRONTS] > ways.rays[TRACE_ONE_BY_ONE]);
    scene_destroy(scene);
}

/** @param state Not used. */
static void test_wavefronts(void **state) {
    (void)state;
    for_every_engine(check_wavefronts);
}

/** Traces the camera ray of a picture of one pixel recursively. @return The number of rays. */
static RayCounts trace_recursively(const Engine *engine, const Scene *scene, TraceLimits limits,
                                   double *rgb) {
    Error error = {0};
    uint64_t path_hash;
    const TraceSettings settings = {
        .depth = limits.depth, .cutoff = limits.cutoff, .offset = OFFSET_BOUND};
    Tracer *tracer = engine->create_tracer(scene, &settings, &error);
    assert_non_null(tracer);
    PixelGrid grid = {.columns = 1, .rows = 1, .stride = 1, .path_hashes = &path_hash};
    RayCounts counts = {0};
    engine->set_view(tracer, scene, 1, 1);
    engine->trace(tracer, &grid, rgb, &counts);
    engine->destroy(tracer);
    return counts;
}

/** One camera ray with more rays than a wavefront has room for is traced recursively. */
static void test_ray_without_room(void **state) {
    (void)state;
    const Engine *engine = engine_with_role(ENGINE_FASTEST), *scalar = engine_scalar(engine);
    SceneMaterial half = glass_material(1.5);
    half.transparency = half.reflectivity = (Rgbd){0.5, 0.5, 0.5};
    Scene *scene = ball_in_mirror_scene(half);
    const TraceLimits limits = {22, CUTOFF_DEFAULT / 1000};
    double wide[3], narrow[3], alone[3];
    RayCounts counts = trace_picture(engine, scene, limits, 1, 1, wide);
    assert_true(wide[0] > 0.02);
    trace_picture(scalar, scene, limits, 1, 1, narrow);
    assert_memory_equal(wide, narrow, sizeof wide);
    // The rays of the wavefront that found no room are counted, too.
    RayCounts recursive = trace_recursively(engine, scene, limits, alone);
    assert_memory_equal(wide, alone, sizeof wide);
    assert_true(counts.reflection + counts.refraction >
                recursive.reflection + recursive.refraction);
    scene_destroy(scene);
}

/**
 * A ball that lets red light through and mirrors all other light, in a mirror: each ray has light
 * of some channel, but red and the others part once and for all. The product of the largest weights
 * would be 1 on every path, and the number of paths would double at each turn.
 */
static void test_parted_colors(void **state) {
    (void)state;
    const Engine *engine = engine_with_role(ENGINE_FASTEST);
    SceneMaterial material = glass_material(1.5);
    material.transparency = (Rgbd){1, 0, 0};
    material.reflectivity = (Rgbd){0, 1, 1};
    Scene *scene = ball_in_mirror_scene(material);
    double rgb[3], alone[3];
    RayCounts counts = trace_picture(engine, scene, (TraceLimits){24, CUTOFF_DEFAULT}, 1, 1, rgb);
    print_message("rays of colours that part: %d\n", (int)(counts.reflection + counts.refraction));
    // The passes and the merged rays, whose number is bounded: not some 2^24.
    assert_true(counts.reflection + counts.refraction < 6 * RAYS_PER_SAMPLE_MAXIMUM);
    trace_recursively(engine, scene, (TraceLimits){24, CUTOFF_DEFAULT}, alone);
    assert_memory_equal(rgb, alone, sizeof rgb);
    scene_destroy(scene);
}

/** @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_scenes),    cmocka_unit_test(test_lanes),
        cmocka_unit_test(test_bright_lights),    cmocka_unit_test(test_guard),
        cmocka_unit_test(test_hidden_surfaces),  cmocka_unit_test(test_wavefronts),
        cmocka_unit_test(test_ray_without_room), cmocka_unit_test(test_parted_colors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
