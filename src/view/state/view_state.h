/**
 * @file
 * @brief Where the camera and the lights of a scene are, and moving them.
 */
#ifndef DIOPTRE_VIEW_STATE_VIEW_STATE_H
#define DIOPTRE_VIEW_STATE_VIEW_STATE_H

#include "dioptre/scene.h"
#include "view/state/held_keys.h"

/** The scene's own camera and lights, and which of them the user has moved. */
typedef struct ViewState {
    SceneCamera camera;   /**< The camera. */
    bool is_camera_moved; /**< Whether the user has moved it. */
    SceneLight *lights;   /**< The lights; owned. */
    bool *is_light_moved; /**< Which of them the user has moved; owned. */
    size_t light_count;   /**< How many lights. */
    Vec3d up_axis; /**< Which way is up in the scene, a unit vector: what the camera turns about. */
} ViewState;

/**
 * Keeps the camera and the lights of a scene.
 * @param[out] view_state  Where to; give it back with #view_state_deinit.
 * @return false without memory.
 */
bool view_state_init(ViewState *view_state, const Scene *scene, Error *error);

/**
 * Keeps the camera and the lights of the same scene at another time, and puts what the user has
 * moved where the user has put it: that stays there, whatever the scene file says, until
 * #view_state_reset.
 * @param[in,out] view_state  What was kept of the scene as it was.
 * @param previous  The scene as it was.
 * @param[in,out] scene  The scene at another time.
 * @return false without memory; nothing is changed then.
 */
bool view_state_transfer(ViewState *view_state, const Scene *previous, Scene *scene, Error *error);

/** Puts the camera and the lights back, all of them. */
void view_state_reset(ViewState *view_state, Scene *scene);

/**
 * Keeps camera and lights as they are now, and which of them the user has moved.
 * @param[out] saved  Where to; give it back with #view_state_deinit.
 * @param view_state  What was kept of the scene's own.
 * @return false without memory.
 */
bool view_state_save_current(ViewState *saved, const ViewState *view_state, const Scene *scene,
                             Error *error);

/** Puts camera and lights back where they were at #view_state_save_current. @param[in,out]
 *  view_state What was kept of the scene's own; it is noted there what is moved. */
void view_state_restore_current(const ViewState *saved, ViewState *view_state, Scene *scene);

/** Gives a pose back. */
void view_state_deinit(ViewState *view_state);

/**
 * Moves a light and the camera along the axes of the picture.
 * @param[in,out] view_state  What was kept of the scene; it is noted there what moves.
 * @param light  Place of the light; beyond the last one, none is moved.
 * @param light_movement  How far the light goes, seconds at plain speed.
 * @param camera_movement  How far the camera goes, seconds at plain speed.
 */
void view_state_move(ViewState *view_state, Scene *scene, size_t light, Movement light_movement,
                     Movement camera_movement);

#endif
