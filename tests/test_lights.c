/**
 * @file
 * @brief Tests of point lights, suns, spherical lights, soft shadows, and the distribution of
 *        samples.
 */
#include "light_samples.h"

#include "trace/math/sobol.h"

/**
 * @return A white point light without attenuation.
 * @param radius 0, or that of a spherical light.
 */
static SceneLight white_point_light(Vec3d position, double radius) {
    return (SceneLight){.color = {1, 1, 1}, .intensity = 1, .position = position, .radius = radius};
}

/** @return Half an ulp of an engine's results, which are at most doubles. */
static double answer_roundoff(const Engine *engine) {
    return engine->mantissa_bits == 24 ? 0x1p-24 : 0x1p-53;
}

/* --- irradiance ------------------------------------------------------------------------------- */

/**
 * A point light straight above a surface, at 1e-6 to 1e6, gives 1 / d^2 to 8 half ulps. A spherical
 * light never gives more than at its surface.
 */
static void check_irradiance(const Engine *engine) {
    for (double away = 1e-6; away < 2e6; away *= 10) {
        double rgb[3], d = round_to_float(away);
        for (int sphere_index = 0; sphere_index < 2; sphere_index++) {
            double r = sphere_index ? round_to_float(3 * d) : 0, nearest = sphere_index ? r : d;
            Scene *scene = create_empty_scene();
            add_shape(scene, "plane", &(PlaneParameters){{0, 0, -d}, {0, 0, 1}});
            scene->camera.position = (Vec3d){0, 0, d};
            SceneLight light = white_point_light((Vec3d){0, 0, 0}, r);
            light.falloff = FALLOFF_INVERSE_SQUARE;
            add_light(scene, light);
            trace_pixel(engine, scene, rgb);
            double truth = 1 / (nearest * nearest);
            assert_at_most(fabs(rgb[0] / truth - 1), 8 * answer_roundoff(engine),
                           "%g away, ball %d, in %s", d, sphere_index, engine->name);
            scene_destroy(scene);
        }
    }
}

/** See #check_irradiance. */
static void test_irradiance(void **state) {
    (void)state;
    for_every_engine(check_irradiance);
}

/**
 * A light of intensity 5 at the distance d gives 5 cos / (c + d), the lamps of report D where c is
 * 2: from next to the surface to far away, and slanting.
 */
static void check_inverse_linear(const Engine *engine) {
    for (double away = 1e-6; away < 2e6; away *= 10) {
        for (int i = 0; i < 4; i++) {
            double rgb[3], d = round_to_float(away), c = (double[]){2, 0.25, 0, 1e3}[i];
            double slope = i % 2 ? 0.75 : 0; // The triangle 3, 4, 5: the cosine is 0.8.
            Scene *scene = create_empty_scene();
            add_shape(scene, "plane", &(PlaneParameters){{0, 0, -d}, {0, 0, 1}});
            scene->camera.position = (Vec3d){0, 0, d};
            SceneLight light = white_point_light((Vec3d){slope * d, 0, 0}, 0);
            light.intensity = 5;
            light.falloff = FALLOFF_INVERSE_LINEAR;
            light.falloff_constant = c;
            add_light(scene, light);
            trace_pixel(engine, scene, rgb);
            double distance = d * sqrt(1 + slope * slope),
                   truth = 5 * d / distance / (c + distance);
            assert_at_most(fabs(rgb[0] / truth - 1), 8 * answer_roundoff(engine),
                           "%g away, constant %g, in %s", d, c, engine->name);
            scene_destroy(scene);
        }
    }
}

/** See #check_inverse_linear. */
static void test_inverse_linear(void **state) {
    (void)state;
    for_every_engine(check_inverse_linear);
}

