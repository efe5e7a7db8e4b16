/**
 * @file
 * @brief Which triangles of a model rays meet.
 *
 * A packet takes the triangles of a block one after the other; a single ray takes all of them at
 * once. Both do the same operations in the same order.
 */
#include "trace/corners.h"
#include "trace/model_point.h"

/** What the rays of a packet have met of a model. */
typedef struct ModelHits {
    real distances[PACKET_VECTORS]; /**< The nearest so far; at first how far rays look. */
    integer slots[PACKET_VECTORS];  /**< Which triangle, by its place in the blocks; -1: none. */
} ModelHits;

/** @return A corner of one triangle in all lanes. @param block A block. @param i Which corner.
 *  @param lane Which of its triangles. */
INLINE Vector corner_of_lane(const TriangleBlock *block, int i, int lane) {
    const Vector *at = &block->corners[i];
    return (Vector){real_of(real_at(&at->x, lane)), real_of(real_at(&at->y, lane)),
                    real_of(real_at(&at->z, lane))};
}

/** @return The same triangle in all lanes. @param block A block. @param lane Which of its
 * triangles.
 */
INLINE Corners corners_of(const TriangleBlock *block, int lane) {
    return (Corners){{corner_of_lane(block, 0, lane), corner_of_lane(block, 1, lane),
                      corner_of_lane(block, 2, lane)}};
}

/* --- a packet against the triangles of a leaf ------------------------------------------------ */

/** @return The lanes in which a triangle comes before what was met: nearer, or as near and earlier
 * in the mesh. @param model The model. @param hits What was met. @param v Which vector.
 *  @param met The lanes that meet it. @param distance The triangle's. @param slot Its place. */
INLINE mask slot_is_nearer(const Model *model, const ModelHits *hits, int v, mask met,
                           real distance, size_t slot) {
    mask nearer = met & (distance < hits->distances[v]);
    mask tie = met & (distance == hits->distances[v]);
    uint32_t triangle = model->blocks[slot / LANES].triangles[slot % LANES];
    while (any(tie)) {
        int lane = mask_first(tie);
        int other = integer_lane(hits->slots[v], lane);
        bool is_first =
            other < 0 || triangle < model->blocks[other / LANES].triangles[other % LANES];
        mask_set_lane(&nearer, lane, is_first);
        mask_set_lane(&tie, lane, false);
    }
    return nearer;
}

/** Takes a triangle where it comes before what was met. @param model The model. @param slot The
 *  triangle. @param ray The rays. @param inside Those that pass inside of it. @param v Which
 * vector.
 *  @param[in,out] hits What was met. */
static void slot_take(const Model *model, size_t slot, const Ray *ray, mask inside, int v,
                      ModelHits *hits) {
    Corners corners = corners_of(&model->blocks[slot / LANES], (int)(slot % LANES));
    real distance;
    mask met = corners_meet(&corners, ray, inside, &distance);
    mask nearer = slot_is_nearer(model, hits, v, met, distance, slot);
    hits->distances[v] = real_select(nearer, distance, hits->distances[v]);
    hits->slots[v] = integer_select(nearer, integer_of((int)slot), hits->slots[v]);
}

/** Asks the triangles of a block, one by one, about the rays that run mainly along one axis.
 *  @param model The model. @param b The block. @param ray The rays. @param axis The axis.
 *  @param active The lanes. @param v Which vector. @param[in,out] hits What was met. */
INLINE void block_ask_along(const Model *model, size_t b, const Ray *ray, int axis, mask active,
                            int v, ModelHits *hits) {
    const TriangleBlock *block = &model->blocks[b];
    Ray turned = shear_turn(ray, axis);
    for (int lane = 0; lane < LANES; lane++) {
        /* What repeats only fills the block up. */
        if (lane > 0 && block->triangles[lane] == block->triangles[lane - 1]) {
            return;
        }
        Offset offsets[3];
        for (int i = 0; i < 3; i++) {
            offsets[i] = shear_offset(vector_turn(corner_of_lane(block, i, lane), axis), &turned);
        }
        mask inside = active & shear_surrounds(offsets, 3);
        if (any(inside)) {
            slot_take(model, b * LANES + (size_t)lane, ray, inside, v, hits);
        }
    }
}

