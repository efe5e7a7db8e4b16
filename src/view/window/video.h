/**
 * @file
 * @brief SDL's video, set up for a window among others.
 */
#ifndef DIOPTRE_VIEW_WINDOW_VIDEO_H
#define DIOPTRE_VIEW_WINDOW_VIDEO_H

#include "dioptre/error.h"

/**
 * Starts SDL's video. `SDL_Quit` ends it, whether it started or not.
 * @param[out] error  What is wrong: no display.
 * @return Whether a window can be opened.
 */
bool video_start(Error *error);

#endif
