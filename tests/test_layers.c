/**
 * @file
 * @brief Tests of AOVs in every engine, and of the layers that show them.
 */
#include "fixtures.h"
#include "pictures.h"

#include "base/encoding.h"
#include "render/difference_map.h"
#include "render/palette.h"
#include "render/render_pass.h"

/** Size of the pictures that every engine traces. */
enum { AOV_WIDTH = 45, AOV_HEIGHT = 29 };

/** The AOVs and the light of such a picture. */
typedef struct AovImage {
    AovSample samples[AOV_WIDTH * AOV_HEIGHT]; /**< The AOVs of its pixels. */
    double rgb[3 * AOV_WIDTH * AOV_HEIGHT];    /**< Its light, as computed by #Engine.trace. */
    RayCounts counts;                          /**< The rays traced for the AOVs. */
    RayCounts ray_counts;                      /**< The rays traced for the light. */
} AovImage;

/** @return A picture traced with AOVs, to be freed. */
static AovImage *trace_aov_image(const Engine *engine, const Scene *scene, unsigned wanted) {
    AovImage *found = calloc(1, sizeof *found);
    PixelGrid grid = {.columns = AOV_WIDTH, .rows = AOV_HEIGHT, .stride = 1};
    Tracer *tracer = create_tracer(engine, scene);
    assert_non_null(found);
    engine->set_view(tracer, scene, AOV_WIDTH, AOV_HEIGHT);
    engine->trace_aovs(tracer, &grid, wanted, found->samples, &found->counts);
    engine->trace(tracer, &grid, found->rgb, &found->ray_counts);
    engine->destroy(tracer);
    return found;
}

/* --- AOVs ------------------------------------------------------------------------------------- */

/**
 * @return The direction of a pixel's ray from a camera at the origin that looks along -z; a unit
 *         vector.
 */
static Vec3d pixel_direction(const SceneCamera *camera, int i) {
    double half = tan(camera->fov / 2 * (M_PI / 180)) / AOV_WIDTH;
    double x = (2 * (i % AOV_WIDTH) + 1 - AOV_WIDTH) * half,
           y = (AOV_HEIGHT - 2 * (i / AOV_WIDTH) - 1) * half;
    return vec3d_scale((Vec3d){x, y, -1}, 1 / sqrt(x * x + y * y + 1));
}

/** Distance, normal and shape of a sphere and of the background equal their closed forms. */
static void check_sphere_aovs(const Engine *engine) {
    Scene *scene = create_empty_scene();
    const SphereParameters far = {{0, 0, -50}, 1}, near = {{0.3, -0.2, -4}, 1.5};
    add_shape(scene, "sphere", &far);
    add_shape(scene, "sphere", &near);
    AovImage *found = trace_aov_image(engine, scene, 0);
    double unit = (double)roundoff(engine) + 0x1p-52;
    int hits = 0;
    for (int i = 0; i < AOV_WIDTH * AOV_HEIGHT; i++) {
        const AovSample *point = &found->samples[i];
        Vec3d direction = pixel_direction(&scene->camera, i);
        double along = vec3d_dot(near.center, direction);
        double square =
            along * along - vec3d_dot(near.center, near.center) + near.radius * near.radius;
        if (fabs(square) < 1e-3) {
            continue;
        }
        assert_int_equal(point->shape, square > 0 ? 1 : -1);
        assert_true((square > 0) == isfinite(point->distance));
        if (square > 0) {
            double distance = along - sqrt(square);
            Vec3d normal = vec3d_scale(
                vec3d_subtract(vec3d_scale(direction, distance), near.center), 1 / near.radius);
            assert_at_most(fabs(point->distance - distance), 300 * unit / sqrt(square),
                           "%s distance", engine->name);
            assert_at_most(fabs(point->normal[0] - normal.x) + fabs(point->normal[1] - normal.y) +
                               fabs(point->normal[2] - normal.z),
                           600 * unit / sqrt(square), "%s normal", engine->name);
            hits++;
        }
    }
    assert_true(hits > 200 && hits < AOV_WIDTH * AOV_HEIGHT - 200);
    assert_int_equal((int)found->counts.camera, AOV_WIDTH * AOV_HEIGHT);
    free(found);
    scene_destroy(scene);
}

/** See #check_sphere_aovs. */
static void test_sphere_aovs(void **state) {
    (void)state;
    for_every_engine(check_sphere_aovs);
}

