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

/** @return A corner in all lanes, with its axes renamed as #shear_turn does. @param c The corner.
 *  @param axis The axis that becomes z. */
INLINE Vector shear_turn_corner(const Corner *c, int axis) {
    return (Vector){real_of(c->at[(axis + 1) % 3]), real_of(c->at[(axis + 2) % 3]),
                    real_of(c->at[axis])};
}

/**
 * @return How far beside the rays corners lie.
 * @param corner  The corners, turned.
 * @param turned  The rays, turned so that they run mainly along z.
 */
INLINE Offset shear_offset(Vector corner, const Ray *turned) {
    real depth = (corner.z - turned->origin.z) * turned->inverse.z;
    return (Offset){(corner.x - turned->origin.x) - turned->direction.x * depth,
                    (corner.y - turned->origin.y) - turned->direction.y * depth};
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
    mask is_left = mask_of(true), is_right = mask_of(true);
    for (int i = 0; i < count; i++) {
        real side = shear_side(offsets[i], offsets[(i + 1) % count]);
        is_left &= side >= 0;
        is_right &= side <= 0;
    }
    return is_left | is_right;
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
    Ray turned = shear_turn(ray, axis);
    Offset offsets[4];
    for (int i = 0; i < count; i++) {
        offsets[i] = shear_offset(shear_turn_corner(&corners[i], axis), &turned);
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
