/**
 * @file
 * @brief A second camera, which views the rays of a pixel from the side.
 */
#ifndef DIOPTRE_RENDER_ORBIT_CAMERA_H
#define DIOPTRE_RENDER_ORBIT_CAMERA_H

#include "dioptre/renderer.h"
#include "render/cut_away.h"
#include "render/projected_view.h"

/** A camera on a sphere around a target. */
typedef struct OrbitCamera {
    Vec3d target;              /**< The target, scene units. */
    double radius;             /**< Of the bounding sphere of the rays, scene units. */
    double ray_length_maximum; /**< Rays are drawn up to this length, scene units. */
    double pan;                /**< Direction of view, degrees to the right of -z. */
    double tilt;               /**< Degrees above the horizon: below 0 it looks down. */
    double zoom;               /**< Magnification; 1: all rays fit in. */
} OrbitCamera;

/** A ray in the second camera's picture, in pixels from its left and upper edge. */
typedef struct ProjectedRay {
    double x[2];       /**< Where it starts and ends. */
    double y[2];       /**< See #x. */
    bool is_truncated; /**< Whether the ray continues beyond its end. */
} ProjectedRay;

/**
 * Chooses an orbit: to the side of the pixel's camera, where few points of the rays are occluded
 * and the rays lie clearly apart.
 * @param cut     Which shapes may be left out: they occlude nothing.
 * @param hidden_kinds  Kinds of rays that are not drawn, and need no room: bit i is #RayType i.
 * @param width   Of the second camera's picture, pixels; the rays and their lights fill it.
 * @param height  See width.
 * @return The orbit.
 */
OrbitCamera orbit_camera_fit(const Renderer *renderer, const Scene *scene, const CutAway *cut,
                             const RayTree *tree, unsigned hidden_kinds, int width, int height);

/**
 * Rotates a camera around its target.
 * @param pan  Degrees to the right.
 * @param tilt  Degrees up; limited before the pole.
 */
void orbit_camera_rotate(OrbitCamera *orbit, double pan, double tilt);

/** Multiplies the magnification by a factor. @param focus The point that keeps its place in the
 *  direction of view: what lies around it comes to the middle. */
void orbit_camera_zoom(OrbitCamera *orbit, double factor, Vec3d focus);

/** @return The middle of a ray, as far as it is drawn. */
Vec3d orbit_camera_ray_middle(const OrbitCamera *orbit, const RayTreeNode *ray);

/**
 * @return The camera on an orbit.
 * @param width   Of its picture, pixels.
 * @param height  See width.
 */
ProjectedView orbit_camera_project(const OrbitCamera *orbit, int width, int height);

/**
 * Projects a ray.
 * @param[out] projected  The line, clipped to the front of the camera.
 * @return Whether any of it is in front of the camera.
 */
bool orbit_camera_project_ray(const OrbitCamera *orbit, const ProjectedView *view,
                              const RayTreeNode *ray, ProjectedRay *projected);

/**
 * @return A view by parallel light that holds all rays: from so far away that nothing converges.
 * @param orbit    Says how long rays are drawn.
 * @param forward  Direction of the light, of length 1.
 * @param up       Up in the picture, of length 1, across \p forward.
 * @param width    Of the picture, pixels.
 * @param[out] nearest  Smallest distance of a point of the rays from the camera, along the light.
 */
ProjectedView parallel_view_fit(const OrbitCamera *orbit, const RayTree *tree, Vec3d forward,
                                Vec3d up, int width, int height, double *nearest);

#endif
