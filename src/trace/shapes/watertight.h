/**
 * @file
 * @brief Watertight intersection with convex polygons (Woop, Benthin, Wald, *Watertight
 * Ray/Triangle Intersection*, JCGT 2013).
 *
 * The vertices are translated to the origin of the ray and sheared so that the ray runs along one
 * axis. The sign of a two-dimensional cross product then is the side on which the ray passes an
 * edge. Two polygons with a common edge compute the same product for it, with opposite sign: a ray
 * between them meets at least one. Contraction to fused multiply-add would break this; it is
 * switched off.
 */
#ifndef DIOPTRE_TRACE_SHAPES_WATERTIGHT_H
#define DIOPTRE_TRACE_SHAPES_WATERTIGHT_H

#include "trace/bvh/slab.h"
#include "trace/math/pack.h"
#include "trace/shapes/support.h"

/** A vertex in the engine's number type. */
typedef struct Vertex {
    scalar xyz[3]; /**< Along x, y and z. */
} Vertex;

/** A vertex in the sheared coordinates of LANES rays, across the ray. */
typedef struct ShearedVertex {
    real u; /**< Along the first axis across. */
    real v; /**< Along the second axis across. */
} ShearedVertex;

/** @return A vertex, rounded. */
static inline Vertex vertex_of(Vec3d v) {
    return (Vertex){{(scalar)v.x, (scalar)v.y, (scalar)v.z}};
}

/** @return A vertex, exactly. */
static inline Vec3sw vertex_widen(Vertex vertex) {
    return (Vec3sw){(wide_scalar)vertex.xyz[0], (wide_scalar)vertex.xyz[1],
                    (wide_scalar)vertex.xyz[2]};
}

/** @return The bounding box of vertices, by #aabbs_padded. */
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

/** @return How far a vertex reaches. */
INLINE real support_of_vertex(Vertex vertex, Vec3s from, Vec3 directions) {
    return support_of_point(support_vector(from, vertex_widen(vertex)), 0, directions);
}

/** @return How far vertices reach. See #ShapeClass.support. */
INLINE real vertices_support(const Vertex *vertices, int count, Vec3s from, Vec3 directions) {
    real reach = support_of_vertex(vertices[0], from, directions);
    for (int i = 1; i < count; i++) {
        reach = real_max(support_of_vertex(vertices[i], from, directions), reach);
    }
    return reach;
}

/** The shear of rays, in axes permuted so that z is their dominant axis. */
typedef struct RayShear {
    Vec3 origin;  /**< Origins. */
    real shear_x; /**< Direction x / z, at most about 1. */
    real shear_y; /**< Direction y / z. */
} RayShear;

/** @return A vector with cyclically permuted axes. @param axis The axis that becomes z: 0, 1 or 2.
 */
INLINE Vec3 permute_axes(Vec3 v, int axis) {
    return axis == 0 ? (Vec3){v.y, v.z, v.x} : axis == 1 ? (Vec3){v.z, v.x, v.y} : v;
}

/** @return The shear of rays. @param axis Their dominant axis. */
INLINE RayShear ray_shear_of(const Ray *ray, int axis) {
    Vec3 main_axes = permute_axes(ray->direction, axis),
         inverse = permute_axes(ray->inverse_direction, axis);
    return (RayShear){permute_axes(ray->origin, axis), main_axes.x * inverse.z,
                      main_axes.y * inverse.z};
}

/** @return A vertex in sheared coordinates. @param vertex Vertices in permuted axes. */
INLINE ShearedVertex ray_shear_vertex(Vec3 vertex, const RayShear *shear) {
    real depth = vertex.z - shear->origin.z;
    return (ShearedVertex){(vertex.x - shear->origin.x) - shear->shear_x * depth,
                           (vertex.y - shear->origin.y) - shear->shear_y * depth};
}

/** @return The side on which rays pass an edge: above 0 left, below 0 right, 0 on it. It is twice
 * the area between edge and ray. */
INLINE real edge_function(ShearedVertex from, ShearedVertex to) {
    return from.u * to.v - from.v * to.u;
}

/**
 * @return The lanes whose line passes inside a convex polygon or through its edge.
 * @param sheared  Vertices in sheared coordinates, in turn.
 * @param count    Number of vertices, 3 or 4.
 */
