/**
 * @file
 * @brief Similarity transforms of distance fields, applied once per ray and not once per step.
 */
#ifndef DIOPTRE_TRACE_SDF_SIMILARITY_H
#define DIOPTRE_TRACE_SDF_SIMILARITY_H

#include "dioptre/sdf.h"
#include "trace/math/vec3.h"

/** A uniform scale, a rotation and a translation. */
typedef struct Similarity {
    bool is_present;    /**< Whether it is not the identity. */
    Vec3sw rows[3];     /**< From world to local: the inverse rotation, divided by the scale. */
    Vec3sw translation; /**< Origin of the local space. */
    wide_scalar scale;  /**< Scale. */
} Similarity;

/** @return The identity. */
static inline Similarity similarity_identity(void) {
    return (Similarity){false, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}, 1};
}

/** @return A local vector in world coordinates: the inverse is the transpose times the square of
 * the scale. */
static inline Vec3sw similarity_direction_to_world_s(const Similarity *similarity, Vec3sw v) {
    Vec3sw sum = {0, 0, 0}, zero = {0, 0, 0};
    const wide_scalar factors[3] = {v.x, v.y, v.z};
    for (int i = 0; i < 3; i++) {
        Vec3sw part =
            vec3sw_scale(similarity->rows[i], factors[i] * similarity->scale * similarity->scale);
        sum = vec3sw_subtract(sum, vec3sw_subtract(zero, part));
    }
    return sum;
}

/** Appends the transform of a #SDF_TRANSFORM node. @param[in,out] similarity The outer transform;
 *  afterwards the product. @param numbers Operands of the node. */
static inline void similarity_append(Similarity *similarity, const double *numbers) {
    // N2 (N1 (p - m1) - m2) = N2 N1 (p - (m1 + N1^-1 m2))
    const Vec3sw zero = {0, 0, 0};
    Vec3sw rows[3], translation = vec3sw_of((Vec3d){numbers[9], numbers[10], numbers[11]});
    Vec3sw local_translation = similarity_direction_to_world_s(similarity, translation);
    for (int i = 0; i < 3; i++) {
        const wide_scalar row[3] = {(wide_scalar)numbers[3 * i], (wide_scalar)numbers[3 * i + 1],
                                    (wide_scalar)numbers[3 * i + 2]};
        rows[i] = zero;
        for (int k = 0; k < 3; k++) {
            Vec3sw part = vec3sw_scale(similarity->rows[k], -row[k]);
            rows[i] = vec3sw_subtract(rows[i], part);
        }
    }
    similarity->is_present = true;
    similarity->translation =
        vec3sw_subtract(similarity->translation, vec3sw_subtract(zero, local_translation));
    similarity->scale *= (wide_scalar)numbers[12];
    for (int i = 0; i < 3; i++) {
        similarity->rows[i] = rows[i];
    }
}

/** @return Directions in local coordinates. */
INLINE Vec3w similarity_direction_to_local(const Similarity *similarity, Vec3w v) {
    return (Vec3w){vec3w_dot(vec3w_splat(similarity->rows[0]), v),
                   vec3w_dot(vec3w_splat(similarity->rows[1]), v),
                   vec3w_dot(vec3w_splat(similarity->rows[2]), v)};
}

/** @return Points in local coordinates. */
INLINE Vec3w similarity_point_to_local(const Similarity *similarity, Vec3w v) {
    return similarity_direction_to_local(similarity,
                                         vec3w_subtract(v, vec3w_splat(similarity->translation)));
}

/** @return Local directions in world coordinates, of the same length. */
INLINE Vec3w similarity_direction_to_world(const Similarity *similarity, Vec3w v) {
    const wide scale = wide_of(similarity->scale);
    Vec3w sum = vec3w_scale(vec3w_splat(similarity->rows[0]), v.x * scale);
    sum = vec3w_add_scaled(sum, vec3w_splat(similarity->rows[1]), v.y * scale);
    return vec3w_add_scaled(sum, vec3w_splat(similarity->rows[2]), v.z * scale);
}

/** @return Local points in world coordinates. */
INLINE Vec3w similarity_point_to_world(const Similarity *similarity, Vec3w v) {
    Vec3w turned = similarity_direction_to_world(similarity, v);
    return vec3w_add_scaled(vec3w_splat(similarity->translation), turned,
                            wide_of(similarity->scale));
}

#endif
