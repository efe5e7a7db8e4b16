/**
 * @file
 * @brief Keys that go down and up.
 */
#include "view/commands/commands.h"
#include "view/commands/recorder.h"
#include "view/input/devices.h"
#include "view/lesson/player.h"

#include <string.h>

/** Factor of a move's speed while Shift is held. */
static const double FAST_FACTOR = 4;
/** Factor of a move's speed while Ctrl is held: pixel by pixel. */
static const double FINE_FACTOR = 0.25;
/** Pixels that an arrow with Ctrl and Shift steps. */
static const int LARGE_PIXEL_STEP = 10;

double input_event_time(Uint32 timestamp) {
    return clock_now_seconds() - (double)(SDL_GetTicks() - timestamp) / 1000;
}

/** @return Factor of a move's speed. @param modifiers SDL's modifiers that are held. */
static double speed_factor(int modifiers) {
    return (modifiers & KMOD_SHIFT ? FAST_FACTOR : 1) * (modifiers & KMOD_CTRL ? FINE_FACTOR : 1);
}

void keyboard_on_release(App *app, const SDL_KeyboardEvent *key) {
    const Command **move = &app->input.moves[key->keysym.scancode];
    if (*move) {
        double time = input_event_time(key->timestamp);
        recorder_on_release(app, *move, time);
        held_keys_release(&app->input.held_keys, (*move)->move, time);
        *move = NULL;
    }
}

void keyboard_release_all(App *app, double time) {
    recorder_on_release_all(app, time);
    held_keys_release_all(&app->input.held_keys, time);
    memset(app->input.moves, 0, sizeof app->input.moves);
}

/** Steps to a pixel nearby: an arrow with Ctrl, while rays or the magnifier are shown. @return
 * Whether the key is one for that. */
static bool step_pixel_by_key(App *app, const Command *command, int modifiers) {
    bool is_arrow =
        command && command->move.subject == MOVE_CAMERA && command->move.axis != MOVE_FORWARD;
    bool has_pixel = app->window.ray_view.is_open || app->window.magnifier.is_on;
    if (!is_arrow || !has_pixel || !(modifiers & KMOD_CTRL)) {
        return false;
    }
    if (!app_is_playing(app)) {
        int step = (modifiers & KMOD_SHIFT ? LARGE_PIXEL_STEP : 1) * command->move.sign;
        int right = command->move.axis == MOVE_RIGHT ? step : 0;
        int down = command->move.axis == MOVE_UP ? -step : 0;
        recorder_on_step(app, "walk(%d, %d)", right, down);
        app_step_pixel(app, right, down);
    }
    return true;
}

/** Scrolls the formulas of the rays that are shown: Page Up and Page Down without Shift. @return
 *  Whether the key is one for that. */
static bool scroll_by_key(App *app, const Command *command, int modifiers) {
    bool is_page =
        command && command->move.subject == MOVE_CAMERA && command->move.axis == MOVE_FORWARD;
    if (!is_page || !app->window.ray_view.is_open || modifiers & (KMOD_SHIFT | KMOD_CTRL)) {
        return false;
    }
    ray_view_scroll(&app->window.ray_view, -command->move.sign);
    return true;
}

/** @return The command of a key: while rays are shown, Space lets the next one fly. */
static const Command *in_ray_view(const App *app, const Command *command) {
    bool flies =
        app->window.ray_view.is_open && !app_is_playing(app) && command_is(command, "time");
    return flies ? command_find(app->commands, "fly ray") : command;
}

/** @return Whether a key with Shift types a question mark: at the places of American, French and
 *  German keyboards. */
static bool is_question_mark(SDL_Keysym key) {
    bool is_place = (key.scancode == SDL_SCANCODE_SLASH && key.sym == SDLK_SLASH) ||
                    (key.scancode == SDL_SCANCODE_M && key.sym == SDLK_COMMA) ||
                    (key.scancode == SDL_SCANCODE_MINUS && key.sym == SDLK_QUOTE);
    return key.sym == SDLK_QUESTION || (is_place && key.mod & KMOD_SHIFT);
}

/** Handles the keys that all programs have: ?, Alt and Enter, and Ctrl and a letter, which is no
 *  command that has the letter alone. @param command The command of the key; NULL: none. @return
 *  Whether it is one of them. */
static bool handle_common_key(App *app, SDL_Keysym key, const Command *command) {
    bool is_letter = key.sym >= SDLK_a && key.sym <= SDLK_z && key.mod & KMOD_CTRL &&
                     !(command && command->flags & COMMAND_CTRL);
    const char *name = NULL;
    if (key.sym == SDLK_RETURN && key.mod & KMOD_ALT) {
        name = "full screen";
    } else if (is_question_mark(key)) {
        name = "help";
    }
    if (name) {
        command_issue_named(app, name);
    }
    return name || is_letter;
}

void keyboard_on_key(App *app, const SDL_KeyboardEvent *key) {
    double time = input_event_time(key->timestamp);
    bool is_down = key->type == SDL_KEYDOWN;
    const Command *command =
        command_find_key(app->commands, key->keysym, app->settings->keys_by_letter);
    command = command && command->name ? in_ray_view(app, command) : NULL;
    if (is_down && handle_common_key(app, key->keysym, command)) {
        return;
    }
    if (is_down && (step_pixel_by_key(app, command, key->keysym.mod) ||
                    scroll_by_key(app, command, key->keysym.mod))) {
        return;
    }
    if (is_down && player_handle_digit(app, key->keysym.scancode)) {
        return;
    }
    double factor = speed_factor(key->keysym.mod);
    app->input.modifiers = key->keysym.mod;
    recorder_on_speed(app, factor, time);
    held_keys_set_speed(&app->input.held_keys, factor, time);
    // A key that moves something repeats nothing, also if another key has changed what it means.
    const Command **move = &app->input.moves[key->keysym.scancode];
    bool is_ignored_repeat =
        key->repeat && (*move || !(command && command->flags & COMMAND_REPEATS));
    if (!is_down || is_ignored_repeat || (key->keysym.mod & WINDOW_MANAGER_MODIFIERS)) {
        return;
    }
    if (app->window.help.is_open && command && !(command->flags & COMMAND_WHILE_PLAYING)) {
        app->window.help.is_open = false; // What the key does is seen, not hidden by the help.
        window_present(&app->window);
    }
    if (player_handle_command(app, command) || !command) {
        return;
    }
    if (key->repeat) {
        command_continue(app, command, time);
    } else {
        command_issue(app, command, time);
        *move = command_is_move(command) ? command : NULL;
    }
}
