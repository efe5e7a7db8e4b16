/**
 * @file
 * @brief The help: its list in as many columns as make its letters largest.
 */
#include "view/panels/help_panel.h"

#include "view/input/keymap.h"
#include "view/panels/keyboard_diagram.h"

/** Most columns of the list. */
enum { HELP_COLUMNS_MAXIMUM = 4 };
/** Share of a window's height that the keyboard takes at most. */
static const double KEYBOARD_HEIGHT_FRACTION = 0.45;

/** The list, cut into columns at headings. */
typedef struct HelpColumns {
    PanelRow rows[HELP_ROWS_MAXIMUM];        /**< All rows. */
    size_t count;                            /**< How many. */
    int column_count;                        /**< How many columns. */
    size_t starts[HELP_COLUMNS_MAXIMUM + 1]; /**< First row of each, then the number of rows. */
    int font_size;                           /**< Size of the letters, pixels. */
} HelpColumns;

/** @return The first heading at or after a row; the number of rows: there is none. */
static size_t next_heading_row(const HelpColumns *list, size_t row) {
    while (row < list->count && !list->rows[row].is_heading) {
        row++;
    }
    return row;
}

/** Cuts the list into columns that are about as long. */
static void split_columns(HelpColumns *list, int columns) {
    list->column_count = columns;
    list->starts[0] = 0;
    for (int i = 1; i <= columns; i++) {
        size_t even = list->count * (size_t)i / (size_t)columns;
        size_t heading = next_heading_row(list, even), before = even;
        while (before > list->starts[i - 1] && !list->rows[before].is_heading) {
            before--;
        }
        bool is_before = before > list->starts[i - 1] && even - before < heading - even;
        list->starts[i] = i == columns ? list->count : is_before ? before : heading;
    }
}

/**
 * @return Size of the largest letters that the columns can have; 0: none.
 * @param bounds  The room for all of them.
 */
static int columns_font_size(const HelpColumns *list, const PanelBounds *bounds) {
    const PanelBounds part = {bounds->width / list->column_count, bounds->height, bounds->scale};
    int size = 0;
    for (int i = 0; i < list->column_count; i++) {
        size_t count = list->starts[i + 1] - list->starts[i];
        int own = count > 0 ? panel_font_size(list->rows + list->starts[i], count, &part) : 0;
        size = i == 0 || own < size ? own : size;
    }
    return size;
}

/** Chooses the columns. */
static void choose_columns(HelpColumns *list, const PanelBounds *bounds) {
    int best = 1;
    for (int columns = 1; columns <= HELP_COLUMNS_MAXIMUM; columns++) {
        split_columns(list, columns);
        int size = columns_font_size(list, bounds);
        if (size > list->font_size) {
            list->font_size = size;
            best = columns;
        }
    }
    split_columns(list, best);
}

/**
 * Draws the columns side by side.
 * @param[out] panels  A panel each, to be freed; NULL: none.
 * @return How large they are together, pixels.
 */
static SDL_Point draw_columns(const HelpColumns *list, SDL_Surface *panels[HELP_COLUMNS_MAXIMUM]) {
    SDL_Point extent = {0, 0};
    for (int i = 0; i < list->column_count; i++) {
        size_t first = list->starts[i];
        panels[i] =
            panel_draw_at_size(list->rows + first, list->starts[i + 1] - first, list->font_size);
        if (panels[i]) {
            extent.x += panels[i]->w;
            extent.y = SDL_max(extent.y, panels[i]->h);
        }
    }
    return extent;
}

/** Lays the columns on the panel, and frees them. @param left Where the first begins. */
static void blit_columns(SDL_Surface *panel, int top, int left, SDL_Surface **columns, int count) {
    for (int i = 0; i < count; i++) {
        if (columns[i]) {
            SDL_Rect destination = {.x = left, .y = top};
            left += columns[i]->w;
            SDL_SetSurfaceBlendMode(columns[i], SDL_BLENDMODE_NONE);
            SDL_BlitSurface(columns[i], NULL, panel, &destination);
            SDL_FreeSurface(columns[i]);
        }
    }
}

SDL_Surface *help_panel_draw(bool by_letter, const PanelBounds *bounds) {
    HelpColumns list = {.column_count = 1};
    SDL_Surface *columns[HELP_COLUMNS_MAXIMUM] = {NULL};
    SDL_Point keyboard =
        keyboard_diagram_size(bounds->width - 8, (int)(bounds->height * KEYBOARD_HEIGHT_FRACTION));
    /* As large as in the whole window, where there is room for it. */
    const int height = SDL_max(1, bounds->height - keyboard.y - 8);
    const PanelBounds below = {bounds->width, height, bounds->scale * bounds->height / height};
    list.count = keymap_help_rows(by_letter, list.rows);
    choose_columns(&list, &below);
    if (list.font_size == 0) {
        return NULL;
    }
    SDL_Point extent = draw_columns(&list, columns);
    int width = SDL_max(extent.x, keyboard.x + 8), top = keyboard.y > 0 ? keyboard.y + 8 : 0;
    SDL_Surface *panel = panel_create(width, top + extent.y);
    if (panel) {
        blit_columns(panel, top, (width - extent.x) / 2, columns, list.column_count);
        SDL_Rect area = {(width - keyboard.x) / 2, 4, keyboard.x, keyboard.y};
        if (keyboard.y > 0) {
            keyboard_diagram_draw(panel, &area, by_letter);
        }
    }
    return panel;
}