/** Asks the triangles of a leaf, one by one, about a vector of rays. @param model The model.
 *  @param first Block. @param count Blocks. @param ray The rays. @param v Which vector.
 *  @param active The lanes. @param[in,out] hits What was met. */
static void leaf_ask_all(const Model *model, size_t first, size_t count, const Ray *ray, int v,
                         mask active, ModelHits *hits) {
    MainAxes along = shear_main_axes(ray, active);
    bool any_x = any(along.x), any_y = any(along.y), any_z = any(along.z);
    for (size_t b = first; b < first + count; b++) {
        if (any_x) {
            block_ask_along(model, b, ray, 0, along.x, v, hits);
        }
        if (any_y) {
            block_ask_along(model, b, ray, 1, along.y, v, hits);
        }
        if (any_z) {
            block_ask_along(model, b, ray, 2, along.z, v, hits);
        }
    }
}

/* --- one ray against the triangles of a leaf ------------------------------------------------- */

/** @return One ray in all lanes. @param ray The rays. @param lane Which of them. */
INLINE Ray ray_spread(const Ray *ray, int lane) {
    const Vector *o = &ray->origin, *d = &ray->direction, *i = &ray->inverse;
    return (Ray){{real_of(real_at(&o->x, lane)), real_of(real_at(&o->y, lane)),
                  real_of(real_at(&o->z, lane))},
                 {real_of(real_at(&d->x, lane)), real_of(real_at(&d->y, lane)),
                  real_of(real_at(&d->z, lane))},
                 {real_of(real_at(&i->x, lane)), real_of(real_at(&i->y, lane)),
                  real_of(real_at(&i->z, lane))}};
}

/** @return The triangles of a block that a ray passes inside of. @param block The block.
 *  @param ray The ray, in all lanes. @param[out] distance How far away each is crossed. */
INLINE mask block_meets(const TriangleBlock *block, const Ray *ray, real *distance) {
    Corners corners = {{block->corners[0], block->corners[1], block->corners[2]}};
    MainAxes along = shear_main_axes(ray, mask_of(true));
    mask inside = mask_lane(along.x, 0)   ? corners_surround(&corners, ray, 0)
                  : mask_lane(along.y, 0) ? corners_surround(&corners, ray, 1)
                                          : corners_surround(&corners, ray, 2);
    if (any(inside)) {
        inside = corners_meet(&corners, ray, inside, distance);
    }
    return inside;
}

/** Takes what is nearest of a block's triangles. @param model The model. @param b The block.
 *  @param inside Its triangles that are met. @param distance How far away. @param[in,out] best The
 *  nearest so far. @param[in,out] best_slot Its slot. */
static void block_take(const Model *model, size_t b, unsigned inside, real distance, scalar *best,
                       int *best_slot) {
    for (; inside; inside &= inside - 1) {
        int lane = __builtin_ctz(inside);
        scalar t = real_lane(distance, lane);
        bool is_first =
            *best_slot < 0 || model->blocks[b].triangles[lane] <
                                  model->blocks[*best_slot / LANES].triangles[*best_slot % LANES];
        if (t < *best || (t == *best && is_first)) {
            *best = t;
            *best_slot = (int)(b * LANES) + lane;
        }
    }
}

/** Asks the triangles of a leaf, side by side, about one ray. @param model The model.
 *  @param first Block. @param count Blocks. @param rays The rays. @param v Which vector they are.
 *  @param lane Which of them. @param[in,out] hits What was met. */
