/**
 * @file
 * @brief Surveys say what the rays do, in every engine, and layers show it.
 */
#include "pictures.h"

#include "dioptre/difference.h"

/** Size of the pictures that every engine is asked about. */
enum { ACROSS = 45, DOWN = 29 };

/** What is known of such a picture. */
typedef struct Survey {
    SurveyPoint points[ACROSS * DOWN]; /**< Its pixels. */
    double rgb[3 * ACROSS * DOWN];     /**< Its light, as #Engine.trace finds it. */
    RayCounts counts;                  /**< The rays traced by the survey. */
    RayCounts traced;                  /**< Those traced for the light. */
} Survey;

/** @return A picture surveyed, to be freed. @param engine The engine. @param scene The scene.
 *  @param wanted See #Engine.survey. */
static Survey *survey(const Engine *engine, const Scene *scene, unsigned wanted) {
    Survey *found = calloc(1, sizeof *found);
    PixelGrid grid = {.columns = ACROSS, .rows = DOWN, .stride = 1};
    Tracer *tracer = prepare(engine, scene);
    assert_non_null(found);
    engine->look(tracer, scene, ACROSS, DOWN);
    engine->survey(tracer, &grid, wanted, found->points, &found->counts);
    engine->trace(tracer, &grid, found->rgb, &found->traced);
    engine->release(tracer);
    return found;
}

/* --- surveys ---------------------------------------------------------------------------------- */

/** @return The way of a pixel's ray from a camera at the origin that looks along -z, one long.
 *  @param camera The camera. @param i Which pixel. */
static Vector3 ray_way(const Camera *camera, int i) {
    double half = tan(camera->fov / 2 * (M_PI / 180)) / ACROSS;
    double x = (2 * (i % ACROSS) + 1 - ACROSS) * half, y = (DOWN - 2 * (i / ACROSS) - 1) * half;
    return vector3_scale((Vector3){x, y, -1}, 1 / sqrt(x * x + y * y + 1));
}

/** Distance, normal and shape of a ball and of nothing, by their closed form. @param engine The
 *  engine. */
static void ball_is_surveyed(const Engine *engine) {
    Scene *scene = empty_scene();
    const SphereParameters far = {{0, 0, -50}, 1}, near = {{0.3, -0.2, -4}, 1.5};
    add_shape(scene, "sphere", &far);
    add_shape(scene, "sphere", &near);
    Survey *found = survey(engine, scene, 0);
    double unit = (double)roundoff(engine) + 0x1p-52;
    int hits = 0;
    for (int i = 0; i < ACROSS * DOWN; i++) {
        const SurveyPoint *point = &found->points[i];
        Vector3 way = ray_way(&scene->camera, i);
        double along = vector3_dot(near.center, way);
        double square =
            along * along - vector3_dot(near.center, near.center) + near.radius * near.radius;
        if (fabs(square) < 1e-3) {
            continue;
        }
        assert_int_equal(point->shape, square > 0 ? 1 : -1);
        assert_true((square > 0) == isfinite(point->distance));
        if (square > 0) {
            double distance = along - sqrt(square);
            Vector3 normal = vector3_scale(
                vector3_subtract(vector3_scale(way, distance), near.center), 1 / near.radius);
            assert_at_most(fabs(point->distance - distance), 300 * unit / sqrt(square),
                           "%s distance", engine->name);
            assert_at_most(fabs(point->normal[0] - normal.x) + fabs(point->normal[1] - normal.y) +
                               fabs(point->normal[2] - normal.z),
                           600 * unit / sqrt(square), "%s normal", engine->name);
            hits++;
        }
    }
    assert_true(hits > 200 && hits < ACROSS * DOWN - 200);
    assert_int_equal((int)found->counts.camera, ACROSS * DOWN);
    free(found);
    scene_destroy(scene);
}

/** See #ball_is_surveyed. @param state The fixture. */
static void test_ball(void **state) {
    (void)state;
    in_every_engine(ball_is_surveyed);
}

/** @return Whether an engine is the slow one, which has other tests. @param engine The engine. */
static bool is_slow(const Engine *engine) {
    return engine->mantissa_bits > 64;
}

/** The light, and the sum of all rays, are those of the picture. @param engine The engine. */
static void rays_are_counted(const Engine *engine) {
    static const char *const scenes[] = {"scenes/box.lua", "scenes/glass-sphere.lua",
                                         "scenes/lamps.lua"};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes && (i == 0 || !is_slow(engine)); i++) {
        Scene *scene = load(scenes[i]);
        scene->image.depth = 5;
        Survey *found = survey(engine, scene, SURVEY_LIGHT);
        uint64_t sum = 0;
        for (size_t k = 0; k < ACROSS * DOWN; k++) {
            sum += found->points[k].rays;
            for (size_t c = 0; c < 3; c++) {
                assert_memory_equal(&found->points[k].color[c], &found->rgb[c * ACROSS * DOWN + k],
                                    sizeof(double));
            }
        }
        assert_int_equal((int)sum, (int)ray_counts_sum(&found->traced));
        assert_memory_equal(&found->counts, &found->traced, sizeof found->counts);
        assert_true(sum > 2 * ACROSS * DOWN);
        free(found);
        scene_destroy(scene);
    }
}

