/**
 * @file
 * @brief Values of settings as a reader says them.
 *
 * Files and options say `bound` and `double` in every language; where the window shows such a
 * value, it has a name in the user's language.
 */
#ifndef DIOPTRE_VIEW_STATE_SETTINGS_WORDS_H
#define DIOPTRE_VIEW_STATE_SETTINGS_WORDS_H

#include "view/state/settings_override.h"

/** @return The name of an offset strategy in the user's language. */
const char *offset_strategy_word(OffsetStrategy offset);

/** @return The name of a number type in the user's language. */
const char *number_type_word(NumberType type);

/** Bytes of the words of an engine with the final zero. */
enum { ENGINE_WORDS_SIZE = 64 };

/** Names an engine by its number type, then by its own name, such as `double (f64x4)`. @param name
 *  The engine's name. */
void engine_words_write(const char *name, char words[ENGINE_WORDS_SIZE]);

#endif
