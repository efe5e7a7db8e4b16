/**
 * @file
 * @brief What keys, mouse and window do to the view.
 */
#include "view/controls.h"

#include "view/choosing.h"
#include "view/deeds.h"
#include "view/keymap.h"
#include "view/mouse.h"
#include "view/scenes.h"

#include <stdio.h>

/** Factor for the speed of a move while Shift is held. */
static const double FAST = 4;
/** Factor for the speed of a move while Ctrl is held: pixel by pixel. */
static const double FINE = 0.25;
/** Factor for the width of the field of view with each notch of the wheel away from the user. */
static const double ZOOM_A_NOTCH = 0.9;
/** Seconds of a held key that a notch of the wheel brings the second camera as near as. */
static const double FORWARD_A_NOTCH = 0.125;
/** Modifiers that make a key one of the window manager's, not ours. */
static const int FOREIGN_MODIFIERS = KMOD_LALT | KMOD_GUI;

/**
 * @return When an event came, seconds on #clock_seconds; it may have waited in the queue.
 * @param timestamp  SDL's time of the event, milliseconds.
 */
static double event_time(Uint32 timestamp) {
    return clock_seconds() - (double)(SDL_GetTicks() - timestamp) / 1000;
}

/** @return Factor for the speed of moves. @param modifiers SDL's modifier keys that are held. */
static double speed(int modifiers) {
    return (modifiers & KMOD_SHIFT ? FAST : 1) * (modifiers & KMOD_CTRL ? FINE : 1);
}

/**
 * Begins to move something.
 * @param[in,out] view  The view.
 * @param action        What, a move.
 * @param time          When the key went down, seconds.
 */
static void begin_move(View *view, Action action, double time) {
    if (!recorder_is_on(view)) {
        motion_press(&view->motion, action, time);
    }
    latency_key(&view->stage.latency, time);
    view->next_step = 0;
}

/** A move ends. @param[in,out] view The view. @param action The move. @param time When its key went
 *  up, seconds. */
static void end_move(View *view, Action action, double time) {
    if (recorder_is_on(view)) {
        recorder_release(view, action, time);
    }
    motion_release(&view->motion, action, time);
}

/** All moves end. @param[in,out] view The view. @param time When, seconds. */
static void end_moves(View *view, double time) {
    if (recorder_is_on(view)) {
        recorder_release_all(view, time);
    }
    motion_release_all(&view->motion, time);
}

/** Moves go faster or slower. @param[in,out] view The view. @param factor How fast. @param time
 *  When, seconds. */
static void set_speed(View *view, double factor, double time) {
    if (recorder_is_on(view)) {
        recorder_set_speed(view, factor, time);
    }
    motion_set_speed(&view->motion, factor, time);
}

/** @return Whether an action goes on while its key is held, though it is no move. @param action It.
 */
static bool is_repeated(Action action) {
    return action == ACTION_TIME_BACK || action == ACTION_TIME_ON || action == ACTION_BAR_LEFT ||
           action == ACTION_BAR_RIGHT;
}

/** Walks to a pixel beside, where the arrows do that: with Ctrl, while the rays of one are shown.
 *  @param[in,out] view The view. @param action What the key asks for. @param modifiers SDL's
 * modifier keys that are held; with Shift it goes ten times as far. @return Whether it is such a
 * key. */
static bool walk(View *view, Action action, int modifiers) {
    int step = modifiers & KMOD_SHIFT ? 10 : 1;
    int right = (action == ACTION_CAMERA_RIGHT) - (action == ACTION_CAMERA_LEFT);
    int down = (action == ACTION_CAMERA_DOWN) - (action == ACTION_CAMERA_UP);
    bool is_walk = view->stage.inspector.is_open && (modifiers & KMOD_CTRL) && (right || down);
    if (is_walk && !player_is_on(view)) {
        char words[STEP_SIZE];
        snprintf(words, sizeof words, "walk(%d, %d)", step * right, step * down);
        recorder_note(view, words);
        controls_walk(view, step * right, step * down);
    }
    return is_walk;
}

/** @return What a key asks for: to leave is first to leave the rays that are shown, unless a lesson
 *          shows them. @param view The view. @param key The key. */
static Action asked(const View *view, SDL_Keysym key) {
    Action action = keymap_action(key, view->settings->keys_by_letter);
    bool shows_rays = view->stage.inspector.is_open && !player_is_on(view);
    return action == ACTION_LEAVE && shows_rays ? ACTION_RAYS : action;
}

/** A key went down or up. @param[in,out] view The view. @param key The event. */
static void on_key(View *view, const SDL_KeyboardEvent *key) {
    double time = event_time(key->timestamp);
    Action action = asked(view, key->keysym);
    if (key->type == SDL_KEYDOWN && walk(view, action, key->keysym.mod)) {
        return;
    }
    set_speed(view, speed(key->keysym.mod), time);
    if (key->type == SDL_KEYUP && action_is_move(action)) {
        end_move(view, action, time);
    }
    bool is_repeat = key->repeat && !is_repeated(action);
    if (key->type == SDL_KEYUP || is_repeat || (key->keysym.mod & FOREIGN_MODIFIERS)) {
        return;
    }
    if (player_takes(view, action)) {
        return;
    }
    if (recorder_is_on(view)) {
        recorder_press(view, action, time);
    }
    if (action_is_move(action)) {
        begin_move(view, action, time);
    } else {
        deeds_do(view, action);
    }
}

