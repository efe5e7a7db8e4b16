/**
 * @file
 * @brief Reading of OBJ files: the triangles of a text.
 *
 * The text is read twice: vertices first, then faces, because a face may name a vertex that follows
 * it. A vertex that is not understood keeps its number and is not a number (NaN), so that those
 * behind it keep theirs; a face that names it is refused.
 */
#include "assets/meshes/obj_reader.h"

#include "assets/meshes/obj_text.h"
#include "assets/meshes/triangulate.h"
#include "base/language.h"
#include "dioptre/parameter.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** First capacity of arrays. */
enum { FIRST_CAPACITY = 1024 };
/** Number of statements between two reports of progress. */
enum { PROGRESS_INTERVAL = 4096 };
/** Fraction of the work that reading the vertices takes. */
#define VERTEX_FRACTION 0.3
/** No index. */
#define NO_INDEX SIZE_MAX

/** Kinds of statements. */
typedef enum {
    STATEMENT_EMPTY,    /**< No words. */
    STATEMENT_POSITION, /**< `v` */
    STATEMENT_UV,       /**< `vt` */
    STATEMENT_NORMAL,   /**< `vn` */
    STATEMENT_FACE,     /**< `f` */
    STATEMENT_HARMLESS, /**< Known, and without triangles. */
    STATEMENT_UNKNOWN   /**< Not known, or a surface that is not a polygon. */
} Statement;

/** Kinds of what a corner of a face names, in the order of a reference `v/vt/vn`. */
typedef enum { VERTEX_POSITION, VERTEX_UV, VERTEX_NORMAL, VERTEX_KINDS } VertexKind;

/** Vertices of a kind. */
typedef struct ObjVertices {
    int required;     /**< Smallest number of numbers of a vertex. */
    int dimension;    /**< Largest number of numbers; more are ignored, missing ones are 0. */
    double *numbers;  /**< The numbers, #dimension per vertex; owned. */
    size_t count;     /**< Number of vertices. */
    size_t capacity;  /**< Capacity of #numbers, in vertices. */
    size_t preceding; /**< Number of vertices before the current statement, in the second pass. */
} ObjVertices;

/** A corner of a face: an index of each kind, or #NO_INDEX. */
typedef struct ObjCorner {
    size_t index[VERTEX_KINDS]; /**< The indices. */
} ObjCorner;

/** A face, and memory for its triangulation. */
typedef struct ObjFace {
    size_t count;        /**< Number of corners. */
    size_t capacity;     /**< Capacity of all arrays, in corners. */
    ObjCorner *corners;  /**< Its corners; owned. */
    Vec3d *positions;    /**< Their positions; owned. */
    uint32_t *work;      /**< An index per corner; owned. */
    uint32_t *triangles; /**< Three indices per corner; owned. */
} ObjFace;

/** A text being read. */
typedef struct ObjReader {
    ObjText text;                       /**< Current position. */
    ObjText start;                      /**< Position of the first statement. */
    size_t size;                        /**< Bytes of the text, at least 1. */
    size_t line;                        /**< First line of the current statement. */
    size_t statement_count;             /**< Number of statements read, in both passes. */
    ObjVertices vertices[VERTEX_KINDS]; /**< The vertices. */
    ObjFace face;                       /**< The current face. */
    const MeshSink *sink;               /**< Receives the triangles. */
    MeshRepairs *repairs;               /**< Receives what is left out. */
    Error *error;                       /**< What is wrong; not owned. */
} ObjReader;

// --- errors --------------------------------------------------------------------------------------

/** Sets the error that memory is exhausted. @return false, always. */
static bool set_out_of_memory(const ObjReader *reader) {
    return error_set(reader->error, STATUS_SCENE, "it needs more memory than a model may take");
}

/** Counts a statement that is left out. */
static void count_skipped(const ObjReader *reader) {
    MeshRepairs *repairs = reader->repairs;
    bool is_first = repairs->skipped_statements == 0 || reader->line < repairs->skipped_line;
    repairs->skipped_line = is_first ? reader->line : repairs->skipped_line;
    repairs->skipped_statements++;
}

// --- statements ----------------------------------------------------------------------------------

