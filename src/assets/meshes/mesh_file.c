/**
 * @file
 * @brief Reading of mesh files.
 */
#include "assets/meshes/mesh_file.h"

#include "assets/meshes/mesh_worker.h"
#include "assets/process/worker_process.h"
#include "base/language.h"
#include "base/regular_file.h"

#include <libintl.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <sys/mman.h>
#include <unistd.h>

/** All extensions, for messages. */
#define MESH_EXTENSIONS N_("obj, ply, stl, glb or gltf")

/** Extensions of the supported formats. */
static const char *const extensions[] = {"obj", "ply", "stl", "glb", "gltf", NULL};

/** A mesh file being read. */
typedef struct MeshLoad {
    const char *name;             /**< Its name, without the folder. */
    const char *extension;        /**< Its format. */
    int file;                     /**< Its descriptor. */
    struct stat info_before;      /**< Size and times at the opening of the file. */
    const MeshProgress *progress; /**< Callback; or NULL. */
} MeshLoad;

/** @return A file's name without its folder. */
static const char *base_name_of(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/**
 * Finds the format of a file's extension, ignoring case.
 * @param path        The file.
 * @param[out] error  The known extensions.
 * @return The extension in lower case; NULL: unknown.
 */
static const char *find_extension(const char *path, Error *error) {
    const char *dot = strrchr(base_name_of(path), '.');
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

/**
 * Sets the error of a worker without a mesh.
 * @param reply       The reply of the worker.
 * @param report      Its report.
 * @param seconds     The time limit.
 * @param[out] error  The error.
 * @return false, always.
 */
static bool set_failure(const WorkerReply *reply, const MeshWorkerReport *report, double seconds,
                        Error *error) {
    char reason[WORKER_REASON_SIZE];
    if (worker_reply_start_failure(reply, reason)) {
        return error_set(error, STATUS_FAILED, "no process to read a model in: %s", reason);
    }
    if (reply->end == WORKER_TIMED_OUT) {
        return error_set(error, STATUS_SCENE, "it takes more than %.0f s to read", seconds);
    }
    if (worker_reply_is_interrupted(reply)) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    if (reply->end == WORKER_FINISHED && report->error.status != STATUS_OK) {
        worker_error_set(error, &report->error);
        return error_set_line(error, report->error.line);
    }
    return error_set(error, STATUS_SCENE, "it makes the library that reads models crash (%s)",
                     reply->detail ? strsignal(reply->detail) : gettext("it ended early"));
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
    MeshWorkerRequest request = {.size = (size_t)load->info_before.st_size};
    MeshWorkerReport report = {0};
    double seconds =
        MESH_FILE_TIME_LIMIT + (double)request.size / (double)MESH_FILE_BYTES_PER_SECOND;
    snprintf(request.extension, sizeof request.extension, "%s", load->extension);
    if (load->progress) {
        report_progress(load, 0, 0);
    }
    WorkerReply reply =
        worker_process_call_once(&(WorkerCall){.task = MESH_WORKER_TASK,
                                               .request = &request,
                                               .request_size = sizeof request,
                                               .file = load->file,
                                               .time_limit = seconds,
                                               .monitor = load->progress ? &monitor : NULL,
                                               .report = &report,
                                               .report_capacity = sizeof report,
                                               .block_capacity = MESH_CAPACITY});
    bool is_good = reply.end == WORKER_FINISHED && report.is_done && reply.block
                       ? regular_file_is_unchanged(load->file, &load->info_before, error) &&
                             validate_mesh(reply.block, reply.block_size, error)
                       : set_failure(&reply, &report, seconds, error);
    if (!is_good && reply.block) {
        munmap(reply.block, reply.block_size);
        reply.block = NULL;
    }
    return reply.block;
}

bool mesh_file_read(const char *path, const MeshProgress *progress, Mesh **mesh, Error *error) {
    *mesh = NULL;
    MeshLoad load = {.name = base_name_of(path), .progress = progress};
    load.extension = find_extension(path, error);
    load.file = load.extension ? regular_file_open(path, &load.info_before, error) : -1;
    if (load.file < 0) {
        return false;
    }
    *mesh = read_open_file(&load, error);
    close(load.file);
    if (progress) {
        progress->end(progress->context);
    }
    return *mesh != NULL;
}
