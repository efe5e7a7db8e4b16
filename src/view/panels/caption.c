/**
 * @file
 * @brief Captions with a heading: the lesson's title and the caption's number; notices.
 */
#include "view/panels/caption.h"

#include "base/language.h"

#include <libintl.h>
#include <stdio.h>
#include <string.h>

/** Most rows of a caption. */
enum { CAPTION_ROWS_MAXIMUM = 6 };
/** Most characters of a row: as many as fit in large letters in a window of 800 pixels. */
enum { CAPTION_ROW_CHARACTERS = 46 };
/** Bytes of a caption; a longer one is cut. */
enum { CAPTION_TEXT_SIZE = 1024 };
/** Most rows of a notice. */
enum { NOTICE_ROWS_MAXIMUM = 8 };
/** Most characters of a row of a notice. */
enum { NOTICE_ROW_CHARACTERS = 64 };
/** Factor of the size of a caption's letters. */
static const double FONT_SCALE = 1.4;

void caption_close(Caption *caption) {
    caption->text = (LessonText){0};
    overlay_invalidate(&caption->overlay);
}

/** Writes the heading. */
static void caption_write_heading(const Caption *caption, char *text, size_t size) {
    const char *title = lesson_text_localized(&caption->title, language_is_french());
    const char *hint = caption->hint ? gettext(caption->hint) : "";
    const char *gap = caption->hint && caption->number > 0 ? " — " : "";
    if (caption->number > 0) {
        snprintf(text, size, "%s%s%zu/%zu%s%s", title, *title ? ", " : "", caption->number,
                 caption->count, gap, hint);
    } else {
        snprintf(text, size, "%s", hint);
    }
}

/** Draws the caption. */
static void caption_draw(Caption *caption, const OverlayTarget *target) {
    char text[CAPTION_TEXT_SIZE], heading[CAPTION_TEXT_SIZE];
    PanelRow rows[CAPTION_ROWS_MAXIMUM + 1];
    const OverlayTarget large = {target->renderer, target->scale * FONT_SCALE,
                                 target->width_fraction, target->top};
    caption_write_heading(caption, heading, sizeof heading);
    rows[0] = (PanelRow){.is_heading = true, .text = heading};
    snprintf(text, sizeof text, "%s", lesson_text_localized(&caption->text, language_is_french()));
    size_t headings = heading[0] ? 1 : 0;
    size_t count =
        headings + word_wrap(text, CAPTION_ROW_CHARACTERS, rows + headings, CAPTION_ROWS_MAXIMUM);
    overlay_draw(&caption->overlay, &large, rows, count);
}

void caption_show(Caption *caption, const OverlayTarget *target) {
    if (!caption->text.english && !caption->text.french) {
        return;
    }
    if (overlay_is_stale(&caption->overlay)) {
        caption_draw(caption, target);
    }
    overlay_show(&caption->overlay, target);
}

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