/** @return Whether an engine is the slow one, which other tests cover. */
static bool is_slow(const Engine *engine) {
    return engine->mantissa_bits > 64;
}

/** Light and total ray counts equal those of the picture. */
static void check_ray_counts(const Engine *engine) {
    static const char *const scenes[] = {"scenes/box.lua", "scenes/glass-sphere.lua",
                                         "scenes/lamps.lua"};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes && (i == 0 || !is_slow(engine)); i++) {
        Scene *scene = load_scene(scenes[i]);
        scene->image.depth = 5;
        AovImage *found = trace_aov_image(engine, scene, AOV_RADIANCE);
        uint64_t sum = 0;
        for (size_t k = 0; k < AOV_WIDTH * AOV_HEIGHT; k++) {
            sum += found->samples[k].ray_count;
            for (size_t c = 0; c < 3; c++) {
                assert_memory_equal(&found->samples[k].color[c],
                                    &found->rgb[c * AOV_WIDTH * AOV_HEIGHT + k], sizeof(double));
            }
        }
        assert_int_equal((int)sum, (int)ray_counts_sum(&found->ray_counts));
        assert_memory_equal(&found->counts, &found->ray_counts, sizeof found->counts);
        assert_true(sum > 2 * AOV_WIDTH * AOV_HEIGHT);
        free(found);
        scene_destroy(scene);
    }
}

/** See #check_ray_counts. */
static void test_rays(void **state) {
    (void)state;
    for_every_engine(check_ray_counts);
}

/** Shape and (u, v) equal the result of #Engine.intersect for the same ray. */
static void check_aov_uvs(const Engine *engine) {
    Scene *scene = create_empty_scene();
    const SphereParameters sphere = {{0, 0, -4}, 1};
    const QuadParameters wall = {{-9, -9, -8}, {18, 0, 0}, {0, 18, 0}};
    add_shape(scene, "sphere", &sphere);
    add_shape(scene, "quad", &wall);
    AovImage *found = trace_aov_image(engine, scene, AOV_UV);
    Tracer *tracer = create_tracer(engine, scene);
    for (int i = 0; i < AOV_WIDTH * AOV_HEIGHT; i++) {
        RayResult answer;
        Vec3d direction = pixel_direction(&scene->camera, i);
        RayQueryQuad query = ray_towards((Vec3d){0, 0, 0}, direction);
        engine->intersect(tracer, 1, &query, &answer);
        if (answer.shape == found->samples[i].shape) {
            assert_at_most(fabs((double)answer.uv[0] - found->samples[i].uv[0]), 1e-4, "u");
            assert_at_most(fabs((double)answer.uv[1] - found->samples[i].uv[1]), 1e-4, "v");
        }
    }
    engine->destroy(tracer);
    free(found);
    scene_destroy(scene);
}

/** See #check_aov_uvs. */
static void test_uvs(void **state) {
    (void)state;
    for_every_engine(check_aov_uvs);
}

/** Adds a point light. */
static void add_point_light(Scene *scene, Vec3d position) {
    Error error = {0};
    SceneLight light = {.color = {1, 1, 1}, .intensity = 1, .position = position};
    assert_true(scene_add_light(scene, &light, &error));
}

/**
 * One light lights a wall, a smaller wall hides another. The next surface of a mirror is recorded.
 */
static void check_lights_and_mirrors(const Engine *engine) {
    Scene *scene = create_empty_scene();
    const QuadParameters wall = {{-9, -9, -8}, {18, 0, 0}, {0, 18, 0}};
    const QuadParameters shade = {{-99, -99, 2}, {198, 0, 0}, {0, 198, 0}};
    scene->materials[0].reflectivity = (Rgbd){0.5, 0.5, 0.5};
    add_shape(scene, "quad", &wall);
    add_shape(scene, "quad", &shade);
    add_point_light(scene, (Vec3d){0, 0, -1});
    add_point_light(scene, (Vec3d){0, 0, 5});
    add_point_light(scene, (Vec3d){0, 0, -20});
    AovImage *found = trace_aov_image(engine, scene, AOV_RADIANCE);
    for (size_t i = 0; i < AOV_WIDTH * AOV_HEIGHT; i++) {
        const AovSample *point = &found->samples[i];
        assert_int_equal(point->shape, 0);
        assert_int_equal((int)point->lights_tested, 3);
        assert_int_equal((int)point->lights_occluded, 2);
        assert_int_equal((int)point->secondary_count, 1);
        assert_int_equal(point->secondary_shapes[0], 1);
    }
    free(found);
    scene_destroy(scene);
}

