/**
 * @file
 * @brief Asking the shapes of a scene: what a packet of rays meets first, and what blocks it.
 */
#include "trace/shape_list.h"

/* --- the shapes that are not in a tree ------------------------------------------------------- */

/** The shapes of a block that a packet may meet. */
typedef struct Candidates {
    unsigned left; /**< Bit i set: shape i of the block is still to be asked. */
    real near;     /**< For each shape of the block: it is nowhere met nearer than this. */
} Candidates;

/**
 * @return The shapes of a block that a packet may meet. A packet of one ray asks every shape
 * itself.
 * @param list   The shapes.
 * @param spans  What is known of the packet.
 * @param block  Which block of boxes.
 */
static Candidates block_candidates(const ShapeList *list, const Spans *spans, size_t block) {
    if (LANES == 1) {
        return (Candidates){1, real_of(0)};
    }
    Candidates candidates;
    size_t left = list->loose_count - block * LANES;
    unsigned there = left < LANES ? (1u << left) - 1 : ALL_LANES;
    mask may_meet = spans_may_meet(spans, &list->bounds[block], &candidates.near);
    candidates.left = mask_bits(may_meet) & there;
    return candidates;
}

/** Takes the nearest of the candidates out of them, so that what it hides need not be asked.
 *  @param[in,out] candidates At least one. @return Its place in the block. */
static int candidates_take(Candidates *candidates) {
    int best = __builtin_ctz(candidates->left);
    for (unsigned left = candidates->left; left; left &= left - 1) {
        int other = __builtin_ctz(left);
        bool is_nearer = real_lane(candidates->near, other) < real_lane(candidates->near, best);
        best = is_nearer ? other : best;
    }
    candidates->left &= ~(1u << best);
    return best;
}

/**
 * Asks one shape about the rays of a packet that have met nothing nearer.
 * @param shape   The shape.
 * @param near    It is nowhere met nearer than this.
 * @param packet  The rays.
 * @param[in,out] hits  What they have met so far.
 */
static void shape_nearest(const Shape *shape, scalar near, const Packet *packet, Hit *hits) {
    if (shape->class->nearest) {
        shape->class->nearest(shape, packet, hits);
        return;
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask open = packet->active[v] & (hits[v].distance >= real_of(near));
        if (LANES == 1 || any(open)) {
            shape->class->is_hit(shape, &packet->rays[v], packet->active[v], &hits[v]);
        }
    }
}

/**
 * Asks one shape whether it blocks the rays of a packet that are not blocked yet.
 * @param shape   The shape.
 * @param packet  The rays.
 * @param[in,out] blocked  Those that are blocked.
 */
static void shape_blocked(const Shape *shape, const Packet *packet, mask *blocked) {
    if (shape->class->blocked) {
        shape->class->blocked(shape, packet, blocked);
        return;
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask open = packet->active[v] & mask_not(blocked[v]);
        if (any(open)) {
            blocked[v] |=
                shape->class->is_blocking(shape, &packet->rays[v], open, packet->limit[v]);
        }
    }
}

/* --- the shapes of the tree ------------------------------------------------------------------ */

/** Asks the shapes of a leaf about rays. See #TreeOwner.ask. @param items The list.
 *  @param leaf The leaf. @param rays The rays. @param[in,out] found The hits. */
static void leaf_nearest(const void *items, TreeLeaf leaf, const TreeRays *rays, void *found) {
    const ShapeList *list = items;
    const Ray *ray = &rays->packet->rays[rays->vector];
    Hit *hit = (Hit *)found + rays->vector;
    mask active = mask_of_bits(rays->lanes);
    for (size_t i = leaf.first; i < leaf.first + leaf.count; i++) {
        const Shape *shape = list->shapes[list->tree.order[i]];
        shape->class->is_hit(shape, ray, active, hit);
    }
    rays->limits[rays->vector] = hit->distance;
}

/** Asks the shapes of a leaf whether they block rays. See #TreeOwner.ask. @param items The list.
 *  @param leaf The leaf. @param rays The rays. @param[in,out] found What is blocked. */
static void leaf_blocked(const void *items, TreeLeaf leaf, const TreeRays *rays, void *found) {
    const ShapeList *list = items;
    const Ray *ray = &rays->packet->rays[rays->vector];
    real limit = rays->packet->limit[rays->vector];
    mask *blocked = (mask *)found + rays->vector, active = mask_of_bits(rays->lanes);
    for (size_t i = leaf.first; i < leaf.first + leaf.count; i++) {
        const Shape *shape = list->shapes[list->tree.order[i]];
        mask open = active & mask_not(*blocked);
        if (any(open)) {
            *blocked |= shape->class->is_blocking(shape, ray, open, limit);
        }
    }
    rays->limits[rays->vector] = real_select(*blocked, real_of(-1), limit);
}

