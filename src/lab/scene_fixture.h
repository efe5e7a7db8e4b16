/**
 * @file
 * @brief Scenes with one shape, in which the tracer's engines compute what methods compute.
 */
#ifndef DIOPTRE_LAB_SCENE_FIXTURE_H
#define DIOPTRE_LAB_SCENE_FIXTURE_H

#include "dioptre/scene.h"

/** A parameter of a shape and its value. */
typedef struct FixtureValue {
    const char *name;     /**< As in a scene file; NULL ends a list. */
    double components[3]; /**< A number or a boolean uses the first only. */
} FixtureValue;

/**
 * Makes a scene with one shape.
 * @param keyword  Its keyword, such as `sphere`.
 * @param values   Its parameters, ended by one without a name.
 * @return The scene, to be released with scene_destroy; NULL if anything is wrong.
 */
Scene *scene_fixture_with_shape(const char *keyword, const FixtureValue *values, Error *error);

/**
 * Adds a shape to a scene.
 * @param keyword_name  Its keyword, such as `sphere`.
 * @param assignments   Its parameters, ended by one without a name.
 * @return false if anything is wrong.
 */
bool scene_fixture_add_shape(Scene *scene, const char *keyword_name,
                             const FixtureValue *assignments, Error *error);

/**
 * Makes a scene with the surface of one distance field, with the default tolerance.
 * @param name    Keyword of the field, such as `distance.sphere`.
 * @param values  Its parameters, ended by one without a name.
 * @param offset  Its translation, scene units.
 * @return The scene, to be released with scene_destroy; NULL if anything is wrong.
 */
Scene *scene_fixture_with_sdf(const char *name, const FixtureValue *values, Vec3d offset,
                              Error *error);

/**
 * Makes a scene with one mesh.
 * @param mesh  Its triangles; the scene owns it, even if anything is wrong.
 * @return The scene, to be released with scene_destroy; NULL if anything is wrong.
 */
Scene *scene_fixture_with_mesh(Mesh *mesh, Error *error);

#endif
