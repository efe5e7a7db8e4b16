/**
 * @file
 * @brief Construction of the binary tree by the surface-area heuristic (SAH).
 *
 * The cost of a box is its area, which is proportional to the number of rays that meet it, times
 * the number of blocks in it. Splits are between bins of centroids (Wald, *On fast Construction of
 * SAH-based Bounding Volume Hierarchies*, 2007).
 */
#include "trace/bvh/bvh_split.h"

/** Number of bins per axis: more gain nothing (measured). */
enum { SAH_BINS = 16 };
/** Number of items up to which half the bins suffice. */
enum { SAH_FEW_ITEMS = 32 };
/** Depth up to which splits follow the cost; below it, halves need at most 32 more levels. */
enum { SAH_MAX_DEPTH = BVH_MAX_DEPTH - 32 };
/** Cost of testing a node relative to a block (measured: leaves of several blocks hardly pay). */
#define SAH_NODE_COST ((build_scalar)0.25)

/* --- the best split -------------------------------------------------------------------------- */

/** The items of a bin. */
typedef struct SahBin {
    BuildAabb box; /**< Their bounding box. */
    size_t count;  /**< Number of items. */
} SahBin;

/** The mapping of doubled centroids to bins along each axis. */
typedef struct SahBinning {
    int bin_count;                       /**< Number of bins per axis, at most #SAH_BINS. */
    build_scalar low[BUILD_AABB_SIZE];   /**< Lowest doubled centroid. */
    build_scalar scale[BUILD_AABB_SIZE]; /**< Bins per unit; 0: all centroids are about the same. */
} SahBinning;

/** A split. */
typedef struct SahSplit {
    int axis;          /**< Its axis; -1: none. */
    int bin;           /**< First bin of the right side. */
    build_scalar cost; /**< Sum of area times blocks of both sides. */
} SahSplit;

/** @return The mapping to bins. @param doubled_centroids Box of the doubled centroids. */
static SahBinning sah_binning_of(const BuildAabb *doubled_centroids, size_t count) {
    /** Keeps the highest centroid inside the last bin, whatever the rounding. */
    const build_scalar inside = (build_scalar)0.99999;
    SahBinning binning = {.bin_count = count > SAH_FEW_ITEMS ? SAH_BINS : SAH_BINS / 2};
    for (int i = 0; i < BUILD_AABB_SIZE; i++) {
        build_scalar width = doubled_centroids->high[i] - doubled_centroids->low[i];
        binning.low[i] = doubled_centroids->low[i];
        build_scalar scale = (build_scalar)binning.bin_count * inside / width;
        binning.scale[i] =
            width > 0 && width < (build_scalar)INFINITE && scale < (build_scalar)INFINITE ? scale
                                                                                          : 0;
    }
    return binning;
}

/** @return The bin of an item. */
static inline int sah_bin_index(const SahBinning *b, const BuildAabb *box, int axis) {
    return (int)((box->low[axis] + box->high[axis] - b->low[axis]) * b->scale[axis]);
}

/** Fills the bins of all axes. */
static void sah_bins_fill(const PrimRef *refs, size_t count, const SahBinning *binning,
                          SahBin bins[3][SAH_BINS]) {
    for (int axis = 0; axis < 3; axis++) {
        for (int i = 0; i < binning->bin_count; i++) {
            bins[axis][i] = (SahBin){.box = build_aabb_empty()};
        }
    }
    for (size_t i = 0; i < count; i++) {
        const BuildAabb *box = &refs[i].box;
        for (int axis = 0; axis < 3; axis++) {
            SahBin *bin = &bins[axis][sah_bin_index(binning, box, axis)];
            build_aabb_extend(&bin->box, box);
            bin->count++;
        }
    }
}

/** Finds the best split along one axis: right sides accumulate from the right, left sides from the
 *  left. @param[in,out] best The best split so far. */