INLINE mask edge_functions_contain_ray(const ShearedVertex *sheared, int count) {
    real lowest = edge_function(sheared[count - 1], sheared[0]), highest = lowest;
    for (int i = 0; i < count - 1; i++) {
        real side = edge_function(sheared[i], sheared[i + 1]);
        lowest = real_min(side, lowest);
        highest = real_max(side, highest);
    }
    // Not both: where all are 0, the vertices are one point, or the ray is in their plane.
    return (lowest >= 0) ^ (highest <= 0);
}

/** #polygon_contains_ray for rays with one dominant axis. */
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

/** The lanes by the dominant axis of their direction. */
typedef struct DominantAxes {
    mask x; /**< Lanes with x. */
    mask y; /**< Lanes with y. */
    mask z; /**< Lanes with z. */
} DominantAxes;

/** @return The active lanes by dominant axis. */
INLINE DominantAxes ray_dominant_axes(const Ray *ray, mask active) {
    real x = real_abs(ray->direction.x), y = real_abs(ray->direction.y);
    real z = real_abs(ray->direction.z);
    mask along_z = active & (z >= x) & (z >= y);
    mask along_x = active & mask_not(along_z) & (x >= y);
    return (DominantAxes){along_x, active & mask_not(along_x | along_z), along_z};
}

/** @return The dominant axis of a direction, by the same rule as ray_dominant_axes(). */
INLINE int ray_dominant_axis(const Vec3 *direction, int lane) {
    scalar x = scalar_abs(real_at(&direction->x, lane)),
           y = scalar_abs(real_at(&direction->y, lane)),
           z = scalar_abs(real_at(&direction->z, lane));
    return z >= x && z >= y ? 2 : x >= y ? 0 : 1;
}

/** @return The lanes whose line passes inside a convex polygon or through its edge. @param count
 *  Number of vertices, 3 or 4. */
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

/** Corners of a quad. */
enum { QUAD_CORNERS = 4 };

// Not for quadruple precision, whose packs are of float.
#if LANES == 1 && REAL_BITS <= 64

/** Number of packs with a number of each corner. */
enum { QUAD_PACKS = QUAD_CORNERS / PACK_LANES };

/** The corners of a quad. */
typedef struct QuadCorners {
    Vertex vertices[QUAD_CORNERS]; /**< The corners, in turn. */
    PackReal xyz[3][QUAD_PACKS];   /**< The same along x, y and z. */
} QuadCorners;

/** @return The corners of a quad. @param vertices In turn. */
static inline QuadCorners quad_corners_of(const Vertex vertices[QUAD_CORNERS]) {
    QuadCorners corners;
    for (int i = 0; i < QUAD_CORNERS; i++) {
        corners.vertices[i] = vertices[i];
        for (int axis = 0; axis < 3; axis++) {
            pack_set_lane(corners.xyz[axis], i, vertices[i].xyz[axis]);
        }
    }
    return corners;
}

/** @return Of each corner the number of the next one. @param i Which of the packs. */
INLINE PackReal quad_pack_next(const PackReal packs[QUAD_PACKS], int i) {
#if REAL_BITS == 32
    return __builtin_shufflevector(packs[i], packs[i], 1, 2, 3, 0);
#else
    return __builtin_shufflevector(packs[i], packs[1 - i], 1, 2);
#endif
}

/** #polygon_contains_ray for a quad: the ray passes all edges at once, with the same bits. */
INLINE mask quad_contains_ray(const QuadCorners *corners, const Ray *ray, mask active) {
    const int axis = ray_dominant_axis(&ray->direction, 0);
    const RayShear shear = ray_shear_of(ray, axis);
    const PackReal *x = corners->xyz[(axis + 1) % 3], *y = corners->xyz[(axis + 2) % 3],
                   *z = corners->xyz[axis];
    PackReal u[QUAD_PACKS], v[QUAD_PACKS], side;
    for (int i = 0; i < QUAD_PACKS; i++) {
        PackReal depth = z[i] - shear.origin.z;
        u[i] = (x[i] - shear.origin.x) - shear.shear_x * depth;
        v[i] = (y[i] - shear.origin.y) - shear.shear_y * depth;
    }
    unsigned below = 0, above = 0;
    for (int i = 0; i < QUAD_PACKS; i++) {
        side = u[i] * quad_pack_next(v, i) - v[i] * quad_pack_next(u, i);
        below |= PACK_BITS(side < 0);
        above |= PACK_BITS(side > 0);
    }
    // edge_functions_contain_ray() ignores a NaN, but not that of the last edge.
    const pack_scalar last = side[PACK_LANES - 1];
    return active & (last == last) & ((below == 0) ^ (above == 0));
}

