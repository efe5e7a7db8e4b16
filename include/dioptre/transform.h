/**
 * @file
 * @brief How a shape is stretched, turned and moved.
 */
#ifndef DIOPTRE_TRANSFORM_H
#define DIOPTRE_TRANSFORM_H

#include "dioptre/parameter.h"

/**
 * Nearest to zero that a scale may be, and its inverse the farthest: a length of the scene times
 * such a factor is still far from the ends of float.
 */
#define SCALE_MINIMUM 1e-6

/** What a scene file says of it, and the matrix that follows. Filled through #transform_keyword. */
typedef struct Transform {
    Vec3d scale;         /**< First it is made so many times as large; negative: mirrored. */
    Vec3d rotate;        /**< Then turned about x, then y, then z, degrees. */
    Vec3d translate;     /**< Then moved, scene units. */
    double matrix[3][3]; /**< Scale and rotation as a matrix, row by row; filled by the finish. */
} Transform;

/** @return Where a transform puts a point. @param t The transform. @param p The point. */
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

/** The fields that every shape takes besides its own. */
extern const Keyword transform_keyword;

#endif
