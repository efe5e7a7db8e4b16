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
     .unit = N_("file"),
     .help = N_("the model file, beside the scene file")},
    {.name = "normals",
     .type = PARAMETER_CHOICE,
     .offset = offsetof(MeshShapeParameters, normals),
     .choices = mesh_normal_words,
     .unit = N_("word"),
     .help = N_("the file's, smooth where it has none; smooth; or flat")},
    {0}};

/** No file: the scene must give it. */
static const MeshShapeParameters mesh_defaults = {.normals = NORMALS_FROM_FILE};

/** Rejects meshes without a file. See #Keyword.finish. @return Whether the file is given. */
static bool mesh_finish(void *values, uint64_t given, Error *error) {
    (void)values;
    return (given & 1) || error_set(error, STATUS_SCENE, "mesh needs a file");
}

/** See #ShapeFacts.ray_growth: measured on models of glass. */
#define MESH_RAY_GROWTH 2

/** Smallest number of triangles with such paths. In a few flat faces rays part only at edges. */
enum { IRREGULAR_TRIANGLES = 100 };

/** @return Facts of a mesh; before its file is read, the box is infinite. See
 *  #SceneShapeClass.facts. */
static ShapeFacts mesh_facts(const void *parameters, const Scene *scene) {
    const MeshShapeParameters *p = parameters;
    const Mesh *mesh = scene->meshes[p->file].mesh;
    return (ShapeFacts){
        .bounds = mesh ? mesh->bounds : aabbd_infinite(),
        .mesh = mesh,
        .is_smooth = p->normals != NORMALS_FLAT,
        .ray_growth = mesh && mesh->triangle_count >= IRREGULAR_TRIANGLES ? MESH_RAY_GROWTH : 0};
}

/** @return A lower bound of the distance of a point from one triangle of a mesh. */
static double mesh_triangle_distance(const Mesh *mesh, size_t index, Vec3d point) {
    const MeshTriangle *triangle = &mesh->triangles[index];
    Vec3d a = mesh->positions[triangle->index[0]], b = mesh->positions[triangle->index[1]],
          c = mesh->positions[triangle->index[2]];
    Vec3d low = vec3d_min(a, vec3d_min(b, c)), high = vec3d_max(a, vec3d_max(b, c));
    Vec3d away = vec3d_max(vec3d_subtract(low, point), vec3d_subtract(point, high));
    Vec3d normal = vec3d_cross(vec3d_subtract(b, a), vec3d_subtract(c, a));
    double from_box = vec3d_length(vec3d_max(away, (Vec3d){0, 0, 0}));
    bool has_area = vec3d_max_abs(normal) > 0;
    return has_area ? fmax(from_box, distance_from_plane(normal, a, point)) : from_box;
}

/** @return A lower bound of the distance of a point from a mesh; 0 before its file is read. See
 *  #SceneShapeClass.distance. */
static double mesh_distance(const void *parameters, const Scene *scene, Vec3d point) {
    const MeshShapeParameters *p = parameters;
    const Mesh *mesh = scene->meshes[p->file].mesh;
    double distance = HUGE_VAL;
    for (size_t i = 0; mesh && i < mesh->triangle_count; i++) {
        distance = fmin(distance, mesh_triangle_distance(mesh, i, point));
    }
    return mesh ? distance : 0;
}

/** Description of `mesh`. */
const SceneShapeClass scene_mesh_class = {
    .keyword = {.name = "mesh",
                .help = "the triangles of a model file",
                .parameters = mesh_parameters,
                .size = sizeof(MeshShapeParameters),
                .defaults = &mesh_defaults,
                .finish = mesh_finish},
    .facts = mesh_facts,
    .distance = mesh_distance,
};
