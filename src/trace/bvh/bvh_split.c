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

/** @return The best split of a node. */
static SahSplit sah_best_split(const BvhBuilder *builder, const BuildNode *node,
                               const SahBinning *binning) {
    SahBin bins[3][SAH_BINS];
    SahSplit best = {.axis = -1, .cost = (build_scalar)INFINITE};
    sah_bins_fill(builder->refs + node->first_ref, node->ref_count, binning, bins);
    for (int axis = 0; axis < 3; axis++) {
        if (binning->scale[axis] > 0) {
            sah_best_split_on_axis(builder, bins[axis], binning->bin_count, axis, &best);
        }
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

/** Moves the items of the left side of a split to the front. @return Their number. */
static size_t prim_refs_partition(PrimRef *refs, size_t count, const SahBinning *binning,
                                  const SahSplit *split) {
    size_t left = 0;
    // Every item is swapped, without a branch: the processor could not predict the side.
    for (size_t i = 0; i < count; i++) {
        bool is_left = sah_bin_index(binning, &refs[i].box, split->axis) < split->bin;
        prim_refs_swap(&refs[left], &refs[i]);
        left += is_left;
    }
    return left;
}

/** Computes the bounding boxes of a node and of its doubled centroids. */
static void build_node_compute_bounds(const BvhBuilder *builder, BuildNode *node,
                                      BuildAabb *doubled_centroids) {
    node->box = *doubled_centroids = build_aabb_empty();
    for (size_t i = 0; i < node->ref_count; i++) {
        const BuildAabb *box = &builder->refs[node->first_ref + i].box;
        build_aabb_extend(&node->box, box);
        build_aabb_extend_centroid(doubled_centroids, box);
    }
}

/**
 * Splits a node by cost, or into halves if there is no such split, or not at all.
 * @param doubled_centroids  Box of the doubled centroids.
 * @param level              Depth of the node.
 * @return Number of items on the left; 0: the node is a leaf.
 */
static size_t build_node_partition(const BvhBuilder *builder, const BuildNode *node,
                                   const BuildAabb *doubled_centroids, int level) {
    size_t blocks = block_count_for(builder, node->ref_count);
    if (blocks == 1) {
        return 0;
    }
    SahBinning binning = sah_binning_of(doubled_centroids, node->ref_count);
    SahSplit split = {.axis = -1};
    if (level < SAH_MAX_DEPTH) {
        split = sah_best_split(builder, node, &binning);
    }
    if (split.axis >= 0) {
        build_scalar area = build_aabb_half_area(&node->box);
        bool is_leaf = blocks <= BVH_LEAF_MAX_BLOCKS &&
                       area * (build_scalar)blocks <= area * SAH_NODE_COST + split.cost;
        return is_leaf ? 0
                       : prim_refs_partition(builder->refs + node->first_ref, node->ref_count,
                                             &binning, &split);
    }
    return blocks <= BVH_LEAF_MAX_BLOCKS ? 0 : node->ref_count / 2;
}

/**
 * Builds the subtree of a node.
 * @param node_index    The node; its range of references is set.
 * @param level         Depth of the node.
 * @param defers_tasks  Whether subtrees of at most #BvhBuilder.task_max_items become tasks.
 */
static void build_node_build(BvhBuilder *builder, uint32_t node_index, int level,
                             bool defers_tasks) {
    BuildNode *node = &builder->nodes[node_index];
    if (defers_tasks && node->ref_count <= builder->task_max_items &&
        builder->task_count < builder->task_capacity) {
        builder->tasks[builder->task_count++] = (SubtreeTask){node_index, level};
        return;
    }
    BuildAabb doubled_centroids;
    build_node_compute_bounds(builder, node, &doubled_centroids);
    size_t left = build_node_partition(builder, node, &doubled_centroids, level);
    if (left == 0) {
        return;
    }
    node->right_child = node_index + 2 * (uint32_t)left;
    builder->nodes[node_index + 1] =
        (BuildNode){.first_ref = node->first_ref, .ref_count = (uint32_t)left};
    builder->nodes[node->right_child] = (BuildNode){.first_ref = node->first_ref + (uint32_t)left,
                                                    .ref_count = node->ref_count - (uint32_t)left};
    build_node_build(builder, node_index + 1, level + 1, defers_tasks);
    build_node_build(builder, node->right_child, level + 1, defers_tasks);
}

/** Builds the subtree of a task. See #ParallelFor.run. */
static void subtree_task_run(void *context, size_t index) {
    BvhBuilder *builder = context;
    build_node_build(builder, builder->tasks[index].node, builder->tasks[index].depth, false);
}

void bvh_build_binary(BvhBuilder *builder, size_t count, const ParallelFor *parallel_for) {
    builder->nodes[0] = (BuildNode){.ref_count = (uint32_t)count};
    build_node_build(builder, 0, 0, true);
    parallel_for_run(parallel_for, builder->task_count, subtree_task_run, builder);
}