static void sah_best_split_on_axis(const BvhBuilder *builder, const SahBin *bins, int count,
                                   int axis, SahSplit *best) {
    build_scalar right_cost[SAH_BINS];
    BuildAabb right = build_aabb_empty(), left = build_aabb_empty();
    size_t right_count = 0, left_count = 0;
    for (int i = count - 1; i > 0; i--) {
        build_aabb_extend(&right, &bins[i].box);
        right_count += bins[i].count;
        right_cost[i] = right_count ? build_aabb_half_area(&right) *
                                          (build_scalar)block_count_for(builder, right_count)
                                    : (build_scalar)INFINITE;
    }
    for (int i = 1; i < count; i++) {
        build_aabb_extend(&left, &bins[i - 1].box);
        left_count += bins[i - 1].count;
        if (left_count == 0) {
            continue;
        }
        build_scalar cost =
            build_aabb_half_area(&left) * (build_scalar)block_count_for(builder, left_count) +
            right_cost[i];
        if (cost < best->cost) {
            *best = (SahSplit){axis, i, cost};
        }
    }
}

/** Finds the boxes of both sides of a split. @param bins Those along its axis. @param count Their
 *  number. @param[out] sides Left and right. */
static void sah_split_sides(const SahSplit *split, const SahBin *bins, int count,
                            BuildAabb sides[2]) {
    sides[0] = sides[1] = build_aabb_empty();
    for (int i = 0; i < count; i++) {
        build_aabb_extend(&sides[i >= split->bin], &bins[i].box);
    }
}

/** @return The best split of a node. @param[out] sides The boxes of both sides, if there is one. */
static SahSplit sah_best_split(const BvhBuilder *builder, const BuildNode *node,
                               const SahBinning *binning, BuildAabb sides[2]) {
    SahBin bins[3][SAH_BINS];
    SahSplit best = {.axis = -1, .cost = (build_scalar)INFINITE};
    sah_bins_fill(builder->refs + node->first_ref, node->ref_count, binning, bins);
    for (int axis = 0; axis < 3; axis++) {
        if (binning->scale[axis] > 0) {
            sah_best_split_on_axis(builder, bins[axis], binning->bin_count, axis, &best);
        }
    }
    if (best.axis >= 0) {
        sah_split_sides(&best, bins[best.axis], binning->bin_count, sides);
    }
    return best;
}

/* --- the tree -------------------------------------------------------------------------------- */

/** Swaps two references. */
static inline void prim_refs_swap(PrimRef *a, PrimRef *b) {
    PrimRef other = *a;
    *a = *b;
    *b = other;
}

/** Both sides of a split. */
typedef struct SplitSides {
    size_t left_count;              /**< Number of items on the left; 0: the node is a leaf. */
    BuildAabb boxes[2];             /**< Bounding boxes, left and right. */
    BuildAabb doubled_centroids[2]; /**< Boxes of twice the centres of the items. */
} SplitSides;

/** Moves the items of the left side of a split to the front, and finds the centres of both sides.
 */
static void prim_refs_partition(PrimRef *refs, size_t count, const SahBinning *binning,
                                const SahSplit *split, SplitSides *sides) {
    size_t left = 0;
    sides->doubled_centroids[0] = sides->doubled_centroids[1] = build_aabb_empty();
    // Every item is swapped, without a branch: the processor could not predict the side.
    for (size_t i = 0; i < count; i++) {
        bool is_right = sah_bin_index(binning, &refs[i].box, split->axis) >= split->bin;
        build_aabb_extend_centroid(&sides->doubled_centroids[is_right], &refs[i].box);
        prim_refs_swap(&refs[left], &refs[i]);
        left += !is_right;
    }
    sides->left_count = left;
}

/** Computes the bounding boxes of items and of their doubled centres. */
static void prim_refs_compute_bounds(const PrimRef *refs, size_t count, BuildAabb *bounds,
                                     BuildAabb *doubled_centroids) {
    *bounds = *doubled_centroids = build_aabb_empty();
    for (size_t i = 0; i < count; i++) {
        build_aabb_extend(bounds, &refs[i].box);
        build_aabb_extend_centroid(doubled_centroids, &refs[i].box);
    }
}

/** Splits items into halves, in the order in which they are. */
static void prim_refs_halve(const PrimRef *refs, size_t count, SplitSides *sides) {
    size_t half = sides->left_count = count / 2;
    prim_refs_compute_bounds(refs, half, &sides->boxes[0], &sides->doubled_centroids[0]);
    prim_refs_compute_bounds(refs + half, count - half, &sides->boxes[1],
                             &sides->doubled_centroids[1]);
}

