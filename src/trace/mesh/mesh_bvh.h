/**
 * @file
 * @brief Mesh BVH: the triangles of a mesh in the engine's number type, and the BVH over them.
 *
 * There is one for each mesh and source of normals. All shapes of that mesh share it; so do the
 * tracers of the frames of a film, each of which takes it over from the previous one.
 */
#ifndef DIOPTRE_TRACE_MESH_MESH_BVH_H
#define DIOPTRE_TRACE_MESH_MESH_BVH_H

#include "dioptre/mesh.h"
#include "trace/bvh/bvh.h"
#include "trace/sdf/step_limit.h"
#include "trace/tracer/footprint.h"

/** LANES triangles side by side. */
typedef struct TriangleBlock {
    /** Their vertices, in turn. Aligned to a vector, because the compiler aligns quad to less: the
     *  size of a block must be a whole number of vectors (see #TRIANGLE_BLOCK_SCALARS). */
    _Alignas(sizeof(real)) Vec3 corners[3];
    uint32_t triangle_ids[LANES]; /**< Their indices in the mesh; the last one repeats to fill the
                                     block. */
} TriangleBlock;

/** Size of a block in scalars, to compute the offset of a slot: one lane of one block. */
#define TRIANGLE_BLOCK_SCALARS ((int)(sizeof(TriangleBlock) / sizeof(scalar)))

/** Texture coordinates. */
typedef struct Uvs {
    scalar u; /**< To the right. */
    scalar v; /**< Up. */
} Uvs;

/** The triangles of a mesh; constant once built. */
typedef struct MeshBvh {
    atomic_uint reference_count;  /**< Number of tracers that use it. */
    Mesh *mesh;                   /**< The mesh; retained. */
    Bvh bvh;                      /**< BVH over the blocks. */
    TriangleBlock *blocks;        /**< The triangles in the order of the BVH; owned. */
    size_t triangle_count;        /**< Number of triangles, without repeated ones. */
    Vec3s *normals;               /**< Unit normals to interpolate; owned. NULL: flat. */
    size_t normal_count;          /**< Number of #normals. */
    MeshTriangle *normal_indices; /**< Per slot, the indices of its vertices in #normals; owned.
                                       NULL: flat. */
    Uvs *uvs;                     /**< Texture coordinates; owned. NULL: the mesh has none, or no
                                       material has a texture. */
    size_t uv_count;              /**< Number of #uvs. */
    MeshTriangle *uv_indices;     /**< Per slot, the indices of its vertices in #uvs; owned. NULL if
                                       #uvs is. */
    Aabbs bounds;                 /**< Bounding box. */
    scalar magnitude;             /**< Largest coordinate: rounding errors scale with it. */
} MeshBvh;

/** @return Bytes of the memory of a mesh BVH. */
size_t mesh_bvh_memory_size(const MeshBvh *mesh_bvh);

/** The mesh BVHs of a scene, each built or reused when the first shape needs it, and the data that
 *  all distance fields share. */
struct MeshBvhCache {
    MeshBvh **entries;       /**< #NORMAL_SOURCE_COUNT per mesh of the scene; NULL if no shape needs
                                  it. Retained. */
    size_t count;            /**< Number of #entries. */
    const SceneMesh *meshes; /**< Meshes of the scene; valid during the creation of shapes only. */
    const MeshBvhCache *reuse_from;  /**< Cache of another tracer, or NULL; likewise. */
    const ParallelFor *parallel_for; /**< Threads for the construction; likewise. */
    bool has_textures;               /**< Whether any material has a texture. */
    scalar relaxation;               /**< #TraceSettings.relaxation */
    unsigned methods;                /**< #TraceSettings.methods */
    double reach;                    /**< Largest coordinate of the camera, as it is at first, and
                                          of bounded shapes; only with #methods. */
    Footprint footprint;             /**< Size of a pixel, for the tolerance of SDFs. */
    StepLimitCounter step_limit_counter; /**< Rays that have reached the step limit of an SDF. */
};

/**
 * Creates an empty cache.
 * @param[out] cache  The cache; the caller frees it with #mesh_bvh_cache_deinit.
 * @param reuse_from  Cache of another tracer, or NULL; read during the creation of shapes only.
 * @param settings    Threads, and settings of sphere tracing.
 * @return false without memory.
 */
bool mesh_bvh_cache_init(MeshBvhCache *cache, const Scene *scene, const MeshBvhCache *reuse_from,
                         const TraceSettings *settings, Error *error);

/** Releases all entries. */
void mesh_bvh_cache_deinit(MeshBvhCache *cache);

/**
 * @return A mesh BVH: from the cache, reused from another tracer, or built now; NULL without
 * memory.
 * @param mesh    Index in #Scene.meshes.
 * @param source  Source of the normals.
 */
const MeshBvh *mesh_bvh_cache_get(MeshBvhCache *cache, size_t mesh, NormalSource source,
                                  Error *error);

/**
 * Finds the closest hits of a packet with a mesh.
 * @param shape_index   Index of the shape in the scene.
 * @param[in,out] hits  Nearest hits so far.
 */
void mesh_bvh_closest_hits(const MeshBvh *mesh_bvh, const Packet *packet, int shape_index,
                           Hit *hits);

/** @return Interpolated texture coordinates of the file. See #ShapeClass.texture_uv. */
TextureUv mesh_bvh_texture_uv(const MeshBvh *mesh_bvh, const Hit *hit, mask lanes);

/** Finds the rays of a packet that meet a mesh before their limit. @param[in,out] occluded The
 *  occluded rays; they are not tested again. */
void mesh_bvh_occluded(const MeshBvh *mesh_bvh, const Packet *packet, mask *occluded);

#endif
