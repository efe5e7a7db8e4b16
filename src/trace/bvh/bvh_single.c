/**
 * @file
 * @brief Traversal of a BVH ray by ray, several of them interleaved.
 *
 * Incoherent rays wait for memory at nearly every node. Several rays therefore take one step each
 * in turn, and the memory for the next step of a ray is prefetched during the steps of the others.
 * All boxes of a node are tested at once against one ray.
 */
#include "trace/bvh/bvh.h"
#include "trace/math/columns.h"

/** Number of interleaved rays: more gain nothing (measured on a mesh larger than all caches). */
enum { RAYS_IN_FLIGHT = 8 };

/** The children that a ray may meet, roughly the nearest on top. A vector may be written beyond. */
typedef struct SingleStack {
    scalar near[BVH_STACK_SIZE + LANES];             /**< Lower bounds on their distances. */
    integer_scalar children[BVH_STACK_SIZE + LANES]; /**< As in #BvhNode.children. */
} SingleStack;

/** State of the traversal of one ray. */
typedef struct SingleTraversal {
    const Ray *ray;    /**< Its vector of the packet. */
    int vector_index;  /**< Index of that vector. */
    int lane;          /**< Its lane. */
    unsigned octant;   /**< The octant of its direction. */
    bool is_active;    /**< Whether the traversal is not finished. */
    scalar limit;      /**< Largest distance. */
    int stack_size;    /**< Number of entries of #stack. */
    SingleStack stack; /**< The children to visit. */
} SingleTraversal;

/** What the rays of a packet share. */
typedef struct SingleTraversalBatch {
    const Bvh *bvh;                    /**< The tree. */
    uint32_t root;                     /**< Root of the subtree, as in #BvhNode.children. */
    const Packet *packet;              /**< The rays. */
    PacketLanes pending;               /**< Rays that have not started yet. */
    int next_vector;                   /**< First vector with such rays. */
    real *limits;                      /**< Largest distances per vector. */
    const BvhIntersector *intersector; /**< Intersects the leaves. */
    void *results;                     /**< Its results. */
} SingleTraversalBatch;

/** Starts the traversal of a ray. */
static void single_traversal_init(const SingleTraversalBatch *batch, SingleTraversal *traversal,
                                  int v, int lane) {
    const Ray *ray = &batch->packet->rays[v];
    traversal->ray = ray;
    traversal->vector_index = v;
    traversal->lane = lane;
    traversal->octant = octant_of(&ray->inverse_direction, lane);
    traversal->limit = real_at(&batch->limits[v], lane);
    traversal->stack.near[0] = 0;
    traversal->stack.children[0] = (integer_scalar)batch->root;
    traversal->stack_size = 1;
}

/** Starts the next ray of a packet, if there is one. */
static void single_traversal_start_next(SingleTraversalBatch *batch, SingleTraversal *traversal) {
    while (batch->next_vector < PACKET_VECTORS && batch->pending.bits[batch->next_vector] == 0) {
        batch->next_vector++;
    }
    traversal->is_active = batch->next_vector < PACKET_VECTORS;
    if (traversal->is_active) {
        uint16_t *left = &batch->pending.bits[batch->next_vector];
        single_traversal_init(batch, traversal, batch->next_vector, __builtin_ctz(*left));
        *left = (uint16_t)(*left & (*left - 1));
    }
}

/** Intersects a ray with the boxes of some children. @param b Index of their vector in the node.
 *  @param[out] near Lower bounds on the distances. */
INLINE mask single_traversal_meets(const SingleTraversal *traversal, const BvhNode *node, int b,
                                   real *near) {
    Vec3 origin = vec3_splat_lane(&traversal->ray->origin, traversal->lane);
    Vec3 inverse = vec3_splat_lane(&traversal->ray->inverse_direction, traversal->lane);
    SlabSpan span = slab_span(origin, inverse, &node->bounds[b], &SLAB_ORDERS[traversal->octant], 0,
                              real_of(traversal->limit));
    *near = span.near;
    return span.near <= span.far;
}

#if BVH_HAS_ORDERS

/** Pushes the children that the ray may meet. Their order is known, so that no branch depends on
 *  it (Fuetterling and others, *Accelerated Single Ray Tracing for Wide Vector Units*, 2017). */
