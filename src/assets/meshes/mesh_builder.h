/**
 * @file
 * @brief Makes a mesh of triangles that come one by one, and puts right what can be.
 */
#ifndef DIOPTRE_ASSETS_MESHES_MESH_BUILDER_H
#define DIOPTRE_ASSETS_MESHES_MESH_BUILDER_H

#include "assets/meshes/mesh_plugin.h"
#include "assets/meshes/vertex_welder.h"
#include "dioptre/mesh.h"

/** A mesh while it is made. Starts as #mesh_builder_init leaves it. */
typedef struct MeshBuilder {
    VertexWelder positions;         /**< Places in space. */
    VertexWelder normals;           /**< Unit normals. */
    VertexWelder uvs;               /**< Places on a picture. */
    size_t count;                   /**< How many triangles. */
    size_t capacity;                /**< How many fit. */
    MeshTriangle *triangles;        /**< Places in #positions. */
    MeshTriangle *triangle_normals; /**< Places in #normals, or #VERTEX_WELDER_NONE. */
    MeshTriangle *triangle_uvs;     /**< Places in #uvs, or #VERTEX_WELDER_NONE. */
    bool has_normals;               /**< Whether any corner came with a normal, good or not. */
    bool has_uvs;                   /**< Whether any came with a (u, v). */
    MeshRepairs repairs;            /**< What was put right. */
    Error *error;                   /**< Where it is said what is wrong. */
} MeshBuilder;

/**
 * Makes an empty builder.
 * @param[out] builder  The builder; give it back with #mesh_builder_deinit.
 * @param error         Where it is said what is wrong, all its life.
 */
void mesh_builder_init(MeshBuilder *builder, Error *error);

/** Adds a triangle, unless it has no area. Corners at the very same place become one. @return false
 *  without memory, or if a coordinate is not finite or too large. */
bool mesh_builder_add(void *context, const MeshCorner corners[3]);

/**
 * Ends the making of a mesh: it is known what it needs.
 * @param[in,out] builder  The builder, all triangles added.
 * @param[out] counts      How many of everything, and what was put right.
 * @return false if there is no triangle, or without memory.
 */
bool mesh_builder_finish(MeshBuilder *builder, Mesh *counts);

/** Copies what was made. @param[out] mesh Where to; laid out for the counts of
 *  #mesh_builder_finish. */
void mesh_builder_copy(const MeshBuilder *builder, Mesh *mesh);

/** Gives a builder's memory back. */
void mesh_builder_deinit(MeshBuilder *builder);

#endif
