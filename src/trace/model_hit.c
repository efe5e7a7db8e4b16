/**
 * @file
 * @brief Which triangles of a model rays meet.
 *
 * A packet takes the triangles of a block one after the other; a single ray takes all of them at
 * once. Both do the same operations in the same order.
 */
#include "trace/corners.h"
#include "trace/model_point.h"

/** What is worked out of the triangles of a block when the first of them is met. */
typedef struct BlockPlanes {
    size_t block;       /**< Which block; #NO_BLOCK: none. */
    BoundsBlock boxes;  /**< Their boxes. */
    WideVector normals; /**< Normals of their planes, of any length. */
} BlockPlanes;

/** Larger than the place of any block. */
#define NO_BLOCK SIZE_MAX

/** What the rays of a packet have met of a model; how far away, their limits say. */
typedef struct ModelHits {
    integer slots[PACKET_VECTORS]; /**< Which triangle, by its place in the blocks; -1: none. */
    BlockPlanes planes;            /**< Those of the last block of which one was met. */
} ModelHits;

/** @return All triangles of a block. @param block The block. */
INLINE Corners block_corners(const TriangleBlock *block) {
    return (Corners){{block->corners[0], block->corners[1], block->corners[2]}};
}

/** @return A corner of one triangle in all lanes. @param block A block. @param i Which corner.
 *  @param lane Which of its triangles. */
INLINE Vector corner_of_lane(const TriangleBlock *block, int i, int lane) {
    const Vector *at = &block->corners[i];
    return (Vector){real_of(real_at(&at->x, lane)), real_of(real_at(&at->y, lane)),
                    real_of(real_at(&at->z, lane))};
}

/* --- a packet against the triangles of a leaf ------------------------------------------------ */

/** @return The lanes in which a triangle comes before what was met: nearer, or as near and earlier
 * in the mesh. @param model The model. @param met The lanes that meet it. @param distance How far
 * away. @param slot Its place. @param limit How far away what was met is. @param slots Which it is.
 */
INLINE mask slot_is_nearer(const Model *model, mask met, real distance, size_t slot, real limit,
                           const integer *slots) {
    mask nearer = met & (distance < limit), tie = met & (distance == limit);
    uint32_t triangle = model->blocks[slot / LANES].triangles[slot % LANES];
    while (any(tie)) {
        int lane = mask_first(tie);
        int other = integer_at(slots, lane);
        bool is_first =
            other < 0 || triangle < model->blocks[other / LANES].triangles[other % LANES];
        mask_set_lane(&nearer, lane, is_first);
        mask_set_lane(&tie, lane, false);
    }
    return nearer;
}

/** Works out the planes of a block. @param model The model. @param b The block.
 *  @param[out] planes Its planes. */
static void planes_find(const Model *model, size_t b, BlockPlanes *planes) {
    Corners corners = block_corners(&model->blocks[b]);
    planes->block = b;
    planes->boxes = corners_boxes(&corners);
    planes->normals = corners_normal(&corners);
}

/** @return How far away rays cross the plane of a triangle. @param block The triangle's block.
 *  @param normals Normals of the block's. @param lane Which. @param ray The rays. */
INLINE real lane_distance(const TriangleBlock *block, const WideVector *normals, int lane,
                          const Ray *ray) {
    WideVector normal = {wide_of(wide_at(&normals->x, lane)), wide_of(wide_at(&normals->y, lane)),
                         wide_of(wide_at(&normals->z, lane))};
    return plane_distance(normal, vector_widen(corner_of_lane(block, 0, lane)), ray);
}

/** Takes a triangle where it comes before what was met. @param model The model. @param b Its block.
 *  @param lane Its place there. @param rays The rays. @param inside Those that pass inside of it.
 *  @param[in,out] hits What was met. */
