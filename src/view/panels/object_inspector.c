/**
 * @file
 * @brief Widgets by parameter tables, and the outline of the selected object.
 */
#include "view/panels/object_inspector.h"

#include "base/language.h"
#include "dioptre/scene_words.h"
#include "view/panels/picture_projection.h"
#include "view/panels/thing_list.h"
#include "view/panels/thing_title.h"

#include <libintl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/** Bytes of a title or a tooltip with the final zero. */
enum { LABEL_SIZE = 512 };
/** Widest range of a number that a slider shows; others are dragged. */
static const double SLIDER_RANGE_MAXIMUM = 1;
/** How much a pixel of a drag changes a number, as a fraction of it. */
static const double DRAG_FRACTION = 0.005;
/** The same at zero, as a fraction of the scene's size. */
static const double DRAG_SCENE_FRACTION = 0.002;
/** Significant digits of a number that was dragged, so that it is short in a file. */
enum { DRAG_DIGITS = 4 };

/** Most words of a choice. */
enum { CHOICES_MAXIMUM = 8 };

/** What the widgets of one object need. */
typedef struct WidgetContext {
    ObjectInspector *inspector;            /**< The inspector. */
    const ObjectInspectorContent *content; /**< What it shows. */
    const SceneObject *object;             /**< The object. */
    double scene_size;                     /**< Size of the scene, scene units. */
} WidgetContext;

/** @return A number with few digits. */
static double shorten(double number) {
    char text[32];
    double shortened = number;
    snprintf(text, sizeof text, "%.*g", DRAG_DIGITS, number);
    sscanf(text, "%lf", &shortened);
    return shortened;
}

/** @return How much a pixel of a drag changes a value. */
static double drag_speed(const WidgetContext *context, const Parameter *row,
                         const double *numbers) {
    double largest = 0;
    for (int i = 0; i < parameter_number_count(row->type); i++) {
        largest = fmax(largest, fabs(numbers[i]));
    }
    bool is_place = row->type == PARAMETER_POINT;
    double at_zero = is_place ? context->scene_size * DRAG_SCENE_FRACTION : DRAG_FRACTION;
    return is_place ? at_zero : fmax(largest * DRAG_FRACTION, largest > 0 ? 0 : at_zero);
}

/** Shows numbers that are dragged. @return Whether the user has changed them. */
static bool drag_numbers(const WidgetContext *context, const Parameter *row, double *numbers,
                         const char *tooltip) {
    int count = parameter_number_count(row->type);
    double before[PARAMETER_NUMBERS_MAXIMUM];
    for (int i = 0; i < count; i++) {
        before[i] = numbers[i];
    }
    bool is_changed = gui_edit_numbers(scene_word(row->name), numbers, count, row->minimum,
                                       row->maximum, drag_speed(context, row, numbers), tooltip);
    for (int i = 0; is_changed && i < count; i++) {
        numbers[i] = numbers[i] != before[i] ? shorten(numbers[i]) : before[i];
    }
    return is_changed;
}

/** Shows a list of words. @return Whether the user has chosen another one. */
static bool show_choice(const Parameter *row, double *numbers, const char *tooltip) {
    const char *names[CHOICES_MAXIMUM + 1] = {NULL};
    for (int i = 0; i < CHOICES_MAXIMUM && row->choices[i]; i++) {
        names[i] = scene_word(row->choices[i]);
    }
    return gui_edit_choice(scene_word(row->name), numbers, names, tooltip);
}