/** At the least distance and the greatest intensity, no light is infinite or NaN. */
static void check_finite_light(const Engine *engine) {
    static const double heights[] = {0, 1e-300, 1e-40, 1e-30, 1e-20, 1e-15, 1e-12, 1e-6, 1};
    for (size_t i = 0; i < sizeof heights / sizeof *heights; i++) {
        for (int strong = 0; strong < 4; strong++) {
            double rgb[3];
            Scene *scene = create_empty_scene();
            SceneLight light = white_point_light((Vec3d){0, 0, heights[i] - 4}, 0);
            light.falloff = strong / 2 ? FALLOFF_INVERSE_LINEAR : FALLOFF_INVERSE_SQUARE;
            light.color = (Rgbd){strong % 2 ? INTENSITY_MAXIMUM : 1, 0, 1};
            light.intensity = strong % 2 ? INTENSITY_MAXIMUM : 1;
            add_shape(scene, "plane", &(PlaneParameters){{0, 0, -4}, {0, 0, 1}});
            scene->materials[0].specular = 1;
            add_light(scene, light);
            trace_pixel(engine, scene, rgb);
            for (int c = 0; c < 3; c++) {
                assert_at_most(fabs(rgb[c]), 1e31, "%g above in %s", heights[i], engine->name);
            }
            scene_destroy(scene);
        }
    }
}

/** See #check_finite_light. */
static void test_finite(void **state) {
    (void)state;
    for_every_engine(check_finite_light);
}

/* --- suns ---------------------------------------------------------------------------------------
 */

/**
 * A sun lights by the cosine alone, at any distance of the floor. A sphere above casts a shadow
 * along its direction.
 */
static void check_sun(const Engine *engine) {
    for (double away = 1; away <= 1e6; away *= 1000) {
        for (int shadow = 0; shadow < 2; shadow++) {
            double rgb[3];
            Scene *scene = create_empty_scene();
            aim_camera(scene, (Vec3d){2 * away, away, 0}, (Vec3d){0, 0, 0});
            SceneLight sun = light_of_kind("sun");
            sun.color = (Rgbd){1, 0.5, 0.25};
            sun.intensity = 2;
            sun.direction = (Vec3d){-3e-3, -4e-3, 0};
            add_light(scene, sun);
            add_shape(scene, "plane", &(PlaneParameters){{0, 0, 0}, {0, 1, 0}});
            // Towards the sun, or as far in the opposite direction.
            double side = shadow ? 1 : -1;
            SphereParameters sphere = {{side * 3 * away, 4 * away, 0}, 0.5 * away};
            add_shape(scene, "sphere", &sphere);
            trace_pixel(engine, scene, rgb);
            for (int c = 0; c < 3; c++) {
                double truth = shadow ? 0 : 2 * ldexp(0.8, -c);
                assert_at_most(fabs(rgb[c] - truth), 16 * answer_roundoff(engine),
                               "sun over %g, shadow %d, in %s", away, shadow, engine->name);
            }
            scene_destroy(scene);
        }
    }
}

/** See #check_sun. */
static void test_sun(void **state) {
    (void)state;
    for_every_engine(check_sun);
}

/** The movement keys rotate a sun like a nearby light; its direction is never zero. */
static void test_sun_turns(void **state) {
    (void)state;
    SceneLight sun = light_of_kind("sun");
    sun.direction = (Vec3d){0, -2, 0};
    scene_light_move(&sun, (Vec3d){5, 0, 0}, 5);
    assert_at_most(fabs(sun.direction.x + sqrt(0.5)) + fabs(sun.direction.y + sqrt(0.5)), 1e-15,
                   "a sun moved to the right shines to the left");
    scene_light_move(&sun, vec3d_scale(sun.direction, 5), 5);
    assert_true(vec3d_length(sun.direction) > 0.99);
    SceneLight light = white_point_light((Vec3d){1, 2, 3}, 0);
    scene_light_move(&light, (Vec3d){1, 1, 1}, 5);
    assert_true(light.position.x == 2 && light.position.y == 3 && light.position.z == 4);
}

/* --- spherical lights ------------------------------------------------------------------------- */

/**
 * A spherical light is visible in its colour, directly and in a mirror. It casts no shadow of its
 * own or another light. A shape in front of it occludes it.
 */