/** Words of statements. */
static const struct {
    const char *word;    /**< The word. */
    Statement statement; /**< Its kind. */
} words[] = {
    {"v", STATEMENT_POSITION},
    {"f", STATEMENT_FACE},
    {"vn", STATEMENT_NORMAL},
    {"vt", STATEMENT_UV},
    {"fo", STATEMENT_FACE}, // The word of version 2 for faces.
    {"g", STATEMENT_HARMLESS},
    {"o", STATEMENT_HARMLESS},
    {"s", STATEMENT_HARMLESS}, // The scene says what is smooth.
    {"usemtl", STATEMENT_HARMLESS},
    {"mtllib", STATEMENT_HARMLESS},
    {"l", STATEMENT_HARMLESS},
    {"p", STATEMENT_HARMLESS},
    {"vp", STATEMENT_HARMLESS}, // Used by curves and curved surfaces, which are counted.
    {"mg", STATEMENT_HARMLESS},
    {"usemap", STATEMENT_HARMLESS},
    {"maplib", STATEMENT_HARMLESS},
    {"bevel", STATEMENT_HARMLESS},
    {"c_interp", STATEMENT_HARMLESS},
    {"d_interp", STATEMENT_HARMLESS},
    {"lod", STATEMENT_HARMLESS},
    {"shadow_obj", STATEMENT_HARMLESS},
    {"trace_obj", STATEMENT_HARMLESS},
};

/** Reads the first word of a statement. @return Its kind. */
static Statement read_statement(ObjReader *reader) {
    if (obj_text_is_at_end(&reader->text)) {
        return STATEMENT_EMPTY;
    }
    reader->line = reader->text.line;
    ObjWord word = obj_text_word(&reader->text);
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        if (strlen(words[i].word) == word.length &&
            memcmp(words[i].word, word.start, word.length) == 0) {
            return words[i].statement;
        }
    }
    return STATEMENT_UNKNOWN;
}

/** Reports progress now and then. @param done Completed fraction before this pass. @param part
 *  Fraction of the work of this pass. */
static void report_progress(ObjReader *reader, double done, double part) {
    if (++reader->statement_count % PROGRESS_INTERVAL == 0) {
        size_t left = (size_t)(reader->text.end - reader->text.next);
        double fraction = 1 - (double)left / (double)reader->size;
        reader->sink->report_progress(reader->sink->context, done + part * fraction);
    }
}

// --- vertices ------------------------------------------------------------------------------------

/** Reserves memory for one more vertex. @return false without memory. */
static bool grow_vertices(ObjVertices *vertices) {
    if (vertices->count == vertices->capacity) {
        size_t capacity = vertices->capacity ? 2 * vertices->capacity : FIRST_CAPACITY;
        size_t size = (size_t)vertices->dimension * sizeof *vertices->numbers;
        double *resized = realloc(vertices->numbers, capacity * size);
        vertices->numbers = resized ? resized : vertices->numbers;
        vertices->capacity = resized ? capacity : vertices->capacity;
    }
    return vertices->count < vertices->capacity;
}

/**
 * Reads a vertex. A weight or a colour behind a position is ignored, as is the depth of a texture.
 * @return false without memory.
 */
static bool read_vertex(ObjReader *reader, VertexKind kind) {
    ObjVertices *vertices = &reader->vertices[kind];
    if (!grow_vertices(vertices)) {
        return set_out_of_memory(reader);
    }
    double *numbers = vertices->numbers + (size_t)vertices->dimension * vertices->count++;
    bool is_valid = true;
    for (int i = 0; i < vertices->dimension; i++) {
        numbers[i] = 0;
        is_valid =
            is_valid &&
            ((i >= vertices->required && obj_text_is_at_end(&reader->text)) ||
             (obj_text_number(&reader->text, &numbers[i]) && fabs(numbers[i]) <= LENGTH_MAXIMUM));
    }
    if (!is_valid) {
        numbers[0] = (double)NAN; // A float, of which clang warns.
        count_skipped(reader);
    }
    return true;
}

/** Reads all vertices, and counts what is not understood. @return false without memory. */
static bool read_vertices(ObjReader *reader) {
    static const VertexKind kinds[] = {[STATEMENT_POSITION] = VERTEX_POSITION,
                                       [STATEMENT_UV] = VERTEX_UV,
                                       [STATEMENT_NORMAL] = VERTEX_NORMAL};
    bool is_read = true;
    reader->text = reader->start;
    while (is_read && reader->text.next < reader->text.end) {
        Statement statement = read_statement(reader);
        if (statement == STATEMENT_UNKNOWN) {
            count_skipped(reader);
        } else if (statement >= STATEMENT_POSITION && statement <= STATEMENT_NORMAL) {
            is_read = read_vertex(reader, kinds[statement]);
        }
        obj_text_next_statement(&reader->text);
        report_progress(reader, 0, VERTEX_FRACTION);
    }
    return is_read;
}

/** @return The line of a position. @param index Its index. */
static size_t line_of_position(const ObjReader *reader, size_t index) {
    ObjReader search = *reader;
    size_t count = 0;
    search.text = search.start;
    while (search.text.next < search.text.end) {
        count += read_statement(&search) == STATEMENT_POSITION;
        if (count == index + 1) {
            break;
        }
        obj_text_next_statement(&search.text);
    }
    return search.line;
}

// --- faces ---------------------------------------------------------------------------------------

