/**
 * @file
 * @brief Intersection of packets with the shapes of a scene.
 */
#include "trace/bvh/shape_set.h"
#include "trace/shapes/plane_equation.h"
#include "trace/tracer/shaft.h"

/* --- shapes in the list ---------------------------------------------------------------------- */

/** The shapes of a pack that a packet may meet. */
typedef struct Candidates {
    unsigned remaining; /**< Bit i: shape i is not tested yet. */
    real near;          /**< Lower bounds on the distances of the shapes. */
} Candidates;

/** @return Number of shapes in a pack. @param pack Index in #ShapeSet.linear_bounds. */
INLINE int linear_pack_size(const ShapeSet *set, size_t pack) {
    size_t count = set->linear_count - pack * AABB_PACK_SIZE;
    return (int)(count < AABB_PACK_SIZE ? count : AABB_PACK_SIZE);
}

/** @return The bits of the shapes of a pack. @param pack Index in #ShapeSet.linear_bounds. */
INLINE unsigned linear_pack_bits(const ShapeSet *set, size_t pack) {
    return (1u << linear_pack_size(set, pack)) - 1;
}

/** @return A shape. @param i Its index in the pack. */
INLINE const Shape *linear_shape(const ShapeSet *set, size_t pack, int i) {
    return set->linear[pack * AABB_PACK_SIZE + (size_t)i];
}

/** @return The shapes of a pack that a packet may meet; in engines of one lane, whose rays have no
 *          intervals, all. @param pack Index in #ShapeSet.linear_bounds. */
static Candidates linear_candidates(const ShapeSet *set, const PacketIntervals *intervals,
                                    size_t pack) {
    Candidates candidates = {.remaining = linear_pack_bits(set, pack)};
    if (LANES > 1) {
        mask may_meet =
            packet_intervals_may_hit(intervals, &set->linear_bounds[pack].boxes, &candidates.near);
        candidates.remaining &= mask_bits(may_meet);
    }
    return candidates;
}

/** @return Whether all rays of a beam surely miss a shape. @param[in,out] sides Its shaft, which is
 *  set by the first shape that asks for it. */
INLINE bool beam_misses_shape(const Beam *beam, Shaft *sides, const Shape *shape) {
    if (!shape->class->support) {
        return false;
    }
    if (sides->vector_count == SHAFT_NOT_SET) {
        beam_shaft(beam, sides);
    }
    return shaft_misses(sides, shape);
}

/** @return Whether all rays to a point surely miss a shape. @param intervals Those of the rays.
 *  @param[in,out] sides Their shaft. */
INLINE bool intervals_miss_shape(const PacketIntervals *intervals, Shaft *sides,
                                 const Shape *shape) {
    const ShapeClass *class = shape->class;
    if (!intervals->has_region) {
        return false;
    }
    if (class->misses_to_point) {
        return class->misses_to_point(shape, intervals);
    }
    if (class->plane && plane_equation_misses_region(class->plane(shape), &intervals->region)) {
        return true;
    }
    if (!class->support) {
        return false;
    }
    if (sides->vector_count == SHAFT_NOT_SET) {
        intervals_shaft(intervals, sides);
    }
    return shaft_misses(sides, shape);
}

/** @return The bits of the candidates that may occlude rays: without those that all rays miss.
 *  @param excluded Another shape that they miss; NULL: there is none. */
INLINE unsigned occluding_candidates(const ShapeSet *set, const PacketIntervals *intervals,
                                     Shaft *sides, size_t pack, const Shape *excluded) {
    unsigned remaining = linear_candidates(set, intervals, pack).remaining, others = remaining;
    for (; remaining; remaining &= remaining - 1) {
        int i = __builtin_ctz(remaining);
        const Shape *shape = linear_shape(set, pack, i);
        bool is_missed = shape == excluded || intervals_miss_shape(intervals, sides, shape);
        others &= is_missed ? ~(1u << i) : ~0u;
    }
    return others;
}

