/**
 * @file
 * @brief The help: the list of keys, and the drawn keyboard above it.
 */
#include "view/panels/help.h"

#include "base/language.h"
#include "view/gui/typeface.h"
#include "view/state/way_out.h"

#include <libintl.h>
#include <stdio.h>
#include <string.h>

/** Width of the keys' column on standard output, characters. */
static const int KEY_COLUMN_WIDTH = 22;
/** Largest part of the panel's height for the keyboard. */
static const float KEYBOARD_HEIGHT_FRACTION = 0.48F;
/** Rows that Page Up and Page Down go. */
enum { PAGE_ROWS = 8 };
/** Bytes of the line below the keyboard with the final zero. */
enum { LINE_SIZE = 256 };
/** Lines of text below the keyboard. */
enum { LINES_BELOW = 2 };

/* --- the list of keys ------------------------------------------------------------------------- */

int help_group(const Help *help, const Command *command) {
    int number = 0;
    const char *group = NULL;
    for (const Command *row = help->commands; row <= command; row++) {
        bool is_new = row->group && (!group || strcmp(row->group, group) != 0);
        number += is_new;
        group = is_new ? row->group : group;
    }
    return number;
}

/** Adds a row. @return Its index; the last one's if all are used. */
static size_t add_row(HelpList *list, const GuiRow *row) {
    size_t index = list->count < HELP_ROWS_MAXIMUM ? list->count++ : HELP_ROWS_MAXIMUM - 1;
    list->rows[index] = *row;
    list->key_counts[index] = 0;
    return index;
}

/** Adds the keys of a command to the last row. */
static void add_keys(const Help *help, HelpList *list, const Command *command) {
    const size_t last = list->count - 1;
    GuiRow *row = &list->rows[last];
    int *count = &list->key_counts[last];
    row->is_clickable = row->is_clickable || command->name;
    const int added = help_key_names(help, command, row->label, GUI_LABEL_SIZE);
    for (int i = 0; i < added && *count < HELP_KEYS_MAXIMUM; i++) {
        list->commands[last][(*count)++] = command->name ? command : NULL;
    }
}

/** @return The group of what keys do while a lesson plays: its rows name other commands. */
static const char *lesson_group(const Help *help) {
    const Command *row = help->commands;
    while (command_is_row(row) && !row->keys_of) {
        row++;
    }
    return command_is_row(row) ? row->group : NULL;
}

/** Adds the rows of commands. @param group Their group. @param is_of_group false: those of all
 *  other groups. */
static void add_groups(const Help *help, HelpList *list, const char *group, bool is_of_group) {
    const Command *previous = NULL;
    for (const Command *command = help->commands; command_is_row(command); command++) {
        if (!command->group || (command_is(command, "quit") && !way_out_exists()) ||
            (group && strcmp(command->group, group) == 0) != is_of_group) {
            continue;
        }
        bool is_new_group = !previous || strcmp(previous->group, command->group) != 0;
        bool is_new_row = is_new_group || strcmp(previous->help, command->help) != 0;
        GuiColor color = gui_group_color(help_group(help, command));
        if (is_new_group) {
            add_row(list,
                    &(GuiRow){.is_heading = true, .text = gettext(command->group), .color = color});
        }
        if (is_new_row) {
            add_row(list,
                    &(GuiRow){.has_keys = true, .text = gettext(command->help), .color = color});
        }
        add_keys(help, list, command);
        previous = command;
    }
}

void help_write_list(const Help *help, HelpList *list) {
    const char *first = help->is_in_lesson ? lesson_group(help) : NULL;
    list->count = 0;
    if (first) {
        add_groups(help, list, first, true);
    }
    add_groups(help, list, first, false);
}

/** Prints the list of keys. */
static void print_help(const Help *help) {
    HelpList list;
    help_write_list(help, &list);
    for (size_t i = 0; i < list.count; i++) {
        const GuiRow *row = &list.rows[i];
        if (row->is_heading) {
            printf("%s\n", row->text);
        } else {
            // printf counts bytes; an arrow has three.
            size_t extra = strlen(row->label) - SDL_utf8strlen(row->label);
            printf("  %-*s %s\n", KEY_COLUMN_WIDTH + (int)extra, row->label, row->text);
        }
    }
    fflush(stdout);
}

