/**
 * @file
 * @brief Points, normals and texture coordinates on the triangles of a mesh.
 */
#include "trace/mesh/mesh_bvh_hit.h"

#include "trace/mesh/triangle_pack.h"
#include "trace/shapes/shading_normal.h"

/** Bound on the error of a point, in half ulps of the coordinates. */
#define TRIANGLE_ERROR 8

/** @return The triangle of each lane. @param met The lanes with a hit; the others get the first
 *  triangle. */
static TrianglePack triangle_pack_gather(const MeshBvh *mesh_bvh, integer slots, mask met) {
    slots = integer_select(met, slots, integer_of(0));
    // The memory of a block is rows of #LANES scalars: x, y and z of each vertex.
    integer lane = slots & integer_of(LANES - 1);
    integer index = (slots - lane) * (TRIANGLE_BLOCK_SCALARS / LANES) + lane;
    const scalar *scalars = (const scalar *)(const void *)mesh_bvh->blocks;
    TrianglePack corners;
    for (int i = 0; i < 3; i++) {
        const scalar *corner = scalars + 3 * i * LANES;
        corners.corners[i] = (Vec3){real_gather(corner, index), real_gather(corner + LANES, index),
                                    real_gather(corner + 2 * LANES, index)};
    }
    return corners;
}

/** @return The normals at the vertices of the triangle of each lane. @param met The lanes with a
 * hit.
 */
static TrianglePack triangle_pack_gather_normals(const MeshBvh *mesh_bvh, integer slots, mask met) {
    Vec3 up = {real_of(0), real_of(1), real_of(0)};
    TrianglePack normals = {{up, up, up}};
    for (unsigned left = mask_bits(met); left; left &= left - 1) {
        int lane = __builtin_ctz(left), slot = integer_lane(slots, lane);
        for (int i = 0; i < 3; i++) {
            const Vec3s *normal = &mesh_bvh->normals[mesh_bvh->normal_indices[slot].index[i]];
            real_set_lane(&normals.corners[i].x, lane, normal->x);
            real_set_lane(&normals.corners[i].y, lane, normal->y);
            real_set_lane(&normals.corners[i].z, lane, normal->z);
        }
    }
    return normals;
}

/**
 * @return Interpolated unit normals; the flat one where the three cancel out.
 * @param normals  Normals at the vertices.
 * @param flat     Unit normals of the triangles.
 */
static Vec3 triangle_pack_interpolate_normals(const TrianglePack *corners,
                                              const TrianglePack *normals, const Ray *ray,
                                              Vec3 flat) {
    DominantAxes axes = ray_dominant_axes(ray, mask_of(true));
    Vec3 barycentrics = triangle_pack_barycentrics(corners, ray, 2);
    barycentrics = vec3_select(axes.x, triangle_pack_barycentrics(corners, ray, 0), barycentrics);
    barycentrics = vec3_select(axes.y, triangle_pack_barycentrics(corners, ray, 1), barycentrics);
    // The areas have the same sign; only their ratios matter.
    Vec3 sum = vec3_scale(normals->corners[0], real_abs(barycentrics.x));
    sum = vec3_add(sum, vec3_scale(normals->corners[1], real_abs(barycentrics.y)));
    sum = vec3_add(sum, vec3_scale(normals->corners[2], real_abs(barycentrics.z)));
    real largest = vec3_max_abs(sum);
    Vec3 normal = vec3_normalize(vec3_scale(sum, 1 / largest));
    mask is_good =
        (largest > 0) & (largest < INFINITE) & (vec3_dot(normal, normal) > real_of((scalar)0.5));
    return vec3_select(is_good, normal, flat);
}

Hit mesh_bvh_hit(const MeshBvh *mesh_bvh, const Ray *ray, real distance, integer slots, mask met,
                 int shape_index) {
    TrianglePack corners = triangle_pack_gather(mesh_bvh, slots, met);
    Vec3 flat = triangle_pack_unit_normal(&corners), normal = flat;
    Vec3 point = vec3_add(ray->origin, vec3_scale(ray->direction, distance));
    real height = vec3_dot(flat, vec3_subtract(point, corners.corners[0]));
    point = vec3_subtract(point, vec3_scale(flat, height));
    real magnitude = vec3_max_abs(point) + real_of(mesh_bvh->magnitude);
    real error = TRIANGLE_ERROR * ROUNDOFF * magnitude;
    if (mesh_bvh->normals) {
        TrianglePack normals = triangle_pack_gather_normals(mesh_bvh, slots, met);
        normal = triangle_pack_interpolate_normals(&corners, &normals, ray, flat);
        // Files disagree on the order of vertices: the interpolated normals define the outside.
        flat = vec3_select(vec3_dot(flat, normal) < 0, vec3_scale(flat, real_of(-1)), flat);
        normal = shading_normal_keep_side(normal, flat, ray->direction);
        // Along an oblique normal, the same distance from the plane is longer.
        error = error / vec3_dot(normal, flat);
    }
    return (Hit){distance, point, normal, error, integer_of(shape_index), slots};
}

/** @return Barycentric coordinates of points on triangles, 0 to 1. */
static Vec3 triangle_pack_barycentrics_at(const TrianglePack *corners, Vec3 point) {
    Vec3w a = vec3_widen(corners->corners[0]), normal = triangle_pack_normal(corners);
    Vec3w b = vec3w_subtract(vec3_widen(corners->corners[1]), a);
    Vec3w c = vec3w_subtract(vec3_widen(corners->corners[2]), a);
    Vec3w to_point = vec3w_subtract(vec3_widen(point), a);
    wide per_area = 1 / vec3w_dot(normal, normal);
    // The areas between the point and two vertices each, relative to the whole area.
    real weight_b = narrow(vec3w_dot(vec3w_cross(to_point, c), normal) * per_area);
    real weight_c = narrow(vec3w_dot(vec3w_cross(b, to_point), normal) * per_area);
    const real zero = real_of(0), one = real_of(1);
    weight_b = real_min(real_max(weight_b, zero), one);
    weight_c = real_min(real_max(weight_c, zero), one);
    return (Vec3){real_max(one - weight_b - weight_c, zero), weight_b, weight_c};
}

TextureUv mesh_bvh_texture_uv(const MeshBvh *mesh_bvh, const Hit *hit, mask lanes) {
    TextureUv uv = {real_of(0), real_of(0), mask_of(true), mask_of(true)};
    if (!mesh_bvh->uvs) {
        return uv;
    }
    TrianglePack corners = triangle_pack_gather(mesh_bvh, hit->primitive, lanes);
    Vec3 barycentrics = triangle_pack_barycentrics_at(&corners, hit->point);
    const real weights[3] = {barycentrics.x, barycentrics.y, barycentrics.z};
    for (unsigned left = mask_bits(lanes); left; left &= left - 1) {
        int lane = __builtin_ctz(left), slot = integer_lane(hit->primitive, lane);
        scalar u = 0, v = 0;
        for (int i = 0; i < 3; i++) {
            const Uvs *corner_uv = &mesh_bvh->uvs[mesh_bvh->uv_indices[slot].index[i]];
            u += corner_uv->u * real_lane(weights[i], lane);
            v += corner_uv->v * real_lane(weights[i], lane);
        }
        real_set_lane(&uv.u, lane, u);
        real_set_lane(&uv.v, lane, v);
    }
    return uv;
}
