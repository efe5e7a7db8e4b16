/**
 * @file
 * @brief Scene files, from the path to the finished scene.
 */
#include "dioptre/script.h"

#include "assets/images/texture_file.h"
#include "assets/meshes/mesh_file.h"
#include "base/scene_name.h"
#include "script/asset_cache.h"
#include "script/asset_notes.h"
#include "script/sanitize.h"
#include "script/script_worker.h"

#include <string.h>

/**
 * Adds the file to an error message. The message is sanitized, because it may quote the file.
 * @param file   The file.
 * @param error  The error; may be NULL.
 * @return false, always.
 */
static bool set_file_error(const SceneFile *file, Error *error) {
    char name[SANITIZED_PATH_SIZE], message[ERROR_MESSAGE_SIZE];
    if (error) {
        sanitize_path(name, file->name);
        sanitize_text(message, sizeof message, error->message, strlen(error->message));
        if (error->line > 0) {
            error_set(error, error->status, "%s: %s:%zu: %s", file->location, name, error->line,
                      message);
        } else {
            error_set(error, error->status, "%s: %s: %s", file->location, name, message);
        }
    }
    return false;
}

/**
 * Copies a mesh out of the block of a scene, and checks what the worker has written.
 * @param built       The mesh in the block.
 * @param[out] mesh   The copy, retained; NULL if it is not valid.
 * @param[out] error  What is wrong.
 * @return Whether it is valid.
 */
static bool copy_built_mesh(const Mesh *built, Mesh **mesh, Error *error) {
    *mesh = mesh_translated(built, (Vec3d){0, 0, 0}, error);
    if (*mesh && !mesh_validate(*mesh, error)) {
        mesh_release(*mesh);
        *mesh = NULL;
    }
    return *mesh != NULL;
}

/**
 * Reads the meshes of a scene that are not yet read.
 * @param scene       The scene.
 * @param progress    Receives the progress, or NULL.
 * @param[out] error  What is wrong, with the line that names the file.
 * @return Whether all were read.
 */
static bool read_meshes(Scene *scene, const MeshProgress *progress, Error *error) {
    for (size_t i = 0; i < scene->mesh_count; i++) {
        SceneMesh *it = &scene->meshes[i];
        bool is_read =
            it->mesh || (it->built ? copy_built_mesh(it->built, &it->mesh, error)
                                   : mesh_file_read(it->file.path, progress, &it->mesh, error));
        if (!is_read) {
            return set_file_error(&it->file, error);
        }
    }
    return true;
}

/**
 * Reads the picture files of a scene that are not yet read.
 * @param scene       The scene.
 * @param[out] error  What is wrong, with the line that names the file.
 * @return Whether all were read.
 */
static bool read_textures(Scene *scene, Error *error) {
    for (size_t i = 0; i < scene->texture_count; i++) {
        SceneTexture *scene_texture = &scene->textures[i];
        if (!scene_texture->texture &&
            !texture_file_read(scene_texture->file.path, &scene_texture->texture, error)) {
            return set_file_error(&scene_texture->file, error);
        }
    }
    return true;
}

/**
 * Finds the mesh of a shape.
 * @param scene    The scene.
 * @param shape    The shape.
 * @param keyword  The keyword of its class.
 * @return The mesh; NULL if the class has none.
 */
static const SceneMesh *mesh_of_shape(const Scene *scene, const SceneShape *shape,
                                      const Keyword *keyword) {
    for (const Parameter *row = keyword->parameters; row->name; row++) {
        if (row->type == PARAMETER_MESH) {
            size_t index;
            memcpy(&index, (const char *)shape->parameters + row->offset, sizeof index);
            return &scene->meshes[index];
        }
    }
    return NULL;
}

/**
 * Checks that each mesh with a texture has texture coordinates.
 * @param scene       The scene, with its meshes read.
 * @param keywords    The keywords of the classes of shapes.
 * @param[out] error  The first mesh without them, with the line that names it.
 * @return Whether all have them.
 */
static bool check_textured_meshes(const Scene *scene, const Keyword *const *keywords,
                                  Error *error) {
    for (size_t i = 0; i < scene->shape_count; i++) {
        const SceneShape *shape = &scene->shapes[i];
        size_t texture = scene->materials[shape->material_index].texture_id;
        const SceneMesh *scene_mesh =
            texture > 0 ? mesh_of_shape(scene, shape, keywords[shape->class_index]) : NULL;
        if (scene_mesh && scene_mesh->mesh->uv_count == 0) {
            error_set(error, STATUS_SCENE, "it has no (u, v) to lay the picture %s on it",
                      scene->textures[texture - 1].file.name);
            return set_file_error(&scene_mesh->file, error);
        }
    }
    return true;
}

/**
 * Reads all files that a scene names, except those in the cache.
 * @param request     The request; its cache holds the files of this scene afterwards.
 * @param scene       The scene.
 * @param[out] error  What is wrong, with the line that names the file.
 * @return Whether all were read.
 */
static bool read_files(const ScriptRequest *request, Scene *scene, Error *error) {
    asset_cache_fill_scene(request->cache, scene);
    return read_meshes(scene, request->progress, error) &&
           check_textured_meshes(scene, request->shape_keywords, error) &&
           read_textures(scene, error) && asset_cache_store(request->cache, scene, error) &&
           asset_notes_add(scene, error);
}

/** Runs a text in a worker, and checks what it made. @return Whether the scene is valid. */
static bool run_text(const ScriptCall *call, Scene *scene, Error *error) {
    size_t size = 0;
    Error damage = {0};
    bool is_run = script_worker_run(call, &size, error);
    // Without a result the scene may be anything, too: it is emptied by its check.
    bool is_valid =
        scene_validate(scene, is_run ? size : 0, call->request->shape_keywords, &damage);
    return is_run && (is_valid || error_set(error, damage.status, "%s", damage.message));
}

/** Creates the scene that a text describes. @return The scene; NULL on errors. */
static Scene *load_text(const ScriptRequest *request, const ScriptText *text, Error *error) {
    Scene *scene = scene_create(error);
    bool is_nff = scene_format_of(request->path) == SCENE_FORMAT_NFF;
    const ScriptCall call = {.request = request,
                             .task = is_nff ? SCRIPT_NFF_TASK : SCRIPT_SCENE_TASK,
                             .text = text,
                             .block = scene,
                             .capacity = SCENE_MEMORY_SIZE};
    if (!scene || !run_text(&call, scene, error) || !read_files(request, scene, error)) {
        scene_destroy(scene);
        scene = NULL;
    }
    return scene;
}

Scene *script_load(const ScriptRequest *request, Error *error) {
    ScriptRequest complete = *request;
    if (!complete.shape_keywords) {
        complete.shape_keywords = scene_shape_keywords;
    }
    ScriptText uncached = {0};
    ScriptText *text = request->cache ? asset_cache_text(request->cache) : &uncached;
    if (!text->text && !script_text_load(request->path, text, error)) {
        return NULL;
    }
    Scene *scene = load_text(&complete, text, error);
    script_text_deinit(&uncached);
    return scene;
}
