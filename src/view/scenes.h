/**
 * @file
 * @brief Which scene is shown: of another time, of a file that was written again, or another one.
 */
#ifndef DIOPTRE_VIEW_SCENES_H
#define DIOPTRE_VIEW_SCENES_H

#include "view/state.h"

/** Begins to watch the scene's file. @param[in,out] view The view, with its event. */
void scenes_begin(View *view);

/** The scene's file was written: it is read again, and what was moved stays. @param[in,out] view
 *  The view. */
void scenes_refresh(View *view);

/** Shows another scene. @param[in,out] view The view. @param path Its file. */
void scenes_open(View *view, const char *path);

/** Reads the newest scene again, if it is wrong, to say once more what is wrong with it.
 *  @param[in,out] view The view. */
void scenes_repeat_error(View *view);

/**
 * Shows the scene that is wanted, as soon as it is there and the one before is on screen.
 * @param[in,out] view  The view.
 * @param now           Now, seconds.
 * @param[out] error    What is wrong with it: the scene before stays, and its time is held.
 * @return Whether all is well.
 */
bool scenes_update(View *view, double now, Error *error);

/** @return How long nothing is to be done, seconds, see #stage_delay. @param view The view. @param
 *  now Now, seconds. */
double scenes_delay(View *view, double now);

/** Gives all scenes but the first back; what the stage draws with must still be there.
 *  @param[in,out] view The view. */
void scenes_end(View *view);

#endif
