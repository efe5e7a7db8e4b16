/**
 * @file
 * @brief Objects of a scene by the calls that made them, and overrides of their fields.
 */
#include "dioptre/scene_override.h"

#include <stdalign.h>
#include <string.h>

/** Bytes of the largest struct of a keyword; #scene_override_check copies it. */
enum { STRUCT_SIZE_MAXIMUM = 1024 };

/** @return Number of classes of shapes. */
static int shape_class_count(void) {
    int count = 0;
    while (scene_shape_keywords[count]) {
        count++;
    }
    return count;
}

/** @return Number of classes of lights. */
static int light_class_count(void) {
    int count = 0;
    while (scene_light_classes[count]) {
        count++;
    }
    return count;
}

const Keyword *scene_object_keyword(int index) {
    int shapes = shape_class_count(), lights = light_class_count();
    if (index < 0 || index > shapes + lights) {
        return NULL;
    }
    if (index < shapes) {
        return scene_shape_keywords[index];
    }
    return index < shapes + lights ? scene_light_classes[index - shapes]->keyword
                                   : &scene_material_keyword;
}

int scene_object_keyword_find(const char *name) {
    const Keyword *keyword;
    for (int i = 0; (keyword = scene_object_keyword(i)); i++) {
        if (strcmp(keyword->name, name) == 0) {
            return i;
        }
    }
    return -1;
}

bool scene_object_is_shape(int keyword) {
    return keyword >= 0 && keyword < shape_class_count();
}

/** @return Number of rows of a keyword. */
static int row_count(const Keyword *keyword) {
    int count = 0;
    while (keyword->parameters[count].name) {
        count++;
    }
    return count;
}

const Parameter *scene_object_row(int keyword, int row) {
    const Keyword *own = scene_object_keyword(keyword);
    int count = own ? row_count(own) : 0;
    if (row >= 0 && row < count) {
        return &own->parameters[row];
    }
    bool is_transform = own && scene_object_is_shape(keyword) && row >= count &&
                        row - count < row_count(&transform_keyword);
    return is_transform ? &transform_keyword.parameters[row - count] : NULL;
}

int scene_object_row_find(int keyword, const char *name) {
    const Parameter *row;
    for (int i = 0; (row = scene_object_row(keyword, i)); i++) {
        if (strcmp(row->name, name) == 0) {
            return i;
        }
    }
    return -1;
}

SceneObject scene_object_of_shape(const Scene *scene, size_t index) {
    const SceneShape *shape = &scene->shapes[index];
    return (SceneObject){.keyword = (int)shape->class_index,
                         .index = index,
                         .values = shape->parameters,
                         .transform = shape->transform,
                         .origin = &shape->origin};
}

SceneObject scene_object_of_light(const Scene *scene, size_t index) {
    const SceneLight *light = &scene->lights[index];
    return (SceneObject){.keyword = shape_class_count() + (int)light->class_index,
                         .index = index,
                         .values = light,
                         .origin = &light->origin};
}

SceneObject scene_object_of_material(const Scene *scene, size_t index) {
    const SceneMaterial *material = &scene->materials[index];
    return (SceneObject){.keyword = shape_class_count() + light_class_count(),
                         .index = index,
                         .values = material,
                         .origin = &material->origin};
}

bool scene_object_find(const Scene *scene, int keyword, int number, SceneObject *object) {
    SceneObject (*of)(const Scene *, size_t) = scene_object_of_material;
    size_t count = scene->material_count;
    if (scene_object_is_shape(keyword)) {
        of = scene_object_of_shape;
        count = scene->shape_count;
    } else if (keyword < shape_class_count() + light_class_count()) {
        of = scene_object_of_light;
        count = scene->light_count;
    }
    for (size_t i = 0; i < count && number > 0; i++) {
        *object = of(scene, i);
        if (object->keyword == keyword && object->origin->number == number) {
            return true;
        }
    }
    return false;
}

/** @return Whether a row is one of #transform_keyword. */
static bool is_transform_row(const Parameter *row) {
    uintptr_t start = (uintptr_t)transform_keyword.parameters;
    return (uintptr_t)row >= start &&
           (uintptr_t)row < start + (size_t)row_count(&transform_keyword) * sizeof *row;
}

void scene_object_get(const SceneObject *object, int row, double *numbers) {
    const Parameter *parameter = scene_object_row(object->keyword, row);
    const void *values = object->values;
    if (is_transform_row(parameter)) {
        values = object->transform ? (const void *)object->transform : transform_keyword.defaults;
    }
    parameter_get_numbers(parameter, values, numbers);
}

/** A copy of an object, with its overrides. */
typedef struct ObjectCopy {
    alignas(max_align_t) char values[STRUCT_SIZE_MAXIMUM]; /**< Struct of its keyword. */
    Transform transform;                                   /**< Its transform. */
    uint64_t given; /**< Rows of the keyword that are given. */
} ObjectCopy;

/** Gives a copy a value. @return Whether the value is valid by itself. */
static bool copy_set(ObjectCopy *copy, const SceneOverride *override, Error *error) {
    const Parameter *row = scene_object_row(override->keyword, override->row);
    if (!row || !parameter_check_numbers(row, override->numbers, error)) {
        return false;
    }
    if (is_transform_row(row)) {
        parameter_set_numbers(row, &copy->transform, override->numbers);
    } else {
        parameter_set_numbers(row, copy->values, override->numbers);
        copy->given |= (uint64_t)1 << override->row;
    }
    return true;
}

bool scene_override_check(const SceneObject *object, const SceneOverride *overrides, size_t count,
                          Error *error) {
    const Keyword *keyword = scene_object_keyword(object->keyword);
    ObjectCopy copy = {.given = object->origin->given};
    memcpy(copy.values, object->values, keyword->size);
    copy.transform =
        object->transform ? *object->transform : *(const Transform *)transform_keyword.defaults;
    for (size_t i = 0; i < count; i++) {
        bool is_own = overrides[i].keyword == object->keyword &&
                      overrides[i].number == object->origin->number;
        if (is_own && !copy_set(&copy, &overrides[i], error)) {
            return false;
        }
    }
    return (!keyword->finish || keyword->finish(copy.values, copy.given, error)) &&
           transform_keyword.finish(&copy.transform, 0, error);
}
