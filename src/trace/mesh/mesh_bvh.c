/**
 * @file
 * @brief Construction of mesh BVHs, and their cache.
 */
#include "trace/mesh/mesh_bvh.h"

#include "trace/shapes/watertight.h"

#include <stdlib.h>
#include <string.h>

/** Alignment, bytes: the widest vector of any engine. */
#define MESH_BVH_ALIGNMENT 64

/** @return A vertex of a triangle. @param corner 0 to 2. */
static Vec3d mesh_triangle_corner(const Mesh *mesh, size_t triangle, int corner) {
    return mesh->positions[mesh->triangles[triangle].index[corner]];
}

/** @return The bounding box of a triangle. */
static Aabbs mesh_triangle_bounds(const Mesh *mesh, size_t triangle) {
    Vertex corners[3];
    for (int i = 0; i < 3; i++) {
        corners[i] = vertex_of(mesh_triangle_corner(mesh, triangle, i));
    }
    return vertices_bounds(corners, 3);
}

/** Computes all bounding boxes. @param[out] boxes The box of each triangle. */
static void mesh_bvh_compute_boxes(MeshBvh *mesh_bvh, const Mesh *mesh, Aabbs *boxes) {
    mesh_bvh->bounds = mesh_triangle_bounds(mesh, 0);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        boxes[i] = mesh_triangle_bounds(mesh, i);
        for (int axis = 0; axis < 3; axis++) {
            scalar low = boxes[i].low[axis], high = boxes[i].high[axis];
            mesh_bvh->bounds.low[axis] =
                low < mesh_bvh->bounds.low[axis] ? low : mesh_bvh->bounds.low[axis];
            mesh_bvh->bounds.high[axis] =
                high > mesh_bvh->bounds.high[axis] ? high : mesh_bvh->bounds.high[axis];
            mesh_bvh->magnitude = -low > mesh_bvh->magnitude ? -low : mesh_bvh->magnitude;
            mesh_bvh->magnitude = high > mesh_bvh->magnitude ? high : mesh_bvh->magnitude;
        }
    }
}

/** Sets one triangle of a block. */
static void triangle_block_set(TriangleBlock *block, int lane, const Mesh *mesh,
                               uint32_t triangle) {
    for (int corner = 0; corner < 3; corner++) {
        Vec3d position = mesh_triangle_corner(mesh, triangle, corner);
        real_set_lane(&block->corners[corner].x, lane, (scalar)position.x);
        real_set_lane(&block->corners[corner].y, lane, (scalar)position.y);
        real_set_lane(&block->corners[corner].z, lane, (scalar)position.z);
    }
    block->triangle_ids[lane] = triangle;
}

/** Copies the triangles in the order of the BVH. @return false without memory. */
static bool mesh_bvh_make_blocks(MeshBvh *mesh_bvh, const Mesh *mesh) {
    _Static_assert(sizeof(TriangleBlock) % sizeof(real) == 0, "a block is whole vectors");
    size_t size = mesh_bvh->bvh.block_count * sizeof *mesh_bvh->blocks;
    mesh_bvh->blocks =
        aligned_alloc(MESH_BVH_ALIGNMENT,
                      (size + MESH_BVH_ALIGNMENT - 1) / MESH_BVH_ALIGNMENT * MESH_BVH_ALIGNMENT);
    for (size_t i = 0; mesh_bvh->blocks && i < mesh_bvh->bvh.block_count * LANES; i++) {
        triangle_block_set(&mesh_bvh->blocks[i / LANES], (int)(i % LANES), mesh,
                           mesh_bvh->bvh.item_indices[i]);
    }
    return mesh_bvh->blocks != NULL;
}

/** @return The normals to interpolate, to be freed; NULL without memory. @param from_file Whether
 * to use those of the file. */
static Vec3s *mesh_bvh_make_normals(const Mesh *mesh, bool from_file) {
    size_t count = from_file ? mesh->normal_count : mesh->position_count;
    Vec3d *smooth = from_file ? NULL : malloc(count * sizeof *smooth);
    Vec3s *normals = malloc(count * sizeof *normals);
    const Vec3d *source = from_file ? mesh->normals : smooth;
    if (smooth) {
        mesh_smooth_normals(mesh, smooth);
    }
    for (size_t i = 0; normals && source && i < count; i++) {
        normals[i] = (Vec3s){(scalar)source[i].x, (scalar)source[i].y, (scalar)source[i].z};
    }
    free(smooth);
    if (!source) {
        free(normals);
        return NULL;
    }
    return normals;
}

