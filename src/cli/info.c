/**
 * @file
 * @brief `dioptre info`: what a scene uses, and what the tracer leaves out for it.
 */
#include "base/language.h"
#include "cli/commands.h"
#include "dioptre/offset_strategy.h"

#include <libintl.h>
#include <stdio.h>
#include <string.h>

/** Most kinds of shape that are counted apart, and most things that can be left out. */
enum { SHAPE_CLASSES_MAXIMUM = 64, OMISSIONS_MAXIMUM = 8 };

/** What is said of a scene. */
typedef struct SceneInfo {
    size_t shape_counts[SHAPE_CLASSES_MAXIMUM]; /**< Shapes of each class. */
    size_t reflective;                          /**< Shapes that mirror. */
    size_t transparent;                         /**< Shapes that let light through. */
    size_t specular;                            /**< Shapes with highlights. */
    bool has_sky_gradient;                      /**< Whether the sky has two colours. */
    TracerStats contents;                       /**< What the tracer is made of. */
} SceneInfo;

/** @return What a scene uses. */
static SceneInfo scene_info(const Scene *scene) {
    const SceneSky *sky = &scene->sky;
    SceneInfo info = {.has_sky_gradient =
                          memcmp(&sky->horizon, &sky->zenith, sizeof sky->zenith) != 0};
    for (size_t i = 0; i < scene->shape_count; i++) {
        const SceneMaterial *material = &scene->materials[scene->shapes[i].material_index];
        info.shape_counts[scene->shapes[i].class_index]++;
        info.reflective += scene_material_is_reflective(material);
        info.transparent += scene_material_is_transparent(material);
        info.specular += material->specular > 0;
    }
    return info;
}

/** @return Why an engine was taken, in English. */
static const char *engine_reason(const Options *options, const Engine *engine) {
    if (options->engine) {
        return N_("asked for");
    }
    return engine == engine_find("auto", NULL)
               ? N_("the fastest that this processor can run")
               : N_("double precision, as single precision is estimated to show errors here");
}

/**
 * Names what the tracer leaves out for a scene, in English.
 * @param omissions  Room for the names.
 * @return How many.
 */
static int info_omissions(const Scene *scene, const SceneInfo *info,
                          const char *omissions[OMISSIONS_MAXIMUM]) {
    int count = 0;
    if (info->reflective + info->transparent == 0) {
        omissions[count++] = N_("recursion");
    }
    if (info->transparent == 0) {
        omissions[count++] = N_("media");
    }
    if (info->specular == 0) {
        omissions[count++] = N_("highlights");
    }
    if (scene->light_count == 0) {
        omissions[count++] = N_("shadows");
    }
    if (!info->has_sky_gradient) {
        omissions[count++] = N_("sky gradient");
    }
    if (!scene_has_textures(scene)) {
        omissions[count++] = N_("textures");
    }
    if (!scene->sky.texture_id) {
        omissions[count++] = N_("panorama");
    }
    if (info->contents.in_bvh == 0) {
        omissions[count++] = N_("tree");
    }
    return count;
}

/** @return Whether a scene has distance fields. */
static bool info_has_sdfs(const Scene *scene) {
    for (size_t i = 0; i < scene->shape_count; i++) {
        if (scene_shape_facts(scene, &scene->shapes[i]).sdf) {
            return true;
        }
    }
    return false;
}

/** Prints the models for programs. */
static void info_print_meshes_json(const Scene *scene) {
    printf(", \"meshes\": [");
    for (size_t i = 0; i < scene->mesh_count; i++) {
        const Mesh *mesh = scene->meshes[i].mesh;
        const MeshRepairs *repairs = &mesh->repairs;
        printf("%s{\"file\": ", i ? ", " : "");
        json_print_string(scene->meshes[i].file.name, stdout);
        printf(", \"triangles\": %zu, \"positions\": %zu, \"normals\": %zu, \"uvs\": %zu, "
               "\"degenerate\": %zu, \"uncut\": %zu, \"lost_normals\": %zu, \"lost_uvs\": %zu}",
               mesh->triangle_count, mesh->position_count, mesh->normal_count, mesh->uv_count,
               repairs->degenerate_triangles, repairs->untriangulated_polygons,
               repairs->missing_normals, repairs->missing_uvs);
    }
    printf("]");
}

