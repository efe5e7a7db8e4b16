/**
 * @file
 * @brief Building a tree: a binary one, whose levels are then merged into wide nodes.
 */
#include "trace/tree_split.h"

#include <stdlib.h>
#include <string.h>

/** Pieces of work a thread that the upper levels are split into: enough to even out their sizes. */
enum { PIECES = 16 };
/** Fewer items than these are not worth a piece of their own. */
enum { PIECE_ITEMS = 1024 };
/** Bytes: the widest vector of any engine. */
#define NODE_ALIGNMENT 64

/* --- from binary to wide --------------------------------------------------------------------- */

/** Children of a wide node, as parts of the binary tree. */
typedef struct Family {
    uint32_t splits[NODE_WIDTH]; /**< Places of the parts. */
    int count;                   /**< How many. */
} Family;

/** @return The child with the largest box that can be opened; -1: none. @param builder The builder.
 *  @param family The children. */
static int family_largest(const Builder *builder, const Family *family) {
    int largest = -1;
    scalar area = -1;
    for (int i = 0; i < family->count; i++) {
        const Split *split = &builder->splits[family->splits[i]];
        if (split->right && extent_area(&split->extent) > area) {
            area = extent_area(&split->extent);
            largest = i;
        }
    }
    return largest;
}

/** @return The children of a part: opened, the largest first, until the node is full.
 *  @param builder The builder. @param place The part. */
static Family family_of(const Builder *builder, uint32_t place) {
    Family family = {.splits = {place}, .count = 1};
    int open = family_largest(builder, &family);
    while (open >= 0 && family.count < NODE_WIDTH) {
        uint32_t opened = family.splits[open];
        family.splits[open] = opened + 1;
        family.splits[family.count++] = builder->splits[opened].right;
        open = family_largest(builder, &family);
    }
    return family;
}

/** Counts the nodes and blocks that a part needs. @param builder The builder. @param place The
 * part.
 */
static void wide_count(Builder *builder, uint32_t place) {
    Family family = family_of(builder, place);
    builder->tree->node_count++;
    for (int i = 0; i < family.count; i++) {
        const Split *split = &builder->splits[family.splits[i]];
        if (split->right) {
            wide_count(builder, family.splits[i]);
        } else {
            builder->tree->block_count += blocks_of(builder, split->count);
        }
    }
}

/** @return The word of a leaf, whose blocks are filled. @param builder The builder.
 *  @param split The part. */
static uint32_t leaf_make(Builder *builder, const Split *split) {
    Tree *tree = builder->tree;
    size_t first = tree->block_count, blocks = blocks_of(builder, split->count);
    for (size_t i = 0; i < blocks * tree->block_size; i++) {
        size_t item = i < split->count ? i : split->count - 1u;
        tree->order[first * tree->block_size + i] = builder->references[split->first + item].item;
    }
    tree->block_count += blocks;
    return TREE_LEAF | (uint32_t)(first << TREE_BLOCK_BITS) | (uint32_t)blocks;
}

/** Puts a box into a node. @param[in,out] node The node. @param i Which child. @param e The box. */
static void node_place(TreeNode *node, int i, const Extent *e) {
    BoundsBlock *block = &node->bounds[i / LANES];
    for (int axis = 0; axis < 3; axis++) {
        real_set_lane(&block->planes[axis], i % LANES, e->low[axis]);
        real_set_lane(&block->planes[axis + 3], i % LANES, e->high[axis]);
    }
}

/**
 * Makes the wide nodes of a part, each before its children.
 * @param builder  The builder.
 * @param place    The part.
 * @return Place of its node.
 */
static uint32_t wide_make(Builder *builder, uint32_t place) {
    uint32_t at = (uint32_t)builder->tree->node_count++;
    TreeNode *node = &builder->tree->nodes[at];
    Family family = family_of(builder, place);
    Extent nothing = extent_nothing();
    for (int i = 0; i < NODE_WIDTH; i++) {
        if (i >= family.count) {
            node->children[i] = TREE_LEAF;
            node_place(node, i, &nothing);
            continue;
        }
        const Split *split = &builder->splits[family.splits[i]];
        node_place(node, i, &split->extent);
        node->children[i] =
            split->right ? wide_make(builder, family.splits[i]) : leaf_make(builder, split);
    }
    return at;
}

/* --- all of it ------------------------------------------------------------------------------- */

/** Fills the references. @param builder The builder. @param boxes The items' boxes.
 *  @param count How many. */
static void references_fill(Builder *builder, const Bounds *boxes, size_t count) {
    for (size_t i = 0; i < count; i++) {
        Reference *reference = &builder->references[i];
        reference->item = (uint32_t)i;
        reference->extent = (Extent){{0}, {0}};
        for (int axis = 0; axis < 3; axis++) {
            reference->extent.low[axis] = boxes[i].low[axis];
            reference->extent.high[axis] = boxes[i].high[axis];
        }
    }
}

/** Turns the binary tree into the wide one. @param builder The builder. @return false without
 *  memory. */
static bool wide_build(Builder *builder) {
    Tree *tree = builder->tree;
    wide_count(builder, 0);
    tree->nodes =
        aligned_alloc(NODE_ALIGNMENT, (tree->node_count * sizeof(TreeNode) + NODE_ALIGNMENT - 1) /
                                          NODE_ALIGNMENT * NODE_ALIGNMENT);
    tree->order = malloc(tree->block_count * tree->block_size * sizeof *tree->order);
    if (!tree->nodes || !tree->order || tree->block_count >= TREE_BLOCKS) {
        return false;
    }
    tree->node_count = tree->block_count = 0;
    wide_make(builder, 0);
    return true;
}

bool tree_build(Tree *tree, const Bounds *boxes, size_t count, size_t block_size,
                const Crew *crew) {
    *tree = (Tree){.block_size = block_size};
    if (count >= TREE_BLOCKS) {
        return false;
    }
    size_t pieces = PIECES * (size_t)(crew->count > 1 ? crew->count : 1);
    Builder builder = {.references = malloc(count * sizeof(Reference)),
                       .splits = calloc(2 * count, sizeof(Split)),
                       .pieces = calloc(4 * pieces, sizeof(Piece)),
                       .piece_capacity = 4 * pieces,
                       .grain = count / pieces > PIECE_ITEMS ? count / pieces : PIECE_ITEMS,
                       .block_shift = __builtin_ctzll(block_size),
                       .tree = tree};
    bool is_built = builder.references && builder.splits && builder.pieces;
    if (is_built) {
        references_fill(&builder, boxes, count);
        splits_build(&builder, count, crew);
        is_built = wide_build(&builder);
    }
    free(builder.references);
    free(builder.splits);
    free(builder.pieces);
    if (!is_built) {
        tree_release(tree);
    }
    return is_built;
}

void tree_release(Tree *tree) {
    free(tree->nodes);
    free(tree->order);
    *tree = (Tree){0};
}

size_t tree_size(const Tree *tree) {
    return tree->node_count * sizeof *tree->nodes +
           (tree->order ? tree->block_count * tree->block_size * sizeof *tree->order : 0);
}