/* --- opening and showing ---------------------------------------------------------------------- */

bool help_toggle(Help *help) {
    bool is_wanted = !help->is_open;
    help->is_open = is_wanted && typeface_find();
    help->selected = (GuiCell){-1, 0};
    if (is_wanted && !help->is_open) {
        print_help(help);
    }
    return help->is_open == is_wanted;
}

/** @return The command of a cell; NULL: none. */
static const Command *command_at(const HelpList *list, GuiCell cell) {
    bool is_there = cell.row >= 0 && (size_t)cell.row < list->count && cell.key >= 0 &&
                    cell.key < list->key_counts[cell.row];
    return is_there ? list->commands[cell.row][cell.key] : NULL;
}

/** Selects the next row that can be run. @param step 1: below; -1: above. */
static void select_row(Help *help, const HelpList *list, int step) {
    for (int row = help->selected.row + step; row >= 0 && row < (int)list->count; row += step) {
        if (list->rows[row].is_clickable) {
            help->selected = (GuiCell){row, 0};
            return;
        }
    }
}

bool help_handle_key(Help *help, SDL_Keycode key) {
    static const struct {
        SDL_Keycode key;
        int rows;
    } moves[] = {{SDLK_UP, -1},
                 {SDLK_DOWN, 1},
                 {SDLK_PAGEUP, -PAGE_ROWS},
                 {SDLK_PAGEDOWN, PAGE_ROWS},
                 {SDLK_HOME, -HELP_ROWS_MAXIMUM},
                 {SDLK_END, HELP_ROWS_MAXIMUM}};
    HelpList list;
    help_write_list(help, &list);
    for (size_t i = 0; i < sizeof moves / sizeof *moves; i++) {
        for (int row = 0; key == moves[i].key && row < SDL_abs(moves[i].rows); row++) {
            select_row(help, &list, moves[i].rows > 0 ? 1 : -1);
        }
        if (key == moves[i].key) {
            return true;
        }
    }
    if (key == SDLK_LEFT || key == SDLK_RIGHT) {
        int row = SDL_max(0, help->selected.row), count = list.key_counts[row];
        int next = help->selected.key + (key == SDLK_RIGHT ? 1 : -1);
        help->selected.key = SDL_max(0, SDL_min(next, count - 1));
        return true;
    }
    if (key == SDLK_RETURN || key == SDLK_KP_ENTER) {
        help->requested = command_at(&list, help->selected);
        return true;
    }
    return false;
}

/** Writes what a key does, or how the help is used. @param row Row of the key; NULL: none. */
static void show_line(const Command *row) {
    char line[LINE_SIZE];
    if (!row) {
        gui_paragraph(gettext("Click a key or a row, or choose a row with ↑ ↓ and press Enter."),
                      GUI_COLOR_FAINT, LINES_BELOW);
        return;
    }
    const char *word = key_action_label(row), *help = row->help ? gettext(row->help) : "";
    bool has_both = help[0] != '\0' && strcmp(word, help) != 0;
    SDL_snprintf(line, sizeof line, "%s%s%s", word, has_both ? " — " : "", has_both ? help : "");
    gui_paragraph(line, GUI_COLOR_TEXT, LINES_BELOW);
}

void help_show(Help *help, const GuiRect *room) {
    if (!help->is_open) {
        return;
    }
    HelpList list;
    help_write_list(help, &list);
    const Command *selected = command_at(&list, help->selected), *hovered = NULL;
    gui_panel_begin("help", room);
    const Command *clicked =
        keyboard_diagram_show(help, KEYBOARD_HEIGHT_FRACTION * room->height, selected, &hovered);
    show_line(hovered ? hovered : selected);
    GuiCell cell = gui_rows(list.rows, list.count, help->selected);
    gui_panel_end();
    if (cell.row >= 0) {
        help->selected = cell;
        clicked = command_at(&list, cell);
    }
    if (clicked && clicked->name) {
        help->requested = clicked;
    }
}