/** See #check_lights_and_mirrors. */
static void test_lights(void **state) {
    (void)state;
    for_every_engine(check_lights_and_mirrors);
}

/** Step counts are equal at every width, and positive only for sphere traced shapes. */
static void test_steps(void **state) {
    (void)state;
    static const char *const scenes[] = {"scenes/cube-frame.lua", "scenes/endless-frames.lua",
                                         "scenes/turned-frame.lua"};
    Error error = {0};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        Scene *scene = load_scene(scenes[i]);
        scene->image.depth = 2;
        AovImage *one = trace_aov_image(engine_find("f32x1", &error), scene, AOV_STEPS);
        AovImage *four =
            trace_aov_image(engine_find("f32x4", &error), scene, AOV_STEPS | AOV_RADIANCE);
        uint64_t sum = 0;
        for (size_t k = 0; k < AOV_WIDTH * AOV_HEIGHT; k++) {
            assert_int_equal(one->samples[k].step_count, four->samples[k].step_count);
            sum += one->samples[k].step_count;
        }
        assert_true(sum > AOV_WIDTH * AOV_HEIGHT);
        free(one);
        free(four);
        scene_destroy(scene);
    }
    Scene *box = load_scene("scenes/box.lua");
    AovImage *none = trace_aov_image(engine_find("f32x4", &error), box, AOV_STEPS);
    for (size_t k = 0; k < AOV_WIDTH * AOV_HEIGHT; k++) {
        assert_int_equal(none->samples[k].step_count, 0);
    }
    free(none);
    scene_destroy(box);
}

/** Bytes of a scene in #test_operations with the final zero. */
enum { FIELD_SCENE_SIZE = 1024 };

/** A field, and the bounds of its operations. */
typedef struct FieldCosts {
    const char *field;  /**< Its text. */
    double least, most; /**< Operations per step, over the whole picture. */
} FieldCosts;

/** Each ray counts what it would evaluate alone, at every width, but for octrees of functions,
 * which not all engines have. An operation is a solid, what joins two, a level of a sponge, an
 * iteration, a step of a function; what is skipped does not count. */
static void test_operations(void **state) {
    static const FieldCosts cases[] = {
        {"distance.sphere { radius = 1 }", 1, 1},
        {"distance.box {}:round(0.1)", 2, 2},
        // Three squares, two sums, the root, and one less; one for the function.
        {"distance.field(function(x, y, z) return math.sqrt(x * x + y * y + z * z) - 1 end)", 8, 8},
        {"distance.union(distance.sphere { radius = 0.3 }:translate{-0.7, 0, 0}, "
         "distance.sphere { radius = 0.3 }:translate{0.7, 0, 0})",
         3.01, 4.99},
        {"distance.menger { size = 2, iterations = 4 }", 1.01, 4.99},
        {"distance.mandelbulb { power = 8, iterations = 9 }", 1.01, 8.99},
        // Of 49 joined balls, each with its place, few can be near.
        {"(function() local balls = distance.sphere { radius = 0.1 } for i = 1, 48 do balls = "
         "distance.union(balls, distance.sphere { radius = 0.1 }:translate{0.03 * i, 0.02 * i, 0}) "
         "end return balls end)()",
         3, 30}};
    Error error = {0};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[FIELD_SCENE_SIZE];
        snprintf(text, sizeof text, "camera { position = {0.3, 0.4, 4} } sdf { %s }",
                 cases[i].field);
        const char *path = fixture_path(state, "field.lua");
        write_file(path, text, strlen(text));
        Scene *scene = load_scene(path);
        const unsigned both = AOV_STEPS | AOV_OPERATIONS;
        AovImage *one = trace_aov_image(engine_find("f32x1", &error), scene, both);
        AovImage *eight = trace_aov_image(engine_find("f32x8", &error), scene, both);
        double steps = 0, operations = 0;
        for (size_t k = 0; k < AOV_WIDTH * AOV_HEIGHT; k++) {
            assert_int_equal(one->samples[k].operation_count, eight->samples[k].operation_count);
            steps += one->samples[k].step_count;
            operations += (double)one->samples[k].operation_count;
        }
        assert_true(steps > 0);
        assert_true(operations >= cases[i].least * steps);
        assert_at_most(operations / steps, cases[i].most, "%s", cases[i].field);
        free(one);
        free(eight);
        scene_destroy(scene);
    }
}

