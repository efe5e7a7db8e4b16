/**
 * @file
 * @brief The selected object as text: on the clipboard, and in the scene file.
 */
#include "base/atomic_file.h"
#include "base/data_dir.h"
#include "base/language.h"
#include "base/regular_file.h"
#include "base/text_file.h"
#include "view/commands/current_scene.h"
#include "view/commands/edits.h"
#include "view/state/scene_text.h"
#include "view/state/snapshot.h"
#include "view/state/source_edit.h"

#include <libintl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/** Largest scene file that is written, bytes. */
static const off_t FILE_MAXIMUM = (off_t)16 << 20;

/** @return The selected object; its number is 0 if there is none. */
static bool find_selected(App *app, SceneObject *object) {
    const ObjectInspector *inspector = &app->window.object_inspector;
    return inspector->number > 0 &&
           scene_object_find(app->scene, inspector->keyword, inspector->number, object);
}

void edits_copy(App *app) {
    SceneObject object;
    if (!find_selected(app, &object)) {
        app_set_status(app, "nothing is selected: click on a thing");
        return;
    }
    char *text = scene_text_of_object(app->scene, &object);
    if (!text) {
        app_set_status(app, "a distance field is a program: copy it from the file");
        return;
    }
    puts(text);
    fflush(stdout);
    bool is_copied = SDL_SetClipboardText(text) == 0;
    app_set_status(app, is_copied ? N_("the object can be pasted") : N_("the object is printed"));
    free(text);
}

/** @return Number of objects of a keyword that a line of the file made. */
static size_t count_of_line(const Scene *scene, const SceneObject *object) {
    size_t count = 0;
    bool is_shape = scene_object_is_shape(object->keyword);
    bool is_material = scene_object_keyword(object->keyword) == &scene_material_keyword;
    size_t all = is_shape      ? scene->shape_count
                 : is_material ? scene->material_count
                               : scene->light_count;
    for (size_t i = 0; i < all; i++) {
        SceneObject other = is_shape      ? scene_object_of_shape(scene, i)
                            : is_material ? scene_object_of_material(scene, i)
                                          : scene_object_of_light(scene, i);
        count += other.keyword == object->keyword && other.origin->line == object->origin->line;
    }
    return count;
}

/** Checks that one call of the scene file made an object. @return Whether it did. */
static bool check_origin(const Scene *scene, const SceneObject *object, Error *error) {
    const char *keyword = scene_object_keyword(object->keyword)->name;
    if (object->origin->line == 0) {
        return error_set(error, STATUS_FAILED, "%s %d is made in an included file", keyword,
                         object->origin->number);
    }
    size_t count = count_of_line(scene, object);
    return count == 1 || error_set(error, STATUS_FAILED,
                                   "line %d makes %zu objects: a value there would change them all",
                                   object->origin->line, count);
}

/** Reads a file. @return Its text, to be freed with `free`; NULL after an error. */
static char *read_file(const char *path, size_t *size, Error *error) {
    struct stat info;
    int file = regular_file_open(path, &info, error);
    if (file < 0) {
        return NULL;
    }
    *size = (size_t)info.st_size;
    char *text = NULL;
    if (info.st_size > FILE_MAXIMUM) {
        error_set(error, STATUS_FAILED, "longer than %zu MiB", (size_t)FILE_MAXIMUM >> 20);
    } else if (!(text = malloc(*size + 1))) {
        error_set(error, STATUS_FAILED, "no memory for a scene file");
    } else if (!regular_file_read(file, text, *size, error)) {
        free(text);
        text = NULL;
    }
    close(file);
    return text;
}

/** Writes the values in force of an object into a text. @param[in,out] text The text; replaced.
 *  @param[in,out] count The number of values written is added. @return Whether all are written. */
static bool write_values(const App *app, const SceneObject *object, char **text, size_t *size,
                         size_t *count, Error *error) {
    const Parameter *row;
    for (int i = 0; (row = scene_object_row(object->keyword, i)); i++) {
        const SceneOverride field = {object->keyword, object->origin->number, i, {0}};
        const SceneOverride *newest = edit_history_find(&app->edits, &field);
        if (!newest) {
            continue;
        }
        size_t new_size = 0;
        if (!check_origin(app->scene, object, error)) {
            return false;
        }
        char *value = scene_text_of_value(row, newest->numbers);
        if (!value) {
            return error_set(error, STATUS_FAILED, "no memory for a scene file");
        }
        const SourceField place = {scene_object_keyword(object->keyword)->name,
                                   object->origin->line, row->name, value};
        char *replaced = source_edit_set(*text, *size, &place, &new_size, error);
        free(value);
        if (!replaced) {
            return false;
        }
        free(*text);
        *text = replaced;
        *size = new_size;
        ++*count;
    }
    return true;
}

/** Checks that there is a scene file, and that the scene on screen is the one in it: objects then
 *  stand at the lines that they were read from. @return Whether it is. */
static bool check_is_shown(const App *app, Error *error) {
    if (strcmp(app->source.path, "-") == 0) {
        return error_set(error, STATUS_FAILED, "a scene from standard input has no file");
    }
    return !current_scene_is_outdated(app) ||
           error_set(error, STATUS_FAILED, "the file has changed: it is loaded again first");
}

