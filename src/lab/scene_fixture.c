/**
 * @file
 * @brief Scenes with one shape.
 */
#include "lab/scene_fixture.h"

#include <stdlib.h>
#include <string.h>

/** Sets a parameter. @param[out] values The struct that contains it. */
static void set_parameter(const Parameter *parameter, const FixtureValue *value, char *values) {
    void *field = values + parameter->offset;
    if (parameter->type == PARAMETER_NUMBER) {
        memcpy(field, value->components, sizeof(double));
    } else if (parameter->type == PARAMETER_BOOLEAN) {
        *(bool *)field = value->components[0] != 0;
    } else if (parameter->type == PARAMETER_MESH) {
        *(size_t *)field = (size_t)value->components[0];
    } else {
        memcpy(field, value->components, sizeof value->components);
    }
}

/** Sets parameters. @param[out] values The struct that contains them. @return Which were set, as
 *  #Keyword.finish expects it. */
static uint64_t set_parameters(const Keyword *keyword, const FixtureValue *assignments,
                               char *values) {
    uint64_t rows = 0;
    for (; assignments->name; assignments++) {
        for (size_t i = 0; keyword->parameters[i].name; i++) {
            if (strcmp(keyword->parameters[i].name, assignments->name) == 0) {
                set_parameter(&keyword->parameters[i], assignments, values);
                rows |= (uint64_t)1 << i;
            }
        }
    }
    return rows;
}

bool scene_fixture_add_shape(Scene *scene, const char *keyword_name,
                             const FixtureValue *assignments, Error *error) {
    size_t kind = scene_shape_find(keyword_name);
    const Keyword *keyword = scene_shape_keywords[kind];
    char *values = malloc(keyword->size);
    if (!values) {
        return error_set(error, STATUS_FAILED, "no memory for a shape");
    }
    memcpy(values, keyword->defaults, keyword->size);
    uint64_t rows = set_parameters(keyword, assignments, values);
    bool is_added = (!keyword->finish || keyword->finish(values, rows, error)) &&
                    scene_add_shape(scene, kind, keyword, values, 0, error);
    free(values);
    return is_added;
}

Scene *scene_fixture_with_shape(const char *keyword, const FixtureValue *values, Error *error) {
    Scene *scene = scene_create(error);
    if (scene && !scene_fixture_add_shape(scene, keyword, values, error)) {
        scene_destroy(scene);
        scene = NULL;
    }
    return scene;
}

/** Makes a distance field. @param[out] field Of one instruction. @return false without memory, or
 * if there is no such field. */
static bool make_sdf_primitive(const char *name, const FixtureValue *assignments, Sdf *field) {
    const SdfPrimitive *const *kind = sdf_primitives;
    while (*kind && strcmp((*kind)->keyword.name, name) != 0) {
        kind++;
    }
    char *values = *kind ? malloc((*kind)->keyword.size) : NULL;
    if (!values) {
        return false;
    }
    memcpy(values, (*kind)->keyword.defaults, (*kind)->keyword.size);
    set_parameters(&(*kind)->keyword, assignments, values);
    (*kind)->create(field, values);
    free(values);
    return true;
}

/** Adds the surface of a distance field. @return false if anything is wrong. */
static bool add_sdf_surface(Scene *scene, const Sdf *field, Error *error) {
    size_t kind = scene_shape_find("sdf");
    const Keyword *keyword = scene_shape_keywords[kind];
    const Sdf *stored = scene_add_sdf(scene, field, error);
    char *values = stored ? malloc(keyword->size) : NULL;
    if (!values) {
        return error_set(error, STATUS_FAILED, "no memory for a shape");
    }
    memcpy(values, keyword->defaults, keyword->size);
    memcpy(values + keyword->parameters->offset, &stored,
           sizeof stored); // The field is its first parameter.
    bool is_added = scene_add_shape(scene, kind, keyword, values, 0, error);
    free(values);
    return is_added;
}

Scene *scene_fixture_with_sdf(const char *name, const FixtureValue *values, Vec3d offset,
                              Error *error) {
    Sdf *field = calloc(1, sdf_size(1)), *moved = calloc(1, sdf_size(2));
    Scene *scene = scene_create(error);
    bool is_made = field && moved && scene && make_sdf_primitive(name, values, field);
    if (is_made) {
        sdf_translate(moved, field, offset);
        is_made = add_sdf_surface(scene, moved, error);
    }
    free(field);
    free(moved);
    if (!is_made) {
        scene_destroy(scene);
        scene = NULL;
    }
    return scene;
}

Scene *scene_fixture_with_mesh(Mesh *mesh, Error *error) {
    const SceneFile file = {.path = "lab", .name = "lab", .location = "lab"};
    const FixtureValue values[] = {{"file", {0}}, {0}};
    size_t index = 0;
    Scene *scene = scene_create(error);
    if (!scene || !scene_add_mesh(scene, &file, &index, error)) {
        scene_destroy(scene);
        mesh_release(mesh);
        return NULL;
    }
    mesh_update_bounds(mesh);
    scene->meshes[index].mesh = mesh;
    if (!scene_fixture_add_shape(scene, "mesh", values, error)) {
        scene_destroy(scene);
        return NULL;
    }
    return scene;
}
