/**
 * @file
 * @brief Scenes in NFF: its statements.
 *
 * The statements fill the structs of the scene language by its parameter tables, so that both have
 * the same limits. doc/scene-reference.md describes what each statement becomes.
 */
#include "script/nff.h"

#include "script/nff_polygons.h"
#include "script/nff_text.h"

#include <math.h>
#include <stdalign.h>
#include <stdlib.h>
#include <string.h>

/** Degrees to radians. */
#define RADIANS_PER_DEGREE (M_PI / 180)

/** Numbers of a fill colour: red, green, blue, Kd, Ks, Shine, T and the index of refraction. */
enum { FILL_NUMBERS = 8 };

/** Slots of the table of fill colours: a power of two. */
enum { FILL_SLOTS = 1 << 16 };

/** Share of light below which a surface counts as one that mirrors and transmits all of it. */
#define LOCAL_SHARE_MINIMUM 1e-9

/** Largest number of vertices of a polygon; also the limit of its indices. */
#define VERTICES_MAXIMUM 1e6

/** A fill colour that the text has named. */
typedef struct Fill {
    double numbers[FILL_NUMBERS]; /**< Its numbers. */
    size_t material;              /**< Index in #Scene.materials; 0: the slot is free. */
} Fill;

/** Reading of an NFF text. */
typedef struct NffReader {
    NffText text;         /**< What is left of it. */
    int line;             /**< Line of the current statement. */
    Scene *scene;         /**< The scene. */
    size_t material;      /**< Index of the current material. */
    Fill *fills;          /**< #FILL_SLOTS, a hash table; owned. Further ones are not shared. */
    NffPolygons polygons; /**< The polygons so far. */
    Error *error;         /**< Receives what is wrong. */
} NffReader;

/** Reads the numbers of a statement. @return Whether all are there. */
static bool read_numbers(NffReader *reader, const char *statement, size_t count, double *numbers) {
    return nff_text_numbers(&reader->text, statement, count, numbers, reader->error);
}

/* --- structs by their tables ------------------------------------------------------------------ */

/** The struct of a keyword. */
typedef struct KeywordValues {
    const Keyword *keyword;               /**< The keyword. */
    uint64_t given;                       /**< Bit i: row i of its table is set. */
    alignas(max_align_t) char bytes[512]; /**< The struct; larger than any. */
} KeywordValues;

/** @return The struct with its defaults. */
static KeywordValues values_of(const Keyword *keyword) {
    KeywordValues values = {.keyword = keyword};
    memcpy(values.bytes, keyword->defaults, keyword->size);
    return values;
}

/**
 * Sets a field, with the checks of the scene language.
 * @param name     The field; it must exist.
 * @param numbers  One number, or three for points, directions and colours.
 * @return Whether all are in range.
 */
static bool set_field(NffReader *reader, KeywordValues *values, const char *name,
                      const double *numbers) {
    int i = 0;
    const Parameter *rows = values->keyword->parameters;
    while (strcmp(rows[i].name, name) != 0) {
        i++;
    }
    void *field = values->bytes + rows[i].offset;
    bool is_number = rows[i].type == PARAMETER_NUMBER || rows[i].type == PARAMETER_INTEGER;
    int count = is_number ? 1 : 3;
    for (int k = 0; k < count; k++) {
        if (!parameter_check_range(&rows[i], numbers[k], reader->error)) {
            return false;
        }
    }
    values->given |= (uint64_t)1 << i;
    if (rows[i].type == PARAMETER_INTEGER) {
        *(int *)field = (int)numbers[0];
        return numbers[0] == floor(numbers[0]) ||
               error_set(reader->error, STATUS_SCENE, "%s must be a whole number, not %.14g", name,
                         numbers[0]);
    }
    memcpy(field, numbers, (size_t)count * sizeof *numbers);
    bool is_zero = count == 3 && numbers[0] == 0 && numbers[1] == 0 && numbers[2] == 0;
    return !(is_zero && rows[i].type == PARAMETER_DIRECTION) ||
           error_set(reader->error, STATUS_SCENE, "%s must not be zero: it says a direction", name);
}

