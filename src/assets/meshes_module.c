/**
 * @file
 * @brief The model module: assimp behind a border of our own.
 *
 * Part of `dioptre-meshes.so` and not of the program. It runs in a child process, and what it hands
 * over is looked at there and again outside.
 */
#include "assets/meshes_module.h"

#include <assimp/cfileio.h>
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <ctype.h>
#include <libintl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Bytes of the name that assimp is given for the file, such as `model.obj`. */
enum { NAME_SIZE = 32 };
/** How much of the whole work it is to read the file. */
#define READING_SHARE 0.5
/** Triangles that are handed over between two tellings. */
enum { TELLING_PERIOD = 4096 };

/** The file as assimp sees it, and the only one that it can see. */
typedef struct ModelFile {
    char name[NAME_SIZE];   /**< What assimp calls it. */
    const char *bytes;      /**< Its bytes. */
    size_t size;            /**< How many. */
    size_t offset;          /**< What is read next. */
    const MeshesSink *sink; /**< Who is told how far it is. */
    struct aiFile file;     /**< The same in assimp's words. */
} ModelFile;

/** @return The model file behind one of assimp's. @param file The file. */
static ModelFile *model_of(struct aiFile *file) {
    return (ModelFile *)(void *)file->UserData;
}

/** Reads on. See aiFileReadProc. @param file The file. @param[out] to Where to. @param size Bytes a
 *  piece. @param count How many pieces. @return How many whole pieces there were. */
static size_t read_bytes(struct aiFile *file, char *to, size_t size, size_t count) {
    ModelFile *model = model_of(file);
    size_t left = model->size - model->offset;
    size_t pieces = size ? left / size : 0;
    pieces = pieces < count ? pieces : count;
    memcpy(to, model->bytes + model->offset, pieces * size);
    model->offset += pieces * size;
    double share = (double)model->offset / (double)(model->size + 1);
    model->sink->tell(model->sink->context, READING_SHARE * share);
    return pieces;
}

/** Writes nothing. See aiFileWriteProc. @param file Not used. @param from Not used. @param size Not
 *  used. @param count Not used. @return 0 */
static size_t write_nothing(struct aiFile *file, const char *from, size_t size, size_t count) {
    (void)file, (void)from, (void)size, (void)count;
    return 0;
}

/** @return What is read next. See aiFileTellProc. @param file The file. */
static size_t tell_offset(struct aiFile *file) {
    return model_of(file)->offset;
}

/** @return Its bytes. See aiFileTellProc. @param file The file. */
static size_t tell_size(struct aiFile *file) {
    return model_of(file)->size;
}

/** Goes elsewhere in the file. See aiFileSeek. @param file The file. @param offset How far.
 *  @param origin From where; backwards from the end too. @return Whether there is such a place. */
static enum aiReturn seek_to(struct aiFile *file, size_t offset, enum aiOrigin origin) {
    ModelFile *model = model_of(file);
    size_t start = origin == aiOrigin_SET   ? 0
                   : origin == aiOrigin_CUR ? model->offset
                                            : model->size;
    size_t place = start + offset; // Unsigned, and so right for steps back, too.
    if (place > model->size) {
        return aiReturn_FAILURE;
    }
    model->offset = place;
    return aiReturn_SUCCESS;
}

/** Does nothing. See aiFileFlushProc. @param file Not used. */
static void flush_nothing(struct aiFile *file) {
    (void)file;
}

/** Opens the model file, and no other. See aiFileOpenProc. @param system Where it is known.
 *  @param name What is asked for. @param mode Not used. @return The file, or NULL. */
static struct aiFile *open_model(struct aiFileIO *system, const char *name, const char *mode) {
    (void)mode;
    ModelFile *model = (ModelFile *)(void *)system->UserData;
    model->offset = 0;
    return strcmp(name, model->name) == 0 ? &model->file : NULL;
}

