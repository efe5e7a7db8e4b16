/**
 * @file
 * @brief Small scenes, in which the tracer's own engines are asked what the methods are asked.
 */
#ifndef DIOPTRE_LAB_SCENE_FIXTURE_H
#define DIOPTRE_LAB_SCENE_FIXTURE_H

#include "dioptre/scene.h"

/** A field of a shape and its value. */
typedef struct FixtureValue {
    const char *name;     /**< As in a scene file; NULL ends a list. */
    double components[3]; /**< A number or a boolean has the first alone. */
} FixtureValue;

/**
 * Makes a scene with one shape.
 * @param keyword  The shape's, such as `sphere`.
 * @param values  Its fields, ended by one without a name.
 * @return The scene, to be given back with scene_destroy; NULL if anything is wrong.
 */
Scene *scene_fixture_with_shape(const char *keyword, const FixtureValue *values, Error *error);

/**
 * Makes a scene with the surface of one field, of the tolerance that surfaces have.
 * @param name  The field's keyword, such as `distance.sphere`.
 * @param values  Its fields, ended by one without a name.
 * @param offset  How far it is moved, scene units.
 * @return The scene, to be given back with scene_destroy; NULL if anything is wrong.
 */
Scene *scene_fixture_with_sdf(const char *name, const FixtureValue *values, Vec3d offset,
                              Error *error);

/**
 * Makes a scene with one model.
 * @param mesh  Its triangles; the scene's from now on, whatever happens.
 * @return The scene, to be given back with scene_destroy; NULL if anything is wrong.
 */
Scene *scene_fixture_with_mesh(Mesh *mesh, Error *error);

#endif
