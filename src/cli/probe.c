/**
 * @file
 * @brief `dioptre probe`: the tree of rays of one pixel.
 */
#include "cli/probe.h"
#include "cli/commands.h"
#include "dioptre/language.h"
#include "dioptre/ray_chart.h"

#include <libintl.h>
#include <stdio.h>
#include <stdlib.h>

/** @return A column or a row. @param name Which of the two. @param text What was said.
 *  @param size Pixels of the picture that way. @param[out] error What is wrong; then -1. */
static int read_pixel(const char *name, const char *text, int size, Error *error) {
    char *end = NULL;
    long place = strtol(text, &end, 10);
    if (end == text || *end) {
        error_set(error, STATUS_USAGE, "%s must be a whole number of pixels, not '%s'", name, text);
        return -1;
    }
    if (place < 0 || place >= size) {
        error_set(error, STATUS_USAGE,
                  "%s must be from 0 to %d, as the picture has %d pixels that way, not '%s'", name,
                  size - 1, size, text);
        return -1;
    }
    return (int)place;
}

/** Reads the pixel. @param options The command line. @param[out] report Gets it, and the picture's
 *  size. @param[out] error What is wrong. @return Whether it is one. */
static bool read_place(const Options *options, ProbeReport *report, Error *error) {
    report->x = read_pixel("X", options->arguments[1], report->settings.width, error);
    report->y =
        report->x < 0 ? -1 : read_pixel("Y", options->arguments[2], report->settings.height, error);
    return report->y >= 0;
}

/** @return How a scene is probed: as `render` draws it, with one ray a pixel where nothing is said.
 *  @param options The command line. @param scene The scene. */
static RenderSettings probe_settings(const Options *options, const Scene *scene) {
    RenderSettings settings = command_settings(options, scene);
    settings.samples = options->samples ? options->samples : 1;
    settings.threads = 1;
    return settings;
}

/** Draws the rays as seen from beside. @param report What is told. @param renderer Who traced them.
 *  @param path The SVG file to write. @param[out] error What is wrong. @return Whether it is there.
 */
static bool probe_draw(const ProbeReport *report, const Renderer *renderer, const char *path,
                       Error *error) {
    /** Bytes of a title: a long path and a few numbers. */
    enum { TITLE_SIZE = 512 };
    char title[TITLE_SIZE];
    ProbeSteps pixel = probe_steps(report);
    snprintf(title, sizeof title, gettext("%.400s: pixel %d %d, colour #%02x%02x%02x"),
             report->path, report->x, report->y, (unsigned)pixel.step[0], (unsigned)pixel.step[1],
             (unsigned)pixel.step[2]);
    RayChart chart = {report->scene, &report->settings, renderer, report->probe, title};
    return ray_chart_write(&chart, path, error);
}

/** Traces the pixel, and tells. @param options The command line. @param report What is told; its
 *  scene, settings and pixel are there. @param[out] error What is wrong. */
static void probe_tell(const Options *options, ProbeReport *report, Error *error) {
    Renderer *renderer = renderer_create(report->scene, &report->settings, error);
    Probe probe = {0};
    report->probe = &probe;
    if (renderer && renderer_probe(renderer, report->x, report->y, &probe, error)) {
        bool is_drawn = !options->svg || probe_draw(report, renderer, options->svg, error);
        if (is_drawn && options->json) {
            probe_print_json(report);
        } else if (is_drawn && !options->quiet) {
            probe_print(report);
        }
    }
    probe_release(&probe);
    renderer_destroy(renderer);
}

/** Probes a pixel. See #Command.run. @param options The command line.
 *  @param[out] error What is wrong. @return The exit status. */
static int probe_run(const Options *options, Error *error) {
    Scene *scene = command_scene(options, error);
    if (!scene) {
        return (int)error->status;
    }
    ProbeReport report = {
        .scene = scene, .path = options->arguments[0], .settings = probe_settings(options, scene)};
    if (read_place(options, &report, error)) {
        probe_tell(options, &report, error);
    }
    scene_destroy(scene);
    return (int)error->status;
}

const Command probe_command = {.name = "probe",
                               .usage = N_("SCENE X Y"),
                               .help = N_("tells the rays of one pixel, and how they add up to it"),
                               .accepts = "sADtjEOXBYJq",
                               .arguments = 3,
                               .run = probe_run};
