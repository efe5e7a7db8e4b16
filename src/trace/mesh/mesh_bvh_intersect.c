/**
 * @file
 * @brief Intersection of rays with the triangles of a mesh.
 *
 * A vector of rays is tested with the edges of the triangles of a block one by one; a single ray
 * with all of them at once. Both do the same operations in the same order.
 */
#include "trace/math/permute.h"
#include "trace/mesh/mesh_bvh_hit.h"
#include "trace/mesh/triangle_pack.h"

/** Larger than the index of any block. */
#define TRIANGLE_BLOCK_NONE SIZE_MAX

/** Bounding boxes of the triangles of a block. */
typedef struct TriangleBlockBoxes {
    size_t block_index; /**< Index of the block; #TRIANGLE_BLOCK_NONE: none. */
    Aabb boxes;         /**< The boxes. */
} TriangleBlockBoxes;

/** Normals of the triangles of a block. */
typedef struct TriangleBlockNormals {
    size_t block_index; /**< Index of the block; #TRIANGLE_BLOCK_NONE: none. */
    Vec3w normals;      /**< The normals, of any length. */
} TriangleBlockNormals;

/** Nearest hits of a packet; #BvhLeafRays.limits holds their distances. */
typedef struct MeshBvhHits {
    integer slots[PACKET_VECTORS];             /**< Slots of the triangles; -1: none. */
    TriangleBlockBoxes boxes;                  /**< Of the last block whose boxes were tested. */
    TriangleBlockNormals normals;              /**< Of the last block with a hit. */
    unsigned interval_bits;                    /**< Bit v: #intervals has those of vector v. */
    PacketIntervals intervals[PACKET_VECTORS]; /**< See #triangle_block_candidates. */
} MeshBvhHits;

/** @return All triangles of a block. */
INLINE TrianglePack triangle_block_load(const TriangleBlock *block) {
    return (TrianglePack){{block->corners[0], block->corners[1], block->corners[2]}};
}

/** @return A vertex of one triangle in all lanes. @param lane Lane of the triangle. */
INLINE Vec3 triangle_block_corner(const TriangleBlock *block, int i, int lane) {
    const Vec3 *corners = &block->corners[i];
    return (Vec3){real_of(real_at(&corners->x, lane)), real_of(real_at(&corners->y, lane)),
                  real_of(real_at(&corners->z, lane))};
}

/* --- a vector of rays with a block of triangles ---------------------------------------------- */

/** @return The triangle of a slot, in the order of the mesh. */
INLINE uint32_t mesh_bvh_slot_triangle(const MeshBvh *mesh_bvh, int slot) {
    return mesh_bvh->blocks[slot / LANES].triangle_ids[slot % LANES];
}

/**
 * @return The lanes in which a triangle is nearer, or as near and earlier in the mesh.
 * @param met    The lanes that meet it.
 * @param slots  Slots of the triangles.
 * @param limit  Distances of the nearest hits so far.
 * @param nearest  Slots of the nearest hits so far.
 */
INLINE mask triangle_slots_are_nearer(const MeshBvh *mesh_bvh, mask met, real distance,
                                      const integer *slots, real limit, const integer *nearest) {
    mask nearer = met & (distance < limit), tie = met & (distance == limit);
    while (any(tie)) {
        int lane = mask_first(tie), other = integer_at(nearest, lane);
        bool is_first = other < 0 || mesh_bvh_slot_triangle(mesh_bvh, integer_at(slots, lane)) <
                                         mesh_bvh_slot_triangle(mesh_bvh, other);
        mask_set_lane(&nearer, lane, is_first);
        mask_set_lane(&tie, lane, false);
    }
    return nearer;
}

/** @return The bounding boxes of the triangles of a block. */
static const Aabb *triangle_block_boxes(const MeshBvh *mesh_bvh, size_t b, MeshBvhHits *hits) {
    if (hits->boxes.block_index != b) {
        TrianglePack corners = triangle_block_load(&mesh_bvh->blocks[b]);
        hits->boxes = (TriangleBlockBoxes){b, triangle_pack_bounds(&corners)};
    }
    return &hits->boxes.boxes;
}

