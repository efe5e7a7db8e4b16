/**
 * @file
 * @brief The boxes that one ray meets, checked at one number type and width: the Makefile compiles
 *        this file for each engine, with the engine's flags.
 */
#include "box_tests.h"

#include "../src/trace/bvh/aabb_pack.h"
#include "../src/trace/bvh/bvh_build.c"
#include "../src/trace/bvh/bvh_single.c"
#include "../src/trace/bvh/bvh_split.c"

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

#if BVH_HAS_ORDERS || LANES == 1

/** @return A random number, 0 to 1 (Knuth's linear congruential generator). */
static scalar random_scalar(uint64_t *state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (scalar)(*state >> 40) / (scalar)0x1000000;
}

#endif

#if BVH_HAS_ORDERS

/** @return What is wrong with an order; NULL: nothing is. */
static const char *check_order(const BvhNode *node, unsigned octant) {
    const Aabb *box = &node->bounds[0];
    unsigned seen = 0;
    scalar last = INFINITE;
    for (int place = 0; place < BVH_WIDTH; place++) {
        const int child = node->orders[octant][place];
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

static const char *check_nodes(uint64_t seed) {
    static Aabbs boxes[BOXES];
    for (int i = 0; i < BOXES; i++) {
        for (int axis = 0; axis < 3; axis++) {
            boxes[i].low[axis] = random_scalar(&seed);
            boxes[i].high[axis] = boxes[i].low[axis] + random_scalar(&seed) / 16;
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

#else

static const char *check_nodes(uint64_t seed) {
    (void)seed;
    return NULL;
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

static unsigned count_leaves(unsigned octant) {
    static Aabbs boxes[BOXES];
    scalar along[3];
    for (int axis = 0; axis < 3; axis++) {
        along[axis] = octant >> axis & 1 ? -1 : 1;
    }
    for (int i = 0; i < BOXES; i++) {
        for (int axis = 0; axis < 3; axis++) {
            scalar middle = (scalar)(i + 1) * along[axis];
            boxes[i].low[axis] = middle - (scalar)0.25;
            boxes[i].high[axis] = middle + (scalar)0.25;
        }
    }
    Bvh bvh = build_tree(boxes);
    static Packet packet;
    const Vec3 zero = {real_of(0), real_of(0), real_of(0)};
    packet.rays[0] = ray_of(zero, (Vec3){real_of(along[0]), real_of(along[1]), real_of(along[2])});
    real limits[PACKET_VECTORS] = {real_of(INFINITE)};
    const PacketLanes lanes = {{1}};
    const BoxRow row = {boxes, &bvh};
    const BvhIntersector intersector = {.items = &row, .intersect_leaf = end_at_box};
    unsigned visits = 0;
    bvh_traverse_single(&bvh, 0, &lanes, &packet, limits, &intersector, &visits);
    bvh_deinit(&bvh);
    return visits;
}

#if LANES == 1

/** Number of packs. */
enum { PACKS = 20000 };

/** @return A random coordinate: whole ones are common, so that rays start on planes and graze them.
 */
static scalar random_coordinate(uint64_t *seed, scalar scale) {
    scalar x = 8 * random_scalar(seed) - 4;
    return scale * (random_scalar(seed) < (scalar)0.5 ? (scalar)(int)x : x);
}

/** @return A random ray; some are parallel to planes, or nearly so, some very long, some short. */
static Ray random_ray(uint64_t *seed, scalar scale) {
    const scalar tiny = REAL_BITS > 64 ? (scalar)1e-40L : (scalar)1e-18, kind = random_scalar(seed),
                 length = kind < (scalar)0.5    ? 1
                          : kind < (scalar)0.75 ? 1 / tiny
                                                : (scalar)0.03125;
    scalar numbers[6];
    for (int i = 0; i < 6; i++) {
        numbers[i] = random_coordinate(seed, i < 3 ? scale : length);
        numbers[i] *= i >= 3 && random_scalar(seed) < (scalar)0.25 ? tiny : 1;
    }
    return ray_of((Vec3){numbers[0], numbers[1], numbers[2]},
                  (Vec3){numbers[3], numbers[4], numbers[5]});
}

/** Checks a pack of boxes with one ray. @return What is wrong; NULL: nothing is. */
static const char *check_pack(uint64_t *seed, scalar scale) {
    AabbPack pack;
    Aabbs boxes[AABB_PACK_SIZE];
    for (int i = 0; i < AABB_PACK_SIZE; i++) {
        for (int axis = 0; axis < 3; axis++) {
            scalar a = random_coordinate(seed, scale), b = random_coordinate(seed, scale);
            boxes[i].low[axis] = a < b ? a : b;
            boxes[i].high[axis] = a < b ? b : a;
        }
        aabb_pack_set(&pack, (size_t)i, boxes[i]);
    }
    const Ray ray = random_ray(seed, scale);
    const scalar limit = random_scalar(seed) < (scalar)0.5 ? INFINITE : scale;
    PackReal nears[PACK_VECTORS];
    unsigned bits = aabb_pack_meets(&ray, &pack, &SLAB_ORDERS[octant_of(&ray.inverse_direction, 0)],
                                    limit, PACK_VECTORS, nears);
    for (int i = 0; i < AABB_PACK_SIZE; i++) {
        Aabb box = aabb_splat(boxes[i]);
        real near;
        if (slab_intersects(&ray, &box, limit, &near)) {
            if (!(bits >> i & 1)) {
                return "a box is missed";
            }
            if ((scalar)pack_lane(nears, i) > near) {
                return "a box is nearer";
            }
        }
    }
    return NULL;
}

static const char *check_packs(uint64_t seed) {
    /** From where products of float vanish to where quad exceeds float. */
    const scalar scales[] = {(scalar)1e-30, (scalar)1e-19, 1,
                             (scalar)1e6,   (scalar)1e30,  REAL_BITS > 64 ? (scalar)1e45 : 1};
    const char *fault = NULL;
    for (size_t i = 0; i < PACKS && !fault; i++) {
        fault = check_pack(&seed, scales[i % (sizeof scales / sizeof *scales)]);
    }
    return fault;
}

#else

static const char *check_packs(uint64_t seed) {
    (void)seed;
    return NULL;
}

#endif

extern const BoxChecks CHECKS;
const BoxChecks CHECKS = {check_nodes, count_leaves, check_packs};