/** Sets a colour to one number in all channels. See #set_field. */
static bool set_grey(NffReader *reader, KeywordValues *values, const char *name, double number) {
    return set_field(reader, values, name, (const double[]){number, number, number});
}

/** Checks the combination of fields. @return Whether it is valid. */
static bool finish(NffReader *reader, KeywordValues *values) {
    return !values->keyword->finish ||
           values->keyword->finish(values->bytes, values->given, reader->error);
}

/** Adds a shape of the current material. @return Whether it is valid, and in memory. */
static bool add_shape(NffReader *reader, KeywordValues *values) {
    Scene *scene = reader->scene;
    bool is_added = finish(reader, values) &&
                    scene_add_shape(scene, scene_shape_find(values->keyword->name), values->keyword,
                                    values->bytes, reader->material, reader->error);
    if (is_added) {
        scene->shapes[scene->shape_count - 1].origin.line = reader->line;
    }
    return is_added;
}

/** @return An empty shape. @param name Its keyword. */
static KeywordValues shape_values(const char *name) {
    return values_of(scene_shape_keywords[scene_shape_find(name)]);
}

/* --- view, background and lights ---------------------------------------------------------------
 */

/** Fields of `v`, in the order of #view_words. */
typedef struct View {
    double from[3];       /**< Position of the eye. */
    double at[3];         /**< A point in the middle of the picture. */
    double up[3];         /**< Up in the picture. */
    double angle[1];      /**< Degrees between the centres of the outermost columns. */
    double hither[1];     /**< Distance of the near plane, which rays do not need. */
    double resolution[2]; /**< Pixels. */
} View;

/** A field of `v`. */
typedef struct ViewWord {
    const char *name; /**< Its name. */
    size_t offset;    /**< Its offset in #View. */
    size_t count;     /**< Number of its numbers. */
    bool is_required; /**< Whether it must be given. */
} ViewWord;

/** The fields of `v`. */
static const ViewWord view_words[] = {{"from", offsetof(View, from), 3, true},
                                      {"at", offsetof(View, at), 3, true},
                                      {"up", offsetof(View, up), 3, true},
                                      {"angle", offsetof(View, angle), 1, true},
                                      {"hither", offsetof(View, hither), 1, false},
                                      {"resolution", offsetof(View, resolution), 2, true}};

/** Number of fields of `v`. */
enum { VIEW_WORDS = sizeof view_words / sizeof *view_words };

/** @return Index of a field of `v`; #VIEW_WORDS: there is none. */
static size_t find_view_word(const char *word) {
    size_t i = 0;
    while (i < VIEW_WORDS && strcmp(view_words[i].name, word) != 0) {
        i++;
    }
    return i;
}

/** Reads the fields of `v`, in any order. @return Whether all that are required are there. */
static bool read_view_fields(NffReader *reader, View *view) {
    char word[NFF_WORD_SIZE];
    unsigned given = 0;
    NffText before = reader->text;
    for (size_t i; nff_text_word(&reader->text, word); before = reader->text) {
        i = find_view_word(word);
        if (i == VIEW_WORDS) {
            break;
        }
        given |= 1u << i;
        if (!read_numbers(reader, word, view_words[i].count,
                          (double *)((char *)view + view_words[i].offset))) {
            return false;
        }
    }
    reader->text = before;
    for (size_t i = 0; i < VIEW_WORDS; i++) {
        if (view_words[i].is_required && !(given >> i & 1)) {
            return error_set(reader->error, STATUS_SCENE, "`v` has no `%s`", view_words[i].name);
        }
    }
    return true;
}

/**
 * @return The field of view, degrees, between the outer edges of the outermost pixels. The angle of
 *         NFF ends at their centres.
 * @param angle  The angle of NFF, degrees.
 * @param width  Pixels.
 */