/* --- layers ----------------------------------------------------------------------------------- */

/** Size of a picture, and a buffer for its pixels: blue, green, red and an unused byte each. */
typedef struct LayerImage {
    int width;     /**< Pixels. */
    int height;    /**< Pixels. */
    uint8_t *bgrx; /**< The buffer; NULL: the pixels are not needed. */
} LayerImage;

/** Waits until a renderer has nothing more to show. @return The state of the picture. */
static RenderStats wait_until_finished(Renderer *renderer) {
    RenderStats report = {0};
    const struct timespec pause = {.tv_nsec = 200000};
    while (!report.is_finished) {
        renderer_copy_latest(renderer, &report, NULL, 0);
        nanosleep(&pause, NULL);
    }
    return report;
}

/** Renders a layer completely. @return Its final statistics. */
static RenderStats draw_layer(Renderer *renderer, const Scene *scene, Layer layer,
                              LayerImage image) {
    Error error = {0};
    renderer_set_layer(renderer, layer);
    assert_true(renderer_start(renderer, scene, image.width, image.height, NULL, NULL, &error));
    RenderStats report = wait_until_finished(renderer);
    renderer_copy_latest(renderer, &report, image.bgrx, 4 * image.width);
    assert_int_equal(report.layer.layer, layer);
    assert_int_equal((int)report.layer.pixel_count, image.width * image.height);
    return report;
}

/** The scene with mirrors that most tests use. */
static const char BOX[] = "scenes/box.lua";

/**
 * @return Statistics of a finished layer.
 * @param offset  How rays leave surfaces.
 * @param epsilon  Constant offset, if that is fixed.
 */
static LayerStats finished_report(const char *path, const char *engine, OffsetStrategy offset,
                                  double epsilon, Layer layer, LayerImage image) {
    Scene *scene = load_scene(path);
    RenderSettings settings = small_settings(scene, engine, 2);
    settings.samples = 1;
    settings.trace.offset = offset;
    settings.trace.epsilon = epsilon;
    Renderer *renderer = create_renderer(scene, &settings);
    LayerStats report = draw_layer(renderer, scene, layer, image).layer;
    renderer_destroy(renderer);
    scene_destroy(scene);
    return report;
}

/**
 * Without an offset there is acne: in float at one in a hundred pixels of the box. Far too large an
 * offset causes leaks. An offset by the error bound causes neither.
 */
static void test_faults(void **state) {
    (void)state;
    const LayerImage large = {800, 600, NULL};
    const uint64_t pixels = 800 * 600;
    LayerStats none = finished_report(BOX, "f32x8", OFFSET_NONE, 0, LAYER_ACNE, large);
    assert_true(none.artifact_pixels > pixels / 100);
    LayerStats far = finished_report(BOX, "f32x8", OFFSET_FIXED, 0.3, LAYER_ACNE, large);
    assert_true(far.leak_pixels > pixels / 100);
    // In the last two, a float ray passes an edge on its other side: that is not an artefact.
    static const char *const scenes[] = {BOX, "scenes/report-d-shapes.lua", "scenes/lamps.lua"};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        LayerStats bound = finished_report(scenes[i], "f32x8", OFFSET_BOUND, 0, LAYER_ACNE, large);
        assert_int_equal((int)bound.artifact_pixels, 0);
        assert_int_equal((int)bound.leak_pixels, 0);
    }
}

/** Errors relative to quad: a few pixels at edges in float, many with acne. */
static void test_errors(void **state) {
    (void)state;
    const LayerImage small = {WIDTH, HEIGHT, NULL};
    assert_true(finished_report(BOX, "f32x8", OFFSET_BOUND, 0, LAYER_ERROR, small).artifact_pixels <
                5);
    uint64_t none =
        finished_report(BOX, "f32x8", OFFSET_NONE, 0, LAYER_ERROR, small).artifact_pixels;
    assert_true(none > WIDTH * HEIGHT / 100);
}

/**
 * Every layer finishes in its colours, in any order. A picture rendered afterwards is unchanged.
 */