/** Removes the nearest candidate: its hit can rule out others. @return Its index in the pack. */
INLINE int candidates_pop_nearest(Candidates *candidates) {
    int best = __builtin_ctz(candidates->remaining);
    for (unsigned remaining = candidates->remaining; remaining; remaining &= remaining - 1) {
        int other = __builtin_ctz(remaining);
        bool is_nearer = real_lane(candidates->near, other) < real_lane(candidates->near, best);
        best = is_nearer ? other : best;
    }
    candidates->remaining &= ~(1u << best);
    return best;
}

/**
 * Intersects a packet with one shape.
 * @param near          Lower bound on its distance.
 * @param[in,out] hits  Nearest hits so far.
 */
static void shape_closest_hits(const Shape *shape, scalar near, const Packet *packet, Hit *hits) {
    const bool has_beam = LANES > 1 && packet->has_beam;
    if (shape_takes_packets(shape)) {
        shape->class->extension->closest_hits(shape, packet, hits);
        return;
    }
    const ShapeClass *class = shape->class;
    if (has_beam && class->beam_hits && class->beam_hits(shape, packet, hits)) {
        return;
    }
    for (int v = 0; v < packet_vector_count(packet); v++) {
        mask pending = packet->active[v] & (hits[v].distance >= real_of(near));
        if (LANES == 1 || any(pending)) {
            class->is_hit(shape, &packet->rays[v], packet->active[v], &hits[v]);
        }
    }
}

/** Tests the rays that are not occluded yet with one shape. @param[in,out] occluded The occluded
 *  rays. */
static void shape_occluded(const Shape *shape, const Packet *packet, mask *occluded) {
    if (shape_takes_packets(shape)) {
        shape->class->extension->occluded(shape, packet, occluded);
        return;
    }
    for (int v = 0; v < packet_vector_count(packet); v++) {
        mask pending = packet->active[v] & mask_not(occluded[v]);
        if (any(pending)) {
            occluded[v] |=
                shape->class->is_occluding(shape, &packet->rays[v], pending, packet->limit[v]);
        }
    }
}

/* --- shapes in the BVH ----------------------------------------------------------------------- */

/** Finds the closest hits in a leaf. See #BvhIntersector.intersect_leaf. */
static void leaf_closest_hits(const void *items, BvhLeaf leaf, const BvhLeafRays *rays,
                              void *found) {
    const ShapeSet *set = items;
    const Ray *ray = &rays->packet->rays[rays->vector];
    Hit *hit = (Hit *)found + rays->vector;
    mask active = mask_of_bits(rays->lane_bits);
    for (size_t i = leaf.first_block; i < leaf.first_block + leaf.block_count; i++) {
        const Shape *shape = set->shapes[set->bvh.item_indices[i]];
        shape->class->is_hit(shape, ray, active, hit);
    }
    rays->limits[rays->vector] = hit->distance;
}

/** What #leaf_occluded finds. */
typedef struct OcclusionQuery {
    const Shape *excluded; /**< A shape that no ray meets; NULL: there is none. */
    mask *occluded;        /**< The occluded rays, per vector. */
} OcclusionQuery;

/** Finds the rays that a leaf occludes. See #BvhIntersector.intersect_leaf. */
static void leaf_occluded(const void *items, BvhLeaf leaf, const BvhLeafRays *rays, void *found) {
    const ShapeSet *set = items;
    const OcclusionQuery *query = found;
    const Ray *ray = &rays->packet->rays[rays->vector];
    real limit = rays->packet->limit[rays->vector];
    mask *occluded = &query->occluded[rays->vector], active = mask_of_bits(rays->lane_bits);
    for (size_t i = leaf.first_block; i < leaf.first_block + leaf.block_count; i++) {
        const Shape *shape = set->shapes[set->bvh.item_indices[i]];
        mask pending = active & mask_not(*occluded);
        if (shape != query->excluded && any(pending)) {
            *occluded |= shape->class->is_occluding(shape, ray, pending, limit);
        }
    }
    rays->limits[rays->vector] = real_select(*occluded, real_of(-1), limit);
}

