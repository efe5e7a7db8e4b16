/**
 * @file
 * @brief Makes a mesh of triangles that come one by one, and puts right what can be.
 */
#ifndef ASSETS_MESH_BUILDER_H
#define ASSETS_MESH_BUILDER_H

#include "assets/meshes_module.h"
#include "assets/pool.h"
#include "dioptre/mesh.h"

/** A mesh while it is made. Starts as #mesh_builder_init leaves it. */
typedef struct MeshBuilder {
    Pool positions;          /**< Places in space. */
    Pool normals;            /**< Unit normals. */
    Pool uvs;                /**< Places on a picture. */
    size_t count;            /**< How many triangles. */
    size_t capacity;         /**< How many fit. */
    MeshTriangle *triangles; /**< Places in #positions. */
    MeshTriangle *normal_at; /**< Places in #normals, or #POOL_NOWHERE. */
    MeshTriangle *uv_at;     /**< Places in #uvs, or #POOL_NOWHERE. */
    bool has_normals;        /**< Whether any corner came with a normal, good or not. */
    bool has_uvs;            /**< Whether any came with a (u, v). */
    MeshRepairs repairs;     /**< What was put right. */
    Error *error;            /**< Where it is said what is wrong. */
} MeshBuilder;

/**
 * Makes an empty builder.
 * @param[out] builder  The builder; give it back with #mesh_builder_release.
 * @param error         Where it is said what is wrong, all its life.
 */
void mesh_builder_init(MeshBuilder *builder, Error *error);

/**
 * Adds a triangle, unless it has no area. Corners at the very same place become one.
 * @param context  The builder.
 * @param corners  Its corners.
 * @return false without memory, or if a coordinate is not finite or too large.
 */
bool mesh_builder_add(void *context, const MeshesCorner corners[3]);

/**
 * Ends the making of a mesh: it is known what it needs.
 * @param[in,out] builder  The builder, all triangles added.
 * @param[out] counts      How many of everything, and what was put right.
 * @return false if there is no triangle, or without memory.
 */
bool mesh_builder_finish(MeshBuilder *builder, Mesh *counts);

/**
 * Copies what was made.
 * @param builder    The builder, finished.
 * @param[out] mesh  Where to; laid out for the counts of #mesh_builder_finish.
 */
void mesh_builder_copy(const MeshBuilder *builder, Mesh *mesh);

/** Gives a builder's memory back. @param builder The builder. */
void mesh_builder_release(MeshBuilder *builder);

#endif
