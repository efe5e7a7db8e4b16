/**
 * @file
 * @brief Mesh: the triangles of a file.
 *
 * The triangles and the BVH over them are a #MeshBvh, which all shapes with the same file and the
 * same normals share. The shape only refers to it.
 */
#include "trace/mesh/mesh_bvh.h"

/** A mesh. @extends Shape */
typedef struct MeshShape {
    Shape base;                 /**< Base. */
    size_t mesh_index;          /**< Index in #Scene.meshes. */
    NormalSource normal_source; /**< Where the normals come from. */
    const MeshBvh *bvh;         /**< The triangles; the tracer's. */
} MeshShape;

/** See #ShapeClass.init. */
static void mesh_shape_init(Shape *self, const void *parameters) {
    MeshShape *mesh = (MeshShape *)self;
    const MeshShapeParameters *p = parameters;
    mesh->mesh_index = p->file;
    mesh->normal_source = (NormalSource)p->normals;
}

/** Finds or builds the triangles. See #ShapeExtension.bind. @return false without memory. */
static bool mesh_shape_bind(Shape *self, const SceneShape *scene_shape, MeshBvhCache *cache,
                            Error *error) {
    (void)scene_shape;
    MeshShape *mesh = (MeshShape *)self;
    mesh->bvh = mesh_bvh_cache_get(cache, mesh->mesh_index, mesh->normal_source, error);
    return mesh->bvh != NULL;
}

/** See #ShapeExtension.closest_hits. @callgraph */
static void mesh_shape_closest_hits(const Shape *self, const Packet *packet, Hit *hits) {
    mesh_bvh_closest_hits(((const MeshShape *)self)->bvh, packet, self->index, hits);
}

/** See #ShapeExtension.occluded. */
static void mesh_shape_occluded(const Shape *self, const Packet *packet, mask *occluded) {
    mesh_bvh_occluded(((const MeshShape *)self)->bvh, packet, occluded);
}

/** @return A packet of one vector of rays. @param limit Largest distance. */
static Packet packet_of_vector(const Ray *ray, mask active, real limit) {
    Packet packet = {.rays = {*ray}, .limit = {limit}};
    packet_init(&packet, 1, true);
    packet.active[0] = active;
    return packet;
}

/** See #ShapeClass.is_hit. */
static mask mesh_shape_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    Packet packet = packet_of_vector(ray, active, hit->distance);
    Hit hits[PACKET_VECTORS] = {*hit};
    mesh_shape_closest_hits(self, &packet, hits);
    mask nearer = active & ((hits[0].distance < hit->distance) | (hits[0].shape != hit->shape));
    *hit = hits[0];
    return nearer;
}

/** See #ShapeClass.is_occluding. */
static mask mesh_shape_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    Packet packet = packet_of_vector(ray, active, limit);
    mask occluded[PACKET_VECTORS] = {0};
    mesh_shape_occluded(self, &packet, occluded);
    return active & occluded[0];
}

/** See #ShapeClass.bounds. */
static Aabbs mesh_shape_bounds(const Shape *self) {
    return ((const MeshShape *)self)->bvh->bounds;
}

/** @return The texture coordinates of the file. See #ShapeClass.texture_uv. */
static TextureUv mesh_shape_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    return mesh_bvh_texture_uv(((const MeshShape *)self)->bvh, hit, lanes);
}

/** A mesh has its own BVH. */
static const ShapeExtension mesh_shape_extension = {
    .bind = mesh_shape_bind,
    .has_bvh = true,
    .closest_hits = mesh_shape_closest_hits,
    .occluded = mesh_shape_occluded,
};

/** Methods of `mesh`. */
const ShapeClass mesh_class = {
    .size = sizeof(MeshShape),
    .init = mesh_shape_init,
    .is_hit = mesh_shape_is_hit,
    .is_occluding = mesh_shape_is_occluding,
    .bounds = mesh_shape_bounds,
    .texture_uv = mesh_shape_texture_uv,
    .extension = &mesh_shape_extension,
};
