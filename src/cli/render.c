/**
 * @file
 * @brief `dioptre render`: one picture, no window.
 */
#include "assets/images/image_file.h"
#include "base/language.h"
#include "cli/commands.h"
#include "cli/render_metadata.h"

#include <libintl.h>
#include <stdio.h>

bool command_render(const RenderJob *job, const Scene *scene, Renderer **renderer, Picture *picture,
                    RenderStats *report, Error *error) {
    RenderSettings settings = command_render_settings(job->options, scene);
    if (!picture_init(picture, settings.width, settings.height, error) ||
        (image_file_is_linear(job->output) && !picture_allocate_linear(picture, error))) {
        return false;
    }
    Renderer *previous = *renderer;
    *renderer = renderer_create_reusing(previous, scene, &settings, error);
    renderer_destroy(previous);
    if (*renderer) {
        progress_set_renderer(job->progress, *renderer);
        *report = renderer_render(*renderer, interrupt_flag(), picture);
        progress_done(job->progress);
    }
    return *renderer != NULL;
}

bool command_write_image(const RenderJob *job, const Scene *scene, Picture *picture, Error *error) {
    RenderMetadata metadata;
    RenderSettings settings = command_render_settings(job->options, scene);
    render_metadata_init(&metadata, job->options, job->time, &settings);
    picture->metadata = metadata.entries;
    bool is_written = image_file_write(job->output, picture, error);
    picture->metadata = NULL;
    return is_written;
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

/** Renders a scene and writes the picture. */
static void render_scene(const Scene *scene, const Options *options, Error *error) {
    RenderJob job = {.options = options, .output = options->output, .time = options->time};
    Picture picture = {0};
    Renderer *renderer = NULL;
    RenderStats report = {0};
    job.progress = progress_begin(options, 1);
    bool is_done = command_render(&job, scene, &renderer, &picture, &report, error);
    renderer_destroy(renderer);
    progress_end(job.progress);
    is_done = is_done && command_write_image(&job, scene, &picture, error);
    picture_deinit(&picture);
    if (is_done) {
        command_print_unresolved(options, &report.rays);
    }
    if (is_done && !report.is_finished) {
        error_set(error, STATUS_INTERRUPTED, "interrupted: %s has %.0f %% of the picture",
                  options->output, 100 * report.progress);
    }
}

void cli_render(const Options *options, Error *error) {
    if (!options->output) {
        error_set(error, STATUS_USAGE, "render needs -o FILE");
        return;
    }
    if (!image_file_check(options->output, error)) {
        return;
    }
    Scene *scene = command_load_scene(options, error);
    if (scene) {
        render_scene(scene, options, error);
        scene_destroy(scene);
    }
}
