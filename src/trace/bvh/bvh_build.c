/**
 * @file
 * @brief Construction of a BVH: a binary tree first, whose levels are then merged into wide nodes.
 */
#include "trace/bvh/bvh_split.h"

#include <stdlib.h>
#include <string.h>

/** Tasks per thread: enough to even out their sizes. */
enum { TASKS_PER_THREAD = 16 };
/** Smallest number of items of a task. */
enum { TASK_MIN_ITEMS = 1024 };
/** Alignment of nodes, bytes: the widest vector of any engine. */
#define BVH_NODE_ALIGNMENT 64

/* --- from binary to wide --------------------------------------------------------------------- */

/** Children of a wide node, as subtrees of the binary tree. */
typedef struct CollapsedChildren {
    uint32_t nodes[BVH_WIDTH];     /**< Indices in #BvhBuilder.nodes. */
    build_scalar areas[BVH_WIDTH]; /**< Half the areas of their boxes; -1: it is a leaf. */
    int count;                     /**< Number of children. */
} CollapsedChildren;

/** Sets a child. @param i Its index. @param build_index Its subtree. */
static void collapsed_children_set(const BvhBuilder *builder, CollapsedChildren *children, int i,
                                   uint32_t build_index) {
    const BuildNode *node = &builder->nodes[build_index];
    children->nodes[i] = build_index;
    children->areas[i] = node->left_child ? build_aabb_half_area(&node->box) : -1;
}

/** @return The inner node with the largest box; -1: all are leaves. */
static int collapsed_children_largest(const CollapsedChildren *children) {
    int largest = -1;
    build_scalar area = -1;
    for (int i = 0; i < children->count; i++) {
        if (children->areas[i] > area) {
            area = children->areas[i];
            largest = i;
        }
    }
    return largest;
}

/** @return The children of a wide node: the largest one is replaced by its two children until the
 *  node is full. */
static CollapsedChildren collapsed_children_of(const BvhBuilder *builder, uint32_t build_index) {
    CollapsedChildren children;
    children.count = 1;
    collapsed_children_set(builder, &children, 0, build_index);
    int expand = collapsed_children_largest(&children);
    while (expand >= 0 && children.count < BVH_WIDTH) {
        uint32_t left_child = builder->nodes[children.nodes[expand]].left_child;
        collapsed_children_set(builder, &children, expand, left_child);
        collapsed_children_set(builder, &children, children.count++, left_child + 1);
        expand = collapsed_children_largest(&children);
    }
    return children;
}

/** Counts the wide nodes and blocks of a subtree. */
static void bvh_count_nodes(BvhBuilder *builder, uint32_t build_index) {
    CollapsedChildren children = collapsed_children_of(builder, build_index);
    builder->bvh->node_count++;
    for (int i = 0; i < children.count; i++) {
        const BuildNode *node = &builder->nodes[children.nodes[i]];
        if (node->left_child) {
            bvh_count_nodes(builder, children.nodes[i]);
        } else {
            builder->bvh->block_count += block_count_for(builder, node->ref_count);
        }
    }
}

/** Fills the blocks of a leaf. @return Its element of #BvhNode.children. */
static uint32_t bvh_make_leaf(BvhBuilder *builder, const BuildNode *node) {
    Bvh *bvh = builder->bvh;
    size_t first_block = bvh->block_count, block_count = block_count_for(builder, node->ref_count);
    for (size_t i = 0; i < block_count * bvh->block_size; i++) {
        size_t item = i < node->ref_count ? i : node->ref_count - 1u;
        bvh->item_indices[first_block * bvh->block_size + i] =
            builder->refs[node->first_ref + item].item;
    }
    bvh->block_count += block_count;
    return BVH_LEAF_BIT | (uint32_t)(first_block << BVH_LEAF_COUNT_BITS) | (uint32_t)block_count;
}

/** Sets the box of a child. */
static void bvh_node_set_box(BvhNode *node, int i, const BuildAabb *box) {
    Aabb *block = &node->bounds[i / LANES];
    for (int axis = 0; axis < 3; axis++) {
        real_set_lane(&block->planes[axis], i % LANES, box->low[axis]);
        real_set_lane(&block->planes[axis + 3], i % LANES, box->high[axis]);
    }
}

#if BVH_HAS_ORDERS

/** @return How far a box, which is finite, is along the diagonal of an octant: twice the sum of
 *          the coordinates of its centre, with their signs. */
static build_scalar build_aabb_advance(const BuildAabb *box, unsigned octant) {
    build_scalar sum = 0;
    for (int axis = 0; axis < 3; axis++) {
        build_scalar twice = box->low[axis] + box->high[axis];
        sum += octant >> axis & 1 ? -twice : twice;
    }
    return sum;
}

/** Finds how far the children of a node are along the diagonal of an octant.
 *  @param[out] advances The result; where there is no child, behind all. */
static void child_advances_find(const BvhBuilder *builder, const CollapsedChildren *children,
                                unsigned octant, build_scalar *advances) {
    for (int i = 0; i < BVH_WIDTH; i++) {
        advances[i] = i < children->count
                          ? build_aabb_advance(&builder->nodes[children->nodes[i]].box, octant)
                          : -(build_scalar)INFINITE;
    }
}

/** Finds the places of children from far to near: the numbers of farther ones. Counting takes no
 *  branch that the processor could not predict, as sorting does. */
static void child_advances_rank(const build_scalar *advances, int32_t *places) {
    memset(places, 0, BVH_WIDTH * sizeof *places);
    for (int other = 0; other < BVH_WIDTH; other++) {
        build_scalar advance = advances[other];
        for (int i = 0; i < BVH_WIDTH; i++) {
            places[i] += (advance > advances[i]) | ((advance == advances[i]) & (other < i));
        }
    }
}

