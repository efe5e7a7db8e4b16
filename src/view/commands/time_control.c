/**
 * @file
 * @brief The scene's time in the window.
 */
#include "view/commands/time_control.h"

double time_control_clock(const App *app) {
    if (player_is_active(app)) {
        return step_clock_seconds(&app->player.step_clock);
    }
    return recorder_is_active(app) ? step_clock_seconds(&app->recorder.step_clock)
                                   : clock_now_seconds();
}

double time_control_scene_time(const App *app) {
    return timeline_time_at(&app->timeline, time_control_clock(app));
}

bool time_control_is_animated(const App *app) {
    return app->settings->load && app->scene->is_time_dependent;
}

/** Says that there is no time. */
static void show_no_time_status(App *app) {
    app_set_status(app, "this scene does not ask for the time t");
}

void time_control_toggle(App *app) {
    if (!time_control_is_animated(app)) {
        show_no_time_status(app);
    } else if (app->timeline.is_running) {
        timeline_pause(&app->timeline, time_control_clock(app));
    } else {
        timeline_run(&app->timeline, time_control_clock(app));
    }
    app->next_title_time = 0;
}

void time_control_step(App *app, int steps) {
    if (time_control_is_animated(app)) {
        timeline_step(&app->timeline, steps, time_control_clock(app));
    } else {
        show_no_time_status(app);
    }
}

bool time_control_is_settled(const App *app) {
    bool is_stopped = !app->timeline.is_running || player_is_clock_stopped(&app->player);
    return is_stopped &&
           (!time_control_is_animated(app) || time_control_scene_time(app) == app->scene_time);
}
