/**
 * @file
 * @brief A scene with other tolerances of its distance fields.
 */
#ifndef DIOPTRE_LAB_VARIATION_H
#define DIOPTRE_LAB_VARIATION_H

#include "dioptre/scene.h"

/** A scene that differs from another in its shapes only. */
typedef struct Variation {
    Scene scene;        /**< The scene; what is not of its own belongs to the other. */
    SceneShape *shapes; /**< Its shapes; owned. */
    char *parameters;   /**< Those that differ; owned. */
} Variation;

/** @return Whether a scene has shapes that are marched. @param scene The scene.
 *  @param keywords The shapes' keywords. */
bool variation_is_possible(const Scene *scene, const Keyword *const *keywords);

/**
 * Makes a scene whose tolerances are so many times as large.
 * @param[out] variation  The scene, to be given back with #variation_release before the other is.
 * @param scene           The other.
 * @param keywords        The shapes' keywords.
 * @param factor          How many times.
 * @param[out] error      What is wrong.
 * @return false without memory.
 */
bool variation_make(Variation *variation, const Scene *scene, const Keyword *const *keywords,
                    double factor, Error *error);

/** Gives back what is its own. @param variation It; may be empty. */
void variation_release(Variation *variation);

#endif
