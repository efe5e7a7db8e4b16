/**
 * @file
 * @brief Finding a constructor in the text of a scene, and replacing a value in it.
 */
#include "view/state/source_edit.h"

#include "base/language.h"
#include "view/state/lua_token.h"

#include <stdlib.h>
#include <string.h>

/** What is found of a field in its constructor. */
typedef struct FieldPlace {
    int count;       /**< How many times the field is given. */
    LuaToken first;  /**< First token of its value. */
    LuaToken last;   /**< Last token of its value. */
    bool is_literal; /**< Whether the value is written out: a number, a word, a list of numbers. */
    bool has_computed_names; /**< Whether a field's name is computed: it may be this one. */
    LuaToken final;          /**< Last token before the brace that ends the constructor. */
} FieldPlace;

/**
 * Finds the brace of a constructor on a line.
 * @param[out] brace  A lexer behind the brace.
 * @param[out] last   The brace.
 * @return Number of such constructors on the line.
 */
static int find_constructor(const char *text, size_t size, const SourceField *field,
                            LuaLexer *brace, LuaToken *last) {
    LuaLexer lexer = lua_lexer_begin(text, size);
    LuaToken before = {0}, name = {0};
    int count = 0;
    for (LuaToken token = lua_lexer_next(&lexer); token.kind != LUA_TOKEN_END;) {
        before = name;
        name = token;
        token = lua_lexer_next(&lexer);
        bool is_member = lua_token_is(text, &before, ".") || lua_token_is(text, &before, ":") ||
                         lua_token_is(text, &before, "function");
        if (is_member || !lua_token_is(text, &name, field->keyword)) {
            continue;
        }
        LuaLexer ahead = lexer;
        LuaToken opening = lua_token_is(text, &token, "(") ? lua_lexer_next(&ahead) : token;
        bool is_here = name.line == field->line || token.line == field->line;
        if (is_here && lua_token_is(text, &opening, "{")) {
            count++;
            *brace = ahead;
            *last = opening;
        }
    }
    return count;
}

/** @return Whether a token is a plain value: a number, a string, true or false. */
static bool is_plain(const char *text, const LuaToken *token) {
    return token->kind == LUA_TOKEN_NUMBER || token->kind == LUA_TOKEN_STRING ||
           lua_token_is(text, token, "true") || lua_token_is(text, token, "false");
}

/** @return Whether a token separates fields or ends the table. */
static bool is_separator(const char *text, const LuaToken *token) {
    return lua_token_is(text, token, ",") || lua_token_is(text, token, ";") ||
           lua_token_is(text, token, "}");
}

/** @return How much deeper the next token is in brackets and functions. */
static int depth_change(const char *text, const LuaToken *token) {
    static const char *const opening[] = {"(", "{", "[", "function", "do", "then", "repeat", NULL};
    static const char *const closing[] = {")", "}", "]", "end", "until", "elseif", "else", NULL};
    for (int i = 0; opening[i]; i++) {
        if (lua_token_is(text, token, opening[i])) {
            return 1;
        }
    }
    for (int i = 0; closing[i]; i++) {
        if (lua_token_is(text, token, closing[i])) {
            // An else ends one block and begins another.
            return strcmp(closing[i], "else") == 0 ? 0 : -1;
        }
    }
    return 0;
}

/**
 * Reads the tokens of a value.
 * @param first       Its first token.
 * @param[out] last   Its last token.
 * @param[out] next   The token behind it.
 * @return Whether the value is written out.
 */
static bool read_value(LuaLexer *lexer, LuaToken first, LuaToken *last, LuaToken *next) {
    const char *text = lexer->text;
    bool is_literal = true;
    int depth = 0, values = 0;
    LuaToken token = first, before = {0};
    while (token.kind != LUA_TOKEN_END && (depth > 0 || !is_separator(text, &token))) {
        bool is_list = depth == 0 && values == 0 && lua_token_is(text, &token, "{");
        bool is_inside = depth == 1 && is_separator(text, &token);
        bool is_minus = lua_token_is(text, &token, "-") &&
                        (before.kind == LUA_TOKEN_END || is_separator(text, &before) ||
                         lua_token_is(text, &before, "{"));
        bool is_sole = is_plain(text, &token) && !is_plain(text, &before);
        is_literal = is_literal && (is_list || is_inside || is_minus || is_sole);
        values += depth == 0;
        depth += depth_change(text, &token);
        *last = before = token;
        token = lua_lexer_next(lexer);
    }
    *next = token;
    return is_literal && values > 0;
}

/** @return Whether a token is the name of the field in quotes. */
static bool is_quoted_name(const char *text, const LuaToken *token, const char *name) {
    size_t length = strlen(name);
    return token->kind == LUA_TOKEN_STRING && token->end - token->start == length + 2 &&
           memcmp(text + token->start + 1, name, length) == 0;
}

/**
 * Reads the name of a field, if there is one.
 * @param[in,out] token  First token of the field; then of its value.
 * @param[out] place     Whether the name is computed.
 * @return Whether it is the field that is wanted.
 */
