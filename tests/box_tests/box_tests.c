/**
 * @file
 * @brief The boxes that rays meet, checked at one number type and width: the Makefile compiles
 *        this file for each engine, with the engine's flags.
 */
#include "box_tests.h"

#include "../src/trace/bvh/aabb_pack.h"
#include "../src/trace/bvh/bvh_build.c"
#include "../src/trace/bvh/bvh_single.c"
#include "../src/trace/bvh/bvh_split.c"
#include "../src/trace/shapes/watertight.h"
#include "../src/trace/tracer/packet.c"
#include "../random_scalar.h"

/** Number of boxes in a tree. */
enum { BOXES = 3000 };

/** @return A tree over boxes; the caller frees it. */
static Bvh build_tree(const Aabbs *boxes) {
    Bvh bvh;
    const ParallelFor one_thread = {0};
    if (!bvh_build(&bvh, boxes, BOXES, LANES, &one_thread)) {
        abort();
    }
    return bvh;
}

#if BVH_HAS_ORDERS

/** @return What is wrong with an order; NULL: nothing is. */
static const char *check_order(const BvhNode *node, unsigned octant) {
    const Aabb *box = &node->bounds[0];
    unsigned seen = 0;
    scalar last = INFINITE;
    for (int place = 0; place < BVH_WIDTH; place++) {
        const int child = lane_order_at(node->orders[octant], place);
        scalar advance = 0;
        bool is_there = true;
        for (int axis = 0; axis < 3; axis++) {
            scalar low = real_at(&box->planes[axis], child),
                   high = real_at(&box->planes[axis + 3], child);
            is_there = is_there && low <= high;
            advance += octant >> axis & 1 ? -(low + high) : low + high;
        }
        if (is_there && advance > last) {
            return "a farther child is nearer to the top";
        }
        last = is_there ? advance : last;
        seen |= 1u << child;
    }
    return seen == (1u << BVH_WIDTH) - 1 ? NULL : "a child is missing";
}

/** @return What is wrong with the orders of a tree over boxes; NULL: nothing is. @param is_tied
 *  Whether the boxes are points at few places, so that many are equally far. */
static const char *check_orders_of(bool is_tied, uint64_t seed) {
    static Aabbs boxes[BOXES];
    for (int i = 0; i < BOXES; i++) {
        for (int axis = 0; axis < 3; axis++) {
            scalar place = random_scalar(&seed);
            boxes[i].low[axis] = is_tied ? (scalar)(int)(3 * place) : place;
            boxes[i].high[axis] = boxes[i].low[axis] + (is_tied ? 0 : random_scalar(&seed) / 16);
        }
    }
    Bvh bvh = build_tree(boxes);
    const char *fault = NULL;
    for (size_t n = 0; n < bvh.node_count; n++) {
        for (unsigned octant = 0; octant < DIRECTION_OCTANTS && !fault; octant++) {
            fault = check_order(&bvh.nodes[n], octant);
        }
    }
    bvh_deinit(&bvh);
    return fault;
}

/** See #BOX_ORDERS. */
static const char *check_orders(uint64_t seed) {
    const char *fault = check_orders_of(false, seed);
    return fault ? fault : check_orders_of(true, seed);
}

#endif

/** A row of boxes. */
typedef struct BoxRow {
    const Aabbs *boxes; /**< The boxes. */
    const Bvh *bvh;     /**< The tree over them. */
} BoxRow;

/** Ends the ray of the first lane at the nearest box of a leaf. See #BvhIntersector.intersect_leaf.
 */
static void end_at_box(const void *items, BvhLeaf leaf, const BvhLeafRays *rays, void *visits) {
    const BoxRow *row = items;
    const uint32_t *at = &row->bvh->item_indices[leaf.first_block * LANES];
    for (size_t i = 0; i < leaf.block_count * LANES; i++) {
        Aabb box = aabb_splat(row->boxes[at[i]]);
        real near;
        mask meets = slab_intersects(&rays->packet->rays[0], &box, rays->limits[0], &near);
        rays->limits[0] = real_select(meets, near, rays->limits[0]);
    }
    ++*(unsigned *)visits;
}