/** Prints what was put right in a model, for people. */
static void info_print_repairs(const MeshRepairs *repairs) {
    const struct {
        size_t count;      /**< How many. */
        const char *words; /**< Of what. */
    } all[] = {
        {repairs->degenerate_triangles, N_("without area, left out")},
        {repairs->untriangulated_polygons, N_("missing, as polygons cannot be cut")},
        {repairs->missing_normals, N_("corners given their triangle's normal")},
        {repairs->missing_uvs, N_("corners given (0, 0) as (u, v)")},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        if (all[i].count > 0) {
            printf("; %s%s%zu", gettext(all[i].words), gettext(": "), all[i].count);
        }
    }
}

/** Prints the models for people, a line each. */
static void info_print_meshes(const Scene *scene) {
    for (size_t i = 0; i < scene->mesh_count; i++) {
        const Mesh *mesh = scene->meshes[i].mesh;
        fputs(gettext("model      "), stdout);
        print_sanitized(scene->meshes[i].file.name, stdout);
        printf(ngettext(": %zu triangle", ": %zu triangles", mesh->triangle_count),
               mesh->triangle_count);
        printf(ngettext(", %zu position", ", %zu positions", mesh->position_count),
               mesh->position_count);
        printf("%s%s", mesh->normal_count ? gettext(", normals") : "",
               mesh->uv_count ? ", (u, v)" : "");
        info_print_repairs(&mesh->repairs);
        putchar('\n');
    }
}

/** @return How the texels of a picture are kept, in English. */
static const char *texels_name(const Texture *texture) {
    return texture->is_hdr ? N_("linear light, floats") : N_("sRGB, 8 bits");
}

/** Prints the pictures for people, a line each. */
static void info_print_textures(const Scene *scene) {
    for (size_t i = 0; i < scene->texture_count; i++) {
        const Texture *texture = scene->textures[i].texture;
        fputs(gettext("texture    "), stdout);
        print_sanitized(scene->textures[i].file.name, stdout);
        printf(gettext(": %d x %d, %s, %.1f MB\n"), texture->width, texture->height,
               gettext(texels_name(texture)), 1e-6 * (double)texture_block_size(texture));
    }
}

/** Prints the pictures for programs. */
static void info_print_textures_json(const Scene *scene) {
    printf(", \"textures\": [");
    for (size_t i = 0; i < scene->texture_count; i++) {
        const Texture *texture = scene->textures[i].texture;
        printf("%s{\"file\": ", i ? ", " : "");
        json_print_string(scene->textures[i].file.name, stdout);
        printf(", \"width\": %d, \"height\": %d, \"texels\": \"%s\", \"bytes\": %zu}",
               texture->width, texture->height, texture->is_hdr ? "light" : "srgb",
               texture_block_size(texture));
    }
    printf("]");
}

/** Prints how shapes are found, and why so, for people. */
static void info_print_bvh(const TracerStats *contents) {
    bool has_bvh = contents->in_bvh > 0;
    if (has_bvh) {
        printf(gettext("tree       over %zu shapes; "), contents->in_bvh);
    } else {
        fputs(gettext("no tree    "), stdout);
    }
    printf(gettext("%zu asked one by one: here a tree pays from %zu on\n"), contents->linear,
           contents->bvh_threshold);
    if (contents->triangles > 0) {
        printf(gettext("memory     %.1f MB for %zu triangles and their trees: %zu bytes each\n"),
               1e-6 * (double)contents->triangle_bytes, contents->triangles,
               contents->triangle_bytes / contents->triangles);
    }
}

/** Prints how shapes are found, for programs. */
static void info_print_bvh_json(const TracerStats *contents) {
    printf(", \"tree\": {\"planted\": %zu, \"listed\": %zu, \"from\": %zu}, "
           "\"triangles\": %zu, \"triangle_bytes\": %zu",
           contents->in_bvh, contents->linear, contents->bvh_threshold, contents->triangles,
           contents->triangle_bytes);
}

