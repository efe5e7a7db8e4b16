/**
 * @file
 * @brief Model files: from the path to a mesh that is checked.
 */
#include "assets/meshes/mesh_file.h"

#include "assets/meshes/mesh_builder.h"
#include "assets/plugin.h"
#include "assets/process/sandbox_process.h"
#include "base/language.h"
#include "base/regular_file.h"

#include <errno.h>
#include <libintl.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/mman.h>
#include <unistd.h>

/** Bytes of address space where a child may leave a mesh: reserved, used as far as it is filled. */
#define MESH_CAPACITY ((size_t)2 << 30)
/** All endings, in words. */
#define MESH_EXTENSIONS N_("obj, ply, stl, glb or gltf")

/** The formats, by the ending of a file's name. */
static const char *const extensions[] = {"obj", "ply", "stl", "glb", "gltf", NULL};

/** The model module. */
static const Plugin mesh_plugin = {.file = "dioptre-meshes.so",
                                   .symbol = MESH_PLUGIN_SYMBOL,
                                   .version = MESH_PLUGIN_VERSION,
                                   .purpose = N_("models from files"),
                                   .library = "assimp",
                                   .build_package = "libassimp-dev",
                                   .runtime_package = "libassimp5",
                                   .fallback_hint = ""};

/** What child and parent share, but for the mesh. */
typedef struct SharedResult {
    bool is_done;                  /**< Whether the child came to the end of its work. */
    Error error;                   /**< What is wrong, if anything. */
    atomic_int progress_per_mille; /**< How much is done. */
} SharedResult;

/** A model file that is being read. */
typedef struct MeshLoad {
    const char *name;        /**< Its name, without the folder. */
    const char *extension;   /**< Its format. */
    int file;                /**< The same, open. */
    struct stat info_before; /**< What was known of it when it was opened. */
    SharedResult *result;    /**< What child and parent share. */
    Mesh *mesh;              /**< Where the child leaves the mesh: #MESH_CAPACITY bytes, shared. */
    const MeshProgress *progress; /**< Who is told; or NULL. */
} MeshLoad;

