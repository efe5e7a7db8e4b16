/**
 * @file
 * @brief What rays meet inside of a transparent shape, and at its wall.
 *
 * What enters glass leaves it, so many rays of such a scene are inside. A ray inside starts in the
 * bounding box of its shape, and a box is convex: what it meets before the wall has a bounding box
 * that overlaps this one. Mostly that is the shape alone. The same holds for the short segment
 * across a wall. A ray that starts or ends beside the box is tested against all shapes, so the hits
 * are the same to the bit.
 */
#ifndef DIOPTRE_TRACE_GLASS_NEIGHBOURS_H
#define DIOPTRE_TRACE_GLASS_NEIGHBOURS_H

#include "trace/glass/interior_list.h"

/** Most neighbours of a shape: to test more takes as long as the boxes of all shapes. */
enum { NEIGHBOURS_MAXIMUM = 16 };

/** A shape that rays can meet in the bounding box of another. */
typedef struct Neighbour {
    const Shape *shape; /**< The shape. */
    Aabbs box;          /**< Its bounding box; infinite if it exceeds that. */
} Neighbour;

/** What rays can meet in the bounding box of a transparent shape. */
struct Neighbours {
    const Shape *glass; /**< The transparent shape. NULL: the shape is opaque or unbounded, or has
                             too many neighbours. */
    Aabbs box;          /**< Its bounding box, with twice #slack on all sides. */
    scalar slack;       /**< Room for rounding errors and ray offsets, by which the boxes of
                             segments of rays are enlarged, scene units. */
    Neighbour others[NEIGHBOURS_MAXIMUM]; /**< The other shapes. */
    int count;                            /**< Number of #others. */
};

/** Finds the neighbours of all transparent shapes, unless there are too many shapes. @return
 * Whether memory sufficed. */
bool neighbours_init(Dielectrics *dielectrics);

/**
 * Finds the closest hits of a packet, as shape_set_closest_hits() does.
 * @param packet     The rays, at least one active.
 * @param interior   The shapes that they are inside of, per vector.
 * @param[out] hits  The hits, per vector of rays.
 */
void neighbours_closest_hits(const Dielectrics *dielectrics, const Packet *packet,
                             const InteriorList *interior, Hit *hits);

/**
 * Visits the transparent shapes that offset segments may meet, as shape_set_visit() does.
 * @param segments       The segments, at least one active.
 * @param hits           The surfaces that they cross, per vector.
 * @param[in,out] found  Last argument of the visitor.
 */
void neighbours_visit_segments(const Dielectrics *dielectrics, const Packet *segments,
                               const Hit *hits, ShapeVisitor visitor, void *found);

#endif