/** Closes nothing. See aiFileCloseProc. @param system Not used. @param file Not used. */
static void close_nothing(struct aiFileIO *system, struct aiFile *file) {
    (void)system, (void)file;
}

/**
 * Puts words into a report, in one line.
 * @param[out] report  The report.
 * @param words        The words.
 * @return false, always.
 */
static bool fail(MeshesReport *report, const char *words) {
    snprintf(report->message, sizeof report->message, "%s", words);
    for (char *c = report->message; *c; c++) {
        *c = *c == '\n' || *c == '\r' ? ' ' : *c;
    }
    return false;
}

/**
 * Puts into a report what assimp says is wrong.
 * @param[out] report  The report.
 * @return false, always.
 */
static bool fail_import(MeshesReport *report) {
    const char *words = aiGetErrorString();
    if (strstr(words, "bad_alloc")) {
        return fail(report, gettext("it needs more memory than a model may take"));
    }
    return fail(report,
                words[0] ? words : gettext("the library that reads models does not say why not"));
}

/**
 * @return Whether a number begins with its decimal point at a place.
 * @param source  The text.
 * @param i       The place.
 */
static bool is_bare_point(const MeshesSource *source, size_t i) {
    const char *bytes = source->bytes;
    if (bytes[i] != '.' || i == 0 || i + 1 >= source->size) {
        return false;
    }
    char before = bytes[i - 1];
    bool is_start = before == ' ' || before == '\t' || before == '-' || before == '+';
    return is_start && isdigit((unsigned char)bytes[i + 1]);
}

/**
 * Writes a nought before each number that begins with its decimal point. assimp 5.2 does not count
 * them as numbers in an OBJ file, and leaves the whole vertex out.
 * @param source     The text.
 * @param[out] size  Bytes of the new one.
 * @return The new text, to be freed; NULL without memory.
 */
static char *complete_numbers(const MeshesSource *source, size_t *size) {
    size_t count = 0;
    for (size_t i = 0; i < source->size; i++) {
        count += is_bare_point(source, i);
    }
    char *text = malloc(source->size + count + 1);
    char *next = text;
    for (size_t i = 0; text && i < source->size; i++) {
        if (is_bare_point(source, i)) {
            *next++ = '0';
        }
        *next++ = source->bytes[i];
    }
    *size = source->size + count;
    return text;
}

/**
 * Has assimp read a file.
 * @param model        The file.
 * @param is_glTF      Whether its parts are placed by a tree of nodes.
 * @return What it made of it, to be released; NULL with words in aiGetErrorString.
 */
static const struct aiScene *import(ModelFile *model, bool is_glTF) {
    model->file = (struct aiFile){.ReadProc = read_bytes,
                                  .WriteProc = write_nothing,
                                  .TellProc = tell_offset,
                                  .FileSizeProc = tell_size,
                                  .SeekProc = seek_to,
                                  .FlushProc = flush_nothing,
                                  .UserData = (void *)model};
    struct aiFileIO system = {
        .OpenProc = open_model, .CloseProc = close_nothing, .UserData = (void *)model};
    return aiImportFileEx(model->name, is_glTF ? aiProcess_PreTransformVertices : 0, &system);
}

/**
 * @return How many triangles a model has.
 * @param scene     The model.
 * @param is_whole  Whether polygons count as those that they can be cut into.
 */
static size_t count_triangles(const struct aiScene *scene, bool is_whole) {
    size_t count = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        const struct aiMesh *mesh = scene->mMeshes[i];
        for (unsigned j = 0; j < mesh->mNumFaces; j++) {
            unsigned corners = mesh->mFaces[j].mNumIndices;
            count += corners == 3 ? 1 : is_whole && corners > 3 ? corners - 2 : 0;
        }
    }
    return count;
}

/**
 * @return One corner.
 * @param mesh  What it is a corner of.
 * @param i     Its place there.
 */
