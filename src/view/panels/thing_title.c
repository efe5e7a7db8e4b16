/**
 * @file
 * @brief Naming shapes, lights and materials.
 */
#include "view/panels/thing_title.h"

#include "base/language.h"
#include "dioptre/scene_words.h"

#include <libintl.h>
#include <stdio.h>

/** @return Whether the number of an object helps to tell it: always for lights and materials, which
 *  are few; for shapes where a function or a loop of the scene file has made several in a line. */
static bool needs_number(const Scene *scene, const SceneObject *object) {
    int count = 0;
    for (size_t i = 0; i < scene->shape_count; i++) {
        count += scene->shapes[i].origin.line == object->origin->line;
    }
    return object->origin->number > 0 && (count > 1 || !scene_object_is_shape(object->keyword));
}

/** @return The number by which an object is told from others of its kind. */
static int number_of(const SceneObject *object) {
    // What no call of a scene file has made is counted.
    return object->origin->number > 0 ? object->origin->number : (int)object->index + 1;
}

/** Names an object. @param numbered Format of its name, its number and its line; in English.
 *  @param plain The same without number. */
static void write_title(const Scene *scene, const SceneObject *object, const char *numbered,
                        const char *plain, char title[THING_TITLE_SIZE]) {
    const char *name = scene_word(scene_object_keyword(object->keyword)->name);
    int line = object->origin->line, number = object->origin->number;
    if (line > 0 && needs_number(scene, object)) {
        snprintf(title, THING_TITLE_SIZE, gettext(numbered), name, number, line);
    } else if (line > 0) {
        snprintf(title, THING_TITLE_SIZE, gettext(plain), name, line);
    } else {
        snprintf(title, THING_TITLE_SIZE, "%s %d", name, number_of(object));
    }
}

void thing_title(const Scene *scene, const SceneObject *object, char title[THING_TITLE_SIZE]) {
    write_title(scene, object, N_("%s %d (line %d of the scene)"), N_("%s (line %d of the scene)"),
                title);
}

void thing_short_title(const Scene *scene, const SceneObject *object,
                       char title[THING_TITLE_SIZE]) {
    write_title(scene, object, N_("%s %d (line %d)"), N_("%s (line %d)"), title);
}

void thing_row_title(const SceneObject *object, char title[THING_TITLE_SIZE]) {
    const char *name = scene_word(scene_object_keyword(object->keyword)->name);
    if (object->origin->line > 0) {
        snprintf(title, THING_TITLE_SIZE, gettext("%s %d (line %d)"), name, number_of(object),
                 object->origin->line);
    } else {
        snprintf(title, THING_TITLE_SIZE, "%s %d", name, number_of(object));
    }
}

void thing_group_title(const SceneObject *object, size_t count, bool is_open,
                       char title[THING_TITLE_SIZE]) {
    snprintf(title, THING_TITLE_SIZE, gettext("%s %s × %zu (line %d)"),
             is_open ? "\xe2\x96\xbc" : "\xe2\x96\xb6",
             scene_word(scene_object_keyword(object->keyword)->name), count, object->origin->line);
}

void shape_title(const Scene *scene, int shape, char title[THING_TITLE_SIZE]) {
    SceneObject object = scene_object_of_shape(scene, (size_t)shape);
    thing_title(scene, &object, title);
}
