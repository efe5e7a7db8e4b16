/**
 * @file
 * @brief What keys, mouse and window do to the view.
 */
#include "view/input/input.h"

#include "view/commands/commands.h"
#include "view/input/browser_input.h"
#include "view/input/keymap.h"
#include "view/input/mouse.h"
#include "view/loading/current_scene.h"

#include <stdio.h>

/** Factor for the speed of a move while Shift is held. */
static const double FAST_FACTOR = 4;
/** Factor for the speed of a move while Ctrl is held: pixel by pixel. */
static const double FINE_FACTOR = 0.25;
/** Factor for the width of the field of view with each notch of the wheel away from the user. */
static const double ZOOM_PER_NOTCH = 0.9;
/** Seconds of a held key that a notch of the wheel brings the second camera as near as. */
static const double FORWARD_PER_NOTCH = 0.125;
/** Modifiers that make a key one of the window manager's, not ours. */
static const int WINDOW_MANAGER_MODIFIERS = KMOD_LALT | KMOD_GUI;

/**
 * @return When an event came, seconds on #clock_now_seconds; it may have waited in the queue.
 * @param timestamp  SDL's time of the event, milliseconds.
 */
static double event_time(Uint32 timestamp) {
    return clock_now_seconds() - (double)(SDL_GetTicks() - timestamp) / 1000;
}

/** @return Factor for the speed of moves. @param modifiers SDL's modifier keys that are held. */
static double speed_factor(int modifiers) {
    return (modifiers & KMOD_SHIFT ? FAST_FACTOR : 1) * (modifiers & KMOD_CTRL ? FINE_FACTOR : 1);
}

/** Begins to move something. @param time When the key went down, seconds. */
static void begin_move(App *app, Action action, double time) {
    if (!recorder_is_active(app)) {
        held_keys_press(&app->held_keys, action, time);
    }
    latency_on_key(&app->window.latency, time);
    app->next_move_time = 0;
}

/** A move ends. @param time When its key went up, seconds. */
static void end_move(App *app, Action action, double time) {
    if (recorder_is_active(app)) {
        recorder_release(app, action, time);
    }
    held_keys_release(&app->held_keys, action, time);
}

/** All moves end. */
static void end_all_moves(App *app, double time) {
    if (recorder_is_active(app)) {
        recorder_release_all(app, time);
    }
    held_keys_release_all(&app->held_keys, time);
}

/** Moves go faster or slower. */
static void set_move_speed(App *app, double factor, double time) {
    if (recorder_is_active(app)) {
        recorder_set_speed(app, factor, time);
    }
    held_keys_set_speed(&app->held_keys, factor, time);
}

/** @return Whether an action goes on while its key is held, though it is no move. */
static bool action_repeats(Action action) {
    return action == ACTION_TIME_BACK || action == ACTION_TIME_FORWARD ||
           action == ACTION_BAR_LEFT || action == ACTION_BAR_RIGHT;
}

/**
 * Walks to a pixel beside, where the arrows do that: with Ctrl, while the rays of one are shown.
 * @param action  What the key asks for.
 * @param modifiers  SDL's modifier keys that are held; with Shift it goes ten times as far.
 * @return Whether it is such a key.
 */
static bool step_pixel_by_key(App *app, Action action, int modifiers) {
    int step = modifiers & KMOD_SHIFT ? 10 : 1;
    int right = (action == ACTION_CAMERA_RIGHT) - (action == ACTION_CAMERA_LEFT);
    int down = (action == ACTION_CAMERA_DOWN) - (action == ACTION_CAMERA_UP);
    bool is_pixel_step =
        app->window.inspector.is_open && (modifiers & KMOD_CTRL) && (right || down);
    if (is_pixel_step && !player_is_active(app)) {
        char text[LESSON_STEP_TEXT_SIZE];
        snprintf(text, sizeof text, "walk(%d, %d)", step * right, step * down);
        recorder_record_step(app, text);
        app_step_pixel(app, step * right, step * down);
    }
    return is_pixel_step;
}

/** @return What a key asks for: to leave is first to leave the rays that are shown, unless a lesson
 *  shows them. */
static Action key_action(const App *app, SDL_Keysym key) {
    Action action = keymap_action(key, app->settings->keys_by_letter);
    bool shows_rays = app->window.inspector.is_open && !player_is_active(app);
    return action == ACTION_QUIT && shows_rays ? ACTION_TOGGLE_RAYS : action;
}

/** A key went down or up. */
static void on_key(App *app, const SDL_KeyboardEvent *key) {
    double time = event_time(key->timestamp);
    Action action = key_action(app, key->keysym);
    if (key->type == SDL_KEYDOWN && step_pixel_by_key(app, action, key->keysym.mod)) {
        return;
    }
    set_move_speed(app, speed_factor(key->keysym.mod), time);
    if (key->type == SDL_KEYUP && action_is_move(action)) {
        end_move(app, action, time);
    }
    bool is_repeat = key->repeat && !action_repeats(action);
    if (key->type == SDL_KEYUP || is_repeat || (key->keysym.mod & WINDOW_MANAGER_MODIFIERS)) {
        return;
    }
    if (player_handle_action(app, action)) {
        return;
    }
    if (recorder_is_active(app)) {
        recorder_press(app, action, time);
    }
    if (action_is_move(action)) {
        begin_move(app, action, time);
    } else {
        command_run(app, action);
    }
}

