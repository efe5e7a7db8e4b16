/**
 * @file
 * @brief The shapes of a scene, as a list: what a packet of rays meets first, and what blocks it.
 */
#ifndef DIOPTRE_TRACE_BVH_SHAPE_SET_H
#define DIOPTRE_TRACE_BVH_SHAPE_SET_H

#include "trace/bvh/bvh.h"

/** All shapes of a scene. */
typedef struct ShapeSet {
    Shape **shapes;       /**< The shapes, in the scene's order; owned, but what they point to only
                               as far as it lies in #memory. */
    void *memory;         /**< What the shapes lie in, in one piece; owned. NULL: they are those of
                               another list. */
    size_t count;         /**< How many. */
    Shape **linear;       /**< Those that are not in the tree; owned. */
    Aabb *linear_bounds;  /**< The boxes of those, LANES a block; owned. */
    size_t linear_count;  /**< How many. */
    size_t bvh_threshold; /**< Shapes with an end from which on they get a tree. */
    bool bvh_over_instances; /**< Whether those with a tree of their own go into it, too. */
    Bvh bvh; /**< The tree over the others, by place; without nodes where there are few. */
} ShapeSet;

/** @return Blocks of boxes for a number of shapes. */
static inline size_t aabb_pack_count(size_t count) {
    return (count + LANES - 1) / LANES;
}

/**
 * Makes the shapes of a scene.
 * @param[out] set  The list; give it back with #shape_set_deinit.
 * @param settings  Whether there is a tree, and who builds it.
 * @return false without memory; the list is then empty.
 */
bool shape_set_init(ShapeSet *set, const Scene *scene, MeshBvhCache *meshes,
                    const TraceSettings *settings, Error *error);

/** @return Whether a shape is chosen. */
typedef bool (*ShapePredicate)(const Shape *shape, const void *context);

/**
 * Makes a list of some shapes of another list, which must live longer.
 * @param[out] subset  The list; give it back with #shape_set_deinit.
 * @param predicate  Asked about each of its shapes.
 * @param settings  Whether there is a tree, and who builds it.
 * @return false without memory; the list is then empty.
 */
bool shape_set_filter(ShapeSet *subset, const ShapeSet *all, ShapePredicate predicate,
                      const void *context, const TraceSettings *settings);

/** Gives the shapes back. */
void shape_set_deinit(ShapeSet *set);

/** @return The box of all bounded shapes; its lowest corner is above its highest one if there is
 *  none. */
Aabbd shape_set_bounds(const ShapeSet *set);

/**
 * Finds what the rays of a packet meet first.
 * @param packet  The rays, at least one active.
 * @param[out] hits  One for each vector of rays. @callgraph
 */
void shape_set_closest_hits(const ShapeSet *set, const Packet *packet, Hit *hits);

/**
 * Finds which rays of a packet are blocked before their limit.
 * @param packet  The rays, at least one active.
 * @param[out] occluded  One mask for each vector of rays.
 */
void shape_set_occluded(const ShapeSet *set, const Packet *packet, mask *occluded);

/** Asked about each shape that rays may meet. @param v Which vector of them. */
typedef void (*ShapeVisitor)(const Shape *shape, const Packet *packet, int v, mask active,
                             void *found);

/**
 * Visits all shapes that rays of a packet may meet before their limit, in no order.
 * @param packet  The rays, at least one active.
 * @param[in,out] found  Handed to the visitor.
 */
void shape_set_visit(const ShapeSet *set, const Packet *packet, ShapeVisitor visitor, void *found);

#endif
