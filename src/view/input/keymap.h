/**
 * @file
 * @brief Which key asks for what: one table, for the keyboard and for the help.
 */
#ifndef DIOPTRE_VIEW_INPUT_KEYMAP_H
#define DIOPTRE_VIEW_INPUT_KEYMAP_H

#include "view/commands/action.h"
#include "view/panels/panel.h"

#include <SDL.h>
#include <stdbool.h>
#include <stddef.h>

/** Rows that the help has at most. */
enum { HELP_ROWS_MAXIMUM = 48 };

/**
 * @return What a key asks for.
 * @param key        The key, its place and its letter.
 * @param by_letter  Whether the light's keys go by their letters, not by their places.
 */
Action keymap_action(SDL_Keysym key, bool by_letter);

/** What the help tells of a key. */
typedef struct KeyInfo {
    Action action;    /**< What it asks for; #ACTION_NONE: nothing. */
    int tint;         /**< The colour of its group: #PanelRow.tint. */
    const char *help; /**< What it does, in English. */
} KeyInfo;

/** @return What a key means. */
KeyInfo keymap_lookup(SDL_Keysym key, bool by_letter);

/**
 * Writes the help, with the keys of the keyboard in use.
 * @param by_letter  Whether the light's keys go by their letters, not by their places.
 * @return How many there are.
 */
size_t keymap_help_rows(bool by_letter, PanelRow rows[HELP_ROWS_MAXIMUM]);

#endif
