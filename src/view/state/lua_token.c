/**
 * @file
 * @brief Reading the tokens of Lua: enough to find values, not to check a program.
 */
#include "view/state/lua_token.h"

#include <ctype.h>
#include <string.h>

/** @return A byte ahead; 0 behind the end. */
static char peek(const LuaLexer *lexer, size_t ahead) {
    return lexer->next + ahead < lexer->size ? lexer->text[lexer->next + ahead] : '\0';
}

/** Goes on by one byte; two bytes that end one line count as one line. */
static void advance(LuaLexer *lexer) {
    char c = peek(lexer, 0), after = peek(lexer, 1);
    lexer->next++;
    if (c == '\n' || c == '\r') {
        bool is_pair = (after == '\n' || after == '\r') && after != c;
        lexer->next += is_pair;
        lexer->line++;
    }
}

/** @return Number of `=` of a long bracket that begins here; -1: none does. */
static int long_bracket_level(const LuaLexer *lexer) {
    int level = 0;
    if (peek(lexer, 0) != '[') {
        return -1;
    }
    while (peek(lexer, (size_t)level + 1) == '=') {
        level++;
    }
    return peek(lexer, (size_t)level + 1) == '[' ? level : -1;
}

/** @return Whether a long bracket ends here. */
static bool ends_long_bracket(const LuaLexer *lexer, int level) {
    if (peek(lexer, 0) != ']') {
        return false;
    }
    for (int i = 1; i <= level; i++) {
        if (peek(lexer, (size_t)i) != '=') {
            return false;
        }
    }
    return peek(lexer, (size_t)level + 1) == ']';
}

/** Goes behind a long bracket. */
static void skip_long_bracket(LuaLexer *lexer, int level) {
    while (lexer->next < lexer->size && !ends_long_bracket(lexer, level)) {
        advance(lexer);
    }
    size_t end = lexer->next + (size_t)level + 2;
    lexer->next = end < lexer->size ? end : lexer->size;
}

/** Goes to the end of the line. */
static void skip_line(LuaLexer *lexer) {
    while (lexer->next < lexer->size && peek(lexer, 0) != '\n' && peek(lexer, 0) != '\r') {
        advance(lexer);
    }
}

/** Goes behind spaces and comments. */
static void skip_space(LuaLexer *lexer) {
    while (lexer->next < lexer->size) {
        if (isspace((unsigned char)peek(lexer, 0))) {
            advance(lexer);
        } else if (peek(lexer, 0) == '-' && peek(lexer, 1) == '-') {
            lexer->next += 2;
            int level = long_bracket_level(lexer);
            level >= 0 ? skip_long_bracket(lexer, level) : skip_line(lexer);
        } else {
            return;
        }
    }
}

/** Goes behind a string in quotes. */
static void skip_quoted(LuaLexer *lexer) {
    char quote = peek(lexer, 0);
    advance(lexer);
    while (lexer->next < lexer->size && peek(lexer, 0) != quote) {
        if (peek(lexer, 0) == '\\') {
            advance(lexer);
        }
        advance(lexer);
    }
    advance(lexer);
}

/** Goes behind a number: Lua, too, takes all letters and digits that follow. */
static void skip_number(LuaLexer *lexer) {
    bool is_hex = peek(lexer, 0) == '0' && (peek(lexer, 1) == 'x' || peek(lexer, 1) == 'X');
    const char *exponents = is_hex ? "pP" : "eE";
    while (isalnum((unsigned char)peek(lexer, 0)) || peek(lexer, 0) == '.') {
        bool has_sign = strchr(exponents, peek(lexer, 0)) && strchr("+-", peek(lexer, 1)) &&
                        peek(lexer, 1) != '\0';
        lexer->next += has_sign ? 2 : 1;
    }
}

LuaLexer lua_lexer_begin(const char *text, size_t size) {
    LuaLexer lexer = {.text = text, .size = size, .line = 1};
    if (size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0) {
        lexer.next = 3;
    }
    if (peek(&lexer, 0) == '#') {
        skip_line(&lexer);
    }
    return lexer;
}

LuaToken lua_lexer_next(LuaLexer *lexer) {
    skip_space(lexer);
    LuaToken token = {.start = lexer->next, .line = lexer->line};
    unsigned char c = (unsigned char)peek(lexer, 0);
    int level = long_bracket_level(lexer);
    if (lexer->next >= lexer->size) {
        token.kind = LUA_TOKEN_END;
    } else if (isalpha(c) || c == '_') {
        token.kind = LUA_TOKEN_NAME;
        while (isalnum((unsigned char)peek(lexer, 0)) || peek(lexer, 0) == '_') {
            lexer->next++;
        }
    } else if (isdigit(c) || (c == '.' && isdigit((unsigned char)peek(lexer, 1)))) {
        token.kind = LUA_TOKEN_NUMBER;
        skip_number(lexer);
    } else if (c == '"' || c == '\'' || level >= 0) {
        token.kind = LUA_TOKEN_STRING;
        level >= 0 ? skip_long_bracket(lexer, level) : skip_quoted(lexer);
    } else {
        token.kind = LUA_TOKEN_SIGN;
        lexer->next++;
    }
    lexer->next = lexer->next < lexer->size ? lexer->next : lexer->size;
    token.end = lexer->next;
    return token;
}

bool lua_token_is(const char *text, const LuaToken *token, const char *word) {
    size_t length = strlen(word);
    bool is_word = token->kind == LUA_TOKEN_NAME || token->kind == LUA_TOKEN_SIGN;
    return is_word && token->end - token->start == length &&
           memcmp(text + token->start, word, length) == 0;
}