static void check_visible_sphere_light(const Engine *engine) {
    double rgb[3];
    Scene *scene = create_empty_scene();
    SceneLight sphere_light = white_point_light((Vec3d){0, 0, -3}, 0.5);
    sphere_light.color = (Rgbd){0.25, 0.5, 4};
    add_light(scene, sphere_light);
    trace_pixel(engine, scene, rgb);
    assert_true(rgb[0] == 0.25 && rgb[1] == 0.5 && rgb[2] == 4);

    // A wall behind it, lit by a light at the camera; camera and light look past the sphere.
    aim_camera(scene, (Vec3d){0, 2, 0}, (Vec3d){0, 0, -6});
    add_shape(scene, "plane", &(PlaneParameters){{0, 0, -6}, {0, 0, 1}});
    scene->lights[0].color = (Rgbd){0, 0, 0};
    add_light(scene, white_point_light((Vec3d){0, 0, 0}, 0));
    trace_pixel(engine, scene, rgb);
    assert_at_most(fabs(rgb[0] - 1), 8 * answer_roundoff(engine), "another's light in %s",
                   engine->name);
    scene->lights[1].intensity = 0;
    scene->lights[0].color = (Rgbd){1, 1, 1};
    trace_pixel(engine, scene, rgb);
    assert_at_most(fabs(rgb[0] - 1), 8 * answer_roundoff(engine), "its own light in %s",
                   engine->name);

    // The wall becomes a mirror, in which the camera at the origin sees the back of the sphere.
    scene->materials[0].reflectivity = (Rgbd){0.5, 0.5, 0.5};
    scene->materials[0].color = (Rgbd){0, 0, 0};
    aim_camera(scene, (Vec3d){0, 3, -3}, (Vec3d){0, 1.5, -6});
    trace_pixel(engine, scene, rgb);
    assert_at_most(fabs(rgb[0] - 0.5), 8 * answer_roundoff(engine), "mirrored in %s", engine->name);
    aim_camera(scene, (Vec3d){0, 0, -12}, (Vec3d){0, 0, -3});
    trace_pixel(engine, scene, rgb);
    assert_at_most(rgb[0], 0, "hidden behind the mirror in %s", engine->name);
    scene_destroy(scene);
}

/** See #check_visible_sphere_light. */
static void test_sphere_light(void **state) {
    (void)state;
    for_every_engine(check_visible_sphere_light);
}

/** #Engine.set_view is sufficient to move a spherical light; near ones occlude far ones. */
static void check_moved_sphere_light(const Engine *engine) {
    double rgb[3];
    RayCounts counts = {0};
    PixelGrid grid = {.columns = 1, .rows = 1, .stride = 1};
    Scene *scene = create_empty_scene();
    for (int i = 0; i < 2; i++) {
        add_light(scene, white_point_light((Vec3d){0, 0, i ? -9 : -5}, 1));
        scene->lights[i].intensity = 1 + i;
    }
    Tracer *tracer = create_tracer(engine, scene);
    for (int step = 0; step < 2; step++) {
        engine->set_view(tracer, scene, 1, 1);
        engine->trace(tracer, &grid, rgb, &counts);
        assert_true(rgb[0] == 1 + step);
        scene_light_move(&scene->lights[0], (Vec3d){3, 0, 0}, 1);
    }
    engine->destroy(tracer);
    scene_destroy(scene);
}

/** A tracer that was created without lights, as the unlit mode of the window creates it, shows none
 *  of the lights of the scene that it is given later. */
static void check_lights_left_out(const Engine *engine) {
    double rgb[3];
    RayCounts counts = {0};
    PixelGrid grid = {.columns = 1, .rows = 1, .stride = 1};
    Scene *scene = create_empty_scene();
    add_light(scene, white_point_light((Vec3d){0, 0, -5}, 1));
    Scene unlit = *scene;
    unlit.light_count = 0;
    Tracer *tracer = create_tracer(engine, &unlit);
    engine->set_view(tracer, scene, 1, 1);
    engine->trace(tracer, &grid, rgb, &counts);
    assert_true(rgb[0] == 0);
    engine->destroy(tracer);
    scene_destroy(scene);
}

/** See #check_lights_left_out. */
static void test_lights_left_out(void **state) {
    (void)state;
    for_every_engine(check_lights_left_out);
}

/** See #check_moved_sphere_light. */
static void test_moved_sphere_light(void **state) {
    (void)state;
    for_every_engine(check_moved_sphere_light);
}

