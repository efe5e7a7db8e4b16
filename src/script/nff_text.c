/**
 * @file
 * @brief The words and numbers of an NFF text.
 */
#include "script/nff_text.h"

#include <stdlib.h>
#include <string.h>

/** @return Whether a character separates words within a line. */
static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

/** Moves a position behind blanks and comments, but not to the next line. */
static void skip_blanks(NffText *text) {
    while (text->next < text->end && (is_blank(*text->next) || *text->next == '#')) {
        if (*text->next == '#') {
            const char *newline = memchr(text->next, '\n', (size_t)(text->end - text->next));
            text->next = newline ? newline : text->end;
        } else {
            text->next++;
        }
    }
}

bool nff_text_has_word_in_line(NffText *text) {
    skip_blanks(text);
    return text->next < text->end && *text->next != '\n';
}

bool nff_text_word(NffText *text, char word[NFF_WORD_SIZE]) {
    skip_blanks(text);
    while (text->next < text->end && *text->next == '\n') {
        text->line++;
        text->next++;
        skip_blanks(text);
    }
    size_t length = 0;
    while (text->next < text->end && !is_blank(*text->next) && *text->next != '\n' &&
           *text->next != '#') {
        if (length + 1 < NFF_WORD_SIZE) {
            word[length++] = *text->next;
        }
        text->next++;
    }
    word[length] = '\0';
    return length > 0;
}

bool nff_text_numbers(NffText *text, const char *statement, size_t count, double *numbers,
                      Error *error) {
    for (size_t i = 0; i < count; i++) {
        char word[NFF_WORD_SIZE], *end;
        if (!nff_text_word(text, word)) {
            return error_set(error, STATUS_SCENE,
                             "`%s` needs %zu numbers; the file ends after %zu of them", statement,
                             count, i);
        }
        numbers[i] = strtod(word, &end);
        if (*end) {
            return error_set(error, STATUS_SCENE, "`%s` needs %zu numbers; number %zu is `%s`",
                             statement, count, i + 1, word);
        }
    }
    return true;
}
