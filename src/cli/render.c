/**
 * @file
 * @brief `dioptre render`: one picture, no window.
 */
#include "cli/commands.h"
#include "cli/notes.h"
#include "dioptre/image_file.h"
#include "dioptre/language.h"

#include <stdio.h>

bool command_draw(const Order *order, const Scene *scene, Renderer **renderer, Picture *picture,
                  RenderReport *report, Error *error) {
    RenderSettings settings = command_settings(order->options, scene);
    if (!picture_init(picture, settings.width, settings.height, error) ||
        (image_file_is_linear(order->output) && !picture_keep_light(picture, error))) {
        return false;
    }
    Renderer *former = *renderer;
    *renderer = renderer_create_after(former, scene, &settings, error);
    renderer_destroy(former);
    if (*renderer) {
        progress_watch(order->progress, *renderer);
        *report = renderer_draw(*renderer, interrupt_flag(), picture);
        progress_done(order->progress);
    }
    return *renderer != NULL;
}

bool command_write(const Order *order, const Scene *scene, Picture *picture, Error *error) {
    Notes notes;
    RenderSettings settings = command_settings(order->options, scene);
    notes_make(&notes, order->options, order->time, &settings);
    picture->notes = notes.rows;
    bool is_written = image_file_write(order->output, picture, error);
    picture->notes = NULL;
    return is_written;
}

/** Draws and writes. @param scene The scene. @param options The command line.
 *  @param[out] error What is wrong. */
static void render_scene(const Scene *scene, const Options *options, Error *error) {
    Order order = {.options = options, .output = options->output, .time = options->time};
    Picture picture = {0};
    Renderer *renderer = NULL;
    RenderReport report = {0};
    order.progress = progress_begin(options, 1);
    bool is_done = command_draw(&order, scene, &renderer, &picture, &report, error);
    renderer_destroy(renderer);
    progress_end(order.progress);
    is_done = is_done && command_write(&order, scene, &picture, error);
    picture_release(&picture);
    if (is_done && !report.is_finished) {
        error_set(error, STATUS_INTERRUPTED, "interrupted: %s has %.0f %% of the picture",
                  options->output, 100 * report.share);
    }
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
                                .usage = N_("SCENE -o FILE"),
                                .help = N_("draws one picture, without a window"),
                                .accepts = "osASDtjEOXBPq",
                                .arguments = 1,
                                .run = render_run};