void controls_move(View *view, Movement light, Movement camera) {
    if (view->stage.inspector.is_open && movement_is_any(camera)) {
        inspector_move(&view->stage.inspector, camera);
        camera = (Movement){0};
        if (!movement_is_any(light)) {
            latency_forget(&view->stage.latency);
            return;
        }
    }
    bool is_light_moved = movement_is_any(light) && view->light < view->scene->light_count;
    if (is_light_moved || movement_is_any(camera)) {
        pose_move(&view->home, view->scene, view->light, light, camera);
        view_changed(view);
    } else {
        latency_forget(&view->stage.latency);
        if (movement_is_any(light)) {
            view_note(view, "there is no light to move");
        }
    }
}

void controls_turn(View *view, double right, double up) {
    if (view->stage.inspector.is_open) {
        inspector_turn(&view->stage.inspector, right, up);
        return;
    }
    camera_turn(&view->scene->camera, view->home.vertical, right, up);
    view->home.is_camera_moved = true;
    view_changed(view);
}

void controls_zoom(View *view, double notches) {
    if (view->stage.inspector.is_open) {
        inspector_move(&view->stage.inspector, (Movement){.forward = notches * FORWARD_A_NOTCH});
        return;
    }
    camera_zoom(&view->scene->camera, pow(ZOOM_A_NOTCH, notches));
    view->home.is_camera_moved = true;
    view_changed(view);
}

void controls_pick(View *view, double x, double y) {
    inspector_pick(&view->stage.inspector, x, y);
}

void controls_walk(View *view, int right, int down) {
    inspector_walk(&view->stage.inspector, right, down);
}

/** The window has another size. @param[in,out] view The view. */
static void on_resize(View *view) {
    if (stage_on_resize(&view->stage)) {
        int width, height;
        char step[STEP_SIZE];
        SDL_GetWindowSize(view->stage.display.window, &width, &height);
        snprintf(step, sizeof step, "size(%d, %d)", width, height);
        recorder_note(view, step);
        view_changed(view);
    }
}

/** Something happened to the window. @param[in,out] view The view. @param window The event. */
static void on_window(View *view, const SDL_WindowEvent *window) {
    stage_on_visibility(&view->stage);
    switch (window->event) {
    case SDL_WINDOWEVENT_SIZE_CHANGED:
        on_resize(view);
        break;
    case SDL_WINDOWEVENT_EXPOSED:
        stage_present(&view->stage);
        break;
    case SDL_WINDOWEVENT_FOCUS_LOST:
    case SDL_WINDOWEVENT_HIDDEN:
        end_moves(view, event_time(window->timestamp));
        break;
    default:
        break;
    }
}

/** The keyboard has another layout. @param[in,out] view The view. @param time Now, seconds. */
static void on_keymap(View *view, double time) {
    end_moves(view, time);
    stage_forget_words(&view->stage);
    stage_present(&view->stage);
}

/** One of our own events came. @param[in,out] view The view. @param event It. */
static void on_own_event(View *view, const SDL_Event *event) {
    Uint32 type = event->type;
    if (type == view->first_event + EVENT_PASS) {
        stage_on_pass(&view->stage, event);
    } else if (type == view->first_event + EVENT_FILE) {
        scenes_refresh(view);
    } else if (type == view->first_event + EVENT_LIST) {
        choosing_on_news(view);
    } else if (type == view->first_event + EVENT_INTERRUPT) {
        view->is_over = true;
        view->status = STATUS_INTERRUPTED;
    }
}

void controls_handle(View *view, const SDL_Event *event) {
    if (recorder_types(view, event) || choosing_takes(view, event)) {
        return;
    }
    switch (event->type) {
    case SDL_KEYDOWN:
    case SDL_KEYUP:
        on_key(view, &event->key);
        break;
    case SDL_MOUSEMOTION:
        mouse_motion(view, &event->motion);
        break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
        mouse_button(view, &event->button);
        break;
    case SDL_MOUSEWHEEL:
        mouse_wheel(view, &event->wheel);
        break;
    case SDL_WINDOWEVENT:
        on_window(view, &event->window);
        break;
    case SDL_DROPFILE:
        scenes_open(view, event->drop.file);
        SDL_free(event->drop.file);
        break;
    case SDL_KEYMAPCHANGED:
        on_keymap(view, event_time(event->common.timestamp));
        break;
    case SDL_RENDER_TARGETS_RESET:
    case SDL_RENDER_DEVICE_RESET:
        stage_on_loss(&view->stage);
        break;
    case SDL_QUIT:
        view->is_over = true;
        break;
    default:
        on_own_event(view, event);
        break;
    }
}
