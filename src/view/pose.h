/**
 * @file
 * @brief Where the camera and the lights of a scene are, and moving them.
 */
#ifndef DIOPTRE_VIEW_POSE_H
#define DIOPTRE_VIEW_POSE_H

#include "dioptre/scene.h"
#include "view/motion.h"

/** The camera and the lights as they were at one time. */
typedef struct Pose {
    Camera camera; /**< The camera. */
    Light *lights; /**< The lights; owned. */
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
 * Puts the camera and the lights back.
 * @param pose            What was kept.
 * @param[in,out] scene   The same scene.
 */
void pose_restore(const Pose *pose, Scene *scene);

/** Gives a pose back. @param[in,out] pose The pose. */
void pose_release(Pose *pose);

/**
 * Moves a light and the camera along the axes of the picture.
 * @param[in,out] scene  The scene.
 * @param light          Place of the light; beyond the last one, none is moved.
 * @param light_by       How far the light goes, seconds at plain speed.
 * @param camera_by      How far the camera goes, seconds at plain speed.
 */
void pose_move(Scene *scene, size_t light, Movement light_by, Movement camera_by);

#endif
