/**
 * @file
 * @brief Events: which part of the program each is for.
 */
#include "view/input/input.h"

#include "view/commands/commands.h"
#include "view/commands/current_scene.h"
#include "view/commands/edits.h"
#include "view/commands/recorder.h"
#include "view/input/devices.h"
#include "view/lesson/player.h"

/* --- the list of scenes ----------------------------------------------------------------------- */

/** Closes the list, or opens a scene, as a key asks. */
static void apply_browser_result(App *app, BrowserResult result) {
    Browser *browser = &app->window.browser;
    if (result == BROWSER_OPEN_SCENE) {
        player_open_selected(app);
    } else if (result == BROWSER_CLOSE) {
        browser_close(browser);
    }
    gui_request_frames(app->window.gui);
    window_present(&app->window);
}

/** Handles the help over the list of scenes: F1 opens it, F1 and Esc close it, and the list is
 * there again. @return Whether the event was for the help. */
static bool handle_help_over_list(App *app, const SDL_Event *event) {
    Help *help = &app->window.help;
    const SDL_Keycode key = event->type == SDL_KEYDOWN ? event->key.keysym.sym : SDLK_UNKNOWN;
    const bool was_open = help->is_open;
    if (key == SDLK_F1 || (was_open && key == SDLK_ESCAPE)) {
        command_issue_named(app, "help");
    } else if (was_open && key != SDLK_UNKNOWN) {
        help_handle_key(help, key); // No other key: it would do something below the list.
    }
    if (was_open) {
        gui_request_frames(app->window.gui);
    }
    return key == SDLK_F1 || (was_open && (key != SDLK_UNKNOWN || event->type == SDL_TEXTINPUT));
}

/** Handles a key with Ctrl while the list of scenes is open: with Backspace it erases a word.
 * Others, but the one that leaves, would change the scene below the list. @return Whether it was
 * for the list. */
static bool handle_browser_ctrl_key(App *app, SDL_Keysym key) {
    if (key.sym == SDLK_BACKSPACE) {
        browser_erase_word(&app->window.browser);
        gui_request_frames(app->window.gui);
    }
    return !command_is(command_find_key(app->commands, key, app->settings->keys_by_letter), "quit");
}

/** Handles an event while the list of scenes is open. @return Whether it was for the list. */
static bool handle_browser_event(App *app, const SDL_Event *event) {
    Browser *browser = &app->window.browser;
    if (!browser->is_open) {
        return false;
    }
    if (handle_help_over_list(app, event)) {
        return true;
    }
    switch (event->type) {
    case SDL_KEYDOWN:
        if (event->key.keysym.mod & WINDOW_MANAGER_MODIFIERS) {
            return false;
        }
        if (event->key.keysym.mod & KMOD_CTRL) {
            return handle_browser_ctrl_key(app, event->key.keysym);
        }
        apply_browser_result(app, browser_key(browser, event->key.keysym.sym));
        return true;
    case SDL_TEXTINPUT:
        browser_type(browser, event->text.text);
        window_present(&app->window);
        return true;
    default:
        return event->type == SDL_MOUSEMOTION || event->type == SDL_MOUSEBUTTONDOWN ||
               event->type == SDL_MOUSEBUTTONUP || event->type == SDL_MOUSEWHEEL;
    }
}

/** Handles a change of the list of scenes. */
static void on_scene_list_changed(App *app) {
    Browser *browser = &app->window.browser;
    if (browser->is_reopen_pending) {
        current_scene_browse(app);
    }
    if (browser->is_open) {
        browser_select_current(browser);
    }
    gui_request_frames(app->window.gui);
    window_present(&app->window);
}

/* --- window ----------------------------------------------------------------------------------- */

/** Handles another size of the window. */
static void on_resize(App *app) {
    if (window_on_resize(&app->window)) {
        int width, height;
        window_size_below_toolbar(&app->window, &width, &height);
        recorder_on_step(app, "size(%d, %d)", width, height);
        app_on_view_changed(app);
    }
}

