/**
 * @file
 * @brief The home view of a scene, and moving its camera and lights.
 */
#ifndef DIOPTRE_VIEW_STATE_VIEW_STATE_H
#define DIOPTRE_VIEW_STATE_VIEW_STATE_H

#include "dioptre/scene.h"
#include "view/state/held_keys.h"

/** Camera and lights as the scene file has them, and which of them the user has moved. */
typedef struct ViewState {
    SceneCamera camera;   /**< The camera. */
    bool is_camera_moved; /**< Whether the user has moved it. */
    SceneLight *lights;   /**< The lights; owned. */
    bool *is_light_moved; /**< Which of them the user has moved; owned. */
    size_t light_count;   /**< Number of lights. */
    Vec3d up_axis;        /**< Axis that the camera turns about, a unit vector. */
    double move_speed;    /**< Scene units per second of a held key; 0: half the distance to
                               the camera's target, as lessons without a speed have it. */
} ViewState;

/**
 * Finds how fast held keys move camera and lights, so that half a second of a key leaves a lamp in
 * its room: a quarter of the scene's size per second. Its size is the longest edge of the box of
 * all bounded shapes and all lights; endless planes do not count. It is at most half the distance
 * to what the camera looks at: a wide floor may make the box too large.
 * @return Scene units per second; above 0.
 */
double view_state_move_speed(const Scene *scene);

/** Saves camera and lights of a scene. @param[out] view_state To be freed with #view_state_deinit.
 * @return false without memory. */
bool view_state_init(ViewState *view_state, const Scene *scene, Error *error);

/**
 * Saves camera and lights of the same scene at another time, and moves there what the user had
 * moved. Such objects stay there until #view_state_reset, whatever the scene file contains.
 * @param[in,out] view_state  The home view of the previous scene, then of this one.
 * @param previous  The previous scene.
 * @param[in,out] scene  The scene of another time.
 * @return false without memory; nothing is changed then.
 */
bool view_state_transfer(ViewState *view_state, const Scene *previous, Scene *scene, Error *error);

/** Puts camera and all lights back home. */
void view_state_reset(ViewState *view_state, Scene *scene);

/** Saves camera and lights where they are now. @param[out] saved To be freed with
 * #view_state_deinit. @param view_state The home view. @return false without memory. */
bool view_state_save_current(ViewState *saved, const ViewState *view_state, const Scene *scene,
                             Error *error);

/** Puts camera and lights back where #view_state_save_current saved them. @param[in,out] view_state
 * The home view; which of them are moved is restored. */
void view_state_restore_current(const ViewState *saved, ViewState *view_state, Scene *scene);

/** Frees a view. */
void view_state_deinit(ViewState *view_state);

/** How the camera moves. */
typedef enum {
    MOTION_FLY, /**< Along the axes of the picture: forward is where it looks. */
    MOTION_WALK /**< Along the ground: forward stays at one height, up is straight up. */
} CameraMotion;

/**
 * Moves a light along the axes of the picture, and the camera.
 * @param[in,out] view_state  The home view; what moves is noted.
 * @param light  Index of the light; beyond the last one: none.
 * @param light_movement  Movement of the light.
 * @param camera_movement  Movement of the camera.
 * @param motion  How the camera moves.
 */
void view_state_move(ViewState *view_state, Scene *scene, size_t light, Movement light_movement,
                     Movement camera_movement, CameraMotion motion);

#endif
