/**
 * @file
 * @brief Leaving: what lies on top first, then the lesson, at last the program.
 */
#include "view/commands/leaving.h"

#include "base/language.h"
#include "view/commands/actions.h"
#include "view/commands/commands.h"
#include "view/commands/edits.h"
#include "view/state/way_out.h"

/* --- the question ----------------------------------------------------------------------------- */

/** @return What leaving would lose, and how to leave nevertheless, in English; NULL: nothing. */
static const char *leaving_question(const App *app) {
    if (app_is_playing(app)) {
        return N_("a lesson plays: leave again to end it, or press another key to stay");
    }
    if (app_is_recording(app)) {
        return N_("a lesson is recorded: leave again to save it and close the window, or press "
                  "another key to stay");
    }
    bool is_changed = edit_history_in_force(&app->edits) > 0;
    return is_changed
               ? N_("objects were changed: leave again to lose them, or press another key to "
                    "stay")
               : NULL;
}

/** @return Whether leaving again loses what was asked about: the question is still shown, and would
 *  be asked now. See #StatusHoldsFn. */
static bool is_asked(const App *app) {
    return app->title.holds == is_asked && app->exit.question &&
           app->exit.question == leaving_question(app);
}

void leaving_request(App *app) {
    if (!way_out_exists() && !app_is_playing(app)) {
        app_set_status(app, "close the tab of the page to leave dioptre");
        return;
    }
    if (leaving_question(app) && !is_asked(app)) {
        app->exit.question = leaving_question(app);
        app_set_status_while(app, is_asked, app->exit.question);
        // It stays until it is answered: who looks away for a while finds it still there.
        window_keep_toast(&app->window);
        return;
    }
    app->player.is_leaving = app_is_playing(app);
    app->exit.is_requested = !app->player.is_leaving;
}

void leaving_withdraw(App *app, const Command *command) {
    if (!command_is(command, "leave") && !command_is(command, "quit")) {
        app->exit.question = NULL;
    }
}

/* --- the commands ----------------------------------------------------------------------------- */

/** Closes the topmost of what the user has opened on the picture. @return Whether there was any. */
static bool close_own(App *app) {
    Window *window = &app->window;
    if (window->ray_view.is_open) {
        command_issue_named(app, "rays");
    } else if (window->settings_chart.is_open) {
        command_issue_named(app, "chart");
    } else if (object_inspector_is_open(&window->object_inspector)) {
        edits_close(app);
    } else if (window->magnifier.is_on) {
        command_issue_named(app, "magnifier");
    } else if (window->shows_settings && window->settings_end_time <= 0) {
        command_issue_named(app, "settings");
    } else if (window->split.mode != SPLIT_NONE) {
        command_issue_named(app, window->split.mode == SPLIT_BAR ? "split back" : "split");
    } else if (window_active_viewport(window)->layer != LAYER_SHADED) {
        command_issue_named(app, "layer light");
    } else if (window->shows_settings) {
        // They came by themselves, and would go so: last, and no lesson records it.
        window_end_settings(window);
        window_present(window);
    } else {
        return false;
    }
    return true;
}

void action_leave(App *app, int argument) {
    (void)argument;
    Window *window = &app->window;
    bool is_full = SDL_GetWindowFlags(window->sdl.window) & SDL_WINDOW_FULLSCREEN_DESKTOP;
    // What a lesson shows stays while it plays.
    bool is_own = !app_is_playing(app);
    if (gui_close_list(window->gui)) {
        return;
    }
    if (window->help.is_open) {
        action_toggle_help(app, 0);
    } else if (app->player.lesson && is_own) {
        app->player.is_leaving = true;
    } else if (is_own && close_own(app)) {
        return;
    } else if (is_full) {
        action_toggle_full_screen(app, 0);
    } else {
        leaving_request(app);
    }
}

void action_quit(App *app, int argument) {
    (void)argument;
    leaving_request(app);
}
