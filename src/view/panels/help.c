/**
 * @file
 * @brief The help: the list of keys, in as many columns as make its letters largest.
 */
#include "view/panels/help.h"

#include "view/window/font.h"

#include <libintl.h>
#include <stdio.h>
#include <string.h>

/** Width of the keys' column on standard output, characters. */
static const int KEY_COLUMN_WIDTH = 22;
/** Most columns of the list. */
enum { HELP_COLUMNS_MAXIMUM = 4 };
/** Largest fraction of a window's height for the keyboard. */
static const double KEYBOARD_HEIGHT_FRACTION = 0.45;

/* --- the list of keys ------------------------------------------------------------------------- */

int help_tint(const Help *help, const Command *command) {
    int number = 0;
    const char *group = NULL;
    for (const Command *row = help->commands; row <= command; row++) {
        bool is_new = row->group && (!group || strcmp(row->group, group) != 0);
        number += is_new;
        group = is_new ? row->group : group;
    }
    return number;
}

/** @return Name of a key, as on the keyboard in use; empty: none. */
static const char *key_name(const CommandKey *key, bool by_letter) {
    if (key->label) {
        return key->label[0] != '\0' ? gettext(key->label) : "";
    }
    if (key->scancode == 0 || (by_letter && key->keycode != 0)) {
        return SDL_GetKeyName(key->keycode);
    }
    const char *printed = SDL_GetKeyName(SDL_GetKeyFromScancode(key->scancode));
    return printed[0] != '\0' ? printed : SDL_GetScancodeName(key->scancode);
}

void help_key_names(const Command *command, bool by_letter, char *text, size_t size) {
    size_t used = strlen(text);
    for (int i = 0; i < COMMAND_KEYS; i++) {
        const char *name = key_name(&command->keys[i], by_letter);
        const char *gap = used > 0 && name[0] != '\0' ? "  " : "";
        SDL_snprintf(text + used, size - used, "%s%s", gap, name);
        used = strlen(text);
    }
}

size_t help_write_rows(const Help *help, PanelRow rows[HELP_ROWS_MAXIMUM]) {
    size_t count = 0;
    const Command *previous = NULL;
    for (const Command *command = help->commands; command_is_row(command); command++) {
        if (!command->group) {
            continue;
        }
        bool is_new_group = !previous || strcmp(previous->group, command->group) != 0;
        bool is_new_row = is_new_group || strcmp(previous->help, command->help) != 0;
        int tint = help_tint(help, command);
        if (is_new_group && count < HELP_ROWS_MAXIMUM) {
            rows[count++] =
                (PanelRow){.is_heading = true, .text = gettext(command->group), .tint = tint};
        }
        if (is_new_row && count < HELP_ROWS_MAXIMUM) {
            rows[count++] = (PanelRow){.text = gettext(command->help), .tint = tint};
        }
        help_key_names(command, help->by_letter, rows[count - 1].label, PANEL_LABEL_SIZE);
        previous = command;
    }
    return count;
}

/* --- columns ---------------------------------------------------------------------------------- */

/** The list, broken into columns at headings. */
typedef struct HelpColumns {
    PanelRow rows[HELP_ROWS_MAXIMUM];        /**< All rows. */
    size_t count;                            /**< Their number. */
    int column_count;                        /**< Number of columns. */
    size_t starts[HELP_COLUMNS_MAXIMUM + 1]; /**< First row of each, then the number of rows. */
    int font_size;                           /**< Size of the letters, pixels. */
} HelpColumns;

/** @return The first heading at or after a row; the number of rows: none. */
static size_t next_heading_row(const HelpColumns *list, size_t row) {
    while (row < list->count && !list->rows[row].is_heading) {
        row++;
    }
    return row;
}

/** Breaks the list into columns of about equal length. */
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

/** @return Size of the largest letters with which the columns fit side by side, pixels; 0 without
 *  font. */
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

/** Chooses the number of columns with which letters are largest. */
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

/** Draws each column. @param[out] panels Their panels, owned by the caller; NULL: none. @return
 *  Their size side by side, pixels. */
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

/** Copies the columns to the panel, and frees them. @param left Left end of the first. */
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

SDL_Surface *help_draw(const Help *help, const PanelBounds *bounds) {
    HelpColumns list = {.column_count = 1};
    SDL_Surface *columns[HELP_COLUMNS_MAXIMUM] = {NULL};
    SDL_Point keyboard =
        keyboard_diagram_size(bounds->width - 8, (int)(bounds->height * KEYBOARD_HEIGHT_FRACTION));
    // Letters are as large as in the whole window, where they fit below the keyboard.
    const int height = SDL_max(1, bounds->height - keyboard.y - 8);
    const PanelBounds below = {bounds->width, height, bounds->scale * bounds->height / height};
    list.count = help_write_rows(help, list.rows);
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
            keyboard_diagram_draw(panel, &area, help);
        }
    }
    return panel;
}

/* --- opening and showing ---------------------------------------------------------------------- */

/** Prints the list of keys. */
static void print_help(const Help *help) {
    PanelRow rows[HELP_ROWS_MAXIMUM];
    size_t count = help_write_rows(help, rows);
    for (size_t i = 0; i < count; i++) {
        if (rows[i].is_heading) {
            printf("%s\n", rows[i].text);
        } else {
            // printf counts bytes; an arrow has three.
            size_t extra = strlen(rows[i].label) - SDL_utf8strlen(rows[i].label);
            printf("  %-*s %s\n", KEY_COLUMN_WIDTH + (int)extra, rows[i].label, rows[i].text);
        }
    }
    fflush(stdout);
}

bool help_toggle(Help *help) {
    bool is_wanted = !help->is_open;
    help->is_open = is_wanted && font_is_available();
    if (is_wanted && !help->is_open) {
        print_help(help);
    }
    return help->is_open == is_wanted;
}

void help_show(Help *help, const OverlayTarget *target) {
    if (!help->is_open) {
        return;
    }
    if (overlay_is_stale(&help->overlay)) {
        PanelBounds bounds = overlay_bounds(target);
        overlay_set_surface(&help->overlay, target, help_draw(help, &bounds));
    }
    overlay_show(&help->overlay, target);
}
