/**
 * @file
 * @brief Surfaces that lie nearer together than float can tell: z-fighting.
 *
 * Two surfaces are apart if the distances at which a ray meets them differ by more than their
 * roundings. For a gap g between parallel planes and an eye at height h above them, distances
 * differ by g / h of themselves, at any angle. A float is exact to 2^-24 of itself. A gap of a few
 * h / 2^24 therefore shows the wrong surface in some pixels.
 *
 * Only numbers of the scene are compared, no ray is traced. What is compared: flat faces of all
 * shapes and lights with one another, meshes with the faces of other shapes, spheres and
 * ellipsoids, and the sides of cylinders and cones. What is not: the triangles of two meshes, and
 * distance fields.
 */
#ifndef DIOPTRE_RENDER_Z_FIGHTING_Z_FIGHTING_H
#define DIOPTRE_RENDER_Z_FIGHTING_Z_FIGHTING_H

#include "dioptre/scene.h"

/** Fraction of a picture from which on it is said that surfaces coincide. */
#define Z_FIGHTING_COINCIDENT_SAID 1e-4

/** Largest number of pairs of bounding boxes that are compared, about 5 ms. */
enum { Z_FIGHTING_PAIRS_MAXIMUM = 1 << 20 };

/** Surfaces of a scene that float, or nothing, can tell apart. */
typedef struct ZFighting {
    double fraction;   /**< Fraction of the pixels that float may give to the wrong one of two
                            surfaces, such as a disk just above a floor. */
    double coincident; /**< Fraction of the pixels that show opaque faces that coincide exactly and
                            look different. No engine can tell them apart, and #fraction does not
                            count them. */
    int lines[2]; /**< Lines in the scene file of the two that cover the most; 0: unknown, or in
                       an included file. */
    long pairs;   /**< Pairs of bounding boxes that were compared; #Z_FIGHTING_PAIRS_MAXIMUM: later
                       pairs were not seen. */
} ZFighting;

/** @return What is found in a scene. For n shapes the time is that of n log n boxes, which are
 *          sorted, and of a limited number of comparisons: of boxes, of shapes and of vertices of
 *          meshes. Surfaces beyond a limit are not seen. */
ZFighting z_fighting_of(const Scene *scene);

#endif
