/**
 * @file
 * @brief Captions with a heading: the lesson's title and the caption's number; notices.
 */
#include "view/panels/caption.h"

#include "base/language.h"

#include <libintl.h>
#include <stdio.h>
#include <string.h>

/** Bytes of a caption's heading; a longer one is cut. */
enum { HEADING_SIZE = 256 };
/** Widest caption, in heights of letters: lines that are easy to read. */
static const float WIDTH_MAXIMUM = 34;

void caption_close(Caption *caption) {
    caption->text = (LessonText){0};
}

bool caption_is_open(const Caption *caption) {
    return caption->text.english || caption->text.french;
}

/** Writes the heading. */
static void write_heading(const Caption *caption, char text[HEADING_SIZE]) {
    const char *title = lesson_text_localized(&caption->title, language_is_french());
    const char *hint = caption->hint ? gettext(caption->hint) : "";
    const char *gap = caption->hint && caption->number > 0 ? " — " : "";
    if (caption->number > 0) {
        snprintf(text, HEADING_SIZE, "%s%s%zu/%zu%s%s", title, *title ? ", " : "", caption->number,
                 caption->count, gap, hint);
    } else {
        snprintf(text, HEADING_SIZE, "%s", hint);
    }
}

/** Writes the rows. @return Their number. */
static size_t write_rows(const Caption *caption, char heading[HEADING_SIZE], GuiRow rows[2]) {
    size_t count = 0;
    write_heading(caption, heading);
    if (heading[0] != '\0') {
        rows[count++] = (GuiRow){.is_heading = true, .text = heading};
    }
    rows[count++] = (GuiRow){.text = lesson_text_localized(&caption->text, language_is_french())};
    return count;
}

/** @return A room that is no wider than a text should be. */
static GuiRect narrowed(const GuiRect *room) {
    GuiRect part = *room;
    part.width = SDL_min(room->width, WIDTH_MAXIMUM * gui_text_size());
    part.x += (room->width - part.width) / 2;
    return part;
}

float caption_height(const Caption *caption, float width) {
    char heading[HEADING_SIZE];
    GuiRow rows[2];
    size_t count = write_rows(caption, heading, rows);
    return gui_rows_panel_height(rows, count, SDL_min(width, WIDTH_MAXIMUM * gui_text_size()));
}

GuiRect caption_show(const Caption *caption, const GuiRect *room) {
    char heading[HEADING_SIZE];
    GuiRow rows[2];
    GuiRect extent = {0};
    if (caption_is_open(caption)) {
        size_t count = write_rows(caption, heading, rows);
        const GuiPlace place = {narrowed(room), 0.5F, caption->is_above ? 0 : 1};
        gui_rows_panel("caption", &place, rows, count, (GuiCell){-1, 0}, &extent);
    }
    return extent;
}

bool notice_set(Notice *notice, const char *text) {
    if (strncmp(notice->text, text, NOTICE_SIZE - 1) == 0) {
        return false;
    }
    snprintf(notice->text, NOTICE_SIZE, "%s", text);
    return true;
}

float notice_show(const Notice *notice, const GuiRect *room) {
    GuiRect extent = {0};
    if (notice->text[0] != '\0') {
        const GuiRow row = {.text = notice->text, .label = "⚠", .color = GUI_COLOR_ERROR};
        const GuiPlace place = {narrowed(room), 0.5F, 1};
        gui_rows_panel("notice", &place, &row, 1, (GuiCell){-1, 0}, &extent);
    }
    return extent.height;
}
