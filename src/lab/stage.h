/**
 * @file
 * @brief Small scenes, in which the tracer's own engines are asked what the methods are asked.
 */
#ifndef DIOPTRE_LAB_STAGE_H
#define DIOPTRE_LAB_STAGE_H

#include "dioptre/scene.h"

/** A field of a shape and its value. */
typedef struct StageValue {
    const char *name;  /**< As in a scene file; NULL ends a list. */
    double numbers[3]; /**< A number or a boolean has the first alone. */
} StageValue;

/**
 * Makes a scene with one shape.
 * @param keyword     The shape's, such as `sphere`.
 * @param values      Its fields, ended by one without a name.
 * @param[out] error  What is wrong.
 * @return The scene, to be given back with scene_destroy; NULL if anything is wrong.
 */
Scene *stage_with(const char *keyword, const StageValue *values, Error *error);

/**
 * Makes a scene with the surface of one field, of the tolerance that surfaces have.
 * @param name        The field's keyword, such as `distance.sphere`.
 * @param values      Its fields, ended by one without a name.
 * @param way         How far it is moved, scene units.
 * @param[out] error  What is wrong.
 * @return The scene, to be given back with scene_destroy; NULL if anything is wrong.
 */
Scene *stage_with_field(const char *name, const StageValue *values, Vector3 way, Error *error);

/**
 * Makes a scene with one model.
 * @param mesh        Its triangles; the scene's from now on, whatever happens.
 * @param[out] error  What is wrong.
 * @return The scene, to be given back with scene_destroy; NULL if anything is wrong.
 */
Scene *stage_with_mesh(Mesh *mesh, Error *error);

#endif