/* --- soft shadows -------------------------------------------------------------------------------
 */

/**
 * @return The fraction of a spherical light that is visible past an edge. The light is straight
 *         above the point; its irradiance is the area of its projection onto the unit circle
 *         (Nusselt), a circle of radius s. The plane through point and edge cuts that along an
 *         ellipse.
 * @param sine   s: the sine of half the angle that the sphere subtends.
 * @param slant  The sine of the edge's angle from the vertical.
 */
static double visible_light_fraction(double sine, double slant) {
    double area = 0;
    const int steps = 20000;
    for (int i = 0; i < steps; i++) {
        double y = sine * (2 * (i + 0.5) / steps - 1);
        double rim = sqrt(sine * sine - y * y), edge = slant * sqrt(1 - y * y);
        area += fmax(0, rim - fmax(edge, -rim)) * 2 * sine / steps;
    }
    return area / (M_PI * sine * sine);
}

/**
 * The penumbra of an edge: the visible fraction equals the closed form. The error of the mean of n
 * samples decreases with n.
 */
static void check_penumbra(const Engine *engine) {
    const double radius = 0.5, height = 2;
    bool is_slow = engine->mantissa_bits > 64;
    for (double edge = -0.25; edge <= 0.25; edge += 0.0625) {
        Scene *scene = create_empty_scene();
        aim_camera(scene, (Vec3d){3, 0.5, 0}, (Vec3d){0, 0, 0});
        add_light(scene, white_point_light((Vec3d){0, height, 0}, radius));
        add_shape(scene, "plane", &(PlaneParameters){{0, 0, 0}, {0, 1, 0}});
        add_shape(scene, "quad", &(QuadParameters){{-50, 1, -50}, {50 + edge, 0, 0}, {0, 0, 100}});
        double truth = visible_light_fraction(radius / height, edge / sqrt(1 + edge * edge));
        double bounds[] = {0.13, 0.05, 0.022};
        for (int k = 0; k < (is_slow ? 1 : 3); k++) {
            LightStatistics spread = sample_soft_light(engine, scene, 4 << 2 * k, truth);
            assert_at_most(spread.rms, bounds[k], "edge at %g, %d samples in %s", edge, 4 << 2 * k,
                           engine->name);
            assert_at_most(fabs(spread.mean - truth), bounds[k] / 4, "mean, edge at %g in %s", edge,
                           engine->name);
        }
        scene_destroy(scene);
    }
}

/** See #check_penumbra. */
static void test_penumbra(void **state) {
    (void)state;
    for_every_engine(check_penumbra);
}

/**
 * Without occluders, a spherical light gives the irradiance of its centre, for any radius and any
 * slant of the surface, while all of it is above the surface.
 */
static void check_sphere_light_irradiance(const Engine *engine) {
    bool is_slow = engine->mantissa_bits > 64;
    for (int i = 0; i < (is_slow ? 2 : 12); i++) {
        double radius = 0.1 + 0.2 * (i % 4), slant = 0.25 * (i % 3);
        Scene *scene = create_empty_scene();
        aim_camera(scene, (Vec3d){3, 0.5, 0}, (Vec3d){0, 0, 0});
        SceneLight light = white_point_light((Vec3d){2 * sin(slant), 2 * cos(slant), 0}, radius);
        // At the distance 2 from the centre: 1, 1/4 and 1/(2 + 2).
        light.falloff = i < 4   ? FALLOFF_NONE
                        : i < 8 ? FALLOFF_INVERSE_SQUARE
                                : FALLOFF_INVERSE_LINEAR;
        light.falloff_constant = 2;
        add_light(scene, light);
        add_shape(scene, "plane", &(PlaneParameters){{0, 0, 0}, {0, 1, 0}});
        double truth = cos(slant) * (i < 4 ? 1 : 0.25);
        LightStatistics spread = sample_soft_light(engine, scene, 64, truth);
        assert_at_most(spread.rms, 0.002, "radius %g, slant %g in %s", radius, slant, engine->name);
        assert_at_most(fabs(spread.mean - truth), 2e-4, "mean, radius %g, slant %g in %s", radius,
                       slant, engine->name);
        scene_destroy(scene);
    }
}