/** @return A tree over boxes in a row; the caller frees it. @param along Direction of the row.
 *  @param[out] boxes The boxes: their centres are 1, 2, 3 and so on in lengths of the direction. */
static Bvh build_row(const scalar along[3], Aabbs *boxes) {
    for (int i = 0; i < BOXES; i++) {
        for (int axis = 0; axis < 3; axis++) {
            scalar middle = (scalar)(i + 1) * along[axis];
            boxes[i].low[axis] = middle - (scalar)0.25;
            boxes[i].high[axis] = middle + (scalar)0.25;
        }
    }
    return build_tree(boxes);
}

/** @return Number of leaves that a ray along a row visits. @param behind Number of boxes behind its
 *  origin. */
static unsigned count_leaves(const BoxRow *row, const scalar along[3], int behind) {
    static Packet packet;
    const Vec3 direction = {real_of(along[0]), real_of(along[1]), real_of(along[2])};
    packet_init(&packet, PACKET_VECTORS, false);
    packet.rays[0] =
        ray_of(vec3_scale(direction, real_of((scalar)behind + (scalar)0.5)), direction);
    real limits[PACKET_VECTORS] = {real_of(INFINITE)};
    const PacketLanes lanes = {{1}};
    const BvhIntersector intersector = {.items = row, .intersect_leaf = end_at_box};
    unsigned visits = 0;
    bvh_traverse_single(row->bvh, 0, &lanes, &packet, limits, &intersector, &visits);
    return visits;
}

/** @return Whether a ray along a row visits one leaf, wherever it begins. @param octant That of its
 *  direction. */
static bool row_takes_one_leaf(unsigned octant) {
    /** Number of origins: more than a node has children. */
    enum { ORIGINS = 60 };
    static Aabbs boxes[BOXES];
    scalar along[3];
    for (int axis = 0; axis < 3; axis++) {
        along[axis] = octant >> axis & 1 ? -1 : 1;
    }
    Bvh bvh = build_row(along, boxes);
    const BoxRow row = {boxes, &bvh};
    bool is_one = true;
    for (int i = 0; i < ORIGINS; i++) {
        is_one = is_one && count_leaves(&row, along, i * BOXES / ORIGINS) == 1;
    }
    bvh_deinit(&bvh);
    return is_one;
}

/** See #BOX_ROW. */
static const char *check_row(uint64_t seed) {
    (void)seed;
    const char *fault = NULL;
    for (unsigned octant = 0; octant < DIRECTION_OCTANTS && !fault; octant++) {
        fault = row_takes_one_leaf(octant) ? NULL : "a leaf behind is visited";
    }
    return fault;
}

enum {
    CASES = 20000,               /**< Number of random cases. */
    MOST_CASES = CASES * 9 / 10, /**< Nearly all of them. */
};

/** @return A random coordinate: whole ones are common, so that rays start on planes and graze them.
 */
static scalar random_coordinate(uint64_t *seed, scalar scale) {
    scalar x = 8 * random_scalar(seed) - 4;
    return scale * (random_scalar(seed) < (scalar)0.5 ? (scalar)(int)x : x);
}

/** @return A random box; some are flat. */
static Aabbs random_box(uint64_t *seed, scalar scale) {
    Aabbs box;
    for (int axis = 0; axis < 3; axis++) {
        scalar a = random_coordinate(seed, scale), b = random_coordinate(seed, scale);
        box.low[axis] = a < b ? a : b;
        box.high[axis] = a < b ? b : a;
    }
    return box;
}

/** Lengths of directions. */
typedef struct Lengths {
    scalar usual; /**< Most components. */
    scalar tiny;  /**< The others, relative to that. */
} Lengths;

/** @return Random lengths: some are very long, some short. */
static Lengths random_lengths(uint64_t *seed) {
    const scalar tiny = REAL_BITS > 64 ? (scalar)1e-40L : (scalar)1e-18, kind = random_scalar(seed);
    return (Lengths){kind < (scalar)0.5    ? 1
                     : kind < (scalar)0.75 ? 1 / tiny
                                           : (scalar)0.03125,
                     tiny};
}

