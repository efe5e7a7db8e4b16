/**
 * @file
 * @brief `dioptre info`: what a scene uses, and what the tracer leaves out for it.
 */
#include "base/json.h"
#include "base/language.h"
#include "base/sanitize.h"
#include "cli/commands.h"
#include "dioptre/scene.h"
#include "dioptre/sdf_tape.h"

#include <libintl.h>
#include <stdio.h>
#include <string.h>

/** Most shape classes, and most omissions. */
enum { SHAPE_CLASSES_MAXIMUM = 64, OMISSIONS_MAXIMUM = 8 };

/** Time for rays at the step limit, seconds: with all else, `info` answers within a second. */
#define SAMPLE_SECONDS 0.5

/** The facts about a scene. */
typedef struct SceneInfo {
    const Scene *scene;      /**< The scene. */
    const Options *options;  /**< The command line. */
    RenderSettings settings; /**< The settings for rendering it. */
    TracerStats contents;    /**< The contents of its tracer. */
    size_t sampled_rays;     /**< Camera rays that were traced for TracerStats::step_limit_count. */
    RayCounts forecast;      /**< Rays of a forecast of the light that the picture will lack. */
    size_t shape_counts[SHAPE_CLASSES_MAXIMUM]; /**< Shapes of each class. */
    size_t reflective;                          /**< Shapes with a reflective material. */
    size_t transparent;                         /**< Shapes with a transparent material. */
    size_t specular;                            /**< Shapes with specular highlights. */
    bool has_sdfs;                              /**< Whether any shape is a distance field. */
    size_t tapes;                               /**< Functions of distance fields. */
    const char *omissions[OMISSIONS_MAXIMUM];   /**< What the tracer leaves out, in English. */
    int omission_count;                         /**< Number of #omissions. */
} SceneInfo;

/* --- gathering -------------------------------------------------------------------------------- */

/**
 * Finds the next function of a field.
 * @param field  The field; may be NULL.
 * @param after  The function before it; NULL: the first one.
 * @return Its #SDF_TAPE node; NULL after the last one.
 */
static const SdfNode *next_tape(const Sdf *field, const SdfNode *after) {
    const SdfNode *node = after ? after + 1 : field ? field->nodes : NULL;
    while (node && node < field->nodes + field->node_count && node->op != SDF_TAPE) {
        node++;
    }
    return node && node < field->nodes + field->node_count ? node : NULL;
}

/** Counts the shapes by class and by material. */
static void count_shapes(SceneInfo *info) {
    const Scene *scene = info->scene;
    for (size_t i = 0; i < scene->shape_count; i++) {
        const SceneMaterial *material = &scene->materials[scene->shapes[i].material_index];
        size_t class_index = scene->shapes[i].class_index;
        info->shape_counts[class_index]++;
        info->reflective += scene_material_is_reflective(material);
        info->transparent += scene_material_is_transparent(material);
        info->specular += material->specular > 0;
        const Sdf *field = scene_shape_facts(scene, &scene->shapes[i]).sdf;
        info->has_sdfs = info->has_sdfs || field;
        for (const SdfNode *tape = NULL; (tape = next_tape(field, tape));) {
            info->tapes++;
        }
    }
}

/** Lists the features that the tracer leaves out for the scene. */
static void list_omissions(SceneInfo *info) {
    const Scene *scene = info->scene;
    const SceneSky *sky = &scene->sky;
    bool has_sky_gradient = memcmp(&sky->horizon, &sky->zenith, sizeof sky->zenith) != 0;
    const struct {
        bool is_used;     /**< Whether the scene uses the feature. */
        const char *name; /**< Its name, in English. */
    } features[OMISSIONS_MAXIMUM] = {
        {info->reflective + info->transparent > 0, N_("recursion")},
        {info->transparent > 0, N_("media")},
        {info->specular > 0, N_("highlights")},
        {scene->light_count > 0, N_("shadows")},
        {has_sky_gradient, N_("sky gradient")},
        {scene_has_textures(scene), N_("textures")},
        {sky->texture_id != 0, N_("panorama")},
        {info->contents.in_bvh > 0, N_("tree")},
    };
    for (int i = 0; i < OMISSIONS_MAXIMUM; i++) {
        if (!features[i].is_used) {
            info->omissions[info->omission_count++] = features[i].name;
        }
    }
}

