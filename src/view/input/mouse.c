/**
 * @file
 * @brief Mouse and fingers: clicks, drags, the wheel.
 */
#include "view/commands/commands.h"
#include "view/commands/edits.h"
#include "view/commands/recorder.h"
#include "view/input/devices.h"
#include "view/lesson/player.h"

/** Degrees that the second camera turns around rays while the mouse crosses the window. */
static const double ORBIT_PER_WINDOW = 180;
/** Notches of the wheel while two fingers spread from one point across the window. */
static const double PINCH_NOTCHES = 30;
/** Screen units that the mouse may move during a click. */
static const int CLICK_TOLERANCE = 3;

/* --- the left button: clicks and drags -----------------------------------------------------------
 */

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
        command_show_rays(app, right, down);
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
        bool is_holding = button->button == input->camera_button;
        if (is_holding) {
            input->camera_drag = CAMERA_IS_FREE;
            input->camera_button = 0;
        }
        return is_holding || button->button != SDL_BUTTON_LEFT;
    }
    CameraDrag drag = camera_drag_of(app, button->button);
    if (drag != CAMERA_IS_FREE && input->camera_button == 0 && player_allows_input(app)) {
        input->camera_drag = drag;
        input->camera_button = button->button;
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

void mouse_on_fingers(App *app, const SDL_MultiGestureEvent *fingers) {
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

void mouse_on_button(App *app, const SDL_MouseButtonEvent *button) {
    app->input.is_pinching = false;
    if (!handle_camera_button(app, button)) {
        on_left_button(app, button);
    }
}

/** Does what a motion does with what the mouse holds. */
static void drag(App *app, const SDL_MouseMotionEvent *mouse) {
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

void mouse_on_motion(App *app, const SDL_MouseMotionEvent *mouse) {
    drag(app, mouse);
    if (app->window.viewports[0].needs_restart) {
        latency_on_input(&app->window.latency, input_event_time(mouse->timestamp));
    }
}

void mouse_on_wheel(App *app, const SDL_MouseWheelEvent *wheel) {
    if (player_allows_input(app)) {
        recorder_on_step(app, "zoom(%.17g)", (double)wheel->preciseY);
        app_zoom(app, (double)wheel->preciseY);
    }
}
