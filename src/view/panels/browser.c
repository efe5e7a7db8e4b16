/**
 * @file
 * @brief The list of scenes: opening, selecting, closing.
 */
#include "view/panels/browser.h"

#include <string.h>

bool browser_open(Browser *browser, const ViewSettings *settings, uint32_t event,
                  const char *path) {
    if (scene_list_is_busy(&browser->list)) {
        // Its thread is ending, and sends an event then; until then the previous list is shown.
        browser->is_open = browser->is_reopen_pending = true;
        return true;
    }
    scene_list_deinit(&browser->list);
    browser->is_open = scene_list_start(&browser->list, settings, event, path);
    browser->is_reopen_pending = browser->is_current_selected = false;
    SDL_strlcpy(browser->path, path, sizeof browser->path);
    browser->selected = browser->first_row = 0;
    overlay_invalidate(&browser->overlay);
    return browser->is_open;
}

void browser_close(Browser *browser) {
    browser->is_open = browser->is_reopen_pending = false;
    scene_list_request_stop(&browser->list);
    overlay_invalidate(&browser->overlay);
}

void browser_deinit(Browser *browser) {
    browser_close(browser);
    scene_list_deinit(&browser->list);
}

/** @return Number of scenes found by now. */
static size_t browser_scene_count(Browser *browser) {
    scene_list_lock(&browser->list);
    size_t scenes = browser->list.count;
    scene_list_unlock(&browser->list);
    return scenes;
}

/** Selects a scene, and scrolls to it. @param index Clamped to the list. */
static void browser_select(Browser *browser, long index, const PanelBounds *bounds) {
    BrowserGrid grid = browser_panel_grid(bounds);
    long last = (long)browser_scene_count(browser) - 1;
    browser->selected = (size_t)SDL_max(0, SDL_min(index, last));
    size_t row = browser->selected / (size_t)grid.columns, rows = (size_t)grid.rows;
    if (row < browser->first_row) {
        browser->first_row = row;
    } else if (row >= browser->first_row + rows) {
        browser->first_row = row - rows + 1;
    }
    overlay_invalidate(&browser->overlay);
}

void browser_select_current(Browser *browser, const PanelBounds *bounds) {
    size_t scenes = browser_scene_count(browser);
    for (size_t i = 0; i < scenes && !browser->is_current_selected; i++) {
        if (strcmp(browser->list.scenes[i].path, browser->path) == 0) {
            browser_select(browser, (long)i, bounds);
            browser->is_current_selected = true;
        }
    }
    browser->is_current_selected = browser->is_current_selected || scenes > 0;
}

BrowserResult browser_key(Browser *browser, SDL_Keycode key, const PanelBounds *bounds) {
    BrowserGrid grid = browser_panel_grid(bounds);
    long current = (long)browser->selected, page = (long)grid.columns * grid.rows;
    const struct {
        SDL_Keycode key;
        long index;
    } moves[] = {{SDLK_LEFT, current - 1},
                 {SDLK_RIGHT, current + 1},
                 {SDLK_UP, current - grid.columns},
                 {SDLK_DOWN, current + grid.columns},
                 {SDLK_PAGEUP, current - page},
                 {SDLK_PAGEDOWN, current + page},
                 {SDLK_HOME, 0},
                 {SDLK_END, SCENE_LIST_MAXIMUM}};
    for (size_t i = 0; i < sizeof moves / sizeof *moves; i++) {
        if (moves[i].key == key) {
            browser_select(browser, moves[i].index, bounds);
        }
    }
    if (key == SDLK_RETURN || key == SDLK_KP_ENTER) {
        return BROWSER_OPEN_SCENE;
    }
    return key == SDLK_ESCAPE || key == SDLK_f ? BROWSER_CLOSE : BROWSER_KEEP_OPEN;
}

BrowserResult browser_click(Browser *browser, int x, int y, const PanelBounds *bounds) {
    BrowserGrid grid = browser_panel_grid(bounds);
    int column = (x - grid.left) / grid.width, row = (y - grid.top) / grid.height;
    size_t index =
        (browser->first_row + (size_t)SDL_max(0, row)) * (size_t)grid.columns + (size_t)column;
    bool is_inside = x >= grid.left && y >= grid.top && column < grid.columns && row < grid.rows;
    if (!is_inside || index >= browser_scene_count(browser)) {
        return BROWSER_KEEP_OPEN;
    }
    browser_select(browser, (long)index, bounds);
    return BROWSER_OPEN_SCENE;
}

void browser_scroll(Browser *browser, int rows, const PanelBounds *bounds) {
    browser_select(
        browser, (long)browser->selected + (long)rows * browser_panel_grid(bounds).columns, bounds);
}

bool browser_selected_path(Browser *browser, char path[PATH_MAX]) {
    scene_list_lock(&browser->list);
    bool is_there = browser->selected < browser->list.count;
    SDL_strlcpy(path, is_there ? browser->list.scenes[browser->selected].path : "", PATH_MAX);
    scene_list_unlock(&browser->list);
    return is_there;
}

void browser_show(Browser *browser, const OverlayTarget *target) {
    if (!browser->is_open) {
        return;
    }
    if (overlay_is_stale(&browser->overlay)) {
        PanelBounds bounds = overlay_bounds(target);
        scene_list_lock(&browser->list);
        SDL_Surface *panel = browser_panel_draw(browser, &bounds);
        scene_list_unlock(&browser->list);
        overlay_set_surface(&browser->overlay, target, panel);
    }
    overlay_show(&browser->overlay, target);
}
