/**
 * @file
 * @brief The mesh module: reading of mesh files by assimp, all formats but OBJ.
 *
 * Part of `dioptre-meshes.so` and not of the program. It runs in a worker process; the program
 * checks its results again.
 */
#include "assets/meshes/mesh_plugin.h"

#include <assimp/cfileio.h>
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <libintl.h>
#include <stdio.h>
#include <string.h>

/** Size of the file name for assimp, such as `model.ply`. */
enum { NAME_SIZE = 32 };
/** Fraction of the work that reading the file takes. */
#define READ_FRACTION 0.5
/** Number of triangles between two reports of progress. */
enum { PROGRESS_INTERVAL = 4096 };

/** The file in memory, the only one that assimp can open. */
typedef struct MemoryFile {
    char name[NAME_SIZE]; /**< Name for assimp. */
    const char *bytes;    /**< Its bytes. */
    size_t size;          /**< Number of bytes. */
    size_t offset;        /**< Current position. */
    const MeshSink *sink; /**< Receives the progress. */
    struct aiFile file;   /**< The callbacks for assimp. */
} MemoryFile;

/** @return The file of an assimp file. */
static MemoryFile *memory_file_of(struct aiFile *file) {
    return (MemoryFile *)(void *)file->UserData;
}

/** Reads from the current position. See aiFileReadProc. @return Number of whole items read. */
static size_t read_bytes(struct aiFile *file, char *to, size_t size, size_t count) {
    MemoryFile *memory = memory_file_of(file);
    size_t left = memory->size - memory->offset;
    size_t pieces = size ? left / size : 0;
    pieces = pieces < count ? pieces : count;
    memcpy(to, memory->bytes + memory->offset, pieces * size);
    memory->offset += pieces * size;
    double fraction = (double)memory->offset / (double)(memory->size + 1);
    memory->sink->report_progress(memory->sink->context, READ_FRACTION * fraction);
    return pieces;
}

/** Writes nothing. See aiFileWriteProc. @return 0 */
static size_t write_nothing(struct aiFile *file, const char *from, size_t size, size_t count) {
    (void)file, (void)from, (void)size, (void)count;
    return 0;
}

/** @return Current position. See aiFileTellProc. */
static size_t tell_offset(struct aiFile *file) {
    return memory_file_of(file)->offset;
}

/** @return Size of the file. See aiFileTellProc. */
static size_t tell_size(struct aiFile *file) {
    return memory_file_of(file)->size;
}

/**
 * Sets the current position. See aiFileSeek.
 * @param file    The file.
 * @param offset  Offset, in bytes.
 * @param origin  Start, current position or end.
 * @return Whether the position is in the file.
 */
static enum aiReturn seek_to(struct aiFile *file, size_t offset, enum aiOrigin origin) {
    MemoryFile *memory = memory_file_of(file);
    size_t start = origin == aiOrigin_SET   ? 0
                   : origin == aiOrigin_CUR ? memory->offset
                                            : memory->size;
    size_t position = start + offset; // Unsigned wrap-around makes negative offsets correct, too.
    if (position > memory->size) {
        return aiReturn_FAILURE;
    }
    memory->offset = position;
    return aiReturn_SUCCESS;
}

/** Does nothing. See aiFileFlushProc. */
static void flush_nothing(struct aiFile *file) {
    (void)file;
}

/**
 * Opens the mesh file, and no other. See aiFileOpenProc.
 * @param system  The file system of assimp.
 * @param name    Name of the file.
 * @param mode    Unused.
 * @return The file, or NULL.
 */
static struct aiFile *open_model(struct aiFileIO *system, const char *name, const char *mode) {
    (void)mode;
    MemoryFile *memory = (MemoryFile *)(void *)system->UserData;
    memory->offset = 0;
    return strcmp(name, memory->name) == 0 ? &memory->file : NULL;
}

/** Closes nothing. See aiFileCloseProc. */
static void close_nothing(struct aiFileIO *system, struct aiFile *file) {
    (void)system, (void)file;
}

/** Sets the message of a result, as one line. @return false, always. */
static bool set_failure(MeshImportResult *result, const char *words) {
    snprintf(result->message, sizeof result->message, "%s", words);
    for (char *c = result->message; *c; c++) {
        *c = *c == '\n' || *c == '\r' ? ' ' : *c;
    }
    return false;
}

/** Sets the message of a result to assimp's error. @return false, always. */
static bool set_import_failure(MeshImportResult *result) {
    const char *words = aiGetErrorString();
    if (strstr(words, "bad_alloc")) {
        return set_failure(result, gettext("it needs more memory than a model may take"));
    }
    return set_failure(
        result, words[0] ? words : gettext("the library that reads models does not say why not"));
}

/**
 * Imports a file with assimp.
 * @param memory   The file.
 * @param is_glTF  Whether it is glTF, whose meshes are transformed by a tree of nodes.
 * @return The scene, to be released; NULL with a message in aiGetErrorString.
 */
