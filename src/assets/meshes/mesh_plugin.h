/**
 * @file
 * @brief Interface of the mesh module `dioptre-meshes.so`: triangles of mesh files.
 *
 * Its library is assimp. OBJ files do not get here: #obj_read reads them.
 *
 * The module is loaded in a worker process only. It receives bytes instead of paths, so that it
 * cannot open the material files that a mesh names.
 */
#ifndef DIOPTRE_ASSETS_MESHES_MESH_PLUGIN_H
#define DIOPTRE_ASSETS_MESHES_MESH_PLUGIN_H

#include <stdbool.h>
#include <stddef.h>

/** Version of this interface; program and module must agree. */
enum { MESH_PLUGIN_VERSION = 1 };
/** Size of a message, with its final zero. */
enum { MESH_PLUGIN_MESSAGE_SIZE = 512 };

/** A mesh file in memory. */
typedef struct MeshSource {
    const char *extension; /**< Format, as the extension of the file: `ply`, ... */
    const char *bytes;     /**< Its bytes. */
    size_t size;           /**< Number of bytes. */
} MeshSource;

/** A corner of a triangle. */
typedef struct MeshCorner {
    double position[3]; /**< Position; any numbers. */
    double normal[3];   /**< Normal, of any length, even zero. */
    double uv[2];       /**< Texture coordinates; any numbers. */
    bool has_normal;    /**< Whether #normal is set. */
    bool has_uv;        /**< Whether #uv is set. */
} MeshCorner;

/** Receiver of the triangles. */
typedef struct MeshSink {
    void *context; /**< First argument of both functions. */
    /** Receives a triangle. @return false to stop. */
    bool (*add_triangle)(void *context, const MeshCorner corners[3]);
    /** Receives the completed fraction, 0 to 1. */
    void (*report_progress)(void *context, double share);
} MeshSink;

/** Defects and errors of a mesh file. */
typedef struct MeshImportResult {
    size_t untriangulated_polygons;         /**< Missing triangles of invalid polygons. */
    char message[MESH_PLUGIN_MESSAGE_SIZE]; /**< Error message, without the file's name. */
} MeshImportResult;

/** The function of the module. */
typedef struct MeshPlugin {
    int version; /**< #MESH_PLUGIN_VERSION at the build of the module. */

    /**
     * Reads a mesh file and passes its triangles to a sink, in the order of the file. Polygons are
     * triangulated; points and lines are ignored.
     * @param source       The file.
     * @param sink         Receives the triangles.
     * @param[out] report  Defects and errors.
     * @return Whether the sink took all; if not, there is a message unless the sink stopped.
     */
    bool (*read)(const MeshSource *source, const MeshSink *sink, MeshImportResult *report);
} MeshPlugin;

/** Symbol of the #MeshPlugin in the module. */
#define MESH_PLUGIN_SYMBOL "dioptre_mesh_plugin"

#endif
