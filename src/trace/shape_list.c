/**
 * @file
 * @brief Making the shapes of a scene, and the tree over them where there are many.
 */
#include "trace/shape_list.h"
#include "trace/model.h"

#include <stdlib.h>
#include <string.h>

/**
 * Shapes with an end from which on a tree over them pays, measured with `f32x8`
 * (doc/tree-pays.svg). Rays that stay together are quick to ask about a list, eight boxes at a
 * time: by a list, a picture of 128 spheres takes 0.95 times as long as with a tree, one of
 * 192 1.04 times, one of 256 1.10.
 */
enum { TREE_SHAPES = 192 };

/**
 * The same where shapes mirror, so that rays go all ways: by a list, a picture of 20 mirroring
 * spheres takes 0.97 times as long as with a tree, one of 24 1.03 times, one of 256 3.8 times.
 */
enum { TREE_SHAPES_MIRRORED = 24 };

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
        real_set_lane(&block->planes[axis], i, box.low[axis]);
        real_set_lane(&block->planes[axis + 3], i, box.high[axis]);
    }
}

/** Makes the shapes of a list whose memory is there. @param list The list. @param scene The scene.
 *  @param models The scene's models. @param[out] error What is wrong. @return false without memory.
 */
static bool shapes_make(ShapeList *list, const Scene *scene, Models *models, Error *error) {
    char *next = list->memory;
    for (size_t i = 0; i < scene->shape_count; i++) {
        Shape *shape = shape_make(next, &scene->shapes[i], (int)i, models, error);
        if (!shape) {
            return false;
        }
        list->shapes[i] = shape;
        next += shape_size(&scene->shapes[i]);
    }
    return true;
}

/** @return Memory for shapes or boxes, zero; NULL without. @param size Bytes. */
static void *shapes_allocate(size_t size) {
    size_t whole = (size + SHAPE_ALIGNMENT - 1) / SHAPE_ALIGNMENT * SHAPE_ALIGNMENT;
    void *memory = aligned_alloc(SHAPE_ALIGNMENT, whole + SHAPE_ALIGNMENT);
    return memory ? memset(memory, 0, whole) : NULL;
}

/** @return Whether a box ends. @param box The box. */
static bool bounds_end(const Bounds *box) {
    bool ends = true;
    for (int axis = 0; axis < 3; axis++) {
        ends = ends && box->low[axis] > -INFINITE && box->high[axis] < INFINITE;
    }
    return ends;
}

/** @return Whether a list has so many shapes with a tree of their own that they, too, go into its
 *          tree. Else a packet asks each of them at once. @param list The list, its shapes made. */
static bool forests_are_planted(const ShapeList *list) {
    /** Boxes that one test tells apart, in the wider engines. */
    const size_t few = 8;
    size_t count = 0;
    for (size_t i = 0; i < list->count; i++) {
        count += list->shapes[i]->class->nearest != NULL;
    }
    return count > few;
}

/** @return Whether a shape would go into a tree. @param shape The shape. @param forests Whether
 *  those with a tree of their own would. */
static bool shape_is_planted(const Shape *shape, bool forests) {
    Bounds box = shape->class->bounds(shape);
    return bounds_end(&box) && (forests || !shape->class->nearest);
}

/** @return How many shapes of a list would go into a tree. @param list The list, its shapes made.
 */
static size_t shapes_to_plant(const ShapeList *list) {
    size_t count = 0;
    for (size_t i = 0; i < list->count; i++) {
        count += shape_is_planted(list->shapes[i], list->plants_forests);
    }
    return count;
}

/** @return Shapes with an end from which on they get a tree. @param scene The scene.
 *  @param settings What is asked for. */
static size_t tree_shapes(const Scene *scene, const TraceSettings *settings) {
    if (settings->tree != TREE_AUTO) {
        return settings->tree == TREE_ALWAYS ? 1 : SIZE_MAX;
    }
    bool is_mirrored = settings->depth > 0 && (scene_has_mirrors(scene) || scene_has_glass(scene));
    return is_mirrored ? TREE_SHAPES_MIRRORED : TREE_SHAPES;
}

