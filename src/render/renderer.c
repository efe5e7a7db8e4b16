/**
 * @file
 * @brief The renderer: settings, life, and drawing at once.
 */
#include "render/renderer.h"

#include "dioptre/forecast.h"

#include <sched.h>
#include <stdlib.h>

int render_processors(void) {
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) != 0) {
        return 1;
    }
    int count = CPU_COUNT(&set);
    return count < 1 ? 1 : count > THREADS_MAXIMUM ? THREADS_MAXIMUM : count;
}

RenderSettings render_settings_default(const Scene *scene) {
    /** Scene units: the size of report C's constant. */
    const double report_epsilon = 1e-4;
    /** Of half a pixel, that marched rays may end before a surface (doc/marching.md). */
    const double footprint = 0.125;
    Forecast forecast = forecast_of(scene);
    int depth = scene->image.depth;
    return (RenderSettings){
        .engine = forecast_engine(&forecast),
        .threads = render_processors(),
        .width = scene->image.width,
        .height = scene->image.height,
        .samples = scene->image.samples,
        .encoding = scene->image.encoding,
        .trace = {.depth = depth == IMAGE_DEPTH_NEEDED ? forecast.depth : depth,
                  .offset = OFFSET_BOUND,
                  .epsilon = report_epsilon,
                  .footprint = footprint},
    };
}

/** Lets workers do what a crew is asked to. See #Crew.run. @param workers The workers.
 *  @param count Pieces. @param job Does one. @param context Handed to it. */
static void crew_workers_run(void *workers, size_t count, void (*job)(void *, size_t),
                             void *context) {
    workers_run(workers, count, job, context);
}

bool renderer_judges(const Renderer *renderer) {
    return renderer->settings.samples > TALLY_LEAST &&
           renderer->settings.sampling == SAMPLING_ADAPTIVE;
}

TraceSettings renderer_trace_settings(const Renderer *renderer, const Renderer *former) {
    const RenderSettings *settings = &renderer->settings;
    TraceSettings trace = settings->trace;
    trace.samples = settings->samples;
    trace.crew = (Crew){renderer->workers, settings->threads, crew_workers_run};
    trace.former = former && former->settings.engine == settings->engine ? former->tracer : NULL;
    return trace;
}

Scene renderer_scene(const Renderer *renderer, const Scene *scene) {
    const Color white = {1, 1, 1}, black = {0, 0, 0};
    Scene lit = *scene;
    if (renderer->settings.light == LIGHT_MODE_LAMPS) {
        lit.ambient = black;
    } else if (renderer->settings.light == LIGHT_MODE_NONE) {
        lit.ambient = white;
        lit.light_count = 0;
    }
    return lit;
}

Renderer *renderer_create(const Scene *scene, const RenderSettings *settings, Error *error) {
    return renderer_create_after(NULL, scene, settings, error);
}

Renderer *renderer_create_after(const Renderer *former, const Scene *scene,
                                const RenderSettings *settings, Error *error) {
    Renderer *renderer = calloc(1, sizeof *renderer);
    if (!renderer) {
        error_set(error, STATUS_FAILED, "no memory for a renderer");
        return NULL;
    }
    renderer->settings = *settings;
    background_init(&renderer->background);
    encoder_init(&renderer->encoder, (Encoding)settings->encoding);
    renderer->workers = workers_create(settings->threads, error);
    bool has_room = !renderer_judges(renderer) ||
                    tally_resize(&renderer->tally, settings->width, settings->height, true, error);
    if (renderer->workers && has_room) {
        TraceSettings trace = renderer_trace_settings(renderer, former);
        Scene lit = renderer_scene(renderer, scene);
        renderer->tracer = settings->engine->prepare(&lit, &trace, error);
    }
    if (!renderer->tracer) {
        renderer_destroy(renderer);
        return NULL;
    }
    settings->engine->look(renderer->tracer, scene, settings->width, settings->height);
    return renderer;
}

TracerContents renderer_contents(const Renderer *renderer) {
    return renderer->settings.engine->contents(renderer->tracer);
}

void renderer_destroy(Renderer *renderer) {
    if (renderer) {
        background_release(&renderer->background);
        layering_release(renderer);
        workers_destroy(renderer->workers);
        tally_release(&renderer->tally);
        renderer->settings.engine->release(renderer->tracer);
        free(renderer);
    }
}

Drawing renderer_drawing(Renderer *renderer, int width, int height, const atomic_bool *stop) {
    return (Drawing){.engine = renderer->settings.engine,
                     .tracer = renderer->tracer,
                     .encoder = &renderer->encoder,
                     .judge = &renderer->encoder,
                     .width = width,
                     .height = height,
                     .stop = stop,
                     .samples = renderer->settings.samples,
                     .done = &renderer->done,
                     .all = &renderer->all};
}

/**
 * Draws a picture whose pixels are judged, by passes from one judgement to the next.
 * @param renderer  The renderer.
 * @param drawing   The drawing.
 * @return false when it was stopped.
 */
static bool draw_judged(Renderer *renderer, Drawing *drawing) {
    int samples = renderer->settings.samples;
    bool is_whole = true;
    drawing->tally = &renderer->tally;
    drawing->is_shown = true;
    for (int first = 0; is_whole && first < samples; first = drawing->pass.last + 1) {
        int next = first == 0 ? tally_first(samples) : 2 * first;
        drawing->pass = (Pass){1, first, (next < samples ? next : samples) - 1};
        is_whole = drawing_pass(drawing, renderer->workers);
    }
    return is_whole;
}

RenderReport renderer_draw(Renderer *renderer, const atomic_bool *stop, Picture *picture) {
    const RenderSettings *settings = &renderer->settings;
    double start = clock_seconds();
    Drawing drawing = renderer_drawing(renderer, settings->width, settings->height, stop);
    drawing.picture = picture;
    drawing.pass = (Pass){.stride = 1, .first = 0, .last = settings->samples - 1};
    Encoder seen;
    if (picture && picture->light) {
        // Linear light has no steps of its own: what counts are those in which it will be seen.
        encoder_init(&seen, ENCODING_SRGB);
        drawing.judge = &seen;
    }
    size_t pixels = (size_t)settings->width * (size_t)settings->height;
    atomic_store(&renderer->done, 0);
    atomic_store(&renderer->all, pixels * (size_t)settings->samples);
    if (picture) {
        picture->encoding = (Encoding)settings->encoding;
    }
    bool is_finished = renderer_judges(renderer) ? draw_judged(renderer, &drawing)
                                                 : drawing_pass(&drawing, renderer->workers);
    return (RenderReport){.seconds = clock_seconds() - start,
                          .rays = drawing_rays(&drawing),
                          .stride = 1,
                          .samples = settings->samples,
                          .share = renderer_progress(renderer),
                          .is_finished = is_finished};
}

double renderer_progress(const Renderer *renderer) {
    size_t all = atomic_load(&renderer->all);
    return all ? (double)atomic_load(&renderer->done) / (double)all : 0;
}
