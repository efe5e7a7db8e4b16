/**
 * @file
 * @brief The list of scenes: opening, searching, selecting, closing.
 */
#include "view/panels/browser.h"

#include "base/utf8.h"

#include <string.h>

/** Lines that Page Up and Page Down go. */
enum { PAGE_LINES = 3 };

bool browser_open(Browser *browser, const ViewSettings *settings, uint32_t event,
                  const char *path) {
    SDL_StartTextInput();
    // What keys have asked for outlasts the wait for the previous list.
    browser->begins_at_top = browser->is_reopen_pending && browser->begins_at_top;
    browser->opens_first = browser->is_reopen_pending && browser->opens_first;
    if (scene_list_is_busy(&browser->list)) {
        // Its thread is ending, and sends an event then. The previous list is shown until then, but
        // its selection is not that of the next one: keys are for that.
        browser->is_open = browser->is_reopen_pending = true;
        browser->has_selection = false;
        return true;
    }
    browser_release_textures(browser);
    browser->is_open = scene_list_start(&browser->list, settings, event, path);
    browser->is_reopen_pending = browser->has_selection = browser->is_requested =
        browser->is_close_requested = browser->follows_mouse = false;
    SDL_strlcpy(browser->path, path, sizeof browser->path);
    browser->selected = 0;
    browser->filter[0] = '\0';
    return browser->is_open;
}

void browser_close(Browser *browser) {
    if (browser->is_open) {
        SDL_StopTextInput();
    }
    browser->is_open = browser->is_reopen_pending = false;
    scene_list_request_stop(&browser->list);
    browser_release_textures(browser);
}

void browser_release_textures(Browser *browser) {
    for (size_t i = 0; i < SCENE_LIST_MAXIMUM; i++) {
        if (browser->textures[i]) {
            SDL_DestroyTexture(browser->textures[i]);
            browser->textures[i] = NULL;
        }
    }
}

void browser_deinit(Browser *browser) {
    browser_close(browser);
    scene_list_deinit(&browser->list);
}

/* --- searching -------------------------------------------------------------------------------- */

/** A sign that stands for one that keyboards have. */
typedef struct FoldedSign {
    const char *sign; /**< The sign, in UTF-8. */
    char letter;      /**< What is typed for it. */
} FoldedSign;

/** The typographic signs of French titles: the apostrophe, and the space before a colon. */
static const FoldedSign folded_signs[] = {{"\xe2\x80\x99", '\''}, {"\xc2\xa0", ' '}};

/** @return The typographic sign that a text begins with, or NULL. */
static const FoldedSign *folded_sign(const char *text) {
    for (size_t i = 0; i < sizeof folded_signs / sizeof *folded_signs; i++) {
        if (strncmp(text, folded_signs[i].sign, strlen(folded_signs[i].sign)) == 0) {
            return &folded_signs[i];
        }
    }
    return NULL;
}

/** Writes a text as it is searched: without accents of Latin-1, in small letters, hyphens and
 *  underscores as spaces, typographic signs as they are typed. */
static void fold(const char *text, char folded[SCENE_TITLE_SIZE]) {
    /** The letters from U+00E0 to U+00FF, and with 32 more the capital ones; `.`: it stays. */
    static const char letters[] = "aaaaaa.ceeeeiiii.nooooo.ouuuuy.y";
    size_t length = 0;
    for (; *text && length + 2 < SCENE_TITLE_SIZE; text++) {
        unsigned char first = (unsigned char)text[0], second = (unsigned char)text[1];
        char letter = first == 0xC3 && second >= 0x80 ? letters[second & 31] : '.';
        const FoldedSign *sign = folded_sign(text);
        if (letter != '.') {
            folded[length++] = letter;
            text++;
        } else if (sign) {
            folded[length++] = sign->letter;
            text += strlen(sign->sign) - 1;
        } else {
            folded[length++] = *text == '-' || *text == '_' ? ' ' : (char)SDL_tolower(first);
        }
    }
    folded[length] = '\0';
}

/** @return Whether a text holds some words. @param words As #fold writes them. */
static bool holds(const char *text, const char *words) {
    char folded[SCENE_TITLE_SIZE];
    fold(text, folded);
    return strstr(folded, words) != NULL;
}

void browser_order(const Browser *browser, BrowserOrder *order) {
    char words[SCENE_TITLE_SIZE];
    fold(browser->filter, words);
    order->count = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (size_t i = 0; i < browser->list.count; i++) {
            const SceneEntry *scene = &browser->list.scenes[i];
            bool is_found = holds(scene->name, words) || holds(scene->label, words) ||
                            holds(scene->title, words);
            if (is_found && scene->is_lesson == (pass == 0)) {
                order->indices[order->count++] = i;
            }
        }
        order->lessons = pass == 0 ? order->count : order->lessons;
    }
}

/** Finds the scenes that are shown, with the list locked meanwhile. */
static void lock_and_order(Browser *browser, BrowserOrder *order) {
    order->count = order->lessons = 0;
    if (browser->list.is_started) {
        scene_list_lock(&browser->list);
        browser_order(browser, order);
        scene_list_unlock(&browser->list);
    }
}

/** @return Where the selected scene stands in the order; 0: it is not shown. */
static size_t selected_position(const Browser *browser, const BrowserOrder *order) {
    for (size_t i = 0; i < order->count; i++) {
        if (order->indices[i] == browser->selected) {
            return i;
        }
    }
    return 0;
}

