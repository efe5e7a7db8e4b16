/**
 * @file
 * @brief What Lua itself says is wrong.
 *
 * Lua has no gettext, and writes names and values into its messages before anybody sees them. So a
 * message is held against the sentences that Lua has, what stands at the gaps is taken out of it,
 * and put into the translation.
 */
#include "script/lua_words.h"

#include "dioptre/error.h"
#include "dioptre/language.h"

#include <libintl.h>
#include <stdio.h>
#include <string.h>

/** Most gaps that a sentence has. */
enum { GAPS_MAXIMUM = 4 };
/** What marks a gap in a sentence. */
static const char GAP[] = "%s";

/** What a message has at the gaps of a sentence. */
typedef struct Gaps {
    char texts[GAPS_MAXIMUM][ERROR_MESSAGE_SIZE]; /**< The texts, ended by zeros. */
} Gaps;

/** Sentences of Lua 5.4, those that say more before those that say less. */
static const char *const sentences[] = {
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
 * @param fixed    The fixed words.
 * @param length   Bytes of them.
 * @param is_last  Whether the message must end with them.
 * @return The place; NULL if it is not there.
 */
static const char *find_fixed(const char *message, const char *fixed, size_t length, bool is_last) {
    size_t rest = strlen(message);
    if (!is_last) {
        return memmem(message, rest, fixed, length);
    }
    const char *end = message + rest - length;
    return length <= rest && memcmp(end, fixed, length) == 0 ? end : NULL;
}

/**
 * Holds a message against a sentence.
 * @param sentence   The sentence, with gaps.
 * @param message    The message.
 * @param[out] gaps  What stands at the gaps.
 * @return Whether it is that sentence.
 */
static bool is_sentence(const char *sentence, const char *message, Gaps *gaps) {
    const char *gap = strstr(sentence, GAP);
    size_t length = gap ? (size_t)(gap - sentence) : strlen(sentence);
    if (strncmp(message, sentence, length) != 0) {
        return false;
    }
    message += length;
    for (int i = 0; gap; i++) {
        const char *fixed = gap + strlen(GAP);
        gap = strstr(fixed, GAP);
        length = gap ? (size_t)(gap - fixed) : strlen(fixed);
        const char *end = find_fixed(message, fixed, length, !gap);
        if (!end) {
            return false;
        }
        snprintf(gaps->texts[i], ERROR_MESSAGE_SIZE, "%.*s", (int)(end - message), message);
        message = end + length;
    }
    return *message == '\0';
}

bool lua_words_translate(const char *message, char *words, size_t size) {
    Gaps gaps = {0};
    for (size_t i = 0; i < sizeof sentences / sizeof *sentences; i++) {
        if (is_sentence(sentences[i], message, &gaps)) {
            snprintf(words, size, gettext(sentences[i]), gaps.texts[0], gaps.texts[1],
                     gaps.texts[2], gaps.texts[3]);
            return true;
        }
    }
    return false;
}