static bool read_name(LuaLexer *lexer, LuaToken *token, const char *name, FieldPlace *place) {
    const char *text = lexer->text;
    LuaLexer ahead = *lexer;
    LuaToken inner = lua_lexer_next(&ahead);
    bool is_wanted = lua_token_is(text, token, name);
    if (token->kind == LUA_TOKEN_NAME && lua_token_is(text, &inner, "=")) {
        LuaLexer behind = ahead;
        LuaToken second = lua_lexer_next(&behind);
        // Two equal signs compare.
        if (!(lua_token_is(text, &second, "=") && second.start == inner.end)) {
            *lexer = behind;
            *token = second;
            return is_wanted;
        }
    }
    if (!lua_token_is(text, token, "[")) {
        return false;
    }
    is_wanted = is_quoted_name(text, &inner, name);
    LuaToken bracket = lua_lexer_next(&ahead);
    if (inner.kind != LUA_TOKEN_STRING || !lua_token_is(text, &bracket, "]")) {
        place->has_computed_names = true;
        return false;
    }
    lua_lexer_next(&ahead); // The equal sign.
    *token = lua_lexer_next(&ahead);
    *lexer = ahead;
    return is_wanted;
}

/** Finds a field in a constructor. @param lexer Behind its brace. @param brace The brace. */
static FieldPlace find_field(LuaLexer *lexer, LuaToken brace, const char *name) {
    FieldPlace place = {.final = brace};
    const char *text = lexer->text;
    LuaToken token = lua_lexer_next(lexer);
    while (token.kind != LUA_TOKEN_END && !lua_token_is(text, &token, "}")) {
        if (is_separator(text, &token)) {
            place.final = token;
            token = lua_lexer_next(lexer);
            continue;
        }
        bool is_wanted = read_name(lexer, &token, name, &place);
        LuaToken first = token, last = token, next;
        bool is_literal = read_value(lexer, first, &last, &next);
        if (is_wanted) {
            place.count++;
            place.first = first;
            place.last = last;
            place.is_literal = is_literal;
        }
        place.final = last;
        token = next;
    }
    return place;
}

/** @return Whether the value of a field can be written. */
static bool check_place(const FieldPlace *place, const SourceField *field, Error *error) {
    if (place->count > 1) {
        return error_set(error, STATUS_SCENE, "line %d gives %s twice", field->line, field->name);
    }
    if (place->count == 1 && !place->is_literal) {
        return error_set(error, STATUS_SCENE,
                         "line %d computes %s: only a value that is written out can be replaced",
                         field->line, field->name);
    }
    return place->count == 1 || !place->has_computed_names ||
           error_set(error, STATUS_SCENE, "line %d computes the name of a field: it may be %s",
                     field->line, field->name);
}

/** @return Parts of a text put together; NULL without memory. */
static char *join(const char *const parts[], const size_t sizes[], size_t count, size_t *size,
                  Error *error) {
    *size = 0;
    for (size_t i = 0; i < count; i++) {
        *size += sizes[i];
    }
    char *joined = malloc(*size + 1), *next = joined;
    if (!joined) {
        error_set(error, STATUS_FAILED, "no memory for a scene file");
        return NULL;
    }
    for (size_t i = 0; i < count; i++) {
        next = mempcpy(next, parts[i], sizes[i]);
    }
    *next = '\0';
    return joined;
}

char *source_edit_set(const char *text, size_t size, const SourceField *field, size_t *new_size,
                      Error *error) {
    LuaLexer lexer = {0};
    LuaToken brace = {0};
    int count = find_constructor(text, size, field, &lexer, &brace);
    if (count != 1) {
        error_set(error, STATUS_SCENE,
                  count == 0 ? N_("line %d has no `%s { ... }`, with its fields in braces")
                             : N_("line %d has more than one `%s { ... }`"),
                  field->line, field->keyword);
        return NULL;
    }
    FieldPlace place = find_field(&lexer, brace, field->name);
    if (!check_place(&place, field, error)) {
        return NULL;
    }
    bool is_new = place.count == 0;
    size_t start = is_new ? place.final.end : place.first.start;
    size_t end = is_new ? start : place.last.end;
    bool has_comma = lua_token_is(text, &place.final, ",") || lua_token_is(text, &place.final, ";");
    bool needs_comma = is_new && !has_comma && !lua_token_is(text, &place.final, "{");
    const char *const parts[] = {text,
                                 needs_comma ? "," : "",
                                 is_new ? " " : "",
                                 is_new ? field->name : "",
                                 is_new ? " = " : "",
                                 field->value,
                                 is_new && has_comma ? "," : "",
                                 text + end};
    const size_t sizes[] = {start,
                            strlen(parts[1]),
                            strlen(parts[2]),
                            strlen(parts[3]),
                            strlen(parts[4]),
                            strlen(parts[5]),
                            strlen(parts[6]),
                            size - end};
    return join(parts, sizes, sizeof sizes / sizeof *sizes, new_size, error);
}