/** Finds the closest hits in the BVH. It is not inlined: a set without one pays nothing.
 *  @param[in,out] hits Nearest hits so far. */
static __attribute__((noinline)) void set_bvh_closest_hits(const ShapeSet *set,
                                                           const Packet *packet,
                                                           const PacketIntervals *intervals,
                                                           Hit *hits) {
    const BvhIntersector callback = {
        .items = set, .prefers_vectors = true, .intersect_leaf = leaf_closest_hits};
    real limits[PACKET_VECTORS];
    for (int v = 0; v < packet_vector_count(packet); v++) {
        limits[v] = hits[v].distance;
    }
    bvh_traverse(&set->bvh, packet, intervals, limits, &callback, hits);
}

/** Finds the rays that the BVH occludes; not inlined, either.
 *  @param excluded A shape that no ray meets; NULL: there is none.
 *  @param[in,out] occluded The occluded rays. */
static __attribute__((noinline)) void set_bvh_occluded(const ShapeSet *set, const Packet *packet,
                                                       const PacketIntervals *intervals,
                                                       const Shape *excluded, mask *occluded) {
    const BvhIntersector callback = {
        .items = set, .prefers_vectors = true, .intersect_leaf = leaf_occluded};
    real limits[PACKET_VECTORS];
    for (int v = 0; v < packet_vector_count(packet); v++) {
        limits[v] = real_select(occluded[v], real_of(-1), packet->limit[v]);
    }
    OcclusionQuery query = {excluded, occluded};
    bvh_traverse(&set->bvh, packet, intervals, limits, &callback, &query);
}

/** Arguments of #shape_set_visit. */
typedef struct VisitRequest {
    ShapeVisitor visitor; /**< The function. */
    void *found;          /**< Its last argument. */
} VisitRequest;

/** Visits the shapes of a leaf. See #BvhIntersector.intersect_leaf. */
static void leaf_visit(const void *items, BvhLeaf leaf, const BvhLeafRays *rays, void *found) {
    const ShapeSet *set = items;
    const VisitRequest *visit = found;
    for (size_t i = leaf.first_block; i < leaf.first_block + leaf.block_count; i++) {
        const Shape *shape = set->shapes[set->bvh.item_indices[i]];
        visit->visitor(shape, rays->packet, rays->vector, mask_of_bits(rays->lane_bits),
                       visit->found);
    }
}

/** Visits the shapes of the BVH, if there is one. */
static void set_bvh_visit(const ShapeSet *set, const Packet *packet,
                          const PacketIntervals *intervals, VisitRequest *visit) {
    const BvhIntersector callback = {
        .items = set, .prefers_vectors = true, .intersect_leaf = leaf_visit};
    real limits[PACKET_VECTORS];
    if (set->bvh.nodes) {
        for (int v = 0; v < packet_vector_count(packet); v++) {
            limits[v] = packet->limit[v];
        }
        bvh_traverse(&set->bvh, packet, intervals, limits, &callback, visit);
    }
}

/* --- one ray --------------------------------------------------------------------------------- */

/** The intervals of a packet of one ray, which nothing reads. */
static const PacketIntervals no_intervals;

/** @return The planes of boxes in the order in which a packet of one ray meets them. */
INLINE const SlabOrder *single_ray_slab_order(const Packet *packet) {
    return &SLAB_ORDERS[octant_of(&packet->rays[0].inverse_direction, 0)];
}

/** @return The bits of the shapes of a pack that a packet of one ray may meet. @param limit The
 *          largest distance that counts. @param[out] near Lower bounds on their distances. */
INLINE unsigned single_ray_candidates(const ShapeSet *set, const Packet *packet,
                                      const SlabOrder *order, real limit, size_t pack,
                                      PackReal near[PACK_VECTORS]) {
    size_t vectors = ((size_t)linear_pack_size(set, pack) + PACK_LANES - 1) / PACK_LANES;
    return linear_pack_bits(set, pack) & aabb_pack_meets(&packet->rays[0],
                                                         &set->linear_bounds[pack], order, limit,
                                                         vectors, near);
}

