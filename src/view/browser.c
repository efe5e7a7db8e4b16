/**
 * @file
 * @brief The list of scenes: its keys.
 */
#include "view/browser.h"

#include "view/browser_panel.h"

#include <string.h>

bool browser_open(Browser *browser, const ViewSettings *settings, uint32_t event,
                  const char *path) {
    if (scene_list_is_busy(&browser->list)) {
        // The thread was told to end, and tells when it has; until then the list before is seen.
        browser->is_open = browser->is_wanted = true;
        return true;
    }
    scene_list_release(&browser->list);
    browser->is_open = scene_list_begin(&browser->list, settings, event, path);
    browser->is_wanted = browser->is_placed = false;
    SDL_strlcpy(browser->path, path, sizeof browser->path);
    browser->selected = browser->first_row = 0;
    overlay_forget(&browser->overlay);
    return browser->is_open;
}

void browser_close(Browser *browser) {
    browser->is_open = browser->is_wanted = false;
    scene_list_stop(&browser->list);
    overlay_forget(&browser->overlay);
}

void browser_end(Browser *browser) {
    browser_close(browser);
    scene_list_release(&browser->list);
}

/** @return How many scenes there are by now. @param[in,out] browser The list. */
static size_t count(Browser *browser) {
    scene_list_lock(&browser->list);
    size_t scenes = browser->list.count;
    scene_list_unlock(&browser->list);
    return scenes;
}

/** Chooses a scene, and sees that it is seen. @param[in,out] browser The list. @param index Which;
 *  beyond the ends: the last or the first. @param room The window. */
static void choose(Browser *browser, long index, const PanelRoom *room) {
    BrowserGrid grid = browser_grid(room);
    long last = (long)count(browser) - 1;
    browser->selected = (size_t)SDL_max(0, SDL_min(index, last));
    size_t row = browser->selected / (size_t)grid.columns, rows = (size_t)grid.rows;
    if (row < browser->first_row) {
        browser->first_row = row;
    } else if (row >= browser->first_row + rows) {
        browser->first_row = row - rows + 1;
    }
    overlay_forget(&browser->overlay);
}

void browser_place(Browser *browser, const PanelRoom *room) {
    size_t scenes = count(browser);
    for (size_t i = 0; i < scenes && !browser->is_placed; i++) {
        if (strcmp(browser->list.scenes[i].path, browser->path) == 0) {
            choose(browser, (long)i, room);
            browser->is_placed = true;
        }
    }
    browser->is_placed = browser->is_placed || scenes > 0;
}

BrowserAnswer browser_key(Browser *browser, SDL_Keycode key, const PanelRoom *room) {
    BrowserGrid grid = browser_grid(room);
    long now = (long)browser->selected, page = (long)grid.columns * grid.rows;
    const struct {
        SDL_Keycode key;
        long index;
    } ways[] = {{SDLK_LEFT, now - 1},
                {SDLK_RIGHT, now + 1},
                {SDLK_UP, now - grid.columns},
                {SDLK_DOWN, now + grid.columns},
                {SDLK_PAGEUP, now - page},
                {SDLK_PAGEDOWN, now + page},
                {SDLK_HOME, 0},
                {SDLK_END, SCENE_LIST_MAXIMUM}};
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        if (ways[i].key == key) {
            choose(browser, ways[i].index, room);
        }
    }
    if (key == SDLK_RETURN || key == SDLK_KP_ENTER) {
        return BROWSER_OPENS;
    }
    return key == SDLK_ESCAPE || key == SDLK_f ? BROWSER_CLOSES : BROWSER_STAYS;
}

BrowserAnswer browser_click(Browser *browser, int x, int y, const PanelRoom *room) {
    BrowserGrid grid = browser_grid(room);
    int column = (x - grid.left) / grid.width, row = (y - grid.top) / grid.height;
    size_t index =
        (browser->first_row + (size_t)SDL_max(0, row)) * (size_t)grid.columns + (size_t)column;
    bool is_inside = x >= grid.left && y >= grid.top && column < grid.columns && row < grid.rows;
    if (!is_inside || index >= count(browser)) {
        return BROWSER_STAYS;
    }
    choose(browser, (long)index, room);
    return BROWSER_OPENS;
}

void browser_scroll(Browser *browser, int rows, const PanelRoom *room) {
    choose(browser, (long)browser->selected + (long)rows * browser_grid(room).columns, room);
}

bool browser_choice(Browser *browser, char path[PATH_MAX]) {
    scene_list_lock(&browser->list);
    bool is_there = browser->selected < browser->list.count;
    SDL_strlcpy(path, is_there ? browser->list.scenes[browser->selected].path : "", PATH_MAX);
    scene_list_unlock(&browser->list);
    return is_there;
}

void browser_show(Browser *browser, const OverlayScreen *screen) {
    if (!browser->is_open) {
        return;
    }
    if (overlay_is_stale(&browser->overlay)) {
        PanelRoom room = overlay_room(screen);
        scene_list_lock(&browser->list);
        SDL_Surface *panel = browser_draw(browser, &room);
        scene_list_unlock(&browser->list);
        overlay_take(&browser->overlay, screen, panel);
    }
    overlay_show(&browser->overlay, screen);
}
