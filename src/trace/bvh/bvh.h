/**
 * @file
 * @brief The bounding volume hierarchy: which of many things a ray may meet, nearest first.
 *
 * A tree of boxes over items that are known by number: the shapes of a scene, or the triangles of a
 * mesh. Nodes are eight wide (sixteen where a vector is), so that one test answers for all
 * children. The items are laid out in leaves, in blocks of a fixed size, by #Bvh.item_indices; what
 * an item is only its owner knows, who is called for each leaf that is reached.
 *
 * The tree changes the time and not one bit of the answer: its tests round outwards, ties are left
 * to the owner, and no leaf is dropped that could hold an equal distance.
 */
#ifndef DIOPTRE_TRACE_BVH_BVH_H
#define DIOPTRE_TRACE_BVH_BVH_H

#include "trace/tracer/packet.h"

/** Does pieces of work. */
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

/** Children a node. */
#define BVH_WIDTH (LANES > 8 ? LANES : 8)
/** Vectors of boxes a node. */
#define BVH_NODE_VECTORS (BVH_WIDTH / LANES)

/** Bit of a child that is a leaf: the rest is its first block and how many there are. */
#define BVH_LEAF_BIT 0x80000000u
/** Bits of a leaf for the number of blocks. */
#define BVH_LEAF_COUNT_BITS 4
/** Largest number of blocks in a leaf. */
#define BVH_LEAF_MAX_BLOCKS ((1u << BVH_LEAF_COUNT_BITS) - 1)
/** Largest number of blocks in a tree: what the other bits of a leaf can say. */
#define BVH_MAX_BLOCKS (BVH_LEAF_BIT >> BVH_LEAF_COUNT_BITS)
/** Levels of a tree at most: the builder halves by number once half of them are used up. */
enum { BVH_MAX_DEPTH = 64 };
/** Entries of a traversal's stack: all children but one of each level, and one. */
#define BVH_STACK_SIZE (BVH_MAX_DEPTH * (BVH_WIDTH - 1) + 1)

/** A node: its children's boxes, side by side, and where the children are. */
typedef struct BvhNode {
    Aabb bounds[BVH_NODE_VECTORS]; /**< The boxes. */
    uint32_t children[BVH_WIDTH];  /**< Places of nodes, or #BVH_LEAF_BIT and blocks. */
} BvhNode;

/** A tree over items. */
typedef struct Bvh {
    BvhNode *nodes;         /**< The nodes, the root first; owned. */
    size_t node_count;      /**< How many. */
    uint32_t *item_indices; /**< Items in the order of the leaves, block by block; owned. A block
                          that is not full repeats its last item. */
    size_t block_count;     /**< How many blocks. */
    size_t block_size;      /**< Items a block. */
} Bvh;

/**
 * Builds a tree by the surface-area heuristic with bins (Wald, *On fast Construction of SAH-based
 * Bounding Volume Hierarchies*, 2007). The tree does not depend on how the work is shared out.
 * @param[out] bvh  The tree; give it back with #bvh_deinit.
 * @param count  How many items, at least 1.
 * @param block_size  Items a block, a power of two: as many as the owner tests at once.
 * @return false without memory, or with more items than a tree can hold.
 */
bool bvh_build(Bvh *bvh, const Aabbs *boxes, size_t count, size_t block_size,
               const ParallelFor *parallel_for);

/** Gives a tree's memory back and empties it. */
void bvh_deinit(Bvh *bvh);

/** @return Bytes that a tree holds. */
size_t bvh_memory_size(const Bvh *bvh);

/** A leaf: the blocks of items in it. */
typedef struct BvhLeaf {
    size_t first_block; /**< The first block. */
    size_t block_count; /**< How many. */
} BvhLeaf;

/** Rays that reach a leaf: some of one vector of a packet. */
typedef struct BvhLeafRays {
    const Packet *packet; /**< The packet. */
    int vector;           /**< Which vector of it. */
    unsigned lane_bits;   /**< Bit i set: lane i counts. At least one. */
    real *limits;         /**< For each vector of the packet: how far its rays look. What they meet
                               nearer lowers them; below 0 they look no further at all. */
} BvhLeafRays;

/** Whoever owns the items of a tree: asked about the leaves that rays reach. */
typedef struct BvhIntersector {
    const void *items;  /**< Handed to #intersect_leaf. */
    const void *blocks; /**< Where the blocks lie, to be fetched before they are asked; or NULL. */
    size_t block_bytes; /**< Bytes a block. */
    bool prefers_vectors; /**< Whether #intersect_leaf takes as long for one ray as for a vector of
                            them, so that few rays, too, are best kept together. */

    /**
     * Asks the items of a leaf about rays.
     * @param rays  The rays; their limits are lowered.
     * @param[in,out] found  What the owner keeps of the packet, such as hits.
     */
    void (*intersect_leaf)(const void *items, BvhLeaf leaf, const BvhLeafRays *rays, void *found);
} BvhIntersector;

/** @return A leaf. @param child A child that is one, see #BvhNode.children. */
static inline BvhLeaf bvh_leaf_decode(uint32_t child) {
    return (BvhLeaf){(child & ~BVH_LEAF_BIT) >> BVH_LEAF_COUNT_BITS, child & BVH_LEAF_MAX_BLOCKS};
}

/** Fetches memory that will be needed. Part of its callers, as those are of theirs: GCC drops calls
 *  of functions that do nothing else. */
INLINE void memory_prefetch(const void *at, size_t bytes) {
    /** Bytes that one fetch brings. */
    enum { CACHE_LINE_BYTES = 64 };
    for (size_t i = 0; i < bytes; i += CACHE_LINE_BYTES) {
        __builtin_prefetch((const char *)at + i);
    }
}

/** Fetches the memory that a child will need: its node, or the first of its blocks. @param
 *  intersector Who owns the items. */
INLINE void bvh_prefetch(const Bvh *bvh, const BvhIntersector *intersector, uint32_t child) {
    if (!(child & BVH_LEAF_BIT)) {
        memory_prefetch(&bvh->nodes[child], sizeof(BvhNode));
    } else if (intersector->blocks) {
        size_t byte_offset = bvh_leaf_decode(child).first_block * intersector->block_bytes;
        memory_prefetch((const char *)intersector->blocks + byte_offset, intersector->block_bytes);
    }
}

/**
 * Asks the items that the rays of a packet may meet, roughly from near to far: for all rays
 * together where they go about the same way, for each by itself where they share nothing.
 * @param[in,out] limits  For each vector: how far rays look before anything is met; then how far
 *         the owner let them.
 * @param intersector  Who owns the items.
 * @param[in,out] results  Handed to the owner.
 */
void bvh_traverse(const Bvh *bvh, const Packet *packet, real *limits,
                  const BvhIntersector *intersector, void *results);

/** Which rays of a packet: bit i of number v set: lane i of vector v. */
typedef struct PacketLanes {
    uint16_t bits[PACKET_VECTORS]; /**< The bits. */
} PacketLanes;

/**
 * As #bvh_traverse, from a node or leaf on, for each ray by itself: several are in flight, so that
 * one computes while another waits for memory.
 * @param child  Where to begin, see #BvhNode.children.
 * @param[in,out] limits  For each vector: how far rays look.
 * @param intersector  Who owns the items.
 * @param[in,out] results  Handed to the owner.
 */
void bvh_traverse_single(const Bvh *bvh, uint32_t child, const PacketLanes *lanes,
                         const Packet *packet, real *limits, const BvhIntersector *intersector,
                         void *results);

#endif
