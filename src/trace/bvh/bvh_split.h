/**
 * @file
 * @brief The binary tree that a wide one is made of.
 */
#ifndef DIOPTRE_TRACE_BVH_BVH_SPLIT_H
#define DIOPTRE_TRACE_BVH_BVH_SPLIT_H

#include "trace/bvh/build_aabb.h"
#include "trace/bvh/bvh.h"

/** An item on its way into the tree. */
typedef struct PrimRef {
    BuildAabb box; /**< Its box. */
    uint32_t item; /**< Its number. */
} PrimRef;

/** A node of the binary tree. The left child is the next node. */
typedef struct BuildNode {
    BuildAabb box;        /**< The box around all its items. */
    uint32_t first_ref;   /**< The first reference. */
    uint32_t ref_count;   /**< How many. */
    uint32_t right_child; /**< Place of the right child; 0: this is a leaf. */
} BuildNode;

/** A part of the binary tree that is still to be built. */
typedef struct SubtreeTask {
    uint32_t node; /**< Where its node goes. */
    int depth;     /**< How deep it lies. */
} SubtreeTask;

/** A tree that is being built. */
typedef struct BvhBuilder {
    PrimRef *refs;         /**< The items, sorted as they are split; owned. */
    BuildNode *nodes;      /**< The binary tree: a part with n items has 2 n - 1 places; owned. */
    SubtreeTask *tasks;    /**< What the threads share out; owned. */
    size_t task_count;     /**< How many. */
    size_t task_capacity;  /**< How many there may be. */
    size_t task_max_items; /**< Parts with no more items than these are pieces. */
    int block_shift;       /**< Items a block, as a power of two. */
    Bvh *bvh;              /**< The result. */
} BvhBuilder;

/** @return Blocks that a number of items fill. */
static inline size_t block_count_for(const BvhBuilder *builder, size_t count) {
    return (count + (1u << builder->block_shift) - 1) >> builder->block_shift;
}

/** Builds the binary tree over a builder's references: its upper levels first, then the pieces that
 *  are left of them, side by side. */
void bvh_build_binary(BvhBuilder *builder, size_t count, const ParallelFor *parallel_for);

#endif