/** @return A file's name without its folder. */
static const char *base_name_of(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/**
 * Finds the format that the ending of a file's name says; small and large letters are alike.
 * @param[out] error  Which endings there are.
 * @return The ending, in small letters; or NULL.
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
    struct stat found;
    int file = find_extension(path, error) ? regular_file_open(path, &found, error) : -1;
    if (file >= 0) {
        close(file);
    }
    return file >= 0;
}

// --- the child -----------------------------------------------------------------------------------

/** Reads all bytes of the file. @return The bytes, to be freed; NULL if they cannot be read. */
static char *read_bytes(const MeshLoad *load, Error *error) {
    size_t size = (size_t)load->info_before.st_size, done = 0;
    char *bytes = malloc(size + 1);
    if (!bytes) {
        error_set(error, STATUS_SCENE, "it needs more memory than a model may take");
    }
    while (bytes && done < size) {
        ssize_t count = pread(load->file, bytes + done, size - done, (off_t)done);
        if (count > 0) {
            done += (size_t)count;
        } else if (count == 0 || errno != EINTR) {
            error_set(error, STATUS_SCENE, "%s",
                      count ? error_errno_text(errno) : gettext("it has become shorter"));
            free(bytes);
            bytes = NULL;
        }
    }
    return bytes;
}

/** What the child works with. */
typedef struct ImportContext {
    MeshBuilder builder;  /**< What the triangles become. */
    SharedResult *result; /**< Where progress is noted. */
} ImportContext;

/** Notes how much is done. See MeshSink::tell. */
static void store_progress(void *context, double fraction) {
    const ImportContext *import = context;
    atomic_store(&import->result->progress_per_mille, (int)(1000 * fraction));
}

/** Takes a triangle. See MeshSink::add. @return Whether more are wanted. */
static bool add_triangle(void *context, const MeshCorner corners[3]) {
    ImportContext *import = context;
    return mesh_builder_add(&import->builder, corners);
}

/**
 * Has the module read the file.
 * @param[in,out] import  Who takes the triangles.
 * @return Whether all were taken.
 */
static bool read_triangles(const MeshLoad *load, ImportContext *import, Error *error) {
    MeshSink sink = {
        .context = import, .add_triangle = add_triangle, .report_progress = store_progress};
    MeshSource source = {.extension = load->extension, .size = (size_t)load->info_before.st_size};
    MeshImportResult result;
    const MeshPlugin *plugin = plugin_open(&mesh_plugin, error);
    char *bytes = plugin ? read_bytes(load, error) : NULL;
    source.bytes = bytes;
    bool is_read = bytes && plugin->read(&source, &sink, &result);
    if (bytes && !is_read && result.message[0]) {
        error_set(error, STATUS_SCENE, "%s", result.message);
    }
    import->builder.repairs.untriangulated_polygons = is_read ? result.untriangulated_polygons : 0;
    free(bytes);
    return is_read;
}

/** Leaves the mesh where the parent finds it. @return false if there is none, or it is too large.
 */
static bool write_shared_mesh(const MeshLoad *load, MeshBuilder *builder, Error *error) {
    Mesh counts;
    if (!mesh_builder_finish(builder, &counts)) {
        return false;
    }
    if (mesh_block_size(&counts) > MESH_CAPACITY) {
        return error_set(error, STATUS_SCENE, "its %zu triangles take more than %zu MiB",
                         counts.triangle_count, MESH_CAPACITY >> 20);
    }
    *load->mesh = counts;
    mesh_bind_arrays(load->mesh);
    mesh_builder_copy(builder, load->mesh);
    return true;
}

/** Is the child: reads the model and leaves it. See #sandbox_process_run. */
static void read_in_sandbox(void *context) {
    const MeshLoad *load = context;
    SharedResult *result = load->result;
    ImportContext import = {.result = result};
    sandbox_process_enter(MESH_FILE_MEMORY_LIMIT);
    mesh_builder_init(&import.builder, &result->error);
    result->is_done = read_triangles(load, &import, &result->error) &&
                      write_shared_mesh(load, &import.builder, &result->error);
    mesh_builder_deinit(&import.builder);
}

// --- the parent ----------------------------------------------------------------------------------

/** Tells how far it is. See SandboxProcessMonitor::tell. */
static void report_progress(void *context, double seconds) {
    const MeshLoad *load = context;
    double fraction = (double)atomic_load(&load->result->progress_per_mille) / 1000;
    load->progress->report(load->progress->context, load->name, fmin(fmax(fraction, 0), 1),
                           seconds);
}

/**
 * Says why a child left no mesh.
 * @param load  What it was to read.
 * @param detail  The signal or the errno.
 * @param seconds  How long it might take.
 * @param[out] error  Where it is said.
 * @return false, always.
 */
static bool set_failure(const MeshLoad *load, SandboxProcessEnd end, int detail, double seconds,
                        Error *error) {
    const Error *reported = &load->result->error;
    if (end == SANDBOX_PROCESS_NOT_STARTED) {
        return error_set(error, STATUS_FAILED, "no process to read a model in: %s",
                         error_errno_text(detail));
    }
    if (end == SANDBOX_PROCESS_TIMED_OUT) {
        return error_set(error, STATUS_SCENE, "it takes more than %.0f s to read", seconds);
    }
    if (end == SANDBOX_PROCESS_CRASHED && detail == SIGINT) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    if (end == SANDBOX_PROCESS_EXITED && reported->status != STATUS_OK) {
        return error_set(error, reported->status, "%.*s", ERROR_MESSAGE_SIZE - 1,
                         reported->message);
    }
    return error_set(error, STATUS_SCENE, "it makes the library that reads models crash (%s)",
                     detail ? strsignal(detail) : gettext("it ended early"));
}

/** Reads the file in a child. @return Whether the child left a mesh. */
static bool run_sandbox(MeshLoad *load, Error *error) {
    int detail;
    double extra_seconds = (double)load->info_before.st_size / (double)MESH_FILE_BYTES_PER_SECOND;
    double seconds = MESH_FILE_TIME_LIMIT + extra_seconds;
    const SandboxProcessMonitor monitor = {.on_tick = report_progress, .context = load};
    SandboxProcessEnd end = sandbox_process_run_monitored(
        read_in_sandbox, load, seconds, load->progress ? &monitor : NULL, &detail);
    bool is_good = end == SANDBOX_PROCESS_EXITED && load->result->is_done;
    return is_good || set_failure(load, end, detail, seconds, error);
}

/** Makes a mesh of what a child left, which may be anything if a file has got hold of it, and gives
 *  the rest of the room back. @return Whether it is a mesh. */
static bool validate_mesh(Mesh *mesh, Error *error) {
    bool is_short = mesh->position_count <= UINT32_MAX && mesh->normal_count <= UINT32_MAX &&
                    mesh->uv_count <= UINT32_MAX && mesh->triangle_count <= UINT32_MAX;
    if (!is_short || mesh_block_size(mesh) > MESH_CAPACITY) {
        return error_set(error, STATUS_SCENE, "it makes the library that reads models go astray");
    }
    atomic_store(&mesh->reference_count, 1);
    mesh_bind_arrays(mesh);
    if (!mesh_validate(mesh, error)) {
        return false;
    }
    mesh_update_bounds(mesh);
    size_t page = (size_t)sysconf(_SC_PAGESIZE);
    size_t kept = (mesh_block_size(mesh) + page - 1) / page * page;
    if (kept < MESH_CAPACITY) {
        munmap((char *)mesh + kept, MESH_CAPACITY - kept);
    }
    return true;
}

/**
 * Reads an open file.
 * @param load  The file; its memory is taken here, and all but the mesh given back.
 * @return Whether it was read; then the mesh is the caller's.
 */
static bool read_open_file(MeshLoad *load, Error *error) {
    load->result = sandbox_process_share_memory(sizeof *load->result);
    load->mesh = sandbox_process_share_memory(MESH_CAPACITY);
    bool has_memory = load->result && load->mesh;
    if (has_memory && load->progress) {
        report_progress(load, 0);
    }
    bool is_read = has_memory
                       ? run_sandbox(load, error) &&
                             regular_file_is_unchanged(load->file, &load->info_before, error) &&
                             validate_mesh(load->mesh, error)
                       : error_set(error, STATUS_FAILED, "no memory for a mesh");
    if (load->mesh && !is_read) {
        munmap(load->mesh, MESH_CAPACITY);
    }
    if (load->result) {
        munmap(load->result, sizeof *load->result);
    }
    return is_read;
}

bool mesh_file_read(const char *path, const MeshProgress *progress, Mesh **mesh, Error *error) {
    *mesh = NULL;
    MeshLoad load = {.name = base_name_of(path), .progress = progress};
    load.extension = find_extension(path, error);
    load.file = load.extension ? regular_file_open(path, &load.info_before, error) : -1;
    if (load.file < 0) {
        return false;
    }
    bool is_read = read_open_file(&load, error);
    close(load.file);
    *mesh = is_read ? load.mesh : NULL;
    if (progress) {
        progress->end(progress->context);
    }
    return is_read;
}
