/**
 * @file
 * @brief What keys do, in a word: short enough to stand on a key.
 */
#ifndef DIOPTRE_VIEW_PANELS_KEY_LABELS_H
#define DIOPTRE_VIEW_PANELS_KEY_LABELS_H

#include "view/input/keymap.h"

/** @return What a key does, in the language that the program speaks; empty: nothing. */
const char *key_action_label(SDL_Scancode scancode, const KeyInfo *info);

/** @return What is printed on a key of the keyboard in use, or a sign for it; may be empty. */
const char *key_cap_label(SDL_Scancode scancode);

#endif