/** Asks the shapes of the tree, if there is one, what rays meet. @param list The shapes.
 *  @param packet The rays. @param[in,out] hits What they have met so far. */
static void tree_nearest(const ShapeList *list, const Packet *packet, Hit *hits) {
    const TreeOwner owner = {.items = list, .asks_vectors = true, .ask = leaf_nearest};
    real limits[PACKET_VECTORS];
    if (list->tree.nodes) {
        for (int v = 0; v < PACKET_VECTORS; v++) {
            limits[v] = hits[v].distance;
        }
        tree_visit(&list->tree, packet, limits, &owner, hits);
    }
}

/** Asks the shapes of the tree, if there is one, which rays they block. @param list The shapes.
 *  @param packet The rays. @param[in,out] blocked Those that are blocked. */
static void tree_blocked(const ShapeList *list, const Packet *packet, mask *blocked) {
    const TreeOwner owner = {.items = list, .asks_vectors = true, .ask = leaf_blocked};
    real limits[PACKET_VECTORS];
    if (list->tree.nodes) {
        for (int v = 0; v < PACKET_VECTORS; v++) {
            limits[v] = real_select(blocked[v], real_of(-1), packet->limit[v]);
        }
        tree_visit(&list->tree, packet, limits, &owner, blocked);
    }
}

/** A visit under way. */
typedef struct Visit {
    ShapeVisitor visitor; /**< Who is asked. */
    void *found;          /**< Handed to it. */
} Visit;

/** Visits the shapes of a leaf. See #TreeOwner.ask. @param items The list. @param leaf The leaf.
 *  @param rays The rays; they look all of the way. @param[in,out] found A #Visit. */
static void leaf_visit(const void *items, TreeLeaf leaf, const TreeRays *rays, void *found) {
    const ShapeList *list = items;
    const Visit *visit = found;
    for (size_t i = leaf.first; i < leaf.first + leaf.count; i++) {
        const Shape *shape = list->shapes[list->tree.order[i]];
        visit->visitor(shape, rays->packet, rays->vector, mask_of_bits(rays->lanes), visit->found);
    }
}

/** Visits the shapes of the tree, if there is one. @param list The shapes. @param packet The rays.
 *  @param visit The visit. */
static void tree_visit_all(const ShapeList *list, const Packet *packet, Visit *visit) {
    const TreeOwner owner = {.items = list, .asks_vectors = true, .ask = leaf_visit};
    real limits[PACKET_VECTORS];
    if (list->tree.nodes) {
        for (int v = 0; v < PACKET_VECTORS; v++) {
            limits[v] = packet->limit[v];
        }
        tree_visit(&list->tree, packet, limits, &owner, visit);
    }
}

/* --- all shapes ------------------------------------------------------------------------------ */

void shape_list_nearest(const ShapeList *list, const Packet *packet, Hit *hits) {
    Spans spans = {0};
    if (LANES > 1 && list->loose_count > 0) {
        spans = packet_spans(packet);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        hits[v] = hit_nothing(packet->limit[v]);
    }
    for (size_t block = 0; block < bounds_blocks(list->loose_count); block++) {
        Candidates candidates = block_candidates(list, &spans, block);
        while (candidates.left) {
            int lane = candidates_take(&candidates);
            const Shape *shape = list->loose[block * LANES + (size_t)lane];
            shape_nearest(shape, real_lane(candidates.near, lane), packet, hits);
        }
    }
    tree_nearest(list, packet, hits);
}

void shape_list_blocked(const ShapeList *list, const Packet *packet, mask *blocked) {
    Spans spans = {0};
    if (LANES > 1 && list->loose_count > 0) {
        spans = packet_spans(packet);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        blocked[v] = mask_of(false);
    }
    for (size_t block = 0; block < bounds_blocks(list->loose_count); block++) {
        unsigned left = block_candidates(list, &spans, block).left;
        for (; left; left &= left - 1) {
            size_t place = block * LANES + (size_t)__builtin_ctz(left);
            shape_blocked(list->loose[place], packet, blocked);
        }
    }
    tree_blocked(list, packet, blocked);
}

void shape_list_visit(const ShapeList *list, const Packet *packet, ShapeVisitor visitor,
                      void *found) {
    Spans spans = {0};
    if (LANES > 1 && list->loose_count > 0) {
        spans = packet_spans(packet);
    }
    for (size_t block = 0; block < bounds_blocks(list->loose_count); block++) {
        unsigned left = block_candidates(list, &spans, block).left;
        for (; left; left &= left - 1) {
            const Shape *shape = list->loose[block * LANES + (size_t)__builtin_ctz(left)];
            for (int v = 0; v < PACKET_VECTORS; v++) {
                if (any(packet->active[v])) {
                    visitor(shape, packet, v, packet->active[v], found);
                }
            }
        }
    }
    Visit visit = {visitor, found};
    tree_visit_all(list, packet, &visit);
}
