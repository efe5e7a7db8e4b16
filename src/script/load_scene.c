/**
 * @file
 * @brief Scene files, from the path to the finished scene.
 */
#include "dioptre/script.h"

#include "assets/asset_budget.h"
#include "assets/images/texture_file.h"
#include "assets/meshes/mesh_file.h"
#include "base/sanitize.h"
#include "base/scene_name.h"
#include "script/asset_cache.h"
#include "script/asset_notes.h"
#include "script/asset_path.h"
#include "script/script_worker.h"

#include <string.h>
#include <unistd.h>

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

/** Files of a scene being read. */
typedef struct AssetLoad {
    const ScriptRequest *request; /**< The request. */
    Scene *scene;                 /**< The scene. */
    AssetBudget budget;           /**< What is left for further files. */
} AssetLoad;

/**
 * Opens a file of a scene, beneath its folder.
 * @param load           The load; one file is taken from its budget.
 * @param[in,out] file   The file; its identity is set.
 * @param[out] opened    The open file.
 * @param[out] path      Its path.
 * @param[out] error     What is wrong.
 * @return Whether it is open.
 */
static bool open_file(AssetLoad *load, SceneFile *file, AssetFile *opened, char path[PATH_MAX],
                      Error *error) {
    char display_path[PATH_MAX];
    opened->path = path;
    opened->descriptor =
        asset_path_open(load->request, file->name, display_path, path, &opened->info, error);
    file->device = opened->descriptor >= 0 ? opened->info.st_dev : 0;
    file->inode = opened->descriptor >= 0 ? opened->info.st_ino : 0;
    return opened->descriptor >= 0;
}

/** @return Whether two names of a scene are of one file. */
static bool is_same_file(const SceneFile *a, const SceneFile *b) {
    return a->inode == b->inode && a->device == b->device;
}

/** A file of a scene, and what is known of its content. */
typedef struct Asset {
    SceneFile *file; /**< The file. */
    bool is_read;    /**< Whether there is a content. */
    bool is_built;   /**< Whether the content is in the scene's block: there is no file. */
    size_t size;     /**< Bytes of the content. */
} Asset;

/** A kind of files of a scene: models or pictures. */
typedef struct AssetKind {
    /** @return One of them. */
    Asset (*at)(const Scene *scene, size_t index);
    /** Gives one the content of another one, of the same file. */
    void (*share)(Scene *scene, size_t from, size_t to);
    /** Reads one from its open file. @return Whether it was read. */
    bool (*read)(AssetLoad *load, const AssetFile *file, size_t index, Error *error);
} AssetKind;

/** Finds a mesh of a scene. See #AssetKind.at. */
static Asset mesh_at(const Scene *scene, size_t index) {
    SceneMesh *it = &scene->meshes[index];
    return (Asset){&it->file, it->mesh, it->built, it->mesh ? mesh_block_size(it->mesh) : 0};
}

/** Shares a mesh. See #AssetKind.share. */
static void mesh_share(Scene *scene, size_t from, size_t to) {
    scene->meshes[to].mesh = mesh_retain(scene->meshes[from].mesh);
}

/** Reads a mesh. See #AssetKind.read. */
static bool mesh_read(AssetLoad *load, const AssetFile *file, size_t index, Error *error) {
    return mesh_file_read(file, &load->budget, load->request->progress,
                          &load->scene->meshes[index].mesh, error);
}

/** Finds a texture of a scene. See #AssetKind.at. */
static Asset texture_at(const Scene *scene, size_t index) {
    SceneTexture *it = &scene->textures[index];
    return (Asset){.file = &it->file,
                   .is_read = it->texture,
                   .size = it->texture ? texture_block_size(it->texture) : 0};
}

/** Shares a texture. See #AssetKind.share. */
static void texture_share(Scene *scene, size_t from, size_t to) {
    scene->textures[to].texture = texture_retain(scene->textures[from].texture);
}

/** Reads a texture. See #AssetKind.read. */
static bool texture_read(AssetLoad *load, const AssetFile *file, size_t index, Error *error) {
    return texture_file_read(file, &load->budget, &load->scene->textures[index].texture, error);
}

/** @return The first of a kind that is of the same file; the index itself if it is the first. */
static size_t find_same_file(const Scene *scene, const AssetKind *kind, size_t index) {
    const SceneFile *file = kind->at(scene, index).file;
    size_t i = 0;
    while (i < index &&
           (kind->at(scene, i).is_built || !is_same_file(kind->at(scene, i).file, file))) {
        i++;
    }
    return i;
}

/** Reads a model or picture from its file, unless it was read under another name. @return Whether
 *  it was read. */
static bool read_asset_file(AssetLoad *load, const AssetKind *kind, size_t index, Error *error) {
    AssetFile file;
    char path[PATH_MAX];
    if (!open_file(load, kind->at(load->scene, index).file, &file, path, error)) {
        return false;
    }
    size_t same = find_same_file(load->scene, kind, index);
    bool is_read = true;
    if (same < index) {
        kind->share(load->scene, same, index);
    } else {
        is_read = asset_budget_take_file_bytes(&load->budget, (size_t)file.info.st_size, error) &&
                  kind->read(load, &file, index, error);
    }
    close(file.descriptor);
    return is_read;
}

/** Reads a model or picture, unless the cache has it. @return Whether it was read. */
static bool read_asset(AssetLoad *load, const AssetKind *kind, size_t index, Error *error) {
    const Asset asset = kind->at(load->scene, index);
    if (!asset_budget_take_file(&load->budget, error)) {
        return false;
    }
    if (!asset.is_read) {
        return read_asset_file(load, kind, index, error);
    }
    return find_same_file(load->scene, kind, index) < index ||
           asset_budget_take_memory(&load->budget, asset.size, error);
}

/** Reads all models or pictures of a scene. @return Whether all were read. */
static bool read_assets(AssetLoad *load, const AssetKind *kind, size_t count, Error *error) {
    for (size_t i = 0; i < count; i++) {
        const Asset asset = kind->at(load->scene, i);
        if (!asset.is_built && !read_asset(load, kind, i, error)) {
            return set_file_error(asset.file, error);
        }
    }
    return true;
}

/** Copies the meshes out of the block of a scene. @return Whether all are valid. */
static bool copy_built_meshes(Scene *scene, Error *error) {
    for (size_t i = 0; i < scene->mesh_count; i++) {
        SceneMesh *it = &scene->meshes[i];
        if (it->built && !it->mesh && !copy_built_mesh(it->built, &it->mesh, error)) {
            return set_file_error(&it->file, error);
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
    static const AssetKind meshes = {mesh_at, mesh_share, mesh_read};
    static const AssetKind textures = {texture_at, texture_share, texture_read};
    AssetLoad load = {.request = request, .scene = scene};
    asset_budget_init(&load.budget);
    asset_cache_fill_scene(request->cache, scene);
    return copy_built_meshes(scene, error) &&
           read_assets(&load, &meshes, scene->mesh_count, error) &&
           check_textured_meshes(scene, request->shape_keywords, error) &&
           read_assets(&load, &textures, scene->texture_count, error) &&
           asset_cache_store(request->cache, scene, error) && asset_notes_add(scene, error);
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
