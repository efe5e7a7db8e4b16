/**
 * @file
 * @brief Meshes: triangles with shared vertices.
 */
#ifndef DIOPTRE_MESH_H
#define DIOPTRE_MESH_H

#include "base/error.h"
#include "base/vec3d.h"

#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>

/** Texture coordinates. */
typedef struct MeshUv {
    double u; /**< To the right, in widths of the picture. */
    double v; /**< Up, in heights of the picture. */
} MeshUv;

/** Three indices in an array, one per vertex; counter-clockwise seen from outside. */
typedef struct MeshTriangle {
    uint32_t index[3]; /**< The indices. */
} MeshTriangle;

/** Defects of a mesh file that were repaired. */
typedef struct MeshRepairs {
    size_t degenerate_triangles;    /**< Triangles without area: removed. */
    size_t untriangulated_polygons; /**< Missing triangles of polygons that cannot be
                                       triangulated. */
    size_t missing_normals; /**< Vertices whose normal is missing, while others have one, or has no
                              direction: they got the normal of their triangle. */
    size_t missing_uvs; /**< Vertices without valid (u, v), while others have one: they got (0, 0).
                         */
    size_t skipped_statements; /**< Statements of an OBJ file that are not understood: left out. */
    size_t skipped_line;       /**< Line of the first of those, from 1; 0: there is none. */
} MeshRepairs;

/** A mesh: one block of memory with all its arrays, shared with child processes. */
typedef struct Mesh {
    size_t position_count;          /**< Number of positions, at least 3. */
    Vec3d *positions;               /**< Positions, scene units, no two the same. */
    Aabbd bounds;                   /**< Bounding box; set by #mesh_update_bounds. */
    size_t normal_count;            /**< Number of normals; 0: the file has none. */
    Vec3d *normals;                 /**< The file's, of unit length. */
    size_t uv_count;                /**< Number of (u, v); 0: the file has none. */
    MeshUv *uvs;                    /**< The file's. */
    size_t triangle_count;          /**< Number of triangles, at least 1. */
    MeshTriangle *triangles;        /**< Indices in #positions. */
    MeshTriangle *triangle_normals; /**< Indices in #normals; NULL without normals. */
    MeshTriangle *triangle_uvs;     /**< Indices in #uvs; NULL without (u, v). */
    MeshRepairs repairs;            /**< Repaired defects. */
    atomic_uint reference_count;    /**< Number of references. */
} Mesh;

/** Progress of reading a mesh file. */
typedef struct MeshProgress {
    /**
     * Called before the start, and about five times per second.
     * @param context  #MeshProgress.context.
     * @param name     The file, without its folder.
     * @param share    Completed fraction, 0 to 1.
     * @param seconds  Seconds since the start.
     */
    void (*report)(void *context, const char *name, double share, double seconds);
    /** Called at the end. @param context #MeshProgress.context. */
    void (*end)(void *context);
    void *context; /**< First argument of both. */
} MeshProgress;

/**
 * Creates a mesh with one reference, all its numbers zero.
 * @param counts      The numbers of all items; the rest is not read.
 * @param[out] error  What is wrong.
 * @return The mesh, to be freed with #mesh_release; NULL without memory.
 */
Mesh *mesh_create(const Mesh *counts, Error *error);

/**
 * Copies a mesh and translates the copy.
 * @param mesh        The mesh.
 * @param offset      Translation, scene units.
 * @param[out] error  What is wrong.
 * @return The copy, to be freed with #mesh_release; NULL without memory.
 */
Mesh *mesh_translated(const Mesh *mesh, Vec3d offset, Error *error);

/** Adds a reference. @param mesh The mesh, or NULL. @return The same. */
Mesh *mesh_retain(Mesh *mesh);

/** Removes a reference; the last one frees the memory. @param mesh The mesh, or NULL. */
void mesh_release(Mesh *mesh);

/**
 * @return Bytes of the block of a mesh.
 * @param counts  The numbers of all items, each at most UINT32_MAX; the rest is not read.
 */
size_t mesh_block_size(const Mesh *counts);

/**
 * Sets the pointers of the arrays, which follow the mesh in its block.
 * @param[in,out] mesh  The mesh at the start of a block of #mesh_block_size bytes, its counts set.
 */
void mesh_bind_arrays(Mesh *mesh);

/**
 * Checks every number of a mesh.
 * @param mesh        The mesh.
 * @param[out] error  What is wrong (#STATUS_SCENE).
 * @return Whether it has a triangle, all is finite and within #LENGTH_MAXIMUM, normals are of unit
 *         length, and all indices are in range.
 */
bool mesh_validate(const Mesh *mesh, Error *error);

/** Computes #Mesh.bounds, once all positions are set. @param[in,out] mesh The mesh. */
void mesh_update_bounds(Mesh *mesh);

/**
 * Computes smooth normals: at each position the mean of the normals of its triangles, weighted by
 * their angles there, which does not depend on the triangulation of flat parts.
 * @param mesh          The mesh.
 * @param[out] normals  One unit normal per position, never NaN. Where the mean vanishes, as on the
 *                      edge of a sheet folded back on itself, it is the normal of one of its
 *                      triangles; where there is none, it is up.
 */
void mesh_smooth_normals(const Mesh *mesh, Vec3d *normals);

#endif