/** @return The normals of the triangles of a block. */
static const Vec3w *triangle_block_normals(const MeshBvh *mesh_bvh, size_t b, MeshBvhHits *hits) {
    if (hits->normals.block_index != b) {
        TrianglePack corners = triangle_block_load(&mesh_bvh->blocks[b]);
        hits->normals = (TriangleBlockNormals){b, triangle_pack_normal(&corners)};
    }
    return &hits->normals.normals;
}

/** @return The intervals of a vector of rays. */
static const PacketIntervals *ray_vector_intervals(const BvhLeafRays *rays, MeshBvhHits *hits) {
    PacketIntervals *intervals = &hits->intervals[rays->vector];
    if (!(hits->interval_bits >> rays->vector & 1)) {
        *intervals = packet_vector_intervals(rays->packet, rays->vector);
        hits->interval_bits |= 1u << rays->vector;
    }
    return intervals;
}

/** The rays that pass inside the edges of the triangles of a block. */
typedef struct TriangleBlockInside {
    unsigned triangle_bits;   /**< Bit i: some ray passes inside triangle i. */
    uint16_t ray_bits[LANES]; /**< Per triangle, bit i: ray i passes inside. */
} TriangleBlockInside;

/** @return The rays that pass inside the triangles of a block. @param triangles Bit i: triangle i
 *  counts. @param axis Dominant axis of the rays. */
INLINE TriangleBlockInside triangle_block_inside(const TriangleBlock *block, unsigned triangles,
                                                 const Ray *ray, int axis, mask active) {
    TriangleBlockInside inside = {0};
    RayShear shear = ray_shear_of(ray, axis);
    for (; triangles; triangles &= triangles - 1) {
        int lane = __builtin_ctz(triangles);
        // Repeated triangles only fill the block.
        if (lane > 0 && block->triangle_ids[lane] == block->triangle_ids[lane - 1]) {
            break;
        }
        ShearedVertex sheared[3];
        for (int i = 0; i < 3; i++) {
            sheared[i] =
                ray_shear_vertex(permute_axes(triangle_block_corner(block, i, lane), axis), &shear);
        }
        inside.ray_bits[lane] =
            (uint16_t)mask_bits(active & edge_functions_contain_ray(sheared, 3));
        inside.triangle_bits |= (unsigned)(inside.ray_bits[lane] != 0) << lane;
    }
    return inside;
}

/** Triangles of a block, one per ray. */
typedef struct DealtTriangles {
    unsigned ray_bits; /**< Bit i: ray i has one. */
    integer lanes;     /**< Their lanes in the block. */
} DealtTriangles;

/** @return Triangles that are left, one for each ray that passes inside of any: their distances,
 *          each a division of wide numbers, are found at once. All rays get the same triangle if
 *          not #HAS_WIDE_PERMUTE. @param[in,out] inside Those that are left. */
INLINE DealtTriangles triangle_block_deal(TriangleBlockInside *inside) {
    DealtTriangles dealt = {0, integer_of(__builtin_ctz(inside->triangle_bits))};
    for (unsigned left = inside->triangle_bits; left; left &= left - 1) {
        int lane = __builtin_ctz(left);
        unsigned bits = inside->ray_bits[lane] & ~dealt.ray_bits;
        dealt.lanes = integer_select(mask_of_bits(bits), integer_of(lane), dealt.lanes);
        dealt.ray_bits |= bits;
        inside->ray_bits[lane] = (uint16_t)(inside->ray_bits[lane] & ~bits);
        inside->triangle_bits &= ~((unsigned)(inside->ray_bits[lane] == 0) << lane);
        if (!HAS_WIDE_PERMUTE) {
            break;
        }
    }
    return dealt;
}

