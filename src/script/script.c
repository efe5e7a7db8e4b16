/**
 * @file
 * @brief Scene files, from the path to the finished scene.
 */
#include "dioptre/script.h"

#include "assets/mesh_file.h"
#include "assets/texture_file.h"
#include "script/launch.h"
#include "script/stock.h"
#include "script/text.h"

#include <string.h>

/**
 * Says in an error which file it is about. A library's words may hold anything that is in the file.
 * @param file           The file.
 * @param[in,out] error  What is wrong with it; may be NULL.
 * @return false, always.
 */
static bool blame(const SceneFile *file, Error *error) {
    char name[TEXT_PATH_SIZE], words[ERROR_MESSAGE_SIZE];
    if (error) {
        text_clean_path(name, file->name);
        text_clean(words, sizeof words, error->message, strlen(error->message));
        error_set(error, error->status, "%s: %s: %s", file->where, name, words);
    }
    return false;
}

/**
 * Reads the model files that a scene names and that are not there yet.
 * @param[in,out] scene  The scene.
 * @param progress       Who is told how far it is; NULL: nobody.
 * @param[out] error     What is wrong, with the line that names the file.
 * @return Whether all were read.
 */
static bool read_models(Scene *scene, const MeshProgress *progress, Error *error) {
    for (size_t i = 0; i < scene->mesh_count; i++) {
        SceneMesh *model = &scene->meshes[i];
        if (!model->mesh && !mesh_file_read(model->file.path, progress, &model->mesh, error)) {
            return blame(&model->file, error);
        }
    }
    return true;
}

/**
 * Reads the picture files that a scene names and that are not there yet.
 * @param[in,out] scene  The scene.
 * @param[out] error     What is wrong, with the line that names the file.
 * @return Whether all were read.
 */
static bool read_pictures(Scene *scene, Error *error) {
    for (size_t i = 0; i < scene->texture_count; i++) {
        SceneTexture *picture = &scene->textures[i];
        if (!picture->texture && !texture_file_read(picture->file.path, &picture->texture, error)) {
            return blame(&picture->file, error);
        }
    }
    return true;
}

/**
 * Finds the model of a shape.
 * @param scene    The scene.
 * @param shape    The shape.
 * @param keyword  What its class says of itself.
 * @return The model that it shows; NULL if shapes of its class show none.
 */
static const SceneMesh *model_of(const Scene *scene, const SceneShape *shape,
                                 const Keyword *keyword) {
    for (const Parameter *row = keyword->parameters; row->name; row++) {
        if (row->type == PARAMETER_MESH) {
            size_t place;
            memcpy(&place, (const char *)shape->parameters + row->offset, sizeof place);
            return &scene->meshes[place];
        }
    }
    return NULL;
}

/**
 * Sees that each model with a picture on it says where the picture goes.
 * @param scene       The scene, with its models.
 * @param keywords    The shapes' classes.
 * @param[out] error  Which does not, with the line that names it.
 * @return Whether all do.
 */
static bool check_painted_models(const Scene *scene, const Keyword *const *keywords, Error *error) {
    for (size_t i = 0; i < scene->shape_count; i++) {
        const SceneShape *shape = &scene->shapes[i];
        size_t texture = scene->materials[shape->material].texture;
        const SceneMesh *model = texture > 0 ? model_of(scene, shape, keywords[shape->kind]) : NULL;
        if (model && model->mesh->uv_count == 0) {
            error_set(error, STATUS_SCENE, "it has no (u, v) to lay the picture %s on it",
                      scene->textures[texture - 1].file.name);
            return blame(&model->file, error);
        }
    }
    return true;
}

/**
 * Reads all files that a scene names, but for those that an earlier one has left.
 * @param request        What was asked for; its stock holds this scene's files afterwards.
 * @param[in,out] scene  The scene.
 * @param[out] error     What is wrong, with the line that names the file.
 * @return Whether all are there.
 */
static bool read_files(const ScriptRequest *request, Scene *scene, Error *error) {
    stock_lend(request->stock, scene);
    return read_models(scene, request->progress, error) &&
           check_painted_models(scene, request->shape_keywords, error) &&
           read_pictures(scene, error) && stock_keep(request->stock, scene, error);
}

/**
 * Makes the scene that a text describes.
 * @param request     What to load.
 * @param source      The text.
 * @param[out] error  What is wrong.
 * @return The scene; NULL if anything is wrong.
 */
static Scene *load_text(const ScriptRequest *request, const Source *source, Error *error) {
    Scene *scene = scene_create(error);
    Report *report = scene ? report_create(request->path, error) : NULL;
    Run run = {.request = request,
               .vocabulary = &scene_vocabulary,
               .source = source,
               .scene = scene,
               .report = report};
    if (!report || !launch_run(&run, error) || !read_files(request, scene, error)) {
        scene_destroy(scene);
        scene = NULL;
    }
    report_destroy(report);
    return scene;
}

Scene *script_load(const ScriptRequest *request, Error *error) {
    Source own = {0};
    Source *source = request->stock ? stock_source(request->stock) : &own;
    if (!source->text && !launch_read(request->path, source, error)) {
        return NULL;
    }
    Scene *scene = load_text(request, source, error);
    source_release(&own);
    return scene;
}
