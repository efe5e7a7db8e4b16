/**
 * @file
 * @brief Words at the lower edge of the picture: what went wrong, readable from the last row.
 */
#ifndef DIOPTRE_VIEW_NOTICE_H
#define DIOPTRE_VIEW_NOTICE_H

#include "view/overlay.h"

/** Bytes of a notice with the final zero; a longer one is cut. */
enum { NOTICE_SIZE = 512 };

/** A notice. Starts as `{.overlay.place = OVERLAY_BELOW}`: there is none. */
typedef struct Notice {
    char words[NOTICE_SIZE]; /**< What it says, UTF-8; empty: it is closed. */
    Overlay overlay;         /**< It as a picture. */
} Notice;

/** Says something. @param[in,out] notice The notice. @param words UTF-8; empty: closes it.
 *  @return Whether anything changed. */
bool notice_say(Notice *notice, const char *words);

/** Lays the notice over what the window shows. @param[in,out] notice The notice, which keeps its
 *  picture. @param screen The window. */
void notice_show(Notice *notice, const OverlayScreen *screen);

#endif
