/**
 * @file
 * @brief Traversal of a BVH with a packet of rays.
 *
 * Interval arithmetic first tests the boxes of a node for the whole packet at once; the remaining
 * ones are tested for the vectors of rays that reached the node. A stack holds the children, the
 * nearest on top.
 */
#include "trace/bvh/bvh.h"

/** Number of rays up to which they are traversed one by one. Reflected rays take longer with fewer,
 *  camera rays with more (measured with 4, 8, 12, 16, 24, 32). */
enum { PACKET_SINGLE_RAY_THRESHOLD = 8 };

/** An entry of the stack: a child. */
typedef struct PacketStackEntry {
    scalar near;       /**< Lower bound on the distances in the child. */
    uint32_t child;    /**< As in #BvhNode.children. */
    PacketLanes lanes; /**< The rays that may meet it. */
} PacketStackEntry;

/** How the rays of a packet meet the planes of boxes. */
typedef struct PacketSlabOrder {
    const SlabOrder *planes; /**< The order; along a mixed axis, the lower plane is the first. */
    unsigned mixed_axes;     /**< Bit i is set where rays go both ways along axis i. */
} PacketSlabOrder;

/** State of the traversal. */
typedef struct PacketTraversal {
    const Packet *packet;                   /**< The rays. */
    PacketIntervals intervals;              /**< Bounds of origins and directions. */
    PacketSlabOrder order;                  /**< How the rays meet the planes of boxes. */
    real *limits;                           /**< Largest distances per vector. */
    PacketStackEntry stack[BVH_STACK_SIZE]; /**< The stack. */
    int stack_size;                         /**< Number of entries. */
} PacketTraversal;

/** Inserts a child in the order of distances. @param first First entry of the same node. */
static void packet_traversal_push(PacketTraversal *traversal, int first, PacketStackEntry entry) {
    int i = traversal->stack_size++;
    for (; i > first && traversal->stack[i - 1].near < entry.near; i--) {
        traversal->stack[i] = traversal->stack[i - 1];
    }
    traversal->stack[i] = entry;
}

/**
 * Finds the rays that meet the box of a child.
 * @param box             The box in all lanes, its planes in the order of the traversal.
 * @param mixed_axes      See #PacketSlabOrder; an argument, so that the loop is compiled without
 *                        them, too.
 * @param lanes           The rays that reached the node.
 * @param[out] hit_lanes  The rays that meet the box.
 * @return Whether there are any.
 */
INLINE bool packet_traversal_test_child(const PacketTraversal *traversal, const Aabb *box,
                                        unsigned mixed_axes, const PacketLanes *lanes,
                                        PacketLanes *hit_lanes) {
    unsigned hit_bits = 0;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        hit_lanes->bits[v] = 0;
        if (lanes->bits[v]) {
            const Ray *ray = &traversal->packet->rays[v];
            SlabSpan span = slab_span(ray->origin, ray->inverse_direction, box, &SLAB_ORDERS[0],
                                      mixed_axes, traversal->limits[v]);
            unsigned bits = real_less_equal_bits(span.near, span.far) & lanes->bits[v];
            hit_lanes->bits[v] = (uint16_t)bits;
            hit_bits |= bits;
        }
    }
    return hit_bits != 0;
}

/** Pushes the children that rays may meet. @param lanes The rays that reached the node. */
static void packet_traversal_visit_node(PacketTraversal *traversal, const BvhNode *node,
                                        const PacketLanes *lanes) {
    const PacketSlabOrder order = traversal->order;
    int first = traversal->stack_size;
    for (int b = 0; b < BVH_NODE_VECTORS; b++) {
        real near;
        unsigned left =
            mask_bits(packet_intervals_may_hit(&traversal->intervals, &node->bounds[b], &near));
        for (; left; left &= left - 1) {
            int lane = __builtin_ctz(left);
            PacketStackEntry entry = {
                real_at(&near, lane), node->children[b * LANES + lane], {{0}}};
            Aabb box = aabb_splat_lane(&node->bounds[b], lane, order.planes);
            if (order.mixed_axes == 0
                    ? packet_traversal_test_child(traversal, &box, 0, lanes, &entry.lanes)
                    : packet_traversal_test_child(traversal, &box, order.mixed_axes, lanes,
                                                  &entry.lanes)) {
                packet_traversal_push(traversal, first, entry);
            }
        }
    }
}

