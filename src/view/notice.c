/**
 * @file
 * @brief Notices.
 */
#include "view/notice.h"

#include "view/rows.h"

#include <stdio.h>
#include <string.h>

/** Rows of a notice at most. */
enum { ROWS_MAXIMUM = 8 };
/** Letters of a row, unless a word is longer: what can be read at a glance. */
enum { ROW_LETTERS = 64 };

bool notice_say(Notice *notice, const char *words) {
    if (strncmp(notice->words, words, NOTICE_SIZE - 1) == 0) {
        return false;
    }
    snprintf(notice->words, NOTICE_SIZE, "%s", words);
    overlay_forget(&notice->overlay);
    return true;
}

void notice_show(Notice *notice, const OverlayScreen *screen) {
    if (notice->words[0] == '\0') {
        return;
    }
    if (overlay_is_stale(&notice->overlay)) {
        char words[NOTICE_SIZE];
        PanelRow rows[ROWS_MAXIMUM];
        memcpy(words, notice->words, sizeof words);
        size_t count = rows_cut(words, ROW_LETTERS, rows, ROWS_MAXIMUM);
        overlay_draw(&notice->overlay, screen, rows, count);
    }
    overlay_show(&notice->overlay, screen);
}
