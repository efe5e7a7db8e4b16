/**
 * @file
 * @brief Meshes: triangles that share their corners, checked and ready to be traced.
 */
#ifndef DIOPTRE_MESH_H
#define DIOPTRE_MESH_H

#include "dioptre/error.h"
#include "dioptre/vector3.h"

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
    uint32_t at[3]; /**< The places. */
} MeshTriangle;

/** What was wrong with a model file and could be put right. */
typedef struct MeshRepairs {
    size_t degenerate;   /**< Triangles without area: left out. */
    size_t uncut;        /**< Triangles missing of polygons that cannot be cut into triangles. */
    size_t lost_normals; /**< Corners whose normal is missing, while others have one, or has no
                              direction: their triangle's normal was put there. */
    size_t lost_uvs;     /**< Corners without a (u, v) that could be used, while others have one:
                              (0, 0) was put there. Where only some corners of one part of an OBJ
                              lack theirs, the library has done so already, uncounted. */
} MeshRepairs;

/** A mesh: one block of memory, shared with child processes, with all its arrays in it. */
typedef struct Mesh {
    size_t position_count;          /**< How many positions, at least 3. */
    Vector3 *positions;             /**< Places in space, scene units, no two the same. */
    size_t normal_count;            /**< How many normals; 0: the file has none. */
    Vector3 *normals;               /**< The file's, of unit length. */
    size_t uv_count;                /**< How many (u, v); 0: the file has none. */
    MeshUv *uvs;                    /**< The file's. */
    size_t triangle_count;          /**< How many triangles, at least 1. */
    MeshTriangle *triangles;        /**< Places in #positions. */
    MeshTriangle *triangle_normals; /**< Places in #normals; NULL without normals. */
    MeshTriangle *triangle_uvs;     /**< Places in #uvs; NULL without (u, v). */
    MeshRepairs repairs;            /**< What was put right. */
    atomic_uint owners;             /**< How many hold it. */
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
    void (*tell)(void *context, const char *name, double share, double seconds);
    /** Is told when the file is read or given up. @param context #MeshProgress.context. */
    void (*end)(void *context);
    void *context; /**< Handed to both. */
} MeshProgress;

/**
 * Makes a mesh with one owner, all its numbers zero, to be filled.
 * @param counts      How many of everything; the rest of it is not read.
 * @param[out] error  What is wrong.
 * @return The mesh, to be given back with #mesh_destroy; NULL without memory.
 */
Mesh *mesh_create(const Mesh *counts, Error *error);

/**
 * Copies a mesh to another place.
 * @param mesh        The mesh.
 * @param way         How far it is moved, scene units.
 * @param[out] error  What is wrong.
 * @return The copy, to be given back with #mesh_destroy; NULL without memory.
 */
Mesh *mesh_moved(const Mesh *mesh, Vector3 way, Error *error);

/** Becomes one more owner. @param mesh The mesh, or NULL. @return The same. */
Mesh *mesh_share(Mesh *mesh);

/** Gives a mesh back; the last owner's call gives its memory back. @param mesh It, or NULL. */
void mesh_destroy(Mesh *mesh);

/**
 * @return Bytes of the block that a mesh lies in.
 * @param counts  The mesh; only its counts are read, each at most UINT32_MAX.
 */
size_t mesh_size(const Mesh *counts);

/**
 * Points the arrays of a mesh to their places in its block, right behind it.
 * @param[in,out] mesh  The mesh, at the head of a block of #mesh_size bytes, its counts set.
 */
void mesh_lay_out(Mesh *mesh);

/**
 * Looks at every number of a mesh.
 * @param mesh        The mesh.
 * @param[out] error  What is wrong (#STATUS_SCENE).
 * @return Whether it has a triangle, all is finite and within #LENGTH_MAXIMUM, normals are of unit
 *         length, and every place is one.
 */
bool mesh_check(const Mesh *mesh, Error *error);

/**
 * Finds normals that make a mesh look smooth: at each position the mean of its triangles' normals,
 * each weighted by its angle there, so that it does not depend on how a flat part is cut.
 * @param mesh          The mesh.
 * @param[out] normals  One unit normal a position, never NaN. Where the mean vanishes, as on the
 *                      edge of a sheet folded back on itself, it is the normal of a triangle that
 *                      is there; where there is none, it is up.
 */
void mesh_smooth_normals(const Mesh *mesh, Vector3 *normals);

#endif
