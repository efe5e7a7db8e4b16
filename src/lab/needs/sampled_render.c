/**
 * @file
 * @brief Taking shots.
 */
#include "lab/needs/sampled_render.h"

#include "render/render_pass.h"
#include "render/thread_pool.h"

#include <stdlib.h>
#include <time.h>

/** Rays of a block. */
enum { RAYS_PER_TILE = TILE_COLUMNS * TILE_ROWS };

/** A shot under way, shared by its threads. */
typedef struct SampleJob {
    const RenderContext *context; /**< What is shot. */
    const Variant *variant;       /**< How. */
    const Tracer *tracer;         /**< The manner's tracer. */
    SampledRender *render;        /**< Where it goes. */
    RayCounts *counts;            /**< Rays traced, for each block. */
} SampleJob;

/** @return The processor's time that this program has used, seconds. */
static double process_cpu_seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/** @return Whether a studio was stopped. */
static bool context_is_stopped(const RenderContext *render_context) {
    return render_context->stop && atomic_load_explicit(render_context->stop, memory_order_relaxed);
}

/**
 * Traces one sample of a block's pixels.
 * @param grid  The pixels, with their sample.
 * @param first  How many pixels come before.
 */
static void trace_sample(const SampleJob *job, PixelGrid *grid, size_t first, RayCounts *counts) {
    double planes[3 * RAYS_PER_TILE];
    size_t count = grid->selected_count;
    size_t index = (size_t)grid->sample * job->context->pixels->count + first;
    grid->path_hashes = job->render->path_hashes + index;
    job->variant->engine->trace(job->tracer, grid, planes, counts);
    for (size_t i = 0; i < 3 * count; i++) {
        job->render->rgb[3 * (index + i % count) + i / count] = planes[i];
    }
}

/** Traces a block. See #ThreadPoolTask. */
static void render_tile(void *context, size_t index) {
    const SampleJob *job = context;
    PixelGrid grid = pixel_set_tile_grid(job->context->pixels, index);
    for (int sample = 0; grid.selected_count > 0 && sample < job->variant->samples_traced;
         sample++) {
        if (context_is_stopped(job->context)) {
            return;
        }
        grid.sample = sample;
        trace_sample(job, &grid, job->context->pixels->tile_first[index], &job->counts[index]);
    }
}

/**
 * @return A camera that is turned by a part of a pixel.
 * @param width  Pixels of the picture.
 */
static SceneCamera camera_rotated(SceneCamera camera, const Variant *variant, int width) {
    double pixel = 2 * tan(camera.fov / 2 * (M_PI / 180)) / width;
    Vec3d right = vec3d_scale(scene_camera_right(&camera), variant->shift_right * pixel);
    Vec3d aim = vec3d_add(camera.direction, right);
    aim = vec3d_add(aim, vec3d_scale(camera.up, variant->shift_up * pixel));
    camera.direction = vec3d_normalize(aim);
    double along = vec3d_dot(camera.up, camera.direction);
    camera.up = vec3d_normalize(vec3d_subtract(camera.up, vec3d_scale(camera.direction, along)));
    return camera;
}

/**
 * Traces all blocks.
 * @param job  The shot, but for its tracer.
 * @return false if anything is.
 */
static bool render_tiles(SampleJob *job, ThreadPool *workers, Error *error) {
    const RenderContext *render_context = job->context;
    const Engine *engine = job->variant->engine;
    const PixelSet *pixels = render_context->pixels;
    Tracer *tracer = engine->create_tracer(render_context->scene, &job->variant->trace, error);
    if (!tracer) {
        return false;
    }
    Scene scene = *render_context->scene;
    if (job->variant->shift_right != 0 || job->variant->shift_up != 0) {
        scene.camera = camera_rotated(scene.camera, job->variant, pixels->width);
    }
    engine->set_view(tracer, &scene, pixels->width, pixels->height);
    job->tracer = tracer;
    double start = process_cpu_seconds();
    thread_pool_run(workers, pixels->tile_count, render_tile, job);
    job->render->cpu_seconds = process_cpu_seconds() - start;
    engine->destroy(tracer);
    return !context_is_stopped(render_context) ||
           error_set(error, STATUS_INTERRUPTED, "interrupted");
}

/** @return The sum of the rays of all blocks. */
static RayCounts sum_counts(const RayCounts *counts, size_t blocks) {
    RayCounts sum = {0};
    for (size_t i = 0; i < blocks; i++) {
        sum.camera += counts[i].camera;
        sum.reflection += counts[i].reflection;
        sum.refraction += counts[i].refraction;
        sum.shadow += counts[i].shadow;
        sum.total_reflection += counts[i].total_reflection;
    }
    return sum;
}

bool render_samples(const RenderContext *render_context, const Variant *variant,
                    SampledRender *render, Error *error) {
    const PixelSet *pixels = render_context->pixels;
    *render = (SampledRender){.ray_count = pixels->count * (size_t)variant->samples_traced};
    render->rgb = calloc(3 * render->ray_count + 1, sizeof *render->rgb);
    render->path_hashes = calloc(render->ray_count + 1, sizeof *render->path_hashes);
    SampleJob job = {.context = render_context, .variant = variant, .render = render};
    job.counts = calloc(pixels->tile_count, sizeof *job.counts);
    bool has_room = render->rgb && render->path_hashes && job.counts;
    ThreadPool *workers = has_room ? thread_pool_create(render_context->threads, error) : NULL;
    bool is_taken = workers && render_tiles(&job, workers, error);
    if (is_taken) {
        render->ray_counts = sum_counts(job.counts, pixels->tile_count);
    } else {
        if (!has_room) {
            error_set(error, STATUS_FAILED, "no memory for %zu rays", render->ray_count);
        }
        sampled_render_deinit(render);
    }
    thread_pool_destroy(workers);
    free(job.counts);
    return is_taken;
}

void sampled_render_deinit(SampledRender *render) {
    free(render->rgb);
    free(render->path_hashes);
    *render = (SampledRender){0};
}
