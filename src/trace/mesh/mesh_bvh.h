/**
 * @file
 * @brief Models: the triangles of a mesh in the engine's number type, and the tree over them.
 *
 * A model is made once for each mesh and way of taking normals; all shapes that show it share it,
 * and so do the tracers of a film's frames, each of which takes it from the one before.
 */
#ifndef DIOPTRE_TRACE_MESH_MESH_BVH_H
#define DIOPTRE_TRACE_MESH_MESH_BVH_H

#include "dioptre/mesh.h"
#include "trace/bvh/bvh.h"
#include "trace/sdf/step_limit.h"
#include "trace/tracer/footprint.h"

/** LANES triangles side by side. */
typedef struct TriangleBlock {
    /** Their corners, in turn. Aligned to a vector, where the compiler asks for less of quad: the
     *  size of a block must be a whole number of vectors (see #TRIANGLE_BLOCK_SCALARS). */
    _Alignas(sizeof(real)) Vec3 corners[3];
    uint32_t triangle_ids[LANES]; /**< Their places in the mesh; the last is repeated to fill up. */
} TriangleBlock;

/** Numbers that a block takes in memory: what a slot's numbers are found by. */
#define TRIANGLE_BLOCK_SCALARS ((int)(sizeof(TriangleBlock) / sizeof(scalar)))
_Static_assert(sizeof(TriangleBlock) % sizeof(real) == 0, "a block is a whole number of vectors");

/** A place on a picture. */
typedef struct Uvs {
    scalar u; /**< To the right. */
    scalar v; /**< Up. */
} Uvs;

/** The triangles of a mesh; it does not change once it is made. */
typedef struct MeshBvh {
    atomic_uint reference_count;  /**< How many tracers hold it. */
    Mesh *mesh;                   /**< What it was made of; it is one of the owners. */
    Bvh bvh;                      /**< The tree over them. */
    TriangleBlock *blocks;        /**< The triangles, as the tree orders them; owned. */
    size_t triangle_count;        /**< How many, repeated ones not counted. */
    Vec3s *normals;               /**< Unit normals to interpolate; owned. NULL: flat. */
    size_t normal_count;          /**< How many. */
    MeshTriangle *normal_indices; /**< For each slot of the blocks, the places of its corners'
                               normals; owned. NULL: flat. */
    Uvs *uvs;                 /**< Places on a picture; owned. NULL: there are none, or no material
                                      has a picture. */
    size_t uv_count;          /**< How many. */
    MeshTriangle *uv_indices; /**< For each slot of the blocks, the places in #uvs of its corners;
                                owned. NULL as they. */
    Aabbs bounds;             /**< The box around all of it. */
    scalar magnitude;         /**< Largest coordinate: what rounding errors scale with. */
} MeshBvh;

/** @return Bytes that a model holds. */
size_t mesh_bvh_memory_size(const MeshBvh *mesh_bvh);

/** The models of a scene, each made, or shared, when a shape first asks for it. */
struct MeshBvhCache {
    MeshBvh **entries; /**< #NORMAL_SOURCE_COUNT for each mesh of the scene; NULL where no shape has
                      asked. It is one of the owners of each. */
    size_t count;      /**< How many. */
    const SceneMesh *meshes;         /**< The scene's meshes; while shapes are made only. */
    const MeshBvhCache *reuse_from;  /**< Where some may be there already, or NULL; likewise. */
    const ParallelFor *parallel_for; /**< Who builds trees; likewise. */
    bool has_textures;               /**< Whether any shape shows a picture. */
    scalar relaxation;               /**< See #TraceSettings.relaxation. */
    Footprint footprint;             /**< How finely the camera sees. */
    StepLimitCounter
        step_limit_counter; /**< Rays that were given up before they met a shape or nothing. */
};

/**
 * Makes room for the models of a scene.
 * @param[out] cache  The models; give them back with #mesh_bvh_cache_deinit.
 * @param reuse_from  Those of another tracer, to be shared; NULL: none. Read, as the crew is, while
 *         shapes are made.
 * @param settings  Who builds trees, and how fields are marched.
 * @return false without memory.
 */
bool mesh_bvh_cache_init(MeshBvhCache *cache, const Scene *scene, const MeshBvhCache *reuse_from,
                         const TraceSettings *settings, Error *error);

/** Gives models back; those that no other tracer holds are gone then. */
void mesh_bvh_cache_deinit(MeshBvhCache *cache);

/**
 * @return A model, made now if nobody has asked before and no former tracer has it; NULL without
 *         memory.
 * @param mesh  Place of the mesh in the scene.
 * @param source  Where its normals come from.
 */
const MeshBvh *mesh_bvh_cache_get(MeshBvhCache *cache, size_t mesh, NormalSource source,
                                  Error *error);

/**
 * Finds where the rays of a packet meet a model.
 * @param shape_index  The shape's place in the scene.
 * @param[in,out] hits  What they have met so far.
 */
void mesh_bvh_closest_hits(const MeshBvh *mesh_bvh, const Packet *packet, int shape_index,
                           Hit *hits);

/** @return Where on a picture points of a model lie, as its file says. See #ShapeClass.texture_uv.
 */
TextureUv mesh_bvh_texture_uv(const MeshBvh *mesh_bvh, const Hit *hit, mask lanes);

/** Finds which rays of a packet meet a model before their limit. @param[in,out] occluded Those that
 *  are blocked; they are not asked again. */
void mesh_bvh_occluded(const MeshBvh *mesh_bvh, const Packet *packet, mask *occluded);

#endif
