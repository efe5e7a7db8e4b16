/**
 * @file
 * @brief Triangulation of polygons, convex or not.
 */
#ifndef DIOPTRE_ASSETS_MESHES_TRIANGULATE_H
#define DIOPTRE_ASSETS_MESHES_TRIANGULATE_H

#include "base/vec3d.h"

#include <stddef.h>
#include <stdint.h>

/**
 * Cuts a polygon into triangles of its own vertices.
 * @param vertices        The vertices in order, finite; nearly in a plane.
 * @param count           Number of vertices, at least 3.
 * @param[out] triangles  At most `count` - 2 times three indices of vertices, oriented as the
 *                        polygon.
 * @param[out] work       Memory for `count` indices.
 * @param[out] missing    Triangles that could not be cut, because edges cross each other.
 * @return Number of triangles. 0 without missing ones: the polygon has no area.
 */
size_t triangulate_polygon(const Vec3d *vertices, size_t count, uint32_t *triangles, uint32_t *work,
                           size_t *missing);

#endif
