/**
 * @file
 * @brief Text over the picture: the caption that is typed, notices of errors and notes.
 */
#ifndef DIOPTRE_VIEW_PANELS_CAPTION_H
#define DIOPTRE_VIEW_PANELS_CAPTION_H

#include "dioptre/lesson.h"
#include "view/gui/gui.h"

/** Where a caption lies on the picture. */
typedef enum {
    CAPTION_BELOW,     /**< At the lower edge. */
    CAPTION_ABOVE,     /**< At the upper edge. */
    CAPTION_LEFT,      /**< At the left edge. */
    CAPTION_RIGHT,     /**< At the right edge. */
    CAPTION_SIDE_COUNT /**< Number of sides. */
} CaptionSide;

/** A caption that is typed for a lesson. Starts as `{0}`: none. */
typedef struct Caption {
    LessonText text;  /**< Its text, not owned; none: it is closed. */
    const char *hint; /**< Which key to press now, in English; NULL: no hint. */
    CaptionSide side; /**< Where it lies. */
} Caption;

/** Closes the caption. */
void caption_close(Caption *caption);

/** @return Whether there is a caption. */
bool caption_is_open(const Caption *caption);

/** @return Where the caption lies in a room, if it is on a side. */
GuiRect caption_rect(const Caption *caption, const GuiRect *room, CaptionSide side);

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
