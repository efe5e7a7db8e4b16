/**
 * @file
 * @brief Running commands for the viewer: the recorder is told first.
 */
#include "view/commands/actions.h"
#include "view/commands/commands.h"
#include "view/commands/leaving.h"
#include "view/commands/recorder.h"

void command_run(App *app, const Command *command, bool continues) {
    const PictureChoice before = window_choice(&app->window);
    command->run(app, command->argument);
    if (command->flags & COMMAND_CHOICE) {
        app_note_choice(app, &before, continues);
    }
}

void command_choose_ray(App *app, size_t ray) {
    recorder_on_step(app, "ray(%zu)", ray);
    app_choose_ray(app, ray);
}

void command_show_rays(App *app, double x, double y) {
    recorder_on_step(app, "pixel(%.17g, %.17g)", x, y);
    app_pick_pixel(app, x, y);
    window_present(&app->window);
}

/** Shows the rays of the pixel that the readout names: a lesson records which one. @return Whether
 *  it names one, and no rays are shown yet. */
static bool show_named_rays(App *app) {
    const Viewport *viewport = &app->window.viewports[0];
    PixelPosition pixel;
    bool is_named = !app->window.ray_view.is_open && window_named_pixel(&app->window, &pixel);
    if (is_named) {
        // The centre of the pixel, so that rounding cannot change it.
        command_show_rays(app, (pixel.x + 0.5) / viewport->width,
                          (pixel.y + 0.5) / viewport->height);
    }
    return is_named;
}

/** Runs a command for the viewer. See #command_issue, #command_continue. */
static void issue(App *app, const Command *command, double time, bool continues) {
    if (command_is(command, "rays") && show_named_rays(app)) {
        return;
    }
    leaving_withdraw(app, command);
    recorder_on_command(app, command, time, continues);
    if (!command_is_move(command)) {
        command_run(app, command, continues);
        return;
    }
    // While a lesson is recorded, things move at the ticks of its clock.
    if (!app_is_recording(app)) {
        held_keys_press(&app->input.held_keys, command->move, time);
    }
    latency_on_input(&app->window.latency, time);
    app->input.next_move_time = 0;
}

void command_issue(App *app, const Command *command, double time) {
    issue(app, command, time, false);
}

void command_issue_named(App *app, const char *name) {
    command_issue(app, command_find(app->commands, name), clock_now_seconds());
}

void command_continue(App *app, const Command *command, double time) {
    issue(app, command, time, true);
}
