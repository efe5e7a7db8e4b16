/**
 * @file
 * @brief Nearest hits alone, for `bench --rays`.
 */
#include "render/renderer.h"

#include <stdlib.h>

/** Rays that a thread takes at a time. */
#define CASTING_RAYS ((size_t)BLOCK_COLUMNS * BLOCK_ROWS)

/** The first number of the random rays: any will do, as long as it is always the same. */
#define CASTING_SEED 20260104u

/** What the threads share. */
typedef struct Casting {
    const Renderer *renderer; /**< The renderer. */
    const PlainRay *rays;     /**< Random rays; NULL: the camera's. */
    size_t count;             /**< How many rays in all. */
} Casting;

/** Casts the camera rays of a block. See #WorkersJob. @param context The casting. @param index It.
 */
static void cast_block(void *context, size_t index) {
    const Casting *casting = context;
    const RenderSettings *settings = &casting->renderer->settings;
    int shapes[CASTING_RAYS];
    double distances[CASTING_RAYS];
    PixelGrid block = drawing_block(settings->width, settings->height, index);
    settings->engine->cast(casting->renderer->tracer, &block, shapes, distances);
}

/** Casts some random rays. See #WorkersJob. @param context The casting. @param index Which. */
static void cast_some(void *context, size_t index) {
    const Casting *casting = context;
    int shapes[CASTING_RAYS];
    double distances[CASTING_RAYS];
    size_t first = index * CASTING_RAYS, left = casting->count - first;
    casting->renderer->settings.engine->nearest(casting->renderer->tracer,
                                                left < CASTING_RAYS ? left : CASTING_RAYS,
                                                casting->rays + first, shapes, distances);
}

/**
 * @return A number, uniform in 0 to 1 (Steele, Lea, Flood, *Fast Splittable Pseudorandom Number
 *         Generators*, 2014: splitmix64).
 * @param[in,out] state  The generator.
 */
static double random_uniform(uint64_t *state) {
    uint64_t z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/** @return A ray from anywhere in a box to anywhere. @param[in,out] state The generator.
 *  @param low The box. @param high The box. */
static PlainRay random_ray(uint64_t *state, Vector3 low, Vector3 high) {
    double height = 2 * random_uniform(state) - 1, angle = 2 * M_PI * random_uniform(state);
    double across = sqrt(1 - height * height);
    PlainRay ray = {.direction = {across * cos(angle), height, across * sin(angle)}};
    ray.origin[0] = low.x + (high.x - low.x) * random_uniform(state);
    ray.origin[1] = low.y + (high.y - low.y) * random_uniform(state);
    ray.origin[2] = low.z + (high.z - low.z) * random_uniform(state);
    return ray;
}

/** @return Random rays, to be freed; NULL without memory. @param renderer The renderer.
 *  @param count How many. */
static PlainRay *random_rays(const Renderer *renderer, size_t count) {
    Vector3 low, high;
    renderer->settings.engine->bounds(renderer->tracer, &low, &high);
    if (!(low.x <= high.x)) {
        low = high = (Vector3){0, 0, 0};
    }
    PlainRay *rays = malloc(count * sizeof *rays);
    uint64_t state = CASTING_SEED;
    for (size_t i = 0; rays && i < count; i++) {
        rays[i] = random_ray(&state, low, high);
    }
    return rays;
}

RenderReport renderer_cast(Renderer *renderer, bool random) {
    const RenderSettings *settings = &renderer->settings;
    size_t count = (size_t)settings->width * (size_t)settings->height;
    PlainRay *rays = random ? random_rays(renderer, count) : NULL;
    if (random && !rays) {
        return (RenderReport){0};
    }
    Casting casting = {renderer, rays, count};
    size_t pieces = random ? (count + CASTING_RAYS - 1) / CASTING_RAYS
                           : drawing_blocks(settings->width, settings->height);
    double start = clock_seconds();
    workers_run(renderer->workers, pieces, random ? cast_some : cast_block, &casting);
    double seconds = clock_seconds() - start;
    free(rays);
    return (RenderReport){
        .seconds = seconds, .rays = {.camera = count}, .share = 1, .is_finished = true};
}
