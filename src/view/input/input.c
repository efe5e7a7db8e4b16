/**
 * @file
 * @brief Events of keyboard, mouse and window.
 */
#include "view/input/input.h"

#include "view/commands/commands.h"
#include "view/commands/current_scene.h"
#include "view/commands/edits.h"
#include "view/commands/recorder.h"
#include "view/lesson/player.h"

/** Factor of a move's speed while Shift is held. */
static const double FAST_FACTOR = 4;
/** Factor of a move's speed while Ctrl is held: pixel by pixel. */
static const double FINE_FACTOR = 0.25;
/** Pixels that an arrow with Ctrl and Shift steps. */
static const int LARGE_PIXEL_STEP = 10;
/** Degrees that the second camera turns around rays while the mouse crosses the window. */
static const double ORBIT_PER_WINDOW = 180;
/** Notches of the wheel while two fingers spread from one point across the window. */
static const double PINCH_NOTCHES = 30;
/** Screen units that the mouse may move during a click. */
static const int CLICK_TOLERANCE = 3;
/** Modifiers with which a key is for the window manager. */
static const int WINDOW_MANAGER_MODIFIERS = KMOD_LALT | KMOD_GUI;

/* --- keyboard --------------------------------------------------------------------------------- */

/** @return When an event happened, seconds on #clock_now_seconds; it may have waited in the queue.
 *  @param timestamp SDL's time of the event, milliseconds. */
static double event_time(Uint32 timestamp) {
    return clock_now_seconds() - (double)(SDL_GetTicks() - timestamp) / 1000;
}

/** @return Factor of a move's speed. @param modifiers SDL's modifiers that are held. */
static double speed_factor(int modifiers) {
    return (modifiers & KMOD_SHIFT ? FAST_FACTOR : 1) * (modifiers & KMOD_CTRL ? FINE_FACTOR : 1);
}