/** @return The reason for the choice of the engine, in English. */
static const char *engine_reason(const SceneInfo *info) {
    if (info->options->engine) {
        return N_("asked for");
    }
    return info->settings.engine == engine_with_role(ENGINE_FASTEST)
               ? engine_fastest_reason()
               : N_("double precision, as single precision is estimated to show errors here");
}

/* --- facts: each as text and as JSON ---------------------------------------------------------- */

/** Prints the number of shapes and how many there are of each class. */
static void print_shapes(const SceneInfo *info) {
    const Keyword *const *keywords = scene_shape_keywords;
    printf(gettext("%zu:"), info->scene->shape_count);
    for (size_t kind = 0; keywords[kind]; kind++) {
        if (info->shape_counts[kind]) {
            printf(" %zu %s", info->shape_counts[kind], keywords[kind]->name);
        }
    }
    putchar('\n');
}

/** Writes the same as JSON. */
static void write_shapes(const SceneInfo *info, JsonWriter *json) {
    const Keyword *const *keywords = scene_shape_keywords;
    json_object_begin(json, "shapes");
    for (size_t kind = 0; keywords[kind]; kind++) {
        if (info->shape_counts[kind]) {
            json_count(json, keywords[kind]->name, info->shape_counts[kind]);
        }
    }
    json_object_end(json);
    json_count(json, "shape_count", info->scene->shape_count);
}

/** Prints the number of lights. */
static void print_lights(const SceneInfo *info) {
    printf("%zu\n", info->scene->light_count);
}

/** Writes the same as JSON. */
static void write_lights(const SceneInfo *info, JsonWriter *json) {
    json_count(json, "lights", info->scene->light_count);
}

/** Prints the number of materials. */
static void print_materials(const SceneInfo *info) {
    printf("%zu\n", info->scene->material_count - 1);
}

/** Writes the same as JSON. */
static void write_materials(const SceneInfo *info, JsonWriter *json) {
    json_count(json, "materials", info->scene->material_count - 1);
}

/** Prints how many shapes reflect and refract, and how deep their rays go. */
static void print_reflections(const SceneInfo *info) {
    bool has_any = info->reflective + info->transparent > 0;
    printf(ngettext("%zu mirror, ", "%zu mirrors, ", info->reflective), info->reflective);
    printf(ngettext("%zu glass shape, ", "%zu glass shapes, ", info->transparent),
           info->transparent);
    printf(gettext("depth %d, cutoff %g steps\n"), has_any ? info->settings.trace.depth : 0,
           info->settings.trace.cutoff);
}

/** Writes the same as JSON. */
static void write_reflections(const SceneInfo *info, JsonWriter *json) {
    json_count(json, "reflective", info->reflective);
    json_count(json, "transparent", info->transparent);
    json_count(json, "specular", info->specular);
    json_integer(json, "depth", info->settings.trace.depth);
    json_number(json, "cutoff", info->settings.trace.cutoff, 6);
}

/** Prints how many camera rays will lack more light than the cutoff allows. */
static void print_missing_light(const SceneInfo *info) {
    const RayCounts *rays = &info->forecast;
    printf(gettext("%llu of %llu camera rays lack more than the cutoff"),
           (unsigned long long)rays->unresolved, (unsigned long long)rays->camera);
    if (rays->unresolved > 0) {
        printf(gettext(", at most %.2g steps"), rays->unresolved_steps);
    }
    putchar('\n');
}

/** @return Whether light is reflected or refracted. */
static bool has_forecast(const SceneInfo *info) {
    return info->forecast.camera > 0;
}

