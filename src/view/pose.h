/**
 * @file
 * @brief Where the camera and the lights of a scene are, and moving them.
 */
#ifndef DIOPTRE_VIEW_POSE_H
#define DIOPTRE_VIEW_POSE_H

#include "dioptre/scene.h"
#include "view/motion.h"

/** The scene's own camera and lights, and which of them the user has moved. */
typedef struct Pose {
    Camera camera;        /**< The camera. */
    bool is_camera_moved; /**< Whether the user has moved it. */
    Light *lights;        /**< The lights; owned. */
    bool *is_light_moved; /**< Which of them the user has moved; owned. */
    size_t light_count;   /**< How many lights. */
    Vector3
        vertical; /**< Which way is up in the scene, a unit vector: what the camera turns about. */
} Pose;

/**
 * Keeps the camera and the lights of a scene.
 * @param[out] pose   Where to; give it back with #pose_release.
 * @param scene       The scene.
 * @param[out] error  What is wrong.
 * @return false without memory.
 */
bool pose_save(Pose *pose, const Scene *scene, Error *error);

/**
 * Keeps the camera and the lights of the same scene at another time, and puts what the user has
 * moved where the user has put it: that stays there, whatever the scene file says, until
 * #pose_restore.
 * @param[in,out] pose  What was kept of the scene as it was.
 * @param before        The scene as it was.
 * @param[in,out] scene The scene at another time.
 * @param[out] error    What is wrong.
 * @return false without memory; nothing is changed then.
 */
bool pose_renew(Pose *pose, const Scene *before, Scene *scene, Error *error);

/**
 * Puts the camera and the lights back, all of them.
 * @param[in,out] pose    What was kept.
 * @param[in,out] scene   The same scene.
 */
void pose_restore(Pose *pose, Scene *scene);

/**
 * Keeps camera and lights as they are now, and which of them the user has moved.
 * @param[out] copy   Where to; give it back with #pose_release.
 * @param pose        What was kept of the scene's own.
 * @param scene       The scene.
 * @param[out] error  What is wrong.
 * @return false without memory.
 */
bool pose_copy(Pose *copy, const Pose *pose, const Scene *scene, Error *error);

/**
 * Puts camera and lights back where they were at #pose_copy.
 * @param copy            What was kept then.
 * @param[in,out] pose    What was kept of the scene's own; it is noted there what is moved.
 * @param[in,out] scene   The scene.
 */
void pose_put_back(const Pose *copy, Pose *pose, Scene *scene);

/** Gives a pose back. @param[in,out] pose The pose. */
void pose_release(Pose *pose);

/**
 * Moves a light and the camera along the axes of the picture.
 * @param[in,out] pose   What was kept of the scene; it is noted there what moves.
 * @param[in,out] scene  The scene.
 * @param light          Place of the light; beyond the last one, none is moved.
 * @param light_by       How far the light goes, seconds at plain speed.
 * @param camera_by      How far the camera goes, seconds at plain speed.
 */
void pose_move(Pose *pose, Scene *scene, size_t light, Movement light_by, Movement camera_by);

#endif