/** Prints it for programs. @param settings How it would be drawn. */
static void info_print_json(const Scene *scene, const SceneInfo *info,
                            const RenderSettings *settings, const Options *options) {
    const char *omissions[OMISSIONS_MAXIMUM];
    int omission_count = info_omissions(scene, info, omissions);
    printf("{\"scene\": ");
    json_print_string(options->arguments[0], stdout);
    printf(", \"shapes\": {");
    const Keyword *const *keywords = scene_shape_keywords;
    const char *comma = "";
    for (size_t kind = 0; keywords[kind]; kind++) {
        if (info->shape_counts[kind]) {
            printf("%s\"%s\": %zu", comma, keywords[kind]->name, info->shape_counts[kind]);
            comma = ", ";
        }
    }
    printf("}, \"shape_count\": %zu, \"lights\": %zu, \"materials\": %zu, \"mirrors\": %zu, "
           "\"glass\": %zu, \"highlights\": %zu, \"width\": %d, \"height\": %d, \"samples\": %d, "
           "\"depth\": %d, "
           "\"engine\": \"%s\", \"engine_reason\": \"%s\", \"threads\": %d, \"offset\": \"%s\", "
           "\"left_out\": [",
           scene->shape_count, scene->light_count, scene->material_count - 1, info->reflective,
           info->transparent, info->specular, settings->width, settings->height, settings->samples,
           settings->trace.depth, settings->engine->name, engine_reason(options, settings->engine),
           settings->threads, offset_strategy_names[settings->trace.offset]);
    for (int i = 0; i < omission_count; i++) {
        printf("%s\"%s\"", i ? ", " : "", omissions[i]);
    }
    putchar(']');
    info_print_meshes_json(scene);
    info_print_textures_json(scene);
    printf(", \"reads_time\": %s, \"stalled\": %llu", scene->is_time_dependent ? "true" : "false",
           (unsigned long long)info->contents.step_limit_count);
    info_print_bvh_json(&info->contents);
    puts("}");
}

/** Prints it for people. @param settings How it would be drawn. */
static void info_print(const Scene *scene, const SceneInfo *info, const RenderSettings *settings,
                       const Options *options) {
    const Keyword *const *keywords = scene_shape_keywords;
    printf(gettext("shapes     %zu:"), scene->shape_count);
    for (size_t kind = 0; keywords[kind]; kind++) {
        if (info->shape_counts[kind]) {
            printf(" %zu %s", info->shape_counts[kind], keywords[kind]->name);
        }
    }
    putchar('\n');
    info_print_meshes(scene);
    info_print_textures(scene);
    printf(gettext("lights     %zu\n"), scene->light_count);
    printf(gettext("materials  %zu\n"), scene->material_count - 1);
    printf(gettext("mirrors    %zu shapes, glass %zu, depth %d\n"), info->reflective,
           info->transparent, info->reflective + info->transparent ? settings->trace.depth : 0);
    printf(gettext("picture    %d x %d, "), settings->width, settings->height);
    printf(ngettext("%d ray a pixel\n", "%d rays a pixel\n", (unsigned long)settings->samples),
           settings->samples);
    fputs(scene->is_time_dependent
              ? gettext("time       asked for: frames of a film differ\n")
              : gettext("time       not asked for: frames of a film are alike\n"),
          stdout);
    printf(gettext("engine     %s: %s\n"), settings->engine->name,
           gettext(engine_reason(options, settings->engine)));
    printf(gettext("offset     %s\n"), offset_strategy_names[settings->trace.offset]);
    info_print_bvh(&info->contents);
    if (info_has_sdfs(scene)) {
        printf(gettext("marching   %llu of %zu rays from the eye run out of steps\n"),
               (unsigned long long)info->contents.step_limit_count,
               (size_t)settings->width * (size_t)settings->height);
    }
    const char *omissions[OMISSIONS_MAXIMUM];
    int omission_count = info_omissions(scene, info, omissions);
    fputs(gettext("left out   "), stdout);
    for (int i = 0; i < omission_count; i++) {
        printf("%s%s", i ? ", " : "", gettext(omissions[i]));
    }
    printf("%s\n", omission_count ? "" : gettext("nothing"));
}

/** Tells about a scene. See #Command.run. @return The exit status. */
static int info_run(const Options *options, Error *error) {
    Scene *scene = command_load_scene(options, error);
    if (!scene) {
        return (int)error->status;
    }
    RenderSettings settings = command_render_settings(options, scene);
    Renderer *renderer = renderer_create(scene, &settings, error);
    if (renderer) {
        SceneInfo info = scene_info(scene);
        if (info_has_sdfs(scene)) {
            renderer_benchmark_rays(renderer, false);
        }
        info.contents = renderer_contents(renderer);
        options->json ? info_print_json(scene, &info, &settings, options)
                      : info_print(scene, &info, &settings, options);
    }
    renderer_destroy(renderer);
    scene_destroy(scene);
    return (int)error->status;
}

const Command info_command = {.name = "info",
                              .usage = N_("SCENE"),
                              .help = N_("says what a scene uses and what the tracer leaves out"),
                              .accepts = "sASDtjEOXBJq",
                              .arguments = 1,
                              .run = info_run};
