/**
 * @file
 * @brief Model files: from the path to a mesh that is checked.
 */
#include "assets/mesh_file.h"

#include "assets/child.h"
#include "assets/mesh_builder.h"
#include "assets/module.h"
#include "assets/plain_file.h"
#include "dioptre/language.h"

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
#define ROOM ((size_t)2 << 30)
/** All endings, in words. */
#define ENDINGS N_("obj, ply, stl, glb or gltf")

/** The formats, by the ending of a file's name. */
static const char *const endings[] = {"obj", "ply", "stl", "glb", "gltf", NULL};

/** The model module. */
static const Module meshes_module = {.file = "dioptre-meshes.so",
                                     .symbol = MESHES_MODULE_SYMBOL,
                                     .version = MESHES_MODULE_VERSION,
                                     .purpose = N_("models from files"),
                                     .library = "assimp",
                                     .to_build = "libassimp-dev",
                                     .to_run = "libassimp5",
                                     .without = ""};

/** What child and parent share, but for the mesh. */
typedef struct Handover {
    bool is_done;         /**< Whether the child came to the end of its work. */
    Error error;          /**< What is wrong, if anything. */
    atomic_int per_mille; /**< How much is done. */
} Handover;

/** A model file that is being read. */
typedef struct Reading {
    const char *name;             /**< Its name, without the folder. */
    const char *ending;           /**< Its format. */
    int file;                     /**< The same, open. */
    struct stat before;           /**< What was known of it when it was opened. */
    Handover *handover;           /**< What child and parent share. */
    Mesh *mesh;                   /**< Where the child leaves the mesh: #ROOM bytes, shared. */
    const MeshProgress *progress; /**< Who is told; or NULL. */
} Reading;