/** Splits the root of a subtree by cost, or into halves if there is no such split, or not at all.
 */
static void subtree_split(const BvhBuilder *builder, const Subtree *subtree, SplitSides *sides) {
    const BuildNode *node = &builder->nodes[subtree->root];
    PrimRef *refs = builder->refs + node->first_ref;
    size_t count = node->ref_count, blocks = block_count_for(builder, count);
    sides->left_count = 0;
    if (blocks == 1) {
        return;
    }
    SahBinning binning = sah_binning_of(&subtree->doubled_centroids, count);
    SahSplit split = {.axis = -1};
    if (subtree->depth < SAH_MAX_DEPTH) {
        split = sah_best_split(builder, node, &binning, sides->boxes);
    }
    build_scalar area = build_aabb_half_area(&node->box);
    bool may_be_leaf = blocks <= BVH_LEAF_MAX_BLOCKS;
    if (split.axis < 0 && !may_be_leaf) {
        prim_refs_halve(refs, count, sides);
    } else if (split.axis >= 0 &&
               !(may_be_leaf && area * (build_scalar)blocks <= area * SAH_NODE_COST + split.cost)) {
        prim_refs_partition(refs, count, &binning, &split, sides);
    }
}

/** Defers a subtree to a task, if it is small enough. @param[in,out] next_node The first free node.
 *  @return Whether it is. */
static bool subtree_defer(BvhBuilder *builder, const Subtree *subtree, uint32_t *next_node) {
    uint32_t count = builder->nodes[subtree->root].ref_count;
    if (count > builder->task_max_items || builder->task_count == builder->task_capacity) {
        return false;
    }
    builder->tasks[builder->task_count++] = (SubtreeTask){*subtree, *next_node};
    *next_node += 2 * (count - 1);
    return true;
}

/**
 * Builds a subtree.
 * @param[in,out] next_node  The first free node.
 * @param defers_tasks       Whether subtrees of at most #BvhBuilder.task_max_items become tasks.
 */
static void subtree_build(BvhBuilder *builder, const Subtree *subtree, uint32_t *next_node,
                          bool defers_tasks) {
    SplitSides sides;
    if (defers_tasks && subtree_defer(builder, subtree, next_node)) {
        return;
    }
    BuildNode *node = &builder->nodes[subtree->root];
    subtree_split(builder, subtree, &sides);
    if (sides.left_count == 0) {
        return;
    }
    uint32_t left_count = (uint32_t)sides.left_count;
    node->left_child = *next_node;
    *next_node += 2;
    BuildNode *children = &builder->nodes[node->left_child];
    children[0] = (BuildNode){sides.boxes[0], node->first_ref, left_count, 0};
    children[1] =
        (BuildNode){sides.boxes[1], node->first_ref + left_count, node->ref_count - left_count, 0};
    for (uint32_t i = 0; i < 2; i++) {
        const Subtree child = {node->left_child + i, subtree->depth + 1,
                               sides.doubled_centroids[i]};
        subtree_build(builder, &child, next_node, defers_tasks);
    }
}

/** Builds the subtree of a task. See #ParallelFor.run. */
static void subtree_task_run(void *context, size_t index) {
    BvhBuilder *builder = context;
    const SubtreeTask *task = &builder->tasks[index];
    uint32_t next_node = task->first_node;
    subtree_build(builder, &task->subtree, &next_node, false);
}

void bvh_build_binary(BvhBuilder *builder, size_t count, const ParallelFor *parallel_for) {
    Subtree whole = {.root = 0};
    BuildNode *root = &builder->nodes[0];
    *root = (BuildNode){.ref_count = (uint32_t)count};
    prim_refs_compute_bounds(builder->refs, count, &root->box, &whole.doubled_centroids);
    uint32_t next_node = 1;
    subtree_build(builder, &whole, &next_node, true);
    parallel_for_run(parallel_for, builder->task_count, subtree_task_run, builder);
}
