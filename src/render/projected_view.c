/**
 * @file
 * @brief Where a camera sees a point in its picture.
 */
#include "render/projected_view.h"

#include <math.h>

/** Depth of the near plane, relative to the distance of the target. */
static const double NEAR_PLANE = 1e-3;

Vec3d camera_space(const SceneCamera *camera, Vec3d point) {
    Vec3d from = vec3d_subtract(point, camera->position);
    return (Vec3d){vec3d_dot(from, scene_camera_right(camera)), vec3d_dot(from, camera->up),
                   vec3d_dot(from, camera->direction)};
}

double camera_near_depth(const SceneCamera *camera) {
    return NEAR_PLANE * camera->target_distance;
}

double projected_view_scale_at(const ProjectedView *view, double depth) {
    return view->width / (2 * tan(view->camera.fov / 2 * (M_PI / 180)) * depth);
}

double projected_view_scale(const ProjectedView *view, Vec3d point) {
    return projected_view_scale_at(view, camera_space(&view->camera, point).z);
}

void projected_view_place(const ProjectedView *view, Vec3d p, double *x, double *y) {
    const double scale = projected_view_scale_at(view, p.z);
    *x = view->width / 2.0 + p.x * scale;
    *y = view->height / 2.0 - p.y * scale;
}

bool projected_view_point(const ProjectedView *view, Vec3d point, double *x, double *y) {
    Vec3d p = camera_space(&view->camera, point);
    if (p.z <= camera_near_depth(&view->camera)) {
        return false;
    }
    projected_view_place(view, p, x, y);
    return true;
}
