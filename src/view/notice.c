/**
 * @file
 * @brief Notices: long words are cut into rows at blanks.
 */
#include "view/notice.h"

#include <stdio.h>
#include <string.h>

/** Rows of a notice at most. */
enum { ROWS_MAXIMUM = 8 };
/** Bytes of a row, unless a word is longer: what can be read at a glance. */
enum { ROW_BYTES = 64 };

bool notice_say(Notice *notice, const char *words) {
    if (strncmp(notice->words, words, NOTICE_SIZE - 1) == 0) {
        return false;
    }
    snprintf(notice->words, NOTICE_SIZE, "%s", words);
    overlay_forget(&notice->overlay);
    return true;
}

/** @return Where a row is cut: at its last blank, or at the first one of a word that is too long.
 *  @param row The rest of the words. */
static char *row_end(char *row) {
    size_t length = strlen(row);
    char *end = length > ROW_BYTES ? row + ROW_BYTES : row + length;
    while (end > row && *end && *end != ' ') {
        end--;
    }
    return end > row ? end : row + strcspn(row, " ");
}

/** Cuts words into rows. @param[in,out] words The words; a zero ends each row. @param[out] rows The
 *  rows. @return How many. */
static size_t rows_cut(char words[NOTICE_SIZE], PanelRow rows[ROWS_MAXIMUM]) {
    size_t count = 0;
    char *rest = words;
    while (*rest && count < ROWS_MAXIMUM) {
        char *end = row_end(rest);
        rows[count++] = (PanelRow){.text = rest};
        rest = *end ? end + 1 : end;
        *end = '\0';
    }
    return count;
}

void notice_show(Notice *notice, const OverlayScreen *screen) {
    if (notice->words[0] == '\0') {
        return;
    }
    if (overlay_is_stale(&notice->overlay)) {
        char words[NOTICE_SIZE];
        PanelRow rows[ROWS_MAXIMUM];
        memcpy(words, notice->words, sizeof words);
        size_t count = rows_cut(words, rows);
        overlay_draw(&notice->overlay, screen, rows, count);
    }
    overlay_show(&notice->overlay, screen);
}