/** #shape_set_update_hits for a packet of one ray. */
INLINE void single_ray_closest_hit(const ShapeSet *set, const Packet *packet, Hit *hits) {
    const SlabOrder *order = single_ray_slab_order(packet);
    PackReal near[PACK_VECTORS];
    for (size_t pack = 0; pack < aabb_pack_count(set->linear_count); pack++) {
        unsigned remaining =
            single_ray_candidates(set, packet, order, hits[0].distance, pack, near);
        for (int i = 0; remaining >> i; i++) {
            // A hit rules out all boxes behind it.
            if (remaining >> i & 1 &&
                (scalar)pack_lane(near, i) <= real_lane(hits[0].distance, 0)) {
                shape_closest_hits(linear_shape(set, pack, i), 0, packet, hits);
            }
        }
    }
    if (set->bvh.nodes) {
        set_bvh_closest_hits(set, packet, &no_intervals, hits);
    }
}

/** #shape_set_occluded for a packet of one ray. */
INLINE void single_ray_occluded(const ShapeSet *set, const Packet *packet, mask *occluded) {
    const SlabOrder *order = single_ray_slab_order(packet);
    PackReal near[PACK_VECTORS];
    occluded[0] = mask_of(false);
    for (size_t pack = 0; pack < aabb_pack_count(set->linear_count) && !any(occluded[0]); pack++) {
        unsigned remaining =
            single_ray_candidates(set, packet, order, packet->limit[0], pack, near);
        for (int i = 0; remaining >> i && !any(occluded[0]); i++) {
            if (remaining >> i & 1) {
                shape_occluded(linear_shape(set, pack, i), packet, occluded);
            }
        }
    }
    if (set->bvh.nodes) {
        set_bvh_occluded(set, packet, &no_intervals, NULL, occluded);
    }
}

/* --- all shapes ------------------------------------------------------------------------------ */

/** @return The intervals of a packet, where they are used: not without shapes. A beam has them for
 *          less; but those are wider by roundings, which would show at a shape that exceeds its
 *          box. */
static PacketIntervals set_intervals(const ShapeSet *set, const Packet *packet) {
    return set->count == 0                            ? (PacketIntervals){0}
           : packet->has_beam && !set->may_exceed_box ? beam_intervals(&packet->beam)
                                                      : packet_intervals(packet);
}

bool shape_set_may_meet(const ShapeSet *set, const PacketIntervals *intervals,
                        const Shape *excluded) {
    Shaft sides;
    sides.vector_count = SHAFT_NOT_SET;
    bool may_meet = LANES == 1 || set->bvh.nodes || set->may_exceed_box;
    for (size_t pack = 0; !may_meet && pack < aabb_pack_count(set->linear_count); pack++) {
        may_meet = occluding_candidates(set, intervals, &sides, pack, excluded) != 0;
    }
    return may_meet;
}

void shape_set_find_in_beam(const ShapeSet *set, const Beam *beam, BeamCandidates *found) {
    const PacketIntervals intervals = beam_intervals(beam);
    Shaft sides;
    sides.vector_count = SHAFT_NOT_SET;
    scalar nearest = INFINITE;
    *found = (BeamCandidates){0, NULL, INFINITE};
    for (size_t pack = 0; pack < aabb_pack_count(set->linear_count); pack++) {
        Candidates candidates = linear_candidates(set, &intervals, pack);
        for (; candidates.remaining; candidates.remaining &= candidates.remaining - 1) {
            int i = __builtin_ctz(candidates.remaining);
            const Shape *shape = linear_shape(set, pack, i);
            scalar distance = real_lane(candidates.near, i);
            if (beam_misses_shape(beam, &sides, shape)) {
                continue;
            }
            found->count++;
            if (!found->nearest || distance < nearest) {
                found->next_distance = found->nearest ? nearest : INFINITE;
                found->nearest = shape;
                nearest = distance;
            } else if (distance < found->next_distance) {
                found->next_distance = distance;
            }
        }
    }
}

