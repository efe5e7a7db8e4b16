/**
 * @file
 * @brief Captions with a heading that says which key to press; notices.
 */
#include "view/panels/caption.h"

#include "base/language.h"

#include <libintl.h>
#include <stdio.h>
#include <string.h>

/** Widest caption, in heights of letters: lines that are easy to read. */
static const float WIDTH_MAXIMUM = 34;
/** Widest caption at the left or right edge, fraction of the picture. */
static const float SIDE_WIDTH = 0.34F;

void caption_close(Caption *caption) {
    caption->text = (LessonText){0};
}

bool caption_is_open(const Caption *caption) {
    return caption->text.english || caption->text.french;
}

/** Writes the rows. @return Their number. */
static size_t write_rows(const Caption *caption, GuiRow rows[2]) {
    size_t count = 0;
    if (caption->hint) {
        rows[count++] = (GuiRow){.is_heading = true, .text = gettext(caption->hint)};
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

/** @return The place of a caption on a side of a room. */
static GuiPlace place_on(const GuiRect *room, CaptionSide side) {
    if (side == CAPTION_BELOW || side == CAPTION_ABOVE) {
        return (GuiPlace){narrowed(room), 0.5F, side == CAPTION_ABOVE ? 0 : 1};
    }
    GuiRect part = *room;
    part.width = SDL_min(SIDE_WIDTH * room->width, WIDTH_MAXIMUM * gui_text_size());
    part.x += side == CAPTION_RIGHT ? room->width - part.width : 0;
    return (GuiPlace){part, side == CAPTION_RIGHT ? 1 : 0, 0.5F};
}

GuiRect caption_rect(const Caption *caption, const GuiRect *room, CaptionSide side) {
    GuiRow rows[2];
    size_t count = write_rows(caption, rows);
    GuiPlace place = place_on(room, side);
    GuiRect rect = place.room;
    rect.height = gui_rows_panel_height(rows, count, rect.width);
    rect.y += place.y * (room->height - rect.height);
    return rect;
}

GuiRect caption_show(const Caption *caption, const GuiRect *room) {
    GuiRow rows[2];
    GuiRect extent = {0};
    if (caption_is_open(caption)) {
        size_t count = write_rows(caption, rows);
        const GuiPlace place = place_on(room, caption->side);
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
