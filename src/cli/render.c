/**
 * @file
 * @brief `dioptre render`: one picture, no window.
 */
#include "cli/commands.h"
#include "cli/notes.h"
#include "dioptre/image_file.h"

#include <stdio.h>

/**
 * Draws a scene into a picture.
 * @param scene        The scene.
 * @param settings     How.
 * @param options      The command line.
 * @param[out] picture The picture; to be released also when anything is wrong.
 * @param[out] report  How it went.
 * @param[out] error   What is wrong.
 * @return false if it could not be drawn.
 */
static bool draw(const Scene *scene, const RenderSettings *settings, const Options *options,
                 Picture *picture, RenderReport *report, Error *error) {
    if (!picture_init(picture, settings->width, settings->height, error) ||
        (image_file_is_linear(options->output) && !picture_keep_light(picture, error))) {
        return false;
    }
    Renderer *renderer = renderer_create(scene, settings, error);
    if (renderer) {
        Progress *progress = progress_begin(renderer, options);
        *report = renderer_draw(renderer, interrupt_flag(), picture);
        progress_end(progress);
        renderer_destroy(renderer);
    }
    return renderer != NULL;
}

/** Draws and writes. @param scene The scene. @param options The command line.
 *  @param[out] error What is wrong. @return The exit status. */
static int render_scene(const Scene *scene, const Options *options, Error *error) {
    Notes notes;
    Picture picture = {0};
    RenderReport report = {0};
    RenderSettings settings = command_settings(options, scene);
    notes_make(&notes, options, &settings);
    bool is_done = draw(scene, &settings, options, &picture, &report, error);
    picture.notes = notes.rows;
    is_done = is_done && image_file_write(options->output, &picture, error);
    picture_release(&picture);
    if (is_done && !report.is_finished) {
        error_set(error, STATUS_INTERRUPTED, "interrupted: %s has %.0f %% of the picture",
                  options->output, 100 * report.share);
    }
    return (int)error->status;
}

/** Renders a scene. See #Command.run. @param options The command line.
 *  @param[out] error What is wrong. @return The exit status. */
static int render_run(const Options *options, Error *error) {
    if (!options->output) {
        error_set(error, STATUS_USAGE, "render needs -o FILE");
        return STATUS_USAGE;
    }
    if (!image_file_check(options->output, error)) {
        return (int)error->status;
    }
    Scene *scene = command_scene(options, error);
    if (scene) {
        render_scene(scene, options, error);
        scene_destroy(scene);
    }
    return (int)error->status;
}

const Command render_command = {.name = "render",
                                .usage = "SCENE -o FILE",
                                .help = "draws one picture, without a window",
                                .accepts = "osASDtjEOXBPq",
                                .arguments = 1,
                                .run = render_run};
