/**
 * @file
 * @brief Which key asks for what: one table, for the keyboard and for the help.
 */
#ifndef DIOPTRE_VIEW_KEYMAP_H
#define DIOPTRE_VIEW_KEYMAP_H

#include "view/action.h"

#include <SDL.h>
#include <stdbool.h>
#include <stddef.h>

/** Bytes for the names of a help row's keys; the longest key name of SDL is below 20. */
enum { HELP_KEYS_SIZE = 64 };

/** Rows that the help has at most. */
enum { HELP_ROWS_MAXIMUM = 24 };

/** One row of the help: a heading, or keys and what they do. */
typedef struct HelpRow {
    bool is_heading;           /**< Whether this is the heading of a group. */
    char keys[HELP_KEYS_SIZE]; /**< What is printed on the keys, UTF-8; empty in a heading. */
    const char *text;          /**< What they do; owned by the program. */
} HelpRow;

/**
 * @return What a key asks for.
 * @param key        The key, its place and its letter.
 * @param by_letter  Whether the light's keys go by their letters, not by their places.
 */
Action keymap_action(SDL_Keysym key, bool by_letter);

/**
 * Writes the help, with the keys of the keyboard in use.
 * @param by_letter  Whether the light's keys go by their letters, not by their places.
 * @param[out] rows  The rows.
 * @return How many there are.
 */
size_t keymap_help(bool by_letter, HelpRow rows[HELP_ROWS_MAXIMUM]);

#endif
