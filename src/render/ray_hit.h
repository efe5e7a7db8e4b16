/**
 * @file
 * @brief What a ray of a ray tree met, in words and angles.
 */
#ifndef DIOPTRE_RENDER_RAY_HIT_H
#define DIOPTRE_RENDER_RAY_HIT_H

#include "dioptre/renderer.h"

/** Longest name of what a ray hit, bytes with its final zero. */
enum { RAY_HIT_NAME_SIZE = 64 };

/**
 * @return The keyword of the shape that a ray hit.
 * @param ray  A ray that hit one.
 */
const char *ray_hit_keyword(const Scene *scene, const RayTreeNode *ray);

/** Names what a ray hit, in the user's language: a shape, a light or the sky. */
void ray_hit_name(const Scene *scene, const RayTreeNode *ray, char name[RAY_HIT_NAME_SIZE]);

/** @return Whether a ray meets a surface from inside glass. A floor has no inside, whichever way
 * its normal points. */
bool ray_is_in_glass(const RayTreeNode *ray);

/** @return The angle of incidence of a ray that hit a surface, degrees. */
double ray_incidence_angle(const RayTreeNode *ray);

/** @return Whether a shadow ray reaches its light through a transparent shape, which takes a part
 * of it. */
bool ray_is_through_glass(const RayTreeNode *ray);

#endif
