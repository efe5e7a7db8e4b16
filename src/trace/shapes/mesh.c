/**
 * @file
 * @brief Mesh: the triangles of a model file.
 *
 * The triangles and the tree over them are a #MeshBvh, which all shapes of the same file and the
 * same normals share; the shape itself only says which one it shows.
 */
#include "trace/mesh/mesh_bvh.h"
#include "trace/shapes/registry.h"

/** What a scene file says of a mesh. */
typedef struct MeshParameters {
    size_t mesh_index; /**< Place of the model file in the scene's list. */
    int normals;       /**< A #NormalSource. */
} MeshParameters;

/** A mesh. @extends Shape */
typedef struct MeshShape {
    Shape base;                 /**< What all shapes have. */
    size_t mesh_index;          /**< Place of the model file in the scene's list. */
    NormalSource normal_source; /**< Where its normals come from. */
    const MeshBvh *bvh;         /**< What it shows; the tracer's. */
} MeshShape;

/** Words of `normals`, in the order of #NormalSource. */
static const char *const mesh_shape_normal_words[] = {"file", "smooth", "flat", NULL};

/** Fields of `mesh`. */
static const Parameter mesh_shape_parameters[] = {{.name = "file",
                                                   .type = PARAMETER_MESH,
                                                   .offset = offsetof(MeshParameters, mesh_index),
                                                   .unit = "file",
                                                   .help = "the model file, beside the scene file"},
                                                  {.name = "normals",
                                                   .type = PARAMETER_CHOICE,
                                                   .offset = offsetof(MeshParameters, normals),
                                                   .choices = mesh_shape_normal_words,
                                                   .unit = "word",
                                                   .help = "the file's, smooth where it has none; "
                                                           "smooth; or flat"},
                                                  {0}};

/** No file: it must be given. */
static const MeshParameters mesh_shape_defaults = {.normals = NORMALS_FROM_FILE};

/**
 * Refuses meshes without a file. See #Keyword.finish.
 * @param given  Which fields were given.
 * @return Whether the file was given.
 */
static bool mesh_shape_finish(void *values, uint64_t given, Error *error) {
    (void)values;
    return (given & 1) || error_set(error, STATUS_SCENE, "mesh needs a file");
}

/** Makes a mesh. */
static void mesh_shape_init(Shape *self, const void *parameters) {
    MeshShape *mesh = (MeshShape *)self;
    const MeshParameters *p = parameters;
    mesh->mesh_index = p->mesh_index;
    mesh->normal_source = (NormalSource)p->normals;
}

/** Finds the model. See #ShapeClass.bind_mesh. @return false without memory. */
static bool mesh_shape_bind(Shape *self, const SceneShape *scene_shape, MeshBvhCache *cache,
                            Error *error) {
    (void)scene_shape;
    MeshShape *mesh = (MeshShape *)self;
    mesh->bvh = mesh_bvh_cache_get(cache, mesh->mesh_index, mesh->normal_source, error);
    return mesh->bvh != NULL;
}

/** Finds where a packet meets the mesh. See #ShapeClass.closest_hits. @callgraph */
static void mesh_shape_closest_hits(const Shape *self, const Packet *packet, Hit *hits) {
    mesh_bvh_closest_hits(((const MeshShape *)self)->bvh, packet, self->index, hits);
}

/** Finds which rays the mesh blocks. See #ShapeClass.occluded. */
static void mesh_shape_occluded(const Shape *self, const Packet *packet, mask *occluded) {
    mesh_bvh_occluded(((const MeshShape *)self)->bvh, packet, occluded);
}

/**
 * @return A packet of one vector of rays.
 * @param limit  How far they look.
 */
static Packet packet_of_vector(const Ray *ray, mask active, real limit) {
    Packet packet = {.rays = {*ray}, .limit = {limit}, .wants_points = true};
    packet.active[0] = active;
    return packet;
}

/** @return The lanes where the mesh is nearer. See #ShapeClass.is_hit. */
static mask mesh_shape_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    Packet packet = packet_of_vector(ray, active, hit->distance);
    Hit hits[PACKET_VECTORS] = {*hit};
    mesh_shape_closest_hits(self, &packet, hits);
    mask nearer = active & ((hits[0].distance < hit->distance) | (hits[0].shape != hit->shape));
    *hit = hits[0];
    return nearer;
}

/** @return The lanes where the mesh is on the way. See #ShapeClass.is_occluding. */
static mask mesh_shape_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    Packet packet = packet_of_vector(ray, active, limit);
    mask occluded[PACKET_VECTORS] = {0};
    mesh_shape_occluded(self, &packet, occluded);
    return active & occluded[0];
}

/** @return The box around a mesh. */
static Aabbs mesh_shape_bounds(const Shape *self) {
    return ((const MeshShape *)self)->bvh->bounds;
}

/** @return Where on a picture points of a mesh lie, as its file says. See #ShapeClass.texture_uv.
 */
static TextureUv mesh_shape_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    return mesh_bvh_texture_uv(((const MeshShape *)self)->bvh, hit, lanes);
}

const ShapeClass mesh_class = {
    .keyword = {.name = "mesh",
                .help = "the triangles of a model file",
                .parameters = mesh_shape_parameters,
                .size = sizeof(MeshParameters),
                .defaults = &mesh_shape_defaults,
                .finish = mesh_shape_finish},
    .size = sizeof(MeshShape),
    .init = mesh_shape_init,
    .bind_mesh = mesh_shape_bind,
    .is_hit = mesh_shape_is_hit,
    .is_occluding = mesh_shape_is_occluding,
    .closest_hits = mesh_shape_closest_hits,
    .occluded = mesh_shape_occluded,
    .bounds = mesh_shape_bounds,
    .texture_uv = mesh_shape_texture_uv,
};
