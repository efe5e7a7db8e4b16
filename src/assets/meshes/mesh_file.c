/**
 * @file
 * @brief Reading of mesh files.
 */
#include "assets/meshes/mesh_file.h"

#include "assets/asset_failure.h"
#include "assets/meshes/mesh_worker.h"
#include "base/base_name.h"
#include "base/language.h"
#include "base/regular_file.h"

#include <libintl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <sys/mman.h>

/** All extensions, for messages. */
#define MESH_EXTENSIONS N_("obj, ply, stl, glb or gltf")

/** Extensions of the supported formats. */
static const char *const extensions[] = {"obj", "ply", "stl", "glb", "gltf", NULL};

/** A mesh file being read. */
typedef struct MeshLoad {
    const char *name;             /**< Its name, without the folder. */
    const char *extension;        /**< Its format. */
    const AssetFile *file;        /**< The file. */
    AssetBudget *budget;          /**< What the scene has left. */
    const MeshProgress *progress; /**< Callback; or NULL. */
} MeshLoad;

/**
 * Finds the format of a file's extension, ignoring case.
 * @param path        The file.
 * @param[out] error  The known extensions.
 * @return The extension in lower case; NULL: unknown.
 */
static const char *find_extension(const char *path, Error *error) {
    const char *dot = strrchr(base_name(path), '.');
    for (int i = 0; dot && extensions[i]; i++) {
        if (strcasecmp(dot + 1, extensions[i]) == 0) {
            return extensions[i];
        }
    }
    error_set(error, STATUS_SCENE, "a model's name must end in .%s", gettext(MESH_EXTENSIONS));
    return NULL;
}

bool mesh_file_check(const char *path, Error *error) {
    return find_extension(path, error) != NULL;
}

/** Reports progress. See #WorkerMonitor.on_tick. */
static void report_progress(void *context, double seconds, double fraction) {
    const MeshLoad *load = context;
    load->progress->report(load->progress->context, load->name, fraction, seconds);
}

/** Sets the error of a worker without a mesh; see #AssetFailure. @return false, always. */
static bool set_failure(const WorkerReply *reply, const MeshWorkerReport *report, double time_limit,
                        bool is_time_shared, Error *error) {
    const AssetFailure failure = {.reply = reply,
                                  .reported = &report->error,
                                  .time_limit = time_limit,
                                  .is_time_shared = is_time_shared,
                                  .no_process = N_("no process to read a model in: %s"),
                                  .crash = N_("it makes the library that reads models crash (%s)")};
    return asset_failure_set(&failure, error);
}

/**
 * Checks a mesh from a worker, which a malicious file may control.
 * @param mesh        The mesh.
 * @param size        Bytes of its block.
 * @param[out] error  What is wrong.
 * @return Whether it is valid.
 */
static bool validate_mesh(Mesh *mesh, size_t size, Error *error) {
    bool is_short = size >= sizeof *mesh && mesh->position_count <= UINT32_MAX &&
                    mesh->normal_count <= UINT32_MAX && mesh->uv_count <= UINT32_MAX &&
                    mesh->triangle_count <= UINT32_MAX;
    if (!is_short || mesh_block_size(mesh) != size) {
        return error_set(error, STATUS_SCENE, "it makes the library that reads models go astray");
    }
    atomic_store(&mesh->reference_count, 1);
    mesh_bind_arrays(mesh);
    if (!mesh_validate(mesh, error)) {
        return false;
    }
    mesh_update_bounds(mesh);
    return true;
}

/** Reads an open file in a worker. @return The mesh; NULL on errors. */
static Mesh *read_open_file(MeshLoad *load, Error *error) {
    const WorkerMonitor monitor = {.on_tick = report_progress, .context = load};
    AssetBudget *budget = load->budget;
    MeshWorkerRequest request = {.size = (size_t)load->file->info.st_size,
                                 .capacity = MESH_CAPACITY < budget->memory ? MESH_CAPACITY
                                                                            : budget->memory,
                                 .is_capacity_shared = MESH_CAPACITY > budget->memory};
    MeshWorkerReport report = {0};
    double own_seconds =
        MESH_FILE_TIME_LIMIT + (double)request.size / (double)MESH_FILE_BYTES_PER_SECOND;
    double seconds = fmax(fmin(own_seconds, budget->seconds), 0);
    snprintf(request.extension, sizeof request.extension, "%s", load->extension);
    if (load->progress) {
        report_progress(load, 0, 0);
    }
    WorkerReply reply =
        worker_process_call_once(&(WorkerCall){.task = MESH_WORKER_TASK,
                                               .request = &request,
                                               .request_size = sizeof request,
                                               .file = load->file->descriptor,
                                               .time_limit = seconds,
                                               .monitor = load->progress ? &monitor : NULL,
                                               .report = &report,
                                               .report_capacity = sizeof report,
                                               .block_capacity = request.capacity});
    asset_budget_take_seconds(budget, reply.seconds);
    bool is_good =
        reply.end == WORKER_FINISHED && report.is_done && reply.block
            ? regular_file_is_unchanged(load->file->descriptor, &load->file->info, error) &&
                  validate_mesh(reply.block, reply.block_size, error) &&
                  asset_budget_take_memory(budget, reply.block_size, error)
            : set_failure(&reply, &report, seconds, seconds < own_seconds, error);
    if (!is_good && reply.block) {
        munmap(reply.block, reply.block_size);
        reply.block = NULL;
    }
    return reply.block;
}

bool mesh_file_read(const AssetFile *file, AssetBudget *budget, const MeshProgress *progress,
                    Mesh **mesh, Error *error) {
    *mesh = NULL;
    MeshLoad load = {.name = base_name(file->path),
                     .extension = find_extension(file->path, error),
                     .file = file,
                     .budget = budget,
                     .progress = progress};
    if (!load.extension) {
        return false;
    }
    *mesh = read_open_file(&load, error);
    if (progress) {
        progress->end(progress->context);
    }
    return *mesh != NULL;
}
