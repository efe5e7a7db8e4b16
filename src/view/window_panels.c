/**
 * @file
 * @brief Panels on the pictures: settings, costs, notices, and the caption where it hides least.
 */
#include "view/panels/picture_unrest.h"
#include "view/window_internal.h"

#include "base/language.h"

#include <string.h>

/** How much calmer another side must be until a caption goes there. */
static const double UNREST_RATIO = 1.5;

void window_show_huds(Window *window, const GuiRect *area) {
    static const char *const ids[WINDOW_VIEWPORTS] = {"panel 1", "panel 2"};
    static const char *const titles[2][WINDOW_VIEWPORTS] = {{N_("left"), N_("right")},
                                                            {N_("left ←"), N_("right ←")}};
    size_t count = window->ray_view.is_open ? 0 : window_viewport_count(window);
    memset(window->hud_rects, 0, sizeof window->hud_rects);
    for (size_t i = 0; i < count; i++) {
        bool is_active = window->split.active == i;
        HudContent content = {.viewport = &window->viewports[i],
                              .title = count > 1 ? titles[is_active][i] : NULL,
                              .shows_settings = window->shows_settings};
        hud_update(&window->huds[i], &content, clock_now_seconds());
        GuiPlace place = {*area, (float)i, 0};
        place.room.width = area->width / (float)count;
        place.room.x += (float)i * place.room.width;
        window->hud_rects[i] = hud_show(&window->huds[i], ids[i], &place);
    }
}

bool rects_overlap(const GuiRect *a, const GuiRect *b) {
    return a->x < b->x + b->width && b->x < a->x + a->width && a->y < b->y + b->height &&
           b->y < a->y + a->height;
}

/** @return Whether a part of the window holds a legend, settings, or what lies outside of a room.
 */
static bool is_taken(const Window *window, const GuiRect *rect, const GuiRect *room) {
    bool is_inside = rect->y >= room->y && rect->y + rect->height <= room->y + room->height;
    bool is_free = is_inside;
    for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
        is_free = is_free && !rects_overlap(rect, &window->hud_rects[i]) &&
                  !rects_overlap(rect, &window->legend_rects[i]);
    }
    return !is_free;
}

/** @return How much the picture changes under a part of the window: its variance. */
static double unrest_below(const Window *window, const GuiRect *rect) {
    SDL_Rect picture = window_to_units(window, window_picture_rect(window));
    double left = ((double)rect->x - picture.x) / picture.w;
    double top = ((double)rect->y - picture.y) / picture.h;
    return picture_unrest(&window->viewports[0],
                          &(PicturePart){left, top, left + (double)rect->width / picture.w,
                                         top + (double)rect->height / picture.h});
}

/** Chooses the side of the picture at which the caption hides least: never a legend, unless there
 *  is no other room. @param room The room for it. */
static void choose_caption_side(Window *window, const GuiRect *room) {
    Caption *caption = &window->caption;
    double least = HUGE_VAL;
    CaptionSide best = CAPTION_BELOW;
    for (CaptionSide side = CAPTION_BELOW; side < CAPTION_SIDE_COUNT; side++) {
        GuiRect rect = caption_rect(caption, room, side);
        double unrest = unrest_below(window, &rect);
        // What has a place keeps it while the picture moves a little.
        unrest *= side == caption->side ? 1 / UNREST_RATIO : 1;
        if (unrest < least && !is_taken(window, &rect, room)) {
            least = unrest;
            best = side;
        }
    }
    caption->side = best;
}

float window_show_captions(Window *window, const GuiRect *area) {
    GuiRect room = *area;
    float notice = notice_show(&window->notice, &room);
    room.height = SDL_max(1, room.height - notice);
    if (!caption_is_open(&window->caption)) {
        return room.y + room.height;
    }
    if (!window->ray_view.is_open) {
        choose_caption_side(window, &room);
    }
    GuiRect caption = caption_show(&window->caption, &room);
    return window->caption.side == CAPTION_BELOW ? caption.y : room.y + room.height;
}
