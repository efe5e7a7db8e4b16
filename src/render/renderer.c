/**
 * @file
 * @brief The renderer: default settings, creation, and rendering in one call.
 */
#include "render/renderer_internal.h"

#include "render/precision_estimate.h"

#include <sched.h>
#include <stdlib.h>

int render_cpu_count(void) {
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) != 0) {
        return 1;
    }
    int count = CPU_COUNT(&set);
    return count < 1 ? 1 : count > THREADS_MAXIMUM ? THREADS_MAXIMUM : count;
}

RenderSettings precision_estimate_settings(const PrecisionEstimate *estimate, const Scene *scene) {
    /** The constant offset of the textbook tracer, scene units. */
    const double report_epsilon = 1e-4;
    int depth = scene->image.depth;
    return (RenderSettings){
        .engine = precision_estimate_engine(estimate),
        .threads = render_cpu_count(),
        .width = scene->image.width,
        .height = scene->image.height,
        .samples = scene->image.samples,
        .encoding = scene->image.encoding,
        .trace = {.depth = depth != IMAGE_DEPTH_AUTO ? depth
                           : estimate->depth > 0     ? DEPTH_MAXIMUM
                                                     : 0,
                  .offset = OFFSET_BOUND,
                  .epsilon = report_epsilon,
                  .cutoff = scene->image.cutoff,
                  .footprint = RENDER_FOOTPRINT},
    };
}

RenderSettings render_settings_default(const Scene *scene) {
    PrecisionEstimate estimate = precision_estimate_of(scene);
    return precision_estimate_settings(&estimate, scene);
}

/** Runs the tasks of a tracer on the thread pool. See #ParallelFor.run. */
static void parallel_for_thread_pool(void *thread_pool, size_t count, void (*task)(void *, size_t),
                                     void *context) {
    thread_pool_run(thread_pool, count, task, context);
}

bool renderer_is_adaptive(const Renderer *renderer) {
    return renderer->settings.samples > ADAPTIVE_SAMPLES_MINIMUM &&
           renderer->settings.sampling == SAMPLING_ADAPTIVE;
}

TraceSettings renderer_trace_settings(const Renderer *renderer, const Renderer *reuse_from) {
    const RenderSettings *settings = &renderer->settings;
    TraceSettings trace = settings->trace;
    trace.samples = settings->samples;
    trace.is_unlit = settings->lighting == LIGHTING_UNLIT;
    trace.encoding = settings->encoding;
    trace.parallel_for =
        (ParallelFor){renderer->thread_pool, settings->threads, parallel_for_thread_pool};
    trace.reuse_from =
        reuse_from && reuse_from->settings.engine == settings->engine ? reuse_from->tracer : NULL;
    return trace;
}

Scene renderer_lit_scene(const Renderer *renderer, const Scene *scene) {
    const Rgbd white = {1, 1, 1}, black = {0, 0, 0};
    Scene lit = *scene;
    if (renderer->settings.lighting == LIGHTING_NO_AMBIENT) {
        lit.ambient = black;
        lit.sky = (SceneSky){0};
    } else if (renderer->settings.lighting == LIGHTING_UNLIT) {
        lit.ambient = white;
    }
    return lit;
}

Renderer *renderer_create(const Scene *scene, const RenderSettings *settings, Error *error) {
    return renderer_create_reusing(NULL, scene, settings, error);
}

Renderer *renderer_create_reusing(const Renderer *reuse_from, const Scene *scene,
                                  const RenderSettings *settings, Error *error) {
    Renderer *renderer = calloc(1, sizeof *renderer);
    if (!renderer) {
        error_set(error, STATUS_FAILED, "no memory for a renderer");
        return NULL;
    }
    renderer->settings = *settings;
    background_renderer_init(&renderer->background);
    encoder_init(&renderer->encoder, (Encoding)settings->encoding);
    renderer->thread_pool = thread_pool_create(settings->threads, error);
    bool has_memory = !renderer_is_adaptive(renderer) ||
                      sample_accumulator_resize(&renderer->accumulator, settings->width,
                                                settings->height, true, error);
    if (renderer->thread_pool && has_memory) {
        TraceSettings trace = renderer_trace_settings(renderer, reuse_from);
        Scene lit = renderer_lit_scene(renderer, scene);
        lit.image.width = settings->width;
        lit.image.height = settings->height;
        renderer->tracer = settings->engine->create_tracer(&lit, &trace, error);
    }
    if (!renderer->tracer) {
        renderer_destroy(renderer);
        return NULL;
    }
    return renderer;
}

