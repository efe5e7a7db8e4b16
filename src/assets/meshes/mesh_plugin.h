/**
 * @file
 * @brief What the model module `dioptre-meshes.so` offers: triangles out of model files.
 *
 * The library behind it is assimp; `doc/tour.md` has the figures of tinyobjloader beside it.
 *
 * The module is opened in a child process only. No file but the model's own is opened, whatever
 * materials it names: the module gets bytes, not paths.
 */
#ifndef DIOPTRE_ASSETS_MESHES_MESH_PLUGIN_H
#define DIOPTRE_ASSETS_MESHES_MESH_PLUGIN_H

#include <stdbool.h>
#include <stddef.h>

/** Counts the changes of this header: program and module must be of the same count. */
enum { MESH_PLUGIN_VERSION = 1 };
/** Longest message, in bytes with its final zero. */
enum { MESH_PLUGIN_MESSAGE_SIZE = 512 };

/** A whole model file in memory. */
typedef struct MeshSource {
    const char *extension; /**< The format, as the ending of the file's name says it: `obj`, ... */
    const char *bytes;     /**< Its bytes. */
    size_t size;           /**< How many. */
} MeshSource;

/** One corner of a triangle. */
typedef struct MeshCorner {
    double position[3]; /**< Where it is; any numbers. */
    double normal[3];   /**< Its normal, of any length, zero too. */
    double uv[2];       /**< Its place on a picture; any numbers. */
    bool has_normal;    /**< Whether there is a normal. */
    bool has_uv;        /**< Whether there is a (u, v). */
} MeshCorner;

/** Who takes the triangles. */
typedef struct MeshSink {
    void *context; /**< Handed to the two functions. */
    /** Takes a triangle; false: no more is wanted. */
    bool (*add_triangle)(void *context, const MeshCorner corners[3]);
    /** Is told how much is done, 0 to 1. */
    void (*report_progress)(void *context, double share);
} MeshSink;

/** What went otherwise than it should. */
typedef struct MeshImportResult {
    size_t untriangulated_polygons; /**< Triangles missing of polygons that cannot be cut. */
    char
        message[MESH_PLUGIN_MESSAGE_SIZE]; /**< What is wrong, in words, without the file's name. */
} MeshImportResult;

/** The module: its one function. */
typedef struct MeshPlugin {
    int version; /**< #MESH_PLUGIN_VERSION as the module was built with. */

    /**
     * Reads a model and hands its triangles over, polygons cut into triangles, points and lines
     * left out, in the order of the file.
     * @param sink  Who takes the triangles.
     * @param[out] report  What went otherwise than it should.
     * @return Whether all were handed over; if not, there is a message unless the sink wanted no
     *         more.
     */
    bool (*read)(const MeshSource *source, const MeshSink *sink, MeshImportResult *report);
} MeshPlugin;

/** Name under which the module offers its one #MeshPlugin. */
#define MESH_PLUGIN_SYMBOL "dioptre_mesh_plugin"

#endif
