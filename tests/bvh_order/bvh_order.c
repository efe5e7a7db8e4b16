/**
 * @file
 * @brief The order in which a ray meets the children of nodes, checked at one number type and
 *        width: the Makefile compiles this file for each engine, with the engine's flags.
 */
#include "bvh_order.h"

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

#if BVH_HAS_ORDERS

/** @return A random number, 0 to 1 (Knuth's linear congruential generator). */
static scalar random_scalar(uint64_t *state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (scalar)(*state >> 40) / (scalar)0x1000000;
}

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

extern const BvhOrderChecks CHECKS;
const BvhOrderChecks CHECKS = {check_nodes, count_leaves};
