/**
 * @file
 * @brief What the mouse does to the view.
 */
#include "view/input/mouse.h"

#include "view/input/input.h"

#include <stdio.h>

/** Degrees that the second camera turns around rays while the mouse crosses the window. */
static const double ORBIT_PER_WINDOW = 180;

/** @return Width of the window, in the screen's units. */
static int mouse_window_width(const App *app) {
    int width = 1;
    SDL_GetWindowSize(app->window.sdl.window, &width, NULL);
    return SDL_max(1, width);
}

/** Shows the rays of the pixel that was clicked on: in the picture, or in the small one while rays
 *  are shown. @param x Where, units of the screen. */
static void pick_at(App *app, int x, int y) {
    SDL_Rect rect = {0};
    SDL_GetWindowSize(app->window.sdl.window, &rect.w, &rect.h);
    if (app->window.inspector.is_open) {
        rect = inspector_inset(rect.w, rect.h);
    }
    if (SDL_PointInRect(&(SDL_Point){x, y}, &rect)) {
        char step[LESSON_STEP_TEXT_SIZE];
        double right = (x - rect.x + 0.5) / rect.w, down = (y - rect.y + 0.5) / rect.h;
        snprintf(step, sizeof step, "pixel(%.17g, %.17g)", right, down);
        recorder_record_step(app, step);
        app_pick_pixel(app, right, down);
    }
}

void mouse_on_button(App *app, const SDL_MouseButtonEvent *button) {
    bool is_down = button->state == SDL_PRESSED;
    if (button->button != SDL_BUTTON_LEFT) {
        return;
    }
    if (!is_down && app->is_click_candidate) {
        pick_at(app, app->click_x, app->click_y);
    }
    double fraction = (double)button->x / mouse_window_width(app);
    bool is_accepted =
        is_down && !player_is_active(app); // A lesson puts back a view, not what is shown.
    app->window.split.is_dragged =
        is_accepted && !app->window.inspector.is_open && window_is_at_bar(&app->window, fraction);
    app->is_click_candidate = is_accepted && !app->window.split.is_dragged;
    app->click_x = button->x;
    app->click_y = button->y;
}

/** @return Whether the mouse has hardly moved since its button went down: it may become a click. */
static bool is_click_candidate(App *app, const SDL_MouseMotionEvent *mouse) {
    /** Units of the screen that a hand moves when it clicks. */
    const int click_tolerance = 3;
    app->is_click_candidate = app->is_click_candidate &&
                              SDL_abs(mouse->x - app->click_x) <= click_tolerance &&
                              SDL_abs(mouse->y - app->click_y) <= click_tolerance;
    return app->is_click_candidate;
}

/** The bar between two pictures is dragged. @param fraction To where, of the window's width. */
static void drag_bar(App *app, double fraction) {
    char step[LESSON_STEP_TEXT_SIZE];
    fraction = SDL_clamp(fraction, 0, 1);
    snprintf(step, sizeof step, "bar(%.17g)", fraction);
    recorder_record_step(app, step);
    window_move_bar(&app->window, fraction);
}

void mouse_on_motion(App *app, const SDL_MouseMotionEvent *mouse) {
    int width = mouse_window_width(app);
    if (app->window.split.is_dragged) {
        drag_bar(app, (double)mouse->x / width);
    } else if (!(mouse->state & SDL_BUTTON_LMASK) || is_click_candidate(app, mouse)) {
        return;
    } else if (player_allows_input(app)) {
        char step[LESSON_STEP_TEXT_SIZE];
        bool is_orbiting = app->window.inspector.is_open;
        double degrees = (is_orbiting ? ORBIT_PER_WINDOW : app->scene->camera.fov) / width;
        double right = mouse->xrel * degrees, up = -mouse->yrel * degrees;
        snprintf(step, sizeof step, "turn(%.17g, %.17g)", right, up);
        recorder_record_step(app, step);
        app_turn(app, right, up);
    }
}

void mouse_on_wheel(App *app, const SDL_MouseWheelEvent *wheel) {
    if (player_allows_input(app)) {
        char step[LESSON_STEP_TEXT_SIZE];
        snprintf(step, sizeof step, "zoom(%.17g)", (double)wheel->preciseY);
        recorder_record_step(app, step);
        app_zoom(app, (double)wheel->preciseY);
    }
}
