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

/** @return Whether a row has a key. */
static bool has_key(const Command *row, SDL_Keysym key, bool by_letter) {
    for (int i = 0; i < COMMAND_KEYS; i++) {
        const CommandKey *own = &row->keys[i];
        bool by_scancode = own->scancode != 0 && (!by_letter || own->keycode == 0);
        if (by_scancode ? key.scancode == own->scancode
                        : own->keycode != 0 && key.sym == own->keycode) {
            return true;
        }
    }
    return false;
}

const Command *command_find_key(const Command *table, SDL_Keysym key, bool by_letter) {
    const Command *found = NULL;
    bool is_shifted = key.mod & KMOD_SHIFT;
    for (const Command *row = table; command_is_row(row); row++) {
        bool needs_shift = row->flags & COMMAND_SHIFT;
        if ((needs_shift ? is_shifted : !found) && has_key(row, key, by_letter)) {
            found = row;
        }
    }
    return found;
}