static void triangle_take(const Model *model, size_t b, int lane, const TreeRays *rays, mask inside,
                          ModelHits *hits) {
    if (hits->planes.block != b) {
        planes_find(model, b, &hits->planes);
    }
    const Ray *ray = &rays->packet->rays[rays->vector];
    real near, *limit = &rays->limits[rays->vector];
    BoundsBlock box = slab_spread(&hits->planes.boxes, lane);
    inside &= slab_meets(ray, &box, *limit, &near);
    if (any(inside)) {
        real distance = lane_distance(&model->blocks[b], &hits->planes.normals, lane, ray);
        inside &= distance > 0;
        distance = real_max(distance, near);
        size_t slot = b * LANES + (size_t)lane;
        integer *slots = &hits->slots[rays->vector];
        mask nearer = slot_is_nearer(model, inside, distance, slot, *limit, slots);
        *limit = real_select(nearer, distance, *limit);
        *slots = integer_select(nearer, integer_of((int)slot), *slots);
    }
}

/** Which rays pass inside of which triangles of a block. */
typedef struct BlockInside {
    unsigned triangles;   /**< Bit i set: some ray passes inside of triangle i. */
    uint16_t rays[LANES]; /**< For each triangle: bit i set: ray i does. */
} BlockInside;

/** @return Which rays pass inside of the triangles of a block. @param block The block. @param ray
 *  The rays. @param axis The axis that they run mainly along. @param active Those that count. */
INLINE BlockInside block_inside(const TriangleBlock *block, const Ray *ray, int axis, mask active) {
    BlockInside inside = {0};
    Shear shear = shear_of(ray, axis);
    for (int lane = 0; lane < LANES; lane++) {
        /* What repeats only fills the block up. */
        if (lane > 0 && block->triangles[lane] == block->triangles[lane - 1]) {
            break;
        }
        Offset offsets[3];
        for (int i = 0; i < 3; i++) {
            offsets[i] = shear_offset(shear_turn(corner_of_lane(block, i, lane), axis), &shear);
        }
        inside.rays[lane] = (uint16_t)mask_bits(active & shear_surrounds(offsets, 3));
        inside.triangles |= (unsigned)(inside.rays[lane] != 0) << lane;
    }
    return inside;
}

/** Asks the triangles of a block, one by one, about the rays that run mainly along one axis.
 *  @param model The model. @param b The block. @param rays The rays. @param axis The axis.
 *  @param active The lanes. @param[in,out] hits What was met. */
INLINE void block_ask_along(const Model *model, size_t b, const TreeRays *rays, int axis,
                            mask active, ModelHits *hits) {
    const Ray *ray = &rays->packet->rays[rays->vector];
    BlockInside inside = block_inside(&model->blocks[b], ray, axis, active);
    for (unsigned left = inside.triangles; left; left &= left - 1) {
        int lane = __builtin_ctz(left);
        triangle_take(model, b, lane, rays, mask_of_bits(inside.rays[lane]), hits);
    }
}

/** Asks the triangles of a leaf, one by one, about rays. @param model The model. @param leaf The
 *  leaf. @param rays The rays. @param[in,out] hits What was met. */