/** See #rays_are_counted. @param state The fixture. */
static void test_rays(void **state) {
    (void)state;
    in_every_engine(rays_are_counted);
}

/** Shape and place are what #Engine.intersect says of the same ray. @param engine The engine. */
static void places_are_those_of_intersect(const Engine *engine) {
    Scene *scene = empty_scene();
    const SphereParameters ball = {{0, 0, -4}, 1};
    const QuadParameters wall = {{-9, -9, -8}, {18, 0, 0}, {0, 18, 0}};
    add_shape(scene, "sphere", &ball);
    add_shape(scene, "quad", &wall);
    Survey *found = survey(engine, scene, SURVEY_PLACE);
    Tracer *tracer = prepare(engine, scene);
    for (int i = 0; i < ACROSS * DOWN; i++) {
        RayAnswer answer;
        Vector3 way = ray_way(&scene->camera, i);
        RayQuery query = ray_towards((Vector3){0, 0, 0}, way);
        engine->intersect(tracer, 1, &query, &answer);
        if (answer.shape == found->points[i].shape) {
            assert_at_most(fabs((double)answer.place[0] - found->points[i].place[0]), 1e-4, "u");
            assert_at_most(fabs((double)answer.place[1] - found->points[i].place[1]), 1e-4, "v");
        }
    }
    engine->release(tracer);
    free(found);
    scene_destroy(scene);
}

/** See #places_are_those_of_intersect. @param state The fixture. */
static void test_places(void **state) {
    (void)state;
    in_every_engine(places_are_those_of_intersect);
}

/** Adds a lamp. @param scene The scene. @param position Where. */
static void add_lamp(Scene *scene, Vector3 position) {
    Error error = {0};
    Light light = {.kind = LIGHT_POINT, .color = {1, 1, 1}, .intensity = 1, .position = position};
    assert_true(scene_add_light(scene, &light, &error));
}

/** A wall is lit by one lamp and not by another behind a smaller wall; and a mirror's next surface
 *  is known. @param engine The engine. */
static void lamps_and_mirrors_are_noted(const Engine *engine) {
    Scene *scene = empty_scene();
    const QuadParameters wall = {{-9, -9, -8}, {18, 0, 0}, {0, 18, 0}};
    const QuadParameters shade = {{-99, -99, 2}, {198, 0, 0}, {0, 198, 0}};
    scene->materials[0].reflectivity = (Color){0.5, 0.5, 0.5};
    add_shape(scene, "quad", &wall);
    add_shape(scene, "quad", &shade);
    add_lamp(scene, (Vector3){0, 0, -1});
    add_lamp(scene, (Vector3){0, 0, 5});
    add_lamp(scene, (Vector3){0, 0, -20});
    Survey *found = survey(engine, scene, SURVEY_LIGHT);
    for (size_t i = 0; i < ACROSS * DOWN; i++) {
        const SurveyPoint *point = &found->points[i];
        assert_int_equal(point->shape, 0);
        assert_int_equal((int)point->asked, 3);
        assert_int_equal((int)point->dark, 2);
        assert_int_equal((int)point->next_count, 1);
        assert_int_equal(point->next[0], 1);
    }
    free(found);
    scene_destroy(scene);
}

/** See #lamps_and_mirrors_are_noted. @param state The fixture. */
static void test_lamps(void **state) {
    (void)state;
    in_every_engine(lamps_and_mirrors_are_noted);
}

/** Steps are the same at every width, and there where something is marched. @param state The
 *  fixture. */
static void test_steps(void **state) {
    (void)state;
    static const char *const scenes[] = {"scenes/cube-frame.lua", "scenes/endless-frames.lua",
                                         "scenes/turned-frame.lua"};
    Error error = {0};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        Scene *scene = load(scenes[i]);
        scene->image.depth = 2;
        Survey *one = survey(engine_find("f32x1", &error), scene, SURVEY_STEPS);
        Survey *four = survey(engine_find("f32x4", &error), scene, SURVEY_STEPS | SURVEY_LIGHT);
        uint64_t sum = 0;
        for (size_t k = 0; k < ACROSS * DOWN; k++) {
            assert_int_equal(one->points[k].steps, four->points[k].steps);
            sum += one->points[k].steps;
        }
        assert_true(sum > ACROSS * DOWN);
        free(one);
        free(four);
        scene_destroy(scene);
    }
    Scene *box = load("scenes/box.lua");
    Survey *none = survey(engine_find("f32x4", &error), box, SURVEY_STEPS);
    for (size_t k = 0; k < ACROSS * DOWN; k++) {
        assert_int_equal(none->points[k].steps, 0);
    }
    free(none);
    scene_destroy(box);
}

