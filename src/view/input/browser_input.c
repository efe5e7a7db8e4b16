/**
 * @file
 * @brief Choosing a scene: what events do to the list of scenes.
 */
#include "view/input/browser_input.h"

#include "view/loading/current_scene.h"
#include "view/window/font.h"

/** @return The room that the list has. */
static PanelBounds browser_bounds(const App *app) {
    const OverlayTarget target = {app->window.sdl.renderer,
                                  app->window.text_scale > 0 ? app->window.text_scale : 1, 1};
    return overlay_bounds(&target);
}

/** @return Whether a lesson is about the scene that is shown; then says so. */
static bool is_locked_by_lesson(App *app) {
    bool is_locked = player_is_active(app) || recorder_is_active(app);
    if (is_locked) {
        app_set_status(app, "a lesson keeps to its scene");
    }
    return is_locked;
}

void browser_input_open(App *app) {
    if (is_locked_by_lesson(app)) {
        return;
    }
    if (!app->settings->preview || !font_is_available() ||
        !browser_open(&app->window.browser, app->settings,
                      app->first_event + EVENT_SCENE_LIST_CHANGED, app->path)) {
        app_set_status(app, "no list of scenes can be shown");
    }
    window_present(&app->window);
}

/** Does what became of a key or a click. */
static void apply_result(App *app, BrowserResult result) {
    Browser *browser = &app->window.browser;
    char path[PATH_MAX];
    if (result == BROWSER_OPEN_SCENE && browser_selected_path(browser, path)) {
        current_scene_open(app, path);
    }
    if (result != BROWSER_KEEP_OPEN) {
        browser_close(browser);
    }
    window_present(&app->window);
}

/** Takes a click. */
static void handle_click(App *app, const SDL_MouseButtonEvent *click, const PanelBounds *bounds) {
    int width = 1, height = 1;
    SDL_GetWindowSize(app->window.sdl.window, &width, &height);
    int x = click->x * bounds->width / SDL_max(1, width);
    int y = click->y * bounds->height / SDL_max(1, height);
    apply_result(app, browser_click(&app->window.browser, x, y, bounds));
}

bool browser_input_handle(App *app, const SDL_Event *event) {
    Browser *browser = &app->window.browser;
    if (!browser->is_open) {
        return false;
    }
    PanelBounds bounds = browser_bounds(app);
    switch (event->type) {
    case SDL_KEYDOWN:
        apply_result(app, browser_key(browser, event->key.keysym.sym, &bounds));
        return true;
    case SDL_MOUSEBUTTONDOWN:
        handle_click(app, &event->button, &bounds);
        return true;
    case SDL_MOUSEWHEEL:
        browser_scroll(browser, -event->wheel.y, &bounds);
        window_present(&app->window);
        return true;
    default:
        return event->type == SDL_MOUSEMOTION;
    }
}

void browser_input_on_list_changed(App *app) {
    Browser *browser = &app->window.browser;
    PanelBounds bounds = browser_bounds(app);
    if (browser->is_reopen_pending) {
        browser_input_open(app);
    }
    if (browser->is_open) {
        browser_select_current(browser, &bounds);
    }
    overlay_invalidate(&browser->overlay);
    window_present(&app->window);
}
