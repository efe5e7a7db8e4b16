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
 * shapes with one another, meshes with the faces of other shapes, spheres with spheres, and
 * cylinders with cylinders. What is not: the triangles of two meshes, the sides of cones,
 * ellipsoids, and distance fields.
 */
#ifndef DIOPTRE_RENDER_Z_FIGHTING_H
#define DIOPTRE_RENDER_Z_FIGHTING_H

#include "dioptre/scene.h"

/**
 * @return The fraction of a scene's pixels that float may give to the wrong one of two surfaces,
 *         such as a disk just above a floor. Surfaces that coincide exactly do not count: double
 *         cannot tell them apart either. The time is proportional to the number of shapes, and to
 *         that of the vertices of meshes that touch a flat face.
 * @param scene   The scene.
 * @param origin  Its #scene_local_origin, to which coordinates are relative.
 */
double z_fighting_fraction(const Scene *scene, Vec3d origin);

#endif
