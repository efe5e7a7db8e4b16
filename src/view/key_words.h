/**
 * @file
 * @brief What keys do, in a word: short enough to stand on a key.
 */
#ifndef DIOPTRE_VIEW_KEY_WORDS_H
#define DIOPTRE_VIEW_KEY_WORDS_H

#include "view/keymap.h"

/** @return What a key does, in the language that the program speaks; empty: nothing.
 *  @param place Its place. @param meaning What it means. */
const char *key_word(SDL_Scancode place, const KeyMeaning *meaning);

/** @return What is printed on a key of the keyboard in use, or a sign for it; may be empty.
 *  @param place Its place. */
const char *key_label(SDL_Scancode place);

#endif
