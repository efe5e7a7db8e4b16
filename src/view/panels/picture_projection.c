/**
 * @file
 * @brief From the scene to the picture on the screen and back.
 */
#include "view/panels/picture_projection.h"

#include "render/projected_view.h"

bool picture_point(const SceneCamera *camera, const SDL_Rect *picture, Vec3d point,
                   GuiPoint *place) {
    const ProjectedView view = {*camera, picture->w, picture->h};
    double right = 0, down = 0;
    bool is_ahead = projected_view_point(&view, point, &right, &down);
    *place = (GuiPoint){(float)(picture->x + right), (float)(picture->y + down)};
    return is_ahead;
}

Vec3d picture_drag_offset(const SceneCamera *camera, double depth, const SDL_Rect *picture,
                          const PictureDrag *drag) {
    const ProjectedView view = {*camera, picture->w, picture->h};
    double scale = 1 / projected_view_scale_at(&view, depth);
    Vec3d right =
        vec3d_scale(scene_camera_right(camera), (double)(drag->to.x - drag->from.x) * scale);
    double up = (double)(drag->from.y - drag->to.y) * scale;
    return drag->is_along ? vec3d_scale(camera->direction, up)
                          : vec3d_add(right, vec3d_scale(camera->up, up));
}

bool picture_drag_offset_at(const SceneCamera *camera, Vec3d point, const SDL_Rect *picture,
                            const PictureDrag *drag, Vec3d *offset) {
    const double depth = camera_space(camera, point).z;
    const bool is_ahead = depth > camera_near_depth(camera);
    if (is_ahead) {
        *offset = picture_drag_offset(camera, depth, picture, drag);
    }
    return is_ahead;
}
