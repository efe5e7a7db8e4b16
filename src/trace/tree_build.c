/**
 * @file
 * @brief Building a tree: binary splits by the surface-area heuristic, then merged into wide nodes.
 */
#include "trace/tree.h"

#include <stdlib.h>
#include <string.h>

/** Bins an axis in which splits are looked for: more gain nothing (measured). */
enum { BINS = 16 };
/** Coordinates of an extent; the fourth is not used, so that four numbers fill a vector. */
enum { COORDINATES = 4 };
/** Levels of binary splits by cost; below, halves by number need at most 32 more. */
enum { COSTED_LEVELS = TREE_LEVELS - 32 };
/** Cost of a node's test in those of a block: both are about one vector's worth of work. */
#define NODE_COST (scalar)0.25
/** Pieces of work a thread that the upper levels are split into: enough to even out their sizes. */
enum { PIECES = 16 };
/** Fewer items than these are not worth a piece of their own. */
enum { PIECE_ITEMS = 1024 };
/** Bytes: the widest vector of any engine. */
#define NODE_ALIGNMENT 64

/** A box that grows. */
typedef struct Extent {
    scalar low[COORDINATES];  /**< Lowest coordinates. */
    scalar high[COORDINATES]; /**< Highest coordinates. */
} Extent;

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
    size_t block_size;     /**< Items a block. */
    Tree *tree;            /**< The result. */
} Builder;

/* --- extents --------------------------------------------------------------------------------- */

/** @return An extent that holds nothing. */
static Extent extent_nothing(void) {
    Extent e;
    for (int i = 0; i < COORDINATES; i++) {
        e.low[i] = INFINITE;
        e.high[i] = -INFINITE;
    }
    return e;
}

/** Makes an extent hold another. @param[in,out] e The extent. @param by The other. */
static inline void extent_grow(Extent *e, const Extent *by) {
    for (int i = 0; i < COORDINATES; i++) {
        e->low[i] = by->low[i] < e->low[i] ? by->low[i] : e->low[i];
        e->high[i] = by->high[i] > e->high[i] ? by->high[i] : e->high[i];
    }
}

/** @return Half the surface of an extent: in proportion to the rays that meet it.
 *  @param e The extent, not empty. */
static inline scalar extent_area(const Extent *e) {
    scalar x = e->high[0] - e->low[0], y = e->high[1] - e->low[1], z = e->high[2] - e->low[2];
    return x * y + y * z + z * x;
}

/** Makes an extent hold twice the middle of another. @param[in,out] e The extent.
 *  @param of The other. */
static inline void extent_grow_middle(Extent *e, const Extent *of) {
    for (int i = 0; i < COORDINATES; i++) {
        scalar middle = of->low[i] + of->high[i];
        e->low[i] = middle < e->low[i] ? middle : e->low[i];
        e->high[i] = middle > e->high[i] ? middle : e->high[i];
    }
}

/* --- where to split -------------------------------------------------------------------------- */

/** What falls into a bin. */
typedef struct Bin {
    Extent extent; /**< The box around it. */
    size_t count;  /**< How many items. */
} Bin;

/** How middles fall into bins along each axis. */
typedef struct Binning {
    scalar low[COORDINATES];   /**< Twice the lowest middle. */
    scalar share[COORDINATES]; /**< Bins a unit of twice the middle; 0 where all are the same. */
} Binning;

/** The best place to split. */
typedef struct Choice {
    int axis;    /**< Along which axis; -1: nowhere. */
    int bin;     /**< The first bin of the right side. */
    scalar cost; /**< Area times blocks, both sides. */
} Choice;

/** @return How middles fall into bins. @param middles Twice the middles of all items. */
static Binning binning_of(const Extent *middles) {
    /** Keeps the highest middle inside the last bin, whatever is rounded. */
    const scalar inside = (scalar)0.99999;
    Binning binning;
    for (int i = 0; i < COORDINATES; i++) {
        scalar width = middles->high[i] - middles->low[i];
        binning.low[i] = middles->low[i];
        binning.share[i] = width > 0 && width < INFINITE ? BINS * inside / width : 0;
    }
    return binning;
}

