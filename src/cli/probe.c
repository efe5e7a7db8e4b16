/**
 * @file
 * @brief `dioptre probe`: the ray tree of one pixel.
 */
#include "cli/probe.h"
#include "base/language.h"
#include "cli/commands.h"
#include "lab/charts/ray_chart.h"

#include <libintl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/**
 * @return A column or a row; -1 if it is wrong.
 * @param name  Its name in errors.
 * @param size  Pixels of the picture in that direction.
 */
static int read_pixel(const char *name, const char *text, int size, Error *error) {
    char *end = NULL;
    long coordinate = strtol(text, &end, 10);
    if (end == text || *end) {
        error_set(error, STATUS_USAGE, "%s must be a whole number of pixels, not '%s'", name, text);
        return -1;
    }
    if (coordinate < 0 || coordinate >= size) {
        error_set(error, STATUS_USAGE,
                  "%s must be from 0 to %d, as the picture has %d pixels that way, not '%s'", name,
                  size - 1, size, text);
        return -1;
    }
    return (int)coordinate;
}

/**
 * Parses the pixel position.
 * @param[in,out] report  Has the size of the picture; gets the position.
 * @return false if it is wrong.
 */
static bool read_pixel_position(const Options *options, ProbeReport *report, Error *error) {
    report->x = read_pixel("X", options->arguments[1], report->settings.width, error);
    report->y =
        report->x < 0 ? -1 : read_pixel("Y", options->arguments[2], report->settings.height, error);
    return report->y >= 0;
}

/**
 * Writes a side view of the rays as SVG.
 * @param path  The file.
 * @return false on failure.
 */
static bool probe_write_svg(const ProbeReport *report, const Renderer *renderer, const char *path,
                            Error *error) {
    /** Bytes of a title: a long path and a few numbers. */
    enum { TITLE_SIZE = 512 };
    char title[TITLE_SIZE];
    ProbePixel pixel = probe_pixel(report);
    snprintf(title, sizeof title, gettext("%.400s: pixel %d %d, colour #%02x%02x%02x"),
             report->path, report->x, report->y, (unsigned)pixel.channels[0],
             (unsigned)pixel.channels[1], (unsigned)pixel.channels[2]);
    interrupt_defer(); // The drawing is still written after a signal: no temporary file is left.
    RayChart chart = {report->scene, &report->settings,
                      renderer,      report->tree,
                      title,         report->ray < 0 ? RAY_CHART_NO_RAY : (size_t)report->ray};
    return ray_chart_write(&chart, path, error);
}

/** @return Whether the chosen ray exists, or none is chosen. */
static bool check_ray(const ProbeReport *report, Error *error) {
    return report->ray < (int)report->tree->count ||
           error_set(error, STATUS_USAGE, "--ray must be from 0 to %zu at this pixel, not %d",
                     report->tree->count - 1, report->ray);
}

/** Records the ray tree of a pixel and prints it. @param report The pixel; gets the tree. */
static void probe_trace_and_print(const Options *options, ProbeReport *report, Error *error) {
    Renderer *renderer = renderer_create(report->scene, &report->settings, error);
    RayTree tree = {0};
    report->tree = &tree;
    if (renderer && renderer_record_ray_tree(renderer, report->x, report->y, &tree, error) &&
        check_ray(report, error)) {
        bool is_drawn = !options->svg || probe_write_svg(report, renderer, options->svg, error);
        if (is_drawn && options->json) {
            probe_print_json(report);
        } else if (is_drawn && !options->quiet) {
            report->ray < 0 ? probe_print(report) : probe_print_ray(report);
        }
    }
    ray_tree_deinit(&tree);
    renderer_destroy(renderer);
}

/** @return Whether the name of a drawing is free or ends in .svg: that of a scene would be
 *  replaced. */
static bool check_svg_name(const char *path, Error *error) {
    const char *name = strrchr(path, '/'), *extension = strrchr(name ? name : path, '.');
    return !extension || strcasecmp(extension, ".svg") == 0 ||
           error_set(error, STATUS_USAGE, "--svg writes a .svg file, not '%s'", path);
}

void cli_probe(const Options *options, Error *error) {
    ProbeReport report = {.path = options->arguments[0], .ray = options->ray};
    if (options->svg && !check_svg_name(options->svg, error)) {
        return;
    }
    Scene *scene = command_load_scene(options, &report.settings, error);
    if (!scene) {
        return;
    }
    report.scene = scene;
    report.ray = options->ray;
    // The settings are those of `render`, but one sample per pixel by default.
    report.settings.samples = options->samples ? options->samples : 1;
    report.settings.threads = 1;
    if (read_pixel_position(options, &report, error)) {
        probe_trace_and_print(options, &report, error);
    }
    scene_destroy(scene);
}
