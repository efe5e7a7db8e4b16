/**
 * @file
 * @brief The scene on screen: of another time, of a file that was written again, or another scene.
 */
#ifndef DIOPTRE_VIEW_COMMANDS_CURRENT_SCENE_H
#define DIOPTRE_VIEW_COMMANDS_CURRENT_SCENE_H

#include "view/app.h"

/** Starts to watch the scene's file. */
void current_scene_begin(App *app);

/** Reloads the scene's file after it was written; moved objects keep their positions. */
void current_scene_reload(App *app);

/** Reloads the scene after a file of its folder was written; if it was the scene's own, changes of
 *  its objects are taken back. */
void current_scene_on_file_event(App *app);

/** @return Whether the scene's file has another text than the scene on screen was read from. */
bool current_scene_is_outdated(const App *app);

/** Notes that this program has written the scene's file, and reloads it. */
void current_scene_file_written(App *app);

/** Loads another scene, or a lesson with its scene. */
void current_scene_open(App *app, const char *path);

/** Says so if a lesson needs the scene on screen. @return Whether one does. */
bool current_scene_is_locked(App *app);

/** Opens the list of scenes, unless a lesson needs the scene on screen. */
void current_scene_browse(App *app);

/** Loads the newest scene again if it is faulty, to report its error again. */
void current_scene_repeat_error(App *app);

/**
 * Requests the scene that is wanted, and shows it once it is loaded and the previous picture is on
 * screen.
 * @param[out] error  The error of the loaded scene: the previous scene stays, its time paused.
 * @return Whether there was no error.
 */
bool current_scene_update(App *app, double now, Error *error);

/** @return Seconds until the next update; see #window_timeout. */
double current_scene_timeout(App *app, double now);

/** Frees all scenes but the first; the window's renderers must still exist. */
void current_scene_end(App *app);

#endif
