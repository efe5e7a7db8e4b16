/**
 * @file
 * @brief The help over the picture: the drawn keyboard, and the list of keys; both can be clicked.
 */
#ifndef DIOPTRE_VIEW_PANELS_HELP_H
#define DIOPTRE_VIEW_PANELS_HELP_H

#include "view/gui/gui.h"
#include "view/state/command.h"

/** Most rows of the list of keys. */
enum { HELP_ROWS_MAXIMUM = 96 };
/** Most keys of a row. */
enum { HELP_KEYS_MAXIMUM = 8 };

/** The help. Starts as `{.commands = ...}`: closed. */
typedef struct Help {
    const Command *commands;  /**< All commands. */
    bool by_letter;           /**< See #command_find_key. */
    bool is_in_lesson;        /**< Whether a lesson plays: the list begins with its keys. */
    bool is_open;             /**< Whether it is shown. */
    GuiCell selected;         /**< The row and the key that Enter runs; row -1: none. */
    const Command *requested; /**< The command that a click or Enter requests; NULL: none. */
} Help;

/** The list of keys. */
typedef struct HelpList {
    GuiRow rows[HELP_ROWS_MAXIMUM];                                /**< Its rows. */
    const Command *commands[HELP_ROWS_MAXIMUM][HELP_KEYS_MAXIMUM]; /**< The command of each key. */
    int key_counts[HELP_ROWS_MAXIMUM];                             /**< Number of keys. */
    size_t count;                                                  /**< Number of rows. */
} HelpList;

/** Opens or closes the help. @return false if it cannot be opened, as there is no typeface: it is
 *  printed on standard output instead. */
bool help_toggle(Help *help);

/** Handles a key that selects a row, or runs it. @return Whether it is one. */
bool help_handle_key(Help *help, SDL_Keycode key);

/** Writes the list of keys, named as on the keyboard in use. */
void help_write_list(const Help *help, HelpList *list);

/** Shows the help, if it is open. @param room The part of the window that it fills. */
void help_show(Help *help, const GuiRect *room);

/** @return The number of a command's group, from 1. */
int help_group(const Help *help, const Command *command);

/* --- names of keys: key_names.c --------------------------------------------------------------- */

/** @return What is printed on a key of the keyboard in use; empty: nothing that is known. */
const char *help_printed_name(SDL_Scancode scancode);

/** Appends the names of a command's keys with what is held meanwhile, such as `Ctrl+Z`, as they are
 *  reached on the keyboard in use, parted by #GUI_KEY_GAP. @return Their number. */
int help_key_names(const Help *help, const Command *command, char *text, size_t size);

/* --- the drawn keyboard ----------------------------------------------------------------------- */

/**
 * Draws the keyboard in use, unless its keys would be too small to be read.
 * @param height   Largest height, units of the window.
 * @param marked   Command whose keys are marked; NULL: none.
 * @param[out] hovered  Command of the key under the mouse; NULL: none.
 * @return The command of the key that was clicked; NULL: none.
 */
const Command *keyboard_diagram_show(const Help *help, float height, const Command *marked,
                                     const Command **hovered);

/** @return What a key does, in a word, translated. @param row Its row; NULL: it does nothing. */
const char *key_action_label(const Command *row);

/** @return What is printed on a key of the keyboard in use, or a sign for it; may be empty. */
const char *key_cap_label(SDL_Scancode scancode);

#endif
