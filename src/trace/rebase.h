/**
 * @file
 * @brief Where in the scene the coordinates of a tracer begin.
 *
 * A float is exact to 1 / 2^24 of itself. A scene of size 1 that stands 10,000 from zero has its
 * places off by a thousandth, and no method can put that right. The scene file says them in double,
 * which is enough: so a tracer counts from the middle of the shapes when that is far away. All
 * places, those of camera and lamps too, are taken from there in double before they are rounded;
 * places in answers are put back. In all but this, such a scene is as one that stands at zero.
 */
#ifndef DIOPTRE_TRACE_REBASE_H
#define DIOPTRE_TRACE_REBASE_H

#include "trace/bvh/shape_set.h"

/** Finds a box that holds all shapes of a list that have an end. @param[out] high Its highest;
 *  lower than the lowest where no shape has an end. */
void rebase_bounds(const ShapeSet *list, Vec3d *low, Vec3d *high);

/** @return How far the origin should be moved: to the middle of the shapes, if they are much
 *  farther away than large; else nowhere. */
Vec3d rebase_offset(const ShapeSet *list);

#endif