/** Shows the widget of a value. @return Whether the user has changed it. */
static bool show_widget(const WidgetContext *context, const Parameter *row, double *numbers,
                        const char *tooltip) {
    bool is_narrow = row->maximum - row->minimum <= SLIDER_RANGE_MAXIMUM;
    const char *name = scene_word(row->name);
    bool is_changed;
    switch (row->type) {
    case PARAMETER_COLOR:
        return gui_edit_color(name, numbers, row->maximum,
                              (const char *const[]){gettext("hue"), gettext("saturation"),
                                                    gettext("value"), gettext("red"),
                                                    gettext("green"), gettext("blue")},
                              tooltip);
    case PARAMETER_BOOLEAN:
        return gui_edit_check(name, numbers, tooltip);
    case PARAMETER_CHOICE:
        return show_choice(row, numbers, tooltip);
    case PARAMETER_INTEGER:
        is_changed = gui_edit_numbers(name, numbers, 1, row->minimum, row->maximum, 1, tooltip);
        numbers[0] = round(numbers[0]);
        return is_changed;
    case PARAMETER_NUMBER:
        if (is_narrow) {
            is_changed = gui_edit_slider(name, numbers, row->minimum, row->maximum, tooltip);
            numbers[0] = is_changed ? shorten(numbers[0]) : numbers[0];
            return is_changed;
        }
        return drag_numbers(context, row, numbers, tooltip);
    default:
        return drag_numbers(context, row, numbers, tooltip);
    }
}

/** @return Whether a row says where a light is. */
static bool is_place(const Parameter *row) {
    return row->type == PARAMETER_POINT || row->type == PARAMETER_DIRECTION;
}

/** Shows one field, and requests an edit if the user changes it. */
static void show_field(const WidgetContext *context, const Parameter *row, int row_index) {
    ObjectInspector *inspector = context->inspector;
    const ObjectInspectorContent *content = context->content;
    SceneOverride field = {.keyword = context->object->keyword,
                           .number = context->object->origin->number,
                           .row = row_index};
    char tooltip[LABEL_SIZE];
    scene_object_get(context->object, row_index, field.numbers);
    const SceneOverride *newest = edit_history_find(content->history, &field);
    if (newest && !(content->is_light_moved && is_place(row))) {
        field = *newest;
    }
    const char *unit = row->unit ? gettext(row->unit) : scene_word(row->name);
    snprintf(tooltip, sizeof tooltip, gettext("%s (%s); in the scene file: %s"), gettext(row->help),
             unit, row->name);
    if (row->type == PARAMETER_COLOR) {
        size_t used = strlen(tooltip);
        snprintf(tooltip + used, sizeof tooltip - used, "\n%s",
                 gettext("☼: its brightness, the largest of red, green and blue; the square: its "
                         "hue, by a click, Space or Enter"));
    }
    if (show_widget(context, row, field.numbers, tooltip) && !content->is_read_only &&
        field.number > 0) {
        inspector->edit = field;
        inspector->has_edit = true;
        inspector->continues = inspector->is_continuing;
        inspector->is_continuing = true;
    }
}

/** Shows the fields of an object. @param first Its first row. @param end Behind its last one; -1:
 *  all. */
static void show_fields(const WidgetContext *context, int first, int end) {
    const Parameter *row;
    for (int i = first;
         (end < 0 || i < end) && (row = scene_object_row(context->object->keyword, i)); i++) {
        if (parameter_number_count(row->type) > 0) {
            show_field(context, row, i);
        }
    }
}

/** @return Number of rows of an object's own table: those of the transform follow. */
static int own_row_count(int keyword) {
    const Parameter *rows = scene_object_keyword(keyword)->parameters;
    int count = 0;
    while (rows[count].name) {
        count++;
    }
    return count;
}

/** Names an object in as many words as its line has room for. */
static void write_title(const Scene *scene, const SceneObject *object,
                        char title[THING_TITLE_SIZE]) {
    thing_title(scene, object, title);
    if (gui_text_width(title) > gui_inspector_title_width()) {
        thing_short_title(scene, object, title);
    }
}

/** Writes what the scene file says of an object. */
static void write_tooltip(const SceneObject *object, char tooltip[LABEL_SIZE]) {
    const char *word = scene_object_keyword(object->keyword)->name;
    if (object->origin->line > 0) {
        snprintf(tooltip, LABEL_SIZE, gettext("in the scene file: %s, line %d"), word,
                 object->origin->line);
    } else {
        snprintf(tooltip, LABEL_SIZE, gettext("in a scene file: %s"), word);
    }
}

