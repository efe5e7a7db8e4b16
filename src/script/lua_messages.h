/**
 * @file
 * @brief What Lua itself says is wrong, in the language that the program speaks.
 */
#ifndef DIOPTRE_SCRIPT_LUA_MESSAGES_H
#define DIOPTRE_SCRIPT_LUA_MESSAGES_H

#include <stdbool.h>
#include <stddef.h>

/**
 * Translates a message of Lua, if it is one of those that scenes meet.
 * @param message  The message, without the place before it.
 * @param[out] translated  The same in the language that the program speaks, ended by a zero and cut
 *         where it is too long.
 * @return Whether it is one of those; otherwise there are no words.
 */
bool lua_message_translate(const char *message, char *translated, size_t size);

#endif