/** Copies per-triangle indices in the order of the blocks. @param triangles The indices in the
 * order of the mesh. @return The indices per slot, to be freed; NULL without memory. */
static MeshTriangle *mesh_bvh_order_by_slot(const MeshBvh *mesh_bvh,
                                            const MeshTriangle *triangles) {
    size_t slot_count = mesh_bvh->bvh.block_count * LANES;
    MeshTriangle *ordered = malloc(slot_count * sizeof *ordered);
    for (size_t i = 0; ordered && i < slot_count; i++) {
        ordered[i] = triangles[mesh_bvh->bvh.item_indices[i]];
    }
    return ordered;
}

/** Sets the normals to interpolate, if any. @return false without memory. */
static bool mesh_bvh_init_normals(MeshBvh *mesh_bvh, const Mesh *mesh, NormalSource source) {
    if (source == NORMALS_FLAT) {
        return true;
    }
    bool from_file = source == NORMALS_FROM_FILE && mesh->normal_count > 0;
    const MeshTriangle *normal_indices = from_file ? mesh->triangle_normals : mesh->triangles;
    mesh_bvh->normals = mesh_bvh_make_normals(mesh, from_file);
    mesh_bvh->normal_count = from_file ? mesh->normal_count : mesh->position_count;
    mesh_bvh->normal_indices = mesh_bvh_order_by_slot(mesh_bvh, normal_indices);
    return mesh_bvh->normals && mesh_bvh->normal_indices;
}

/** Sets the texture coordinates, if the mesh has any. @return false without memory. */
static bool mesh_bvh_init_uvs(MeshBvh *mesh_bvh, const Mesh *mesh) {
    if (mesh->uv_count == 0) {
        return true;
    }
    mesh_bvh->uv_count = mesh->uv_count;
    mesh_bvh->uvs = malloc(mesh->uv_count * sizeof *mesh_bvh->uvs);
    for (size_t i = 0; mesh_bvh->uvs && i < mesh->uv_count; i++) {
        mesh_bvh->uvs[i] = (Uvs){(scalar)mesh->uvs[i].u, (scalar)mesh->uvs[i].v};
    }
    mesh_bvh->uv_indices = mesh_bvh_order_by_slot(mesh_bvh, mesh->triangle_uvs);
    return mesh_bvh->uvs && mesh_bvh->uv_indices;
}

/** Releases a mesh BVH; the last release frees it. */
static void mesh_bvh_release(MeshBvh *mesh_bvh) {
    if (mesh_bvh && atomic_fetch_sub(&mesh_bvh->reference_count, 1) == 1) {
        bvh_deinit(&mesh_bvh->bvh);
        free(mesh_bvh->blocks);
        free(mesh_bvh->normals);
        free(mesh_bvh->normal_indices);
        free(mesh_bvh->uvs);
        free(mesh_bvh->uv_indices);
        mesh_release(mesh_bvh->mesh);
        free(mesh_bvh);
    }
}

/** Builds BVH, blocks, normals and texture coordinates. @return false without memory. */
static bool mesh_bvh_build(MeshBvh *mesh_bvh, NormalSource source, const MeshBvhCache *cache) {
    const Mesh *mesh = mesh_bvh->mesh;
    Aabbs *boxes = malloc(mesh->triangle_count * sizeof *boxes);
    if (boxes) {
        mesh_bvh_compute_boxes(mesh_bvh, mesh, boxes);
    }
    bool is_built =
        boxes && bvh_build(&mesh_bvh->bvh, boxes, mesh->triangle_count, LANES, cache->parallel_for);
    free(boxes);
    // The offset of a slot must fit into the 32 bits of a lane.
    is_built =
        is_built && mesh_bvh->bvh.block_count <= (size_t)(INT32_MAX / TRIANGLE_BLOCK_SCALARS) &&
        mesh_bvh_make_blocks(mesh_bvh, mesh) && mesh_bvh_init_normals(mesh_bvh, mesh, source) &&
        (!cache->has_textures || mesh_bvh_init_uvs(mesh_bvh, mesh));
    // From here on, the blocks contain the order.
    free(mesh_bvh->bvh.item_indices);
    mesh_bvh->bvh.item_indices = NULL;
    return is_built;
}

