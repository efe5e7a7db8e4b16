/**
 * @file
 * @brief Taking shots.
 */
#include "lab/shot.h"

#include "render/drawing.h"
#include "render/workers.h"

#include <stdlib.h>
#include <time.h>

/** Rays of a block. */
enum { BLOCK_RAYS = BLOCK_COLUMNS * BLOCK_ROWS };

/** A shot under way, shared by its threads. */
typedef struct Taking {
    const Studio *studio; /**< What is shot. */
    const Manner *manner; /**< How. */
    const Tracer *tracer; /**< The manner's tracer. */
    Shot *shot;           /**< Where it goes. */
    RayCounts *counts;    /**< Rays traced, for each block. */
} Taking;

/** @return The processor's time that this program has used, seconds. */
static double processor_seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/** @return Whether a studio was stopped. @param studio It. */
static bool is_stopped(const Studio *studio) {
    return studio->stop && atomic_load_explicit(studio->stop, memory_order_relaxed);
}

/** Traces one sample of a block's pixels. @param taking The shot. @param grid The pixels, with
 *  their sample. @param first How many pixels come before. @param[in,out] counts The rays. */
static void sample_trace(const Taking *taking, PixelGrid *grid, size_t first, RayCounts *counts) {
    double planes[3 * BLOCK_RAYS];
    size_t count = grid->chosen_count;
    size_t place = (size_t)grid->sample * taking->studio->pixels->count + first;
    grid->trails = taking->shot->trails + place;
    taking->manner->engine->trace(taking->tracer, grid, planes, counts);
    for (size_t i = 0; i < 3 * count; i++) {
        taking->shot->rgb[3 * (place + i % count) + i / count] = planes[i];
    }
}

/** Traces a block. See #WorkersJob. @param context The #Taking. @param index Which block. */
static void block_take(void *context, size_t index) {
    const Taking *taking = context;
    PixelGrid grid = pixels_grid(taking->studio->pixels, index);
    for (int sample = 0; grid.chosen_count > 0 && sample < taking->manner->rays; sample++) {
        if (is_stopped(taking->studio)) {
            return;
        }
        grid.sample = sample;
        sample_trace(taking, &grid, taking->studio->pixels->first[index], &taking->counts[index]);
    }
}

/** @return A camera that is turned by a part of a pixel. @param camera The camera. @param manner By
 *  how much. @param width Pixels of the picture. */
static Camera camera_nudged(Camera camera, const Manner *manner, int width) {
    double pixel = 2 * tan(camera.fov / 2 * (M_PI / 180)) / width;
    Vector3 right = vector3_scale(camera_right(&camera), manner->right * pixel);
    Vector3 aim = vector3_add(camera.direction, right);
    aim = vector3_add(aim, vector3_scale(camera.up, manner->up * pixel));
    camera.direction = vector3_normalize(aim);
    double along = vector3_dot(camera.up, camera.direction);
    camera.up =
        vector3_normalize(vector3_subtract(camera.up, vector3_scale(camera.direction, along)));
    return camera;
}

/** Traces all blocks. @param taking The shot, but for its tracer. @param workers Who does it.
 *  @param[out] error What is wrong. @return false if anything is. */
static bool blocks_take(Taking *taking, Workers *workers, Error *error) {
    const Studio *studio = taking->studio;
    const Engine *engine = taking->manner->engine;
    const Pixels *pixels = studio->pixels;
    Tracer *tracer = engine->prepare(studio->scene, &taking->manner->trace, error);
    if (!tracer) {
        return false;
    }
    Scene scene = *studio->scene;
    if (taking->manner->right != 0 || taking->manner->up != 0) {
        scene.camera = camera_nudged(scene.camera, taking->manner, pixels->width);
    }
    engine->look(tracer, &scene, pixels->width, pixels->height);
    taking->tracer = tracer;
    double start = processor_seconds();
    workers_run(workers, pixels->blocks, block_take, taking);
    taking->shot->seconds = processor_seconds() - start;
    engine->release(tracer);
    return !is_stopped(studio) || error_set(error, STATUS_INTERRUPTED, "interrupted");
}

/** @return The sum of the rays of all blocks. @param counts Theirs. @param blocks How many. */
static RayCounts counts_sum(const RayCounts *counts, size_t blocks) {
    RayCounts sum = {0};
    for (size_t i = 0; i < blocks; i++) {
        sum.camera += counts[i].camera;
        sum.mirror += counts[i].mirror;
        sum.refract += counts[i].refract;
        sum.shadow += counts[i].shadow;
        sum.total += counts[i].total;
    }
    return sum;
}

bool shot_take(const Studio *studio, const Manner *manner, Shot *shot, Error *error) {
    const Pixels *pixels = studio->pixels;
    *shot = (Shot){.count = pixels->count * (size_t)manner->rays};
    shot->rgb = calloc(3 * shot->count + 1, sizeof *shot->rgb);
    shot->trails = calloc(shot->count + 1, sizeof *shot->trails);
    Taking taking = {.studio = studio, .manner = manner, .shot = shot};
    taking.counts = calloc(pixels->blocks, sizeof *taking.counts);
    bool has_room = shot->rgb && shot->trails && taking.counts;
    Workers *workers = has_room ? workers_create(studio->threads, error) : NULL;
    bool is_taken = workers && blocks_take(&taking, workers, error);
    if (is_taken) {
        shot->rays = counts_sum(taking.counts, pixels->blocks);
    } else {
        if (!has_room) {
            error_set(error, STATUS_FAILED, "no memory for %zu rays", shot->count);
        }
        shot_release(shot);
    }
    workers_destroy(workers);
    free(taking.counts);
    return is_taken;
}

void shot_release(Shot *shot) {
    free(shot->rgb);
    free(shot->trails);
    *shot = (Shot){0};
}