static double field_of_view(double angle, double width) {
    double pixels = width > 1 ? width / (width - 1) : 1;
    return 2 * atan(tan(angle / 2 * RADIANS_PER_DEGREE) * pixels) / RADIANS_PER_DEGREE;
}

/** Reads `v`. See #Statement.read. */
static bool read_view(NffReader *reader) {
    View view = {0};
    KeywordValues camera = values_of(&scene_camera_keyword);
    KeywordValues image = values_of(&scene_image_keyword);
    if (!read_view_fields(reader, &view) || !set_field(reader, &camera, "position", view.from) ||
        !set_field(reader, &camera, "look_at", view.at) ||
        !set_field(reader, &camera, "up", view.up) ||
        !set_field(reader, &camera, "fov", view.angle) ||
        !set_field(reader, &image, "width", &view.resolution[0]) ||
        !set_field(reader, &image, "height", &view.resolution[1])) {
        return false;
    }
    double fov = field_of_view(view.angle[0], view.resolution[0]);
    if (!set_field(reader, &camera, "fov", &fov) || !finish(reader, &camera) ||
        !finish(reader, &image)) {
        return false;
    }
    memcpy(&reader->scene->camera, camera.bytes, sizeof reader->scene->camera);
    memcpy(&reader->scene->image, image.bytes, sizeof reader->scene->image);
    reader->scene->has_camera = true;
    return true;
}

/** Reads `b`. See #Statement.read. */
static bool read_background(NffReader *reader) {
    double rgb[3];
    KeywordValues sky = values_of(&scene_sky_keyword);
    if (!read_numbers(reader, "b", 3, rgb) || !set_field(reader, &sky, "color", rgb) ||
        !finish(reader, &sky)) {
        return false;
    }
    memcpy(&reader->scene->sky, sky.bytes, sizeof reader->scene->sky);
    return true;
}

/** Reads `l`. A light without a colour has the intensity 0 until all are counted. See
 *  #Statement.read. */
static bool read_light(NffReader *reader) {
    double position[3], rgb[3] = {1, 1, 1}, intensity;
    KeywordValues light = values_of(&scene_light_keyword);
    if (!read_numbers(reader, "l", 3, position)) {
        return false;
    }
    bool has_color = nff_text_has_word_in_line(&reader->text);
    intensity = has_color ? 1 : 0;
    return (!has_color || read_numbers(reader, "l", 3, rgb)) &&
           set_field(reader, &light, "position", position) &&
           set_field(reader, &light, "color", rgb) &&
           set_field(reader, &light, "intensity", &intensity) && finish(reader, &light) &&
           scene_add_light(reader->scene, (const SceneLight *)light.bytes, reader->error);
}

/** Sets the intensity of lights without a colour: their sum in quadrature is 1. */
static void set_light_intensities(Scene *scene) {
    for (size_t i = 0; i < scene->light_count; i++) {
        SceneLight *light = &scene->lights[i];
        light->intensity =
            light->intensity > 0 ? light->intensity : 1 / sqrt((double)scene->light_count);
    }
}

/* --- materials -------------------------------------------------------------------------------- */

/**
 * Converts a fill colour to a material. The scene's materials give the local light the share
 * 1 - R - T; the weights of NFF do not, so that they are divided by it.
 * @return Whether it is valid.
 */
static bool set_material(NffReader *reader, KeywordValues *material, const double *fill) {
    double kd = fill[3], ks = fill[4], shine = fill[5], transmittance = fill[6], ior = fill[7];
    // Checked before anything is computed with them.
    if (!set_field(reader, material, "color", fill) ||
        !set_grey(reader, material, "transparency", transmittance) ||
        !set_grey(reader, material, "reflectivity", ks) ||
        !set_field(reader, material, "diffuse", &kd)) {
        return false;
    }
    double mirrored = fmin(ks, 1 - transmittance), local = 1 - mirrored - transmittance;
    double per_local = local > LOCAL_SHARE_MINIMUM ? 1 / local : 0;
    double diffuse = kd * per_local, specular = ks * per_local;
    return set_grey(reader, material, "reflectivity", mirrored) &&
           set_field(reader, material, "diffuse", &diffuse) &&
           set_field(reader, material, "specular", &specular) &&
           (ks == 0 || set_field(reader, material, "shininess", &shine)) &&
           (transmittance == 0 || set_field(reader, material, "ior", &ior)) &&
           finish(reader, material);
}

