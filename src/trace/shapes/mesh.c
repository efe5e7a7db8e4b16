/**
 * @file
 * @brief Mesh: the triangles of a model file.
 *
 * The triangles and the tree over them are a #Model, which all shapes of the same file and the same
 * normals share; the shape itself only says which one it shows.
 */
#include "trace/model.h"
#include "trace/shapes/registry.h"

/** What a scene file says of a mesh. */
typedef struct MeshParameters {
    size_t file; /**< Place of the model file in the scene's list. */
    int normals; /**< A #NormalSource. */
} MeshParameters;

/** A mesh. @extends Shape */
typedef struct MeshShape {
    Shape base;          /**< What all shapes have. */
    size_t file;         /**< Place of the model file in the scene's list. */
    NormalSource source; /**< Where its normals come from. */
    const Model *model;  /**< What it shows; the tracer's. */
} MeshShape;

/** Words of `normals`, in the order of #NormalSource. */
static const char *const mesh_normals[] = {"file", "smooth", "flat", NULL};

/** Fields of `mesh`. */
static const Parameter mesh_parameters[] = {{.name = "file",
                                             .type = PARAMETER_MESH,
                                             .offset = offsetof(MeshParameters, file),
                                             .unit = "file",
                                             .help = "the model file, beside the scene file"},
                                            {.name = "normals",
                                             .type = PARAMETER_WORD,
                                             .offset = offsetof(MeshParameters, normals),
                                             .words = mesh_normals,
                                             .unit = "word",
                                             .help = "the file's, smooth where it has none; "
                                                     "smooth; or flat"},
                                            {0}};

/** No file: it must be given. */
static const MeshParameters mesh_defaults = {.normals = NORMALS_FILE};

/**
 * Refuses meshes without a file. See #Keyword.finish.
 * @param[in,out] values  A #MeshParameters.
 * @param given           Which fields were given.
 * @param[out] error      What is wrong.
 * @return Whether the file was given.
 */
static bool mesh_finish(void *values, uint64_t given, Error *error) {
    (void)values;
    return (given & 1) || error_set(error, STATUS_SCENE, "mesh needs a file");
}

/** Makes a mesh. @param self The mesh. @param parameters A #MeshParameters. */
static void mesh_init(Shape *self, const void *parameters) {
    MeshShape *mesh = (MeshShape *)self;
    const MeshParameters *p = parameters;
    mesh->file = p->file;
    mesh->source = (NormalSource)p->normals;
}

/** Finds the model. See #ShapeClass.bind. @param self The mesh. @param said Not looked
 *  at. @param models All models. @param[out] error What is wrong. @return false without memory. */
static bool mesh_bind(Shape *self, const SceneShape *said, Models *models, Error *error) {
    (void)said;
    MeshShape *mesh = (MeshShape *)self;
    mesh->model = models_get(models, mesh->file, mesh->source, error);
    return mesh->model != NULL;
}

/** Finds where a packet meets the mesh. See #ShapeClass.nearest. @callgraph
 *  @param self The mesh. @param packet The rays. @param[in,out] hits What they met. */
static void mesh_nearest(const Shape *self, const Packet *packet, Hit *hits) {
    model_nearest(((const MeshShape *)self)->model, packet, self->place, hits);
}

/** Finds which rays the mesh blocks. See #ShapeClass.blocked.
 *  @param self The mesh. @param packet The rays. @param[in,out] blocked Those that are. */
static void mesh_blocked(const Shape *self, const Packet *packet, mask *blocked) {
    model_blocked(((const MeshShape *)self)->model, packet, blocked);
}

/** @return A packet of one vector of rays. @param ray The rays. @param active Those that count.
 *  @param limit How far they look. */
static Packet packet_of_one(const Ray *ray, mask active, real limit) {
    Packet packet = {.rays = {*ray}, .limit = {limit}, .wants_points = true};
    packet.active[0] = active;
    return packet;
}

/** @return The lanes where the mesh is nearer. See #ShapeClass.is_hit. @param self The mesh.
 *  @param ray The rays. @param active The lanes. @param[in,out] hit The hit. */
static mask mesh_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    Packet packet = packet_of_one(ray, active, hit->distance);
    Hit hits[PACKET_VECTORS] = {*hit};
    mesh_nearest(self, &packet, hits);
    mask nearer = active & ((hits[0].distance < hit->distance) | (hits[0].shape != hit->shape));
    *hit = hits[0];
    return nearer;
}

/** @return The lanes where the mesh is on the way. See #ShapeClass.is_blocking. @param self The
 * mesh.
 *  @param ray The rays. @param active The lanes. @param limit The way's end. */
static mask mesh_is_blocking(const Shape *self, const Ray *ray, mask active, real limit) {
    Packet packet = packet_of_one(ray, active, limit);
    mask blocked[PACKET_VECTORS] = {0};
    mesh_blocked(self, &packet, blocked);
    return active & blocked[0];
}

/** @return The box around a mesh. @param self The mesh. */
static Bounds mesh_bounds(const Shape *self) {
    return ((const MeshShape *)self)->model->bounds;
}

/** @return Where on a picture points of a mesh lie, as its file says. See
 *  #ShapeClass.texture_place. @param self The mesh. @param hit The points. @param lanes The lanes
 *  that count. */
static TexturePlace mesh_texture_place(const Shape *self, const Hit *hit, mask lanes) {
    return model_texture_place(((const MeshShape *)self)->model, hit, lanes);
}

const ShapeClass mesh_class = {
    .keyword = {.name = "mesh",
                .help = "the triangles of a model file",
                .parameters = mesh_parameters,
                .size = sizeof(MeshParameters),
                .defaults = &mesh_defaults,
                .finish = mesh_finish},
    .size = sizeof(MeshShape),
    .init = mesh_init,
    .bind = mesh_bind,
    .is_hit = mesh_is_hit,
    .is_blocking = mesh_is_blocking,
    .nearest = mesh_nearest,
    .blocked = mesh_blocked,
    .bounds = mesh_bounds,
    .texture_place = mesh_texture_place,
};
