/**
 * @file
 * @brief What the pixel under the mouse shows, or the one that is magnified: read once per frame,
 *        and shown where it hides neither that pixel nor the picture's edge there.
 */
#include "view/panels/pixel_readout.h"
#include "view/window_internal.h"

/** How near to the readout the pixel may be until that goes to the upper edge, in heights of
 *  letters. */
static const float REACH = 1;
/** The same until it comes back: it does not go to and fro. */
static const float REACH_BACK = 3;

/* --- which pixel ------------------------------------------------------------------------------ */

bool window_picture_is_shown(const Window *window) {
    return !window->help.is_open && !window->browser.is_open && !window->ray_view.is_open;
}

/** Finds the pixel under the mouse. @return false if the mouse is not on the picture. */
static bool pixel_under_mouse(const Window *window, PixelPosition *pixel) {
    const Viewport *viewport = &window->viewports[0];
    int x = 0, y = 0;
    double right, down;
    SDL_GetMouseState(&x, &y);
    if (SDL_GetMouseFocus() != window->sdl.window ||
        !window_picture_position(window, x, y, &right, &down)) {
        return false;
    }
    *pixel = (PixelPosition){(int)(right * viewport->width), (int)(down * viewport->height)};
    return true;
}

bool window_named_pixel(const Window *window, PixelPosition *pixel) {
    if (!window->gui || !window_picture_is_shown(window)) {
        return false;
    }
    if (window->magnifier.is_on && window->magnifier.has_place) {
        *pixel = window->magnifier.pixel;
        return true;
    }
    return !gui_has_mouse() && pixel_under_mouse(window, pixel);
}

void window_follow_mouse(Window *window) {
    PixelPosition mouse;
    const Viewport *viewport = &window->viewports[0];
    bool is_there = pixel_under_mouse(window, &mouse);
    magnifier_follow(&window->magnifier, is_there ? &mouse : NULL, SDL_max(1, viewport->width),
                     SDL_max(1, viewport->height));
}

/* --- what it shows ---------------------------------------------------------------------------- */

/** Reads a pixel of all pictures. @return false if one has no pass yet. */
static bool read_pixels(const Window *window, int x, int y, PixelReadout *readout) {
    *readout = (PixelReadout){
        .scene = window->state.scene, .x = x, .y = y, .is_magnified = window->magnifier.is_on};
    for (size_t i = 0; i < window_viewport_count(window); i++) {
        Renderer *renderer = window->viewports[i].renderer;
        if (!renderer || !renderer_read_pixel(renderer, x, y, &readout->readings[i])) {
            return false;
        }
        readout->count++;
    }
    readout->samples = window->viewports[0].report.samples;
    return true;
}

/** @return Whether the readout is wanted, and nothing is to be read in its place. */
static bool is_readout_wanted(const Window *window) {
    // It would cover a part of what a question is about.
    bool is_in_the_way = window->toolbar.is_folded || window->lesson_panel.is_asking;
    return (window->magnifier.is_on || !is_in_the_way) && window->hint.text[0] == '\0';
}

/* --- where it lies ---------------------------------------------------------------------------- */

GuiPoint window_pixel_place(const Window *window, const PixelPosition *pixel) {
    const Viewport *viewport = &window->viewports[0];
    const SDL_Rect picture = window_to_units(window, window_picture_rect(window));
    return (GuiPoint){(float)(picture.x + (pixel->x + 0.5) / viewport->width * picture.w),
                      (float)(picture.y + (pixel->y + 0.5) / viewport->height * picture.h)};
}

/** @return Whether a point is near a part of the window. @param reach How near, screen units. */
static bool is_near(GuiPoint point, const GuiRect *rect, float reach) {
    return point.x >= rect->x - reach && point.x < rect->x + rect->width + reach &&
           point.y >= rect->y - reach && point.y < rect->y + rect->height + reach;
}

/** @return Whether the pixel of the readout is near a part of the window, or one that a lesson
 * marks.
 *  @param reach How near, screen units. */
static bool is_pixel_near(const Window *window, const GuiRect *rect, float reach) {
    const Readout *readout = &window->readout;
    const Viewport *viewport = &window->viewports[0];
    const RayView *marked = &window->ray_view;
    const PixelPosition read = {readout->pixel.x, readout->pixel.y};
    const PixelPosition mark = {(int)(marked->x * viewport->width),
                                (int)(marked->y * viewport->height)};
    return is_near(window_pixel_place(window, &read), rect, reach) ||
           (marked->is_marked && is_near(window_pixel_place(window, &mark), rect, reach));
}

/** Finds where the readout lies: at the lower edge of its area. It lies at the upper edge while a
 *  pixel of interest is near the lower one, if it would cover the picture there and no caption is
 *  open. */
static void place_readout(Window *window) {
    Readout *readout = &window->readout;
    const GuiRect area = window_area_units(window);
    const SDL_Rect picture = window_to_units(window, window_picture_rect(window));
    const GuiRect edges = {(float)picture.x, (float)picture.y, (float)picture.w, (float)picture.h};
    const GuiReadoutPlace lower = {{area.x, area.y + area.height}, area.x + area.width, GUI_ABOVE};
    const GuiReadoutPlace upper = {
        {area.x, window_area_below_button(window).y}, area.x + area.width, GUI_BELOW};
    const GuiRect below = gui_readout_rect(readout->text, &lower);
    const GuiRect above = gui_readout_rect(readout->text, &upper);
    const float reach = (readout->is_above ? REACH_BACK : REACH) * gui_text_size();
    readout->is_above = is_pixel_near(window, &below, reach) && rects_overlap(&below, &edges) &&
                        !is_pixel_near(window, &above, 0) && !caption_is_open(&window->caption);
    readout->rect = readout->is_above ? above : below;
}

void window_read_pixel(Window *window) {
    Readout *readout = &window->readout;
    PixelPosition pixel;
    const bool is_wanted = is_readout_wanted(window);
    readout->is_read = (is_wanted || window->magnifier.is_on) &&
                       window_named_pixel(window, &pixel) &&
                       read_pixels(window, pixel.x, pixel.y, &readout->pixel);
    readout->is_shown = readout->is_read && is_wanted;
    readout->is_above = readout->is_above && readout->is_shown;
    if (readout->is_shown) {
        pixel_readout_write(&readout->pixel, readout->text);
        place_readout(window);
    }
}

GuiRect window_area_beside_readout(const Window *window, GuiRect area) {
    const Readout *readout = &window->readout;
    const float height = readout->is_shown ? readout->rect.height : 0;
    area.y += readout->is_above ? height : 0;
    area.height = SDL_max(1, area.height - height);
    return area;
}

void window_show_readout(const Window *window) {
    const Readout *readout = &window->readout;
    if (readout->is_shown) {
        const size_t side = window_is_right_side(window, readout->pixel.x) ? 1 : 0;
        const GuiRect *rect = &readout->rect, area = window_area_units(window);
        const float edge = readout->is_above ? rect->y : rect->y + rect->height;
        gui_readout("readout", readout->text, readout->pixel.readings[side].rgb,
                    &(GuiReadoutPlace){{rect->x, edge},
                                       area.x + area.width,
                                       readout->is_above ? GUI_BELOW : GUI_ABOVE});
    }
}
