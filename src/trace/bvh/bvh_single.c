/**
 * @file
 * @brief Going through a tree ray by ray, several in flight.
 *
 * Rays that share nothing wait for memory at nearly every node. So several are on their way at
 * once, each takes one step in turn, and what its next step needs is fetched while the others take
 * theirs. A node's boxes are tested side by side against the one ray.
 */
#include "trace/bvh/bvh.h"
#include "trace/bvh/slab.h"

/** Rays in flight: more gain nothing (measured on a mesh that fits no cache). */
enum { RAYS_IN_FLIGHT = 8 };

/** A child that waits. */
typedef struct SingleStackEntry {
    scalar near;    /**< The ray meets nothing in it nearer than this. */
    uint32_t child; /**< A node or a leaf, see #BvhNode.children. */
} SingleStackEntry;

/** A ray on its way. */
typedef struct SingleTraversal {
    const Ray *ray;                         /**< Its vector of the packet. */
    int vector_index;                       /**< Which that is. */
    int lane;                               /**< Its lane of it. */
    SlabOrder slab_order;                   /**< Which of a box's planes it meets first. */
    bool is_active;                         /**< Whether it has not come to its end. */
    scalar limit;                           /**< How far it still looks. */
    int stack_size;                         /**< How many children wait. */
    SingleStackEntry stack[BVH_STACK_SIZE]; /**< What waits, the nearest on top. */
} SingleTraversal;

/** What a packet of rays and a tree share while its rays fly. */
typedef struct SingleTraversalBatch {
    const Bvh *bvh;                    /**< The tree. */
    uint32_t root;                     /**< Where they begin. */
    const Packet *packet;              /**< The rays. */
    PacketLanes pending;               /**< Those that have not flown yet. */
    int next_vector;                   /**< The first vector of those. */
    real *limits;                      /**< How far they look. */
    const BvhIntersector *intersector; /**< Who is asked. */
    void *results;                     /**< The owner's. */
} SingleTraversalBatch;

/** @return One of LANES points in all lanes. */
INLINE Vec3 vec3_splat_lane(const Vec3 *v, int lane) {
    return (Vec3){real_of(real_at(&v->x, lane)), real_of(real_at(&v->y, lane)),
                  real_of(real_at(&v->z, lane))};
}

/** Puts a ray of a packet where the rays begin. */
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

/** Lets the next ray of a packet fly, if there is one. */
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

/** Puts a child where its distance belongs. @param first The stack's first entry of the same node.
 */
INLINE void single_traversal_push(SingleTraversal *traversal, int first, SingleStackEntry entry) {
    int i = traversal->stack_size++;
    for (; i > first && traversal->stack[i - 1].near < entry.near; i--) {
        traversal->stack[i] = traversal->stack[i - 1];
    }
    traversal->stack[i] = entry;
}

/** Puts the children that a ray may meet on its stack. */
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

/** Takes one step. @return false at the end of its way. */
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
        // A shadow ray that is blocked looks no further.
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