TracerStats renderer_contents(const Renderer *renderer) {
    return renderer->settings.engine->stats(renderer->tracer);
}

void renderer_destroy(Renderer *renderer) {
    if (renderer) {
        background_renderer_deinit(&renderer->background);
        layer_renderer_deinit(renderer);
        thread_pool_destroy(renderer->thread_pool);
        sample_accumulator_deinit(&renderer->accumulator);
        renderer->settings.engine->destroy(renderer->tracer);
        free(renderer);
    }
}

RenderPass renderer_make_pass(Renderer *renderer, int width, int height, const atomic_bool *stop) {
    return (RenderPass){.renderer = renderer,
                        .engine = renderer->settings.engine,
                        .tracer = renderer->tracer,
                        .encoder = &renderer->encoder,
                        .adaptive_encoder = &renderer->encoder,
                        .width = width,
                        .height = height,
                        .stop = stop,
                        .start = clock_now_seconds(),
                        .samples = renderer->settings.samples};
}

/** Renders with adaptive sampling, a pass from each update of the active pixels to the next.
 * @return false when it was stopped. */
static bool render_adaptive(Renderer *renderer, RenderPass *pass) {
    int samples = renderer->settings.samples;
    bool is_complete = true;
    pass->accumulator = &renderer->accumulator;
    pass->has_previous = true;
    for (int first = 0; is_complete && first < samples; first = pass->range.last_sample + 1) {
        int end = first == 0 ? adaptive_first_samples(samples) : 2 * first;
        pass->range = (PassRange){
            .stride = 1, .first_sample = first, .last_sample = (end < samples ? end : samples) - 1};
        is_complete = render_pass_run_samples(pass);
    }
    return is_complete;
}

RenderStats renderer_render(Renderer *renderer, const atomic_bool *stop, Picture *picture) {
    const RenderSettings *settings = &renderer->settings;
    RenderPass pass = renderer_make_pass(renderer, settings->width, settings->height, stop);
    pass.picture = picture;
    pass.range = (PassRange){.stride = 1, .first_sample = 0, .last_sample = settings->samples - 1};
    Encoder srgb;
    if (picture && picture->linear) {
        // Linear light has no steps: samples are compared in those of sRGB, as it will be seen.
        encoder_init(&srgb, ENCODING_SRGB);
        pass.adaptive_encoder = &srgb;
    }
    size_t pixels = (size_t)settings->width * (size_t)settings->height;
    atomic_store(&renderer->rays_done, 0);
    atomic_store(&renderer->rays_total, pixels * (size_t)settings->samples);
    if (picture) {
        picture->encoding = (Encoding)settings->encoding;
    }
    bool is_finished = renderer_is_adaptive(renderer) ? render_adaptive(renderer, &pass)
                                                      : render_pass_run_samples(&pass);
    RenderStats stats = render_pass_stats(&pass, is_finished);
    stats.samples = settings->samples;
    return stats;
}

PassProgress renderer_pass_progress(const Renderer *renderer) {
    size_t total = atomic_load(&renderer->tiles_total), done = atomic_load(&renderer->tiles_done);
    double seconds = clock_now_seconds() - atomic_load(&renderer->pass_start);
    return total ? (PassProgress){(double)done / (double)total, seconds} : (PassProgress){0, 0};
}

double renderer_progress(const Renderer *renderer) {
    size_t total = atomic_load(&renderer->rays_total);
    return total ? (double)atomic_load(&renderer->rays_done) / (double)total : 0;
}
