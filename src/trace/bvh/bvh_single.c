/**
 * @file
 * @brief Traversal of a BVH ray by ray, several of them interleaved.
 *
 * Incoherent rays wait for memory at nearly every node. Several rays therefore take one step each
 * in turn, and the memory for the next step of a ray is prefetched during the steps of the others.
 * All boxes of a node are tested at once against one ray.
 */
#include "trace/bvh/bvh.h"
#include "trace/bvh/slab.h"

/** Number of interleaved rays: more gain nothing (measured on a mesh larger than all caches). */
enum { RAYS_IN_FLIGHT = 8 };

/** An entry of the stack: a child. */
typedef struct SingleStackEntry {
    scalar near;    /**< Lower bound on the distance in the child. */
    uint32_t child; /**< As in #BvhNode.children. */
} SingleStackEntry;

/** State of the traversal of one ray. */
typedef struct SingleTraversal {
    const Ray *ray;                         /**< Its vector of the packet. */
    int vector_index;                       /**< Index of that vector. */
    int lane;                               /**< Its lane. */
    SlabOrder slab_order;                   /**< Planes of a box in the order it meets them. */
    bool is_active;                         /**< Whether the traversal is not finished. */
    scalar limit;                           /**< Largest distance. */
    int stack_size;                         /**< Number of entries. */
    SingleStackEntry stack[BVH_STACK_SIZE]; /**< The stack, the nearest child on top. */
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
    const Vec3 *inverse = &batch->packet->rays[v].inverse_direction;
    traversal->ray = &batch->packet->rays[v];
    slab_order_set(&traversal->slab_order, 0, real_at(&inverse->x, lane) < 0);
    slab_order_set(&traversal->slab_order, 1, real_at(&inverse->y, lane) < 0);
    slab_order_set(&traversal->slab_order, 2, real_at(&inverse->z, lane) < 0);
    traversal->vector_index = v;
    traversal->lane = lane;
    traversal->limit = real_at(&batch->limits[v], lane);
    traversal->stack[0] = (SingleStackEntry){.child = batch->root};
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

/** Inserts a child in the order of distances. @param first First entry of the same node. */
INLINE void single_traversal_push(SingleTraversal *traversal, int first, SingleStackEntry entry) {
    int i = traversal->stack_size++;
    for (; i > first && traversal->stack[i - 1].near < entry.near; i--) {
        traversal->stack[i] = traversal->stack[i - 1];
    }
    traversal->stack[i] = entry;
}

/** Pushes the children that the ray may meet. */
static void single_traversal_visit_node(SingleTraversal *traversal, const BvhNode *node) {
    int first = traversal->stack_size, ray_lane = traversal->lane;
    Vec3 origin = vec3_splat_lane(&traversal->ray->origin, ray_lane);
    Vec3 inverse = vec3_splat_lane(&traversal->ray->inverse_direction, ray_lane);
    for (int b = 0; b < BVH_NODE_VECTORS; b++) {
        real near;
        unsigned left =
            slab_intersects_ordered(origin, inverse, &node->bounds[b], &traversal->slab_order,
                                    real_of(traversal->limit), &near);
        for (; left; left &= left - 1) {
            int lane = __builtin_ctz(left);
            SingleStackEntry entry = {real_at(&near, lane), node->children[b * LANES + lane]};
            single_traversal_push(traversal, first, entry);
        }
    }
}

/** Takes one step. @return false if the traversal is finished. */
static bool single_traversal_step(SingleTraversalBatch *batch, SingleTraversal *traversal) {
    SingleStackEntry entry;
    do {
        if (traversal->stack_size == 0) {
            return false;
        }
        entry = traversal->stack[--traversal->stack_size];
    } while (entry.near > traversal->limit);
    if (entry.child & BVH_LEAF_BIT) {
        BvhLeafRays rays = {batch->packet, traversal->vector_index, 1u << traversal->lane,
                            batch->limits};
        batch->intersector->intersect_leaf(batch->intersector->items, bvh_leaf_decode(entry.child),
                                           &rays, batch->results);
        traversal->limit = real_at(&batch->limits[traversal->vector_index], traversal->lane);
        // An occluded shadow ray is finished.
        traversal->stack_size = traversal->limit < 0 ? 0 : traversal->stack_size;
    } else {
        single_traversal_visit_node(traversal, &batch->bvh->nodes[entry.child]);
    }
    if (traversal->stack_size > 0) {
        bvh_prefetch(batch->bvh, batch->intersector,
                     traversal->stack[traversal->stack_size - 1].child);
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