/** Checks that the scene file is the user's own. @return Whether it is. */
static bool check_file(const App *app, Error *error) {
    char folder[PATH_MAX], own[PATH_MAX];
    const char *path = app->source.path;
    bool is_installed = data_dir_installed_scenes(folder) && realpath(path, own) &&
                        strncmp(own, folder, strlen(folder)) == 0 && own[strlen(folder)] == '/';
    if (is_installed) {
        return error_set(error, STATUS_FAILED,
                         "this scene belongs to the program: save a copy (Ctrl+Shift+S)");
    }
    return atomic_file_check(path, error);
}

/** Replaces a file. @return Whether it is written. */
static bool replace_file(const char *path, const char *text, size_t size, Error *error) {
    AtomicFile file;
    if (!atomic_file_open(&file, path, ATOMIC_REPLACE, error)) {
        return false;
    }
    if (fwrite(text, 1, size, file.stream) != size) {
        atomic_file_discard(&file);
        return error_set(error, STATUS_FAILED, "it cannot be written");
    }
    return atomic_file_commit(&file, error);
}

/** Writes the selected object and its material. @param[out] count Number of values. @return Whether
 *  they are written. */
static bool write_selected(App *app, const SceneObject *objects, size_t object_count, size_t *count,
                           Error *error) {
    size_t size = 0;
    bool is_writable = check_is_shown(app, error) && check_file(app, error);
    char *text = is_writable ? read_file(app->source.path, &size, error) : NULL;
    bool is_good = text != NULL;
    for (size_t i = 0; i < object_count && is_good; i++) {
        is_good = write_values(app, &objects[i], &text, &size, count, error);
    }
    is_good = is_good && (*count == 0 || replace_file(app->source.path, text, size, error));
    free(text);
    return is_good;
}

void edits_write(App *app) {
    SceneObject objects[2];
    Error error = {0};
    size_t count = 0, object_count = 1;
    if (!find_selected(app, &objects[0])) {
        app_set_status(app, "nothing is selected: click on a thing");
        return;
    }
    if (scene_object_is_shape(objects[0].keyword)) {
        size_t material = app->scene->shapes[objects[0].index].material_index;
        objects[1] = scene_object_of_material(app->scene, material);
        object_count = objects[1].origin->number > 0 ? 2 : 1;
    }
    if (!write_selected(app, objects, object_count, &count, &error)) {
        app_set_status(app, "not written: %.*s", STATUS_TEXT_SIZE - 32, error.message);
    } else if (count == 0) {
        app_set_status(app, "nothing of it has changed");
    } else {
        for (size_t i = 0; i < object_count; i++) {
            edit_history_wake_originals(&app->edits, objects[i].keyword, objects[i].origin->number);
        }
        current_scene_file_written(app);
        app_set_status(app,
                       ngettext("%zu value written into %s", "%zu values written into %s", count),
                       count, app->source.path);
    }
}

/* --- copies -------------------------------------------------------------------------------------
 */

/** Text to be written. */
typedef struct CopyText {
    char *text;  /**< Its bytes. */
    size_t size; /**< Their number. */
} CopyText;

/** Writes it. See #NumberedFile.write. */
static bool write_copy(const void *context, const char *path, bool *exists, Error *error) {
    const CopyText *copy = context;
    return text_file_write_new(path, copy->text, copy->size, exists, error);
}

/** Writes the values of all changed objects into a text. @param[in,out] copy The text. @return
 *  Whether all are written. */
static bool write_all_values(const App *app, CopyText *copy, size_t *count, Error *error) {
    SceneOverride *overrides = calloc(SCENE_OVERRIDES_MAXIMUM, sizeof *overrides);
    size_t fields = overrides ? edit_history_overrides(&app->edits, overrides) : 0;
    bool is_good = overrides || error_set(error, STATUS_FAILED, "no memory for a scene file");
    for (size_t i = 0; i < fields && is_good; i++) {
        SceneObject object;
        bool is_known = false; // All fields of an object are written at its first one.
        for (size_t k = 0; k < i; k++) {
            is_known = is_known || (overrides[k].keyword == overrides[i].keyword &&
                                    overrides[k].number == overrides[i].number);
        }
        if (!is_known &&
            scene_object_find(app->scene, overrides[i].keyword, overrides[i].number, &object)) {
            is_good = write_values(app, &object, &copy->text, &copy->size, count, error);
        }
    }
    free(overrides);
    return is_good;
}

void edits_save_copy(App *app) {
    Error error = {0};
    CopyText copy = {0};
    size_t count = 0;
    char path[NUMBERED_FILE_PATH_SIZE], name[SCENE_NAME_SIZE + 8];
    snprintf(name, sizeof name, "%s-copy", app->source.name);
    const NumberedFile file = {app->settings->snapshot_dir, name, "lua", write_copy, &copy};
    copy.text =
        check_is_shown(app, &error) ? read_file(app->source.path, &copy.size, &error) : NULL;
    bool is_saved = copy.text && write_all_values(app, &copy, &count, &error) &&
                    numbered_file_write(&file, path, &error);
    free(copy.text);
    if (!is_saved) {
        app_set_status(app, "not written: %.*s", STATUS_TEXT_SIZE - 32, error.message);
        return;
    }
    app_print_path(path);
    app_set_status(app, ngettext("%zu value written into %s", "%zu values written into %s", count),
                   count, path);
}
