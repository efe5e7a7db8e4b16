/**
 * @file
 * @brief Which scene is shown: of another time, of a file that was written again, or another one.
 */
#ifndef DIOPTRE_VIEW_LOADING_CURRENT_SCENE_H
#define DIOPTRE_VIEW_LOADING_CURRENT_SCENE_H

#include "view/app.h"

/** Begins to watch the scene's file. @param[in,out] app The view, with its event. */
void current_scene_begin(App *app);

/** The scene's file was written: it is read again, and what was moved stays. */
void current_scene_reload(App *app);

/** Shows another scene. */
void current_scene_open(App *app, const char *path);

/** Reads the newest scene again, if it is wrong, to say once more what is wrong with it. */
void current_scene_repeat_error(App *app);

/**
 * Shows the scene that is wanted, as soon as it is there and the one before is on screen.
 * @param[out] error  What is wrong with it: the scene before stays, and its time is held.
 * @return Whether all is well.
 */
bool current_scene_update(App *app, double now, Error *error);

/** @return How long nothing is to be done, seconds, see #window_timeout. */
double current_scene_timeout(App *app, double now);

/** Gives all scenes but the first back; what the stage draws with must still be there. */
void current_scene_end(App *app);

#endif
