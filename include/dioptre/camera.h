/**
 * @file
 * @brief The camera: from where, and which way, the picture is taken.
 */
#ifndef DIOPTRE_CAMERA_H
#define DIOPTRE_CAMERA_H

#include "dioptre/parameter.h"

/** A pinhole camera. Filled from a scene file through #scene_camera_keyword. */
typedef struct SceneCamera {
    Vec3d position;  /**< Where the eye is. */
    Vec3d look_at;   /**< A point in the middle of the picture, when `look_at` was given. */
    Vec3d direction; /**< Which way it looks; after #Keyword.finish a unit vector. */
    Vec3d up;        /**< Which way is up; after #Keyword.finish a unit vector at right angles. */
    double pan;      /**< Degrees to the right of -z, when `pan` was given. */
    double tilt;     /**< Degrees above the horizon, when `tilt` was given. */
    double fov;      /**< Horizontal field of view, degrees; the height follows from it. */
    double target_distance; /**< Distance of what it looks at, scene units: the step of the keys. */
} SceneCamera;

/** The scene language's `camera`. */
extern const Keyword scene_camera_keyword;

/**
 * @return The unit vector to the right in the picture.
 * @param camera  A finished camera.
 */
Vec3d scene_camera_right(const SceneCamera *camera);

/**
 * Moves the camera without turning it.
 * @param[in,out] camera  A finished camera.
 * @param right    Scene units to the right.
 * @param up       Scene units up in the picture.
 * @param forward  Scene units ahead.
 */
void scene_camera_move(SceneCamera *camera, double right, double up, double forward);

/**
 * Turns the camera on the spot, as a head turns: about the vertical, then up or down, never over
 * the pole.
 * @param[in,out] camera  A finished camera.
 * @param vertical  The scene's own up, a unit vector.
 * @param pan       Degrees to the right.
 * @param tilt      Degrees up; stops 1 degree before the pole.
 */
void scene_camera_rotate(SceneCamera *camera, Vec3d vertical, double pan, double tilt);

/**
 * Opens or closes the field of view.
 * @param[in,out] camera  A camera.
 * @param factor          The tangent of half the field is multiplied by this; kept in range.
 */
void scene_camera_zoom(SceneCamera *camera, double factor);

#endif