/**
 * Changes the capacity of an array.
 * @param[in,out] array  The array.
 * @param size           Bytes of its new capacity.
 * @return false without memory.
 */
static bool resize(void *array, size_t size) {
    void *old, *resized;
    memcpy(&old, array, sizeof old);
    resized = realloc(old, size);
    if (resized) {
        memcpy(array, &resized, sizeof resized);
    }
    return resized != NULL;
}

/** Reserves memory for one more corner. @return false without memory. */
static bool grow_face(ObjFace *face) {
    if (face->count < face->capacity) {
        return true;
    }
    size_t capacity = face->capacity ? 2 * face->capacity : FIRST_CAPACITY;
    bool has_memory = capacity <= UINT32_MAX / 3 &&
                      resize(&face->corners, capacity * sizeof *face->corners) &&
                      resize(&face->positions, capacity * sizeof *face->positions) &&
                      resize(&face->work, capacity * sizeof *face->work) &&
                      resize(&face->triangles, 3 * capacity * sizeof *face->triangles);
    face->capacity = has_memory ? capacity : face->capacity;
    return has_memory;
}

/** Sets the error of an index. @return false, always. */
static bool set_index_error(const ObjReader *reader, VertexKind kind, ObjWord word) {
    static const char *const formats[VERTEX_KINDS] = {
        N_("a face names vertex %.*s, but there are %zu"),
        N_("a face names (u, v) %.*s, but there are %zu"),
        N_("a face names normal %.*s, but there are %zu")};
    /** Digits of an index that are shown. */
    enum { SHOWN_DIGITS = 24 };
    const ObjVertices *vertices = &reader->vertices[kind];
    bool is_relative = word.start[0] == '-';
    error_set(reader->error, STATUS_SCENE, formats[kind],
              word.length < SHOWN_DIGITS ? (int)word.length : SHOWN_DIGITS, word.start,
              is_relative ? vertices->preceding : vertices->count);
    return error_set_line(reader->error, reader->line);
}

/**
 * Reads an index of a corner, if there is one. A positive one counts from the first vertex of the
 * file, a negative one back from the statement.
 * @return false if it names no vertex.
 */
static bool read_index(ObjReader *reader, VertexKind kind, size_t *index) {
    const ObjVertices *vertices = &reader->vertices[kind];
    ObjWord word = {.start = reader->text.next};
    long long number;
    if (!obj_text_index(&reader->text, &number) ||
        (kind != VERTEX_POSITION && vertices->count == 0)) {
        return true; // Normals and (u, v) may have been stripped from the file.
    }
    word.length = (size_t)(reader->text.next - word.start);
    if (number > 0 && (unsigned long long)number <= vertices->count) {
        *index = (size_t)number - 1;
    } else if (number < 0 && (unsigned long long)-number <= vertices->preceding) {
        *index = vertices->preceding - (size_t)-number;
    } else {
        return set_index_error(reader, kind, word);
    }
    return true;
}

/** Sets the error of a corner that is not a reference. @return false, always. */
static bool set_corner_error(const ObjReader *reader, ObjText at) {
    /** Bytes of a word that are shown. */
    enum { SHOWN_BYTES = 40 };
    ObjWord word = obj_text_word(&at);
    error_set(reader->error, STATUS_SCENE,
              "`%.*s` is no corner of a face, such as 1, 1/2, 1//3 or 1/2/3",
              word.length < SHOWN_BYTES ? (int)word.length : SHOWN_BYTES, word.start);
    return error_set_line(reader->error, reader->line);
}

/** Sets the error of a face with a position that is not understood. @return false, always. */
static bool set_position_error(const ObjReader *reader, size_t index) {
    error_set(reader->error, STATUS_SCENE,
              "a vertex of a face needs three numbers, finite and at most %g", LENGTH_MAXIMUM);
    return error_set_line(reader->error, line_of_position(reader, index));
}

/** Reads a corner of a face: v, v/vt, v//vn or v/vt/vn. @return false if it is none. */
static bool read_corner(ObjReader *reader) {
    ObjFace *face = &reader->face;
    ObjText start = reader->text;
    if (!grow_face(face)) {
        return set_out_of_memory(reader);
    }
    ObjCorner *corner = &face->corners[face->count];
    *corner = (ObjCorner){{NO_INDEX, NO_INDEX, NO_INDEX}};
    for (int kind = 0; kind < VERTEX_KINDS; kind++) {
        if (kind > 0 && !obj_text_slash(&reader->text)) {
            break;
        }
        if (!read_index(reader, (VertexKind)kind, &corner->index[kind])) {
            return false;
        }
    }
    if (corner->index[VERTEX_POSITION] == NO_INDEX || !obj_text_is_word_end(&reader->text)) {
        return set_corner_error(reader, start);
    }
    const double *p =
        reader->vertices[VERTEX_POSITION].numbers + 3 * corner->index[VERTEX_POSITION];
    if (isnan(p[0])) {
        return set_position_error(reader, corner->index[VERTEX_POSITION]);
    }
    face->positions[face->count++] = (Vec3d){p[0], p[1], p[2]};
    return true;
}

