/**
 * @file
 * @brief Values in place of those that a scene file gives: what a user changes in the window.
 *
 * A scene file runs again with its overrides: the call that makes an object gets them as if they
 * were written there. So they are read and checked like the file's own values.
 */
#ifndef DIOPTRE_SCENE_OVERRIDE_H
#define DIOPTRE_SCENE_OVERRIDE_H

#include "dioptre/scene.h"

/** Most overrides of a scene. */
enum { SCENE_OVERRIDES_MAXIMUM = 1024 };

/** A value in place of one of the file. */
typedef struct SceneOverride {
    int keyword; /**< The keyword that made the object: an index, see #scene_object_keyword. */
    int number;  /**< #SceneOrigin.number of the object, from 1. */
    int row;     /**< The field, see #scene_object_row. */
    double numbers[PARAMETER_NUMBERS_MAXIMUM]; /**< The value, see #parameter_get_numbers. */
} SceneOverride;

/** @return Whether two overrides are of the same field of the same object. */
static inline bool scene_override_is_same_field(const SceneOverride *a, const SceneOverride *b) {
    return a->keyword == b->keyword && a->number == b->number && a->row == b->row;
}

/** An object of a scene: a shape, a light or a material. */
typedef struct SceneObject {
    int keyword;                /**< See #SceneOverride.keyword. */
    size_t index;               /**< Index in the scene's shapes, lights or materials. */
    const void *values;         /**< The struct of its keyword. */
    const Transform *transform; /**< Of a shape; NULL: none. */
    const SceneOrigin *origin;  /**< The call that made it. */
} SceneObject;

/** @return The keyword of an index: shapes, then lights, then the material; NULL beyond. */
const Keyword *scene_object_keyword(int index);

/** @return The index of a keyword by its name; -1: no object has it. */
int scene_object_keyword_find(const char *name);

/** @return Whether objects of a keyword are shapes. */
bool scene_object_is_shape(int keyword);

/** @return A field of objects of a keyword; of shapes, those of #transform_keyword follow their
 *  own. NULL: beyond the last, or the keyword does not exist. */
const Parameter *scene_object_row(int keyword, int row);

/** @return The row of a field by its name; -1: there is none. */
int scene_object_row_find(int keyword, const char *name);

/** @return A shape as an object. */
SceneObject scene_object_of_shape(const Scene *scene, size_t index);

/** @return A light as an object. */
SceneObject scene_object_of_light(const Scene *scene, size_t index);

/** @return A material as an object. */
SceneObject scene_object_of_material(const Scene *scene, size_t index);

/** Finds an object. @param[out] object The object. @return false if the scene has none. */
bool scene_object_find(const Scene *scene, int keyword, int number, SceneObject *object);

/** Reads the value of a field. @param[out] numbers See #parameter_get_numbers. */
void scene_object_get(const SceneObject *object, int row, double *numbers);

/**
 * Checks overrides of one object as a scene file's values are checked.
 * @param overrides   All overrides of the scene; those of other objects are left out.
 * @param[out] error  What is wrong.
 * @return Whether the file could have given these values.
 */
bool scene_override_check(const SceneObject *object, const SceneOverride *overrides, size_t count,
                          Error *error);

#endif