/** See #check_sphere_light_irradiance. */
static void test_sphere_light_irradiance(void **state) {
    (void)state;
    for_every_engine(check_sphere_light_irradiance);
}

/**
 * A surface inside a spherical light gets finite light, with hard and with soft shadows, even at
 * the centre.
 */
static void check_inside_sphere_light(const Engine *engine) {
    for (int samples = 1; samples <= 4; samples += 3) {
        for (double height = 0; height < 0.5; height += 0.2) {
            Scene *scene = create_empty_scene();
            aim_camera(scene, (Vec3d){0.1, 0.1, 0}, (Vec3d){0, 0, 0});
            SceneLight light = white_point_light((Vec3d){0, height, 0}, 0.05);
            light.falloff = FALLOFF_INVERSE_SQUARE;
            add_light(scene, light);
            add_shape(scene, "plane", &(PlaneParameters){{0, 0, 0}, {0, 1, 0}});
            LightStatistics spread = sample_soft_light(engine, scene, samples, 0);
            assert_at_most(spread.rms, 401, "height %g in %s", height, engine->name);
            scene_destroy(scene);
        }
    }
}

/** See #check_inside_sphere_light. */
static void test_inside_sphere_light(void **state) {
    (void)state;
    for_every_engine(check_inside_sphere_light);
}

/* --- samples ------------------------------------------------------------------------------------
 */

/** Fails unless each of 2^k rectangles a x b contains one of 2^k points. */
static void assert_stratified(uint32_t first, int k, uint32_t seed) {
    static uint8_t seen[1 << 12];
    for (int across = 0; across <= k; across++) {
        memset(seen, 0, sizeof seen);
        for (uint32_t i = 0; i < 1u << k; i++) {
            SobolPoint point = sobol_point(first + i, seed);
            uint32_t column = (uint32_t)((uint64_t)point.x >> (32 - across));
            uint32_t row = (uint32_t)((uint64_t)point.y >> (32 - (k - across)));
            uint8_t *cell = &seen[column << (k - across) | row];
            assert_int_equal(*cell, 0);
            *cell = 1;
        }
    }
}

/** 2^k points from a multiple of 2^k on are stratified, for every scrambling. */
static void test_sequence(void **state) {
    (void)state;
    for (uint32_t seed = 0; seed < 20; seed++) {
        for (int k = 0; k <= 12; k++) {
            assert_stratified(0, k, hash_u32(seed));
            assert_stratified(5u << k, k, hash_u32(seed));
        }
    }
}

/** @return A small scene with soft visible lights, mirrors, a sun and edges; to be destroyed. */
static Scene *soft_light_scene(void) {
    Scene *scene = create_empty_scene();
    scene->camera.position = (Vec3d){0, 0, 4};
    scene->materials[0].reflectivity = (Rgbd){0.3, 0.3, 0.3};
    scene->materials[0].specular = 0.5;
    add_light(scene, white_point_light((Vec3d){-1.4, 1.2, 1}, 0.4));
    SceneLight second = white_point_light((Vec3d){1.2, 0.2, -1}, 0.2);
    second.falloff = FALLOFF_INVERSE_LINEAR;
    second.falloff_constant = 0.5;
    add_light(scene, second);
    SceneLight sun = light_of_kind("sun");
    sun.color = (Rgbd){0.3, 0.3, 0.2};
    sun.direction = (Vec3d){1, -1, -1};
    add_light(scene, sun);
    add_shape(scene, "plane", &(PlaneParameters){{0, -1, 0}, {0, 1, 0}});
    add_shape(scene, "sphere", &(SphereParameters){{0, -0.4, 0}, 0.6});
    add_shape(scene, "box", &(BoxParameters){{-1.5, -1, -1}, {-0.8, 0, -0.3}});
    return scene;
}

/**
 * Soft shadows and adaptive samples are bitwise equal for any number of lanes and threads, and in
 * the background.
 */
