/**
 * @file
 * @brief Words at the lower edge of the picture: what went wrong, readable from the last row.
 */
#ifndef DIOPTRE_VIEW_PANELS_NOTICE_H
#define DIOPTRE_VIEW_PANELS_NOTICE_H

#include "view/panels/overlay.h"

/** Bytes of a notice with the final zero; a longer one is cut. */
enum { NOTICE_SIZE = 512 };

/** A notice. Starts as `{.overlay.place = OVERLAY_BOTTOM}`: there is none. */
typedef struct Notice {
    char text[NOTICE_SIZE]; /**< What it says, UTF-8; empty: it is closed. */
    Overlay overlay;        /**< It as a picture. */
} Notice;

/**
 * Says something.
 * @param text  UTF-8; empty: closes it.
 * @return Whether anything changed.
 */
bool notice_set(Notice *notice, const char *text);

/** Lays the notice over what the window shows. @param[in,out] notice The notice, which keeps its
 *  picture. */
void notice_show(Notice *notice, const OverlayTarget *target);

#endif