/** Writes the same as JSON. */
static void write_missing_light(const SceneInfo *info, JsonWriter *json) {
    json_count(json, "unresolved", info->forecast.unresolved);
    json_count(json, "unresolved_rays", info->forecast.camera);
    json_number(json, "unresolved_steps", info->forecast.unresolved_steps, 3);
}

/** Prints the size of the picture and its rays per pixel. */
static void print_picture(const SceneInfo *info) {
    const RenderSettings *settings = &info->settings;
    printf("%d x %d, ", settings->width, settings->height);
    printf(ngettext("%d ray per pixel\n", "%d rays per pixel\n", (unsigned long)settings->samples),
           settings->samples);
}

/** Writes the same as JSON. */
static void write_picture(const SceneInfo *info, JsonWriter *json) {
    json_integer(json, "width", info->settings.width);
    json_integer(json, "height", info->settings.height);
    json_integer(json, "samples", info->settings.samples);
}

/** Prints whether the scene depends on its time. */
static void print_time(const SceneInfo *info) {
    fputs(info->scene->is_time_dependent ? gettext("used: frames of a film differ\n")
                                         : gettext("not used: frames of a film are alike\n"),
          stdout);
}

/** Writes the same as JSON. */
static void write_time(const SceneInfo *info, JsonWriter *json) {
    json_bool(json, "is_time_dependent", info->scene->is_time_dependent);
}

/** Prints the engine and the reason for it. */
static void print_engine(const SceneInfo *info) {
    printf(gettext("%s: %s\n"), info->settings.engine->name, gettext(engine_reason(info)));
}

/** Writes the same as JSON. */
static void write_engine(const SceneInfo *info, JsonWriter *json) {
    json_string(json, "engine", info->settings.engine->name);
    json_string(json, "engine_reason", engine_reason(info));
    json_integer(json, "threads", info->settings.threads);
}

/** Prints the offset strategy. */
static void print_offset(const SceneInfo *info) {
    printf("%s\n", offset_strategy_names[info->settings.trace.offset]);
}

/** Writes the same as JSON. */
static void write_offset(const SceneInfo *info, JsonWriter *json) {
    json_string(json, "offset", offset_strategy_names[info->settings.trace.offset]);
}

/** Prints whether there is a BVH over the shapes, and from how many shapes on there is one. */
static void print_bvh(const SceneInfo *info) {
    const TracerStats *contents = &info->contents;
    if (contents->in_bvh == 0) {
        printf(ngettext("none (%zu shape; ", "none (%zu shapes; ", contents->linear),
               contents->linear);
    } else {
        printf(ngettext("over %zu shape (", "over %zu shapes (", contents->in_bvh),
               contents->in_bvh);
        if (contents->linear > 0) {
            printf(gettext("%zu outside it; "), contents->linear);
        }
    }
    printf(gettext("used from %zu)\n"), contents->bvh_threshold);
}

/** Writes the same as JSON. */
static void write_bvh(const SceneInfo *info, JsonWriter *json) {
    json_object_begin(json, "bvh");
    json_count(json, "in_bvh", info->contents.in_bvh);
    json_count(json, "linear", info->contents.linear);
    json_count(json, "threshold", info->contents.bvh_threshold);
    json_object_end(json);
}

/** Prints the memory of all triangles. */
static void print_memory(const SceneInfo *info) {
    const TracerStats *contents = &info->contents;
    printf(gettext("%.1f MB for %zu triangles and their trees: %zu bytes each\n"),
           1e-6 * (double)contents->triangle_bytes, contents->triangles,
           contents->triangle_bytes / contents->triangles);
}

/** @return Whether there are triangles. */
static bool has_memory(const SceneInfo *info) {
    return info->contents.triangles > 0;
}

/** Writes the same as JSON. */
static void write_memory(const SceneInfo *info, JsonWriter *json) {
    json_count(json, "triangles", info->contents.triangles);
    json_count(json, "triangle_bytes", info->contents.triangle_bytes);
}

