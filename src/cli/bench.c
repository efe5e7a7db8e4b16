/**
 * @file
 * @brief `dioptre bench`: how fast a scene is drawn.
 */
#include "cli/commands.h"
#include "dioptre/language.h"

#include <libintl.h>
#include <stdio.h>
#include <stdlib.h>

/** Pictures that are timed when nothing is said. */
#define BENCH_FRAMES 10

/** What was measured. */
typedef struct Bench {
    int frames;       /**< Pictures timed. */
    double ms_min;    /**< Fastest, milliseconds. */
    double ms_median; /**< Median, milliseconds. */
    uint64_t rays;    /**< Rays a picture. */
    uint64_t camera;  /**< Those of them that leave the camera. */
} Bench;

/** @return Order of two doubles, for qsort. @param a One. @param b The other. */
static int compare_doubles(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/** Draws, or casts, one picture. @param renderer The renderer. @param rays Which rays.
 *  @return How it went. */
static RenderReport bench_frame(Renderer *renderer, BenchRays rays) {
    return rays == BENCH_IMAGE ? renderer_draw(renderer, interrupt_flag(), NULL)
                               : renderer_cast(renderer, rays == BENCH_RANDOM);
}

/**
 * Times pictures, after one that is not counted.
 * @param renderer    The renderer.
 * @param rays        Which rays.
 * @param frames      How many pictures.
 * @param[out] bench  What was measured.
 * @param[out] error  What is wrong.
 * @return false when interrupted or without memory.
 */
static bool bench_measure(Renderer *renderer, BenchRays rays, int frames, Bench *bench,
                          Error *error) {
    double *ms = calloc((size_t)frames, sizeof *ms);
    if (!ms) {
        return error_set(error, STATUS_FAILED, "no memory for %d times", frames);
    }
    RenderReport report = bench_frame(renderer, rays);
    for (int i = 0; i < frames && report.is_finished; i++) {
        report = bench_frame(renderer, rays);
        ms[i] = 1e3 * report.seconds;
    }
    qsort(ms, (size_t)frames, sizeof *ms, compare_doubles);
    *bench = (Bench){.frames = frames,
                     .ms_min = ms[0],
                     .ms_median = (ms[(frames - 1) / 2] + ms[frames / 2]) / 2,
                     .camera = report.rays.camera,
                     .rays = ray_counts_sum(&report.rays)};
    free(ms);
    return report.is_finished || error_set(error, STATUS_INTERRUPTED, "interrupted");
}

/** Prints what was measured. @param bench It. @param settings Of what. @param options How. */
static void bench_print(const Bench *bench, const RenderSettings *settings,
                        const Options *options) {
    double mrays = (double)bench->rays / (1e3 * bench->ms_median);
    if (options->json) {
        printf("{\"scene\": ");
        json_print_string(options->arguments[0], stdout);
        printf(", \"engine\": \"%s\", \"threads\": %d, \"width\": %d, \"height\": %d, "
               "\"frames\": %d, \"ms_min\": %.6g, \"ms_median\": %.6g, \"rays\": %llu, "
               "\"mrays_per_s\": %.6g, \"samples_per_pixel\": %.6g}\n",
               settings->engine->name, settings->threads, settings->width, settings->height,
               bench->frames, bench->ms_min, bench->ms_median, (unsigned long long)bench->rays,
               mrays, (double)bench->camera / settings->width / settings->height);
    } else {
        printf(ngettext("%s: %s, %d thread, ", "%s: %s, %d threads, ",
                        (unsigned long)settings->threads),
               options->arguments[0], settings->engine->name, settings->threads);
        printf(gettext("%d x %d: %.2f ms (fastest %.2f), %llu rays, %.1f Mrays/s\n"),
               settings->width, settings->height, bench->ms_median, bench->ms_min,
               (unsigned long long)bench->rays, mrays);
    }
}

/**
 * Finds how many pictures are to be timed.
 * @param options      The command line.
 * @param[out] frames  How many.
 * @param[out] error   That a range was given, or none.
 * @return Whether it is a number.
 */
static bool bench_frames(const Options *options, int *frames, Error *error) {
    const FrameRange *range = &options->frames;
    *frames = range->step ? range->first : BENCH_FRAMES;
    return (range->first == range->last && *frames > 0) ||
           error_set(error, STATUS_USAGE, "bench --frames takes how many, at least 1");
}

/** Times a scene. See #Command.run. @param options The command line.
 *  @param[out] error What is wrong. @return The exit status. */
static int bench_run(const Options *options, Error *error) {
    int frames;
    Scene *scene = bench_frames(options, &frames, error) ? command_scene(options, error) : NULL;
    if (!scene) {
        return (int)error->status;
    }
    RenderSettings settings = command_settings(options, scene);
    Renderer *renderer = renderer_create(scene, &settings, error);
    Bench bench = {0};
    if (renderer && bench_measure(renderer, options->rays, frames, &bench, error)) {
        bench_print(&bench, &settings, options);
    }
    renderer_destroy(renderer);
    scene_destroy(scene);
    return (int)error->status;
}

const Command bench_command = {.name = "bench",
                               .usage = N_("SCENE"),
                               .help = N_("times the drawing of a scene"),
                               .accepts = "sASDtjEOXBFRJq",
                               .arguments = 1,
                               .run = bench_run};
