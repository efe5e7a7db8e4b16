/**
 * @file
 * @brief Rows of things with their colours, and the camera's values.
 */
#include "view/panels/thing_list.h"

#include "base/encoding.h"
#include "base/language.h"
#include "base/typeset_numbers.h"
#include "view/panels/thing_title.h"

#include <libintl.h>
#include <math.h>
#include <stdio.h>

/** Bytes of a line with the final zero. */
enum { LINE_SIZE = 128 };
/** Linear light of the camera's colour. */
static const Rgbd CAMERA_COLOR = {0.3, 0.3, 0.35};

size_t thing_list_count(const Scene *scene) {
    return 1 + scene->light_count + scene->shape_count;
}

SceneObject thing_list_object(const Scene *scene, size_t index) {
    const size_t first_shape = 1 + scene->light_count;
    return index < first_shape ? scene_object_of_light(scene, index - 1)
                               : scene_object_of_shape(scene, index - first_shape);
}

/** @return The colour of a thing, linear: that of its material, or of its light. */
static Rgbd color_of(const Scene *scene, size_t index) {
    const size_t first_shape = 1 + scene->light_count;
    if (index == THING_CAMERA) {
        return CAMERA_COLOR;
    }
    return index < first_shape
               ? scene->lights[index - 1].color
               : scene->materials[scene->shapes[index - first_shape].material_index].color;
}

/** Encodes a colour for the screen. */
static void encode(Rgbd color, unsigned char rgb[3]) {
    const double channels[] = {color.red, color.green, color.blue};
    for (int i = 0; i < 3; i++) {
        rgb[i] =
            (unsigned char)lround(encoding_encode(ENCODING_SRGB, fmin(fmax(channels[i], 0), 1)));
    }
}

/** @return Whether a thing is the one that is selected, or was last. */
static bool is_last_chosen(const ObjectInspector *inspector, size_t index) {
    return inspector->has_chosen && inspector->chosen == index;
}

/** Shows a row. @return Whether it was chosen. */
static bool show_row(const ObjectInspector *inspector, const Scene *scene, size_t index) {
    char title[THING_TITLE_SIZE];
    unsigned char rgb[3];
    if (index == THING_CAMERA) {
        SDL_strlcpy(title, gettext("camera"), sizeof title);
    } else {
        const SceneObject object = thing_list_object(scene, index);
        thing_row_title(&object, title);
    }
    encode(color_of(scene, index), rgb);
    return gui_list_row((int)index, title, 0, rgb, is_last_chosen(inspector, index), false);
}

void thing_list_show(ObjectInspector *inspector, const Scene *scene) {
    int first = 0, end = 0;
    const bool is_new = !inspector->was_shown && inspector->has_chosen;
    gui_rows_begin((int)thing_list_count(scene), is_new ? (int)inspector->chosen : -1);
    while (gui_rows_next(&first, &end)) {
        for (int i = first; i < end; i++) {
            if (show_row(inspector, scene, (size_t)i)) {
                inspector->request = INSPECTOR_CHOOSE;
                inspector->chosen = (size_t)i;
                inspector->has_chosen = true;
                inspector->is_by_mouse = gui_is_mouse_released();
            }
        }
    }
}

/** Writes a vector as readers do. */
static void write_vector(Vec3d vector, char line[LINE_SIZE]) {
    snprintf(line, LINE_SIZE, "(%.3g, %.3g, %.3g)", vector.x, vector.y, vector.z);
    typeset_numbers(line, LINE_SIZE);
}

void thing_list_show_camera(const Scene *scene) {
    const SceneCamera *camera = &scene->camera;
    char line[LINE_SIZE];
    write_vector(camera->position, line);
    gui_list_text(gettext("where it is"), line);
    write_vector(camera->direction, line);
    gui_list_text(gettext("where it looks"), line);
    snprintf(line, sizeof line, "%.3g°", camera->fov);
    typeset_numbers(line, sizeof line);
    gui_list_text(gettext("field of view"), line);
    gui_paragraph(gettext("Arrows, Page Up and Page Down move it; a drag turns it; the wheel "
                          "changes its field of view."),
                  GUI_COLOR_TEXT, 1);
}