static const struct aiScene *import(MemoryFile *memory, bool is_glTF) {
    memory->file = (struct aiFile){.ReadProc = read_bytes,
                                   .WriteProc = write_nothing,
                                   .TellProc = tell_offset,
                                   .FileSizeProc = tell_size,
                                   .SeekProc = seek_to,
                                   .FlushProc = flush_nothing,
                                   .UserData = (void *)memory};
    struct aiFileIO system = {
        .OpenProc = open_model, .CloseProc = close_nothing, .UserData = (void *)memory};
    return aiImportFileEx(memory->name, is_glTF ? aiProcess_PreTransformVertices : 0, &system);
}

/**
 * @return Number of triangles of a scene.
 * @param scene            The scene.
 * @param counts_polygons  Whether polygons count, as the triangles that they consist of.
 */
static size_t count_triangles(const struct aiScene *scene, bool counts_polygons) {
    size_t count = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        const struct aiMesh *mesh = scene->mMeshes[i];
        for (unsigned j = 0; j < mesh->mNumFaces; j++) {
            unsigned corners = mesh->mFaces[j].mNumIndices;
            count += corners == 3 ? 1 : counts_polygons && corners > 3 ? corners - 2 : 0;
        }
    }
    return count;
}

/**
 * @return A corner of a triangle.
 * @param mesh  The mesh.
 * @param i     Index of the vertex.
 */
static MeshCorner corner_of(const struct aiMesh *mesh, unsigned i) {
    struct aiVector3D position = mesh->mVertices[i];
    MeshCorner corner = {.position = {(double)position.x, (double)position.y, (double)position.z},
                         .has_normal = mesh->mNormals != NULL,
                         .has_uv = mesh->mTextureCoords[0] != NULL};
    if (corner.has_normal) {
        struct aiVector3D normal = mesh->mNormals[i];
        corner.normal[0] = (double)normal.x;
        corner.normal[1] = (double)normal.y;
        corner.normal[2] = (double)normal.z;
    }
    if (corner.has_uv) {
        corner.uv[0] = (double)mesh->mTextureCoords[0][i].x;
        corner.uv[1] = (double)mesh->mTextureCoords[0][i].y;
    }
    return corner;
}

/**
 * Passes a triangle to the sink.
 * @return false if its indices are invalid, or if the sink stops.
 */
static bool emit_triangle(const struct aiMesh *mesh, const struct aiFace *face,
                          const MeshSink *sink, MeshImportResult *result) {
    MeshCorner corners[3];
    for (int k = 0; k < 3; k++) {
        if (face->mIndices[k] >= mesh->mNumVertices) {
            return set_failure(result, gettext("a face names a vertex that is not there"));
        }
        corners[k] = corner_of(mesh, face->mIndices[k]);
    }
    return sink->add_triangle(sink->context, corners);
}

/** Passes all triangles to the sink. @return Whether the sink took all. */
static bool emit_triangles(const struct aiScene *scene, const MeshSink *sink,
                           MeshImportResult *result) {
    size_t total = count_triangles(scene, false), done = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        const struct aiMesh *mesh = scene->mMeshes[i];
        for (unsigned j = 0; j < mesh->mNumFaces; j++) {
            const struct aiFace *face = &mesh->mFaces[j];
            if (face->mNumIndices != 3) {
                continue;
            }
            if (!emit_triangle(mesh, face, sink, result)) {
                return false;
            }
            if (++done % PROGRESS_INTERVAL == 0) {
                double fraction = (double)done / (double)total;
                sink->report_progress(sink->context,
                                      READ_FRACTION + (1 - READ_FRACTION) * fraction);
            }
        }
    }
    return true;
}

/**
 * Triangulates the polygons of a scene and passes all triangles to the sink.
 * @param scene        The scene.
 * @param sink         Receives the triangles.
 * @param[out] result  Defects and errors.
 * @return Whether the sink took all.
 */
static bool triangulate_and_emit(const struct aiScene *scene, const MeshSink *sink,
                                 MeshImportResult *result) {
    size_t expected = count_triangles(scene, true);
    const struct aiScene *triangulated = aiApplyPostProcessing(scene, aiProcess_Triangulate);
    if (!triangulated) { // assimp has released it.
        return set_import_failure(result);
    }
    size_t found = count_triangles(triangulated, false);
    result->untriangulated_polygons = found < expected ? expected - found : 0;
    bool is_done = emit_triangles(triangulated, sink, result);
    aiReleaseImport(triangulated);
    return is_done;
}

/**
 * Implements #MeshPlugin.read: reads a mesh file and passes its triangles to the sink.
 * @param source       The file.
 * @param sink         Receives the triangles.
 * @param[out] result  Defects and errors.
 * @return Whether the sink took all.
 */
static bool read_model(const MeshSource *source, const MeshSink *sink, MeshImportResult *result) {
    *result = (MeshImportResult){0};
    bool is_glTF = strncmp(source->extension, "gl", 2) == 0;
    MemoryFile memory = {.bytes = source->bytes, .size = source->size, .sink = sink};
    snprintf(memory.name, sizeof memory.name, "model.%s", source->extension);
    const struct aiScene *scene = import(&memory, is_glTF);
    return scene ? triangulate_and_emit(scene, sink, result) : set_import_failure(result);
}

/** The exported symbol of the module: #MESH_PLUGIN_SYMBOL. */
__attribute__((visibility("default"))) extern const MeshPlugin dioptre_mesh_plugin;
const MeshPlugin dioptre_mesh_plugin = {.version = MESH_PLUGIN_VERSION, .read = read_model};
