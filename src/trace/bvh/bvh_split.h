/**
 * @file
 * @brief The binary tree from which the wide one is made.
 */
#ifndef DIOPTRE_TRACE_BVH_BVH_SPLIT_H
#define DIOPTRE_TRACE_BVH_BVH_SPLIT_H

#include "trace/bvh/build_aabb.h"
#include "trace/bvh/bvh.h"

/** A reference to an item. */
typedef struct PrimRef {
    BuildAabb box; /**< Bounding box. */
    uint32_t item; /**< Index of the item. */
} PrimRef;

/** A node of the binary tree. */
typedef struct BuildNode {
    BuildAabb box;       /**< Bounding box of all its items. */
    uint32_t first_ref;  /**< First reference. */
    uint32_t ref_count;  /**< Number of references. */
    uint32_t left_child; /**< Index of the left child, before the right one; 0: this is a leaf. */
} BuildNode;

/** A subtree that is not built yet. */
typedef struct Subtree {
    uint32_t root;               /**< Index of its root, whose box and references are set. */
    int depth;                   /**< Depth of its root. */
    BuildAabb doubled_centroids; /**< Box of twice the centres of its items. */
} Subtree;

/** A subtree that a thread will build. */
typedef struct SubtreeTask {
    Subtree subtree;     /**< The subtree. */
    uint32_t first_node; /**< First of the nodes that it has for itself. */
} SubtreeTask;

/** State of the construction. */
typedef struct BvhBuilder {
    PrimRef *refs;         /**< The items, in the order of the leaves; owned. */
    BuildNode *nodes;      /**< The binary tree, the root first: at most 2 n - 1 nodes for n items;
                                owned. */
    SubtreeTask *tasks;    /**< Subtrees for the threads; owned. */
    size_t task_count;     /**< Number of #tasks. */
    size_t task_capacity;  /**< Largest number of #tasks. */
    size_t task_max_items; /**< Largest number of items of a task. */
    int block_shift;       /**< Number of items per block, as a power of two. */
    Bvh *bvh;              /**< The result. */
} BvhBuilder;

/** @return Number of blocks for a number of items. */
static inline size_t block_count_for(const BvhBuilder *builder, size_t count) {
    return (count + (1u << builder->block_shift) - 1) >> builder->block_shift;
}

/** Builds the binary tree over #BvhBuilder.refs: its upper levels first, then the tasks in
 * parallel.
 */
void bvh_build_binary(BvhBuilder *builder, size_t count, const ParallelFor *parallel_for);

#endif