void app_move(App *app, Movement light, Movement camera) {
    if (app->window.inspector.is_open && movement_is_nonzero(camera)) {
        inspector_move(&app->window.inspector, camera);
        camera = (Movement){0};
        if (!movement_is_nonzero(light)) {
            latency_discard_pending(&app->window.latency);
            return;
        }
    }
    bool is_light_moved =
        movement_is_nonzero(light) && app->selected_light < app->scene->light_count;
    if (is_light_moved || movement_is_nonzero(camera)) {
        view_state_move(&app->home_view, app->scene, app->selected_light, light, camera);
        app_on_view_changed(app);
    } else {
        latency_discard_pending(&app->window.latency);
        if (movement_is_nonzero(light)) {
            app_set_status(app, "there is no light to move");
        }
    }
}

void app_turn(App *app, double right, double up) {
    if (app->window.inspector.is_open) {
        inspector_turn(&app->window.inspector, right, up);
        return;
    }
    scene_camera_rotate(&app->scene->camera, app->home_view.up_axis, right, up);
    app->home_view.is_camera_moved = true;
    app_on_view_changed(app);
}

void app_zoom(App *app, double notches) {
    if (app->window.inspector.is_open) {
        inspector_move(&app->window.inspector, (Movement){.forward = notches * FORWARD_PER_NOTCH});
        return;
    }
    scene_camera_zoom(&app->scene->camera, pow(ZOOM_PER_NOTCH, notches));
    app->home_view.is_camera_moved = true;
    app_on_view_changed(app);
}

void app_pick_pixel(App *app, double x, double y) {
    inspector_pick(&app->window.inspector, x, y);
}

void app_step_pixel(App *app, int right, int down) {
    inspector_step_pixel(&app->window.inspector, right, down);
}

/** The window has another size. */
static void on_resize(App *app) {
    if (window_on_resize(&app->window)) {
        int width, height;
        char step[LESSON_STEP_TEXT_SIZE];
        SDL_GetWindowSize(app->window.sdl.window, &width, &height);
        snprintf(step, sizeof step, "size(%d, %d)", width, height);
        recorder_record_step(app, step);
        app_on_view_changed(app);
    }
}

/** Something happened to the window. */
static void on_window(App *app, const SDL_WindowEvent *event) {
    window_on_visibility(&app->window);
    switch (event->event) {
    case SDL_WINDOWEVENT_SIZE_CHANGED:
        on_resize(app);
        break;
    case SDL_WINDOWEVENT_EXPOSED:
        window_present(&app->window);
        break;
    case SDL_WINDOWEVENT_FOCUS_LOST:
    case SDL_WINDOWEVENT_HIDDEN:
        end_all_moves(app, event_time(event->timestamp));
        break;
    default:
        break;
    }
}

/** The keyboard has another layout. */
static void on_keymap(App *app, double time) {
    end_all_moves(app, time);
    window_invalidate_text(&app->window);
    window_present(&app->window);
}

/** One of our own events came. */
static void on_app_event(App *app, const SDL_Event *event) {
    Uint32 type = event->type;
    if (type == app->first_event + EVENT_PASS_FINISHED) {
        window_on_pass(&app->window, event);
    } else if (type == app->first_event + EVENT_FILE_CHANGED) {
        current_scene_reload(app);
    } else if (type == app->first_event + EVENT_SCENE_LIST_CHANGED) {
        browser_input_on_list_changed(app);
    } else if (type == app->first_event + EVENT_SIGNAL) {
        app->should_quit = true;
        app->exit_status = STATUS_INTERRUPTED;
    }
}

void input_handle_event(App *app, const SDL_Event *event) {
    if (caption_input_handle(app, event) || browser_input_handle(app, event)) {
        return;
    }
    switch (event->type) {
    case SDL_KEYDOWN:
    case SDL_KEYUP:
        on_key(app, &event->key);
        break;
    case SDL_MOUSEMOTION:
        mouse_on_motion(app, &event->motion);
        break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
        mouse_on_button(app, &event->button);
        break;
    case SDL_MOUSEWHEEL:
        mouse_on_wheel(app, &event->wheel);
        break;
    case SDL_WINDOWEVENT:
        on_window(app, &event->window);
        break;
    case SDL_DROPFILE:
        current_scene_open(app, event->drop.file);
        SDL_free(event->drop.file);
        break;
    case SDL_KEYMAPCHANGED:
        on_keymap(app, event_time(event->common.timestamp));
        break;
    case SDL_RENDER_TARGETS_RESET:
    case SDL_RENDER_DEVICE_RESET:
        window_on_device_reset(&app->window);
        break;
    case SDL_QUIT:
        app->should_quit = true;
        break;
    default:
        on_app_event(app, event);
        break;
    }
}