/** @return A corner of a triangle. */
static MeshCorner mesh_corner_of(const ObjReader *reader, size_t index) {
    const ObjCorner *corner = &reader->face.corners[index];
    Vec3d position = reader->face.positions[index];
    size_t uv = corner->index[VERTEX_UV], normal = corner->index[VERTEX_NORMAL];
    MeshCorner result = {.position = {position.x, position.y, position.z},
                         .has_normal = normal != NO_INDEX,
                         .has_uv = uv != NO_INDEX};
    if (result.has_normal) {
        memcpy(result.normal, reader->vertices[VERTEX_NORMAL].numbers + 3 * normal,
               sizeof result.normal);
    }
    if (result.has_uv) {
        memcpy(result.uv, reader->vertices[VERTEX_UV].numbers + 2 * uv, sizeof result.uv);
    }
    return result;
}

/** Passes the triangles of a face to the sink. @return Whether the sink took all. */
static bool emit_face(ObjReader *reader) {
    static const uint32_t single[] = {0, 1, 2};
    ObjFace *face = &reader->face;
    const uint32_t *triangles = single;
    size_t count = 1;
    if (face->count > 3) {
        size_t missing;
        count = triangulate_polygon(face->positions, face->count, face->triangles, face->work,
                                    &missing);
        reader->repairs->untriangulated_polygons += missing;
        // Vertices on a straight line and repeated ones.
        reader->repairs->degenerate_triangles += face->count - 2 - count - missing;
        triangles = face->triangles;
    }
    for (size_t i = 0; i < count; i++) {
        MeshCorner corners[3];
        for (size_t k = 0; k < 3; k++) {
            corners[k] = mesh_corner_of(reader, triangles[3 * i + k]);
        }
        if (!reader->sink->add_triangle(reader->sink->context, corners)) {
            return false;
        }
    }
    return true;
}

/** Reads a face and passes its triangles to the sink. @return false if the face is invalid, or if
 *  the sink stops. */
static bool read_face(ObjReader *reader) {
    bool is_read = true;
    reader->face.count = 0;
    while (is_read && !obj_text_is_at_end(&reader->text)) {
        is_read = read_corner(reader);
    }
    if (is_read && reader->face.count < 3) {
        count_skipped(reader);
        return true;
    }
    return is_read && emit_face(reader);
}

/** Reads all faces. @return false if one is invalid, or if the sink stops. */
static bool read_faces(ObjReader *reader) {
    bool is_read = true;
    reader->text = reader->start;
    while (is_read && reader->text.next < reader->text.end) {
        Statement statement = read_statement(reader);
        reader->vertices[VERTEX_POSITION].preceding += statement == STATEMENT_POSITION;
        reader->vertices[VERTEX_UV].preceding += statement == STATEMENT_UV;
        reader->vertices[VERTEX_NORMAL].preceding += statement == STATEMENT_NORMAL;
        is_read = statement != STATEMENT_FACE || read_face(reader);
        obj_text_next_statement(&reader->text);
        report_progress(reader, VERTEX_FRACTION, 1 - VERTEX_FRACTION);
    }
    return is_read;
}

// --- the file ------------------------------------------------------------------------------------

/** @return Whether a text begins with a byte order mark of UTF-16. */
static bool is_utf16(const char *text, size_t size) {
    return size >= 2 && (memcmp(text, "\xFE\xFF", 2) == 0 || memcmp(text, "\xFF\xFE", 2) == 0);
}

bool obj_read(const char *text, size_t size, const MeshSink *sink, MeshRepairs *repairs,
              Error *error) {
    ObjReader reader = {.start = obj_text_start(text, size),
                        .size = size + 1,
                        .vertices = {[VERTEX_POSITION] = {.required = 3, .dimension = 3},
                                     [VERTEX_UV] = {.required = 1, .dimension = 2},
                                     [VERTEX_NORMAL] = {.required = 3, .dimension = 3}},
                        .sink = sink,
                        .repairs = repairs,
                        .error = error};
    if (is_utf16(text, size)) {
        return error_set(error, STATUS_SCENE, "it is written in UTF-16; an OBJ file must be UTF-8");
    }
    bool is_read = read_vertices(&reader) && read_faces(&reader);
    for (int kind = 0; kind < VERTEX_KINDS; kind++) {
        free(reader.vertices[kind].numbers);
    }
    free(reader.face.corners);
    free(reader.face.positions);
    free(reader.face.work);
    free(reader.face.triangles);
    return is_read;
}