/** Selects a scene, and scrolls to it. @param position In the order; clamped. */
static void select_position(Browser *browser, const BrowserOrder *order, long position) {
    if (order->count > 0) {
        long last = (long)order->count - 1;
        browser->selected = order->indices[SDL_max(0, SDL_min(position, last))];
        browser->scrolls = browser->has_selection = true;
    }
}

/** Shows only scenes with the words that are searched now, and selects the first of them. */
static void apply_filter(Browser *browser) {
    BrowserOrder order;
    lock_and_order(browser, &order);
    select_position(browser, &order, 0);
}

void browser_type(Browser *browser, const char *text) {
    browser->follows_mouse = false;
    if (strlen(browser->filter) + strlen(text) < sizeof browser->filter) {
        SDL_strlcat(browser->filter, text, sizeof browser->filter);
        apply_filter(browser);
    }
}

void browser_erase_word(Browser *browser) {
    static const char separators[] = " -_";
    char *words = browser->filter;
    size_t length = strlen(words);
    while (length > 0 && strchr(separators, words[length - 1])) {
        length--;
    }
    while (length > 0 && !strchr(separators, words[length - 1])) {
        length--;
    }
    words[length] = '\0';
    apply_filter(browser);
}

/* --- selecting -------------------------------------------------------------------------------- */

void browser_select_current(Browser *browser) {
    // An event of the previous list may come before or while this one is being filled.
    if (browser->has_selection || browser->is_reopen_pending ||
        !atomic_load(&browser->list.is_complete)) {
        return;
    }
    BrowserOrder order;
    lock_and_order(browser, &order);
    long current = 0;
    for (size_t i = 0; i < order.count && !browser->begins_at_top; i++) {
        if (strcmp(browser->list.scenes[order.indices[i]].path, browser->path) == 0) {
            current = (long)i;
        }
    }
    select_position(browser, &order, current);
    browser->is_requested = browser->opens_first && browser->has_selection;
}

void browser_begin_at_top(Browser *browser) {
    browser->begins_at_top = true;
}

/** @return The position some lines below. Lessons and scenes begin with lines of their own. @param
 *  lines Negative: above. */
static long position_below(const BrowserOrder *order, long position, long columns, int lines) {
    long lessons = (long)order->lessons, count = (long)order->count;
    long gap = (columns - lessons % columns) % columns; // Empty places behind the last lesson.
    long place = (position < lessons ? position : position + gap) + lines * columns;
    if (place >= lessons && place < lessons + gap) {
        return lines > 0 || lessons == 0 ? SDL_min(lessons, count - 1) : lessons - 1;
    }
    place -= place >= lessons + gap ? gap : 0;
    return place < 0 ? position : SDL_min(place, count - 1);
}

void browser_go_to(Browser *browser, BrowserPart part) {
    BrowserOrder order;
    lock_and_order(browser, &order);
    bool has_scenes = order.lessons < order.count;
    select_position(browser, &order,
                    part == BROWSER_SCENES && has_scenes ? (long)order.lessons : 0);
}

BrowserPart browser_part(const Browser *browser, const BrowserOrder *order) {
    return selected_position(browser, order) < order->lessons ? BROWSER_LESSONS : BROWSER_SCENES;
}

BrowserResult browser_key(Browser *browser, SDL_Keycode key) {
    BrowserOrder order;
    lock_and_order(browser, &order);
    browser->follows_mouse = false;
    const long columns = SDL_max(1, browser->columns);
    const long current = (long)selected_position(browser, &order);
    const struct {
        SDL_Keycode key;
        long position;
    } moves[] = {{SDLK_LEFT, current - 1},
                 {SDLK_RIGHT, current + 1},
                 {SDLK_UP, position_below(&order, current, columns, -1)},
                 {SDLK_DOWN, position_below(&order, current, columns, 1)},
                 {SDLK_PAGEUP, current - PAGE_LINES * columns},
                 {SDLK_PAGEDOWN, current + PAGE_LINES * columns},
                 {SDLK_HOME, 0},
                 {SDLK_END, SCENE_LIST_MAXIMUM}};
    for (size_t i = 0; i < sizeof moves / sizeof *moves; i++) {
        if (moves[i].key == key) {
            select_position(browser, &order, moves[i].position);
        }
    }
    if (key == SDLK_TAB && !browser->has_selection) {
        // While the list is being filled, the other part is what will be selected.
        browser->begins_at_top = !browser->begins_at_top;
    } else if (key == SDLK_TAB) {
        browser_go_to(browser, browser_part(browser, &order) == BROWSER_LESSONS ? BROWSER_SCENES
                                                                                : BROWSER_LESSONS);
    }
    if (key == SDLK_BACKSPACE) {
        utf8_erase_last(browser->filter);
        apply_filter(browser);
    }
    if (key == SDLK_RETURN || key == SDLK_KP_ENTER) {
        browser->opens_first = !browser->has_selection;
        return order.count > 0 && browser->has_selection ? BROWSER_OPEN_SCENE : BROWSER_KEEP_OPEN;
    }
    return key == SDLK_ESCAPE ? BROWSER_CLOSE : BROWSER_KEEP_OPEN;
}

bool browser_selected_path(Browser *browser, char path[PATH_MAX]) {
    scene_list_lock(&browser->list);
    bool is_there = browser->selected < browser->list.count;
    SDL_strlcpy(path, is_there ? browser->list.scenes[browser->selected].path : "", PATH_MAX);
    scene_list_unlock(&browser->list);
    return is_there;
}
