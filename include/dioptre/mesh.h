/**
 * @file
 * @brief Meshes: triangles that share their corners, checked and ready to be traced.
 */
#ifndef DIOPTRE_MESH_H
#define DIOPTRE_MESH_H

#include "dioptre/error.h"
#include "dioptre/vec3d.h"

#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>

/** A place on a picture that is wrapped around a mesh. */
typedef struct MeshUv {
    double u; /**< To the right, 1 a picture's width. */
    double v; /**< Up, 1 a picture's height. */
} MeshUv;

/** Three places in an array, one a corner; counter-clockwise seen from outside. */
typedef struct MeshTriangle {
    uint32_t index[3]; /**< The places. */
} MeshTriangle;

/** What was wrong with a model file and could be put right. */
typedef struct MeshRepairs {
    size_t degenerate_triangles;    /**< Triangles without area: left out. */
    size_t untriangulated_polygons; /**< Triangles missing of polygons that cannot be cut into
                                       triangles. */
    size_t missing_normals; /**< Corners whose normal is missing, while others have one, or has no
                              direction: their triangle's normal was put there. */
    size_t missing_uvs;     /**< Corners without a (u, v) that could be used, while others have one:
                              (0, 0) was put there. Where only some corners of one part of an OBJ
                              lack theirs, the library has done so already, uncounted. */
} MeshRepairs;

/** A mesh: one block of memory, shared with child processes, with all its arrays in it. */
typedef struct Mesh {
    size_t position_count;          /**< How many positions, at least 3. */
    Vec3d *positions;               /**< Places in space, scene units, no two the same. */
    Aabbd bounds;                   /**< Bounding box; set by #mesh_update_bounds. */
    size_t normal_count;            /**< How many normals; 0: the file has none. */
    Vec3d *normals;                 /**< The file's, of unit length. */
    size_t uv_count;                /**< How many (u, v); 0: the file has none. */
    MeshUv *uvs;                    /**< The file's. */
    size_t triangle_count;          /**< How many triangles, at least 1. */
    MeshTriangle *triangles;        /**< Places in #positions. */
    MeshTriangle *triangle_normals; /**< Places in #normals; NULL without normals. */
    MeshTriangle *triangle_uvs;     /**< Places in #uvs; NULL without (u, v). */
    MeshRepairs repairs;            /**< What was put right. */
    atomic_uint reference_count;    /**< How many hold it. */
} Mesh;

/** Somebody who is told, while a model file is read, how far it is. */
typedef struct MeshProgress {
    /**
     * Is told before the start, and about five times a second.
     * @param context  #MeshProgress.context.
     * @param name     The file, without its folder.
     * @param share    How much is done, 0 to 1.
     * @param seconds  Since the start.
     */
    void (*report)(void *context, const char *name, double share, double seconds);
    /** Is told when the file is read or given up. @param context #MeshProgress.context. */
    void (*end)(void *context);
    void *context; /**< Handed to both. */
} MeshProgress;

/**
 * Makes a mesh with one owner, all its numbers zero, to be filled.
 * @param counts      How many of everything; the rest of it is not read.
 * @param[out] error  What is wrong.
 * @return The mesh, to be given back with #mesh_release; NULL without memory.
 */
Mesh *mesh_create(const Mesh *counts, Error *error);

/**
 * Copies a mesh to another place.
 * @param mesh        The mesh.
 * @param offset         How far it is moved, scene units.
 * @param[out] error  What is wrong.
 * @return The copy, to be given back with #mesh_release; NULL without memory.
 */
Mesh *mesh_translated(const Mesh *mesh, Vec3d offset, Error *error);

/** Becomes one more owner. @param mesh The mesh, or NULL. @return The same. */
Mesh *mesh_retain(Mesh *mesh);

/** Gives a mesh back; the last owner's call gives its memory back. @param mesh It, or NULL. */
void mesh_release(Mesh *mesh);

/**
 * @return Bytes of the block that a mesh lies in.
 * @param counts  The mesh; only its counts are read, each at most UINT32_MAX.
 */
size_t mesh_block_size(const Mesh *counts);

/**
 * Points the arrays of a mesh to their places in its block, right behind it.
 * @param[in,out] mesh  The mesh, at the head of a block of #mesh_block_size bytes, its counts set.
 */
void mesh_bind_arrays(Mesh *mesh);

/**
 * Looks at every number of a mesh.
 * @param mesh        The mesh.
 * @param[out] error  What is wrong (#STATUS_SCENE).
 * @return Whether it has a triangle, all is finite and within #LENGTH_MAXIMUM, normals are of unit
 *         length, and every place is one.
 */
bool mesh_validate(const Mesh *mesh, Error *error);

/** Computes #Mesh.bounds, once all positions are set. @param[in,out] mesh The mesh. */
void mesh_update_bounds(Mesh *mesh);

/**
 * Finds normals that make a mesh look smooth: at each position the mean of its triangles' normals,
 * each weighted by its angle there, so that it does not depend on how a flat part is cut.
 * @param mesh          The mesh.
 * @param[out] normals  One unit normal a position, never NaN. Where the mean vanishes, as on the
 *                      edge of a sheet folded back on itself, it is the normal of a triangle that
 *                      is there; where there is none, it is up.
 */
void mesh_smooth_normals(const Mesh *mesh, Vec3d *normals);

#endif