static void leaf_ask_all(const Model *model, TreeLeaf leaf, const TreeRays *rays, ModelHits *hits) {
    MainAxes along = shear_main_axes(&rays->packet->rays[rays->vector], mask_of_bits(rays->lanes));
    bool any_x = any(along.x), any_y = any(along.y), any_z = any(along.z);
    for (size_t b = leaf.first; b < leaf.first + leaf.count; b++) {
        if (any_x) {
            block_ask_along(model, b, rays, 0, along.x, hits);
        }
        if (any_y) {
            block_ask_along(model, b, rays, 1, along.y, hits);
        }
        if (any_z) {
            block_ask_along(model, b, rays, 2, along.z, hits);
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

/** @return The triangles of a block that a ray passes inside of, within their boxes. @param block
 *  The block. @param ray The ray, in all lanes. @param limit How far it looks. @param[out] near It
 *  meets each no nearer than this. */
INLINE unsigned block_meets(const TriangleBlock *block, const Ray *ray, scalar limit, real *near) {
    Corners corners = block_corners(block);
    MainAxes along = shear_main_axes(ray, mask_of(true));
    mask inside = mask_lane(along.x, 0)   ? corners_surround(&corners, ray, 0)
                  : mask_lane(along.y, 0) ? corners_surround(&corners, ray, 1)
                                          : corners_surround(&corners, ray, 2);
    if (any(inside)) {
        BoundsBlock boxes = corners_boxes(&corners);
        inside &= slab_meets(ray, &boxes, real_of(limit), near);
    }
    return mask_bits(inside);
}

/** @return A lane of vectors, exactly. @param v The vectors. @param lane Which. */
INLINE WidePoint lane_widen(const Vector *v, int lane) {
    return (WidePoint){(wide_scalar)real_at(&v->x, lane), (wide_scalar)real_at(&v->y, lane),
                       (wide_scalar)real_at(&v->z, lane)};
}

/** @return How far away one ray crosses the plane of one triangle: #lane_distance for one.
 *  @param block The triangle's block. @param lane Which of it. @param rays The rays.
 *  @param r Which of them. */
INLINE scalar one_distance(const TriangleBlock *block, int lane, const Ray *rays, int r) {
    WidePoint a = lane_widen(&block->corners[0], lane);
    WidePoint u = wide_point_subtract(lane_widen(&block->corners[1], lane), a);
    WidePoint v = wide_point_subtract(lane_widen(&block->corners[2], lane), a);
    WidePoint normal = wide_point_cross(u, v);
    WidePoint to_corner = wide_point_subtract(a, lane_widen(&rays->origin, r));
    return (scalar)(wide_point_dot(normal, to_corner) /
                    wide_point_dot(normal, lane_widen(&rays->direction, r)));
}

/** What one ray has met. */
typedef struct Nearest {
    scalar distance; /**< How far away. */
    int slot;        /**< Which triangle; -1: none. */
} Nearest;

/** Takes a triangle where it comes before what was met. @param model The model. @param slot The
 *  triangle. @param distance How far away it is met. @param[in,out] best What was met. */
INLINE void one_take(const Model *model, int slot, scalar distance, Nearest *best) {
    uint32_t triangle = model->blocks[slot / LANES].triangles[slot % LANES];
    bool is_first = best->slot < 0 ||
                    triangle < model->blocks[best->slot / LANES].triangles[best->slot % LANES];
    if (distance < best->distance || (distance == best->distance && is_first)) {
        *best = (Nearest){distance, slot};
    }
}

/** Takes the nearest of some triangles of a block. @param model The model. @param b The block.
 *  @param inside Which of its triangles are met. @param near No nearer than this. @param rays The
 *  rays. @param r Which of them. @param[in,out] best What was met. */
INLINE void block_take(const Model *model, size_t b, unsigned inside, const real *near,
                       const Ray *rays, int r, Nearest *best) {
    for (; inside; inside &= inside - 1) {
        int lane = __builtin_ctz(inside);
        scalar distance = one_distance(&model->blocks[b], lane, rays, r);
        scalar nearest = real_at(near, lane);
        if (distance > 0) {
            distance = distance > nearest ? distance : nearest;
            one_take(model, (int)(b * LANES) + lane, distance, best);
        }
    }
}

/** Asks the triangles of a leaf, side by side, about one ray. @param model The model. @param leaf
 *  The leaf. @param rays The rays. @param lane Which of them. @param[in,out] hits What was met. */
static void leaf_ask_one(const Model *model, TreeLeaf leaf, const TreeRays *rays, int lane,
                         ModelHits *hits) {
    const Ray *vector = &rays->packet->rays[rays->vector];
    real *limits = &rays->limits[rays->vector];
    integer *slots = &hits->slots[rays->vector];
    Ray ray = ray_spread(vector, lane);
    Nearest best = {real_at(limits, lane), integer_at(slots, lane)};
    for (size_t b = leaf.first; b < leaf.first + leaf.count; b++) {
        real near = real_of(0);
        unsigned inside = block_meets(&model->blocks[b], &ray, best.distance, &near);
        block_take(model, b, inside, &near, vector, lane, &best);
    }
    real_set_lane(limits, lane, best.distance);
    integer_set_lane(slots, lane, best.slot);
}

/* --- leaves ---------------------------------------------------------------------------------- */

/** @return Whether a leaf is asked ray by ray, all its triangles at once, rather than triangle by
 *  triangle, all rays at once: whichever is less work. @param lanes How many rays. */
INLINE bool leaf_is_for_one(int lanes) {
    /** Rays a block for which the two are about as quick (measured): blocks are not always full. */
    const int even = 3 * LANES / 8;
    return lanes <= even || LANES == 1;
}

/** Asks a leaf about rays. See #TreeOwner.ask. @param items The model. @param leaf The leaf.
 *  @param rays The rays. @param[in,out] found A #ModelHits. */
static void model_ask(const void *items, TreeLeaf leaf, const TreeRays *rays, void *found) {
    if (leaf_is_for_one(__builtin_popcount(rays->lanes))) {
        for (unsigned left = rays->lanes; left; left &= left - 1) {
            leaf_ask_one(items, leaf, rays, __builtin_ctz(left), found);
        }
    } else {
        leaf_ask_all(items, leaf, rays, found);
    }
}

/** Asks a leaf about shadow rays: those that meet anything look no further. See #TreeOwner.ask.
 *  @param items The model. @param leaf The leaf. @param rays The rays. @param[in,out] found A
 *  #ModelHits. */
static void model_ask_shadow(const void *items, TreeLeaf leaf, const TreeRays *rays, void *found) {
    model_ask(items, leaf, rays, found);
    real *limits = &rays->limits[rays->vector];
    const real *ends = &rays->packet->limit[rays->vector];
    for (unsigned left = rays->lanes; left; left &= left - 1) {
        int lane = __builtin_ctz(left);
        if (real_at(limits, lane) < real_at(ends, lane)) {
            real_set_lane(limits, lane, -1);
        }
    }
}

/* --- all of it ------------------------------------------------------------------------------- */

/** Begins what the rays of a packet have met. @param[out] hits Nothing yet. */
static void model_hits_clear(ModelHits *hits) {
    hits->planes.block = NO_BLOCK;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        hits->slots[v] = integer_of(-1);
    }
}

void model_nearest(const Model *model, const Packet *packet, int place, Hit *hits) {
    const TreeOwner owner = {.items = model,
                             .blocks = model->blocks,
                             .block_bytes = sizeof *model->blocks,
                             .ask = model_ask};
    real limits[PACKET_VECTORS];
    ModelHits found;
    model_hits_clear(&found);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        limits[v] = hits[v].distance;
    }
    tree_visit(&model->tree, packet, limits, &owner, &found);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask met = packet->active[v] & (found.slots[v] >= integer_of(0));
        mask nearer = hit_is_nearer(&hits[v], met, limits[v], place);
        if (any(nearer)) {
            Hit hit = hit_nothing(limits[v]);
            hit.shape = integer_of(place);
            if (packet->wants_points) {
                hit = model_hit(model, &packet->rays[v], limits[v], found.slots[v], nearer, place);
            }
            hit_take(&hits[v], nearer, &hit);
            hits[v].part = integer_select(nearer, hit.part, hits[v].part);
        }
    }
}

void model_blocked(const Model *model, const Packet *packet, mask *blocked) {
    const TreeOwner owner = {.items = model,
                             .blocks = model->blocks,
                             .block_bytes = sizeof *model->blocks,
                             .ask = model_ask_shadow};
    real limits[PACKET_VECTORS];
    ModelHits found;
    model_hits_clear(&found);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        limits[v] = real_select(blocked[v], real_of(-1), packet->limit[v]);
    }
    tree_visit(&model->tree, packet, limits, &owner, &found);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        // A way may end before it begins: what is met says more than where it ends.
        blocked[v] |= packet->active[v] & (found.slots[v] >= integer_of(0)) & (limits[v] < 0);
    }
}
