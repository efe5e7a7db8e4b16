/**
 * @file
 * @brief A second camera, which looks at the rays of a pixel from beside.
 */
#ifndef DIOPTRE_RENDER_ORBIT_CAMERA_H
#define DIOPTRE_RENDER_ORBIT_CAMERA_H

#include "dioptre/renderer.h"

/** How a tree of rays is looked at: from around its middle. */
typedef struct OrbitCamera {
    Vec3d target;              /**< What it looks at, scene units. */
    double radius;             /**< Of the ball around the rays, scene units. */
    double ray_length_maximum; /**< How much of a ray is shown at most, scene units. */
    double pan;                /**< Which way it looks, degrees to the right of -z. */
    double tilt;               /**< Degrees above the horizon: below 0 it looks down. */
    double zoom;               /**< How many times as near as needed to see all; 1 at first. */
} OrbitCamera;

/** The second camera, and the picture that it makes. */
typedef struct ProjectedView {
    SceneCamera camera; /**< The camera. */
    int width;          /**< Pixels. */
    int height;         /**< Pixels. */
} ProjectedView;

/** A ray in that picture, in pixels from its left and upper edge. */
typedef struct ProjectedRay {
    double x[2];       /**< Where it starts and ends. */
    double y[2];       /**< See #x. */
    bool is_truncated; /**< Whether it goes on beyond its end. */
} ProjectedRay;

/**
 * Chooses how a tree of rays is looked at: turned away from the camera that it belongs to, and so
 * that as few as can be of its points are behind something.
 * @param width  Pixels of the second camera's picture, which the rays shall fill.
 * @return The view.
 */
OrbitCamera orbit_camera_fit(const Renderer *renderer, const SceneCamera *camera,
                             const RayTree *tree, int width, int height);

/**
 * Turns a view around its middle.
 * @param pan  Degrees to the right.
 * @param tilt  Degrees up; stops before the pole.
 */
void orbit_camera_rotate(OrbitCamera *orbit, double pan, double tilt);

/** Comes nearer or goes away. @param factor How many times as near. */
void orbit_camera_zoom(OrbitCamera *orbit, double factor);

/**
 * @return The camera of a view.
 * @param width  Pixels of its picture.
 */
ProjectedView orbit_camera_project(const OrbitCamera *orbit, int width, int height);

/**
 * Finds where a point is seen.
 * @param[out] x  Pixels from the left edge.
 * @param[out] y  Pixels from the upper edge.
 * @return Whether it is before the camera.
 */
bool projected_view_point(const ProjectedView *view, Vec3d point, double *x, double *y);

/**
 * Finds where a ray is seen.
 * @param[out] projected  Its line; what is behind the camera is cut off.
 * @return Whether any of it is before the camera.
 */
bool orbit_camera_project_ray(const OrbitCamera *orbit, const ProjectedView *view,
                              const RayTreeNode *ray, ProjectedRay *projected);

/** Longest name of what a ray met, bytes with its final zero. */
enum { RAY_HIT_NAME_SIZE = 64 };

/**
 * @return The keyword of the shape that a ray met.
 * @param ray  The ray, which met one.
 */
const char *ray_hit_keyword(const Scene *scene, const RayTreeNode *ray);

/** Names what a ray met, in the user's language: a shape, a lamp or the sky. */
void ray_hit_name(const Scene *scene, const RayTreeNode *ray, char name[RAY_HIT_NAME_SIZE]);

/** @return The angle between a ray and the normal of the surface that it met, degrees. */
double ray_incidence_angle(const RayTreeNode *ray);

#endif