/** Prints how many camera rays reach the step limit of sphere tracing. */
static void print_step_limit(const SceneInfo *info) {
    size_t pixels = (size_t)info->settings.width * (size_t)info->settings.height;
    printf(gettext("%llu of %zu camera rays reach the step limit"),
           (unsigned long long)info->contents.step_limit_count, info->sampled_rays);
    if (info->sampled_rays < pixels) {
        printf(gettext("; there was no time for the other %zu"), pixels - info->sampled_rays);
    }
    putchar('\n');
}

/** @return Whether there are distance fields. */
static bool has_sdfs(const SceneInfo *info) {
    return info->has_sdfs;
}

/** Writes the same as JSON. */
static void write_step_limit(const SceneInfo *info, JsonWriter *json) {
    json_count(json, "step_limit_count", info->contents.step_limit_count);
    json_count(json, "step_limit_rays", info->sampled_rays);
}

/** @return Whether a field is a function. */
static bool has_tapes(const SceneInfo *info) {
    return info->tapes > 0;
}

/** Prints the operations of each function of a field and how fast it grows. */
static void print_tapes(const SceneInfo *info) {
    const Scene *scene = info->scene;
    const char *separator = "";
    for (size_t i = 0; i < scene->shape_count; i++) {
        const Sdf *field = scene_shape_facts(scene, &scene->shapes[i]).sdf;
        for (const SdfNode *tape = NULL; (tape = next_tape(field, tape));) {
            double factor = tape->operands[SDF_TAPE_FACTOR];
            printf("%s", separator);
            printf(ngettext("%d operation, slope %.3g", "%d operations, slope %.3g",
                            (unsigned long)tape->body_count),
                   tape->body_count, tape->operands[SDF_TAPE_SLOPE]);
            if (factor != 1) {
                printf(gettext(", divided by %.3g"), 1 / factor);
            }
            separator = gettext("; ");
        }
    }
    putchar('\n');
}

/** Writes the same as JSON. */
static void write_tapes(const SceneInfo *info, JsonWriter *json) {
    const Scene *scene = info->scene;
    json_array_begin(json, "field_functions");
    for (size_t i = 0; i < scene->shape_count; i++) {
        const Sdf *field = scene_shape_facts(scene, &scene->shapes[i]).sdf;
        for (const SdfNode *tape = NULL; (tape = next_tape(field, tape));) {
            json_object_begin(json, NULL);
            json_integer(json, "line", scene->shapes[i].origin.line);
            json_integer(json, "operations", tape->body_count);
            json_number(json, "slope", tape->operands[SDF_TAPE_SLOPE], 6);
            json_number(json, "divided_by", 1 / tape->operands[SDF_TAPE_FACTOR], 6);
            json_object_end(json);
        }
    }
    json_array_end(json);
}

/** Prints what the tracer leaves out. */
static void print_omissions(const SceneInfo *info) {
    for (int i = 0; i < info->omission_count; i++) {
        printf("%s%s", i ? ", " : "", gettext(info->omissions[i]));
    }
    printf("%s\n", info->omission_count ? "" : gettext("nothing"));
}

/** Writes the same as JSON. */
static void write_omissions(const SceneInfo *info, JsonWriter *json) {
    json_array_begin(json, "left_out");
    for (int i = 0; i < info->omission_count; i++) {
        json_string(json, NULL, info->omissions[i]);
    }
    json_array_end(json);
}

/** A repair of a mesh. */
typedef struct RepairFact {
    const char *key;   /**< Its key in JSON. */
    size_t offset;     /**< Where its number is in #MeshRepairs, bytes. */
    const char *label; /**< Its name in text output, in English. */
} RepairFact;

