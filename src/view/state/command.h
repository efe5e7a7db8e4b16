/**
 * @file
 * @brief What a command is: one row of a table, with its keys, its name, its help and its function.
 *
 * The table itself is #command_table (view/commands/commands.c). Here are the type of its rows and
 * the searches by key and by name, which the help also uses.
 */
#ifndef DIOPTRE_VIEW_STATE_COMMAND_H
#define DIOPTRE_VIEW_STATE_COMMAND_H

#include "view/state/held_keys.h"

#include <SDL.h>
#include <stdbool.h>

/** The state of an open window; see view/app.h. */
typedef struct App App;

/** When a command is run, as bits. */
typedef enum {
    COMMAND_SHIFT = 1,         /**< Its key counts with Shift only: another row has the key. */
    COMMAND_REPEATS = 2,       /**< Runs again and again while its key is held. */
    COMMAND_UNRECORDED = 4,    /**< A lesson does not record it. */
    COMMAND_WHILE_PLAYING = 8, /**< The viewer may run it while a lesson plays. */
    COMMAND_WHILE_PAUSED = 16, /**< The viewer may run it while a lesson is paused. */
    COMMAND_CTRL = 32,         /**< Its key counts with Ctrl only. */
    COMMAND_CHOICE = 64,       /**< Changes settings, layer or pictures: it can be undone. */
} CommandFlags;

/** One key of a command. */
typedef struct CommandKey {
    SDL_Scancode scancode; /**< Position on the keyboard, as on the US one; 0: it goes by letter. */
    SDL_Keycode keycode;   /**< Letter or name; 0 with a scancode: it always goes by position. */
    const char *label;     /**< Its name in the help, in English; NULL: what is printed on it;
                                empty: none. */
    bool is_spare;         /**< Whether it counts only where it is no key of another command: for
                                keyboards that have the others with Shift alone, or not at all. */
} CommandKey;

/** Most keys of a command. */
enum { COMMAND_KEYS = 5 };

/** Modifiers with which a key counts by what is printed on it, even where its place is that of
 *  another command: AltGr, on any keyboard. */
enum { COMMAND_BY_PRINT = KMOD_RALT | KMOD_MODE };

/** A command, or a row of the help about something that is not a command (no name). */
typedef struct Command {
    const char *name;                    /**< Its id, and its name in lesson files, in English. */
    const CommandKey keys[COMMAND_KEYS]; /**< Its keys. */
    const char *cap;                     /**< What it does, in a word, for the drawn keyboard, in
                                              English; NULL: #help. */
    const char *group;   /**< Heading of the help above it; NULL: not in the help. */
    const char *keys_of; /**< Command whose keys it has in the help; NULL: its own. */
    const char *help;    /**< What it does, in English. Neighbours with equal texts
                              share a row of the help. */
    unsigned flags;      /**< See #CommandFlags. */
    Move move;           /**< What it moves while its key is held. */
    void (*run)(App *app, int argument); /**< Runs it; NULL: it is a move, or no command. */
    int argument;                        /**< Second argument of #run. */
} Command;

/** @return Whether a row is not the end of the table. */
static inline bool command_is_row(const Command *row) {
    return row->name || row->help;
}

/** @return Whether a command moves something while its key is held. */
static inline bool command_is_move(const Command *command) {
    return command->move.subject != MOVE_NOTHING;
}

/** @return Whether a command has a name. @param command The command; NULL: none. */
bool command_is(const Command *command, const char *name);

/** @return The command of a name; NULL: there is none. */
const Command *command_find(const Command *table, const char *name);

/**
 * Finds the row of a key.
 * @param key        The key, with the modifiers that are held.
 * @param by_letter  Whether keys that have both a letter and a position go by their letters.
 * @return Its row, which may have no name; NULL: the key does nothing.
 */
const Command *command_find_key(const Command *table, SDL_Keysym key, bool by_letter);

#endif
