/**
 * @file
 * @brief Selecting objects of the scene, and changing them: in the window and in lessons.
 *
 * A change is an override of the scene file (dioptre/scene_override.h). The scene is loaded again
 * in the background with all overrides, and the last picture stays meanwhile.
 */
#ifndef DIOPTRE_VIEW_COMMANDS_EDITS_H
#define DIOPTRE_VIEW_COMMANDS_EDITS_H

#include "view/app.h"

/* --- for the user: recorded ------------------------------------------------------------------- */

/** Selects what a pixel shows; where it shows nothing, nothing is selected. @param x Fraction of
 *  the picture's width. @param y Fraction of its height, from the top. */
void edits_click(App *app, double x, double y);

/** Selects a light whose mark was clicked. @param light Its index. */
void edits_click_light(App *app, size_t light);

/** Selects the next shape or light that can be changed; at first, what is in the middle of the
 *  picture. @param step 1: the next; -1: the one
 *  before. */
void edits_select_next(App *app, int step);

/** Finds the point that a pixel shows. @param x Fraction of the picture's width. @param y Fraction
 *  of its height. @param[out] point It, scene units. @return false if it shows nothing. */
bool edits_point_at(App *app, double x, double y, Vec3d *point);

/** Takes hold of the selected shape. @param x Fraction of the picture's width. @param y Fraction of
 *  its height. @param[out] point Where it is held, scene units. @return Whether it is there. */
bool edits_grab(App *app, double x, double y, Vec3d *point);

/** Drags the selected shape. @param offset How far, scene units. @param continues Whether the drag
 *  goes on. */
void edits_drag(App *app, Vec3d offset, bool continues);

/** Carries out what the inspector requests. */
void edits_handle_requests(App *app);

/** Selects nothing, which closes the inspector, or leads back to its list; closes the list, if
 *  nothing was selected. @return false if neither was there. */
bool edits_close(App *app);

/** Selects nothing, and shows the list of all things. */
void edits_list(App *app);

/** Copies the selected object as text of the scene language. */
void edits_copy(App *app);

/** Writes the changes of the selected object and of its material into the scene file. */
void edits_write(App *app);

/** Saves a copy of the scene file with the changes of all objects, numbered, in the folder of
 *  snapshots. */
void edits_save_copy(App *app);

/* --- for commands and lessons ----------------------------------------------------------------- */

/** Selects an object. @param number See #SceneOverride.number; 0: none. @param pixel Where it was
 *  clicked, fractions of the picture's width and height; NULL: not in the picture. */
void edits_select(App *app, int keyword, int number, const Uvd *pixel);

/** Checks edits of one object together with those in force. @return Whether the file could have
 *  given these values. */
bool edits_check(const App *app, const SceneObject *object, const SceneOverride *edits,
                 size_t count, Error *error);

/** Gives a field a value. @param continues Whether it belongs to the change before it. */
void edits_set(App *app, const SceneOverride *override, bool continues);

/** Moves a shape or a light. @param offset How far, scene units. @param continues Whether it
 *  belongs to the change before it. */
void edits_move(App *app, int keyword, int number, Vec3d offset, bool continues);

/** Takes the last change back: of an object, of camera and lights, of settings and layer. */
void edits_undo(App *app);

/** Does the change again that was taken back last. */
void edits_redo(App *app);

#endif