/** @return Number of shapes that have a material. */
static size_t count_users(const Scene *scene, size_t material) {
    size_t count = 0;
    for (size_t i = 0; i < scene->shape_count; i++) {
        count += scene->shapes[i].material_index == material;
    }
    return count;
}

/** Shows the material of a shape. */
static void show_material(const WidgetContext *context) {
    const Scene *scene = context->content->scene;
    size_t index = scene->shapes[context->object->index].material_index;
    SceneObject material = scene_object_of_material(scene, index);
    char title[THING_TITLE_SIZE], text[LABEL_SIZE];
    if (material.origin->number == 0) {
        gui_paragraph(gettext("It has no material of its own."), GUI_COLOR_TEXT, 1);
        return;
    }
    WidgetContext own = *context;
    own.object = &material;
    write_title(scene, &material, title);
    write_tooltip(&material, text);
    if (gui_inspector_section(title, text, true)) {
        size_t users = count_users(scene, index);
        if (users > 1) {
            snprintf(text, sizeof text, ngettext("%zu shape has it.", "%zu shapes have it.", users),
                     users);
            gui_paragraph(text, GUI_COLOR_TEXT, 1);
        }
        show_fields(&own, 0, -1);
    }
}

/** @return Whether a button of the inspector would do anything. */
static bool is_possible(const ObjectInspectorContent *content, InspectorRequest request) {
    return request == INSPECTOR_UNDO   ? content->can_undo
           : request == INSPECTOR_REDO ? content->can_redo
                                       : true;
}

/** Shows the buttons. */
static void show_buttons(ObjectInspector *inspector, const ObjectInspectorContent *content) {
    static const struct {
        InspectorRequest request;
        const char *label;
        const char *tooltip;
    } buttons[] = {
        {INSPECTOR_UNDO, N_("undo"), N_("take the last change back — Ctrl+Z")},
        {INSPECTOR_REDO, N_("redo"), N_("do it again — Ctrl+Y")},
        {INSPECTOR_THINGS, N_("things"), N_("all things of the scene: a list — Shift+F10")},
        {INSPECTOR_COPY, N_("copy as scene text"), N_("its text with these values, to paste")},
        {INSPECTOR_WRITE, N_("write into the file"), N_("its changes, at the line that made it")},
        {INSPECTOR_RAYS, N_("rays of this pixel"), N_("of the pixel that was clicked")},
    };
    for (size_t i = 0; i < sizeof buttons / sizeof *buttons; i++) {
        bool is_shown = buttons[i].request != INSPECTOR_RAYS || inspector->has_pixel;
        if (is_shown && gui_inspector_button(gettext(buttons[i].label), gettext(buttons[i].tooltip),
                                             is_possible(content, buttons[i].request))) {
            inspector->request = buttons[i].request;
        }
    }
}

/** @return The size of a scene, scene units. */
static double size_of_scene(const Scene *scene) {
    Aabbd bounds = scene_bounds(scene);
    return aabbd_is_bounded(bounds) && bounds.low.x <= bounds.high.x
               ? vec3d_max_abs(vec3d_subtract(bounds.high, bounds.low))
               : scene->camera.target_distance;
}

/* --- where it lies ---------------------------------------------------------------------------- */

/** Finds where an object is seen: where it was clicked, else its middle. @return Whether it is. */
static bool find_place(const ObjectInspector *inspector, const ObjectInspectorContent *content,
                       const SceneObject *object, GuiPoint *place) {
    const SDL_Rect *picture = &content->picture;
    const Scene *scene = content->scene;
    if (inspector->has_pixel) {
        *place = (GuiPoint){(float)(picture->x + content->pixel.u * picture->w),
                            (float)(picture->y + content->pixel.v * picture->h)};
        return true;
    }
    Vec3d middle;
    if (scene_object_is_shape(object->keyword)) {
        Aabbd box = scene_shape_facts(scene, &scene->shapes[object->index]).bounds;
        middle = vec3d_scale(vec3d_add(box.low, box.high), 0.5);
        return aabbd_is_bounded(box) && picture_point(&scene->camera, picture, middle, place);
    }
    return scene_light_center(&scene->lights[object->index], &middle) &&
           picture_point(&scene->camera, picture, middle, place);
}

