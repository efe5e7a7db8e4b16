/**
 * @file
 * @brief Notices.
 */
#include "view/panels/notice.h"

#include "view/panels/word_wrap.h"

#include <stdio.h>
#include <string.h>

/** Rows of a notice at most. */
enum { NOTICE_ROWS_MAXIMUM = 8 };
/** Letters of a row, unless a word is longer: what can be read at a glance. */
enum { NOTICE_ROW_CHARACTERS = 64 };

bool notice_set(Notice *notice, const char *text) {
    if (strncmp(notice->text, text, NOTICE_SIZE - 1) == 0) {
        return false;
    }
    snprintf(notice->text, NOTICE_SIZE, "%s", text);
    overlay_invalidate(&notice->overlay);
    return true;
}

void notice_show(Notice *notice, const OverlayTarget *target) {
    if (notice->text[0] == '\0') {
        return;
    }
    if (overlay_is_stale(&notice->overlay)) {
        char text[NOTICE_SIZE];
        PanelRow rows[NOTICE_ROWS_MAXIMUM];
        memcpy(text, notice->text, sizeof text);
        size_t count = word_wrap(text, NOTICE_ROW_CHARACTERS, rows, NOTICE_ROWS_MAXIMUM);
        overlay_draw(&notice->overlay, target, rows, count);
    }
    overlay_show(&notice->overlay, target);
}