/** @return The slot of a fill colour, or a free one; NULL if the table is full. */
static Fill *find_fill(Fill *fills, const double *numbers) {
    // FNV-1a, by Fowler, Noll and Vo.
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < FILL_NUMBERS * sizeof *numbers; i++) {
        hash = (hash ^ ((const unsigned char *)numbers)[i]) * 0x100000001b3u;
    }
    for (size_t probe = 0; probe < FILL_SLOTS; probe++) {
        Fill *fill = &fills[(hash + probe) & (FILL_SLOTS - 1)];
        if (!fill->material || memcmp(fill->numbers, numbers, sizeof fill->numbers) == 0) {
            return fill;
        }
    }
    return NULL;
}

/** Reads `f`; the same numbers are the same material. See #Statement.read. */
static bool read_fill(NffReader *reader) {
    double numbers[FILL_NUMBERS];
    if (!read_numbers(reader, "f", FILL_NUMBERS, numbers)) {
        return false;
    }
    Fill *fill = find_fill(reader->fills, numbers);
    if (fill && fill->material) {
        reader->material = fill->material;
        return true;
    }
    KeywordValues material = values_of(&scene_material_keyword);
    if (!set_material(reader, &material, numbers) ||
        !scene_add_material(reader->scene, (const SceneMaterial *)material.bytes, reader->error)) {
        return false;
    }
    reader->material = reader->scene->material_count - 1;
    if (fill) {
        memcpy(fill->numbers, numbers, sizeof fill->numbers);
        fill->material = reader->material;
    }
    return true;
}

/* --- shapes ----------------------------------------------------------------------------------- */

/** Rejects a negative radius. @return Whether it is not negative. */
static bool check_radius(NffReader *reader, double radius) {
    return !(radius < 0) ||
           error_set(reader->error, STATUS_SCENE,
                     "a radius of %g: shapes that are seen from inside only are not supported",
                     radius);
}

/** Reads `s`. See #Statement.read. */
static bool read_sphere(NffReader *reader) {
    double numbers[4];
    KeywordValues sphere = shape_values("sphere");
    return read_numbers(reader, "s", 4, numbers) && check_radius(reader, numbers[3]) &&
           set_field(reader, &sphere, "center", numbers) &&
           set_field(reader, &sphere, "radius", &numbers[3]) && add_shape(reader, &sphere);
}

/** Reads `c`: an open cylinder if both radii are the same, else an open cone. See
 *  #Statement.read. */
static bool read_cone(NffReader *reader) {
    double numbers[8];
    if (!read_numbers(reader, "c", 8, numbers) || !check_radius(reader, numbers[3]) ||
        !check_radius(reader, numbers[7])) {
        return false;
    }
    bool is_cylinder = numbers[3] == numbers[7];
    KeywordValues shape = shape_values(is_cylinder ? "cylinder" : "cone");
    bool is_set = set_field(reader, &shape, "base", numbers) &&
                  set_field(reader, &shape, "top", numbers + 4) &&
                  set_field(reader, &shape, "radius", &numbers[3]) &&
                  (is_cylinder || set_field(reader, &shape, "top_radius", &numbers[7]));
    if (is_cylinder) {
        ((CylinderParameters *)shape.bytes)->capped = false;
    } else {
        ((ConeParameters *)shape.bytes)->capped = false;
    }
    return is_set && add_shape(reader, &shape);
}