/** @return LANES random rays; some are parallel to planes, or nearly so. */
static Ray random_rays(uint64_t *seed, scalar scale, Lengths lengths) {
    real numbers[6];
    for (int i = 0; i < 6; i++) {
        for (int lane = 0; lane < LANES; lane++) {
            scalar x = random_coordinate(seed, i < 3 ? scale : lengths.usual);
            x *= i >= 3 && random_scalar(seed) < (scalar)0.25 ? lengths.tiny : 1;
            real_set_lane(&numbers[i], lane, x);
        }
    }
    return ray_of((Vec3){numbers[0], numbers[1], numbers[2]},
                  (Vec3){numbers[3], numbers[4], numbers[5]});
}

/** @return A size of coordinates: from where products of float vanish to where quad exceeds float.
 */
static scalar scale_of(size_t i) {
    const scalar scales[] = {(scalar)1e-30,
                             (scalar)1e-19,
                             1,
                             (scalar)1e6,
                             (scalar)1e30,
                             REAL_BITS > 64 ? (scalar)8e37 : 1,
                             REAL_BITS > 64 ? (scalar)1e45L : 1};
    return scales[i % (sizeof scales / sizeof *scales)];
}

#if LANES == 1

/** Checks a pack of boxes with one ray. @return What is wrong; NULL: nothing is. */
static const char *check_pack(uint64_t *seed, scalar scale) {
    AabbPack pack;
    Aabbs boxes[AABB_PACK_SIZE];
    for (int i = 0; i < AABB_PACK_SIZE; i++) {
        boxes[i] = random_box(seed, scale);
        aabb_pack_set(&pack, (size_t)i, boxes[i]);
    }
    const Ray ray = random_rays(seed, scale, random_lengths(seed));
    const scalar limit = random_scalar(seed) < (scalar)0.5 ? INFINITE : scale;
    PackReal nears[PACK_VECTORS];
    unsigned bits = aabb_pack_meets(&ray, &pack, &SLAB_ORDERS[octant_of(&ray.inverse_direction, 0)],
                                    limit, PACK_VECTORS, nears);
    for (int i = 0; i < AABB_PACK_SIZE; i++) {
        Aabb box = aabb_splat(boxes[i]);
        real near;
        if (!slab_intersects(&ray, &box, limit, &near)) {
            continue;
        }
        if (!(bits >> i & 1) || (scalar)pack_lane(nears, i) > near) {
            return bits >> i & 1 ? "a bound is too far" : "a box is missed";
        }
    }
    return NULL;
}

/** See #BOX_PACKS. */
static const char *check_packs(uint64_t seed) {
    const char *fault = NULL;
    for (size_t i = 0; i < CASES && !fault; i++) {
        fault = check_pack(&seed, scale_of(i));
    }
    return fault;
}

#if REAL_BITS <= 64

/** @return A ray to a corner of a quad, to the middle of an edge or between all corners. */
static Ray ray_to_quad(uint64_t *seed, scalar scale, const Vertex *corners) {
    const int last = (int)(4 * random_scalar(seed)),
              count = (int[]){1, 2, QUAD_CORNERS}[(int)(3 * random_scalar(seed))];
    scalar origin[3], direction[3];
    for (int axis = 0; axis < 3; axis++) {
        scalar sum = 0;
        for (int i = 0; i < count; i++) {
            sum += corners[(last + i) % QUAD_CORNERS].xyz[axis] / (scalar)count;
        }
        origin[axis] = random_coordinate(seed, scale);
        direction[axis] = sum - origin[axis];
    }
    return ray_of((Vec3){real_of(origin[0]), real_of(origin[1]), real_of(origin[2])},
                  (Vec3){real_of(direction[0]), real_of(direction[1]), real_of(direction[2])});
}