/** All keys go up: the window lost the keyboard, or its layout changed. */
static void end_all_moves(App *app, double time) {
    recorder_on_release_all(app, time);
    held_keys_release_all(&app->input.held_keys, time);
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

/** Handles the keys that all programs have: ?, Ctrl and a letter, Alt and Enter. @param command The
 *  command of the key; NULL: none. @return Whether it is one of them: a letter with Ctrl is no
 *  command that has the letter alone. */
static bool handle_common_key(App *app, SDL_Keysym key, const Command *command) {
    bool is_letter = key.sym >= SDLK_a && key.sym <= SDLK_z && key.mod & KMOD_CTRL &&
                     !(command && command->flags & COMMAND_CTRL);
    const char *name = NULL;
    if (key.sym == SDLK_RETURN && key.mod & KMOD_ALT) {
        name = "full screen";
    } else if (is_question_mark(key)) {
        name = "help";
    } else if (is_letter && key.sym == SDLK_q) {
        command_leave_program(app);
    }
    if (name) {
        command_issue(app, command_find(app->commands, name), event_time(SDL_GetTicks()));
    }
    return name || is_letter;
}

/** Handles a key that goes down or up. */
static void on_key(App *app, const SDL_KeyboardEvent *key) {
    double time = event_time(key->timestamp);
    bool is_down = key->type == SDL_KEYDOWN;
    const Command *command =
        command_find_key(app->commands, key->keysym, app->settings->keys_by_letter);
    command = command && command->name ? in_ray_view(app, command) : NULL;
    if (is_down && handle_common_key(app, key->keysym, command)) {
        return;
    }
    if (is_down && step_pixel_by_key(app, command, key->keysym.mod)) {
        return;
    }
    if (is_down && player_handle_digit(app, key->keysym.scancode)) {
        return;
    }
    double factor = speed_factor(key->keysym.mod);
    app->input.modifiers = key->keysym.mod;
    recorder_on_speed(app, factor, time);
    held_keys_set_speed(&app->input.held_keys, factor, time);
    if (!is_down && command && command_is_move(command)) {
        recorder_on_release(app, command, time);
        held_keys_release(&app->input.held_keys, command->move, time);
    }
    bool is_ignored_repeat = key->repeat && !(command && command->flags & COMMAND_REPEATS);
    if (!is_down || is_ignored_repeat || (key->keysym.mod & WINDOW_MANAGER_MODIFIERS)) {
        return;
    }
    if (!player_handle_command(app, command) && command) {
        command_issue(app, command, time);
    }
}

/* --- mouse ------------------------------------------------------------------------------------ */

/** @return Width of the window, screen units. */
static int mouse_window_width(const App *app) {
    int width = 1;
    SDL_GetWindowSize(app->window.sdl.window, &width, NULL);
    return SDL_max(1, width);
}

/** Handles a click: it selects what is there. While rays are shown it chooses the ray there, or
 *  shows the rays of the pixel there, in the picture or in the inset. @param x Screen units. */
static void click_at(App *app, int x, int y) {
    double right, down;
    size_t ray;
    bool is_inside = window_picture_position(&app->window, x, y, &right, &down);
    if (window_ray_at(&app->window, x, y, &ray)) {
        command_choose_ray(app, ray);
    } else if (is_inside && !app->window.ray_view.is_open) {
        edits_click(app, right, down);
    } else if (is_inside) {
        recorder_on_step(app, "pixel(%.17g, %.17g)", right, down);
        app_pick_pixel(app, right, down);
    }
}

/** @return Position of the mouse, fraction of the picture's width. @param x Screen units. */
static double picture_fraction(const App *app, int x) {
    double right, down;
    window_picture_position(&app->window, x, 0, &right, &down);
    return right;
}

/** Takes hold of what is under the mouse: a light, or the bar between two pictures. @return Whether
 *  there is any. */
static bool grab_at(App *app, int x, int y) {
    InputState *input = &app->input;
    const LightMark *mark = window_light_at(&app->window, x, y);
    input->is_light_dragged = mark != NULL;
    if (mark) {
        input->dragged_light = mark->light;
        app->selected_light = mark->light;
        return true;
    }
    double right, down;
    bool is_picture =
        !app->window.ray_view.is_open && window_picture_position(&app->window, x, y, &right, &down);
    input->is_object_dragged = is_picture && !window_is_at_bar(&app->window, right) &&
                               edits_grab(app, right, down, &input->dragged_point);
    if (input->is_object_dragged) {
        return true;
    }
    app->window.split.is_dragged =
        !app->window.ray_view.is_open && window_is_at_bar(&app->window, picture_fraction(app, x));
    return app->window.split.is_dragged;
}

/** Lets go of what the left button holds. */
static void end_drags(App *app) {
    InputState *input = &app->input;
    app->window.split.is_dragged = input->is_light_dragged = input->is_object_dragged =
        input->has_dragged = input->is_click_candidate = false;
}

/** Handles the left mouse button: it takes hold of something, or clicks on a pixel. */
static void on_left_button(App *app, const SDL_MouseButtonEvent *button) {
    InputState *input = &app->input;
    bool is_down = button->state == SDL_PRESSED;
    if (!is_down && input->is_click_candidate) {
        click_at(app, input->click_x, input->click_y);
    }
    if (!is_down && input->is_light_dragged && !input->has_dragged) {
        edits_click_light(app, input->dragged_light);
    }
    // A lesson restores camera and lights when it resumes, but neither bar nor rays.
    bool is_accepted = is_down && !app_is_playing(app);
    if (!is_down && input->is_object_dragged && !input->has_dragged) {
        click_at(app, button->x, button->y);
    }
    end_drags(app);
    input->is_click_candidate = is_accepted && !grab_at(app, button->x, button->y);
    input->click_x = button->x;
    input->click_y = button->y;
}

/** @return Whether the mouse has hardly moved since its button went down. */
static bool is_click_candidate(InputState *input, const SDL_MouseMotionEvent *mouse) {
    input->is_click_candidate = input->is_click_candidate &&
                                SDL_abs(mouse->x - input->click_x) <= CLICK_TOLERANCE &&
                                SDL_abs(mouse->y - input->click_y) <= CLICK_TOLERANCE;
    return input->is_click_candidate;
}

/** Drags the bar between two pictures. @param fraction New position, fraction of the width. */
static void drag_bar(App *app, double fraction) {
    fraction = SDL_clamp(fraction, 0, 1);
    recorder_on_step(app, "bar(%.17g)", fraction);
    window_move_bar(&app->window, fraction);
}

/** Drags the selected shape in the plane that faces the camera; with Shift, along the direction of
 *  view. */
static void drag_object(App *app, const SDL_MouseMotionEvent *mouse) {
    InputState *input = &app->input;
    const PictureDrag drag = {{(float)(mouse->x - mouse->xrel), (float)(mouse->y - mouse->yrel)},
                              {(float)mouse->x, (float)mouse->y},
                              input->modifiers & KMOD_SHIFT};
    Vec3d offset;
    if (window_drag_offset_at(&app->window, input->dragged_point, &drag, &offset)) {
        edits_drag(app, offset, input->has_dragged);
        input->dragged_point = vec3d_add(input->dragged_point, offset);
        input->has_dragged = true;
    }
}

/** Drags a light in the plane that faces the camera; with Shift, along the direction of view. */
static void drag_light(App *app, const SDL_MouseMotionEvent *mouse) {
    size_t light = app->input.dragged_light;
    GuiPoint to = {(float)mouse->x, (float)mouse->y};
    GuiPoint from = {(float)(mouse->x - mouse->xrel), (float)(mouse->y - mouse->yrel)};
    Vec3d offset;
    if (window_drag_offset(&app->window, light, from, to, app->input.modifiers & KMOD_SHIFT,
                           &offset)) {
        recorder_on_step(app, "drag(%zu, %.17g, %.17g, %.17g)", light + 1, offset.x, offset.y,
                         offset.z);
        app_drag_light(app, light, offset);
        app->input.has_dragged = true;
    }
}

/* --- the camera by mouse and fingers ------------------------------------------------------------
 */

/** @return The point that the camera is moved about: what is under the mouse, else the scene's
 *  centre, else what the camera looks at. @param x Screen units. */
static Vec3d find_camera_point(App *app, int x, int y) {
    const SceneCamera *camera = &app->scene->camera;
    Aabbd bounds = scene_bounds(app->scene);
    double right, down;
    Vec3d point;
    if (window_picture_position(&app->window, x, y, &right, &down) &&
        edits_point_at(app, right, down, &point)) {
        return point;
    }
    point = vec3d_scale(vec3d_add(bounds.low, bounds.high), 0.5);
    bool is_seen = aabbd_is_bounded(bounds) && bounds.low.x <= bounds.high.x &&
                   vec3d_dot(vec3d_subtract(point, camera->position), camera->direction) > 0;
    return is_seen ? point
                   : vec3d_add(camera->position,
                               vec3d_scale(camera->direction, camera->target_distance));
}

/** @return How a button moves the camera. The left one does it with Alt only. */
static CameraDrag camera_drag_of(const App *app, Uint8 button) {
    bool is_alt = app->input.modifiers & KMOD_LALT, is_shift = app->input.modifiers & KMOD_SHIFT;
    if (button == SDL_BUTTON_MIDDLE || (button == SDL_BUTTON_RIGHT && is_shift)) {
        return CAMERA_IS_PANNED;
    }
    return button == SDL_BUTTON_RIGHT || (button == SDL_BUTTON_LEFT && is_alt) ? CAMERA_IS_TURNED
                                                                               : CAMERA_IS_FREE;
}

/** Begins or ends to move the camera. @return Whether the button is one for that. */
static bool handle_camera_button(App *app, const SDL_MouseButtonEvent *button) {
    InputState *input = &app->input;
    if (button->state == SDL_RELEASED) {
        bool was_dragged = input->camera_drag != CAMERA_IS_FREE;
        input->camera_drag = CAMERA_IS_FREE;
        return was_dragged || button->button != SDL_BUTTON_LEFT;
    }
    CameraDrag drag = camera_drag_of(app, button->button);
    if (drag != CAMERA_IS_FREE && player_allows_input(app)) {
        input->camera_drag = drag;
        input->camera_point = find_camera_point(app, button->x, button->y);
    }
    return drag != CAMERA_IS_FREE || button->button != SDL_BUTTON_LEFT;
}

/** Moves the camera so that its point stays under the mouse. @param from Screen units. @param to
 *  The same. */
static void pan_camera(App *app, GuiPoint from, GuiPoint to) {
    const SceneCamera *camera = &app->scene->camera;
    const PictureDrag drag = {from, to, false};
    Vec3d offset;
    if (!app->window.ray_view.is_open && player_allows_input(app) &&
        window_drag_offset_at(&app->window, app->input.camera_point, &drag, &offset)) {
        double right = -vec3d_dot(offset, scene_camera_right(camera));
        double up = -vec3d_dot(offset, camera->up);
        recorder_on_step(app, "pan(%.17g, %.17g)", right, up);
        app_pan(app, right, up);
    }
}

/** Rotates the camera around its point: half a turn while the mouse crosses the window. */
static void orbit_camera(App *app, const SDL_MouseMotionEvent *mouse) {
    const Vec3d *point = &app->input.camera_point;
    double degrees = ORBIT_PER_WINDOW / mouse_window_width(app);
    double right = mouse->xrel * degrees, up = -mouse->yrel * degrees;
    if (player_allows_input(app)) {
        recorder_on_step(app, "orbit(%.17g, %.17g, %.17g, %.17g, %.17g)", right, up, point->x,
                         point->y, point->z);
        app_orbit(app, right, up, *point);
    }
}

/** Handles two fingers: their middle pans, their distance zooms. The first of them was a mouse
 *  button until now. */
static void on_fingers(App *app, const SDL_MultiGestureEvent *fingers) {
    InputState *input = &app->input;
    int width = 1, height = 1;
    if (fingers->numFingers != 2 || !player_allows_input(app)) {
        return;
    }
    SDL_GetWindowSize(app->window.sdl.window, &width, &height);
    GuiPoint to = {fingers->x * (float)width, fingers->y * (float)height};
    GuiPoint from = {input->pinch_x * (float)width, input->pinch_y * (float)height};
    if (input->is_pinching) {
        double notches = PINCH_NOTCHES * (double)fingers->dDist;
        pan_camera(app, from, to);
        recorder_on_step(app, "zoom(%.17g)", notches);
        app_zoom(app, notches);
    } else {
        end_drags(app);
        input->camera_point = find_camera_point(app, (int)to.x, (int)to.y);
    }
    input->is_pinching = true;
    input->pinch_x = fingers->x;
    input->pinch_y = fingers->y;
}

/* --- events of the mouse ------------------------------------------------------------------------
 */

/** Handles a mouse button. */
static void on_button(App *app, const SDL_MouseButtonEvent *button) {
    app->input.is_pinching = false;
    if (!handle_camera_button(app, button)) {
        on_left_button(app, button);
    }
}

/** Handles a mouse motion: drags a light or the bar, or turns the camera by the angle that the
 * mouse crosses.
 */
static void on_motion(App *app, const SDL_MouseMotionEvent *mouse) {
    int width = mouse_window_width(app);
    if (app->input.is_pinching) {
        return; // The mouse is one of two fingers.
    }
    if (app->input.camera_drag == CAMERA_IS_TURNED) {
        orbit_camera(app, mouse);
    } else if (app->input.camera_drag == CAMERA_IS_PANNED) {
        pan_camera(app,
                   (GuiPoint){(float)(mouse->x - mouse->xrel), (float)(mouse->y - mouse->yrel)},
                   (GuiPoint){(float)mouse->x, (float)mouse->y});
    } else if (app->input.is_light_dragged) {
        drag_light(app, mouse);
    } else if (app->input.is_object_dragged) {
        drag_object(app, mouse);
    } else if (app->window.split.is_dragged) {
        drag_bar(app, picture_fraction(app, mouse->x));
    } else if (!(mouse->state & SDL_BUTTON_LMASK) || is_click_candidate(&app->input, mouse)) {
        return;
    } else if (player_allows_input(app)) {
        bool is_orbiting = app->window.ray_view.is_open;
        double degrees = (is_orbiting ? ORBIT_PER_WINDOW : app->scene->camera.fov) / width;
        double right = mouse->xrel * degrees, up = -mouse->yrel * degrees;
        recorder_on_step(app, "turn(%.17g, %.17g)", right, up);
        app_turn(app, right, up);
    }
}

/** Handles the wheel: away from the user zooms in. */
static void on_wheel(App *app, const SDL_MouseWheelEvent *wheel) {
    if (player_allows_input(app)) {
        recorder_on_step(app, "zoom(%.17g)", (double)wheel->preciseY);
        app_zoom(app, (double)wheel->preciseY);
    }
}

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

/** Handles an event while the list of scenes is open. @return Whether it was for the list. */
static bool handle_browser_event(App *app, const SDL_Event *event) {
    Browser *browser = &app->window.browser;
    if (!browser->is_open) {
        return false;
    }
    switch (event->type) {
    case SDL_KEYDOWN:
        if (event->key.keysym.mod & (KMOD_CTRL | WINDOW_MANAGER_MODIFIERS)) {
            return false;
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
        end_all_moves(app, event_time(event->timestamp));
        break;
    default:
        break;
    }
}

/** Handles another keyboard layout. */
static void on_keymap(App *app, double time) {
    end_all_moves(app, time);
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
    return gui_handle_event(app->window.gui, event);
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

void input_handle_event(App *app, const SDL_Event *event) {
    if (handle_widget_event(app, event) || recorder_handle_caption_event(app, event) ||
        handle_browser_event(app, event) || handle_help_event(app, event)) {
        return;
    }
    switch (event->type) {
    case SDL_KEYDOWN:
    case SDL_KEYUP:
        on_key(app, &event->key);
        break;
    case SDL_MOUSEMOTION:
        on_motion(app, &event->motion);
        break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
        on_button(app, &event->button);
        break;
    case SDL_MULTIGESTURE:
        on_fingers(app, &event->mgesture);
        break;
    case SDL_MOUSEWHEEL:
        on_wheel(app, &event->wheel);
        break;
    case SDL_WINDOWEVENT:
        on_window(app, &event->window);
        break;
    case SDL_DROPFILE:
        player_open_file(app, event->drop.file);
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
        app->exit.is_requested = true;
        break;
    default:
        on_app_event(app, event);
        break;
    }
}
