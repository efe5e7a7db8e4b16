/**
 * @file
 * @brief Splitting items in two, again and again, where that costs rays least.
 *
 * The cost of a box is its area, to which the number of rays that meet it is in proportion, times
 * the blocks of items in it (the surface-area heuristic). Where to split is looked for between bins
 * (Wald, *On fast Construction of SAH-based Bounding Volume Hierarchies*, 2007).
 */
#include "trace/tree_split.h"

/** Bins an axis in which splits are looked for: more gain nothing (measured). */
enum { BINS = 16 };
/** Items that are split well with half the bins. */
enum { FEW_ITEMS = 32 };
/** Levels of binary splits by cost; below, halves by number need at most 32 more. */
enum { COSTED_LEVELS = TREE_LEVELS - 32 };
/** Cost of a node's test in those of a block (measured: leaves of more than a block hardly pay). */
#define NODE_COST ((scalar)0.25)

/* --- where to split -------------------------------------------------------------------------- */

/** What falls into a bin. */
typedef struct Bin {
    Extent extent; /**< The box around it. */
    size_t count;  /**< How many items. */
} Bin;

/** How middles fall into bins along each axis. */
typedef struct Binning {
    int bins;                  /**< How many bins an axis, at most #BINS. */
    scalar low[COORDINATES];   /**< Twice the lowest middle. */
    scalar share[COORDINATES]; /**< Bins a unit of twice the middle; 0 where all are about the
                                    same: no number says how many. */
} Binning;

/** The best place to split. */
typedef struct Choice {
    int axis;    /**< Along which axis; -1: nowhere. */
    int bin;     /**< The first bin of the right side. */
    scalar cost; /**< Area times blocks, both sides. */
} Choice;

/** @return How middles fall into bins. @param middles Twice the middles of all items.
 *  @param count How many items. */
static Binning binning_of(const Extent *middles, size_t count) {
    /** Keeps the highest middle inside the last bin, whatever is rounded. */
    const scalar inside = (scalar)0.99999;
    Binning binning = {.bins = count > FEW_ITEMS ? BINS : BINS / 2};
    for (int i = 0; i < COORDINATES; i++) {
        scalar width = middles->high[i] - middles->low[i];
        binning.low[i] = middles->low[i];
        scalar share = (scalar)binning.bins * inside / width;
        binning.share[i] = width > 0 && width < INFINITE && share < INFINITE ? share : 0;
    }
    return binning;
}

/** @return The bin of an item. @param b How items fall. @param e The item's box. @param axis Along
 *  which axis. */
static inline int binning_place(const Binning *b, const Extent *e, int axis) {
    return (int)((e->low[axis] + e->high[axis] - b->low[axis]) * b->share[axis]);
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
    for (int axis = 0; axis < 3; axis++) {
        for (int i = 0; i < binning->bins; i++) {
            bins[axis][i] = (Bin){.extent = extent_nothing()};
        }
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
 * @param count    How many.
 * @param axis     The axis.
 * @param[in,out] best  The best choice so far.
 */
static void axis_choose(const Builder *builder, const Bin *bins, int count, int axis,
                        Choice *best) {
    scalar right_cost[BINS];
    Extent right = extent_nothing(), left = extent_nothing();
    size_t right_count = 0, left_count = 0;
    for (int i = count - 1; i > 0; i--) {
        extent_grow(&right, &bins[i].extent);
        right_count += bins[i].count;
        right_cost[i] =
            right_count ? extent_area(&right) * (scalar)blocks_of(builder, right_count) : INFINITE;
    }
    for (int i = 1; i < count; i++) {
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
            axis_choose(builder, bins[axis], binning->bins, axis, &best);
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
    size_t left = 0;
    // Every item is swapped, so that nothing is guessed: which side is as likely as not.
    for (size_t i = 0; i < count; i++) {
        bool is_left = binning_place(binning, &references[i].extent, choice->axis) < choice->bin;
        references_swap(&references[left], &references[i]);
        left += is_left;
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
    Binning binning = binning_of(middles, split->count);
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

void splits_build(Builder *builder, size_t count, const Crew *crew) {
    builder->splits[0] = (Split){.count = (uint32_t)count};
    split_build(builder, 0, 0, true);
    crew_run(crew, builder->piece_count, piece_build, builder);
}
