/**
 * @file
 * @brief What Lua itself says is wrong, in the language that the program speaks.
 */
#ifndef SCRIPT_LUA_WORDS_H
#define SCRIPT_LUA_WORDS_H

#include <stdbool.h>
#include <stddef.h>

/**
 * Translates a message of Lua, if it is one of those that scenes meet.
 * @param message     The message, without the place before it.
 * @param[out] words  The same in the language that the program speaks, ended by a zero and cut
 * where it is too long.
 * @param size        Bytes that fit.
 * @return Whether it is one of those; otherwise there are no words.
 */
bool lua_words_translate(const char *message, char *words, size_t size);

#endif
