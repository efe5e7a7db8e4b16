/**
 * @file
 * @brief Bounding volume hierarchy (BVH): a tree of bounding boxes over numbered items.
 *
 * The items are the shapes of a scene or the triangles of a mesh. Nodes have eight children
 * (sixteen where a vector has sixteen lanes): one test covers all of them. Leaves hold items in
 * blocks of a fixed size, in the order of #Bvh.item_indices. Traversal calls a function of the
 * caller, #BvhIntersector, for each leaf that rays reach.
 *
 * The tree changes the time and no bit of the result: its tests round outwards, the caller decides
 * ties, and no leaf is culled that could hold an equal distance.
 */
#ifndef DIOPTRE_TRACE_BVH_BVH_H
#define DIOPTRE_TRACE_BVH_BVH_H

#include "trace/bvh/slab.h"
#include "trace/math/permute.h"

/** Runs tasks 0 to count - 1, in parallel if the renderer has supplied threads. */
static inline void parallel_for_run(const ParallelFor *parallel_for, size_t count,
                                    void (*task)(void *, size_t), void *context) {
    if (parallel_for->run) {
        parallel_for->run(parallel_for->pool, count, task, context);
        return;
    }
    for (size_t i = 0; i < count; i++) {
        task(context, i);
    }
}

/** Number of children per node. */
#define BVH_WIDTH (LANES > 8 ? LANES : 8)
/** Number of vectors of boxes per node. */
#define BVH_NODE_VECTORS (BVH_WIDTH / LANES)

/** Bit of a child that is a leaf; the other bits are its first block and the number of blocks. */
#define BVH_LEAF_BIT 0x80000000u
/** Number of bits for the number of blocks of a leaf. */
#define BVH_LEAF_COUNT_BITS 4
/** Largest number of blocks in a leaf. */
#define BVH_LEAF_MAX_BLOCKS ((1u << BVH_LEAF_COUNT_BITS) - 1)
/** Largest number of blocks in a tree: the range of the other bits of a leaf. */
#define BVH_MAX_BLOCKS (BVH_LEAF_BIT >> BVH_LEAF_COUNT_BITS)
/** Largest depth of a tree: beyond half of it the builder splits by halves. */
enum { BVH_MAX_DEPTH = 64 };
/** Size of a traversal stack: all children but one per level, and one. */
#define BVH_STACK_SIZE (BVH_MAX_DEPTH * (BVH_WIDTH - 1) + 1)

#ifdef LANES_PERMUTE
/** Whether nodes have the order in which rays meet their children: where one vector holds them all,
 *  and an instruction permutes its lanes. */
#define BVH_HAS_ORDERS 1
_Static_assert(BVH_NODE_VECTORS == 1, "an order is of the lanes of a vector");
#else
#define BVH_HAS_ORDERS 0
#endif

/** A node: the boxes of its children as a structure of arrays, and the children. */
typedef struct BvhNode {
    Aabb bounds[BVH_NODE_VECTORS]; /**< The boxes. */
    uint32_t children[BVH_WIDTH];  /**< Indices of nodes, or #BVH_LEAF_BIT and blocks. */
#if BVH_HAS_ORDERS
    /** Per octant of a direction, the children from far to near. */
    lane_order orders[DIRECTION_OCTANTS];
#endif
} BvhNode;

/** A tree over items. */
typedef struct Bvh {
    BvhNode *nodes;         /**< The nodes, the root first; owned. */
    size_t node_count;      /**< Number of #nodes. */
    uint32_t *item_indices; /**< Items in the order of the leaves, block by block; owned. A block
                          that is not full repeats its last item. */
    size_t block_count;     /**< Number of blocks. */
    size_t block_size;      /**< Number of items per block. */
} Bvh;

/**
 * Builds a tree by the surface-area heuristic with bins (Wald, *On fast Construction of SAH-based
 * Bounding Volume Hierarchies*, 2007). The tree does not depend on the number of threads.
 * @param[out] bvh    The tree; the caller frees it with #bvh_deinit.
 * @param count       Number of items, at least 1.
 * @param block_size  Number of items per block, a power of two: as many as the caller tests at
 * once.
 * @return false without memory, or with more items than a tree can hold.
 */
bool bvh_build(Bvh *bvh, const Aabbs *boxes, size_t count, size_t block_size,
               const ParallelFor *parallel_for);