/** Removes rays whose limit is now nearer than the child. @return Whether any is left. */
static bool packet_traversal_cull_entry(const PacketTraversal *traversal, PacketStackEntry *entry) {
    unsigned left = 0;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        if (entry->lanes.bits[v]) {
            unsigned reaching = real_less_equal_bits(real_of(entry->near), traversal->limits[v]);
            entry->lanes.bits[v] = (uint16_t)(entry->lanes.bits[v] & reaching);
            left |= entry->lanes.bits[v];
        }
    }
    return left != 0;
}

/** Intersects the rays with a leaf. */
static void packet_traversal_visit_leaf(PacketTraversal *traversal,
                                        const BvhIntersector *intersector,
                                        const PacketStackEntry *leaf, void *results) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        if (leaf->lanes.bits[v]) {
            BvhLeafRays rays = {traversal->packet, v, leaf->lanes.bits[v], traversal->limits};
            intersector->intersect_leaf(intersector->items, bvh_leaf_decode(leaf->child), &rays,
                                        results);
        }
    }
}

/** @return How the rays of a packet meet the planes of boxes. */
static PacketSlabOrder packet_slab_order(const PacketIntervals *intervals) {
    unsigned octant = 0, mixed_axes = 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        const AxisInterval *span = &intervals->axis[axis];
        bool is_positive = span->inverse_low > 0, is_negative = span->inverse_high < 0;
        octant |= (is_negative ? 1u : 0u) << axis;
        mixed_axes |= (is_positive || is_negative ? 0u : 1u) << axis;
    }
    return (PacketSlabOrder){&SLAB_ORDERS[octant], mixed_axes};
}

/** @return Number of rays in a set. */
static int packet_lanes_count(const PacketLanes *lanes) {
    int count = 0;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        count += __builtin_popcount(lanes->bits[v]);
    }
    return count;
}

/** Pops a child: traversed by its rays together, or one by one if they are few. */
static void packet_traversal_step(PacketTraversal *traversal, const Bvh *bvh,
                                  const BvhIntersector *intersector, void *results) {
    PacketStackEntry entry = traversal->stack[--traversal->stack_size];
    if (traversal->stack_size > 0) {
        bvh_prefetch(bvh, intersector, traversal->stack[traversal->stack_size - 1].child);
    }
    if (!packet_traversal_cull_entry(traversal, &entry)) {
        return;
    }
    if (entry.child & BVH_LEAF_BIT) {
        packet_traversal_visit_leaf(traversal, intersector, &entry, results);
    } else if (!intersector->prefers_vectors &&
               packet_lanes_count(&entry.lanes) <= PACKET_SINGLE_RAY_THRESHOLD) {
        bvh_traverse_single(bvh, entry.child, &entry.lanes, traversal->packet, traversal->limits,
                            intersector, results);
    } else {
        packet_traversal_visit_node(traversal, &bvh->nodes[entry.child], &entry.lanes);
    }
}

void bvh_traverse(const Bvh *bvh, const Packet *packet, const PacketIntervals *intervals,
                  real *limits, const BvhIntersector *intersector, void *results) {
    PacketTraversal traversal;
    traversal.packet = packet;
    traversal.limits = limits;
    traversal.stack[0] = (PacketStackEntry){0};
    for (int v = 0; v < packet_vector_count(packet); v++) {
        traversal.stack[0].lanes.bits[v] = (uint16_t)mask_bits(packet->active[v]);
    }
    traversal.intervals = *intervals;
    traversal.order = packet_slab_order(intervals);
    // In a coherent packet all rays go the same way along at least one axis.
    bool is_coherent = traversal.order.mixed_axes != ALL_AXES;
    if (LANES == 1 || (!intersector->prefers_vectors && !is_coherent)) {
        bvh_traverse_single(bvh, 0, &traversal.stack[0].lanes, packet, limits, intersector,
                            results);
        return;
    }
    traversal.stack_size = 1;
    while (traversal.stack_size > 0) {
        packet_traversal_step(&traversal, bvh, intersector, results);
    }
}