static void single_traversal_visit_node(SingleTraversal *traversal, const BvhNode *node) {
    const real none = real_of(-1);
    integer order = lane_order_unpack(node->orders[traversal->octant]);
    SingleStack *stack = &traversal->stack;
    real near;
    mask meets = single_traversal_meets(traversal, node, 0, &near);
    near = real_select(meets, near, none);
    near = real_permute(&near, order);
    integer children = integer_load((const integer_scalar *)(const void *)node->children);
    unsigned bits = real_less_equal_bits(real_of(0), near);
    real_compress(stack->near + traversal->stack_size, near, bits);
    integer_compress(stack->children + traversal->stack_size, integer_permute(children, order),
                     bits);
    traversal->stack_size += __builtin_popcount(bits);
}

#else

/** Inserts a child in the order of distances. @param first First entry of the same node. */
INLINE void single_traversal_push(SingleTraversal *traversal, int first, scalar near,
                                  uint32_t child) {
    SingleStack *stack = &traversal->stack;
    int i = traversal->stack_size++;
    for (; i > first && stack->near[i - 1] < near; i--) {
        stack->near[i] = stack->near[i - 1];
        stack->children[i] = stack->children[i - 1];
    }
    stack->near[i] = near;
    stack->children[i] = (integer_scalar)child;
}

/** Pushes the children that the ray may meet. */
static void single_traversal_visit_node(SingleTraversal *traversal, const BvhNode *node) {
    int first = traversal->stack_size;
    for (int b = 0; b < BVH_NODE_VECTORS; b++) {
        real near;
        unsigned left = mask_bits(single_traversal_meets(traversal, node, b, &near));
        for (; left; left &= left - 1) {
            int lane = __builtin_ctz(left);
            single_traversal_push(traversal, first, real_at(&near, lane),
                                  node->children[b * LANES + lane]);
        }
    }
}

#endif

/** Takes one step. @return false if the traversal is finished. */
static bool single_traversal_step(SingleTraversalBatch *batch, SingleTraversal *traversal) {
    SingleStack *stack = &traversal->stack;
    do {
        if (traversal->stack_size == 0) {
            return false;
        }
        traversal->stack_size--;
    } while (stack->near[traversal->stack_size] > traversal->limit);
    uint32_t child = (uint32_t)stack->children[traversal->stack_size];
    if (child & BVH_LEAF_BIT) {
        BvhLeafRays rays = {batch->packet, traversal->vector_index, 1u << traversal->lane,
                            batch->limits};
        batch->intersector->intersect_leaf(batch->intersector->items, bvh_leaf_decode(child), &rays,
                                           batch->results);
        traversal->limit = real_at(&batch->limits[traversal->vector_index], traversal->lane);
        // An occluded shadow ray is finished.
        traversal->stack_size = traversal->limit < 0 ? 0 : traversal->stack_size;
    } else {
        single_traversal_visit_node(traversal, &batch->bvh->nodes[child]);
    }
    if (traversal->stack_size > 0) {
        bvh_prefetch(batch->bvh, batch->intersector,
                     (uint32_t)stack->children[traversal->stack_size - 1]);
    }
    return true;
}

void bvh_traverse_single(const Bvh *bvh, uint32_t child, const PacketLanes *lanes,
                         const Packet *packet, real *limits, const BvhIntersector *intersector,
                         void *results) {
    SingleTraversalBatch batch = {bvh, child, packet, *lanes, 0, limits, intersector, results};
    SingleTraversal traversals[RAYS_IN_FLIGHT], *const end = traversals + RAYS_IN_FLIGHT;
    int active_count = 0;
    for (SingleTraversal *traversal = traversals; traversal < end; traversal++) {
        single_traversal_start_next(&batch, traversal);
        active_count += traversal->is_active;
    }
    for (SingleTraversal *traversal = traversals; active_count > 0;
         traversal = traversal + 1 < end ? traversal + 1 : traversals) {
        if (traversal->is_active && !single_traversal_step(&batch, traversal)) {
            single_traversal_start_next(&batch, traversal);
            active_count -= !traversal->is_active;
        }
    }
}