/** @return A file's name without its folder. @param path The file. */
static const char *name_of(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/**
 * Finds the format that the ending of a file's name says; small and large letters are alike.
 * @param path        The file.
 * @param[out] error  Which endings there are.
 * @return The ending, in small letters; or NULL.
 */
static const char *find_ending(const char *path, Error *error) {
    const char *dot = strrchr(name_of(path), '.');
    for (int i = 0; dot && endings[i]; i++) {
        if (strcasecmp(dot + 1, endings[i]) == 0) {
            return endings[i];
        }
    }
    error_set(error, STATUS_SCENE, "a model's name must end in .%s", gettext(ENDINGS));
    return NULL;
}

bool mesh_file_check(const char *path, Error *error) {
    struct stat found;
    int file = find_ending(path, error) ? plain_file_open(path, &found, error) : -1;
    if (file >= 0) {
        close(file);
    }
    return file >= 0;
}

// --- the child -----------------------------------------------------------------------------------

/**
 * Reads all bytes of the file.
 * @param reading     The file.
 * @param[out] error  What is wrong.
 * @return The bytes, to be freed; NULL if they cannot be read.
 */
static char *read_bytes(const Reading *reading, Error *error) {
    size_t size = (size_t)reading->before.st_size, done = 0;
    char *bytes = malloc(size + 1);
    if (!bytes) {
        error_set(error, STATUS_SCENE, "it needs more memory than a model may take");
    }
    while (bytes && done < size) {
        ssize_t count = pread(reading->file, bytes + done, size - done, (off_t)done);
        if (count > 0) {
            done += (size_t)count;
        } else if (count == 0 || errno != EINTR) {
            error_set(error, STATUS_SCENE, "%s",
                      count ? error_system(errno) : gettext("it has become shorter"));
            free(bytes);
            bytes = NULL;
        }
    }
    return bytes;
}

/** What the child works with. */
typedef struct Work {
    MeshBuilder builder; /**< What the triangles become. */
    Handover *handover;  /**< Where progress is noted. */
} Work;

/** Notes how much is done. See MeshesSink::tell. @param context A #Work. @param share How much. */
static void note_share(void *context, double share) {
    const Work *work = context;
    atomic_store(&work->handover->per_mille, (int)(1000 * share));
}

/** Takes a triangle. See MeshesSink::add. @param context A #Work. @param corners Its corners.
 *  @return Whether more are wanted. */
static bool add_triangle(void *context, const MeshesCorner corners[3]) {
    Work *work = context;
    return mesh_builder_add(&work->builder, corners);
}

/**
 * Has the module read the file.
 * @param reading       The file.
 * @param[in,out] work  Who takes the triangles.
 * @param[out] error    What is wrong.
 * @return Whether all were taken.
 */
static bool read_triangles(const Reading *reading, Work *work, Error *error) {
    MeshesSink sink = {.context = work, .add = add_triangle, .tell = note_share};
    MeshesSource source = {.ending = reading->ending, .size = (size_t)reading->before.st_size};
    MeshesReport report;
    const MeshesModule *module = module_open(&meshes_module, error);
    char *bytes = module ? read_bytes(reading, error) : NULL;
    source.bytes = bytes;
    bool is_read = bytes && module->read(&source, &sink, &report);
    if (bytes && !is_read && report.message[0]) {
        error_set(error, STATUS_SCENE, "%s", report.message);
    }
    work->builder.repairs.uncut = is_read ? report.uncut : 0;
    free(bytes);
    return is_read;
}

/**
 * Leaves the mesh where the parent finds it.
 * @param reading     The file.
 * @param builder     The mesh.
 * @param[out] error  What is wrong.
 * @return false if there is none, or it is too large.
 */
static bool leave_mesh(const Reading *reading, MeshBuilder *builder, Error *error) {
    Mesh counts;
    if (!mesh_builder_finish(builder, &counts)) {
        return false;
    }
    if (mesh_size(&counts) > ROOM) {
        return error_set(error, STATUS_SCENE, "its %zu triangles take more than %zu MiB",
                         counts.triangle_count, ROOM >> 20);
    }
    *reading->mesh = counts;
    mesh_lay_out(reading->mesh);
    mesh_builder_copy(builder, reading->mesh);
    return true;
}

/** Is the child: reads the model and leaves it. See #child_run. @param context The #Reading. */
static void read_in_child(void *context) {
    const Reading *reading = context;
    Handover *handover = reading->handover;
    Work work = {.handover = handover};
    child_withdraw(MESH_FILE_MEMORY);
    mesh_builder_init(&work.builder, &handover->error);
    handover->is_done = read_triangles(reading, &work, &handover->error) &&
                        leave_mesh(reading, &work.builder, &handover->error);
    mesh_builder_release(&work.builder);
}

// --- the parent ----------------------------------------------------------------------------------

/** Tells how far it is. See ChildWatcher::tell. @param context The #Reading. @param seconds Since
 *  the start. */
static void tell(void *context, double seconds) {
    const Reading *reading = context;
    double share = (double)atomic_load(&reading->handover->per_mille) / 1000;
    reading->progress->tell(reading->progress->context, reading->name, fmin(fmax(share, 0), 1),
                            seconds);
}

/**
 * Says why a child left no mesh.
 * @param reading     What it was to read.
 * @param end         How it ended.
 * @param detail      The signal or the errno.
 * @param seconds     How long it might take.
 * @param[out] error  Where it is said.
 * @return false, always.
 */
static bool explain(const Reading *reading, ChildEnd end, int detail, double seconds,
                    Error *error) {
    const Error *said = &reading->handover->error;
    if (end == CHILD_UNSTARTED) {
        return error_set(error, STATUS_FAILED, "no process to read a model in: %s",
                         error_system(detail));
    }
    if (end == CHILD_LATE) {
        return error_set(error, STATUS_SCENE, "it takes more than %.0f s to read", seconds);
    }
    if (end == CHILD_CRASHED && detail == SIGINT) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    if (end == CHILD_ENDED && said->status != STATUS_DONE) {
        return error_set(error, said->status, "%.*s", ERROR_MESSAGE_SIZE - 1, said->message);
    }
    return error_set(error, STATUS_SCENE, "it makes the library that reads models crash (%s)",
                     detail ? strsignal(detail) : gettext("it ended early"));
}

/**
 * Reads the file in a child.
 * @param reading     The file.
 * @param[out] error  What is wrong.
 * @return Whether the child left a mesh.
 */
static bool run_child(Reading *reading, Error *error) {
    int detail;
    double more = (double)reading->before.st_size / (double)MESH_FILE_BYTES_A_SECOND;
    double seconds = MESH_FILE_SECONDS + more;
    const ChildWatcher watcher = {.tell = tell, .context = reading};
    ChildEnd end = child_run_watched(read_in_child, reading, seconds,
                                     reading->progress ? &watcher : NULL, &detail);
    bool is_good = end == CHILD_ENDED && reading->handover->is_done;
    return is_good || explain(reading, end, detail, seconds, error);
}

/**
 * Makes a mesh of what a child left, which may be anything if a file has got hold of it, and gives
 * the rest of the room back.
 * @param left        What it left.
 * @param[out] error  What is wrong.
 * @return Whether it is a mesh.
 */
static bool accept(Mesh *left, Error *error) {
    bool is_short = left->position_count <= UINT32_MAX && left->normal_count <= UINT32_MAX &&
                    left->uv_count <= UINT32_MAX && left->triangle_count <= UINT32_MAX;
    if (!is_short || mesh_size(left) > ROOM) {
        return error_set(error, STATUS_SCENE, "it makes the library that reads models go astray");
    }
    atomic_store(&left->owners, 1);
    mesh_lay_out(left);
    if (!mesh_check(left, error)) {
        return false;
    }
    size_t page = (size_t)sysconf(_SC_PAGESIZE);
    size_t kept = (mesh_size(left) + page - 1) / page * page;
    if (kept < ROOM) {
        munmap((char *)left + kept, ROOM - kept);
    }
    return true;
}

/**
 * Reads an open file.
 * @param reading     The file; its memory is taken here, and all but the mesh given back.
 * @param[out] error  What is wrong.
 * @return Whether it was read; then the mesh is the caller's.
 */
static bool read_open(Reading *reading, Error *error) {
    reading->handover = child_share_memory(sizeof *reading->handover);
    reading->mesh = child_share_memory(ROOM);
    bool has_memory = reading->handover && reading->mesh;
    if (has_memory && reading->progress) {
        tell(reading, 0);
    }
    bool is_read = has_memory ? run_child(reading, error) &&
                                    plain_file_is_same(reading->file, &reading->before, error) &&
                                    accept(reading->mesh, error)
                              : error_set(error, STATUS_FAILED, "no memory for a mesh");
    if (reading->mesh && !is_read) {
        munmap(reading->mesh, ROOM);
    }
    if (reading->handover) {
        munmap(reading->handover, sizeof *reading->handover);
    }
    return is_read;
}

bool mesh_file_read(const char *path, const MeshProgress *progress, Mesh **mesh, Error *error) {
    *mesh = NULL;
    Reading reading = {.name = name_of(path), .progress = progress};
    reading.ending = find_ending(path, error);
    reading.file = reading.ending ? plain_file_open(path, &reading.before, error) : -1;
    if (reading.file < 0) {
        return false;
    }
    bool is_read = read_open(&reading, error);
    close(reading.file);
    *mesh = is_read ? reading.mesh : NULL;
    if (progress) {
        progress->end(progress->context);
    }
    return is_read;
}
