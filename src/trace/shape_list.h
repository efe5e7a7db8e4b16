/**
 * @file
 * @brief The shapes of a scene, as a list: what a packet of rays meets first, and what blocks it.
 */
#ifndef DIOPTRE_TRACE_SHAPE_LIST_H
#define DIOPTRE_TRACE_SHAPE_LIST_H

#include "trace/tree.h"

/** All shapes of a scene. */
typedef struct ShapeList {
    Shape **shapes;      /**< The shapes, in the scene's order; owned, but what they point to only
                              as far as it lies in #memory. */
    void *memory;        /**< What the shapes lie in, in one piece; owned. NULL: they are those of
                              another list. */
    size_t count;        /**< How many. */
    Shape **loose;       /**< Those that are not in the tree; owned. */
    BoundsBlock *bounds; /**< The boxes of those, LANES a block; owned. */
    size_t loose_count;  /**< How many. */
    size_t tree_from;    /**< Shapes with an end from which on they get a tree. */
    bool plants_forests; /**< Whether those with a tree of their own go into it, too. */
    Tree tree; /**< The tree over the others, by place; without nodes where there are few. */
} ShapeList;

/** @return Blocks of boxes for a number of shapes. @param count The shapes. */
static inline size_t bounds_blocks(size_t count) {
    return (count + LANES - 1) / LANES;
}

/**
 * Makes the shapes of a scene.
 * @param[out] list   The list; give it back with #shape_list_release.
 * @param scene       The scene.
 * @param models      The scene's models.
 * @param settings    Whether there is a tree, and who builds it.
 * @param[out] error  What is wrong.
 * @return false without memory; the list is then empty.
 */
bool shape_list_init(ShapeList *list, const Scene *scene, Models *models,
                     const TraceSettings *settings, Error *error);

/** @return Whether a shape is chosen. @param shape The shape. @param context Of whoever chooses. */
typedef bool (*ShapeChoice)(const Shape *shape, const void *context);

/**
 * Makes a list of some shapes of another list, which must live longer.
 * @param[out] part  The list; give it back with #shape_list_release.
 * @param all        The other list.
 * @param choice     Asked about each of its shapes.
 * @param context    Handed to it.
 * @param settings   Whether there is a tree, and who builds it.
 * @return false without memory; the list is then empty.
 */
bool shape_list_choose(ShapeList *part, const ShapeList *all, ShapeChoice choice,
                       const void *context, const TraceSettings *settings);

/** Gives the shapes back. @param list The list. */
void shape_list_release(ShapeList *list);

/**
 * Finds what the rays of a packet meet first.
 * @param list    The shapes.
 * @param packet  The rays, at least one active.
 * @param[out] hits  One for each vector of rays.
 * @callgraph
 */
void shape_list_nearest(const ShapeList *list, const Packet *packet, Hit *hits);

/**
 * Finds which rays of a packet are blocked before their limit.
 * @param list    The shapes.
 * @param packet  The rays, at least one active.
 * @param[out] blocked  One mask for each vector of rays.
 */
void shape_list_blocked(const ShapeList *list, const Packet *packet, mask *blocked);

/**
 * Asked about each shape that rays may meet.
 * @param shape   The shape.
 * @param packet  The rays.
 * @param v       Which vector of them.
 * @param active  Which lanes.
 * @param[in,out] found  What the visitor keeps.
 */
typedef void (*ShapeVisitor)(const Shape *shape, const Packet *packet, int v, mask active,
                             void *found);

/**
 * Visits all shapes that rays of a packet may meet before their limit, in no order.
 * @param list    The shapes.
 * @param packet  The rays, at least one active.
 * @param visitor  Asked about each.
 * @param[in,out] found  Handed to the visitor.
 */
void shape_list_visit(const ShapeList *list, const Packet *packet, ShapeVisitor visitor,
                      void *found);

#endif
