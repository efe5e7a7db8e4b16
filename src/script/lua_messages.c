/**
 * @file
 * @brief What Lua itself says is wrong.
 *
 * Lua has no gettext, and writes names and values into its messages before anybody sees them. So a
 * message is held against the sentences that Lua has, what stands at the gaps is taken out of it,
 * and put into the translation.
 */
#include "script/lua_messages.h"

#include "base/language.h"
#include "dioptre/error.h"

#include <libintl.h>
#include <stdio.h>
#include <string.h>

/** Most gaps that a sentence has. */
enum { MESSAGE_ARGUMENTS_MAXIMUM = 4 };
/** What marks a gap in a sentence. */
static const char PLACEHOLDER[] = "%s";

/** What a message has at the gaps of a sentence. */
typedef struct MessageArguments {
    char texts[MESSAGE_ARGUMENTS_MAXIMUM][ERROR_MESSAGE_SIZE]; /**< The texts, ended by zeros. */
} MessageArguments;

/** Sentences of Lua 5.4, those that say more before those that say less. */
static const char *const message_formats[] = {
    N_("%s expected (to close %s at line %s) near %s"),
    N_("%s expected near %s"),
    N_("unexpected symbol near %s"),
    N_("unfinished string near %s"),
    N_("malformed number near %s"),
    N_("syntax error near %s"),
    N_("attempt to call a %s value (%s)"),
    N_("attempt to call a %s value"),
    N_("attempt to index a %s value (%s)"),
    N_("attempt to index a %s value"),
    N_("attempt to perform arithmetic on a %s value (%s)"),
    N_("attempt to perform arithmetic on a %s value"),
    N_("attempt to concatenate a %s value (%s)"),
    N_("attempt to concatenate a %s value"),
    N_("attempt to compare two %s values"),
    N_("attempt to compare %s with %s"),
    N_("attempt to perform 'n//0'"),
    N_("'for' initial value must be a number"),
    N_("'for' limit must be a number"),
    N_("'for' step must be a number"),
    N_("'for' step is zero"),
    N_("number has no integer representation"),
    N_("bad argument #%s to %s (%s expected, got %s)"),
    N_("assertion failed!"),
};

/**
 * Finds where the fixed words after a gap begin in a message.
 * @param message  The rest of the message.
 * @param is_last  Whether the message must end with them.
 * @return The place; NULL if it is not there.
 */
static const char *find_literal(const char *message, const char *literal, size_t length,
                                bool is_last) {
    size_t rest = strlen(message);
    if (!is_last) {
        return memmem(message, rest, literal, length);
    }
    const char *end = message + rest - length;
    return length <= rest && memcmp(end, literal, length) == 0 ? end : NULL;
}

/**
 * Holds a message against a sentence.
 * @param[out] arguments  What stands at the gaps.
 * @return Whether it is that sentence.
 */
static bool match_format(const char *format, const char *message, MessageArguments *arguments) {
    const char *placeholder = strstr(format, PLACEHOLDER);
    size_t length = placeholder ? (size_t)(placeholder - format) : strlen(format);
    if (strncmp(message, format, length) != 0) {
        return false;
    }
    message += length;
    for (int i = 0; placeholder; i++) {
        const char *literal = placeholder + strlen(PLACEHOLDER);
        placeholder = strstr(literal, PLACEHOLDER);
        length = placeholder ? (size_t)(placeholder - literal) : strlen(literal);
        const char *end = find_literal(message, literal, length, !placeholder);
        if (!end) {
            return false;
        }
        snprintf(arguments->texts[i], ERROR_MESSAGE_SIZE, "%.*s", (int)(end - message), message);
        message = end + length;
    }
    return *message == '\0';
}

bool lua_message_translate(const char *message, char *translated, size_t size) {
    MessageArguments arguments = {0};
    for (size_t i = 0; i < sizeof message_formats / sizeof *message_formats; i++) {
        if (match_format(message_formats[i], message, &arguments)) {
            snprintf(translated, size, gettext(message_formats[i]), arguments.texts[0],
                     arguments.texts[1], arguments.texts[2], arguments.texts[3]);
            return true;
        }
    }
    return false;
}
