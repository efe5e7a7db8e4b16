/**
 * @file
 * @brief Where a camera sees a point in its picture.
 */
#ifndef DIOPTRE_RENDER_PROJECTED_VIEW_H
#define DIOPTRE_RENDER_PROJECTED_VIEW_H

#include "dioptre/scene.h"

/** A camera and the size of its picture. */
typedef struct ProjectedView {
    SceneCamera camera; /**< The camera. */
    int width;          /**< Of the picture: pixels, or units of a window. */
    int height;         /**< The same. */
} ProjectedView;

/** @return A point as a camera sees it, scene units: to the right, up, and ahead of it. */
Vec3d camera_space(const SceneCamera *camera, Vec3d point);

/** @return The least depth, scene units, at which a point counts as in front of a camera. */
double camera_near_depth(const SceneCamera *camera);

/** @return Pixels of a scene unit at a depth ahead of the camera, across the view. */
double projected_view_scale_at(const ProjectedView *view, double depth);

/** @return The same at a point in front of the camera. */
double projected_view_scale(const ProjectedView *view, Vec3d point);

/**
 * Projects a point.
 * @param p       The point, see #camera_space; it is ahead of the camera.
 * @param[out] x  Pixels from the left edge.
 * @param[out] y  Pixels from the upper edge.
 */
void projected_view_place(const ProjectedView *view, Vec3d p, double *x, double *y);

/**
 * Projects a point of the scene.
 * @param[out] x  Pixels from the left edge; perhaps outside the picture.
 * @param[out] y  Pixels from the upper edge.
 * @return Whether it is in front of the camera.
 */
bool projected_view_point(const ProjectedView *view, Vec3d point, double *x, double *y);

#endif
