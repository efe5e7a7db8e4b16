/**
 * @file
 * @brief Small scenes.
 */
#include "lab/stage.h"

#include "dioptre/engine.h"

#include <stdlib.h>
#include <string.h>

/** @return The place of a shape's keyword among all, whose keyword is NULL if there is none.
 *  @param name The keyword. */
static size_t find_kind(const char *name) {
    const Keyword *const *keywords = engine_list()[0]->shape_keywords;
    size_t kind = 0;
    while (keywords[kind] && strcmp(keywords[kind]->name, name) != 0) {
        kind++;
    }
    return kind;
}

/** Sets a field. @param parameter The field. @param value Its value. @param[out] values The struct
 *  that it lies in. */
static void set(const Parameter *parameter, const StageValue *value, char *values) {
    void *field = values + parameter->offset;
    if (parameter->type == PARAMETER_NUMBER) {
        memcpy(field, value->numbers, sizeof(double));
    } else if (parameter->type == PARAMETER_BOOLEAN) {
        *(bool *)field = value->numbers[0] != 0;
    } else {
        memcpy(field, value->numbers, sizeof value->numbers);
    }
}

/** Adds a shape. @param[in,out] scene The scene. @param kind Its place among the keywords.
 *  @param given Its fields. @param[out] error What is wrong. @return Whether it is there. */
static bool add(Scene *scene, size_t kind, const StageValue *given, Error *error) {
    const Keyword *keyword = engine_list()[0]->shape_keywords[kind];
    char *values = malloc(keyword->size);
    if (!values) {
        return error_set(error, STATUS_FAILED, "no memory for a shape");
    }
    memcpy(values, keyword->defaults, keyword->size);
    for (; given->name; given++) {
        for (const Parameter *row = keyword->parameters; row->name; row++) {
            if (strcmp(row->name, given->name) == 0) {
                set(row, given, values);
            }
        }
    }
    bool is_added = (!keyword->finish || keyword->finish(values, UINT64_MAX, error)) &&
                    scene_add_shape(scene, kind, keyword, values, 0, error);
    free(values);
    return is_added;
}

Scene *stage_with(const char *keyword, const StageValue *values, Error *error) {
    Scene *scene = scene_create(error);
    if (scene && !add(scene, find_kind(keyword), values, error)) {
        scene_destroy(scene);
        scene = NULL;
    }
    return scene;
}
