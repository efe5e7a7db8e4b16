/**
 * @file
 * @brief Construction of a mesh from single triangles, with repairs.
 */
#ifndef DIOPTRE_ASSETS_MESHES_MESH_BUILDER_H
#define DIOPTRE_ASSETS_MESHES_MESH_BUILDER_H

#include "assets/meshes/mesh_plugin.h"
#include "assets/meshes/vertex_welder.h"
#include "dioptre/mesh.h"

/** A mesh under construction. */
typedef struct MeshBuilder {
    VertexWelder positions;         /**< Positions. */
    VertexWelder normals;           /**< Unit normals. */
    VertexWelder uvs;               /**< Texture coordinates. */
    size_t count;                   /**< Number of triangles. */
    size_t capacity;                /**< Capacity of the arrays of triangles. */
    MeshTriangle *triangles;        /**< Indices in #positions. */
    MeshTriangle *triangle_normals; /**< Indices in #normals, or #VERTEX_WELDER_NONE. */
    MeshTriangle *triangle_uvs;     /**< Indices in #uvs, or #VERTEX_WELDER_NONE. */
    bool has_normals;               /**< Whether any corner had a normal, valid or not. */
    bool has_uvs;                   /**< Whether any corner had (u, v), valid or not. */
    MeshRepairs repairs;            /**< Repaired defects. */
    Error *error;                   /**< What is wrong; not owned. */
} MeshBuilder;

/**
 * Initialises an empty builder.
 * @param[out] builder  The builder, to be released with #mesh_builder_deinit.
 * @param error         Receives the errors of all calls.
 */
void mesh_builder_init(MeshBuilder *builder, Error *error);

/**
 * Checks a position, which must be done before a polygon is cut.
 * @param builder   The builder, which receives the error.
 * @param position  The position.
 * @return Whether its coordinates are finite and in range.
 */
bool mesh_builder_check(const MeshBuilder *builder, const double position[3]);

/**
 * Adds a triangle, unless its area is zero. Corners at the same position share one vertex.
 * @param context  The #MeshBuilder.
 * @param corners  The corners.
 * @return false without memory, or if a coordinate is not finite or out of range.
 */
bool mesh_builder_add(void *context, const MeshCorner corners[3]);

/**
 * Completes a mesh: fills in missing normals and (u, v), and computes its sizes.
 * @param[in,out] builder  The builder, with all triangles.
 * @param[out] counts      Numbers of all items, and the repairs.
 * @return false if there is no triangle, or without memory.
 */
bool mesh_builder_finish(MeshBuilder *builder, Mesh *counts);

/**
 * Copies the result.
 * @param builder    The builder.
 * @param[out] mesh  A mesh of the sizes that #mesh_builder_finish computed, its arrays bound.
 */
void mesh_builder_copy(const MeshBuilder *builder, Mesh *mesh);

/** Releases the memory of a builder. @param builder The builder. */
void mesh_builder_deinit(MeshBuilder *builder);

#endif
