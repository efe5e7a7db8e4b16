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
    } else if (parameter->type == PARAMETER_MESH) {
        *(size_t *)field = (size_t)value->numbers[0];
    } else {
        memcpy(field, value->numbers, sizeof value->numbers);
    }
}

/** Sets fields. @param keyword The shape's. @param given The fields. @param[out] values The struct
 *  that they lie in. @return Which rows of the table were set, as #Keyword.finish wants it. */
static uint64_t set_all(const Keyword *keyword, const StageValue *given, char *values) {
    uint64_t rows = 0;
    for (; given->name; given++) {
        for (size_t i = 0; keyword->parameters[i].name; i++) {
            if (strcmp(keyword->parameters[i].name, given->name) == 0) {
                set(&keyword->parameters[i], given, values);
                rows |= (uint64_t)1 << i;
            }
        }
    }
    return rows;
}

/** Adds a shape. @param[in,out] scene The scene. @param name Its keyword. @param given Its fields.
 *  @param[out] error What is wrong. @return Whether it is there. */
static bool add(Scene *scene, const char *name, const StageValue *given, Error *error) {
    size_t kind = find_kind(name);
    const Keyword *keyword = engine_list()[0]->shape_keywords[kind];
    char *values = malloc(keyword->size);
    if (!values) {
        return error_set(error, STATUS_FAILED, "no memory for a shape");
    }
    memcpy(values, keyword->defaults, keyword->size);
    uint64_t rows = set_all(keyword, given, values);
    bool is_added = (!keyword->finish || keyword->finish(values, rows, error)) &&
                    scene_add_shape(scene, kind, keyword, values, 0, error);
    free(values);
    return is_added;
}

Scene *stage_with(const char *keyword, const StageValue *values, Error *error) {
    Scene *scene = scene_create(error);
    if (scene && !add(scene, keyword, values, error)) {
        scene_destroy(scene);
        scene = NULL;
    }
    return scene;
}

/** Makes a field. @param name Its keyword. @param given Its fields. @param[out] field Room for one
 *  step. @return Whether there is such a field, and memory for it. */
static bool field_make(const char *name, const StageValue *given, Field *field) {
    const FieldKind *const *kind = field_kinds;
    while (*kind && strcmp((*kind)->keyword.name, name) != 0) {
        kind++;
    }
    char *values = *kind ? malloc((*kind)->keyword.size) : NULL;
    if (!values) {
        return false;
    }
    memcpy(values, (*kind)->keyword.defaults, (*kind)->keyword.size);
    set_all(&(*kind)->keyword, given, values);
    (*kind)->make(field, values);
    free(values);
    return true;
}

/** Adds the surface of a field. @param[in,out] scene The scene. @param field The field.
 *  @param[out] error What is wrong. @return Whether it is there. */
static bool add_surface(Scene *scene, const Field *field, Error *error) {
    size_t kind = find_kind("sdf");
    const Keyword *keyword = engine_list()[0]->shape_keywords[kind];
    const Field *kept = scene_keep_field(scene, field, error);
    char *values = kept ? malloc(keyword->size) : NULL;
    if (!values) {
        return error_set(error, STATUS_FAILED, "no memory for a shape");
    }
    memcpy(values, keyword->defaults, keyword->size);
    memcpy(values + keyword->parameters->offset, &kept, sizeof kept); // The field is its first.
    bool is_added = scene_add_shape(scene, kind, keyword, values, 0, error);
    free(values);
    return is_added;
}

Scene *stage_with_field(const char *name, const StageValue *values, Vector3 way, Error *error) {
    Field *field = calloc(1, field_size(1)), *moved = calloc(1, field_size(2));
    Scene *scene = scene_create(error);
    bool is_made = field && moved && scene && field_make(name, values, field);
    if (is_made) {
        field_move(moved, field, way);
        is_made = add_surface(scene, moved, error);
    }
    free(field);
    free(moved);
    if (!is_made) {
        scene_destroy(scene);
        scene = NULL;
    }
    return scene;
}

Scene *stage_with_mesh(Mesh *mesh, Error *error) {
    const SceneFile file = {.path = "lab", .name = "lab", .where = "lab"};
    const StageValue values[] = {{"file", {0}}, {0}};
    size_t place = 0;
    Scene *scene = scene_create(error);
    if (!scene || !scene_add_mesh(scene, &file, &place, error)) {
        scene_destroy(scene);
        mesh_destroy(mesh);
        return NULL;
    }
    scene->meshes[place].mesh = mesh;
    if (!add(scene, "mesh", values, error)) {
        scene_destroy(scene);
        return NULL;
    }
    return scene;
}
