/**
 * @file
 * @brief The formulas of the rays of a pixel, with the numbers put in, and their sums.
 */
#ifndef DIOPTRE_RENDER_RAY_FORMULA_H
#define DIOPTRE_RENDER_RAY_FORMULA_H

#include "dioptre/renderer.h"

/** Bytes of a label with the final zero. */
enum { RAY_FORMULA_LABEL_SIZE = 64 };
/** Bytes of a formula with the final zero: three vectors and some words. */
enum { RAY_FORMULA_TEXT_SIZE = 256 };
/** Most formulas of a ray, and most terms of a sum; the rest is only counted. */
enum { RAY_FORMULAS_MAXIMUM = 48 };

/** A formula: what it gives, and how. */
typedef struct RayFormula {
    char label[RAY_FORMULA_LABEL_SIZE]; /**< What it gives, in the user's language. */
    char text[RAY_FORMULA_TEXT_SIZE];   /**< The formula with its numbers. */
} RayFormula;

/** Formulas of one ray. Starts as `{0}`: none. */
typedef struct RayFormulas {
    RayFormula items[RAY_FORMULAS_MAXIMUM]; /**< The formulas. */
    size_t count;                           /**< Number of #items. */
    size_t omitted;                         /**< Formulas for which there was no room. */
} RayFormulas;

/** The rays whose formulas are asked for. */
typedef struct RayFormulaInput {
    const Scene *scene;  /**< The scene. */
    const RayTree *tree; /**< The rays. */
    bool is_own; /**< Whether the tracer's own methods made them; a report's shading is given as one
                      number. */
} RayFormulaInput;

/**
 * Writes how a ray begins, where it ends, and what its surface does.
 * @param index  Of the ray in its tree.
 * @param[out] formulas  The formulas.
 */
void ray_formulas_write(const RayFormulaInput *input, size_t index, RayFormulas *formulas);

/**
 * Writes the sum that makes the colour of a ray: its own light, and the weighted colours of the
 * rays that it sends on.
 * @param index  Of the ray in its tree.
 * @param[out] sum  One term per entry; the last is the result.
 */
void ray_sum_write(const RayFormulaInput *input, size_t index, RayFormulas *sum);

/** @return The cosine of the angle of refraction by Snell's law; below 0 where reflection is total.
 *  @param surface A transparent surface. */
double ray_refraction_cosine(const RayTreeSurface *surface);

/** @return The normal of a surface on the side of the ray that hit it. */
Vec3d ray_front_normal(const RayTreeNode *ray);

#endif
