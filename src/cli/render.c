/**
 * @file
 * @brief `dioptre render`: one picture, no window.
 */
#include "assets/images/image_file.h"
#include "base/language.h"
#include "base/output_path.h"
#include "cli/commands.h"
#include "cli/render_metadata.h"

#include <libintl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

bool command_render(const RenderJob *job, const Scene *scene, Renderer **renderer, Picture *picture,
                    RenderStats *report, Error *error) {
    const RenderSettings *settings = &job->settings;
    if (!picture_init(picture, settings->width, settings->height, error) ||
        (image_file_is_linear(job->output) && !picture_allocate_linear(picture, error))) {
        return false;
    }
    Renderer *previous = *renderer;
    *renderer = renderer_create_reusing(previous, scene, settings, error);
    renderer_destroy(previous);
    if (*renderer) {
        if (!previous) {
            command_forecast_light(job->options, *renderer);
        }
        progress_set_renderer(job->progress, *renderer);
        *report = renderer_render(*renderer, interrupt_flag(), picture);
        report->is_finished ? progress_done(job->progress)
                            : progress_stop(job->progress, report->progress);
    }
    return *renderer != NULL;
}

bool command_write_file(const RenderJob *job, const Picture *picture, Error *error) {
    return job->options->no_sync ? image_file_write_unsynced(job->output, picture, error)
                                 : image_file_write(job->output, picture, error);
}

bool command_write_image(const RenderJob *job, Picture *picture, Error *error) {
    RenderMetadata metadata;
    render_metadata_init(&metadata, job->options, job->time, &job->settings);
    picture->metadata = metadata.entries;
    bool is_written = command_write_file(job, picture, error);
    picture->metadata = NULL;
    return is_written;
}

void command_forecast_light(const Options *options, Renderer *renderer) {
    if (options->quiet) {
        return;
    }
    RayCounts rays = renderer_forecast_light(renderer, FORECAST_SECONDS, interrupt_flag());
    if (rays.unresolved > 0) {
        double percent = 100 * (double)rays.unresolved / (double)rays.camera;
        fprintf(stderr,
                gettext("dioptre: some %.2g %% of the camera rays will lack light, of at most %.2g "
                        "steps of 255: reflections go on and on\n"),
                percent, rays.unresolved_steps);
    }
}

void command_print_unresolved(const Options *options, const RayCounts *rays) {
    if (rays->unresolved > 0 && !options->quiet) {
        double percent = 100 * (double)rays->unresolved / (double)rays->camera;
        fprintf(stderr,
                gettext("dioptre: %.2g %% of the camera rays lack light, of at most %.2g steps of "
                        "255: reflections went on and on\n"),
                percent, rays->unresolved_steps);
    }
}

/** What a part of a picture has before its extension. */
#define PART_SUFFIX ".part"

/**
 * Finds the file for a part of a picture: `NAME.part.EXT` beside an old picture, which is better
 * than a part of the new one, or the file itself where there is none.
 * @param path       The file of the whole picture.
 * @param[out] part  The file of the part. A name is cut to NAME_MAX bytes.
 * @return Whether it is another file. Where its path would be too long, it is empty.
 */
static bool part_path(const char *path, char part[PATH_MAX]) {
    OutputPath target;
    bool is_beside =
        output_path_resolve(&target, path) && target.mode != 0 && !output_path_is_direct(&target);
    const char *name = path + output_path_dir_length(path);
    const char *extension = strrchr(name, '.'); // There is one: it names the format.
    if (!is_beside || !extension) {
        snprintf(part, PATH_MAX, "%s", path);
        return false;
    }
    int length = (int)(extension - name);
    int longest = NAME_MAX - (int)strlen(PART_SUFFIX) - (int)strlen(extension);
    int written = snprintf(part, PATH_MAX, "%.*s%s%s",
                           (int)(name - path) + (length < longest ? length : longest), path,
                           PART_SUFFIX, extension);
    if (written >= PATH_MAX) {
        part[0] = '\0'; // A cut path would name another file.
    }
    return true;
}

/**
 * Writes what there is of a picture after an interruption.
 * @param[out] error  Where it is (#STATUS_INTERRUPTED), or why it is not written.
 */
static void write_part(const RenderJob *job, Picture *picture, const RenderStats *report,
                       Error *error) {
    char path[PATH_MAX];
    RenderJob part = *job;
    bool is_beside = part_path(job->output, path);
    part.output = path;
    if (path[0] == '\0') {
        error_set(error, STATUS_INTERRUPTED, "interrupted");
        return;
    }
    if (!command_write_image(&part, picture, error)) {
        return;
    }
    double percent = 100 * report->progress;
    is_beside ? error_set(error, STATUS_INTERRUPTED,
                          "interrupted: %s has %.0f %% of the picture; %s is the old one", path,
                          percent, job->output)
              : error_set(error, STATUS_INTERRUPTED, "interrupted: %s has %.0f %% of the picture",
                          path, percent);
}

/** Renders a scene and writes the picture. */
static void render_scene(const Scene *scene, const Options *options, const RenderSettings *settings,
                         Error *error) {
    RenderJob job = {.options = options,
                     .output = options->output,
                     .time = options_time(options),
                     .settings = *settings};
    Picture picture = {0};
    Renderer *renderer = NULL;
    RenderStats report = {0};
    job.progress = progress_begin(options, PROGRESS_FRAMES, 1);
    bool is_done = command_render(&job, scene, &renderer, &picture, &report, error);
    renderer_destroy(renderer);
    progress_end(job.progress);
    if (is_done && !report.is_finished) {
        write_part(&job, &picture, &report, error);
    } else if (is_done && command_write_image(&job, &picture, error)) {
        command_print_unresolved(options, &report.rays);
    }
    picture_deinit(&picture);
}

void cli_render(const Options *options, Error *error) {
    if (!options->output) {
        error_set(error, STATUS_USAGE, "render needs -o FILE");
        return;
    }
    if (!image_file_check(options->output, error)) {
        return;
    }
    RenderSettings settings;
    Scene *scene = command_load_scene(options, &settings, error);
    if (scene) {
        render_scene(scene, options, &settings, error);
        scene_destroy(scene);
    }
}
