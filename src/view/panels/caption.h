/**
 * @file
 * @brief Text over the picture: captions of lessons, notices of errors and notes.
 */
#ifndef DIOPTRE_VIEW_PANELS_CAPTION_H
#define DIOPTRE_VIEW_PANELS_CAPTION_H

#include "dioptre/lesson.h"
#include "view/gui/gui.h"

/** A caption of a lesson. Starts as `{0}`: none. */
typedef struct Caption {
    LessonText text;  /**< Its text, owned by the lesson; none: it is closed. */
    LessonText title; /**< Title of the lesson. */
    size_t number;    /**< Which caption of the lesson, from 1; 0: it belongs to no lesson. */
    size_t count;     /**< Number of captions of the lesson. */
    const char *hint; /**< Which key to press now, in English; NULL: no hint. */
    bool is_above;    /**< Whether it lies at the upper edge of the picture. */
} Caption;

/** Closes the caption. */
void caption_close(Caption *caption);

/** @return Whether there is a caption. */
bool caption_is_open(const Caption *caption);

/** @return The height of the caption in a room of some width. */
float caption_height(const Caption *caption, float width);

/** Shows the caption over the picture, if there is one. @return Where it lies. */
GuiRect caption_show(const Caption *caption, const GuiRect *room);

/** Bytes of a notice with the final zero; a longer one is cut. */
enum { NOTICE_SIZE = 512 };

/** A notice of an error. Starts as `{0}`: none. */
typedef struct Notice {
    char text[NOTICE_SIZE]; /**< Its text, UTF-8; empty: it is closed. */
} Notice;

/** Sets the text. @param text UTF-8; empty: closes it. @return Whether the text has changed. */
bool notice_set(Notice *notice, const char *text);

/** Shows the notice at the lower edge of a room, if there is one. @return Its height. */
float notice_show(const Notice *notice, const GuiRect *room);

#endif
