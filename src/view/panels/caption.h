/**
 * @file
 * @brief Text at the lower edge of the picture: captions of lessons, notices of errors and notes.
 */
#ifndef DIOPTRE_VIEW_PANELS_CAPTION_H
#define DIOPTRE_VIEW_PANELS_CAPTION_H

#include "dioptre/lesson.h"
#include "view/panels/panel.h"

/** A caption of a lesson, in large letters. Starts as `{.overlay.anchor = OVERLAY_BOTTOM}`. */
typedef struct Caption {
    LessonText text;  /**< Its text, owned by the lesson; none: it is closed. */
    LessonText title; /**< Title of the lesson. */
    size_t number;    /**< Which caption of the lesson, from 1; 0: it belongs to no lesson. */
    size_t count;     /**< Number of captions of the lesson. */
    const char *hint; /**< Which key to press now, in English; NULL: no hint. */
    Overlay overlay;  /**< Its panel. */
} Caption;

/** Closes the caption. */
void caption_close(Caption *caption);

/** Shows the caption over the picture, if there is one. */
void caption_show(Caption *caption, const OverlayTarget *target);

/** Bytes of a notice with the final zero; a longer one is cut. */
enum { NOTICE_SIZE = 512 };

/** A notice of an error. Starts as `{.overlay.anchor = OVERLAY_BOTTOM}`. */
typedef struct Notice {
    char text[NOTICE_SIZE]; /**< Its text, UTF-8; empty: it is closed. */
    Overlay overlay;        /**< Its panel. */
} Notice;

/** Sets the text. @param text UTF-8; empty: closes it. @return Whether the text has changed. */
bool notice_set(Notice *notice, const char *text);

/** Shows the notice over the picture, if there is one. */
void notice_show(Notice *notice, const OverlayTarget *target);

#endif
