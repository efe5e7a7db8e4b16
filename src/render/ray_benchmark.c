/**
 * @file
 * @brief Closest hits alone: a benchmark for `bench --rays`.
 */
#include "render/renderer_internal.h"

#include <stdlib.h>

/** Rays of a task. */
#define BENCHMARK_BATCH_RAYS ((size_t)TILE_COLUMNS * TILE_ROWS)

/** Seed of the random rays. */
#define BENCHMARK_SEED 20260104u

/** A benchmark, as its threads share it. */
typedef struct RayBenchmark {
    const Renderer *renderer; /**< The renderer. */
    const RayQuery *rays;     /**< Random rays; NULL: camera rays. */
    size_t count;             /**< Number of rays. */
} RayBenchmark;

/** Traces the camera rays of a tile. See #ThreadPoolTask. */
static void benchmark_tile(void *context, size_t index) {
    const RayBenchmark *benchmark = context;
    const RenderSettings *settings = &benchmark->renderer->settings;
    int shapes[BENCHMARK_BATCH_RAYS];
    double distances[BENCHMARK_BATCH_RAYS];
    PixelGrid tile = tile_at(settings->width, settings->height, index);
    settings->engine->trace_primary(benchmark->renderer->tracer, &tile, shapes, distances);
}

/** Traces a batch of random rays. See #ThreadPoolTask. */
static void benchmark_batch(void *context, size_t index) {
    const RayBenchmark *benchmark = context;
    int shapes[BENCHMARK_BATCH_RAYS];
    double distances[BENCHMARK_BATCH_RAYS];
    size_t first = index * BENCHMARK_BATCH_RAYS, remaining = benchmark->count - first;
    benchmark->renderer->settings.engine->closest_hits(
        benchmark->renderer->tracer,
        remaining < BENCHMARK_BATCH_RAYS ? remaining : BENCHMARK_BATCH_RAYS,
        benchmark->rays + first, shapes, distances);
}

/** @return A number, uniform in 0 to 1 (Steele, Lea, Flood, *Fast Splittable Pseudorandom Number
 *  Generators*, 2014: splitmix64). */
static double random_uniform(uint64_t *state) {
    uint64_t z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/** @return A ray from a uniform point of a box in a uniform direction. */
static RayQuery random_ray(uint64_t *state, Vec3d low, Vec3d high) {
    double height = 2 * random_uniform(state) - 1, angle = 2 * M_PI * random_uniform(state);
    double radius = sqrt(1 - height * height);
    RayQuery ray = {.direction = {radius * cos(angle), height, radius * sin(angle)}};
    ray.origin[0] = low.x + (high.x - low.x) * random_uniform(state);
    ray.origin[1] = low.y + (high.y - low.y) * random_uniform(state);
    ray.origin[2] = low.z + (high.z - low.z) * random_uniform(state);
    return ray;
}

/** @return Random rays, to be freed; NULL without memory. */
static RayQuery *random_rays(const Renderer *renderer, size_t count) {
    Vec3d low, high;
    renderer->settings.engine->bounds(renderer->tracer, &low, &high);
    if (!(low.x <= high.x)) {
        low = high = (Vec3d){0, 0, 0};
    }
    RayQuery *rays = malloc(count * sizeof *rays);
    uint64_t state = BENCHMARK_SEED;
    for (size_t i = 0; rays && i < count; i++) {
        rays[i] = random_ray(&state, low, high);
    }
    return rays;
}

RenderStats renderer_benchmark_rays(Renderer *renderer, bool random) {
    const RenderSettings *settings = &renderer->settings;
    size_t count = (size_t)settings->width * (size_t)settings->height;
    RayQuery *rays = random ? random_rays(renderer, count) : NULL;
    if (random && !rays) {
        return (RenderStats){0};
    }
    RayBenchmark benchmark = {renderer, rays, count};
    size_t tasks = random ? (count + BENCHMARK_BATCH_RAYS - 1) / BENCHMARK_BATCH_RAYS
                          : tile_count(settings->width, settings->height);
    double start = clock_now_seconds();
    thread_pool_run(renderer->thread_pool, tasks, random ? benchmark_batch : benchmark_tile,
                    &benchmark);
    double seconds = clock_now_seconds() - start;
    free(rays);
    return (RenderStats){
        .seconds = seconds, .rays = {.camera = count}, .progress = 1, .is_finished = true};
}
