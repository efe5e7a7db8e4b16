/**
 * @file
 * @brief What the mouse does to the view.
 */
#include "view/mouse.h"

#include "view/controls.h"

#include <stdio.h>

/** Degrees that the second camera turns around rays while the mouse crosses the window. */
static const double AROUND = 180;

/** @return Width of the window, in the screen's units. @param view The view. */
static int window_width(const View *view) {
    int width = 1;
    SDL_GetWindowSize(view->stage.display.window, &width, NULL);
    return SDL_max(1, width);
}

/** Shows the rays of the pixel that was clicked on: in the picture, or in the small one while rays
 * are shown. @param[in,out] view The view. @param x Where, units of the screen. @param y Where. */
static void click(View *view, int x, int y) {
    SDL_Rect room = {0};
    SDL_GetWindowSize(view->stage.display.window, &room.w, &room.h);
    if (view->stage.inspector.is_open) {
        room = inspector_inset(room.w, room.h);
    }
    if (SDL_PointInRect(&(SDL_Point){x, y}, &room)) {
        char step[STEP_SIZE];
        double right = (x - room.x + 0.5) / room.w, down = (y - room.y + 0.5) / room.h;
        snprintf(step, sizeof step, "pixel(%.17g, %.17g)", right, down);
        recorder_note(view, step);
        controls_pick(view, right, down);
    }
}

void mouse_button(View *view, const SDL_MouseButtonEvent *button) {
    bool is_down = button->state == SDL_PRESSED;
    if (button->button != SDL_BUTTON_LEFT) {
        return;
    }
    if (!is_down && view->is_click) {
        click(view, view->click_x, view->click_y);
    }
    double share = (double)button->x / window_width(view);
    bool is_ours = is_down && !player_is_on(view); // A lesson puts back a view, not what is shown.
    view->stage.split.is_dragged =
        is_ours && !view->stage.inspector.is_open && stage_is_at_bar(&view->stage, share);
    view->is_click = is_ours && !view->stage.split.is_dragged;
    view->click_x = button->x;
    view->click_y = button->y;
}

/** @return Whether the mouse has hardly moved since its button went down: it may become a click.
 *  @param[in,out] view The view. @param mouse The event. */
static bool is_still(View *view, const SDL_MouseMotionEvent *mouse) {
    /** Units of the screen that a hand moves when it clicks. */
    const int tremor = 3;
    view->is_click = view->is_click && SDL_abs(mouse->x - view->click_x) <= tremor &&
                     SDL_abs(mouse->y - view->click_y) <= tremor;
    return view->is_click;
}

/** The bar between two pictures is dragged. @param[in,out] view The view. @param share To where, of
 *  the window's width. */
static void drag_bar(View *view, double share) {
    char step[STEP_SIZE];
    share = SDL_clamp(share, 0, 1);
    snprintf(step, sizeof step, "bar(%.17g)", share);
    recorder_note(view, step);
    stage_move_bar(&view->stage, share);
}

void mouse_motion(View *view, const SDL_MouseMotionEvent *mouse) {
    int width = window_width(view);
    if (view->stage.split.is_dragged) {
        drag_bar(view, (double)mouse->x / width);
    } else if (!(mouse->state & SDL_BUTTON_LMASK) || is_still(view, mouse)) {
        return;
    } else if (player_leaves_view(view)) {
        char step[STEP_SIZE];
        bool is_around = view->stage.inspector.is_open;
        double degrees = (is_around ? AROUND : view->scene->camera.fov) / width;
        double right = mouse->xrel * degrees, up = -mouse->yrel * degrees;
        snprintf(step, sizeof step, "turn(%.17g, %.17g)", right, up);
        recorder_note(view, step);
        controls_turn(view, right, up);
    }
}

void mouse_wheel(View *view, const SDL_MouseWheelEvent *wheel) {
    if (player_leaves_view(view)) {
        char step[STEP_SIZE];
        snprintf(step, sizeof step, "zoom(%.17g)", (double)wheel->preciseY);
        recorder_note(view, step);
        controls_zoom(view, (double)wheel->preciseY);
    }
}