/** Handles a window event. */
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
        keyboard_release_all(app, input_event_time(event->timestamp));
        break;
    default:
        break;
    }
}

/** Handles another keyboard layout. */
static void on_keymap(App *app, double time) {
    keyboard_release_all(app, time);
    gui_on_keymap(app->window.gui);
    window_invalidate_text(&app->window);
    window_present(&app->window);
}

/** Handles one of the window's own events. */
static void on_app_event(App *app, const SDL_Event *event) {
    Uint32 type = event->type;
    if (type == app->first_event + EVENT_PASS_FINISHED) {
        window_on_pass(&app->window, event);
    } else if (type == app->first_event + EVENT_FILE_CHANGED) {
        current_scene_on_file_event(app);
    } else if (type == app->first_event + EVENT_SCENE_LIST_CHANGED) {
        on_scene_list_changed(app);
    } else if (type == app->first_event + EVENT_SIGNAL) {
        app->exit = (ExitState){.is_requested = true, .status = STATUS_INTERRUPTED};
    }
}

/** Handles an event over a widget. @return Whether it was for the widget. */
static bool handle_widget_event(App *app, const SDL_Event *event) {
    if (event->type == SDL_MOUSEBUTTONDOWN || event->type == SDL_KEYDOWN) {
        window_end_hint(&app->window);
    }
    if (event->type == SDL_MOUSEBUTTONDOWN) {
        window_present(&app->window); // The widgets learn where the mouse is.
    }
    bool is_for_widget = gui_handle_event(app->window.gui, event);
    if (is_for_widget && (event->type == SDL_KEYDOWN || event->type == SDL_KEYUP)) {
        window_present(&app->window); // A key that goes up before the next frame would be lost.
    }
    return is_for_widget;
}

/** Handles an event while the help is open. @return Whether it was for the help. */
static bool handle_help_event(App *app, const SDL_Event *event) {
    Help *help = &app->window.help;
    bool is_key = help->is_open && event->type == SDL_KEYDOWN &&
                  !(event->key.keysym.mod & WINDOW_MANAGER_MODIFIERS) &&
                  help_handle_key(help, event->key.keysym.sym);
    if (is_key) {
        gui_request_frames(app->window.gui);
    }
    return is_key;
}

/** Ends what an event ends, whoever uses it: the move of a key, the typing of a caption. */
static void end_by_event(App *app, const SDL_Event *event) {
    if (event->type == SDL_KEYUP) {
        keyboard_on_release(app, &event->key);
    } else if (event->type == SDL_MOUSEBUTTONDOWN) {
        recorder_accept_caption(app); // What is clicked comes after it in the lesson.
    }
}

void input_handle_event(App *app, const SDL_Event *event) {
    end_by_event(app, event);
    if (handle_widget_event(app, event) || recorder_handle_caption_event(app, event) ||
        handle_browser_event(app, event) || handle_help_event(app, event)) {
        return;
    }
    switch (event->type) {
    case SDL_KEYDOWN:
    case SDL_KEYUP:
        keyboard_on_key(app, &event->key);
        break;
    case SDL_MOUSEMOTION:
        mouse_on_motion(app, &event->motion);
        break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
        mouse_on_button(app, &event->button);
        break;
    case SDL_MULTIGESTURE:
        mouse_on_fingers(app, &event->mgesture);
        break;
    case SDL_MOUSEWHEEL:
        mouse_on_wheel(app, &event->wheel);
        break;
    case SDL_WINDOWEVENT:
        on_window(app, &event->window);
        break;
    case SDL_DROPFILE:
        player_open_file(app, event->drop.file);
        SDL_free(event->drop.file);
        break;
    case SDL_KEYMAPCHANGED:
        on_keymap(app, input_event_time(event->common.timestamp));
        break;
    case SDL_RENDER_TARGETS_RESET:
    case SDL_RENDER_DEVICE_RESET:
        window_on_device_reset(&app->window);
        break;
    case SDL_QUIT:
        app->exit.is_requested = true;
        break;
    default:
        on_app_event(app, event);
        break;
    }
}