static void test_layers(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/glass-sphere.lua");
    scene->image.samples = 4;
    RenderSettings settings = small_settings(scene, "f32x4", 2);
    Picture before = draw_picture(scene, &settings);
    Renderer *renderer = create_renderer(scene, &settings);
    Tracer *tracer = settings.engine->create_tracer(scene, &settings.trace, &(Error){0});
    settings.engine->set_view(tracer, scene, WIDTH, HEIGHT);
    for (Layer layer = LAYER_NORMALS; layer < LAYER_COUNT; layer++) {
        uint8_t *bgrx = calloc(4, (size_t)WIDTH * HEIGHT);
        LayerImage image = {WIDTH, HEIGHT, bgrx};
        LayerScale scale = draw_layer(renderer, scene, layer, image).layer.scale;
        const bool is_from_aovs = layer < LAYER_TIME || layer == LAYER_OPERATIONS;
        for (size_t i = 0; i < WIDTH * HEIGHT && is_from_aovs; i += 97) {
            PixelGrid grid = {.x = (int)(i % WIDTH), .y = (int)(i / WIDTH), 1, 1, 1};
            AovSample point;
            float numbers[LAYER_VALUES] = {0};
            uint8_t rgb[3];
            settings.engine->trace_aovs(tracer, &grid,
                                        AOV_RADIANCE | AOV_STEPS | AOV_UV | AOV_OPERATIONS, &point,
                                        &(RayCounts){0});
            layer_values(layer, &point, numbers);
            layer_color(layer, &scale, numbers, rgb);
            for (size_t c = 0; c < 3; c++) {
                assert_int_equal(bgrx[4 * i + 2 - c], rgb[c]);
            }
        }
        free(bgrx);
    }
    settings.engine->destroy(tracer);
    int passes = 0;
    renderer_set_layer(renderer, LAYER_SHADED);
    assert_same_picture(&before, draw_in_background(renderer, scene, &passes));
    picture_deinit(&before);
    renderer_destroy(renderer);
    scene_destroy(scene);
}

/** @return The lightness of a colour, 0 to 255. */
static double lightness(const uint8_t rgb[3]) {
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

/**
 * Lightness increases with the number, so that scales are readable without hues. Scales contain all
 * numbers, have round ends, and legends descend from one end to the other.
 */
static void test_legends(void **state) {
    (void)state;
    static const double ends[][2] = {{0, 0},         {1, 1},     {4.37, 9.01}, {1, 40},
                                     {0.003, 700},   {2.2, 1e7}, {1e-9, 1e9},  {0, 12},
                                     {1e6, 1e6 + 3}, {7, 6}};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        LegendEntry ticks[LEGEND_ENTRIES_MAXIMUM];
        LayerScale scale = layer_scale(LAYER_RAYS, ends[i][0], ends[i][1]);
        size_t count = layer_legend(LAYER_RAYS, &scale, ticks);
        if (ends[i][1] < ends[i][0]) {
            assert_int_equal((int)count, 0);
            continue;
        }
        assert_true(scale.low <= ends[i][0] && ends[i][1] <= scale.high);
        assert_true(scale.low < scale.high);
        assert_true(count >= 3 && count <= LEGEND_ENTRIES_MAXIMUM);
        assert_at_most(fabs(strtod(ticks[0].number, NULL) / scale.high - 1), 1e-5, "first %zu", i);
        for (size_t k = 1; k < count; k++) {
            assert_true(strtod(ticks[k].number, NULL) < strtod(ticks[k - 1].number, NULL));
            assert_true(lightness(ticks[k].rgb) < lightness(ticks[k - 1].rgb));
        }
    }
    for (Layer layer = LAYER_NORMALS; layer < LAYER_COUNT; layer++) {
        LegendEntry ticks[LEGEND_ENTRIES_MAXIMUM];
        LayerScale scale = layer_scale(layer, 0.5, 80);
        size_t count = layer_legend(layer, &scale, ticks);
        assert_true(count >= 2 && count <= LEGEND_ENTRIES_MAXIMUM);
        assert_true(layer_name(layer)[0] != '\0');
    }
}

/**
 * A difference is white where there is none, red where the first is brighter, blue where the second
 * is. One step is tolerated, two are not.
 */