/** @return The boxes of triangles of a block. @param lanes Their lanes. */
INLINE Aabb aabb_permute(const Aabb *boxes, integer lanes) {
    Aabb permuted;
    for (int i = 0; i < 6; i++) {
        permuted.planes[i] = real_permute(&boxes->planes[i], lanes);
    }
    return permuted;
}

/** @return The distances at which rays cross the planes of triangles of a block. @param normals
 *  Those of the block. @param lanes The lanes of the triangles. */
INLINE real triangle_block_plane_distance(const TriangleBlock *block, const Vec3w *normals,
                                          integer lanes, const Ray *ray) {
    const Vec3 *corners = &block->corners[0];
    Vec3w normal = {wide_permute(&normals->x, lanes), wide_permute(&normals->y, lanes),
                    wide_permute(&normals->z, lanes)};
    Vec3 corner = {real_permute(&corners->x, lanes), real_permute(&corners->y, lanes),
                   real_permute(&corners->z, lanes)};
    return ray_plane_distance(normal, vec3_widen(corner), ray);
}

/** Updates the nearest hits with triangles of a block, inside of whose edges the rays pass. */
INLINE void mesh_bvh_accept_triangles(const MeshBvh *mesh_bvh, size_t b,
                                      const DealtTriangles *triangles, const BvhLeafRays *rays,
                                      MeshBvhHits *hits) {
    const Ray *ray = &rays->packet->rays[rays->vector];
    const integer lanes = triangles->lanes;
    real near, *limit = &rays->limits[rays->vector];
    Aabb boxes = aabb_permute(triangle_block_boxes(mesh_bvh, b, hits), lanes);
    mask inside = mask_of_bits(triangles->ray_bits) & slab_intersects(ray, &boxes, *limit, &near);
    if (any(inside)) {
        real distance = triangle_block_plane_distance(
            &mesh_bvh->blocks[b], triangle_block_normals(mesh_bvh, b, hits), lanes, ray);
        inside &= distance > 0;
        distance = real_max(distance, near);
        integer new_slots = integer_of((int)(b * LANES)) + lanes;
        integer *slots = &hits->slots[rays->vector];
        mask nearer =
            triangle_slots_are_nearer(mesh_bvh, inside, distance, &new_slots, *limit, slots);
        *limit = real_select(nearer, distance, *limit);
        *slots = integer_select(nearer, new_slots, *slots);
    }
}

/** Intersects the rays with one dominant axis with the triangles of a block. */
INLINE void triangle_block_intersect_along(const MeshBvh *mesh_bvh, size_t b, unsigned triangles,
                                           const BvhLeafRays *rays, int axis, mask active,
                                           MeshBvhHits *hits) {
    const Ray *ray = &rays->packet->rays[rays->vector];
    const TriangleBlock *block = &mesh_bvh->blocks[b];
    TriangleBlockInside inside = triangle_block_inside(block, triangles, ray, axis, active);
    while (inside.triangle_bits) {
        DealtTriangles dealt = triangle_block_deal(&inside);
        mesh_bvh_accept_triangles(mesh_bvh, b, &dealt, rays, hits);
    }
}

/** @return The triangles of a block that any ray of a vector may meet: bit i for triangle i. Up to
 *          eight triangles are tested one by one in no more time (measured). */
INLINE unsigned triangle_block_candidates(const MeshBvh *mesh_bvh, size_t b,
                                          const BvhLeafRays *rays, MeshBvhHits *hits) {
    if (LANES <= 8) {
        return ALL_LANES;
    }
    real near;
    return mask_bits(packet_intervals_may_hit(ray_vector_intervals(rays, hits),
                                              triangle_block_boxes(mesh_bvh, b, hits), &near));
}

