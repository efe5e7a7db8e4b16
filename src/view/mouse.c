/**
 * @file
 * @brief What the mouse does to the view.
 */
#include "view/mouse.h"

#include "view/controls.h"

#include <stdio.h>

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
        inspector_pick(&view->stage.inspector, (x - room.x + 0.5) / room.w,
                       (y - room.y + 0.5) / room.h);
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
    view->stage.split.is_dragged =
        is_down && !view->stage.inspector.is_open && stage_is_at_bar(&view->stage, share);
    view->is_click = is_down && !view->stage.split.is_dragged && player_leaves_view(view);
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

/** The mouse was dragged around rays. @param[in,out] view The view. @param mouse The event. */
static void drag_around(View *view, const SDL_MouseMotionEvent *mouse) {
    int width = 1, height = 1;
    SDL_GetWindowSize(view->stage.display.window, &width, &height);
    inspector_drag(&view->stage.inspector, (double)mouse->xrel / SDL_max(1, width),
                   (double)mouse->yrel / SDL_max(1, height));
}

void mouse_motion(View *view, const SDL_MouseMotionEvent *mouse) {
    int width = window_width(view);
    if (view->stage.split.is_dragged) {
        stage_move_bar(&view->stage, (double)mouse->x / width);
    } else if (!(mouse->state & SDL_BUTTON_LMASK) || is_still(view, mouse)) {
        return;
    } else if (view->stage.inspector.is_open) {
        drag_around(view, mouse);
    } else if (player_leaves_view(view)) {
        char step[STEP_SIZE];
        double degrees = view->scene->camera.fov / width;
        double right = mouse->xrel * degrees, up = -mouse->yrel * degrees;
        snprintf(step, sizeof step, "turn(%.17g, %.17g)", right, up);
        recorder_note(view, step);
        controls_turn(view, right, up);
    }
}

void mouse_wheel(View *view, const SDL_MouseWheelEvent *wheel) {
    if (view->stage.inspector.is_open) {
        inspector_move(&view->stage.inspector, (Movement){.forward = (double)wheel->preciseY / 8});
    } else if (player_leaves_view(view)) {
        char step[STEP_SIZE];
        snprintf(step, sizeof step, "zoom(%.17g)", (double)wheel->preciseY);
        recorder_note(view, step);
        controls_zoom(view, (double)wheel->preciseY);
    }
}