static void test_difference(void **state) {
    (void)state;
    uint8_t a[] = {9, 9, 9, 0, 9, 8, 9, 0, 9, 9, 19, 0, 0, 0, 0, 0};
    const uint8_t b[] = {9, 9, 9, 0, 9, 9, 9, 0, 9, 9, 9, 0, 255, 0, 1, 0};
    DifferenceMap difference = difference_map_draw(a, b, 4, a);
    assert_true(difference.max_difference == 255);
    assert_int_equal((int)difference.differing_pixels, 2);
    assert_true(a[0] == a[1] && a[1] == a[2] && a[0] > 240);
    assert_true(a[4] > a[6] && a[10] > a[8] && a[12] > a[14]);
    LegendEntry ticks[LEGEND_ENTRIES_MAXIMUM];
    size_t count = difference_map_legend(&difference, ticks);
    assert_true(count > 4 && count <= LEGEND_ENTRIES_MAXIMUM);
    assert_string_equal(ticks[count / 2].number, "0");
}

/**
 * Two pictures of a layer differ in its numbers, with their unit: signed, white where they are
 * equal, grey where one has none. What has no number in both is equal.
 */
static void test_value_difference(void **state) {
    (void)state;
    const float missing = NAN;
    const float a[][LAYER_VALUES] = {{5}, {3}, {7}, {missing}, {missing}};
    const float b[][LAYER_VALUES] = {{5}, {5.5F}, {6}, {1}, {missing}};
    uint8_t bgrx[4 * 5];
    DifferenceMap map = difference_map_draw_values(LAYER_DISTANCE, a[0], b[0], 5, bgrx);
    assert_true(map.max_difference == 2.5 && map.scale.high >= 2.5 && map.scale.high <= 5);
    assert_int_equal((int)map.differing_pixels, 2);
    assert_int_equal((int)map.unknown_pixels, 1);
    assert_true(bgrx[0] == bgrx[1] && bgrx[1] == bgrx[2] && bgrx[0] > 240); // White.
    assert_true(bgrx[4] > bgrx[6] + 40);                                    // Blue: less.
    assert_true(bgrx[10] > bgrx[8] + 40);                                   // Red: more.
    assert_true(bgrx[12] < 100 && bgrx[14] < 100);                          // Grey: only one.
    assert_memory_equal(bgrx, bgrx + 16, 3);
    LegendEntry ticks[LEGEND_ENTRIES_MAXIMUM];
    size_t count = difference_map_legend(&map, ticks);
    assert_string_equal(ticks[0].number, "+5");
    assert_true(ticks[0].position == 1 && ticks[count - 1].position < 0);
    const float x[LAYER_VALUES] = {1, 0, 0}, y[LAYER_VALUES] = {0, -2, 0};
    assert_at_most(fabs(layer_difference(LAYER_NORMALS, x, y) - 90), 1e-12, "angle");
    assert_string_equal(layer_difference_unit(LAYER_NORMALS), "degrees");
    // An error of double is seen beside one of float.
    const float errors[2][LAYER_VALUES] = {{1e-5F}, {1e-14F}};
    map = difference_map_draw_values(LAYER_ERROR, errors[0], errors[1], 1, bgrx);
    assert_true(bgrx[2] > bgrx[0] + 40);
    map = difference_map_draw_none(1, bgrx);
    assert_int_equal((int)difference_map_legend(&map, ticks), 0);
}

/** Pictures in float and in double have errors of other colours, both on the scale. */
static void test_error_scale(void **state) {
    (void)state;
    LayerScale scale = layer_scale(LAYER_ERROR, 0, 1);
    assert_true(scale.low <= 1e-16 && scale.high == 255 && scale.is_log);
    const float single[LAYER_VALUES] = {1e-5F}, twice[LAYER_VALUES] = {1e-13F};
    uint8_t rgb[2][3];
    layer_color(LAYER_ERROR, &scale, single, rgb[0]);
    layer_color(LAYER_ERROR, &scale, twice, rgb[1]);
    assert_true(lightness(rgb[0]) > lightness(rgb[1]) + 60);
    // The difference of encoded values keeps its digits, however small it is.
    double light = 0.4, step = 0x1p-50;
    double exact = 255 * 1.055 / 2.4 * pow(light, 1 / 2.4 - 1) * step;
    double found = encoding_difference(ENCODING_SRGB, light + step, light);
    assert_at_most(fabs(found / exact - 1), 1e-9, "small difference");
    assert_true(encoding_difference(ENCODING_SRGB, 0.7, 0.7) == 0);
    for (double x = 0; x < 1; x += 0.0101) {
        for (double y = 0; y < 1; y += 0.0103) {
            double plain = encoding_encode(ENCODING_SRGB, x) - encoding_encode(ENCODING_SRGB, y);
            assert_at_most(fabs(encoding_difference(ENCODING_SRGB, x, y) - plain), 1e-11, "%g", x);
        }
    }
}