static MeshesCorner corner_of(const struct aiMesh *mesh, unsigned i) {
    struct aiVector3D at = mesh->mVertices[i];
    MeshesCorner corner = {.position = {(double)at.x, (double)at.y, (double)at.z},
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
 * Hands a triangle over.
 * @param mesh         What it is in.
 * @param face         Its corners, three.
 * @param sink         Who takes it.
 * @param[out] report  What is wrong.
 * @return false if it names a corner that is not there, or no more is wanted.
 */
static bool hand_over(const struct aiMesh *mesh, const struct aiFace *face, const MeshesSink *sink,
                      MeshesReport *report) {
    MeshesCorner corners[3];
    for (int k = 0; k < 3; k++) {
        if (face->mIndices[k] >= mesh->mNumVertices) {
            return fail(report, gettext("a face names a vertex that is not there"));
        }
        corners[k] = corner_of(mesh, face->mIndices[k]);
    }
    return sink->add(sink->context, corners);
}

/**
 * Hands all triangles over.
 * @param scene        The model.
 * @param sink         Who takes them.
 * @param[out] report  What is wrong.
 * @return Whether all were taken.
 */
static bool hand_all_over(const struct aiScene *scene, const MeshesSink *sink,
                          MeshesReport *report) {
    size_t total = count_triangles(scene, false), done = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        const struct aiMesh *mesh = scene->mMeshes[i];
        for (unsigned j = 0; j < mesh->mNumFaces; j++) {
            const struct aiFace *face = &mesh->mFaces[j];
            if (face->mNumIndices != 3) {
                continue;
            }
            if (!hand_over(mesh, face, sink, report)) {
                return false;
            }
            if (++done % TELLING_PERIOD == 0) {
                double share = (double)done / (double)total;
                sink->tell(sink->context, READING_SHARE + (1 - READING_SHARE) * share);
            }
        }
    }
    return true;
}

/**
 * Cuts the polygons of a model into triangles and hands all over.
 * @param scene        The model; released.
 * @param sink         Who takes them.
 * @param[out] report  What went otherwise than it should.
 * @return Whether all were taken.
 */
static bool take_apart(const struct aiScene *scene, const MeshesSink *sink, MeshesReport *report) {
    size_t wanted = count_triangles(scene, true);
    const struct aiScene *cut = aiApplyPostProcessing(scene, aiProcess_Triangulate);
    if (!cut) { // assimp has released it.
        return fail_import(report);
    }
    size_t found = count_triangles(cut, false);
    report->uncut = found < wanted ? wanted - found : 0;
    bool is_done = hand_all_over(cut, sink, report);
    aiReleaseImport(cut);
    return is_done;
}

/**
 * Is MeshesModule::read: reads a model and hands its triangles over.
 * @param source       The file.
 * @param sink         Who takes the triangles.
 * @param[out] report  What went otherwise than it should.
 * @return Whether all were handed over.
 */
static bool read_model(const MeshesSource *source, const MeshesSink *sink, MeshesReport *report) {
    *report = (MeshesReport){0};
    bool is_text = strcmp(source->ending, "obj") == 0;
    bool is_glTF = strncmp(source->ending, "gl", 2) == 0;
    ModelFile model = {.bytes = source->bytes, .size = source->size, .sink = sink};
    snprintf(model.name, sizeof model.name, "model.%s", source->ending);
    char *text = is_text ? complete_numbers(source, &model.size) : NULL;
    if (is_text && !text) {
        return fail(report, gettext("it needs more memory than a model may take"));
    }
    model.bytes = text ? text : model.bytes;
    const struct aiScene *scene = import(&model, is_glTF);
    bool is_done = scene ? take_apart(scene, sink, report) : fail_import(report);
    free(text);
    return is_done;
}

/** The one thing of the module that is seen from outside: #MESHES_MODULE_SYMBOL. */
__attribute__((visibility("default"))) extern const MeshesModule dioptre_meshes_module;
const MeshesModule dioptre_meshes_module = {.version = MESHES_MODULE_VERSION, .read = read_model};
