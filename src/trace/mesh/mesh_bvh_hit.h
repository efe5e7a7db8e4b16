/**
 * @file
 * @brief Where rays meet the triangles of a model.
 */
#ifndef DIOPTRE_TRACE_MESH_MESH_BVH_HIT_H
#define DIOPTRE_TRACE_MESH_MESH_BVH_HIT_H

#include "trace/mesh/mesh_bvh.h"

/**
 * @return Where rays meet the triangles that they met: the point of the ray, put back on the plane,
 *         with the triangle's own normal or the one between its corners'.
 * @param slots  Which triangles, by their places in the model's blocks.
 * @param met  The lanes that met any.
 * @param shape_index  The shape's place in the scene.
 */
Hit mesh_bvh_hit(const MeshBvh *mesh_bvh, const Ray *ray, real distance, integer slots, mask met,
                 int shape_index);

#endif
