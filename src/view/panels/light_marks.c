/**
 * @file
 * @brief Where the lights are in the picture.
 */
#include "view/panels/light_marks.h"

#include "render/projected_view.h"
#include "view/panels/picture_projection.h"

#include <libintl.h>
#include <math.h>
#include <stdio.h>

/** Bytes of a light's name with the final zero. */
enum { NAME_SIZE = 48 };
/** Distance of an arrow's tip from the edge of the picture, in heights of letters. */
static const float EDGE_GAP = 0.3F;
/** @return The middle of a rectangle. */
static GuiPoint middle_of(const SDL_Rect *rect) {
    return (GuiPoint){(float)rect->x + (float)rect->w / 2, (float)rect->y + (float)rect->h / 2};
}

/** Shows an arrow at the edge of the picture towards a light outside of it. @param right Where it
 *  is from the middle, of any length. @return The middle of the arrow. */
static GuiPoint show_outside(const SDL_Rect *picture, double right, double down, const char *name,
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
    return gui_mark_outside(tip, direction, name, is_selected);
}

/** A light as the camera sees it. */
typedef struct SeenLight {
    Vec3d point;    /**< Where it is, in the camera's space. */
    double right;   /**< Right of the middle of the picture, pixels. Of a light behind the camera:
                         where it would come into sight. */
    double down;    /**< The same, below the middle. */
    bool is_inside; /**< Whether it is in the picture. */
} SeenLight;

/** Finds where a camera sees a light. @param center Of the light. */
static SeenLight see_light(const SceneCamera *camera, const SDL_Rect *picture, Vec3d center) {
    const ProjectedView view = {*camera, picture->w, picture->h};
    SeenLight seen = {.point = camera_space(camera, center)};
    double scale = projected_view_scale_at(&view, fabs(seen.point.z));
    seen.right = seen.point.x * scale;
    seen.down = -seen.point.y * scale;
    seen.is_inside = seen.point.z > camera_near_depth(camera) &&
                     fabs(seen.right) < picture->w / 2.0 && fabs(seen.down) < picture->h / 2.0;
    return seen;
}

/** Shows one light. */
static void show_light(LightMarks *marks, const Scene *scene, size_t light, const SDL_Rect *picture,
                       bool is_selected) {
    Vec3d center;
    char name[NAME_SIZE];
    if (!scene_light_center(&scene->lights[light], &center)) {
        return;
    }
    const SeenLight seen = see_light(&scene->camera, picture, center);
    if (scene->light_count > 1) {
        snprintf(name, sizeof name, gettext("lamp %d"), (int)light + 1);
    } else {
        snprintf(name, sizeof name, "%s", gettext("lamp"));
    }
    GuiPoint middle = middle_of(picture);
    GuiPoint place = {middle.x + (float)seen.right, middle.y + (float)seen.down};
    if (seen.is_inside) {
        gui_mark_light(place, name, is_selected);
    } else {
        place = show_outside(picture, isfinite(seen.right) ? seen.right : seen.point.x,
                             isfinite(seen.down) ? seen.down : -seen.point.y, name, is_selected);
    }
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

bool light_marks_drag_offset(const Scene *scene, size_t light, const SDL_Rect *picture,
                             GuiPoint from, GuiPoint to, bool is_along, Vec3d *offset) {
    const SceneCamera *camera = &scene->camera;
    Vec3d center;
    if (light >= scene->light_count || !scene_light_center(&scene->lights[light], &center)) {
        return false;
    }
    const SeenLight seen = see_light(camera, picture, center);
    // Beside the camera the depth is hardly anything: a light there would not move.
    const double depth =
        seen.is_inside ? seen.point.z : fmax(vec3d_length(seen.point), camera_near_depth(camera));
    *offset = picture_drag_offset(camera, depth, picture, &(PictureDrag){from, to, is_along});
    return true;
}
