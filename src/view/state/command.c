/**
 * @file
 * @brief Searching the table of commands.
 */
#include "view/state/command.h"

#include <string.h>

bool command_is(const Command *command, const char *name) {
    return command && command->name && strcmp(command->name, name) == 0;
}

const Command *command_find(const Command *table, const char *name) {
    for (const Command *row = table; command_is_row(row); row++) {
        if (command_is(row, name)) {
            return row;
        }
    }
    return NULL;
}

/** @return Whether a row has a key. @param is_spare Whether its spare keys are looked at, or the
 *  others. */
static bool has_key(const Command *row, SDL_Keysym key, bool by_letter, bool is_spare) {
    const bool by_print = key.mod & COMMAND_BY_PRINT;
    for (int i = 0; i < COMMAND_KEYS; i++) {
        const CommandKey *own = &row->keys[i];
        const bool by_scancode = own->scancode != 0 && (!by_letter || own->keycode == 0);
        const bool is_own = by_scancode ? key.scancode == own->scancode
                                        : own->keycode != 0 && key.sym == own->keycode;
        if (is_own && own->is_spare == is_spare && !(by_print && own->scancode != 0)) {
            return true;
        }
    }
    return false;
}

/** Finds the row of a key among the spare ones, or among the others. See #command_find_key. */
static const Command *find_row(const Command *table, SDL_Keysym key, bool by_letter,
                               bool is_spare) {
    const Command *found = NULL;
    unsigned held =
        (key.mod & KMOD_SHIFT ? COMMAND_SHIFT : 0u) | (key.mod & KMOD_CTRL ? COMMAND_CTRL : 0u);
    unsigned found_modifiers = 0;
    for (const Command *row = table; command_is_row(row); row++) {
        unsigned modifiers = row->flags & (COMMAND_SHIFT | COMMAND_CTRL);
        bool is_held = (modifiers & held) == modifiers;
        if (is_held && (!found || modifiers > found_modifiers) &&
            has_key(row, key, by_letter, is_spare)) {
            found = row;
            found_modifiers = modifiers;
        }
    }
    return found;
}

const Command *command_find_key(const Command *table, SDL_Keysym key, bool by_letter) {
    const Command *found = find_row(table, key, by_letter, false);
    return found ? found : find_row(table, key, by_letter, true);
}
