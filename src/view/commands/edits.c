/**
 * @file
 * @brief Selecting and changing objects.
 */
#include "view/commands/edits.h"

#include "base/language.h"
#include "view/commands/commands.h"
#include "view/commands/current_scene.h"
#include "view/commands/recorder.h"
#include "view/panels/thing_list.h"
#include "view/state/scene_text.h"

#include <string.h>

/** @return Whether an object is a light. */
static bool is_light(const SceneObject *object) {
    return !scene_object_is_shape(object->keyword) &&
           scene_object_keyword(object->keyword) != &scene_material_keyword;
}

/* --- selecting -------------------------------------------------------------------------------- */

void edits_select(App *app, int keyword, int number, const Uvd *pixel) {
    ObjectInspector *inspector = &app->window.object_inspector;
    SceneObject object;
    bool is_known = number > 0 && scene_object_find(app->scene, keyword, number, &object);
    *inspector = (ObjectInspector){.keyword = keyword,
                                   .number = is_known ? number : 0,
                                   .has_pixel = is_known && pixel,
                                   .lists = inspector->lists,
                                   .has_chosen = inspector->has_chosen,
                                   .chosen = inspector->chosen};
    if (is_known && is_light(&object)) {
        app->selected_light = object.index;
    }
    if (is_known && pixel) {
        ray_view_aim(&app->window.ray_view, pixel->u, pixel->v);
    }
    window_present(&app->window);
}

/** Selects an object for the user. @param object The object; NULL: none. @param pixel Where it was
 *  clicked, fractions of the picture; NULL: not in the picture. */
static void select_object(App *app, const SceneObject *object, const Uvd *pixel) {
    if (object && object->origin->number == 0) {
        app_set_status(app, "no call of the scene file made this: it cannot be changed here");
        object = NULL;
    }
    if (!object) {
        if (app->window.object_inspector.number > 0) {
            recorder_on_step(app, "select()");
        }
        edits_select(app, 0, 0, NULL);
        return;
    }
    const char *keyword = scene_object_keyword(object->keyword)->name;
    int number = object->origin->number;
    if (pixel) {
        recorder_on_step(app, "select(\"%s\", %d, %.17g, %.17g)", keyword, number, pixel->u,
                         pixel->v);
    } else {
        recorder_on_step(app, "select(\"%s\", %d)", keyword, number);
    }
    edits_select(app, object->keyword, number, pixel);
}

/** Finds what a pixel shows. @param[out] point Where it is, scene units. @return false if it shows
 *  nothing. */
static bool find_object_at(App *app, double x, double y, SceneObject *object, Vec3d *point) {
    const Viewport *viewport = window_active_viewport(&app->window);
    RayTree tree = {0};
    Error error = {0};
    bool is_found = renderer_record_ray_tree(viewport->renderer, (int)(x * viewport->width),
                                             (int)(y * viewport->height), &tree, &error) &&
                    tree.count > 0;
    int shape = is_found ? tree.nodes[0].shape : -1, light = is_found ? tree.nodes[0].light : -1;
    *point = is_found ? tree.nodes[0].point : (Vec3d){0};
    ray_tree_deinit(&tree);
    if (shape >= 0 && (size_t)shape < app->scene->shape_count) {
        *object = scene_object_of_shape(app->scene, (size_t)shape);
        return true;
    }
    if (light >= 0 && (size_t)light < app->scene->light_count) {
        *object = scene_object_of_light(app->scene, (size_t)light);
        return true;
    }
    return false;
}

bool edits_point_at(App *app, double x, double y, Vec3d *point) {
    SceneObject object;
    return find_object_at(app, x, y, &object, point);
}

void edits_click(App *app, double x, double y) {
    SceneObject object;
    Vec3d point;
    const Uvd pixel = {x, y};
    bool is_found = find_object_at(app, x, y, &object, &point);
    select_object(app, is_found ? &object : NULL, &pixel);
}