/** Ticks lie on the bar where their number has its colour. */
static void test_tick_positions(void **state) {
    (void)state;
    static const Layer bars[] = {LAYER_DISTANCE, LAYER_RAYS,  LAYER_STEPS,
                                 LAYER_TIME,     LAYER_ERROR, LAYER_OPERATIONS};
    for (size_t i = 0; i < sizeof bars / sizeof *bars; i++) {
        LegendEntry ticks[LEGEND_ENTRIES_MAXIMUM];
        LayerScale scale = layer_scale(bars[i], 2, 17);
        size_t count = layer_legend(bars[i], &scale, ticks), ticked = 0;
        assert_at_most(fabs(ticks[0].position - 1), 1e-12, "upper end");
        for (size_t k = 0; k < count; k++) {
            uint8_t rgb[3];
            if (ticks[k].position >= 0) {
                palette_color(&palette_cividis, ticks[k].position, rgb);
                assert_memory_equal(rgb, ticks[k].rgb, sizeof rgb);
                ticked++;
            }
        }
        assert_true(ticked >= 4);
    }
    // From 2 to 20, 3 has a tick: most pictures have pixels of three rays.
    LegendEntry ticks[LEGEND_ENTRIES_MAXIMUM];
    LayerScale scale = layer_scale(LAYER_RAYS, 2, 17);
    size_t count = layer_legend(LAYER_RAYS, &scale, ticks);
    assert_string_equal(ticks[count - 2].number, "3");
}

/** What is read under the mouse is what the ray tree of the pixel has, which `dioptre probe`
 *  prints. */
static void test_readings(void **state) {
    (void)state;
    Scene *scene = load_scene(BOX);
    RenderSettings settings = small_settings(scene, "f32x8", 2);
    settings.samples = 1;
    Renderer *renderer = create_renderer(scene, &settings);
    static const Layer layers[] = {LAYER_NORMALS, LAYER_DISTANCE, LAYER_SHAPES, LAYER_RAYS};
    RayTree tree = {0};
    Error error = {0};
    for (size_t i = 0; i < sizeof layers / sizeof *layers; i++) {
        draw_layer(renderer, scene, layers[i], (LayerImage){WIDTH, HEIGHT, NULL});
        for (int y = 3; y < HEIGHT; y += 11) {
            for (int x = 2; x < WIDTH; x += 13) {
                PixelReading reading;
                assert_true(renderer_read_pixel(renderer, x, y, &reading));
                assert_true(renderer_record_ray_tree(renderer, x, y, &tree, &error));
                const RayTreeNode *ray = &tree.nodes[0];
                const float expected[][LAYER_VALUES] = {
                    {(float)ray->normal.x, (float)ray->normal.y, (float)ray->normal.z},
                    {(float)ray->distance},
                    {(float)ray->shape},
                    {(float)tree.count}};
                assert_int_equal(reading.layer, layers[i]);
                assert_int_equal(reading.shape, ray->shape);
                assert_true(reading.distance == ray->distance);
                assert_true(ray->shape < 0 || reading.values[0] == expected[i][0]);
            }
        }
    }
    ray_tree_deinit(&tree);
    renderer_destroy(renderer);
    scene_destroy(scene);
}

/** A pixel of acne alone has a mark of its own; an edge that is no artefact reads as none. Too many
 *  have no marks. */
