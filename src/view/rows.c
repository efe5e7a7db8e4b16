/**
 * @file
 * @brief Words cut into rows.
 */
#include "view/rows.h"

#include <string.h>

/** @return Where a row has all its letters: at its end of line, or sooner. @param row The rest of
 *          the words, UTF-8. @param letters How many it may have. */
static char *row_limit(char *row, int letters) {
    char *end = row;
    for (; *end && *end != '\n'; end++) {
        bool is_letter = (*end & 0xC0) != 0x80; // Not the second byte of one, nor the third.
        if (is_letter && letters-- == 0) {
            break;
        }
    }
    return end;
}

/** @return Where a row is cut: at its last blank, or at the first one of a word that is too long.
 *  @param row The rest of the words. @param letters How many it may have. */
static char *row_end(char *row, int letters) {
    char *limit = row_limit(row, letters), *end = limit;
    while (end > row && *end && *end != ' ' && *end != '\n') {
        end--;
    }
    return end > row || *row == '\n' ? end : limit + strcspn(limit, " \n");
}

size_t rows_cut(char *words, int letters, PanelRow *rows, size_t most) {
    size_t count = 0;
    char *rest = words;
    while (*rest && count < most) {
        char *end = row_end(rest, letters);
        rows[count++] = (PanelRow){.text = rest};
        rest = *end ? end + 1 : end;
        *end = '\0';
    }
    return count;
}
