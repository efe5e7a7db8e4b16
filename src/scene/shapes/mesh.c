/**
 * @file
 * @brief Description of meshes: the triangles of a file.
 */
#include "scene/shapes/fields.h"

/** Words of `normals`, in the order of #NormalSource. */
static const char *const mesh_normal_words[] = {"file", "smooth", "flat", NULL};

/** Fields of `mesh`. */
static const Parameter mesh_parameters[] = {
    {.name = "file",
     .type = PARAMETER_MESH,
     .offset = offsetof(MeshShapeParameters, file),
     .unit = "file",
     .help = "the model file, beside the scene file"},
    {.name = "normals",
     .type = PARAMETER_CHOICE,
     .offset = offsetof(MeshShapeParameters, normals),
     .choices = mesh_normal_words,
     .unit = "word",
     .help = "the file's, smooth where it has none; smooth; or flat"},
    {0}};

/** No file: the scene must give it. */
static const MeshShapeParameters mesh_defaults = {.normals = NORMALS_FROM_FILE};

/** Rejects meshes without a file. See #Keyword.finish. @return Whether the file is given. */
static bool mesh_finish(void *values, uint64_t given, Error *error) {
    (void)values;
    return (given & 1) || error_set(error, STATUS_SCENE, "mesh needs a file");
}

/** @return Facts of a mesh; before its file is read, the box is infinite. See
 *  #SceneShapeClass.facts. */
static ShapeFacts mesh_facts(const void *parameters, const Scene *scene) {
    const MeshShapeParameters *p = parameters;
    const Mesh *mesh = scene->meshes[p->file].mesh;
    return (ShapeFacts){.bounds = mesh ? mesh->bounds : aabbd_infinite(),
                        .mesh = mesh,
                        .is_smooth = p->normals != NORMALS_FLAT};
}

const SceneShapeClass scene_mesh_class = {
    .keyword = {.name = "mesh",
                .help = "the triangles of a model file",
                .parameters = mesh_parameters,
                .size = sizeof(MeshShapeParameters),
                .defaults = &mesh_defaults,
                .finish = mesh_finish},
    .facts = mesh_facts,
};