static void test_same_bits(void **state) {
    (void)state;
    Scene *scene = soft_light_scene();
    for (int bits = 32; bits <= 64; bits *= 2) {
        RenderSettings settings = small_settings(scene, bits == 32 ? "f32x1" : "f64x1", 1);
        settings.samples = 20;
        Picture narrow = draw_picture(scene, &settings);
        for (const Engine *const *engine = engine_list(); *engine; engine++) {
            bool is_other = ((*engine)->mantissa_bits == 24) == (bits == 32);
            if (engine_is_supported(*engine) && is_other && (*engine)->mantissa_bits < 64) {
                settings.engine = *engine;
                settings.threads = 3;
                assert_same_picture(&narrow, draw_picture(scene, &settings));
            }
        }
        Renderer *renderer = create_renderer(scene, &settings);
        int passes;
        assert_same_picture(&narrow, draw_in_background(renderer, scene, &passes));
        renderer_destroy(renderer);
        picture_deinit(&narrow);
    }
    scene_destroy(scene);
}

/** @return Number of camera rays of a picture. */
static uint64_t count_camera(const Scene *scene, const RenderSettings *settings, Picture *picture) {
    Error error = {0};
    assert_true(picture_init(picture, settings->width, settings->height, &error));
    Renderer *renderer = create_renderer(scene, settings);
    RenderStats report = renderer_render(renderer, NULL, picture);
    assert_true(report.is_finished && report.progress == 1);
    renderer_destroy(renderer);
    return report.rays.camera;
}

/** Comparison of adaptive sampling with all samples. */
typedef struct SampleSaving {
    int worst_step;  /**< Largest difference, 8-bit steps. */
    double fraction; /**< Fraction of the samples that were traced. */
} SampleSaving;

/** @return The comparison of adaptive sampling with all samples. */
static SampleSaving adaptive_against_full(const Scene *scene, int samples) {
    Picture full, judged;
    RenderSettings settings = small_settings(scene, "auto", 2);
    settings.samples = samples;
    uint64_t rays = count_camera(scene, &settings, &judged);
    settings.sampling = SAMPLING_FULL;
    uint64_t all = count_camera(scene, &settings, &full);
    assert_int_equal(all, (uint64_t)WIDTH * HEIGHT * (uint64_t)samples);
    PictureComparison comparison = picture_compare(&full, &judged, NULL);
    picture_deinit(&full);
    picture_deinit(&judged);
    return (SampleSaving){comparison.max_difference, (double)rays / (double)all};
}

/**
 * The adaptive picture of the box is within two steps of the full one, with half of the rays; up to
 * eight samples it equals the full one.
 */
static void test_adaptive(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/box.lua");
    SampleSaving few = adaptive_against_full(scene, 8), many = adaptive_against_full(scene, 64);
    assert_true(few.worst_step == 0 && few.fraction == 1);
    assert_at_most(many.worst_step, 2, "steps off in the box");
    assert_at_most(many.fraction, 0.5, "share of the samples in the box");
    scene_destroy(scene);
    scene = soft_light_scene();
    assert_at_most(adaptive_against_full(scene, 32).worst_step, 2, "steps off in the still life");
    scene_destroy(scene);
}

/** @return A white line over a black sky. @param fraction Its width in pixels. */
static Scene *thin_line_scene(double fraction) {
    Scene *scene = create_empty_scene();
    double pixel = 2 * tan(scene->camera.fov / 2 * (M_PI / 180)) / WIDTH;
    scene->materials[0].emission = (Rgbd){1, 1, 1};
    // Slanted, so that it crosses pixels at all positions.
    Vec3d along = {0.6, 0.08, 0}, across = {-0.08 / 0.6053, 0.6 / 0.6053, 0};
    QuadParameters line = {{-0.3, -0.05, -1}, along, vec3d_scale(across, fraction * pixel)};
    add_shape(scene, "quad", &line);
    return scene;
}

/**
 * For a picture in linear light, adaptive sampling compares linear light: an edge brighter than
 * white gets all samples, too.
 */
