/**
 * @file
 * @brief A lesson's words at the lower edge of the picture, large.
 */
#ifndef DIOPTRE_VIEW_PANELS_CAPTION_H
#define DIOPTRE_VIEW_PANELS_CAPTION_H

#include "dioptre/lesson.h"
#include "view/panels/overlay.h"

/** A caption. Starts as `{.overlay.place = OVERLAY_BOTTOM}`: there is none. */
typedef struct Caption {
    LessonText text;  /**< What it says; none: it is closed. The lesson's. */
    LessonText title; /**< What the lesson is called. */
    size_t number;    /**< Which caption of the lesson, from 1; 0: it is not of one. */
    size_t count;     /**< How many it has. */
    const char *hint; /**< What can be done now, in English; NULL: nothing is said of it. */
    Overlay overlay;  /**< It as a picture. */
} Caption;

/** Takes the caption away. */
void caption_close(Caption *caption);

/** Lays the caption over what the window shows, if there is one. @param[in,out] caption The
 *  caption, which keeps its picture. */
void caption_show(Caption *caption, const OverlayTarget *target);

#endif
