/**
 * @file
 * @brief Reading of meshes: the worker's side.
 */
#include "assets/meshes/mesh_worker.h"

#include "assets/asset_budget.h"
#include "assets/meshes/mesh_builder.h"
#include "assets/meshes/obj_reader.h"
#include "assets/plugin.h"
#include "base/language.h"
#include "base/regular_file.h"

#include <stdlib.h>
#include <string.h>

/** The mesh module. */
static const Plugin mesh_plugin = {.file = "dioptre-meshes.so",
                                   .symbol = MESH_PLUGIN_SYMBOL,
                                   .version = MESH_PLUGIN_VERSION,
                                   .purpose = N_("models from files"),
                                   .library = "assimp",
                                   .build_package = "libassimp-dev",
                                   .runtime_package = "libassimp5",
                                   .fallback_hint = ""};

/** Reads all bytes of a file. @return The bytes, to be freed with `free`; NULL on errors. */
static char *read_bytes(int file, size_t size, Error *error) {
    char *bytes = malloc(size + 1);
    if (!bytes) {
        error_set(error, STATUS_SCENE, "it needs more memory than a model may take");
    } else if (!regular_file_read(file, bytes, size, error)) {
        free(bytes);
        bytes = NULL;
    }
    return bytes;
}

/** A mesh file being read. */
typedef struct Import {
    MeshBuilder builder; /**< Collects the triangles. */
    int per_mille;       /**< Last progress that was sent, 0 to 1000. */
} Import;

/** Sends progress if it has changed. See #MeshSink.report_progress. */
static void report_progress(void *context, double fraction) {
    Import *import = context;
    int per_mille = (int)(1000 * fraction);
    if (per_mille != import->per_mille) {
        import->per_mille = per_mille;
        worker_job_progress(fraction);
    }
}

/** Adds a triangle. See #MeshSink.add_triangle. @return false to stop. */
static bool add_triangle(void *context, const MeshCorner corners[3]) {
    Import *import = context;
    return mesh_builder_add(&import->builder, corners);
}

/** Reads a file in memory with the module. @return Whether all triangles were added. */
static bool read_with_module(const MeshPlugin *plugin, const MeshSource *source,
                             const MeshSink *sink, MeshRepairs *repairs, Error *error) {
    MeshImportResult result;
    bool is_read = plugin->read(source, sink, &result);
    if (!is_read && result.message[0]) {
        error_set(error, STATUS_SCENE, "%s", result.message);
    }
    repairs->untriangulated_polygons = is_read ? result.untriangulated_polygons : 0;
    return is_read;
}

/** Reads the file: OBJ here, other formats with the module. @return Whether all triangles were
 *  added. */
static bool read_triangles(const WorkerJob *job, Import *import, Error *error) {
    const MeshWorkerRequest *request = job->request;
    const MeshSink sink = {
        .context = import, .add_triangle = add_triangle, .report_progress = report_progress};
    MeshRepairs *repairs = &import->builder.repairs;
    bool is_obj = strcmp(request->extension, "obj") == 0;
    const MeshPlugin *plugin = is_obj ? NULL : plugin_open(&mesh_plugin, error);
    worker_job_ready();
    worker_enter_sandbox(MESH_FILE_MEMORY_LIMIT);
    char *bytes = is_obj || plugin ? read_bytes(job->file, request->size, error) : NULL;
    const MeshSource source = {request->extension, bytes, request->size};
    bool is_read = bytes && (is_obj ? obj_read(bytes, request->size, &sink, repairs, error)
                                    : read_with_module(plugin, &source, &sink, repairs, error));
    free(bytes);
    return is_read;
}

/** Creates the block: the mesh of a builder. @return false if it is empty or too large. */
static bool make_block(WorkerJob *job, MeshBuilder *builder, Error *error) {
    Mesh counts;
    if (!mesh_builder_finish(builder, &counts)) {
        return false;
    }
    const MeshWorkerRequest *request = job->request;
    if (mesh_block_size(&counts) > request->capacity) {
        if (request->is_capacity_shared) {
            return asset_budget_set_memory_error(error);
        }
        return error_set(error, STATUS_SCENE, "its %zu triangles take more than %zu MiB",
                         counts.triangle_count, request->capacity >> 20);
    }
    Mesh *mesh = mesh_create(&counts, error);
    if (mesh) {
        mesh->repairs = counts.repairs;
        mesh_builder_copy(builder, mesh);
        job->block = mesh;
        job->block_size = job->block_capacity = mesh_block_size(mesh);
    }
    return mesh != NULL;
}

void mesh_worker_read(WorkerJob *job) {
    static MeshWorkerReport report;
    Import import = {.per_mille = 0};
    report = (MeshWorkerReport){0};
    job->report = &report;
    job->report_size = sizeof report;
    mesh_builder_init(&import.builder, &report.error);
    report.is_done = read_triangles(job, &import, &report.error) &&
                     make_block(job, &import.builder, &report.error);
    mesh_builder_deinit(&import.builder);
}