#else

/** The corners of a quad. */
typedef struct QuadCorners {
    Vertex vertices[QUAD_CORNERS]; /**< The corners, in turn. */
} QuadCorners;

/** @return The corners of a quad. @param vertices In turn. */
static inline QuadCorners quad_corners_of(const Vertex vertices[QUAD_CORNERS]) {
    return (QuadCorners){{vertices[0], vertices[1], vertices[2], vertices[3]}};
}

/** #polygon_contains_ray for a quad. */
INLINE mask quad_contains_ray(const QuadCorners *corners, const Ray *ray, mask active) {
    return polygon_contains_ray(corners->vertices, QUAD_CORNERS, ray, active);
}

#endif

/** The edges of a polygon of four corners, one in each of the first lanes. */
typedef struct PolygonEdges {
    Vec3 from; /**< Where they start. */
    Vec3 to;   /**< Where they end. */
} PolygonEdges;

/** @return The edges of a quad; further lanes repeat them. @param corners In turn. */
static inline PolygonEdges quad_edges_of(const Vertex *corners) {
    PolygonEdges edges = {0};
    for (int i = 0; i < LANES; i++) {
        const scalar *from = corners[i % QUAD_CORNERS].xyz,
                     *to = corners[(i + 1) % QUAD_CORNERS].xyz;
        real_set_lane(&edges.from.x, i, from[0]);
        real_set_lane(&edges.from.y, i, from[1]);
        real_set_lane(&edges.from.z, i, from[2]);
        real_set_lane(&edges.to.x, i, to[0]);
        real_set_lane(&edges.to.y, i, to[1]);
        real_set_lane(&edges.to.z, i, to[2]);
    }
    return edges;
}

/**
 * Bound on all roundings, relative to the lengths of the two corners of an edge, seen from the ray,
 * and of the direction: those of polygon_contains_ray() come to 34, of a ray's direction to 10, of
 * polygon_covers_beam() to 20.
 */
#define COVER_SLACK (128 * ROUNDOFF)

/**
 * @return Whether polygon_contains_ray() holds for all rays of a beam. A ray passes an edge on the
 *         side that the sign of d . (a x b) says, for its direction d and the corners a and b as
 *         seen from its origin. That is linear in d: over a beam it is least at a corner.
 */
static inline bool polygon_covers_beam(const PolygonEdges *edges, const Beam *beam) {
    Vec3 origin = vec3_splat(beam->origin), a = vec3_subtract(edges->from, origin),
         b = vec3_subtract(edges->to, origin);
    Vec3 n = vec3_cross(a, b);
    real side = vec3_dot(n, vec3_splat(beam->axis));
    real spread = real_abs(vec3_dot(n, vec3_splat(beam->across))) +
                  real_abs(vec3_dot(n, vec3_splat(beam->up)));
    real length =
        real_of(vec3s_abs_sum(beam->axis) + vec3s_abs_sum(beam->across) + vec3s_abs_sum(beam->up));
    real least = spread + COVER_SLACK * length * vec3_abs_sum(a) * vec3_abs_sum(b);
    return mask_bits(side > least) == ALL_LANES || mask_bits(-side > least) == ALL_LANES;
}

/** @return The rays inside the edges of a polygon that meet its bounding box, too. Beside a polygon
 *  that is smaller than the roundings of the vectors to its vertices, an edge function can have any
 *  sign: without the box, such a speck is hit from afar. @param inside The rays inside the edges.
 */
INLINE mask polygon_rays_in_box(const Aabbs *bounds, const Ray *ray, mask inside) {
    const Aabb box = aabb_splat(*bounds);
    real near;
    return inside & slab_intersects(ray, &box, real_of(INFINITE), &near);
}

#endif
