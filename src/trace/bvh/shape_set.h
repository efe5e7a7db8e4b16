/**
 * @file
 * @brief The shapes of a scene, in a BVH and in a list: closest hits and occlusion of packets.
 */
#ifndef DIOPTRE_TRACE_BVH_SHAPE_SET_H
#define DIOPTRE_TRACE_BVH_SHAPE_SET_H

#include "trace/bvh/aabb_pack.h"
#include "trace/bvh/bvh.h"

/** A set of shapes: if there are many bounded ones, they are in a BVH; all others are in a list. */
typedef struct ShapeSet {
    Shape **shapes;          /**< The shapes in the order of the scene; the array is owned. */
    void *memory;            /**< Memory of the shapes; owned. NULL: another set owns it. */
    size_t count;            /**< Number of #shapes. */
    Shape **linear;          /**< The shapes outside the BVH; the array is owned. */
    AabbPack *linear_bounds; /**< Their bounding boxes; owned. */
    size_t linear_count;     /**< Number of #linear. */
    size_t bvh_threshold;    /**< Number of bounded shapes from which on there is a BVH. */
    bool may_exceed_box;     /**< Whether there is a shape for which shape_exceeds_box(). */
    bool bvh_over_instances; /**< Whether the BVH contains shapes with a BVH of their own. */
    Bvh bvh;                 /**< BVH over indices in #shapes; without nodes if there is none. */
} ShapeSet;

/**
 * Creates the shapes of a scene.
 * @param[out] set  The set; the caller frees it with #shape_set_deinit.
 * @param meshes    Triangles of the meshes.
 * @param settings  Mode of the BVH, and threads.
 * @return false without memory; the set is then empty.
 */
bool shape_set_init(ShapeSet *set, const Scene *scene, MeshBvhCache *meshes,
                    const TraceSettings *settings, Error *error);

/** @return Whether a shape belongs to a subset. */
typedef bool (*ShapePredicate)(const Shape *shape, const void *context);

/**
 * Creates a subset of another set, which must live longer.
 * @param[out] subset  The subset; the caller frees it with #shape_set_deinit.
 * @param predicate    Selects the shapes.
 * @param context      Last argument of the predicate.
 * @param settings     Mode of the BVH, and threads.
 * @return false without memory; the subset is then empty.
 */
bool shape_set_filter(ShapeSet *subset, const ShapeSet *all, ShapePredicate predicate,
                      const void *context, const TraceSettings *settings);

/** Frees the memory of a set. */
void shape_set_deinit(ShapeSet *set);

/** @return The bounding box of all bounded shapes; its lowest corner is above its highest one if
 *  there is none. */
Aabbd shape_set_bounds(const ShapeSet *set);

/** @return Whether rays within intervals may meet a shape; true where a tree would have to be
 *  searched, and for engines of one lane, whose rays have no intervals. @param excluded A shape
 *  that no ray meets; NULL: there is none. */
bool shape_set_may_meet(const ShapeSet *set, const PacketIntervals *intervals,
                        const Shape *excluded);

/** The shapes that the rays of a beam may meet. */
typedef struct BeamCandidates {
    int count;            /**< Number of shapes. */
    const Shape *nearest; /**< The one whose box is nearest; NULL: there is none. */
    scalar next_distance; /**< Lower bound on the distances of all others; infinite without any. */
} BeamCandidates;

/** @return Whether shape_set_find_in_beam() can be asked: there is no BVH, and each shape lies in
 *          its box. */
static inline bool shape_set_is_list(const ShapeSet *set) {
    return LANES > 1 && !set->bvh.nodes && !set->may_exceed_box;
}

/** Finds the shapes that the rays of a beam may meet. See shape_set_is_list(). */
void shape_set_find_in_beam(const ShapeSet *set, const Beam *beam, BeamCandidates *found);

/** @return The only shape that the rays of a beam may meet; NULL: none, or several. */
static inline const Shape *beam_only_shape(const BeamCandidates *candidates) {
    return candidates->count == 1 ? candidates->nearest : NULL;
}

/** Finds the shapes that the rays of a part of a beam may meet. @param[in,out] candidates Those of
 *  the whole beam. @param part The part. */
void shape_set_narrow_candidates(const ShapeSet *set, const Beam *part, BeamCandidates *candidates);

/**
 * Finds the closest hits of a packet.
 * @param packet     The rays, at least one active.
 * @param[out] hits  The hits, per vector of rays. @callgraph
 */
void shape_set_closest_hits(const ShapeSet *set, const Packet *packet, Hit *hits);

/** Finds closer hits of a packet. @param[in,out] hits The closest so far, per vector of rays. */
void shape_set_update_hits(const ShapeSet *set, const Packet *packet, Hit *hits);

/**
 * Finds the rays of a packet that meet any shape before their limit.
 * @param packet         The rays, at least one active.
 * @param intervals      Those of the packet; NULL: not known.
 * @param excluded       A shape that no ray meets, which need not be tested; NULL: there is none.
 *                       Engines of one lane test all.
 * @param[out] occluded  The occluded rays, per vector.
 */
void shape_set_occluded(const ShapeSet *set, const Packet *packet, const PacketIntervals *intervals,
                        const Shape *excluded, mask *occluded);

/** Called for each shape that rays may meet. @param v Index of the vector of rays. */
typedef void (*ShapeVisitor)(const Shape *shape, const Packet *packet, int v, mask active,
                             void *found);

/**
 * Visits all shapes that rays of a packet may meet before their limit, in any order.
 * @param packet         The rays, at least one active.
 * @param[in,out] found  Last argument of the visitor.
 */
void shape_set_visit(const ShapeSet *set, const Packet *packet, ShapeVisitor visitor, void *found);

#endif