/** What goes into a tree. */
typedef struct Planting {
    Bounds *boxes;    /**< The boxes of its shapes; owned. */
    uint32_t *places; /**< Their places in the list; owned. */
    size_t count;     /**< How many. */
} Planting;

/** Sorts the shapes of a list into those of its tree and loose ones. @param list The list, with
 * room for all of them as loose ones. @param[in,out] planting What goes into the tree; NULL
 * without. */
static void shapes_sort(ShapeList *list, Planting *planting) {
    for (size_t i = 0; i < list->count; i++) {
        Bounds box = list->shapes[i]->class->bounds(list->shapes[i]);
        if (planting && shape_is_planted(list->shapes[i], list->plants_forests)) {
            planting->boxes[planting->count] = box;
            planting->places[planting->count++] = (uint32_t)i;
        } else {
            size_t at = list->loose_count++;
            bounds_place(&list->bounds[at / LANES], (int)(at % LANES), box);
            list->loose[at] = list->shapes[i];
        }
    }
}

/** Plants a tree over the shapes that end. @param list The list, its shapes made. @param crew Who
 *  builds it. @return false without memory. */
static bool shapes_plant(ShapeList *list, const Crew *crew) {
    Planting planting = {.boxes = malloc(list->count * sizeof *planting.boxes),
                         .places = malloc(list->count * sizeof *planting.places)};
    bool is_planted = planting.boxes && planting.places;
    if (is_planted) {
        shapes_sort(list, &planting);
        is_planted = tree_build(&list->tree, planting.boxes, planting.count, 1, crew);
        for (size_t i = 0; is_planted && i < list->tree.block_count; i++) {
            list->tree.order[i] = planting.places[list->tree.order[i]];
        }
    }
    free(planting.boxes);
    free(planting.places);
    return is_planted;
}

/** Makes room for the shapes of a list. @param list The list. @param count How many at most.
 *  @return false without memory. */
static bool shapes_make_room(ShapeList *list, size_t count) {
    list->shapes = calloc(count + 1, sizeof *list->shapes);
    list->loose = calloc(count + 1, sizeof *list->loose);
    list->bounds = shapes_allocate(bounds_blocks(count) * sizeof *list->bounds);
    return list->shapes && list->loose && list->bounds;
}

/** Plants a tree over the shapes of a list where it pays. @param list The list, its shapes made.
 *  @param settings What is asked for. @return false without memory. */
static bool shapes_arrange(ShapeList *list, const TraceSettings *settings) {
    list->plants_forests = settings->tree == TREE_ALWAYS || forests_are_planted(list);
    if (shapes_to_plant(list) >= list->tree_from) {
        return shapes_plant(list, &settings->crew);
    }
    shapes_sort(list, NULL);
    return true;
}

bool shape_list_init(ShapeList *list, const Scene *scene, Models *models,
                     const TraceSettings *settings, Error *error) {
    size_t count = scene->shape_count;
    *list = (ShapeList){.count = count, .tree_from = tree_shapes(scene, settings)};
    list->memory = shapes_allocate(shapes_size(scene));
    if (!list->memory || !shapes_make_room(list, count) ||
        !shapes_make(list, scene, models, error) || !shapes_arrange(list, settings)) {
        shape_list_release(list);
        return error_set(error, STATUS_FAILED, "no memory for %zu shapes", count);
    }
    return true;
}

bool shape_list_choose(ShapeList *part, const ShapeList *all, ShapeChoice choice,
                       const void *context, const TraceSettings *settings) {
    *part = (ShapeList){.tree_from = all->tree_from};
    bool is_made = shapes_make_room(part, all->count);
    for (size_t i = 0; is_made && i < all->count; i++) {
        if (choice(all->shapes[i], context)) {
            part->shapes[part->count++] = all->shapes[i];
        }
    }
    if (!is_made || !shapes_arrange(part, settings)) {
        shape_list_release(part);
        return false;
    }
    return true;
}

void shape_list_release(ShapeList *list) {
    free(list->memory);
    free(list->shapes);
    free(list->loose);
    free(list->bounds);
    tree_release(&list->tree);
    *list = (ShapeList){0};
}
