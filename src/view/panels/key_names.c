/**
 * @file
 * @brief The names of keys, as on the keyboard in use, and how they are reached there.
 */
#include "base/language.h"
#include "view/panels/help.h"

#include <libintl.h>
#include <string.h>

/** What SDL says of all dead keys, which have no name: a sign that stays until the next letter. */
enum { DEAD_KEY = SDLK_SCANCODE_MASK };

const char *help_printed_name(SDL_Scancode scancode) {
    /** Dead keys, told by a key nearby. */
    static const struct {
        SDL_Scancode scancode, nearby; /**< Its place, and that of the other. */
        SDL_Keycode printed;           /**< What is on the other. */
        const char *sign;              /**< What is on it. */
    } dead_keys[] = {
        {SDL_SCANCODE_LEFTBRACKET, SDL_SCANCODE_RIGHTBRACKET, '$', "^"},      // French, Belgian.
        {SDL_SCANCODE_LEFTBRACKET, SDL_SCANCODE_RIGHTBRACKET, DEAD_KEY, "^"}, // Canadian French.
        {SDL_SCANCODE_RIGHTBRACKET, SDL_SCANCODE_LEFTBRACKET, DEAD_KEY, "¸"},
        {SDL_SCANCODE_RIGHTBRACKET, SDL_SCANCODE_LEFTBRACKET, 0xe8, "¨"}, // Swiss French: è.
        {SDL_SCANCODE_RIGHTBRACKET, SDL_SCANCODE_LEFTBRACKET, 0xfc, "¨"}, // Swiss German: ü.
        {SDL_SCANCODE_EQUALS, SDL_SCANCODE_RIGHTBRACKET, DEAD_KEY, "^"},  // Both.
        {SDL_SCANCODE_EQUALS, SDL_SCANCODE_RIGHTBRACKET, '+', "´"},       // German.
        {SDL_SCANCODE_LEFTBRACKET, SDL_SCANCODE_RIGHTBRACKET, '+', "`"},  // Spanish.
    };
    const SDL_Keycode key = SDL_GetKeyFromScancode(scancode);
    for (size_t i = 0; key == DEAD_KEY && i < sizeof dead_keys / sizeof *dead_keys; i++) {
        if (dead_keys[i].scancode == scancode &&
            SDL_GetKeyFromScancode(dead_keys[i].nearby) == dead_keys[i].printed) {
            return dead_keys[i].sign;
        }
    }
    return SDL_GetKeyName(key);
}

/** How a key of a command is reached on the keyboard in use. */
typedef enum {
    REACH_NONE,  /**< Not at all: no key has its letter. */
    REACH_PLAIN, /**< By itself. */
    REACH_ALTGR  /**< With AltGr: its place is that of another command. */
} KeyReach;

/** @return How a key of a command is reached. */
static KeyReach key_reach(const Help *help, const Command *command, const CommandKey *key) {
    SDL_Keysym pressed = {.scancode = key->scancode, .sym = key->keycode};
    const bool by_place = key->scancode != 0 && (!help->by_letter || key->keycode == 0);
    pressed.mod = (Uint16)((command->flags & COMMAND_CTRL ? KMOD_LCTRL : 0) |
                           (command->flags & COMMAND_SHIFT ? KMOD_LSHIFT : 0));
    if (by_place) {
        pressed.sym = SDL_GetKeyFromScancode(key->scancode);
    } else {
        pressed.scancode = SDL_GetScancodeFromKey(key->keycode);
    }
    if (pressed.scancode == SDL_SCANCODE_UNKNOWN) {
        return REACH_NONE;
    }
    if (command_find_key(help->commands, pressed, help->by_letter) == command) {
        return REACH_PLAIN;
    }
    pressed.mod |= KMOD_MODE;
    return command_find_key(help->commands, pressed, help->by_letter) == command ? REACH_ALTGR
                                                                                 : REACH_NONE;
}

/** @return Name of a key, as on the keyboard in use; empty: none. */
static const char *key_name(const CommandKey *key, bool by_letter) {
    if (key->label) {
        return key->label[0] != '\0' ? gettext(key->label) : "";
    }
    if (key->scancode == 0 || (by_letter && key->keycode != 0)) {
        return SDL_GetKeyName(key->keycode);
    }
    const char *printed = help_printed_name(key->scancode);
    return printed[0] != '\0' ? printed : SDL_GetScancodeName(key->scancode);
}

/** Appends a key of a command with what is held meanwhile, such as `Ctrl+Z`, unless it has no name
 *  or the keyboard no such key. @return Whether it has. */
static bool add_chord(const Help *help, const Command *command, const CommandKey *key, char *text,
                      size_t size) {
    const char *name = key_name(key, help->by_letter);
    const size_t used = strlen(text);
    // A row without a key has a label only.
    const bool is_label = key->scancode == 0 && key->keycode == 0;
    const KeyReach reach = is_label ? REACH_PLAIN : key_reach(help, command, key);
    if (name[0] == '\0' || reach == REACH_NONE) {
        return false;
    }
    const bool has_ctrl = command->flags & COMMAND_CTRL, has_shift = command->flags & COMMAND_SHIFT;
    SDL_snprintf(text + used, size - used, "%s%s%s%s%s%s%s", used > 0 ? GUI_KEY_GAP : "",
                 reach == REACH_ALTGR ? "AltGr+" : "", has_ctrl ? gettext("Ctrl") : "",
                 has_ctrl ? "+" : "", has_shift ? gettext("Shift") : "", has_shift ? "+" : "",
                 name);
    return true;
}

int help_key_names(const Help *help, const Command *command, char *text, size_t size) {
    int count = 0;
    if (command->keys_of) {
        command = command_find(help->commands, command->keys_of);
    }
    for (int i = 0; i < COMMAND_KEYS; i++) {
        const CommandKey *key = &command->keys[i];
        if (!key->is_spare || count == 0) {
            count += add_chord(help, command, key, text, size);
        }
    }
    return count;
}