/** Reads a polygon. @param numbers Numbers per vertex: 3, or 6 with normals. */
static bool read_vertices(NffReader *reader, const char *statement, size_t numbers) {
    double count, vertex[NFF_VERTEX_NUMBERS] = {0};
    if (!read_numbers(reader, statement, 1, &count)) {
        return false;
    }
    if (!(count >= 3 && count <= VERTICES_MAXIMUM) || count != floor(count)) {
        return error_set(reader->error, STATUS_SCENE,
                         "`%s` takes a whole number of vertices from 3 to %g, not %g", statement,
                         VERTICES_MAXIMUM, count);
    }
    NffPolygon polygon = {.first = reader->polygons.vertex_count,
                          .count = (size_t)count,
                          .material = reader->material,
                          .has_normals = numbers > 3,
                          .line = reader->line};
    for (size_t i = 0; i < polygon.count; i++) {
        if (!read_numbers(reader, statement, numbers, vertex) ||
            !nff_polygons_add_vertex(&reader->polygons, vertex, reader->error)) {
            return false;
        }
    }
    return nff_polygons_add(&reader->polygons, &polygon, reader->error);
}

/** Reads `p`. See #Statement.read. */
static bool read_polygon(NffReader *reader) {
    return read_vertices(reader, "p", 3);
}

/** Reads `pp`. See #Statement.read. */
static bool read_patch(NffReader *reader) {
    return read_vertices(reader, "pp", NFF_VERTEX_NUMBERS);
}

/* --- the text --------------------------------------------------------------------------------- */

/** A statement of NFF. */
typedef struct Statement {
    const char *name; /**< Its first word. */
    /** Reads the rest of it. @return Whether it is valid. */
    bool (*read)(NffReader *reader);
} Statement;

/** The statements of NFF 3.1. */
static const Statement statements[] = {
    {"v", read_view},    {"b", read_background}, {"l", read_light},
    {"f", read_fill},    {"c", read_cone},       {"s", read_sphere},
    {"p", read_polygon}, {"pp", read_patch},     {0}};

/** Reads a statement. @param word Its first word. @return Whether it is valid. */
static bool read_statement(NffReader *reader, const char *word) {
    for (const Statement *statement = statements; statement->name; statement++) {
        if (strcmp(statement->name, word) == 0) {
            return statement->read(reader);
        }
    }
    return error_set(reader->error, STATUS_SCENE,
                     "`%s` is no statement of NFF; those are v, b, l, f, c, s, p and pp", word);
}

/** Reads all statements. @param[out] location The current line. @return Whether all are valid. */
static bool read_statements(NffReader *reader, SourceLocation *location) {
    char word[NFF_WORD_SIZE];
    while (nff_text_word(&reader->text, word)) {
        reader->line = reader->text.line;
        location->line = reader->line;
        if (!read_statement(reader, word)) {
            return false;
        }
    }
    return reader->scene->has_camera ||
           error_set(reader->error, STATUS_SCENE, "there is no `v` in the file: no camera");
}

void nff_execute(ScriptRun *run) {
    Error error = {0};
    size_t size;
    script_run_use_c_locale();
    worker_enter_sandbox(run->request->memory_limit);
    const char *body = script_text_body(run->text, &size);
    NffReader reader = {.text = {.next = body, .end = body + size, .line = 1},
                        .scene = run->scene,
                        .fills = calloc(FILL_SLOTS, sizeof *reader.fills),
                        .error = &error};
    int *line = &run->result->location.line;
    bool is_good = reader.fills || error_set(&error, STATUS_SCENE, "no memory for a scene file");
    is_good =
        is_good && read_statements(&reader, &run->result->location) &&
        nff_polygons_add_to_scene(&reader.polygons, run->scene, run->request->path, line, &error);
    set_light_intensities(run->scene);
    if (!is_good) {
        script_result_fail(run->result, run->result->location, error.message,
                           strlen(error.message));
    }
    nff_polygons_deinit(&reader.polygons);
    free(reader.fills);
}
