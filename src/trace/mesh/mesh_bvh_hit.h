/**
 * @file
 * @brief Hits on the triangles of a mesh.
 */
#ifndef DIOPTRE_TRACE_MESH_MESH_BVH_HIT_H
#define DIOPTRE_TRACE_MESH_MESH_BVH_HIT_H

#include "trace/mesh/mesh_bvh.h"

/**
 * @return Hits: the points of the rays, moved onto the planes of the triangles, with the flat or
 * the interpolated normals.
 * @param slots        Slots of the triangles in #MeshBvh.blocks.
 * @param met          The lanes with a hit.
 * @param shape_index  Index of the shape in the scene.
 */
Hit mesh_bvh_hit(const MeshBvh *mesh_bvh, const Ray *ray, real distance, integer slots, mask met,
                 int shape_index);

#endif
