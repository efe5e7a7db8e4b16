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
    const ProjectedView view = {scene->camera, picture->w, picture->h};
    Vec3d point = camera_space(&view.camera, center);
    // Also behind the camera: the arrow at the edge points to where it would come into sight.
    double scale = projected_view_scale_at(&view, fabs(point.z));
    double right = point.x * scale, down = -point.y * scale;
    bool is_ahead = point.z > camera_near_depth(&view.camera);
    bool is_inside = is_ahead && fabs(right) < picture->w / 2.0 && fabs(down) < picture->h / 2.0;
    if (scene->light_count > 1) {
        snprintf(name, sizeof name, gettext("lamp %d"), (int)light + 1);
    } else {
        snprintf(name, sizeof name, "%s", gettext("lamp"));
    }
    if (!is_inside) {
        show_outside(picture, isfinite(right) ? right : point.x, isfinite(down) ? down : -point.y,
                     name, is_selected);
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

bool light_marks_drag_offset(const Scene *scene, size_t light, const SDL_Rect *picture,
                             GuiPoint from, GuiPoint to, bool is_along, Vec3d *offset) {
    Vec3d center;
    return light < scene->light_count && scene_light_center(&scene->lights[light], &center) &&
           picture_drag_offset(&scene->camera, center, picture, &(PictureDrag){from, to, is_along},
                               offset);
}
