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
/** Fewest things of one line of the scene file that are folded into one row. */
enum { FOLDED_MINIMUM = 10 };
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

/** Shows the row of a thing. @return Whether it was chosen. */
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
    return gui_list_row((int)index, title,
                        index >= inspector->open_first && index < inspector->open_end, rgb,
                        is_last_chosen(inspector, index), false);
}

/* --- things of one line ------------------------------------------------------------------------
 */

/** Things beside each other that one line of the scene file has made. */
typedef struct ThingRun {
    size_t first; /**< Index of the first. */
    size_t end;   /**< Behind the last. */
} ThingRun;

/** @return The things of the line that made one. @param first The first of them. */
static ThingRun run_at(const Scene *scene, size_t first) {
    const size_t count = thing_list_count(scene);
    ThingRun run = {first, first + 1};
    if (first == THING_CAMERA || first >= count) {
        return run;
    }
    const SceneObject object = thing_list_object(scene, first);
    for (; run.end < count && object.origin->line > 0; run.end++) {
        const SceneObject next = thing_list_object(scene, run.end);
        if (next.keyword != object.keyword || next.origin->line != object.origin->line) {
            break;
        }
    }
    return run;
}

/** @return Whether things have a row together, as they are many. */
static bool is_group(ThingRun run) {
    return run.end - run.first >= FOLDED_MINIMUM;
}

/** @return Whether each thing has a row of its own. */
static bool is_unfolded(const ObjectInspector *inspector, ThingRun run) {
    return !is_group(run) || run.first == inspector->open_first;
}

/** @return The number of rows. @param wanted A thing. @param[out] row Its row, if it has one. */
static size_t count_rows(const ObjectInspector *inspector, const Scene *scene, size_t wanted,
                         size_t *row) {
    size_t rows = 0;
    for (ThingRun run = run_at(scene, 0); run.first < thing_list_count(scene);
         run = run_at(scene, run.end)) {
        rows += is_group(run);
        if (wanted >= run.first && wanted < run.end) {
            *row = rows + wanted - run.first;
        }
        rows += is_unfolded(inspector, run) ? run.end - run.first : 0;
    }
    return rows;
}

/** Unfolds the things among which one is. */
static void unfold(ObjectInspector *inspector, const Scene *scene, size_t index) {
    ThingRun run = run_at(scene, 0);
    while (run.end <= index) {
        run = run_at(scene, run.end);
    }
    if (is_group(run)) {
        inspector->open_first = run.first;
        inspector->open_end = run.end;
    }
}

/** Shows the row of things together. @return Whether it was clicked. */
static bool show_group(const ObjectInspector *inspector, const Scene *scene, ThingRun run) {
    char title[THING_TITLE_SIZE];
    unsigned char rgb[3];
    const SceneObject object = thing_list_object(scene, run.first);
    thing_group_title(&object, run.end - run.first, is_unfolded(inspector, run), title);
    encode(color_of(scene, run.first), rgb);
    return gui_list_row(-(int)run.first, title, 0, rgb, false, false);
}

/** Requests a thing that was chosen. */
static void choose(ObjectInspector *inspector, size_t index) {
    inspector->request = INSPECTOR_CHOOSE;
    inspector->chosen = index;
    inspector->has_chosen = true;
    inspector->is_by_mouse = gui_is_mouse_released();
}

/** Shows the rows in sight. @param first The first of them. @param end Behind the last. @param
 *  clicked Things whose row together was clicked; left as they are: none. */
static void show_rows(ObjectInspector *inspector, const Scene *scene, size_t first, size_t end,
                      ThingRun *clicked) {
    size_t row = 0;
    for (ThingRun run = run_at(scene, 0); run.first < thing_list_count(scene) && row < end;
         run = run_at(scene, run.end)) {
        if (is_group(run) && row++ >= first && show_group(inspector, scene, run)) {
            *clicked = run;
        }
        for (size_t i = run.first; is_unfolded(inspector, run) && i < run.end; i++, row++) {
            if (row >= first && row < end && show_row(inspector, scene, i)) {
                choose(inspector, i);
            }
        }
    }
}

void thing_list_show(ObjectInspector *inspector, const Scene *scene) {
    int first = 0, end = 0;
    size_t revealed = 0;
    ThingRun clicked = {0, 0};
    const bool is_new = !inspector->was_shown && inspector->has_chosen &&
                        inspector->chosen < thing_list_count(scene);
    if (is_new) {
        unfold(inspector, scene, inspector->chosen);
    }
    const size_t count = count_rows(inspector, scene, inspector->chosen, &revealed);
    gui_rows_begin((int)count, is_new ? (int)revealed : -1);
    while (gui_rows_next(&first, &end)) {
        show_rows(inspector, scene, (size_t)first, (size_t)end, &clicked);
    }
    if (clicked.end > 0) { // Once more folds them.
        const bool is_open = is_unfolded(inspector, clicked);
        inspector->open_first = is_open ? 0 : clicked.first;
        inspector->open_end = is_open ? 0 : clicked.end;
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