/** The repairs of meshes. */
static const RepairFact repair_facts[] = {
    {"degenerate_triangles", offsetof(MeshRepairs, degenerate_triangles),
     N_("without area, left out")},
    {"missing_triangles", offsetof(MeshRepairs, untriangulated_polygons),
     N_("missing, as polygons cannot be cut")},
    {"missing_normals", offsetof(MeshRepairs, missing_normals),
     N_("corners given their triangle's normal")},
    {"missing_uvs", offsetof(MeshRepairs, missing_uvs), N_("corners given (0, 0) as (u, v)")},
    {"skipped_statements", offsetof(MeshRepairs, skipped_statements),
     N_("statements not understood, left out")},
};

/** Number of repairs. */
enum { REPAIR_COUNT = sizeof repair_facts / sizeof *repair_facts };

/** @return How often a repair was made. */
static size_t repair_count(const MeshRepairs *repairs, const RepairFact *fact) {
    return *(const size_t *)((const char *)repairs + fact->offset);
}

/** Prints a mesh. */
static void print_mesh(const SceneMesh *file) {
    const Mesh *mesh = file->mesh;
    sanitize_print_line(file->file.name, stdout);
    printf(ngettext(": %zu triangle", ": %zu triangles", mesh->triangle_count),
           mesh->triangle_count);
    printf(ngettext(", %zu position", ", %zu positions", mesh->position_count),
           mesh->position_count);
    printf("%s%s", mesh->normal_count ? gettext(", normals") : "",
           mesh->uv_count ? ", (u, v)" : "");
    for (int i = 0; i < REPAIR_COUNT; i++) {
        size_t count = repair_count(&mesh->repairs, &repair_facts[i]);
        if (count > 0) {
            printf("; %s%s%zu", gettext(repair_facts[i].label), gettext(": "), count);
        }
    }
    putchar('\n');
}

/** Writes all meshes as JSON. */
static void write_meshes(const SceneInfo *info, JsonWriter *json) {
    json_array_begin(json, "meshes");
    for (size_t i = 0; i < info->scene->mesh_count; i++) {
        const Mesh *mesh = info->scene->meshes[i].mesh;
        json_object_begin(json, NULL);
        json_string(json, "file", info->scene->meshes[i].file.name);
        json_count(json, "triangles", mesh->triangle_count);
        json_count(json, "positions", mesh->position_count);
        json_count(json, "normals", mesh->normal_count);
        json_count(json, "uvs", mesh->uv_count);
        for (int k = 0; k < REPAIR_COUNT; k++) {
            json_count(json, repair_facts[k].key, repair_count(&mesh->repairs, &repair_facts[k]));
        }
        json_object_end(json);
    }
    json_array_end(json);
}

/** Prints a texture. */
static void print_texture(const SceneTexture *file) {
    const Texture *texture = file->texture;
    sanitize_print_line(file->file.name, stdout);
    printf(gettext(": %d x %d, %s, %.1f MB%s\n"), texture->width, texture->height,
           texture->is_hdr ? gettext("linear light, floats") : gettext("sRGB, 8 bits"),
           1e-6 * (double)texture_block_size(texture),
           texture->is_damaged ? gettext("; cut off or damaged") : "");
}

/** Writes all textures as JSON. */
static void write_textures(const SceneInfo *info, JsonWriter *json) {
    json_array_begin(json, "textures");
    for (size_t i = 0; i < info->scene->texture_count; i++) {
        const Texture *texture = info->scene->textures[i].texture;
        json_object_begin(json, NULL);
        json_string(json, "file", info->scene->textures[i].file.name);
        json_integer(json, "width", texture->width);
        json_integer(json, "height", texture->height);
        json_string(json, "texels", texture->is_hdr ? "linear" : "srgb");
        json_count(json, "bytes", texture_block_size(texture));
        json_bool(json, "damaged", texture->is_damaged);
        json_object_end(json);
    }
    json_array_end(json);
}

/* --- output ----------------------------------------------------------------------------------- */

