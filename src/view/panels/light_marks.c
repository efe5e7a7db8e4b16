/**
 * @file
 * @brief Where the lights are in the picture.
 */
#include "view/panels/light_marks.h"

#include <libintl.h>
#include <math.h>
#include <stdio.h>

/** Bytes of a light's name with the final zero. */
enum { NAME_SIZE = 48 };
/** Points that are nearer to the camera's plane than this fraction of the distance to the target
 *  have no place in the picture. */
static const double NEAR_FRACTION = 1e-6;
/** Distance of an arrow's tip from the edge of the picture, in heights of letters. */
static const float EDGE_GAP = 0.3F;
/** Radians per degree. */
#define RADIANS_PER_DEGREE (M_PI / 180)

/** A point as the camera sees it. */
typedef struct CameraPoint {
    double right; /**< To the right, scene units. */
    double up;    /**< Up, scene units. */
    double ahead; /**< Along the direction of view, scene units. */
} CameraPoint;

/** @return A point as the camera sees it. */
static CameraPoint to_camera(const SceneCamera *camera, Vec3d point) {
    Vec3d offset = vec3d_subtract(point, camera->position);
    return (CameraPoint){vec3d_dot(offset, scene_camera_right(camera)),
                         vec3d_dot(offset, camera->up), vec3d_dot(offset, camera->direction)};
}

/** @return Scene units per pixel at a distance ahead of the camera. */
static double units_per_pixel(const SceneCamera *camera, const SDL_Rect *picture, double ahead) {
    return 2 * ahead * tan(camera->fov / 2 * RADIANS_PER_DEGREE) / picture->w;
}

/** @return The middle of a rectangle. */
static GuiPoint middle_of(const SDL_Rect *rect) {
    return (GuiPoint){(float)rect->x + (float)rect->w / 2, (float)rect->y + (float)rect->h / 2};
}

/** Shows an arrow at the edge of the picture towards a light outside of it. @param right Where it
 *  is from the middle, of any length. */
static void show_outside(const SDL_Rect *picture, double right, double down, const char *name,
                         bool is_selected) {
    double length = hypot(right, down);
    GuiPoint middle = middle_of(picture);
    if (!(length > 0)) {
        right = 0;
        down = length = 1; // Straight behind the camera: any edge is as near.
    }
    GuiPoint direction = {(float)(right / length), (float)(down / length)};
    double gap = (double)(EDGE_GAP * gui_text_size());
    double reach = fmin((picture->w / 2.0 - gap) / fmax(fabs((double)direction.x), 1e-9),
                        (picture->h / 2.0 - gap) / fmax(fabs((double)direction.y), 1e-9));
    GuiPoint tip = {middle.x + (float)reach * direction.x, middle.y + (float)reach * direction.y};
    gui_mark_outside(tip, direction, name, is_selected);
}

/** Shows one light. */
static void show_light(LightMarks *marks, const Scene *scene, size_t light, const SDL_Rect *picture,
                       bool is_selected) {
    Vec3d center;
    char name[NAME_SIZE];
    if (!scene_light_center(&scene->lights[light], &center)) {
        return;
    }
    CameraPoint point = to_camera(&scene->camera, center);
    double scale = 1 / units_per_pixel(&scene->camera, picture, fabs(point.ahead));
    double right = point.right * scale, down = -point.up * scale;
    bool is_ahead = point.ahead > NEAR_FRACTION * scene->camera.target_distance;
    bool is_inside = is_ahead && fabs(right) < picture->w / 2.0 && fabs(down) < picture->h / 2.0;
    if (scene->light_count > 1) {
        snprintf(name, sizeof name, gettext("lamp %d"), (int)light + 1);
    } else {
        snprintf(name, sizeof name, "%s", gettext("lamp"));
    }
    if (!is_inside) {
        show_outside(picture, isfinite(right) ? right : point.right,
                     isfinite(down) ? down : -point.up, name, is_selected);
        return;
    }
    GuiPoint middle = middle_of(picture);
    GuiPoint place = {middle.x + (float)right, middle.y + (float)down};
    gui_mark_light(place, name, is_selected);
    marks->marks[marks->count++] = (LightMark){light, place};
}

void light_marks_show(LightMarks *marks, const Scene *scene, const SDL_Rect *picture,
                      size_t selected) {
    marks->count = 0;
    for (size_t i = 0; i < scene->light_count && i < LIGHT_MARKS_MAXIMUM; i++) {
        show_light(marks, scene, i, picture, i == selected);
    }
}

const LightMark *light_marks_at(const LightMarks *marks, GuiPoint point, float reach) {
    for (size_t i = 0; i < marks->count; i++) {
        const LightMark *mark = &marks->marks[i];
        if (hypotf(mark->point.x - point.x, mark->point.y - point.y) <= reach) {
            return mark;
        }
    }
    return NULL;
}

bool picture_point(const SceneCamera *camera, const SDL_Rect *picture, Vec3d point,
                   GuiPoint *place) {
    CameraPoint seen = to_camera(camera, point);
    double scale = 1 / units_per_pixel(camera, picture, seen.ahead);
    place->x = (float)(picture->x + picture->w / 2.0 + seen.right * scale);
    place->y = (float)(picture->y + picture->h / 2.0 - seen.up * scale);
    return seen.ahead > NEAR_FRACTION * camera->target_distance;
}

bool picture_drag_offset(const SceneCamera *camera, Vec3d point, const SDL_Rect *picture,
                         const PictureDrag *drag, Vec3d *offset) {
    double ahead = to_camera(camera, point).ahead;
    double scale = units_per_pixel(camera, picture, ahead);
    if (!(ahead > NEAR_FRACTION * camera->target_distance)) {
        return false;
    }
    Vec3d right =
        vec3d_scale(scene_camera_right(camera), (double)(drag->to.x - drag->from.x) * scale);
    double up = (double)(drag->from.y - drag->to.y) * scale;
    *offset = drag->is_along ? vec3d_scale(camera->direction, up)
                             : vec3d_add(right, vec3d_scale(camera->up, up));
    return true;
}

bool light_marks_drag_offset(const Scene *scene, size_t light, const SDL_Rect *picture,
                             GuiPoint from, GuiPoint to, bool is_along, Vec3d *offset) {
    Vec3d center;
    return light < scene->light_count && scene_light_center(&scene->lights[light], &center) &&
           picture_drag_offset(&scene->camera, center, picture, &(PictureDrag){from, to, is_along},
                               offset);
}