void edits_click_light(App *app, size_t light) {
    SceneObject object = scene_object_of_light(app->scene, light);
    select_object(app, &object, NULL);
}

/** @return The objects of a scene in turn: shapes, then lights. @param index Below their number. */
static SceneObject object_at(const Scene *scene, size_t index) {
    return index < scene->shape_count ? scene_object_of_shape(scene, index)
                                      : scene_object_of_light(scene, index - scene->shape_count);
}

void edits_select_next(App *app, int step) {
    const ObjectInspector *inspector = &app->window.object_inspector;
    const Scene *scene = app->scene;
    size_t count = scene->shape_count + scene->light_count, present = step > 0 ? count - 1 : 0;
    SceneObject middle;
    Vec3d point;
    // A floor of a hundred tiles would come before what the picture is about.
    if (inspector->number == 0 && find_object_at(app, 0.5, 0.5, &middle, &point) &&
        middle.origin->number > 0) {
        edits_click(app, 0.5, 0.5);
        return;
    }
    for (size_t i = 0; i < count && inspector->number > 0; i++) {
        SceneObject object = object_at(scene, i);
        if (object.keyword == inspector->keyword && object.origin->number == inspector->number) {
            present = i;
        }
    }
    for (size_t i = 1; i <= count; i++) {
        SceneObject object =
            object_at(scene, (present + (step > 0 ? i : count - i % count)) % count);
        if (object.origin->number > 0) {
            select_object(app, &object, NULL);
            return;
        }
    }
    app_set_status(app, "there is nothing that can be changed");
}

bool edits_close(App *app) {
    ObjectInspector *inspector = &app->window.object_inspector;
    const bool is_open = object_inspector_is_open(inspector);
    inspector->lists = inspector->lists && object_inspector_has_thing(inspector);
    select_object(app, NULL, NULL);
    return is_open;
}

void edits_list(App *app) {
    app->window.object_inspector.lists = true;
    select_object(app, NULL, NULL);
}

/** Selects what was chosen in the list of all things. */
static void choose_thing(App *app) {
    ObjectInspector *inspector = &app->window.object_inspector;
    if (inspector->is_by_mouse) {
        gui_take_keyboard(app->window.gui); // The next key is for the picture.
    }
    if (inspector->chosen == THING_CAMERA) {
        select_object(app, NULL, NULL);
        inspector->is_camera = true;
    } else if (inspector->chosen < thing_list_count(app->scene)) {
        const SceneObject object = thing_list_object(app->scene, inspector->chosen);
        select_object(app, &object, NULL);
    }
}

/* --- changing --------------------------------------------------------------------------------- */

/** A change puts a moved light back under the file's control. */
static void release_moved_light(App *app, const SceneObject *object, const Parameter *row) {
    bool is_place = row->type == PARAMETER_POINT || row->type == PARAMETER_DIRECTION;
    if (is_light(object) && is_place && object->index < app->home_view.light_count) {
        app->home_view.is_light_moved[object->index] = false;
    }
}

bool edits_check(const App *app, const SceneObject *object, const SceneOverride *edits,
                 size_t count, Error *error) {
    SceneOverride *all = calloc(SCENE_OVERRIDES_MAXIMUM + count, sizeof *all);
    if (!all) {
        return error_set(error, STATUS_FAILED, "no memory for a change");
    }
    size_t in_force = edit_history_overrides(&app->edits, all);
    memcpy(all + in_force, edits, count * sizeof *edits);
    bool is_valid = scene_override_check(object, all, in_force + count, error) &&
                    (in_force + count <= SCENE_OVERRIDES_MAXIMUM ||
                     error_set(error, STATUS_FAILED, "at most %d changes can be kept",
                               SCENE_OVERRIDES_MAXIMUM));
    free(all);
    return is_valid;
}