/** Intersects a vector of rays with the triangles of a leaf, one by one. */
static void mesh_leaf_intersect_packet(const MeshBvh *mesh_bvh, BvhLeaf leaf,
                                       const BvhLeafRays *rays, MeshBvhHits *hits) {
    DominantAxes axes =
        ray_dominant_axes(&rays->packet->rays[rays->vector], mask_of_bits(rays->lane_bits));
    bool any_x = any(axes.x), any_y = any(axes.y), any_z = any(axes.z);
    for (size_t b = leaf.first_block; b < leaf.first_block + leaf.block_count; b++) {
        unsigned triangles = triangle_block_candidates(mesh_bvh, b, rays, hits);
        if (any_x) {
            triangle_block_intersect_along(mesh_bvh, b, triangles, rays, 0, axes.x, hits);
        }
        if (any_y) {
            triangle_block_intersect_along(mesh_bvh, b, triangles, rays, 1, axes.y, hits);
        }
        if (any_z) {
            triangle_block_intersect_along(mesh_bvh, b, triangles, rays, 2, axes.z, hits);
        }
    }
}

/* --- one ray with a block of triangles ------------------------------------------------------- */

/** One ray, in all lanes. */
typedef struct SplatRay {
    Ray ray;        /**< The ray. */
    RayShear shear; /**< Its shear. */
    int axes[3];    /**< The axes of the shear, the dominant one last. */
} SplatRay;

/** @return One lane of vectors in all lanes, with permuted axes. */
INLINE Vec3 vec3_splat_axes(const Vec3 *v, const int axes[3], int lane) {
    return (Vec3){real_of(real_at(vec3_axis(v, axes[0]), lane)),
                  real_of(real_at(vec3_axis(v, axes[1]), lane)),
                  real_of(real_at(vec3_axis(v, axes[2]), lane))};
}

/** @return The ray of a lane. */
INLINE SplatRay ray_splat_lane(const Ray *rays, int lane) {
    const Vec3 *o = &rays->origin, *d = &rays->direction, *inverse = &rays->inverse_direction;
    const int z = ray_dominant_axis(d, lane), x = z == 2 ? 0 : z + 1, y = z == 0 ? 2 : z - 1;
    SplatRay splat = {
        {vec3_splat_lane(o, lane), vec3_splat_lane(d, lane), vec3_splat_lane(inverse, lane)},
        .axes = {x, y, z}};
    const Ray permuted = {vec3_splat_axes(o, splat.axes, lane),
                          vec3_splat_axes(d, splat.axes, lane),
                          vec3_splat_axes(inverse, splat.axes, lane)};
    splat.shear = ray_shear_of(&permuted, 2);
    return splat;
}

/**
 * @return The triangles of a block whose edges and bounding box a ray passes.
 * @param limit      Largest distance.
 * @param[out] near  Lower bounds on the distances of the triangles.
 */
INLINE unsigned triangle_block_intersect_single(const TriangleBlock *block, const SplatRay *splat,
                                                scalar limit, real *near) {
    ShearedVertex sheared[3];
    for (int i = 0; i < 3; i++) {
        const Vec3 *corner = &block->corners[i];
        Vec3 permuted = {*vec3_axis(corner, splat->axes[0]), *vec3_axis(corner, splat->axes[1]),
                         *vec3_axis(corner, splat->axes[2])};
        sheared[i] = ray_shear_vertex(permuted, &splat->shear);
    }
    mask inside = edge_functions_contain_ray(sheared, 3);
    if (any(inside)) {
        TrianglePack corners = triangle_block_load(block);
        Aabb boxes = triangle_pack_bounds(&corners);
        inside &= slab_intersects(&splat->ray, &boxes, real_of(limit), near);
    }
    return mask_bits(inside);
}

/** @return One lane of vectors, widened. */
INLINE Vec3sw vec3_lane_widen(const Vec3 *v, int lane) {
    return (Vec3sw){(wide_scalar)real_at(&v->x, lane), (wide_scalar)real_at(&v->y, lane),
                    (wide_scalar)real_at(&v->z, lane)};
}

/** @return The distance of one ray to the plane of one triangle: the same operations as
 *  #triangle_block_plane_distance. */