static void leaf_ask_one(const Model *model, size_t first, size_t count, const Ray *rays, int v,
                         int lane, ModelHits *hits) {
    Ray ray = ray_spread(rays, lane);
    scalar best = real_at(&hits->distances[v], lane);
    int slot = integer_lane(hits->slots[v], lane);
    for (size_t b = first; b < first + count; b++) {
        real distance = real_of(0);
        unsigned inside = mask_bits(block_meets(&model->blocks[b], &ray, &distance));
        if (inside) {
            block_take(model, b, inside, distance, &best, &slot);
            real_set_lane(&hits->distances[v], lane, best);
            integer_set_lane(&hits->slots[v], lane, slot);
        }
    }
}

/* --- leaves ---------------------------------------------------------------------------------- */

/** @return Whether a leaf is asked ray by ray, all its triangles at once, rather than triangle by
 *  triangle, all rays at once: whichever is less work. @param lanes How many rays. */
INLINE bool leaf_is_for_one(int lanes) {
    /** Rays a block for which the two are about as quick (measured): blocks are not always full. */
    const int even = 3 * LANES / 8;
    return lanes <= even || LANES == 1;
}

/** Asks a leaf about rays. See #TreeOwner.ask. @param items The model. @param first Block.
 *  @param count Blocks. @param packet The rays. @param v Which vector. @param lanes Which lanes.
 *  @param[in,out] found A #ModelHits. @return How far they still look. */
static real model_ask(const void *items, size_t first, size_t count, const Packet *packet, int v,
                      unsigned lanes, void *found) {
    ModelHits *hits = found;
    if (leaf_is_for_one(__builtin_popcount(lanes))) {
        for (; lanes; lanes &= lanes - 1) {
            leaf_ask_one(items, first, count, &packet->rays[v], v, __builtin_ctz(lanes), hits);
        }
    } else {
        leaf_ask_all(items, first, count, &packet->rays[v], v, mask_of_bits(lanes), hits);
    }
    return hits->distances[v];
}

/* --- shadows --------------------------------------------------------------------------------- */

/** Asks a leaf about shadow rays: those that meet anything look no further. See #TreeOwner.ask.
 *  @param items The model. @param first Block. @param count Blocks. @param packet The rays.
 *  @param v Which vector. @param lanes Which lanes. @param[in,out] found A #ModelHits.
 *  @return How far they still look. */
static real model_ask_shadow(const void *items, size_t first, size_t count, const Packet *packet,
                             int v, unsigned lanes, void *found) {
    real distance = model_ask(items, first, count, packet, v, lanes, found);
    return real_select(distance < packet->limit[v], real_of(-1), distance);
}

/* --- all of it ------------------------------------------------------------------------------- */

void model_nearest(const Model *model, const Packet *packet, int place, Hit *hits) {
    ModelHits found;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        found.distances[v] = hits[v].distance;
        found.slots[v] = integer_of(-1);
    }
    const TreeOwner owner = {model, model->blocks, sizeof *model->blocks, model_ask};
    tree_visit(&model->tree, packet, found.distances, &owner, &found);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask met = packet->active[v] & (found.slots[v] >= integer_of(0));
        mask nearer = hit_is_nearer(&hits[v], met, found.distances[v], place);
        if (any(nearer)) {
            Hit hit = model_hit(model, &packet->rays[v], found.distances[v], found.slots[v], nearer,
                                place);
            hit_take(&hits[v], nearer, &hit);
        }
    }
}

void model_blocked(const Model *model, const Packet *packet, mask *blocked) {
    ModelHits found;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        found.distances[v] = real_select(blocked[v], real_of(-1), packet->limit[v]);
        found.slots[v] = integer_of(-1);
    }
    const TreeOwner owner = {model, model->blocks, sizeof *model->blocks, model_ask_shadow};
    tree_visit(&model->tree, packet, found.distances, &owner, &found);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        blocked[v] |= packet->active[v] & (found.slots[v] >= integer_of(0)) &
                      (found.distances[v] < packet->limit[v]);
    }
}
