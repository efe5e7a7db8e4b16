/**
 * @file
 * @brief `dioptre bench`: rendering speed of a scene.
 */
#include "base/json.h"
#include "base/language.h"
#include "base/median.h"
#include "base/sanitize.h"
#include "cli/commands.h"

#include <libintl.h>
#include <stdio.h>
#include <stdlib.h>

/** Default number of pictures that are timed. */
#define BENCH_FRAMES_DEFAULT 10

/** The measurements. */
typedef struct BenchResult {
    int frames;           /**< Pictures timed. */
    double ms_min;        /**< Fastest, milliseconds. */
    double ms_median;     /**< Median, milliseconds. */
    uint64_t rays;        /**< Rays per picture. */
    uint64_t camera_rays; /**< Camera rays per picture. */
} BenchResult;

/** Renders one picture, or traces its primary or random rays. */
static RenderStats bench_frame(Renderer *renderer, BenchRays rays) {
    return rays == BENCH_IMAGE ? renderer_render(renderer, interrupt_flag(), NULL)
                               : renderer_benchmark_rays(renderer, rays == BENCH_RANDOM);
}

/** Times pictures, after one that is not counted. @param progress Counts these. @return false when
 *  interrupted or without memory. */
static bool bench_measure(Renderer *renderer, BenchRays rays, int frames, Progress *progress,
                          BenchResult *result, Error *error) {
    double *ms = calloc((size_t)frames, sizeof *ms);
    if (!ms) {
        return error_set(error, STATUS_FAILED, "no memory for %d times", frames);
    }
    RenderStats report = bench_frame(renderer, rays);
    for (int i = 0; i < frames && report.is_finished; i++) {
        report = bench_frame(renderer, rays);
        ms[i] = 1e3 * report.seconds;
        progress_done(progress);
    }
    double median = median_sort(ms, (size_t)frames);
    *result = (BenchResult){.frames = frames,
                            .ms_min = ms[0],
                            .ms_median = median,
                            .camera_rays = report.rays.camera,
                            .rays = ray_counts_sum(&report.rays)};
    free(ms);
    return report.is_finished || error_set(error, STATUS_INTERRUPTED, "interrupted");
}

/** Prints the measurements. */
static void bench_print(const BenchResult *result, const RenderSettings *settings,
                        const Options *options) {
    /** Significant digits of numbers in JSON. */
    const int digits = 6;
    double mrays = (double)result->rays / (1e3 * result->ms_median);
    if (options->json) {
        JsonWriter json = {.stream = stdout};
        json_object_begin(&json, NULL);
        json_string(&json, "scene", options->arguments[0]);
        json_string(&json, "engine", settings->engine->name);
        json_integer(&json, "threads", settings->threads);
        json_integer(&json, "width", settings->width);
        json_integer(&json, "height", settings->height);
        json_integer(&json, "frames", result->frames);
        json_number(&json, "ms_min", result->ms_min, digits);
        json_number(&json, "ms_median", result->ms_median, digits);
        json_count(&json, "rays", result->rays);
        json_number(&json, "mrays_per_s", mrays, digits);
        json_number(&json, "samples_per_pixel",
                    (double)result->camera_rays / settings->width / settings->height, digits);
        json_line_end(&json);
    } else if (!options->quiet) {
        sanitize_print_line(options->arguments[0], stdout);
        printf(
            ngettext(": %s, %d thread, ", ": %s, %d threads, ", (unsigned long)settings->threads),
            settings->engine->name, settings->threads);
        printf(gettext("%d x %d: %.2f ms (fastest %.2f), %llu rays, %.1f Mrays/s\n"),
               settings->width, settings->height, result->ms_median, result->ms_min,
               (unsigned long long)result->rays, mrays);
    }
}

/**
 * Reads the number of pictures from `--frames`.
 * @return false if that is a range or 0.
 */
static bool bench_frame_count(const Options *options, int *frames, Error *error) {
    const FrameRange *range = &options->frames;
    *frames = range->step ? range->first : BENCH_FRAMES_DEFAULT;
    return (range->first == range->last && *frames > 0) ||
           error_set(error, STATUS_USAGE, "bench --frames takes how many, at least 1");
}

void cli_bench(const Options *options, Error *error) {
    int frames;
    RenderSettings settings;
    Scene *scene = bench_frame_count(options, &frames, error)
                       ? command_load_scene(options, &settings, error)
                       : NULL;
    if (!scene) {
        return;
    }
    Renderer *renderer = renderer_create(scene, &settings, error);
    BenchResult result = {0};
    Progress *progress = renderer ? progress_begin(options, PROGRESS_FRAMES, frames) : NULL;
    bool is_measured = renderer && bench_measure(renderer, (BenchRays)options->rays, frames,
                                                 progress, &result, error);
    progress_end(progress);
    if (is_measured) {
        bench_print(&result, &settings, options);
    }
    renderer_destroy(renderer);
    scene_destroy(scene);
}