/** @return The bin of an item. @param b How items fall. @param e The item's box. @param axis Along
 *  which axis. */
static inline int binning_place(const Binning *b, const Extent *e, int axis) {
    return (int)((e->low[axis] + e->high[axis] - b->low[axis]) * b->share[axis]);
}

/** @return Blocks that a number of items fill. @param builder The builder. @param count Items. */
static inline size_t blocks_of(const Builder *builder, size_t count) {
    return (count + builder->block_size - 1) / builder->block_size;
}

/**
 * Counts items into bins, along all axes at once.
 * @param references  The items.
 * @param count       How many.
 * @param binning     How they fall.
 * @param[out] bins   The bins.
 */
static void bins_fill(const Reference *references, size_t count, const Binning *binning,
                      Bin bins[3][BINS]) {
    for (int i = 0; i < 3 * BINS; i++) {
        bins[i / BINS][i % BINS] = (Bin){.extent = extent_nothing()};
    }
    for (size_t i = 0; i < count; i++) {
        const Extent *extent = &references[i].extent;
        for (int axis = 0; axis < 3; axis++) {
            Bin *bin = &bins[axis][binning_place(binning, extent, axis)];
            extent_grow(&bin->extent, extent);
            bin->count++;
        }
    }
}

/**
 * Looks for the best split along one axis: areas and numbers of the right sides are summed up from
 * the right, those of the left sides from the left.
 * @param builder  The builder.
 * @param bins     The axis's bins.
 * @param axis     The axis.
 * @param[in,out] best  The best choice so far.
 */
static void axis_choose(const Builder *builder, const Bin *bins, int axis, Choice *best) {
    scalar right_cost[BINS];
    Extent right = extent_nothing(), left = extent_nothing();
    size_t right_count = 0, left_count = 0;
    for (int i = BINS - 1; i > 0; i--) {
        extent_grow(&right, &bins[i].extent);
        right_count += bins[i].count;
        right_cost[i] =
            right_count ? extent_area(&right) * (scalar)blocks_of(builder, right_count) : INFINITE;
    }
    for (int i = 1; i < BINS; i++) {
        extent_grow(&left, &bins[i - 1].extent);
        left_count += bins[i - 1].count;
        if (left_count == 0) {
            continue;
        }
        scalar cost = extent_area(&left) * (scalar)blocks_of(builder, left_count) + right_cost[i];
        if (cost < best->cost) {
            *best = (Choice){axis, i, cost};
        }
    }
}

/**
 * @return Where to split a part.
 * @param builder  The builder.
 * @param split    The part.
 * @param binning  How its items fall into bins.
 */
static Choice split_choose(const Builder *builder, const Split *split, const Binning *binning) {
    Bin bins[3][BINS];
    Choice best = {.axis = -1, .cost = INFINITE};
    bins_fill(builder->references + split->first, split->count, binning, bins);
    for (int axis = 0; axis < 3; axis++) {
        if (binning->share[axis] > 0) {
            axis_choose(builder, bins[axis], axis, &best);
        }
    }
    return best;
}

/* --- splitting ------------------------------------------------------------------------------- */

/** Swaps two items. @param a One. @param b The other. */
static inline void references_swap(Reference *a, Reference *b) {
    Reference other = *a;
    *a = *b;
    *b = other;
}

/**
 * Sorts the items of a part to the two sides of a split.
 * @param references  The items.
 * @param count       How many.
 * @param binning     How they fall into bins.
 * @param choice      Where to split.
 * @return How many are on the left.
 */
