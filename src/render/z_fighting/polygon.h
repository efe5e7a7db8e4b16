/**
 * @file
 * @brief Convex polygons that are clipped by planes (Sutherland and Hodgman).
 */
#ifndef DIOPTRE_RENDER_Z_FIGHTING_POLYGON_H
#define DIOPTRE_RENDER_Z_FIGHTING_POLYGON_H

#include "dioptre/scene.h"

/** Largest number of corners of a clipped face: 8 of its own, and one for each clip, by at most 8
 *  edges of a face, 4 of the picture and 2 sides of a gap. */
enum { CORNERS_MAXIMUM = 32 };

/** A convex polygon. */
typedef struct Polygon {
    Vec3d corners[CORNERS_MAXIMUM]; /**< Corners, in turn. */
    int count;                      /**< Number of corners; fewer than 3: empty. */
} Polygon;

/** Keeps the part of a polygon on one side of a plane: normal . p >= least. */
void polygon_clip(Polygon *polygon, Vec3d normal, double least);

/** Keeps the part of a polygon above or below a face. */
void polygon_clip_by_face(Polygon *polygon, const ShapeFace *face);

/** Keeps the part of a polygon whose height above a face is at most a bound, up or down. */
void polygon_clip_to_gap(Polygon *polygon, const ShapeFace *face, double bound);

/** @return The area of a polygon. */
double polygon_area(const Polygon *polygon);

#endif
