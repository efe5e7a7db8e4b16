/**
 * @file
 * @brief Watertight polygons: on which side of each edge a ray passes.
 *
 * The corners are moved so that the ray starts at zero, and sheared so that it runs along one axis;
 * on which side of an edge it passes is then the sign of a product of two plane vectors. Two
 * polygons that share an edge compute the same products of it, with opposite sign, so a ray between
 * them meets at least one (Woop, Benthin, Wald, *Watertight Ray/Triangle Intersection*, JCGT 2013).
 * Contraction to fused multiply-add would break this: the program is built without.
 */
#ifndef DIOPTRE_TRACE_SHAPES_SHEAR_H
#define DIOPTRE_TRACE_SHAPES_SHEAR_H

#include "trace/shape.h"

/** A corner in the engine's number type. */
typedef struct Corner {
    scalar at[3]; /**< Along x, y and z. */
} Corner;

/** A corner as LANES rays see it: how far beside the ray it lies. */
typedef struct Offset {
    real u; /**< Beside the ray, along the first of the other two axes. */
    real v; /**< Beside the ray, along the second. */
} Offset;

/** @return A corner. @param v A point of the scene. */
static inline Corner corner_of(Vector3 v) {
    return (Corner){{(scalar)v.x, (scalar)v.y, (scalar)v.z}};
}

/** @return A corner, exactly. @param corner The corner. */
static inline WidePoint corner_widen(Corner corner) {
    return (WidePoint){(wide_scalar)corner.at[0], (wide_scalar)corner.at[1],
                       (wide_scalar)corner.at[2]};
}

/** @return The box around corners. @param corners The corners. @param count How many. */
static inline Bounds corners_bounds(const Corner *corners, int count) {
    Bounds box;
    for (int axis = 0; axis < 3; axis++) {
        box.low[axis] = box.high[axis] = corners[0].at[axis];
        for (int i = 1; i < count; i++) {
            scalar at = corners[i].at[axis];
            box.low[axis] = at < box.low[axis] ? at : box.low[axis];
            box.high[axis] = at > box.high[axis] ? at : box.high[axis];
        }
    }
    return bounds_outwards(box);
}

/** Rays, turned so that they run mainly along z. */
typedef struct Shear {
    Vector origin; /**< Where they start. */
    real slope_x;  /**< How far they go along x for each step along z, at most about 1. */
    real slope_y;  /**< How far they go along y. */
} Shear;

/** @return A vector with its axes renamed in a circle. @param v It. @param axis What becomes z:
 *  0, 1 or 2 for x, y or z. */
INLINE Vector shear_turn(Vector v, int axis) {
    return axis == 0 ? (Vector){v.y, v.z, v.x} : axis == 1 ? (Vector){v.z, v.x, v.y} : v;
}

/** @return Rays turned. @param ray The rays. @param axis The axis that they run mainly along. */
INLINE Shear shear_of(const Ray *ray, int axis) {
    Vector along = shear_turn(ray->direction, axis), inverse = shear_turn(ray->inverse, axis);
    return (Shear){shear_turn(ray->origin, axis), along.x * inverse.z, along.y * inverse.z};
}

/**
 * @return How far beside the rays corners lie.
 * @param corner  The corners, turned.
 * @param shear   The rays.
 */
INLINE Offset shear_offset(Vector corner, const Shear *shear) {
    real depth = corner.z - shear->origin.z;
    return (Offset){(corner.x - shear->origin.x) - shear->slope_x * depth,
                    (corner.y - shear->origin.y) - shear->slope_y * depth};
}

/**
 * @return On which side of an edge the rays pass: above 0 to the left, below 0 to the right, 0 on
 *         it; twice the area between the edge and the ray.
 * @param from  One end of the edge.
 * @param to    The other.
 */
INLINE real shear_side(Offset from, Offset to) {
    return from.u * to.v - from.v * to.u;
}

/**
 * @return The lanes whose ray passes inside a convex polygon or through its edge. The line counts,
 *         forwards and backwards.
 * @param offsets  How far beside the rays the corners lie, in turn.
 * @param count    How many, 3 or 4.
 */
INLINE mask shear_surrounds(const Offset *offsets, int count) {
    real lowest = shear_side(offsets[count - 1], offsets[0]), highest = lowest;
    for (int i = 0; i < count - 1; i++) {
        real side = shear_side(offsets[i], offsets[i + 1]);
        lowest = real_min(side, lowest);
        highest = real_max(side, highest);
    }
    return (lowest >= 0) | (highest <= 0);
}

/**
 * @return The lanes whose ray passes inside a convex polygon, for rays that run mainly along one
 *         axis.
 * @param corners  The corners, in turn.
 * @param count    How many, 3 or 4.
 * @param ray      The rays.
 * @param axis     The axis.
 */
INLINE mask shear_is_inside_along(const Corner *corners, int count, const Ray *ray, int axis) {
    Shear shear = shear_of(ray, axis);
    Offset offsets[4];
    for (int i = 0; i < count; i++) {
        const scalar *at = corners[i].at;
        Vector corner = {real_of(at[0]), real_of(at[1]), real_of(at[2])};
        offsets[i] = shear_offset(shear_turn(corner, axis), &shear);
    }
    return shear_surrounds(offsets, count);
}

/** Which lanes run mainly along which axis. */
typedef struct MainAxes {
    mask x; /**< Along x. */
    mask y; /**< Along y. */
    mask z; /**< Along z. */
} MainAxes;

/** @return Which lanes run mainly along which axis. @param ray The rays. @param active The lanes
 * that count. */
INLINE MainAxes shear_main_axes(const Ray *ray, mask active) {
    real x = real_abs(ray->direction.x), y = real_abs(ray->direction.y);
    real z = real_abs(ray->direction.z);
    mask along_z = active & (z >= x) & (z >= y);
    mask along_x = active & mask_not(along_z) & (x >= y);
    return (MainAxes){along_x, active & mask_not(along_x | along_z), along_z};
}

/**
 * @return The lanes whose ray's line passes inside a convex polygon or through its edge.
 * @param corners  The corners, in turn.
 * @param count    How many, 3 or 4.
 * @param ray      The rays.
 * @param active   The lanes that count.
 */
INLINE mask shear_is_inside(const Corner *corners, int count, const Ray *ray, mask active) {
    MainAxes along = shear_main_axes(ray, active);
    mask inside = mask_of(false);
    if (any(along.x)) {
        inside = along.x & shear_is_inside_along(corners, count, ray, 0);
    }
    if (any(along.y)) {
        inside |= along.y & shear_is_inside_along(corners, count, ray, 1);
    }
    if (any(along.z)) {
        inside |= along.z & shear_is_inside_along(corners, count, ray, 2);
    }
    return inside;
}

#endif