/** Remembers the value that the file gives a field. @return Whether there was memory. */
static bool keep_original(App *app, const SceneObject *object, const SceneOverride *edit,
                          Error *error) {
    SceneOverride original = *edit;
    SceneObject home = *object;
    if (is_light(object) && object->index < app->home_view.light_count) {
        home.values = &app->home_view.lights[object->index];
    }
    scene_object_get(&home, edit->row, original.numbers);
    return edit_history_keep_original(&app->edits, &original, error);
}

/** Adds edits of one object, or says why they are not possible. */
static void apply_edits(App *app, const SceneOverride *edits, size_t count, bool continues) {
    SceneObject object;
    Error error = {0};
    if (!app->settings->load ||
        !scene_object_find(app->scene, edits[0].keyword, edits[0].number, &object)) {
        app_set_status(app, "there is no such object");
        return;
    }
    bool is_good = edits_check(app, &object, edits, count, &error);
    if (is_good) {
        view_history_forget_undone(&app->moves);
    }
    for (size_t i = 0; i < count && is_good; i++) {
        is_good = keep_original(app, &object, &edits[i], &error) &&
                  edit_history_add(&app->edits, &edits[i], continues || i > 0, &error);
        release_moved_light(app, &object, scene_object_row(edits[i].keyword, edits[i].row));
    }
    if (!is_good) {
        app_set_status(app, "%.*s", STATUS_TEXT_SIZE - 1, error.message);
    }
}

void edits_set(App *app, const SceneOverride *override, bool continues) {
    if (scene_object_row(override->keyword, override->row)) {
        apply_edits(app, override, 1, continues);
    }
}

/** Significant digits of the distance to the target in which objects move: far less than a pixel.
 */
enum { MOVE_DIGITS = 5 };

/** @return Decimals of the places of objects that are moved: they are short in a file. */
static int decimals_of_scene(const App *app) {
    double digits = MOVE_DIGITS - floor(log10(app->scene->camera.target_distance));
    return (int)SDL_clamp(digits, 0, 30);
}

/** @return A number with few decimals. */
static double shorten(double number, int decimals) {
    char text[512]; // The largest double has 309 digits before the point.
    snprintf(text, sizeof text, "%.*f", decimals, number);
    return strtod(text, NULL);
}

/** Most fields that move with an object. */
enum { MOVED_FIELDS_MAXIMUM = 8 };

/** Lists the new values of the points that move with an object. @return Their number. */
static size_t list_moved_points(const App *app, const SceneObject *object, Vec3d offset,
                                SceneOverride edits[MOVED_FIELDS_MAXIMUM]) {
    const Parameter *row;
    int digits = decimals_of_scene(app);
    size_t count = 0;
    bool has_own_point = false;
    for (int i = 0; (row = scene_object_row(object->keyword, i)); i++) {
        bool is_transform = strcmp(row->name, "translate") == 0;
        // What is transformed, or has no points of its own, moves by its transform.
        bool is_moved = row->type == PARAMETER_POINT &&
                        (is_transform ? object->transform || !has_own_point : !object->transform);
        if (!is_moved || count == MOVED_FIELDS_MAXIMUM) {
            continue;
        }
        has_own_point = true;
        SceneOverride edit = {object->keyword, object->origin->number, i, {0}};
        scene_object_get(object, i, edit.numbers);
        const SceneOverride *newest = edit_history_find(&app->edits, &edit);
        edit = newest ? *newest : edit;
        edit.numbers[0] = shorten(edit.numbers[0] + offset.x, digits);
        edit.numbers[1] = shorten(edit.numbers[1] + offset.y, digits);
        edit.numbers[2] = shorten(edit.numbers[2] + offset.z, digits);
        edits[count++] = edit;
    }
    return count;
}

void edits_move(App *app, int keyword, int number, Vec3d offset, bool continues) {
    SceneObject object;
    SceneOverride edits[MOVED_FIELDS_MAXIMUM];
    if (scene_object_find(app->scene, keyword, number, &object)) {
        size_t count = list_moved_points(app, &object, offset, edits);
        if (count > 0) {
            apply_edits(app, edits, count, continues);
        }
    }
}

