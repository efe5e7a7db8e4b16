/**
 * @file
 * @brief Captions: a small heading with the lesson's title and the caption's number, then the
 *        words.
 */
#include "view/caption.h"

#include "dioptre/language.h"
#include "view/rows.h"

#include <libintl.h>
#include <stdio.h>

/** Rows of words at most. */
enum { ROWS_MAXIMUM = 6 };
/** Letters of a row, unless a word is longer: so many can be large in a window of 800 pixels. */
enum { ROW_LETTERS = 46 };
/** Bytes of a caption; a longer one is cut. */
enum { WORDS_SIZE = 1024 };
/** How many times as large as other words captions are. */
static const double LARGE = 1.4;

void caption_close(Caption *caption) {
    caption->text = (LessonText){0};
    overlay_forget(&caption->overlay);
}

/** Writes the heading. @param caption The caption. @param[out] words The heading; empty: none.
 *  @param size Bytes that fit. */
static void write_heading(const Caption *caption, char *words, size_t size) {
    const char *title = lesson_words(&caption->title, language_is_french());
    const char *hint = caption->hint ? gettext(caption->hint) : "";
    const char *gap = caption->hint && caption->number > 0 ? " — " : "";
    if (caption->number > 0) {
        snprintf(words, size, "%s%s%zu/%zu%s%s", title, *title ? ", " : "", caption->number,
                 caption->count, gap, hint);
    } else {
        snprintf(words, size, "%s", hint);
    }
}

/** Draws the caption anew. @param[in,out] caption The caption. @param screen The window. */
static void draw(Caption *caption, const OverlayScreen *screen) {
    char words[WORDS_SIZE], heading[WORDS_SIZE];
    PanelRow rows[ROWS_MAXIMUM + 1];
    const OverlayScreen large = {screen->renderer, screen->scale * LARGE, screen->share};
    write_heading(caption, heading, sizeof heading);
    rows[0] = (PanelRow){.is_heading = true, .text = heading};
    snprintf(words, sizeof words, "%s", lesson_words(&caption->text, language_is_french()));
    size_t headings = heading[0] ? 1 : 0;
    size_t count = headings + rows_cut(words, ROW_LETTERS, rows + headings, ROWS_MAXIMUM);
    overlay_draw(&caption->overlay, &large, rows, count);
}

void caption_show(Caption *caption, const OverlayScreen *screen) {
    if (!caption->text.english && !caption->text.french) {
        return;
    }
    if (overlay_is_stale(&caption->overlay)) {
        draw(caption, screen);
    }
    overlay_show(&caption->overlay, screen);
}
