/**
 * @file
 * @brief The bounding volume hierarchy: which of many things a ray may meet, nearest first.
 *
 * A tree of boxes over items that are known by number: the shapes of a scene, or the triangles of a
 * mesh. Nodes are eight wide (sixteen where a vector is), so that one test answers for all
 * children. The items are laid out in leaves, in blocks of a fixed size, by #Tree.order; what an
 * item is only its owner knows, who is called for each leaf that is reached.
 *
 * The tree changes the time and not one bit of the answer: its tests round outwards, ties are left
 * to the owner, and no leaf is dropped that could hold an equal distance.
 */
#ifndef DIOPTRE_TRACE_TREE_H
#define DIOPTRE_TRACE_TREE_H

#include "trace/packet.h"

/** Does pieces of work. @param crew Who. @param count How many pieces. @param job Does one.
 *  @param context Handed to it. */
static inline void crew_run(const Crew *crew, size_t count, void (*job)(void *, size_t),
                            void *context) {
    if (crew->run) {
        crew->run(crew->workers, count, job, context);
        return;
    }
    for (size_t i = 0; i < count; i++) {
        job(context, i);
    }
}

/** Children a node. */
#define NODE_WIDTH (LANES > 8 ? LANES : 8)
/** Vectors of boxes a node. */
#define NODE_VECTORS (NODE_WIDTH / LANES)

/** Bit of a child that is a leaf: the rest is its first block and how many there are. */
#define TREE_LEAF 0x80000000u
/** Bits of a leaf for the number of blocks. */
#define TREE_BLOCK_BITS 4
/** Largest number of blocks in a leaf. */
#define TREE_LEAF_BLOCKS ((1u << TREE_BLOCK_BITS) - 1)
/** Largest number of blocks in a tree: what the other bits of a leaf can say. */
#define TREE_BLOCKS (TREE_LEAF >> TREE_BLOCK_BITS)
/** Levels of a tree at most: the builder halves by number once half of them are used up. */
enum { TREE_LEVELS = 64 };
/** Entries of a traversal's stack: all children but one of each level, and one. */
#define TREE_STACK (TREE_LEVELS * (NODE_WIDTH - 1) + 1)

/** A node: its children's boxes, side by side, and where the children are. */
typedef struct TreeNode {
    BoundsBlock bounds[NODE_VECTORS]; /**< The boxes. */
    uint32_t children[NODE_WIDTH];    /**< Places of nodes, or #TREE_LEAF and blocks. */
} TreeNode;

/** A tree over items. */
typedef struct Tree {
    TreeNode *nodes;   /**< The nodes, the root first; owned. */
    size_t node_count; /**< How many. */
    uint32_t *order;   /**< Items in the order of the leaves, block by block; owned. A block that is
                            not full repeats its last item. */
    size_t block_count; /**< How many blocks. */
    size_t block_size;  /**< Items a block. */
} Tree;

/**
 * Builds a tree by the surface-area heuristic with bins (Wald, *On fast Construction of SAH-based
 * Bounding Volume Hierarchies*, 2007). The tree does not depend on how the work is shared out.
 * @param[out] tree    The tree; give it back with #tree_release.
 * @param boxes        The items' boxes.
 * @param count        How many items, at least 1.
 * @param block_size   Items a block, a power of two: as many as the owner tests at once.
 * @param crew         Who builds.
 * @return false without memory, or with more items than a tree can hold.
 */
bool tree_build(Tree *tree, const Bounds *boxes, size_t count, size_t block_size, const Crew *crew);

/** Gives a tree's memory back and empties it. @param tree The tree. */
void tree_release(Tree *tree);

/** @return Bytes that a tree holds. @param tree The tree. */
size_t tree_size(const Tree *tree);

/** A leaf: the blocks of items in it. */
typedef struct TreeLeaf {
    size_t first; /**< The first block. */
    size_t count; /**< How many. */
} TreeLeaf;