/** @return A new mesh BVH with one reference; NULL without memory. */
static MeshBvh *mesh_bvh_create(Mesh *mesh, NormalSource source, const MeshBvhCache *cache,
                                Error *error) {
    MeshBvh *mesh_bvh = malloc(sizeof *mesh_bvh);
    if (mesh_bvh) {
        *mesh_bvh = (MeshBvh){.triangle_count = mesh->triangle_count, .mesh = mesh_retain(mesh)};
        atomic_init(&mesh_bvh->reference_count, 1);
    }
    if (!mesh_bvh || !mesh_bvh_build(mesh_bvh, source, cache)) {
        mesh_bvh_release(mesh_bvh);
        error_set(error, STATUS_FAILED, "no memory for a tree over %zu triangles",
                  mesh->triangle_count);
        return NULL;
    }
    return mesh_bvh;
}

size_t mesh_bvh_memory_size(const MeshBvh *mesh_bvh) {
    size_t slot_count = mesh_bvh->bvh.block_count * LANES;
    return bvh_memory_size(&mesh_bvh->bvh) + mesh_bvh->bvh.block_count * sizeof *mesh_bvh->blocks +
           mesh_bvh->normal_count * sizeof *mesh_bvh->normals +
           mesh_bvh->uv_count * sizeof *mesh_bvh->uvs +
           (mesh_bvh->normal_indices ? slot_count * sizeof *mesh_bvh->normal_indices : 0) +
           (mesh_bvh->uv_indices ? slot_count * sizeof *mesh_bvh->uv_indices : 0);
}

/** @return The largest coordinate of the camera and of bounded shapes, scene units. */
static double scene_reach(const Scene *scene) {
    Aabbd bounds = aabbd_add_point(scene_bounds(scene), scene->camera.position);
    return fmax(vec3d_max_abs(bounds.low), vec3d_max_abs(bounds.high));
}

bool mesh_bvh_cache_init(MeshBvhCache *cache, const Scene *scene, const MeshBvhCache *reuse_from,
                         const TraceSettings *settings, Error *error) {
    size_t count = scene->mesh_count * NORMAL_SOURCE_COUNT;
    *cache = (MeshBvhCache){.count = count,
                            .meshes = scene->meshes,
                            .reuse_from = reuse_from,
                            .parallel_for = &settings->parallel_for,
                            .has_textures = scene_has_textures(scene),
                            .relaxation = (scalar)settings->relaxation,
                            .methods = settings->methods,
                            .reach = settings->methods ? scene_reach(scene) : 0,
                            .footprint = {.pixel_fraction = (scalar)settings->footprint}};
    cache->entries = calloc(count + 1, sizeof *cache->entries);
    return cache->entries ||
           error_set(error, STATUS_FAILED, "no memory for %zu models", scene->mesh_count);
}

void mesh_bvh_cache_deinit(MeshBvhCache *cache) {
    for (size_t i = 0; cache->entries && i < cache->count; i++) {
        mesh_bvh_release(cache->entries[i]);
    }
    free(cache->entries);
    *cache = (MeshBvhCache){0};
}

/** @return Whether a mesh BVH has the texture coordinates that a scene needs. */
static bool mesh_bvh_is_reusable(const MeshBvh *mesh_bvh, const MeshBvhCache *cache) {
    return !cache->has_textures || mesh_bvh->uvs || mesh_bvh->mesh->uv_count == 0;
}

/** @return A mesh BVH of another tracer, retained; NULL if there is none. */
static MeshBvh *mesh_bvh_reuse(const MeshBvhCache *cache, const Mesh *mesh, NormalSource source) {
    const MeshBvhCache *reuse_from = cache->reuse_from;
    for (size_t i = source; reuse_from && i < reuse_from->count; i += NORMAL_SOURCE_COUNT) {
        MeshBvh *candidate = reuse_from->entries[i];
        if (candidate && candidate->mesh == mesh && mesh_bvh_is_reusable(candidate, cache)) {
            atomic_fetch_add(&candidate->reference_count, 1);
            return candidate;
        }
    }
    return NULL;
}

const MeshBvh *mesh_bvh_cache_get(MeshBvhCache *cache, size_t mesh, NormalSource source,
                                  Error *error) {
    MeshBvh **entry = &cache->entries[mesh * NORMAL_SOURCE_COUNT + source];
    Mesh *source_mesh = cache->meshes[mesh].mesh;
    if (!*entry) {
        *entry = mesh_bvh_reuse(cache, source_mesh, source);
    }
    if (!*entry) {
        *entry = mesh_bvh_create(source_mesh, source, cache, error);
    }
    return *entry;
}