void shape_set_narrow_candidates(const ShapeSet *set, const Beam *part,
                                 BeamCandidates *candidates) {
    const Shape *only = beam_only_shape(candidates);
    if (only && only->class->support) {
        Shaft sides;
        sides.vector_count = SHAFT_NOT_SET;
        candidates->count = !beam_misses_shape(part, &sides, only);
        candidates->nearest = candidates->count ? only : NULL;
    } else if (candidates->count > 0) {
        shape_set_find_in_beam(set, part, candidates);
    }
}

void shape_set_closest_hits(const ShapeSet *set, const Packet *packet, Hit *hits) {
    for (int v = 0; v < packet_vector_count(packet); v++) {
        hits[v] = hit_none(packet->limit[v]);
    }
    if (LANES == 1) {
        single_ray_closest_hit(set, packet, hits); // Inlined: a call per ray would show.
        return;
    }
    shape_set_update_hits(set, packet, hits);
}

void shape_set_update_hits(const ShapeSet *set, const Packet *packet, Hit *hits) {
    if (LANES == 1) {
        single_ray_closest_hit(set, packet, hits);
        return;
    }
    if (packet->has_beam && packet->only_shape) {
        shape_closest_hits(packet->only_shape, 0, packet, hits);
        return;
    }
    const PacketIntervals intervals = set_intervals(set, packet);
    Shaft sides;
    sides.vector_count = SHAFT_NOT_SET;
    for (size_t pack = 0; pack < aabb_pack_count(set->linear_count); pack++) {
        Candidates candidates = linear_candidates(set, &intervals, pack);
        while (candidates.remaining) {
            int i = candidates_pop_nearest(&candidates);
            const Shape *shape = linear_shape(set, pack, i);
            if (packet->has_beam && beam_misses_shape(&packet->beam, &sides, shape)) {
                continue;
            }
            shape_closest_hits(shape, real_lane(candidates.near, i), packet, hits);
        }
    }
    if (set->bvh.nodes) {
        set_bvh_closest_hits(set, packet, &intervals, hits);
    }
}

void shape_set_occluded(const ShapeSet *set, const Packet *packet, const PacketIntervals *known,
                        const Shape *excluded, mask *occluded) {
    if (LANES == 1) {
        single_ray_occluded(set, packet, occluded);
        return;
    }
    PacketIntervals intervals = known ? *known : set_intervals(set, packet);
    // Such a shape may be hit outside its box.
    intervals.has_region = intervals.has_region && !set->may_exceed_box;
    Shaft sides;
    sides.vector_count = SHAFT_NOT_SET;
    for (int v = 0; v < packet_vector_count(packet); v++) {
        occluded[v] = mask_of(false);
    }
    for (size_t pack = 0; pack < aabb_pack_count(set->linear_count); pack++) {
        unsigned remaining = occluding_candidates(set, &intervals, &sides, pack, excluded);
        for (; remaining; remaining &= remaining - 1) {
            shape_occluded(linear_shape(set, pack, __builtin_ctz(remaining)), packet, occluded);
        }
    }
    if (set->bvh.nodes) {
        set_bvh_occluded(set, packet, &intervals, excluded, occluded);
    }
}

void shape_set_visit(const ShapeSet *set, const Packet *packet, ShapeVisitor visitor, void *found) {
    const PacketIntervals intervals = set_intervals(set, packet);
    for (size_t pack = 0; pack < aabb_pack_count(set->linear_count); pack++) {
        unsigned remaining = linear_candidates(set, &intervals, pack).remaining;
        for (; remaining; remaining &= remaining - 1) {
            const Shape *shape = linear_shape(set, pack, __builtin_ctz(remaining));
            for (int v = 0; v < packet_vector_count(packet); v++) {
                if (any(packet->active[v])) {
                    visitor(shape, packet, v, packet->active[v], found);
                }
            }
        }
    }
    VisitRequest visit = {visitor, found};
    set_bvh_visit(set, packet, &intervals, &visit);
}
