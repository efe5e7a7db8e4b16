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

/** @return The box around corners. @param corners The corners. @param count How many. */
static inline Bounds corners_bounds(const Corner *corners, int count) {
    Corner low = corners[0], high = corners[0];
    for (int i = 1; i < count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            scalar at = corners[i].at[axis];
            low.at[axis] = at < low.at[axis] ? at : low.at[axis];
            high.at[axis] = at > high.at[axis] ? at : high.at[axis];
        }
    }
    return bounds_around((Vector3){(double)low.at[0], (double)low.at[1], (double)low.at[2]},
                         (Vector3){(double)high.at[0], (double)high.at[1], (double)high.at[2]});
}

/**
 * @return The rays with their axes renamed in a circle, so that a given axis becomes z.
 * @param ray   The rays.
 * @param axis  0, 1 or 2 for x, y or z.
 */
INLINE Ray shear_turn(const Ray *ray, int axis) {
    Vector o = ray->origin, d = ray->direction, i = ray->inverse;
    if (axis == 0) {
        return (Ray){{o.y, o.z, o.x}, {d.y, d.z, d.x}, {i.y, i.z, i.x}};
    }
    if (axis == 1) {
        return (Ray){{o.z, o.x, o.y}, {d.z, d.x, d.y}, {i.z, i.x, i.y}};
    }
    return *ray;
}

/**
 * @return How far beside the rays a corner lies.
 * @param corner  The corner.
 * @param turned  The rays, turned so that they run mainly along z.
 * @param axis    The axis that z was.
 */
INLINE Offset shear_offset(const Corner *corner, const Ray *turned, int axis) {
    real x = real_of(corner->at[(axis + 1) % 3]), y = real_of(corner->at[(axis + 2) % 3]);
    real depth = (real_of(corner->at[axis]) - turned->origin.z) * turned->inverse.z;
    return (Offset){(x - turned->origin.x) - turned->direction.x * depth,
                    (y - turned->origin.y) - turned->direction.y * depth};
}

/**
 * @return The lanes whose ray passes inside a convex polygon or through its edge, for rays that run
 *         mainly along one axis. The line counts, forwards and backwards.
 * @param corners  The corners, in turn.
 * @param count    How many, 3 or 4.
 * @param ray      The rays.
 * @param axis     The axis.
 */
INLINE mask shear_is_inside_along(const Corner *corners, int count, const Ray *ray, int axis) {
    Ray turned = shear_turn(ray, axis);
    Offset first = shear_offset(&corners[0], &turned, axis), from = first;
    mask is_left = mask_of(true), is_right = mask_of(true);
    for (int i = 1; i <= count; i++) {
        Offset to = i < count ? shear_offset(&corners[i], &turned, axis) : first;
        real side = from.u * to.v - from.v * to.u;
        is_left &= side >= 0;
        is_right &= side <= 0;
        from = to;
    }
    return is_left | is_right;
}

/**
 * @return The lanes whose ray's line passes inside a convex polygon or through its edge.
 * @param corners  The corners, in turn.
 * @param count    How many, 3 or 4.
 * @param ray      The rays.
 * @param active   The lanes that count.
 */
INLINE mask shear_is_inside(const Corner *corners, int count, const Ray *ray, mask active) {
    real x = real_abs(ray->direction.x), y = real_abs(ray->direction.y);
    real z = real_abs(ray->direction.z);
    mask mainly_z = active & (z >= x) & (z >= y);
    mask mainly_x = active & mask_not(mainly_z) & (x >= y);
    mask mainly_y = active & mask_not(mainly_x | mainly_z);
    mask inside = mask_of(false);
    if (any(mainly_x)) {
        inside = mainly_x & shear_is_inside_along(corners, count, ray, 0);
    }
    if (any(mainly_y)) {
        inside |= mainly_y & shear_is_inside_along(corners, count, ray, 1);
    }
    if (any(mainly_z)) {
        inside |= mainly_z & shear_is_inside_along(corners, count, ray, 2);
    }
    return inside;
}

#endif
