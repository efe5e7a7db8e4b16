/**
 * @file
 * @brief Words cut into rows.
 */
#include "view/panels/word_wrap.h"

#include <string.h>

/** @return Where a row has all its letters: at its end of line, or sooner. @param row The rest of
 *          the words, UTF-8. @param characters How many it may have. */
static char *word_wrap_row_limit(char *row, int characters) {
    char *end = row;
    for (; *end && *end != '\n'; end++) {
        bool is_character = (*end & 0xC0) != 0x80; // Not the second byte of one, nor the third.
        if (is_character && characters-- == 0) {
            break;
        }
    }
    return end;
}

/** @return Where a row is cut: at its last blank, or at the first one of a word that is too long.
 *  @param row The rest of the words. @param characters How many it may have. */
static char *word_wrap_row_end(char *row, int characters) {
    char *limit = word_wrap_row_limit(row, characters), *end = limit;
    while (end > row && *end && *end != ' ' && *end != '\n') {
        end--;
    }
    return end > row || *row == '\n' ? end : limit + strcspn(limit, " \n");
}

size_t word_wrap(char *text, int characters, PanelRow *rows, size_t maximum) {
    size_t count = 0;
    char *rest = text;
    while (*rest && count < maximum) {
        char *end = word_wrap_row_end(rest, characters);
        rows[count++] = (PanelRow){.text = rest};
        rest = *end ? end + 1 : end;
        *end = '\0';
    }
    return count;
}
