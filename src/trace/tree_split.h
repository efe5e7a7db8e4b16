/**
 * @file
 * @brief The binary tree that a wide one is made of.
 */
#ifndef DIOPTRE_TRACE_TREE_SPLIT_H
#define DIOPTRE_TRACE_TREE_SPLIT_H

#include "trace/extent.h"
#include "trace/tree.h"

/** An item on its way into the tree. */
typedef struct Reference {
    Extent extent; /**< Its box. */
    uint32_t item; /**< Its number. */
} Reference;

/** A node of the binary tree. The left child is the next node. */
typedef struct Split {
    Extent extent;  /**< The box around all its items. */
    uint32_t first; /**< The first reference. */
    uint32_t count; /**< How many. */
    uint32_t right; /**< Place of the right child; 0: this is a leaf. */
} Split;

/** A part of the binary tree that is still to be built. */
typedef struct Piece {
    uint32_t split; /**< Where its node goes. */
    int level;      /**< How deep it lies. */
} Piece;

/** A tree that is being built. */
typedef struct Builder {
    Reference *references; /**< The items, sorted as they are split; owned. */
    Split *splits;         /**< The binary tree: a part with n items has 2 n - 1 places; owned. */
    Piece *pieces;         /**< What the threads share out; owned. */
    size_t piece_count;    /**< How many. */
    size_t piece_capacity; /**< How many there may be. */
    size_t grain;          /**< Parts with no more items than these are pieces. */
    int block_shift;       /**< Items a block, as a power of two. */
    Tree *tree;            /**< The result. */
} Builder;

/** @return Blocks that a number of items fill. @param builder The builder. @param count Items. */
static inline size_t blocks_of(const Builder *builder, size_t count) {
    return (count + (1u << builder->block_shift) - 1) >> builder->block_shift;
}

/**
 * Builds the binary tree over a builder's references: its upper levels first, then the pieces that
 * are left of them, side by side.
 * @param builder  The builder.
 * @param count    How many references.
 * @param crew     Who builds.
 */
void splits_build(Builder *builder, size_t count, const Crew *crew);

#endif