/** Frees the memory of a tree and empties it. */
void bvh_deinit(Bvh *bvh);

/** @return Bytes of the memory of a tree. */
size_t bvh_memory_size(const Bvh *bvh);

/** A leaf: the blocks of items in it. */
typedef struct BvhLeaf {
    size_t first_block; /**< The first block. */
    size_t block_count; /**< Number of blocks. */
} BvhLeaf;

/** Rays that reach a leaf: lanes of one vector of a packet. */
typedef struct BvhLeafRays {
    const Packet *packet; /**< The packet. */
    int vector;           /**< Index of the vector. */
    unsigned lane_bits;   /**< Bit i set: lane i counts. At least one. */
    real *limits;         /**< Largest distances of the rays, per vector of the packet. A hit lowers
                               them; a ray with a limit below 0 is finished. */
} BvhLeafRays;

/** The intersection of rays with the items of a leaf. */
typedef struct BvhIntersector {
    const void *items;    /**< First argument of #intersect_leaf. */
    const void *blocks;   /**< Memory of the blocks, to be prefetched; or NULL. */
    size_t block_bytes;   /**< Bytes per block. */
    bool prefers_vectors; /**< Whether #intersect_leaf takes as long for one ray as for a vector:
                               then few rays stay together. */

    /**
     * Intersects rays with the items of a leaf.
     * @param rays           The rays; hits lower their limits.
     * @param[in,out] found  Results of the caller for the packet, such as hits.
     */
    void (*intersect_leaf)(const void *items, BvhLeaf leaf, const BvhLeafRays *rays, void *found);
} BvhIntersector;

/** @return The blocks of a leaf. @param child Element of #BvhNode.children with #BVH_LEAF_BIT. */
static inline BvhLeaf bvh_leaf_decode(uint32_t child) {
    return (BvhLeaf){(child & ~BVH_LEAF_BIT) >> BVH_LEAF_COUNT_BITS, child & BVH_LEAF_MAX_BLOCKS};
}

/** Prefetches memory. Always inlined, as are its callers: GCC removes calls of functions that do
 *  nothing else. */
INLINE void memory_prefetch(const void *at, size_t bytes) {
    /** Bytes per prefetch. */
    enum { CACHE_LINE_BYTES = 64 };
    for (size_t i = 0; i < bytes; i += CACHE_LINE_BYTES) {
        __builtin_prefetch((const char *)at + i);
    }
}

/** Prefetches a child: its node, or the first of its blocks. */
INLINE void bvh_prefetch(const Bvh *bvh, const BvhIntersector *intersector, uint32_t child) {
    if (!(child & BVH_LEAF_BIT)) {
        memory_prefetch(&bvh->nodes[child], sizeof(BvhNode));
    } else if (intersector->blocks) {
        size_t byte_offset = bvh_leaf_decode(child).first_block * intersector->block_bytes;
        memory_prefetch((const char *)intersector->blocks + byte_offset, intersector->block_bytes);
    }
}

/**
 * Intersects a packet with the items of a tree, roughly from near to far: coherent rays as a
 * packet, others one by one.
 * @param intervals        The intervals of the packet; not used with one lane.
 * @param[in,out] limits   Largest distances per vector; hits lower them.
 * @param intersector      Intersects the leaves.
 * @param[in,out] results  Last argument of #BvhIntersector.intersect_leaf.
 */
void bvh_traverse(const Bvh *bvh, const Packet *packet, const PacketIntervals *intervals,
                  real *limits, const BvhIntersector *intersector, void *results);

/** A set of rays of a packet: bit i of element v represents lane i of vector v. */
typedef struct PacketLanes {
    uint16_t bits[PACKET_VECTORS]; /**< The bits. */
} PacketLanes;

/**
 * Traverses a subtree ray by ray. Several rays are interleaved: one computes while another waits
 * for memory.
 * @param child            Root of the subtree, as in #BvhNode.children.
 * @param lanes            The rays.
 * @param[in,out] limits   Largest distances per vector; hits lower them.
 * @param intersector      Intersects the leaves.
 * @param[in,out] results  Last argument of #BvhIntersector.intersect_leaf.
 */
void bvh_traverse_single(const Bvh *bvh, uint32_t child, const PacketLanes *lanes,
                         const Packet *packet, real *limits, const BvhIntersector *intersector,
                         void *results);

#endif
