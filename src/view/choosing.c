/**
 * @file
 * @brief Choosing a scene: what events do to the list of scenes.
 */
#include "view/choosing.h"

#include "view/font.h"
#include "view/scenes.h"

/** @return The room that the list has. @param view The view. */
static PanelRoom room_of(const View *view) {
    const OverlayScreen screen = {view->stage.display.renderer,
                                  view->stage.text_scale > 0 ? view->stage.text_scale : 1, 1};
    return overlay_room(&screen);
}

/** @return Whether a lesson is about the scene that is shown; then says so. @param[in,out] view The
 *  view. */
static bool is_bound(View *view) {
    bool is_bound = player_is_on(view) || recorder_is_on(view);
    if (is_bound) {
        view_note(view, "a lesson keeps to its scene");
    }
    return is_bound;
}

void choosing_begin(View *view) {
    if (is_bound(view)) {
        return;
    }
    if (!view->settings->preview || !font_is_there() ||
        !browser_open(&view->stage.browser, view->settings, view->first_event + EVENT_LIST,
                      view->path)) {
        view_note(view, "no list of scenes can be shown");
    }
    stage_present(&view->stage);
}

/** Does what became of a key or a click. @param[in,out] view The view. @param answer What. */
static void follow(View *view, BrowserAnswer answer) {
    Browser *browser = &view->stage.browser;
    char path[PATH_MAX];
    if (answer == BROWSER_OPENS && browser_choice(browser, path)) {
        scenes_open(view, path);
    }
    if (answer != BROWSER_STAYS) {
        browser_close(browser);
    }
    stage_present(&view->stage);
}

/** Takes a click. @param[in,out] view The view. @param click The event. @param room The room. */
static void take_click(View *view, const SDL_MouseButtonEvent *click, const PanelRoom *room) {
    int width = 1, height = 1;
    SDL_GetWindowSize(view->stage.display.window, &width, &height);
    int x = click->x * room->width / SDL_max(1, width);
    int y = click->y * room->height / SDL_max(1, height);
    follow(view, browser_click(&view->stage.browser, x, y, room));
}

bool choosing_takes(View *view, const SDL_Event *event) {
    Browser *browser = &view->stage.browser;
    if (!browser->is_open) {
        return false;
    }
    PanelRoom room = room_of(view);
    switch (event->type) {
    case SDL_KEYDOWN:
        follow(view, browser_key(browser, event->key.keysym.sym, &room));
        return true;
    case SDL_MOUSEBUTTONDOWN:
        take_click(view, &event->button, &room);
        return true;
    case SDL_MOUSEWHEEL:
        browser_scroll(browser, -event->wheel.y, &room);
        stage_present(&view->stage);
        return true;
    default:
        return event->type == SDL_MOUSEMOTION;
    }
}

void choosing_on_news(View *view) {
    Browser *browser = &view->stage.browser;
    PanelRoom room = room_of(view);
    if (browser->is_wanted) {
        choosing_begin(view);
    }
    if (browser->is_open) {
        browser_place(browser, &room);
    }
    overlay_forget(&browser->overlay);
    stage_present(&view->stage);
}