static void test_marks(void **state) {
    (void)state;
    Scene *scene = load_scene(BOX);
    RenderSettings settings = small_settings(scene, "f32x8", 2);
    settings.samples = 1;
    settings.trace.offset = OFFSET_FIXED;
    bool is_few = false, is_many = false;
    for (double epsilon = 1e-8; epsilon < 1e-4; epsilon *= 1.5) {
        LayerMarks marks;
        settings.trace.epsilon = epsilon;
        Renderer *renderer = create_renderer(scene, &settings);
        LayerStats stats =
            draw_layer(renderer, scene, LAYER_ACNE, (LayerImage){WIDTH, HEIGHT, NULL}).layer;
        renderer_copy_marks(renderer, &marks);
        assert_true((stats.artifact_pixels + stats.leak_pixels > 0) ==
                    (marks.count > 0 || marks.is_too_many));
        assert_true(marks.count <= stats.artifact_pixels + stats.leak_pixels);
        for (size_t i = 0; i < marks.count; i++) {
            PixelReading reading;
            assert_true(renderer_read_pixel(renderer, marks.x[i], marks.y[i], &reading));
            assert_true(reading.values[1] > ARTIFACT_NONE);
        }
        int wrong = 0;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            PixelReading reading;
            assert_true(renderer_read_pixel(renderer, i % WIDTH, i / WIDTH, &reading));
            wrong += reading.values[1] > ARTIFACT_NONE;
        }
        assert_int_equal(wrong, (int)(stats.artifact_pixels + stats.leak_pixels));
        is_few = is_few || marks.count > 0;
        is_many = is_many || marks.is_too_many;
        assert_string_equal(stats.reference, engine_with_role(ENGINE_DOUBLE)->name);
        assert_true(stats.measured_fraction == 1);
        renderer_destroy(renderer);
    }
    assert_true(is_few && is_many);
    scene_destroy(scene);
}

/** What a layer shows first. */
typedef struct FirstPass {
    Renderer *renderer;               /**< Renders it. */
    bool is_seen;                     /**< Whether it was shown. */
    double time;                      /**< When, seconds. */
    double next_time;                 /**< When the pass after it was shown; 0: not yet. */
    double measured_fraction;         /**< Share of the pixels whose number it knows. */
    uint8_t bgrx[4 * WIDTH * HEIGHT]; /**< Its colours. */
} FirstPass;

/** Keeps the first pass. See #RenderPassCallback. @param context #FirstPass */
static void keep_first_pass(void *context) {
    FirstPass *first = context;
    RenderStats report;
    double now = clock_now_seconds();
    if (!first->is_seen && renderer_copy_latest(first->renderer, &report, first->bgrx, 4 * WIDTH)) {
        first->is_seen = true;
        first->time = now;
        first->measured_fraction = report.layer.measured_fraction;
    } else if (first->next_time == 0) {
        first->next_time = now;
    }
}

/** Layers that trace more than the picture show the picture first, in grey, so that a key is
 *  answered as fast as in the picture. The slow passes leave it the time to reach the screen. */
static void test_previews(void **state) {
    (void)state;
    static FirstPass first;
    Scene *scene = load_scene(BOX);
    RenderSettings settings = small_settings(scene, "f32x8", 2);
    for (Layer layer = LAYER_NORMALS; layer < LAYER_COUNT; layer++) {
        bool has_preview = layer == LAYER_ERROR || layer == LAYER_ROUNDING;
        Error error = {0};
        Renderer *renderer = create_renderer(scene, &settings);
        first = (FirstPass){.renderer = renderer};
        renderer_set_layer(renderer, layer);
        assert_true(
            renderer_start(renderer, scene, WIDTH, HEIGHT, keep_first_pass, &first, &error));
        wait_until_finished(renderer);
        assert_true(first.is_seen);
        assert_int_equal(first.measured_fraction == 0, has_preview);
        assert_true(!has_preview || first.next_time - first.time >= PREVIEW_PAUSE);
        int brightest = 0;
        for (size_t i = 0; has_preview && i < WIDTH * HEIGHT; i++) {
            const uint8_t *pixel = first.bgrx + 4 * i;
            assert_true(pixel[0] == pixel[1] && pixel[1] == pixel[2]);
            brightest = pixel[0] > brightest ? pixel[0] : brightest;
        }
        assert_true(!has_preview || brightest > ENCODING_CODE_MAXIMUM / 2);
        renderer_destroy(renderer);
    }
    scene_destroy(scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_faults),
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_layers),
        cmocka_unit_test(test_legends),
        cmocka_unit_test(test_difference),
        cmocka_unit_test(test_sphere_aovs),
        cmocka_unit_test(test_rays),
        cmocka_unit_test(test_uvs),
        cmocka_unit_test(test_lights),
        cmocka_unit_test(test_steps),
        cmocka_unit_test_setup_teardown(test_operations, fixture_set_up, fixture_tear_down),
        cmocka_unit_test(test_readings),
        cmocka_unit_test(test_value_difference),
        cmocka_unit_test(test_marks),
        cmocka_unit_test(test_error_scale),
        cmocka_unit_test(test_tick_positions),
        cmocka_unit_test(test_previews),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