/** See #BOX_QUADS. */
static const char *check_quads(uint64_t seed) {
    size_t hits = 0;
    for (size_t i = 0; i < CASES; i++) {
        // Beyond the range, products are infinite, and their differences NaN.
        const scalar scale = i % 8 == 7 && REAL_BITS == 64 ? (scalar)1e200 : scale_of(i);
        Vertex vertices[QUAD_CORNERS];
        for (int corner = 0; corner < QUAD_CORNERS; corner++) {
            bool is_repeated = corner > 0 && random_scalar(&seed) < (scalar)0.125;
            for (int axis = 0; axis < 3; axis++) {
                vertices[corner].xyz[axis] =
                    is_repeated ? vertices[corner - 1].xyz[axis] : random_coordinate(&seed, scale);
            }
        }
        const bool is_aimed = random_scalar(&seed) < (scalar)0.75;
        const Ray ray = is_aimed ? ray_to_quad(&seed, scale, vertices)
                                 : random_rays(&seed, scale, random_lengths(&seed));
        const QuadCorners corners = quad_corners_of(vertices);
        const mask active = mask_of(random_scalar(&seed) < (scalar)0.875);
        const mask contains = polygon_contains_ray(vertices, QUAD_CORNERS, &ray, active);
        if (quad_contains_ray(&corners, &ray, active) != contains) {
            return "a quad and its polygon are not met by the same rays";
        }
        hits += any(contains);
    }
    return hits > CASES / 8 && hits < CASES / 2 ? NULL : "rays hit too few quads or too many";
}

#endif

#else

/** @return A packet of random rays that mostly go the same way along one axis. */
static Packet random_packet(uint64_t *seed, scalar scale) {
    Packet packet;
    packet_init(&packet, PACKET_VECTORS, true);
    const Lengths lengths = random_lengths(seed);
    const real limit = real_of(random_scalar(seed) < (scalar)0.5 ? INFINITE : scale);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Ray rays = random_rays(seed, scale, lengths);
        rays.direction.x = real_abs(rays.direction.x);
        rays.origin.y = real_of(scale); // As from one point: it may lie in a plane.
        packet.rays[v] = ray_of(rays.origin, rays.direction);
        packet.active[v] = mask_of(true);
        packet.limit[v] = limit;
    }
    return packet;
}

/** Checks intervals with the rays of some vectors. @return What is wrong; NULL: nothing is. */
static const char *check_kept(const Packet *packet, int first, int end,
                              const PacketIntervals *intervals, const Aabb *boxes) {
    real nearest;
    mask may_hit = packet_intervals_may_hit(intervals, boxes, &nearest);
    for (int i = 0; i < LANES; i++) {
        Aabb box = aabb_splat_lane(boxes, i, &SLAB_ORDERS[0]);
        for (int v = first; v < end; v++) {
            real near;
            mask meets = slab_intersects(&packet->rays[v], &box, packet->limit[v], &near);
            if (any(meets) && !mask_lane(may_hit, i)) {
                return "a box is missed";
            }
            if (any(meets & (near < real_of(real_lane(nearest, i))))) {
                return "a bound is too far";
            }
        }
    }
    return NULL;
}

/** See #BOX_INTERVALS. */
static const char *check_intervals(uint64_t seed) {
    const char *fault = NULL;
    for (size_t i = 0; i < CASES / LANES && !fault; i++) {
        Aabb boxes;
        for (int lane = 0; lane < LANES; lane++) {
            Aabbs box = random_box(&seed, scale_of(i));
            for (int axis = 0; axis < 3; axis++) {
                real_set_lane(&boxes.planes[axis], lane, box.low[axis]);
                real_set_lane(&boxes.planes[axis + 3], lane, box.high[axis]);
            }
        }
        const Packet packet = random_packet(&seed, scale_of(i));
        PacketIntervals intervals = packet_intervals(&packet);
        fault = check_kept(&packet, 0, PACKET_VECTORS, &intervals, &boxes);
        const int v = (int)(i % PACKET_VECTORS);
        intervals = packet_vector_intervals(&packet, v);
        fault = fault ? fault : check_kept(&packet, v, v + 1, &intervals, &boxes);
    }
    return fault;
}

#endif

extern const BoxChecks CHECKS;
const BoxChecks CHECKS = {{
#if BVH_HAS_ORDERS
    [BOX_ORDERS] = check_orders,
#endif
    [BOX_ROW] = check_row,
#if LANES == 1
    [BOX_PACKS] = check_packs,
#if REAL_BITS <= 64
    [BOX_QUADS] = check_quads,
#endif
#else
    [BOX_INTERVALS] = check_intervals,
#endif
}};