static size_t references_part(Reference *references, size_t count, const Binning *binning,
                              const Choice *choice) {
    size_t left = 0, right = count;
    while (left < right) {
        if (binning_place(binning, &references[left].extent, choice->axis) < choice->bin) {
            left++;
        } else {
            references_swap(&references[left], &references[--right]);
        }
    }
    return left;
}

/** Works out a part's box and that of twice its middles. @param builder The builder.
 *  @param[in,out] split The part. @param[out] middles The middles. */
static void split_measure(const Builder *builder, Split *split, Extent *middles) {
    split->extent = *middles = extent_nothing();
    for (size_t i = 0; i < split->count; i++) {
        const Extent *extent = &builder->references[split->first + i].extent;
        extent_grow(&split->extent, extent);
        extent_grow_middle(middles, extent);
    }
}

/**
 * Decides how a part is split: by cost, by halves where that finds nothing, or not at all.
 * @param builder  The builder.
 * @param split    The part, measured.
 * @param middles  Twice the middles of its items.
 * @param level    How deep it lies.
 * @return How many items go to the left; 0: it stays a leaf.
 */
static size_t split_items(const Builder *builder, const Split *split, const Extent *middles,
                          int level) {
    size_t blocks = blocks_of(builder, split->count);
    if (blocks == 1) {
        return 0;
    }
    Binning binning = binning_of(middles);
    Choice choice = {.axis = -1};
    if (level < COSTED_LEVELS) {
        choice = split_choose(builder, split, &binning);
    }
    if (choice.axis >= 0) {
        scalar area = extent_area(&split->extent);
        bool is_leaf =
            blocks <= TREE_LEAF_BLOCKS && area * (scalar)blocks <= area * NODE_COST + choice.cost;
        return is_leaf ? 0
                       : references_part(builder->references + split->first, split->count, &binning,
                                         &choice);
    }
    return blocks <= TREE_LEAF_BLOCKS ? 0 : split->count / 2;
}

/**
 * Builds the binary tree over a part. Parts no larger than the builder's grain are put aside as
 * pieces, while there is a list of them.
 * @param builder  The builder.
 * @param place    Where its node goes; first and count are filled.
 * @param level    How deep it lies.
 * @param pieces   Whether to put pieces aside.
 */
static void split_build(Builder *builder, uint32_t place, int level, bool pieces) {
    Split *split = &builder->splits[place];
    if (pieces && split->count <= builder->grain &&
        builder->piece_count < builder->piece_capacity) {
        builder->pieces[builder->piece_count++] = (Piece){place, level};
        return;
    }
    Extent middles;
    split_measure(builder, split, &middles);
    size_t left = split_items(builder, split, &middles, level);
    if (left == 0) {
        return;
    }
    split->right = place + 2 * (uint32_t)left;
    builder->splits[place + 1] = (Split){.first = split->first, .count = (uint32_t)left};
    builder->splits[split->right] =
        (Split){.first = split->first + (uint32_t)left, .count = split->count - (uint32_t)left};
    split_build(builder, place + 1, level + 1, pieces);
    split_build(builder, split->right, level + 1, pieces);
}

/** Builds one piece. A job of the crew. @param context The builder. @param index Which piece. */
static void piece_build(void *context, size_t index) {
    Builder *builder = context;
    split_build(builder, builder->pieces[index].split, builder->pieces[index].level, false);
}

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

/** Builds the binary tree. @param builder The builder. @param count Items. @param crew Who builds.
 */
static void binary_build(Builder *builder, size_t count, const Crew *crew) {
    builder->splits[0] = (Split){.count = (uint32_t)count};
    split_build(builder, 0, 0, true);
    crew_run(crew, builder->piece_count, piece_build, builder);
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
                       .block_size = block_size,
                       .tree = tree};
    bool is_built = builder.references && builder.splits && builder.pieces;
    if (is_built) {
        references_fill(&builder, boxes, count);
        binary_build(&builder, count, crew);
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
           tree->block_count * tree->block_size * sizeof *tree->order;
}
