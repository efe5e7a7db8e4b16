/**
 * @file
 * @brief Tests of the stack of the threads that trace rays: what the deepest ray needs, measured on
 *        a stack that was painted before.
 */
#include "fixtures.h"
#include "load_scene.h"

#include "render/ray_stack.h"

#include <pthread.h>
#include <sys/mman.h>

/**
 * A ball that mirrors all light inside, with the camera, balls of glass that refract nothing (so
 * that rays do not split), a triangle, a distance field and lights in it: every ray goes as deep as
 * it may, and calls all parts of the tracer on its way.
 */
static const char SCENE[] =
    "camera { position = {0.3, 0.1, 3}, look_at = {0, 0, 0}, fov = 90 }\n"
    "light { position = {1, 2, 1}, radius = 0.1 } light { position = {-1, 2, 1} }\n"
    "ambient(0.2)\n"
    "sphere { radius = 9, material = material { color = 0.1, reflectivity = 1 } }\n"
    "local air = material { color = 0, transparency = 1, ior = 1 }\n"
    "for i = -4, 4 do for j = -4, 4 do\n"
    "  sphere { center = {1.1 * i, 1.1 * j, 0}, radius = 0.5, material = air }\n"
    "  box { min = {1.1 * i, 1.1 * j, 3.2}, max = {1.1 * i + 1, 1.1 * j + 1, 4}, material = air }\n"
    "end end\n"
    "triangle { a = {-9, -2, -2}, b = {9, -2, -2}, c = {0, -2, 3} }\n"
    "sdf { distance.smooth_union(distance.torus {}, distance.box {}, 0.2):translate{0, 1.5, 2},\n"
    "      material = material { color = 0.1, reflectivity = 1 } }\n"
    "cone { scale = {1, 2, 1}, rotate = {20, 30, 40}, translate = {0, -2, 1}, material = air }\n";

/** Bytes of the painted stack: more than a thread has, so that a test fails and does not crash. */
#define PAINTED_SIZE (2 * RAY_STACK_SIZE)
/** Colour of the paint. */
enum { PAINT = 0xA5 };
/** Size of the picture, pixels. */
enum { WIDTH = 16, HEIGHT = 16 };

/** What a thread traces. */
typedef struct DeepTrace {
    const Engine *engine; /**< The engine. */
    const Scene *scene;   /**< The scene. */
    int depth;            /**< Recursion depth. */
    RayCounts counts;     /**< The rays. */
} DeepTrace;

/** Traces all pixels of a scene. See pthread_create. @return NULL */
static void *trace_all(void *argument) {
    static double rgb[3 * WIDTH * HEIGHT];
    static AovSample samples[WIDTH * HEIGHT];
    DeepTrace *deep = argument;
    Error error = {0};
    const TraceSettings settings = {
        .depth = deep->depth, .samples = 4, .offset = OFFSET_BOUND, .footprint = 0.5};
    const PixelGrid grid = {.columns = WIDTH, .rows = HEIGHT, .stride = 1};
    Tracer *tracer = deep->engine->create_tracer(deep->scene, &settings, &error);
    assert_non_null(tracer);
    deep->engine->set_view(tracer, deep->scene, WIDTH, HEIGHT);
    deep->engine->trace(tracer, &grid, rgb, &deep->counts);
    deep->engine->trace_aovs(tracer, &grid, AOV_RADIANCE, samples, &deep->counts);
    deep->engine->destroy(tracer);
    return NULL;
}

/** @return Bytes of stack that a trace needs. */
static size_t stack_use(DeepTrace *deep) {
    pthread_attr_t attributes;
    pthread_t thread;
    unsigned char *stack =
        mmap(NULL, PAINTED_SIZE, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    assert_true(stack != MAP_FAILED);
    memset(stack, PAINT, PAINTED_SIZE);
    pthread_attr_init(&attributes);
    assert_int_equal(pthread_attr_setstack(&attributes, stack, PAINTED_SIZE), 0);
    assert_int_equal(pthread_create(&thread, &attributes, trace_all, deep), 0);
    pthread_join(thread, NULL);
    pthread_attr_destroy(&attributes);
    size_t untouched = 0;
    while (untouched < PAINTED_SIZE && stack[untouched] == PAINT) {
        untouched++;
    }
    munmap(stack, PAINTED_SIZE);
    return PAINTED_SIZE - untouched;
}

/**
 * A ray of the largest depth needs at most three quarters of the stack of a thread, in every
 * engine; the paint shows that it goes that deep: the stack grows with the depth.
 */
static void test_deepest_ray(void **state) {
    write_file(fixture_path(state, "deep.lua"), SCENE, sizeof SCENE - 1);
    Scene *scene = load_scene(fixture_path(state, "deep.lua"));
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if (engine_is_supported(*engine)) {
            DeepTrace flat = {.engine = *engine, .scene = scene, .depth = 0};
            DeepTrace half = {.engine = *engine, .scene = scene, .depth = DEPTH_MAXIMUM / 2};
            DeepTrace deep = {.engine = *engine, .scene = scene, .depth = DEPTH_MAXIMUM};
            size_t flat_use = stack_use(&flat), half_use = stack_use(&half);
            size_t deep_use = stack_use(&deep);
            print_message("%s: %zu bytes of stack, %zu at half the depth, %zu without recursion\n",
                          (*engine)->name, deep_use, half_use, flat_use);
            assert_true(flat_use < half_use && half_use < deep_use);
            assert_at_most(deep_use, RAY_STACK_SIZE / 4 * 3, "stack of %s", (*engine)->name);
            // What the first, heaviest levels need, at all levels.
            assert_at_most(flat_use + 2 * (half_use - flat_use), RAY_STACK_SIZE / 4 * 3,
                           "stack of %s by its first half", (*engine)->name);
        }
    }
    scene_destroy(scene);
}

/** Runs the tests. @return 0 if all pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_deepest_ray, fixture_set_up, fixture_tear_down)};
    return cmocka_run_group_tests_name("thread stack", tests, NULL, NULL);
}