/** Rays that reach a leaf: some of one vector of a packet. */
typedef struct TreeRays {
    const Packet *packet; /**< The packet. */
    int vector;           /**< Which vector of it. */
    unsigned lanes;       /**< Bit i set: lane i counts. At least one. */
    real *limits;         /**< For each vector of the packet: how far its rays look. What they meet
                               nearer lowers them; below 0 they look no further at all. */
} TreeRays;

/** Whoever owns the items of a tree: asked about the leaves that rays reach. */
typedef struct TreeOwner {
    const void *items;  /**< Handed to #ask. */
    const void *blocks; /**< Where the blocks lie, to be fetched before they are asked; or NULL. */
    size_t block_bytes; /**< Bytes a block. */
    bool asks_vectors;  /**< Whether #ask takes as long for one ray as for a vector of them, so that
                             few rays, too, are best kept together. */

    /**
     * Asks the items of a leaf about rays.
     * @param items  See #items.
     * @param leaf   The leaf.
     * @param rays   The rays; their limits are lowered.
     * @param[in,out] found  What the owner keeps of the packet, such as hits.
     */
    void (*ask)(const void *items, TreeLeaf leaf, const TreeRays *rays, void *found);
} TreeOwner;

/** @return A leaf. @param child A child that is one, see #TreeNode.children. */
static inline TreeLeaf tree_leaf(uint32_t child) {
    return (TreeLeaf){(child & ~TREE_LEAF) >> TREE_BLOCK_BITS, child & TREE_LEAF_BLOCKS};
}

/** Fetches memory that will be needed. Part of its callers, as those are of theirs: GCC drops calls
 *  of functions that do nothing else. @param at Where. @param bytes How much. */
INLINE void memory_fetch(const void *at, size_t bytes) {
    /** Bytes that one fetch brings. */
    enum { LINE = 64 };
    for (size_t i = 0; i < bytes; i += LINE) {
        __builtin_prefetch((const char *)at + i);
    }
}

/** Fetches the memory that a child will need: its node, or the first of its blocks. @param tree The
 *  tree. @param owner Who owns the items. @param child See #TreeNode.children. */
INLINE void tree_fetch(const Tree *tree, const TreeOwner *owner, uint32_t child) {
    if (!(child & TREE_LEAF)) {
        memory_fetch(&tree->nodes[child], sizeof(TreeNode));
    } else if (owner->blocks) {
        size_t place = tree_leaf(child).first * owner->block_bytes;
        memory_fetch((const char *)owner->blocks + place, owner->block_bytes);
    }
}

/**
 * Asks the items that the rays of a packet may meet, roughly from near to far: for all rays
 * together where they go about the same way, for each by itself where they share nothing.
 * @param tree     The tree.
 * @param packet   The rays.
 * @param[in,out] limits  For each vector: how far rays look before anything is met; then how far
 *                 the owner let them.
 * @param owner    Who owns the items.
 * @param[in,out] found  Handed to the owner.
 */
void tree_visit(const Tree *tree, const Packet *packet, real *limits, const TreeOwner *owner,
                void *found);

/** Which rays of a packet: bit i of number v set: lane i of vector v. */
typedef struct Lanes {
    uint16_t of[PACKET_VECTORS]; /**< The bits. */
} Lanes;

/**
 * As #tree_visit, from a node or leaf on, for each ray by itself: several are in flight, so that
 * one computes while another waits for memory.
 * @param tree     The tree.
 * @param child    Where to begin, see #TreeNode.children.
 * @param lanes    The rays that count.
 * @param packet   The rays.
 * @param[in,out] limits  For each vector: how far rays look.
 * @param owner    Who owns the items.
 * @param[in,out] found  Handed to the owner.
 */
void tree_visit_singly(const Tree *tree, uint32_t child, const Lanes *lanes, const Packet *packet,
                       real *limits, const TreeOwner *owner, void *found);

#endif
