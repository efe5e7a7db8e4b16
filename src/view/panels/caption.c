/**
 * @file
 * @brief Captions: a small heading with the lesson's title and the caption's number, then the
 *        words.
 */
#include "view/panels/caption.h"

#include "base/language.h"
#include "view/panels/word_wrap.h"

#include <libintl.h>
#include <stdio.h>

/** Rows of words at most. */
enum { CAPTION_ROWS_MAXIMUM = 6 };
/** Letters of a row, unless a word is longer: so many can be large in a window of 800 pixels. */
enum { CAPTION_ROW_CHARACTERS = 46 };
/** Bytes of a caption; a longer one is cut. */
enum { CAPTION_TEXT_SIZE = 1024 };
/** How many times as large as other words captions are. */
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

/** Draws the caption anew. */
static void caption_draw(Caption *caption, const OverlayTarget *target) {
    char text[CAPTION_TEXT_SIZE], heading[CAPTION_TEXT_SIZE];
    PanelRow rows[CAPTION_ROWS_MAXIMUM + 1];
    const OverlayTarget large = {target->renderer, target->scale * FONT_SCALE,
                                 target->width_fraction};
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
