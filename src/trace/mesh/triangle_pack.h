/**
 * @file
 * @brief LANES triangles, one per lane.
 *
 * The watertight edge test of all polygons (watertight.h) decides whether a ray meets a triangle.
 * The distance is that of its plane, in the wide precision relative to the origin of the ray, where
 * the differences of float vertices are exact.
 *
 * From far away, the rounding of the edge test exceeds the size of small triangles: a ray can pass
 * the test without meeting the bounding box, and whether the BVH reaches the triangle would depend
 * on its other boxes. A hit therefore also requires the triangle's own box: the shape of the BVH
 * then makes no difference.
 */
#ifndef DIOPTRE_TRACE_MESH_TRIANGLE_PACK_H
#define DIOPTRE_TRACE_MESH_TRIANGLE_PACK_H

#include "trace/bvh/slab.h"
#include "trace/shapes/watertight.h"

/** LANES triangles. */
typedef struct TrianglePack {
    Vec3 corners[3]; /**< Vertices, in turn. */
} TrianglePack;

/** Shears the vertices into the coordinates of the rays. @param axis Dominant axis of the rays. */
INLINE void triangle_pack_shear(const TrianglePack *triangle, const Ray *ray, int axis,
                                ShearedVertex *sheared) {
    RayShear shear = ray_shear_of(ray, axis);
    for (int i = 0; i < 3; i++) {
        sheared[i] = ray_shear_vertex(permute_axes(triangle->corners[i], axis), &shear);
    }
}

/** @return Normals of triangles, of any length. */
INLINE Vec3w triangle_pack_normal(const TrianglePack *triangle) {
    Vec3w a = vec3_widen(triangle->corners[0]);
    Vec3w u = vec3w_subtract(vec3_widen(triangle->corners[1]), a);
    Vec3w v = vec3w_subtract(vec3_widen(triangle->corners[2]), a);
    return vec3w_cross(u, v);
}

/** @return The distances at which rays cross planes. @param normal Normals of any length. */
INLINE real ray_plane_distance(Vec3w normal, Vec3w point, const Ray *ray) {
    Vec3w to_anchor = vec3w_subtract(point, vec3_widen(ray->origin));
    return narrow(vec3w_dot(normal, to_anchor) / vec3w_dot(normal, vec3_widen(ray->direction)));
}

/** Computes the bounds of three vertices along an axis, bit for bit as #vertices_bounds. */
INLINE void triangle_pack_axis_bounds(real a, real b, real c, real *low, real *high) {
    real lowest = real_min(a, real_min(b, c)), highest = real_max(a, real_max(b, c));
    real slack = AABB_ROUNDINGS * AABB_ROUNDOFF * real_max(highest, -lowest);
    *low = lowest - slack;
    *high = highest + slack;
}

/** @return Bounding boxes of triangles. */
INLINE Aabb triangle_pack_bounds(const TrianglePack *triangle) {
    const Vec3 *a = &triangle->corners[0], *b = &triangle->corners[1], *c = &triangle->corners[2];
    Aabb boxes;
    triangle_pack_axis_bounds(a->x, b->x, c->x, &boxes.planes[0], &boxes.planes[3]);
    triangle_pack_axis_bounds(a->y, b->y, c->y, &boxes.planes[1], &boxes.planes[4]);
    triangle_pack_axis_bounds(a->z, b->z, c->z, &boxes.planes[2], &boxes.planes[5]);
    return boxes;
}

/** @return Unit normals of triangles. */
INLINE Vec3 triangle_pack_unit_normal(const TrianglePack *triangle) {
    Vec3w n = triangle_pack_normal(triangle);
    wide scale = 1 / wide_sqrt(vec3w_dot(n, n));
    return (Vec3){narrow(n.x * scale), narrow(n.y * scale), narrow(n.z * scale)};
}

/** @return Barycentric coordinates of the hits, not normalised: the areas between the ray and the
 *  opposite edges. @param axis Dominant axis of the rays. */
INLINE Vec3 triangle_pack_barycentrics(const TrianglePack *triangle, const Ray *ray, int axis) {
    ShearedVertex sheared[3];
    triangle_pack_shear(triangle, ray, axis, sheared);
    return (Vec3){edge_function(sheared[1], sheared[2]), edge_function(sheared[2], sheared[0]),
                  edge_function(sheared[0], sheared[1])};
}

#endif