/* --- layers ----------------------------------------------------------------------------------- */

/** A picture's size, and where its pixels go, blue, green, red and an unused byte each, or NULL. */
typedef struct Paper {
    int width;     /**< Pixels. */
    int height;    /**< Pixels. */
    uint8_t *bgrx; /**< Room for them; NULL: nobody wants them. */
} Paper;

/** Draws a layer to its end. @param renderer What draws. @param scene Camera and lights.
 *  @param layer Which. @param paper Its size. @return How it stands. */
static RenderReport draw_layer(Renderer *renderer, const Scene *scene, Layer layer, Paper paper) {
    Error error = {0};
    RenderReport report = {0};
    const struct timespec pause = {.tv_nsec = 200000};
    renderer_set_layer(renderer, layer);
    assert_true(renderer_start(renderer, scene, paper.width, paper.height, NULL, NULL, &error));
    while (!report.is_finished) {
        renderer_take(renderer, &report, NULL, 0);
        nanosleep(&pause, NULL);
    }
    renderer_take(renderer, &report, paper.bgrx, 4 * paper.width);
    assert_int_equal(report.layer.layer, layer);
    assert_int_equal((int)report.layer.pixels, paper.width * paper.height);
    return report;
}

/** The scene with mirrors that most is asked of. */
static const char BOX[] = "scenes/box.lua";

/** @return How a layer stands when it is finished. @param path The scene. @param engine The
 * engine's name.
 *  @param offset How rays leave surfaces. @param epsilon How far, where that is fixed.
 *  @param layer Which layer. @param paper Its size. */
static LayerReport report_of(const char *path, const char *engine, OffsetStrategy offset,
                             double epsilon, Layer layer, Paper paper) {
    Scene *scene = load(path);
    RenderSettings settings = small_settings(scene, engine, 2);
    settings.samples = 1;
    settings.trace.offset = offset;
    settings.trace.epsilon = epsilon;
    Renderer *renderer = create(scene, &settings);
    LayerReport report = draw_layer(renderer, scene, layer, paper).layer;
    renderer_destroy(renderer);
    scene_destroy(scene);
    return report;
}

/** Rays that start where they hit make acne, in float a hundredth of the box; a fixed epsilon
 *  that is far too large makes leaks; a bound on the error makes neither. @param state The fixture.
 */
static void test_faults(void **state) {
    (void)state;
    const Paper large = {800, 600, NULL};
    const uint64_t pixels = 800 * 600;
    LayerReport none = report_of(BOX, "f32x8", OFFSET_NONE, 0, LAYER_ACNE, large);
    assert_true(none.faults > pixels / 100);
    LayerReport far = report_of(BOX, "f32x8", OFFSET_FIXED, 0.3, LAYER_ACNE, large);
    assert_true(far.leaks > pixels / 100);
    // In the last two a ray passes an edge on its other side in float: that is no fault.
    static const char *const scenes[] = {BOX, "scenes/report-d-shapes.lua", "scenes/lamps.lua"};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        LayerReport bound = report_of(scenes[i], "f32x8", OFFSET_BOUND, 0, LAYER_ACNE, large);
        assert_int_equal((int)bound.faults, 0);
        assert_int_equal((int)bound.leaks, 0);
    }
}

/** Errors against quad: a few pixels on edges in float, many with acne. @param state The fixture.
 */
static void test_errors(void **state) {
    (void)state;
    const Paper small = {WIDTH, HEIGHT, NULL};
    assert_true(report_of(BOX, "f32x8", OFFSET_BOUND, 0, LAYER_ERROR, small).faults < 5);
    uint64_t none = report_of(BOX, "f32x8", OFFSET_NONE, 0, LAYER_ERROR, small).faults;
    assert_true(none > WIDTH * HEIGHT / 100);
}

/** Every layer comes to its end with its colours, in any order, and the light is drawn afterwards
 *  as if there were none. @param state The fixture. */
