/**
 * @file
 * @brief The tokens of a scene file, to find a value in it.
 */
#ifndef DIOPTRE_VIEW_STATE_LUA_TOKEN_H
#define DIOPTRE_VIEW_STATE_LUA_TOKEN_H

#include <stdbool.h>
#include <stddef.h>

/** The kinds of tokens. */
typedef enum {
    LUA_TOKEN_END,    /**< The end of the text. */
    LUA_TOKEN_NAME,   /**< A name or a keyword of Lua. */
    LUA_TOKEN_NUMBER, /**< A number. */
    LUA_TOKEN_STRING, /**< A string, in quotes or long brackets. */
    LUA_TOKEN_SIGN    /**< One character of an operator or a bracket. */
} LuaTokenKind;

/** A token. */
typedef struct LuaToken {
    LuaTokenKind kind; /**< Its kind. */
    size_t start;      /**< Offset of its first byte. */
    size_t end;        /**< Offset behind its last byte. */
    int line;          /**< Line of its first byte, from 1, as Lua counts. */
} LuaToken;

/** A text being read. */
typedef struct LuaLexer {
    const char *text; /**< The text, without a final zero. */
    size_t size;      /**< Its bytes. */
    size_t next;      /**< Offset of the next byte. */
    int line;         /**< Its line. */
} LuaLexer;

/** @return A lexer at the start of a file: behind a byte order mark and a line for the shell. */
LuaLexer lua_lexer_begin(const char *text, size_t size);

/** @return The next token; comments are skipped. */
LuaToken lua_lexer_next(LuaLexer *lexer);

/** @return Whether a token is a given word or sign. */
bool lua_token_is(const char *text, const LuaToken *token, const char *word);

#endif
