/**
 * @file
 * @brief Transforms of shapes: scale, rotation, translation.
 */
#ifndef DIOPTRE_TRANSFORM_H
#define DIOPTRE_TRANSFORM_H

#include "dioptre/parameter.h"

/**
 * Smallest absolute scale; its inverse is the largest: lengths times such a factor stay in the
 * range of float.
 */
#define SCALE_MINIMUM 1e-6

/** A transform. Filled through #transform_keyword. */
typedef struct Transform {
    Vec3d scale;         /**< Scale, applied first; negative: mirrored. */
    Vec3d rotate;        /**< Rotation about x, then y, then z, degrees. */
    Vec3d translate;     /**< Translation, applied last, scene units. */
    double matrix[3][3]; /**< Scale and rotation, row by row; set by #Keyword.finish. */
} Transform;

/** @return A transformed point. @param t The transform. @param p The point. */
static inline Vec3d transform_point(const Transform *t, Vec3d p) {
    const double v[3] = {p.x, p.y, p.z};
    double out[3] = {t->translate.x, t->translate.y, t->translate.z};
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++) {
            out[row] += t->matrix[row][column] * v[column];
        }
    }
    return (Vec3d){out[0], out[1], out[2]};
}

/** The fields of all shapes besides their own. */
extern const Keyword transform_keyword;

#endif