static void test_layers(void **state) {
    (void)state;
    Scene *scene = load("scenes/glass-sphere.lua");
    scene->image.samples = 4;
    RenderSettings settings = small_settings(scene, "f32x4", 2);
    Picture before = draw(scene, &settings);
    Renderer *renderer = create(scene, &settings);
    Tracer *tracer = settings.engine->prepare(scene, &settings.trace, &(Error){0});
    settings.engine->look(tracer, scene, WIDTH, HEIGHT);
    for (Layer layer = LAYER_NORMALS; layer < LAYER_COUNT; layer++) {
        uint8_t *bgrx = calloc(4, (size_t)WIDTH * HEIGHT);
        Paper paper = {WIDTH, HEIGHT, bgrx};
        LayerScale scale = draw_layer(renderer, scene, layer, paper).layer.scale;
        for (size_t i = 0; i < WIDTH * HEIGHT && layer < LAYER_TIME; i += 97) {
            PixelGrid grid = {.x = (int)(i % WIDTH), .y = (int)(i / WIDTH), 1, 1, 1};
            SurveyPoint point;
            float numbers[LAYER_NUMBERS] = {0};
            uint8_t rgb[3];
            settings.engine->survey(tracer, &grid, SURVEY_LIGHT | SURVEY_STEPS | SURVEY_PLACE,
                                    &point, &(RayCounts){0});
            layer_numbers(layer, &point, numbers);
            layer_color(layer, &scale, numbers, rgb);
            for (size_t c = 0; c < 3; c++) {
                assert_int_equal(bgrx[4 * i + 2 - c], rgb[c]);
            }
        }
        free(bgrx);
    }
    settings.engine->release(tracer);
    int passes = 0;
    renderer_set_layer(renderer, LAYER_SHADED);
    assert_same(&before, draw_in_background(renderer, scene, &passes));
    picture_release(&before);
    renderer_destroy(renderer);
    scene_destroy(scene);
}

/** @return How light a colour is, 0 to 255. @param rgb The colour. */
static double lightness(const uint8_t rgb[3]) {
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

/** Larger numbers are lighter, so that they are told apart without hues, too. Scales hold all
 * numbers, their ends are round, and their legends go down from one end to the other. @param state
 * The fixture. */
static void test_legends(void **state) {
    (void)state;
    static const double ends[][2] = {{0, 0},         {1, 1},     {4.37, 9.01}, {1, 40},
                                     {0.003, 700},   {2.2, 1e7}, {1e-9, 1e9},  {0, 12},
                                     {1e6, 1e6 + 3}, {7, 6}};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        LayerTick ticks[LAYER_TICKS];
        LayerScale scale = layer_scale(LAYER_RAYS, ends[i][0], ends[i][1]);
        size_t count = layer_legend(LAYER_RAYS, &scale, ticks);
        if (ends[i][1] < ends[i][0]) {
            assert_int_equal((int)count, 0);
            continue;
        }
        assert_true(scale.low <= ends[i][0] && ends[i][1] <= scale.high);
        assert_true(scale.low < scale.high);
        assert_true(count >= 3 && count <= LAYER_TICKS);
        assert_at_most(fabs(strtod(ticks[0].number, NULL) / scale.high - 1), 1e-5, "first %zu", i);
        for (size_t k = 1; k < count; k++) {
            assert_true(strtod(ticks[k].number, NULL) < strtod(ticks[k - 1].number, NULL));
            assert_true(lightness(ticks[k].rgb) < lightness(ticks[k - 1].rgb));
        }
    }
    for (Layer layer = LAYER_NORMALS; layer < LAYER_COUNT; layer++) {
        LayerTick ticks[LAYER_TICKS];
        LayerScale scale = layer_scale(layer, 0.5, 80);
        size_t count = layer_legend(layer, &scale, ticks);
        assert_true(count >= 2 && count <= LAYER_TICKS);
        assert_true(layer_name(layer)[0] != '\0');
    }
}

/** A difference is white where there is none, red where the first is brighter, blue where the
 * second is; one step is no fault, two are. @param state The fixture. */
static void test_difference(void **state) {
    (void)state;
    uint8_t a[] = {9, 9, 9, 0, 9, 8, 9, 0, 9, 9, 19, 0, 0, 0, 0, 0};
    const uint8_t b[] = {9, 9, 9, 0, 9, 9, 9, 0, 9, 9, 9, 0, 255, 0, 1, 0};
    Difference difference = difference_draw(a, b, 4, a);
    assert_int_equal(difference.worst, 255);
    assert_int_equal((int)difference.off, 2);
    assert_true(a[0] == a[1] && a[1] == a[2] && a[0] > 240);
    assert_true(a[4] > a[6] && a[10] > a[8] && a[12] > a[14]);
    LayerTick ticks[LAYER_TICKS];
    size_t count = difference_legend(ticks);
    assert_true(count > 4 && count <= LAYER_TICKS);
    assert_string_equal(ticks[count / 2].number, "0");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_faults),     cmocka_unit_test(test_errors),
        cmocka_unit_test(test_layers),     cmocka_unit_test(test_legends),
        cmocka_unit_test(test_difference), cmocka_unit_test(test_ball),
        cmocka_unit_test(test_rays),       cmocka_unit_test(test_places),
        cmocka_unit_test(test_lamps),      cmocka_unit_test(test_steps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
