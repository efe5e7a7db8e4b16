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
#ifndef DIOPTRE_TRACE_SHAPES_WATERTIGHT_H
#define DIOPTRE_TRACE_SHAPES_WATERTIGHT_H

#include "trace/shapes/shape.h"

/** A corner in the engine's number type. */
typedef struct Vertex {
    scalar xyz[3]; /**< Along x, y and z. */
} Vertex;

/** A corner as LANES rays see it: how far beside the ray it lies. */
typedef struct ShearedVertex {
    real u; /**< Beside the ray, along the first of the other two axes. */
    real v; /**< Beside the ray, along the second. */
} ShearedVertex;

/** @return A corner. @param v A point of the scene. */
static inline Vertex vertex_of(Vec3d v) {
    return (Vertex){{(scalar)v.x, (scalar)v.y, (scalar)v.z}};
}

/** @return A corner, exactly. */
static inline Vec3sw vertex_widen(Vertex vertex) {
    return (Vec3sw){(wide_scalar)vertex.xyz[0], (wide_scalar)vertex.xyz[1],
                    (wide_scalar)vertex.xyz[2]};
}

/** @return The box around corners. */
static inline Aabbs vertices_bounds(const Vertex *vertices, int count) {
    Aabbs box;
    for (int axis = 0; axis < 3; axis++) {
        box.low[axis] = box.high[axis] = vertices[0].xyz[axis];
        for (int i = 1; i < count; i++) {
            scalar coordinates = vertices[i].xyz[axis];
            box.low[axis] = coordinates < box.low[axis] ? coordinates : box.low[axis];
            box.high[axis] = coordinates > box.high[axis] ? coordinates : box.high[axis];
        }
    }
    return aabbs_padded(box);
}

/** Rays, turned so that they run mainly along z. */
typedef struct RayShear {
    Vec3 origin;  /**< Where they start. */
    real shear_x; /**< How far they go along x for each step along z, at most about 1. */
    real shear_y; /**< How far they go along y. */
} RayShear;

/**
 * @return A vector with its axes renamed in a circle.
 * @param axis  What becomes z: 0, 1 or 2 for x, y or z.
 */
INLINE Vec3 permute_axes(Vec3 v, int axis) {
    return axis == 0 ? (Vec3){v.y, v.z, v.x} : axis == 1 ? (Vec3){v.z, v.x, v.y} : v;
}

/**
 * @return Rays turned.
 * @param axis  The axis that they run mainly along.
 */
INLINE RayShear ray_shear_of(const Ray *ray, int axis) {
    Vec3 main_axes = permute_axes(ray->direction, axis),
         inverse = permute_axes(ray->inverse_direction, axis);
    return (RayShear){permute_axes(ray->origin, axis), main_axes.x * inverse.z,
                      main_axes.y * inverse.z};
}

/** @return How far beside the rays corners lie. */
INLINE ShearedVertex ray_shear_vertex(Vec3 vertex, const RayShear *shear) {
    real depth = vertex.z - shear->origin.z;
    return (ShearedVertex){(vertex.x - shear->origin.x) - shear->shear_x * depth,
                           (vertex.y - shear->origin.y) - shear->shear_y * depth};
}

/**
 * @return On which side of an edge the rays pass: above 0 to the left, below 0 to the right, 0 on
 *         it; twice the area between the edge and the ray.
 * @param from  One end of the edge.
 */
INLINE real edge_function(ShearedVertex from, ShearedVertex to) {
    return from.u * to.v - from.v * to.u;
}

/**
 * @return The lanes whose ray passes inside a convex polygon or through its edge. The line counts,
 *         forwards and backwards.
 * @param sheared  How far beside the rays the corners lie, in turn.
 * @param count    How many, 3 or 4.
 */
INLINE mask edge_functions_contain_ray(const ShearedVertex *sheared, int count) {
    real lowest = edge_function(sheared[count - 1], sheared[0]), highest = lowest;
    for (int i = 0; i < count - 1; i++) {
        real side = edge_function(sheared[i], sheared[i + 1]);
        lowest = real_min(side, lowest);
        highest = real_max(side, highest);
    }
    return (lowest >= 0) | (highest <= 0);
}

/**
 * @return The lanes whose ray passes inside a convex polygon, for rays that run mainly along one
 *         axis.
 * @param count  How many, 3 or 4.
 */
INLINE mask polygon_contains_ray_along(const Vertex *vertices, int count, const Ray *ray,
                                       int axis) {
    RayShear shear = ray_shear_of(ray, axis);
    ShearedVertex sheared[4];
    for (int i = 0; i < count; i++) {
        const scalar *coordinates = vertices[i].xyz;
        Vec3 vertex = {real_of(coordinates[0]), real_of(coordinates[1]), real_of(coordinates[2])};
        sheared[i] = ray_shear_vertex(permute_axes(vertex, axis), &shear);
    }
    return edge_functions_contain_ray(sheared, count);
}

/** Which lanes run mainly along which axis. */
typedef struct DominantAxes {
    mask x; /**< Along x. */
    mask y; /**< Along y. */
    mask z; /**< Along z. */
} DominantAxes;

/** @return Which lanes run mainly along which axis. */
INLINE DominantAxes ray_dominant_axes(const Ray *ray, mask active) {
    real x = real_abs(ray->direction.x), y = real_abs(ray->direction.y);
    real z = real_abs(ray->direction.z);
    mask along_z = active & (z >= x) & (z >= y);
    mask along_x = active & mask_not(along_z) & (x >= y);
    return (DominantAxes){along_x, active & mask_not(along_x | along_z), along_z};
}

/**
 * @return The lanes whose ray's line passes inside a convex polygon or through its edge.
 * @param count  How many, 3 or 4.
 */
INLINE mask polygon_contains_ray(const Vertex *vertices, int count, const Ray *ray, mask active) {
    DominantAxes main_axes = ray_dominant_axes(ray, active);
    mask inside = mask_of(false);
    if (any(main_axes.x)) {
        inside = main_axes.x & polygon_contains_ray_along(vertices, count, ray, 0);
    }
    if (any(main_axes.y)) {
        inside |= main_axes.y & polygon_contains_ray_along(vertices, count, ray, 1);
    }
    if (any(main_axes.z)) {
        inside |= main_axes.z & polygon_contains_ray_along(vertices, count, ray, 2);
    }
    return inside;
}

#endif