/** A fact in its two forms. A new fact is a row of #facts and these two functions. */
typedef struct Fact {
    const char *label; /**< The label of its line, in English. */

    /** Prints it as text, with the end of the line. */
    void (*print)(const SceneInfo *info);

    /** Writes it as one or more members of the JSON object. */
    void (*write)(const SceneInfo *info, JsonWriter *json);

    /** @return Whether its line is printed; NULL: always. */
    bool (*is_printed)(const SceneInfo *info);
} Fact;

/** All facts, in the order of the output; meshes and textures, a line each, follow the first. */
static const Fact facts[] = {
    {N_("shapes"), print_shapes, write_shapes, NULL},
    {N_("lights"), print_lights, write_lights, NULL},
    {N_("materials"), print_materials, write_materials, NULL},
    {N_("reflections"), print_reflections, write_reflections, NULL},
    {N_("missing light"), print_missing_light, write_missing_light, has_forecast},
    {N_("picture"), print_picture, write_picture, NULL},
    {N_("time"), print_time, write_time, NULL},
    {N_("engine"), print_engine, write_engine, NULL},
    {N_("offset"), print_offset, write_offset, NULL},
    {N_("acceleration tree"), print_bvh, write_bvh, NULL},
    {N_("memory"), print_memory, write_memory, has_memory},
    {N_("sphere tracing"), print_step_limit, write_step_limit, has_sdfs},
    {N_("functions"), print_tapes, write_tapes, has_tapes},
    {N_("left out"), print_omissions, write_omissions, NULL},
};

/** Number of facts. */
enum { FACT_COUNT = sizeof facts / sizeof *facts };

/** @return Width of the column of labels, letters: the longest label and a blank. */
static int label_column_width(void) {
    int width = 0;
    for (int i = 0; i < FACT_COUNT; i++) {
        int label_width = language_text_width(gettext(facts[i].label));
        width = label_width > width ? label_width : width;
    }
    return width + 1;
}

/** Prints all facts as text. */
static void info_print(const SceneInfo *info) {
    int width = label_column_width();
    for (int i = 0; i < FACT_COUNT; i++) {
        if (!facts[i].is_printed || facts[i].is_printed(info)) {
            print_padded(gettext(facts[i].label), width);
            facts[i].print(info);
        }
        for (size_t k = 0; i == 0 && k < info->scene->mesh_count; k++) {
            print_padded(gettext("mesh"), width);
            print_mesh(&info->scene->meshes[k]);
        }
        for (size_t k = 0; i == 0 && k < info->scene->texture_count; k++) {
            print_padded(gettext("texture"), width);
            print_texture(&info->scene->textures[k]);
        }
    }
}

/** Prints all facts as one JSON object. */
static void info_print_json(const SceneInfo *info) {
    JsonWriter json = {.stream = stdout};
    json_object_begin(&json, NULL);
    json_string(&json, "scene", info->options->arguments[0]);
    for (int i = 0; i < FACT_COUNT; i++) {
        facts[i].write(info, &json);
    }
    write_meshes(info, &json);
    write_textures(info, &json);
    json_line_end(&json);
}

void cli_info(const Options *options, Error *error) {
    SceneInfo info = {.options = options};
    Scene *scene = command_load_scene(options, &info.settings, error);
    if (!scene) {
        return;
    }
    info.scene = scene;
    Renderer *renderer = renderer_create(scene, &info.settings, error);
    if (renderer) {
        count_shapes(&info);
        if (info.has_sdfs) {
            info.sampled_rays = renderer_sample_camera_rays(renderer, SAMPLE_SECONDS).rays.camera;
        }
        info.contents = renderer_contents(renderer); // Before the forecast's rays count.
        info.forecast = renderer_forecast_light(renderer, FORECAST_SECONDS, interrupt_flag());
        list_omissions(&info);
        if (options->json) {
            info_print_json(&info);
        } else if (!options->quiet) {
            info_print(&info);
        }
    }
    renderer_destroy(renderer);
    scene_destroy(scene);
}