INLINE scalar triangle_single_distance(const TriangleBlock *block, int lane, const Ray *rays,
                                       int r) {
    Vec3sw a = vec3_lane_widen(&block->corners[0], lane);
    Vec3sw u = vec3sw_subtract(vec3_lane_widen(&block->corners[1], lane), a);
    Vec3sw v = vec3sw_subtract(vec3_lane_widen(&block->corners[2], lane), a);
    Vec3sw normal = vec3sw_cross(u, v);
    Vec3sw to_corner = vec3sw_subtract(a, vec3_lane_widen(&rays->origin, r));
    return (scalar)(vec3sw_dot(normal, to_corner) /
                    vec3sw_dot(normal, vec3_lane_widen(&rays->direction, r)));
}

/** Nearest hit of one ray. */
typedef struct ClosestTriangle {
    scalar distance; /**< Its distance. */
    int slot;        /**< Slot of the triangle; -1: none. */
} ClosestTriangle;

/** Updates the nearest hit with a triangle. */
INLINE void closest_triangle_update(const MeshBvh *mesh_bvh, int slot, scalar distance,
                                    ClosestTriangle *best) {
    bool is_first = best->slot < 0 || mesh_bvh_slot_triangle(mesh_bvh, slot) <
                                          mesh_bvh_slot_triangle(mesh_bvh, best->slot);
    if (distance < best->distance || (distance == best->distance && is_first)) {
        *best = (ClosestTriangle){distance, slot};
    }
}

/**
 * Updates the nearest hit with some triangles of a block.
 * @param inside  Bit i: the ray passes inside triangle i.
 * @param near    Lower bounds on their distances.
 */
INLINE void closest_triangle_update_from_block(const MeshBvh *mesh_bvh, size_t b, unsigned inside,
                                               const real *near, const Ray *rays, int r,
                                               ClosestTriangle *best) {
    for (; inside; inside &= inside - 1) {
        int lane = __builtin_ctz(inside);
        scalar distance = triangle_single_distance(&mesh_bvh->blocks[b], lane, rays, r);
        scalar nearest = real_at(near, lane);
        if (distance > 0) {
            distance = distance > nearest ? distance : nearest;
            closest_triangle_update(mesh_bvh, (int)(b * LANES) + lane, distance, best);
        }
    }
}

/** Intersects one ray with the triangles of a leaf, a block at a time. */
static void mesh_leaf_intersect_single(const MeshBvh *mesh_bvh, BvhLeaf leaf,
                                       const BvhLeafRays *rays, int lane, MeshBvhHits *hits) {
    const Ray *rays_vector = &rays->packet->rays[rays->vector];
    real *limits = &rays->limits[rays->vector];
    integer *slots = &hits->slots[rays->vector];
    SplatRay ray = ray_splat_lane(rays_vector, lane);
    ClosestTriangle best = {real_at(limits, lane), integer_at(slots, lane)};
    for (size_t b = leaf.first_block; b < leaf.first_block + leaf.block_count; b++) {
        real near = real_of(0);
        unsigned inside =
            triangle_block_intersect_single(&mesh_bvh->blocks[b], &ray, best.distance, &near);
        closest_triangle_update_from_block(mesh_bvh, b, inside, &near, rays_vector, lane, &best);
    }
    real_set_lane(limits, lane, best.distance);
    integer_set_lane(slots, lane, best.slot);
}

/* --- leaves ---------------------------------------------------------------------------------- */

/** @return Whether rays are tested one by one with whole blocks, rather than together with one
 *  triangle after the other: whichever is faster. */
INLINE bool mesh_leaf_prefers_single(int lanes) {
    /** Number of rays at which both take the same time (measured): blocks are not always full. */
    const int break_even = LANES / 4;
    return lanes <= break_even || LANES == 1;
}