/** Shows buttons and fields of the selected object. */
static void show_object(ObjectInspector *inspector, const ObjectInspectorContent *content,
                        const SceneObject *object) {
    WidgetContext context = {inspector, content, object, size_of_scene(content->scene)};
    if (!content->is_read_only) {
        show_buttons(inspector, content);
    }
    int own = own_row_count(object->keyword);
    show_fields(&context, 0, own);
    if (scene_object_is_shape(object->keyword)) {
        if (gui_inspector_section(gettext("transform"), "", object->transform != NULL)) {
            show_fields(&context, own, -1);
        }
        show_material(&context);
    }
    if (!gui_is_editing()) {
        inspector->is_continuing = false;
    }
}

bool object_inspector_has_thing(const ObjectInspector *inspector) {
    return inspector->number > 0 || inspector->is_camera;
}

bool object_inspector_is_open(const ObjectInspector *inspector) {
    return object_inspector_has_thing(inspector) || inspector->lists;
}

void object_inspector_show(ObjectInspector *inspector, const ObjectInspectorContent *content) {
    SceneObject object;
    char title[THING_TITLE_SIZE], tooltip[LABEL_SIZE] = "";
    const bool has_object =
        inspector->number > 0 &&
        scene_object_find(content->scene, inspector->keyword, inspector->number, &object);
    if (!object_inspector_is_open(inspector) || (inspector->number > 0 && !has_object)) {
        return;
    }
    GuiInspectorPlace place = {.area = content->area, .is_new = !inspector->was_shown};
    if (has_object) {
        write_title(content->scene, &object, title);
        write_tooltip(&object, tooltip);
        place.has_thing = find_place(inspector, content, &object, &place.thing);
    } else {
        SDL_strlcpy(title, inspector->is_camera ? gettext("camera") : gettext("all things"),
                    sizeof title);
    }
    if (!gui_inspector_begin("object", title, tooltip, &place)) {
        inspector->request = INSPECTOR_CLOSE;
    }
    if (has_object) {
        show_object(inspector, content, &object);
    } else if (inspector->is_camera) {
        thing_list_show_camera(content->scene);
    } else {
        thing_list_show(inspector, content->scene);
    }
    inspector->was_shown = true;
    gui_inspector_end();
}

/* --- the outline ------------------------------------------------------------------------------ */

void object_inspector_outline(const ObjectInspector *inspector, const Scene *scene,
                              const SDL_Rect *picture) {
    SceneObject object;
    if (inspector->number == 0 || !scene_object_is_shape(inspector->keyword) ||
        !scene_object_find(scene, inspector->keyword, inspector->number, &object)) {
        return;
    }
    Aabbd box = scene_shape_facts(scene, &scene->shapes[object.index]).bounds;
    if (!aabbd_is_bounded(box)) {
        return;
    }
    const GuiRect area = {(float)picture->x, (float)picture->y, (float)picture->w,
                          (float)picture->h};
    for (int corner = 0; corner < 8; corner++) {
        for (int axis = 1; axis < 8; axis *= 2) {
            Vec3d ends[2];
            GuiPoint places[2];
            bool is_ahead = true;
            for (int i = 0; i < 2; i++) {
                int bits = i == 0 ? corner : corner | axis;
                ends[i] =
                    (Vec3d){bits & 1 ? box.high.x : box.low.x, bits & 2 ? box.high.y : box.low.y,
                            bits & 4 ? box.high.z : box.low.z};
                is_ahead = picture_point(&scene->camera, picture, ends[i], &places[i]) && is_ahead;
            }
            if (!(corner & axis) && is_ahead) {
                gui_outline_line(places[0], places[1], &area);
            }
        }
    }
}