static void test_adaptive_beyond_white(void **state) {
    (void)state;
    Error error = {0};
    Scene *scene = thin_line_scene(20);
    scene->materials[0].emission = (Rgbd){9, 9, 9};
    scene->sky.horizon = scene->sky.zenith = (Rgbd){3, 3, 3};
    RenderSettings settings = small_settings(scene, "auto", 2);
    settings.samples = 64;
    Picture pictures[2] = {0};
    for (int i = 0; i < 2; i++) {
        settings.sampling = i == 0 ? SAMPLING_ADAPTIVE : SAMPLING_FULL;
        assert_true(picture_init(&pictures[i], settings.width, settings.height, &error));
        assert_true(picture_allocate_linear(&pictures[i], &error));
        Renderer *renderer = create_renderer(scene, &settings);
        uint64_t rays = renderer_render(renderer, NULL, &pictures[i]).rays.camera;
        assert_true(i == 1 || rays < (uint64_t)WIDTH * HEIGHT * 64 / 2);
        renderer_destroy(renderer);
    }
    double worst = 0;
    for (int i = 0; i < 3 * WIDTH * HEIGHT; i++) {
        double judged = (double)pictures[0].linear[i], full = (double)pictures[1].linear[i];
        worst = fmax(worst, fabs(judged / full - 1));
    }
    assert_at_most(worst, 0.02, "share of the light that is off");
    picture_deinit(&pictures[0]);
    picture_deinit(&pictures[1]);
    scene_destroy(scene);
}

/**
 * Lines as thin as an eleventh of a pixel appear along their whole length, although the first
 * samples of a pixel may miss them.
 */
static void test_thin_line(void **state) {
    (void)state;
    for (double fraction = 1; fraction > 1.0 / 12; fraction /= 1.5) {
        Scene *scene = thin_line_scene(fraction);
        SampleSaving saving = adaptive_against_full(scene, 64);
        print_message("line of %.3f pixels: %d steps off, %.3f of the samples\n", fraction,
                      saving.worst_step, saving.fraction);
        assert_at_most(saving.worst_step, 2, "steps off, line of %g pixels", fraction);
        assert_at_most(saving.fraction, 0.3, "share of the samples");
        scene_destroy(scene);
    }
}

/* --- acne ---------------------------------------------------------------------------------------
 */

/**
 * Single convex shapes, lit by a sun, a point light and a soft light, have no dark points: float
 * equals double; without an offset it does not.
 */
static void test_acne(void **state) {
    (void)state;
    Scene *scene = soft_light_scene();
    scene->shape_count = 0;
    scene->materials[0].reflectivity = (Rgbd){0, 0, 0};
    add_shape(scene, "sphere", &(SphereParameters){{0.3, 0.1, -40.7}, 13.3});
    RenderSettings settings = small_settings(scene, "f64x1", 2);
    settings.samples = 2;
    Picture truth = draw_picture(scene, &settings);
    int different[2];
    for (int i = 0; i < 2; i++) {
        settings.engine = engine_find("auto", NULL);
        settings.trace.offset = i ? OFFSET_NONE : OFFSET_BOUND;
        Picture picture = draw_picture(scene, &settings);
        different[i] = picture_compare(&truth, &picture, NULL).max_difference;
        picture_deinit(&picture);
    }
    assert_at_most(different[0], 1, "steps off with the bound");
    assert_true(different[1] > 20);
    picture_deinit(&truth);
    scene_destroy(scene);
}

/** Runs the tests. @return 0 if all pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_irradiance),
        cmocka_unit_test(test_inverse_linear),
        cmocka_unit_test(test_finite),
        cmocka_unit_test(test_sun),
        cmocka_unit_test(test_sun_turns),
        cmocka_unit_test(test_sphere_light),
        cmocka_unit_test(test_moved_sphere_light),
        cmocka_unit_test(test_lights_left_out),
        cmocka_unit_test(test_penumbra),
        cmocka_unit_test(test_sphere_light_irradiance),
        cmocka_unit_test(test_inside_sphere_light),
        cmocka_unit_test(test_sequence),
        cmocka_unit_test(test_same_bits),
        cmocka_unit_test(test_adaptive),
        cmocka_unit_test(test_adaptive_beyond_white),
        cmocka_unit_test(test_thin_line),
        cmocka_unit_test(test_acne),
    };
    return cmocka_run_group_tests_name("lights", tests, NULL, NULL);
}