/** Records a change. */
static void record_set(App *app, const SceneOverride *edit, bool continues) {
    const Parameter *row = scene_object_row(edit->keyword, edit->row);
    char *value = scene_text_of_value(row, edit->numbers);
    if (value) {
        recorder_on_step(app, "set(\"%s\", %d, \"%s\", %s%s)",
                         scene_object_keyword(edit->keyword)->name, edit->number, row->name, value,
                         continues ? ", true" : "");
        free(value);
    }
}

/** Takes the last move or choice back, or does it again. @return Whether there is any. */
static bool step_view(App *app, ViewHistoryStepFn *do_step) {
    PictureChoice choice = window_choice(&app->window);
    const ViewTarget target = {&app->home_view, app->scene, &choice};
    const ViewStep *step = do_step(&app->moves, &target, edit_history_in_force(&app->edits));
    if (step && step->is_choice) {
        window_choose(&app->window, &choice);
        app_clear_status(app); // It may name a setting that is another one now.
        window_end_toast(&app->window);
        window_tell_settings(&app->window);
    } else if (step) {
        app_on_view_changed(app);
    }
    return step != NULL;
}

void edits_undo(App *app) {
    if (!step_view(app, view_history_undo) && !edit_history_undo(&app->edits)) {
        app_set_status(app, "there is nothing to undo");
    }
}

void edits_redo(App *app) {
    if (!step_view(app, view_history_redo) && !edit_history_redo(&app->edits)) {
        app_set_status(app, "there is nothing to do again");
    }
}

bool edits_grab(App *app, double x, double y, Vec3d *point) {
    const ObjectInspector *inspector = &app->window.object_inspector;
    SceneObject object;
    return inspector->number > 0 && scene_object_is_shape(inspector->keyword) &&
           find_object_at(app, x, y, &object, point) && object.keyword == inspector->keyword &&
           object.origin->number == inspector->number;
}

void edits_drag(App *app, Vec3d offset, bool continues) {
    const ObjectInspector *inspector = &app->window.object_inspector;
    recorder_on_step(app, "move(\"%s\", %d, %.17g, %.17g, %.17g%s)",
                     scene_object_keyword(inspector->keyword)->name, inspector->number, offset.x,
                     offset.y, offset.z, continues ? ", true" : "");
    edits_move(app, inspector->keyword, inspector->number, offset, continues);
}

/* --- requests --------------------------------------------------------------------------------- */

/** Carries out what the inspector requests besides an edit. */
static void handle_request(App *app, InspectorRequest request) {
    switch (request) {
    case INSPECTOR_CLOSE:
        edits_close(app);
        break;
    case INSPECTOR_UNDO:
    case INSPECTOR_REDO:
        command_issue_named(app, request == INSPECTOR_UNDO ? "undo" : "redo");
        break;
    case INSPECTOR_COPY:
        edits_copy(app);
        break;
    case INSPECTOR_WRITE:
        edits_write(app);
        break;
    case INSPECTOR_RAYS: // Of the pixel that was clicked, wherever the mouse is now.
        command_show_rays(app, app->window.ray_view.x, app->window.ray_view.y);
        break;
    case INSPECTOR_THINGS:
        command_issue_named(app, "things");
        break;
    case INSPECTOR_CHOOSE:
        choose_thing(app);
        break;
    case INSPECTOR_NO_REQUEST:
        break;
    }
}

void edits_handle_requests(App *app) {
    ObjectInspector *inspector = &app->window.object_inspector;
    InspectorRequest request = inspector->request;
    if (inspector->has_edit && !app_is_playing(app)) {
        record_set(app, &inspector->edit, inspector->continues);
        edits_set(app, &inspector->edit, inspector->continues);
    }
    inspector->has_edit = false;
    inspector->request = INSPECTOR_NO_REQUEST;
    handle_request(app, request);
}