/** Sorts the children of a node from far to near, as rays of an octant meet them; rays of the
 *  opposite octant meet them the other way. @param octant One of the first half. */
static void bvh_node_sort_octant(BvhNode *node, const BvhBuilder *builder,
                                 const CollapsedChildren *children, unsigned octant) {
    lane_order order = 0, opposite = 0;
    build_scalar advances[BVH_WIDTH];
    int32_t places[BVH_WIDTH];
    child_advances_find(builder, children, octant, advances);
    child_advances_rank(advances, places);
    for (int i = 0; i < BVH_WIDTH; i++) {
        int place = places[i];
        order = lane_order_with(order, place, i);
        opposite =
            lane_order_with(opposite, i < children->count ? children->count - 1 - place : place, i);
    }
    node->orders[octant] = order;
    node->orders[DIRECTION_OCTANTS - 1 - octant] = opposite;
}

#endif

/** Creates the wide nodes of a subtree, each before its children. @return Index of the first. */
static uint32_t bvh_make_nodes(BvhBuilder *builder, uint32_t build_index) {
    uint32_t node_index = (uint32_t)builder->bvh->node_count++;
    BvhNode *node = &builder->bvh->nodes[node_index];
    CollapsedChildren children = collapsed_children_of(builder, build_index);
    BuildAabb nothing = build_aabb_empty();
#if BVH_HAS_ORDERS
    for (unsigned octant = 0; octant < DIRECTION_OCTANTS / 2; octant++) {
        bvh_node_sort_octant(node, builder, &children, octant);
    }
#endif
    for (int i = 0; i < BVH_WIDTH; i++) {
        if (i >= children.count) {
            node->children[i] = BVH_LEAF_BIT;
            bvh_node_set_box(node, i, &nothing);
            continue;
        }
        const BuildNode *child = &builder->nodes[children.nodes[i]];
        bvh_node_set_box(node, i, &child->box);
        node->children[i] = child->left_child ? bvh_make_nodes(builder, children.nodes[i])
                                              : bvh_make_leaf(builder, child);
    }
    return node_index;
}

/* --- the whole tree -------------------------------------------------------------------------- */

/** Fills #BvhBuilder.refs. */
static void prim_refs_fill(BvhBuilder *builder, const Aabbs *boxes, size_t count) {
    for (size_t i = 0; i < count; i++) {
        PrimRef *ref = &builder->refs[i];
        ref->item = (uint32_t)i;
        ref->box = (BuildAabb){{0}, {0}};
        for (int axis = 0; axis < 3; axis++) {
            ref->box.low[axis] = build_scalar_below(boxes[i].low[axis]);
            ref->box.high[axis] = build_scalar_above(boxes[i].high[axis]);
        }
    }
}

/** Converts the binary tree to the wide one. @return false without memory. */
static bool bvh_collapse(BvhBuilder *builder) {
    Bvh *bvh = builder->bvh;
    bvh_count_nodes(builder, 0);
    bvh->nodes = aligned_alloc(BVH_NODE_ALIGNMENT,
                               (bvh->node_count * sizeof(BvhNode) + BVH_NODE_ALIGNMENT - 1) /
                                   BVH_NODE_ALIGNMENT * BVH_NODE_ALIGNMENT);
    bvh->item_indices = malloc(bvh->block_count * bvh->block_size * sizeof *bvh->item_indices);
    if (!bvh->nodes || !bvh->item_indices || bvh->block_count >= BVH_MAX_BLOCKS) {
        return false;
    }
    bvh->node_count = bvh->block_count = 0;
    bvh_make_nodes(builder, 0);
    return true;
}

bool bvh_build(Bvh *bvh, const Aabbs *boxes, size_t count, size_t block_size,
               const ParallelFor *parallel_for) {
    *bvh = (Bvh){.block_size = block_size};
    if (count >= BVH_MAX_BLOCKS) {
        return false;
    }
    size_t task_count = TASKS_PER_THREAD *
                        (size_t)(parallel_for->thread_count > 1 ? parallel_for->thread_count : 1);
    BvhBuilder builder = {.refs = malloc(count * sizeof(PrimRef)),
                          .nodes = malloc(2 * count * sizeof(BuildNode)),
                          .tasks = calloc(4 * task_count, sizeof(SubtreeTask)),
                          .task_capacity = 4 * task_count,
                          .task_max_items = count / task_count > TASK_MIN_ITEMS ? count / task_count
                                                                                : TASK_MIN_ITEMS,
                          .block_shift = __builtin_ctzll(block_size),
                          .bvh = bvh};
    bool is_built = builder.refs && builder.nodes && builder.tasks;
    if (is_built) {
        prim_refs_fill(&builder, boxes, count);
        bvh_build_binary(&builder, count, parallel_for);
        is_built = bvh_collapse(&builder);
    }
    free(builder.refs);
    free(builder.nodes);
    free(builder.tasks);
    if (!is_built) {
        bvh_deinit(bvh);
    }
    return is_built;
}

void bvh_deinit(Bvh *bvh) {
    free(bvh->nodes);
    free(bvh->item_indices);
    *bvh = (Bvh){0};
}

size_t bvh_memory_size(const Bvh *bvh) {
    return bvh->node_count * sizeof *bvh->nodes +
           (bvh->item_indices ? bvh->block_count * bvh->block_size * sizeof *bvh->item_indices : 0);
}