/** Finds the closest hits in a leaf. See #BvhIntersector.intersect_leaf. */
static void mesh_leaf_intersect(const void *items, BvhLeaf leaf, const BvhLeafRays *rays,
                                void *results) {
    if (mesh_leaf_prefers_single(__builtin_popcount(rays->lane_bits))) {
        for (unsigned left = rays->lane_bits; left; left &= left - 1) {
            mesh_leaf_intersect_single(items, leaf, rays, __builtin_ctz(left), results);
        }
    } else {
        mesh_leaf_intersect_packet(items, leaf, rays, results);
    }
}

/** Finds the rays that a leaf occludes; they are finished. See #BvhIntersector.intersect_leaf. */
static void mesh_leaf_occluded(const void *items, BvhLeaf leaf, const BvhLeafRays *rays,
                               void *results) {
    mesh_leaf_intersect(items, leaf, rays, results);
    real *limits = &rays->limits[rays->vector];
    const real *ray_limits = &rays->packet->limit[rays->vector];
    for (unsigned left = rays->lane_bits; left; left &= left - 1) {
        int lane = __builtin_ctz(left);
        if (real_at(limits, lane) < real_at(ray_limits, lane)) {
            real_set_lane(limits, lane, -1);
        }
    }
}

/* --- the whole mesh -------------------------------------------------------------------------- */

/** Initialises the hits of a packet: none. */
static void mesh_bvh_hits_init(MeshBvhHits *hits) {
    hits->boxes.block_index = hits->normals.block_index = TRIANGLE_BLOCK_NONE;
    hits->interval_bits = 0;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        hits->slots[v] = integer_of(-1);
    }
}

void mesh_bvh_closest_hits(const MeshBvh *mesh_bvh, const Packet *packet, int shape_index,
                           Hit *hits) {
    const BvhIntersector intersector = {.items = mesh_bvh,
                                        .blocks = mesh_bvh->blocks,
                                        .block_bytes = sizeof *mesh_bvh->blocks,
                                        .intersect_leaf = mesh_leaf_intersect};
    real limits[PACKET_VECTORS];
    MeshBvhHits results;
    mesh_bvh_hits_init(&results);
    for (int v = 0; v < packet_vector_count(packet); v++) {
        limits[v] = hits[v].distance;
    }
    const PacketIntervals intervals = packet_intervals(packet);
    bvh_traverse(&mesh_bvh->bvh, packet, &intervals, limits, &intersector, &results);
    for (int v = 0; v < packet_vector_count(packet); v++) {
        mask met = packet->active[v] & (results.slots[v] >= integer_of(0));
        mask nearer = hit_is_nearer(&hits[v], met, limits[v], shape_index);
        if (any(nearer)) {
            Hit hit = hit_none(limits[v]);
            hit.shape = integer_of(shape_index);
            if (packet->wants_points) {
                hit = mesh_bvh_hit(mesh_bvh, &packet->rays[v], limits[v], results.slots[v], nearer,
                                   shape_index);
            }
            hit_update(&hits[v], nearer, &hit);
            hits[v].primitive = integer_select(nearer, hit.primitive, hits[v].primitive);
        }
    }
}

void mesh_bvh_occluded(const MeshBvh *mesh_bvh, const Packet *packet, mask *occluded) {
    const BvhIntersector intersector = {.items = mesh_bvh,
                                        .blocks = mesh_bvh->blocks,
                                        .block_bytes = sizeof *mesh_bvh->blocks,
                                        .intersect_leaf = mesh_leaf_occluded};
    real limits[PACKET_VECTORS];
    MeshBvhHits results;
    mesh_bvh_hits_init(&results);
    for (int v = 0; v < packet_vector_count(packet); v++) {
        limits[v] = real_select(occluded[v], real_of(-1), packet->limit[v]);
    }
    const PacketIntervals intervals = packet_intervals(packet);
    bvh_traverse(&mesh_bvh->bvh, packet, &intervals, limits, &intersector, &results);
    for (int v = 0; v < packet_vector_count(packet); v++) {
        // A limit may be negative from the start: only together with a slot it means a hit.
        occluded[v] |= packet->active[v] & (results.slots[v] >= integer_of(0)) & (limits[v] < 0);
    }
}
