/**
 * @file
 * @brief The shapes of a scene, as a list.
 */
#include "trace/shape_list.h"

#include <stdlib.h>
#include <string.h>

/** @return Bytes of all shapes of a scene. @param scene The scene. */
static size_t shapes_size(const Scene *scene) {
    size_t size = 0;
    for (size_t i = 0; i < scene->shape_count; i++) {
        size += shape_size(&scene->shapes[i]);
    }
    return size;
}

/** Puts a box into a block. @param[in,out] block The block. @param i Its lane. @param box The box.
 */
static void bounds_place(BoundsBlock *block, int i, Bounds box) {
    for (int axis = 0; axis < 3; axis++) {
        real_set_lane(&block->low[axis], i, box.low[axis]);
        real_set_lane(&block->high[axis], i, box.high[axis]);
    }
}

/** @return Blocks of boxes for a number of shapes. @param count The shapes. */
static size_t bounds_blocks(size_t count) {
    return (count + LANES - 1) / LANES;
}

/**
 * Fills a list whose memory is there.
 * @param list   The list.
 * @param scene  The scene.
 */
static void shapes_make(ShapeList *list, const Scene *scene) {
    char *next = list->memory;
    for (size_t i = 0; i < scene->shape_count; i++) {
        Shape *shape = shape_make(next, &scene->shapes[i], (int)i);
        list->shapes[i] = shape;
        bounds_place(&list->bounds[i / LANES], (int)(i % LANES), shape->class->bounds(shape));
        next += shape_size(&scene->shapes[i]);
    }
}

/** @return Memory for shapes or boxes, zero; NULL without. @param size Bytes. */
static void *shapes_allocate(size_t size) {
    size_t whole = (size + SHAPE_ALIGNMENT - 1) / SHAPE_ALIGNMENT * SHAPE_ALIGNMENT;
    void *memory = aligned_alloc(SHAPE_ALIGNMENT, whole);
    return memory ? memset(memory, 0, whole) : NULL;
}

bool shape_list_init(ShapeList *list, const Scene *scene, Error *error) {
    size_t count = scene->shape_count;
    *list = (ShapeList){.count = count};
    if (count == 0) {
        return true;
    }
    list->memory = shapes_allocate(shapes_size(scene));
    list->shapes = calloc(count, sizeof *list->shapes);
    list->bounds = shapes_allocate(bounds_blocks(count) * sizeof *list->bounds);
    if (!list->memory || !list->shapes || !list->bounds) {
        shape_list_release(list);
        return error_set(error, STATUS_FAILED, "no memory for %zu shapes", count);
    }
    shapes_make(list, scene);
    return true;
}

void shape_list_release(ShapeList *list) {
    free(list->memory);
    free(list->shapes);
    free(list->bounds);
    *list = (ShapeList){0};
}

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
    size_t left = list->count - block * LANES;
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
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask open = packet->active[v] & mask_not(blocked[v]);
        if (any(open)) {
            blocked[v] |=
                shape->class->is_blocking(shape, &packet->rays[v], open, packet->limit[v]);
        }
    }
}

void shape_list_nearest(const ShapeList *list, const Packet *packet, Hit *hits) {
    Spans spans = {0};
    if (LANES > 1) {
        spans = packet_spans(packet);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        hits[v] = hit_nothing(packet->limit[v]);
    }
    for (size_t block = 0; block < bounds_blocks(list->count); block++) {
        Candidates candidates = block_candidates(list, &spans, block);
        while (candidates.left) {
            int lane = candidates_take(&candidates);
            const Shape *shape = list->shapes[block * LANES + (size_t)lane];
            shape_nearest(shape, real_lane(candidates.near, lane), packet, hits);
        }
    }
}

void shape_list_blocked(const ShapeList *list, const Packet *packet, mask *blocked) {
    Spans spans = {0};
    if (LANES > 1) {
        spans = packet_spans(packet);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        blocked[v] = mask_of(false);
    }
    for (size_t block = 0; block < bounds_blocks(list->count); block++) {
        unsigned left = block_candidates(list, &spans, block).left;
        for (; left; left &= left - 1) {
            size_t place = block * LANES + (size_t)__builtin_ctz(left);
            shape_blocked(list->shapes[place], packet, blocked);
        }
    }
}
