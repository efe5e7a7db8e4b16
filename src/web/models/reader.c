/**
 * @file
 * @brief The program that reads PLY, STL and glTF files for the page: mesh_plugin.c with assimp.
 *
 * It is a WebAssembly of its own, `models.wasm`, which the page fetches when such a file is dropped
 * there: nobody else waits for its bytes. Each file gets a new instance with memory of its own, so
 * that a hostile file can harm that instance alone.
 */
#include "web/models.h"

#include <emscripten.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/** The mesh module, see mesh_plugin.c. */
extern const MeshPlugin dioptre_mesh_plugin;

/** Triangles being collected. */
typedef struct Collection {
    ModelTriangles *model; /**< The triangles; owned by the caller of #models_read. */
    size_t capacity;       /**< Number of triangles that fit. */
} Collection;

/** Triangles for which there is room at first. */
enum { CAPACITY_AT_FIRST = 1024 };

/** @return Bytes of a number of triangles. */
static size_t bytes_of(size_t count) {
    return sizeof(ModelTriangles) + 3 * count * sizeof(MeshCorner);
}

/** Adds a triangle. See #MeshSink.add_triangle. @return Whether there was memory. */
static bool add_triangle(void *context, const MeshCorner corners[3]) {
    Collection *collection = context;
    ModelTriangles *model = collection->model;
    if (model->count == collection->capacity) {
        ModelTriangles *grown = realloc(model, bytes_of(2 * collection->capacity));
        if (!grown) {
            return false;
        }
        collection->capacity *= 2;
        collection->model = model = grown;
    }
    memcpy(&model->corners[3 * (size_t)model->count++], corners, 3 * sizeof *corners);
    return true;
}

/** Does nothing: the page waits. See #MeshSink.report_progress. */
static void report_progress(void *context, double fraction) {
    (void)context, (void)fraction;
}

/** Reads a model file. @param extension Its format. @param bytes Its bytes. @return The triangles;
 *  NULL without memory. Called by the page. */
EMSCRIPTEN_KEEPALIVE const ModelTriangles *models_read(const char *extension, const char *bytes,
                                                       size_t size) {
    Collection collection = {.model = calloc(1, bytes_of(CAPACITY_AT_FIRST)),
                             .capacity = CAPACITY_AT_FIRST};
    if (!collection.model) {
        return NULL;
    }
    const MeshSource source = {.extension = extension, .bytes = bytes, .size = size};
    const MeshSink sink = {
        .context = &collection, .add_triangle = add_triangle, .report_progress = report_progress};
    MeshImportResult result;
    bool is_read = dioptre_mesh_plugin.read(&source, &sink, &result);
    collection.model->is_read = is_read;
    collection.model->result = result;
    return collection.model;
}

/** @return Bytes of what #models_read gave. Called by the page. */
EMSCRIPTEN_KEEPALIVE size_t models_size(const ModelTriangles *model) {
    return bytes_of(model->count);
}
