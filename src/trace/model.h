/**
 * @file
 * @brief Models: the triangles of a mesh in the engine's number type, and the tree over them.
 *
 * A model is made once for each mesh and way of taking normals; all shapes that show it share it,
 * and so do the tracers of a film's frames, each of which takes it from the one before.
 */
#ifndef DIOPTRE_TRACE_MODEL_H
#define DIOPTRE_TRACE_MODEL_H

#include "dioptre/mesh.h"
#include "trace/footprint.h"
#include "trace/stalls.h"
#include "trace/tree.h"

/** LANES triangles side by side. */
typedef struct TriangleBlock {
    /** Their corners, in turn. Aligned to a vector, where the compiler asks for less of quad: the
     *  size of a block must be a whole number of vectors (see #BLOCK_NUMBERS). */
    _Alignas(sizeof(real)) Vector corners[3];
    uint32_t triangles[LANES]; /**< Their places in the mesh; the last is repeated to fill up. */
} TriangleBlock;

/** Numbers that a block takes in memory: what a slot's numbers are found by. */
#define BLOCK_NUMBERS ((int)(sizeof(TriangleBlock) / sizeof(scalar)))
_Static_assert(sizeof(TriangleBlock) % sizeof(real) == 0, "a block is a whole number of vectors");

/** A place on a picture. */
typedef struct Spot {
    scalar u; /**< To the right. */
    scalar v; /**< Up. */
} Spot;

/** The triangles of a mesh; it does not change once it is made. */
typedef struct Model {
    atomic_uint owners;    /**< How many tracers hold it. */
    Mesh *mesh;            /**< What it was made of; it is one of the owners. */
    Tree tree;             /**< The tree over them. */
    TriangleBlock *blocks; /**< The triangles, as the tree orders them; owned. */
    size_t triangle_count; /**< How many, repeated ones not counted. */
    Point *normals;        /**< Unit normals to interpolate; owned. NULL: flat. */
    size_t normal_count;   /**< How many. */
    MeshTriangle *places;  /**< For each slot of the blocks, the places of its corners' normals;
                                owned. NULL: flat. */
    Spot *spots;           /**< Places on a picture; owned. NULL: there are none, or no material
                                has a picture. */
    size_t spot_count;     /**< How many. */
    MeshTriangle *spot_at; /**< For each slot of the blocks, the places in #spots of its corners;
                                owned. NULL as they. */
    Bounds bounds;         /**< The box around all of it. */
    scalar reach;          /**< Largest coordinate: what rounding errors scale with. */
} Model;

/** @return Bytes that a model holds. @param model The model. */
size_t model_size(const Model *model);

/** Where the normals of a model come from. */
typedef enum {
    NORMALS_FILE,   /**< The file's; smooth where it has none. */
    NORMALS_SMOOTH, /**< Worked out from the triangles around each corner. */
    NORMALS_FLAT    /**< Each triangle's own. */
} NormalSource;

/** Models that a mesh can be made into: one for each #NormalSource. */
enum { MODEL_KINDS = 3 };

/** The models of a scene, each made, or shared, when a shape first asks for it. */
struct Models {
    Model **all;             /**< #MODEL_KINDS for each mesh of the scene; NULL where no shape has
                                  asked. It is one of the owners of each. */
    size_t count;            /**< How many. */
    const SceneMesh *meshes; /**< The scene's meshes; while shapes are made only. */
    const Models *former;    /**< Where some may be there already, or NULL; likewise. */
    const Crew *crew;        /**< Who builds trees; likewise. */
    bool has_textures;       /**< Whether any shape shows a picture. */
    scalar relaxation;       /**< See #TraceSettings.relaxation. */
    Footprint footprint;     /**< How finely the camera sees. */
    Stalls stalls;           /**< Rays that were given up before they met a shape or nothing. */
};

/**
 * Makes room for the models of a scene.
 * @param[out] models  The models; give them back with #models_release.
 * @param scene        The scene.
 * @param former       Those of another tracer, to be shared; NULL: none. Read, as the crew is,
 * while shapes are made.
 * @param settings     Who builds trees, and how fields are marched.
 * @param[out] error   What is wrong.
 * @return false without memory.
 */
bool models_init(Models *models, const Scene *scene, const Models *former,
                 const TraceSettings *settings, Error *error);

/** Gives models back; those that no other tracer holds are gone then. @param models The models. */
void models_release(Models *models);

/**
 * @return A model, made now if nobody has asked before and no former tracer has it; NULL without
 *         memory.
 * @param models      The models.
 * @param mesh        Place of the mesh in the scene.
 * @param source      Where its normals come from.
 * @param[out] error  What is wrong.
 */
const Model *models_get(Models *models, size_t mesh, NormalSource source, Error *error);

/**
 * Finds where the rays of a packet meet a model.
 * @param model   The model.
 * @param packet  The rays.
 * @param place   The shape's place in the scene.
 * @param[in,out] hits  What they have met so far.
 */
void model_nearest(const Model *model, const Packet *packet, int place, Hit *hits);

/**
 * @return Where on a picture points of a model lie, as its file says. See
 *         #ShapeClass.texture_place.
 * @param model  The model.
 * @param hit    The points.
 * @param lanes  The lanes that count.
 */
TexturePlace model_texture_place(const Model *model, const Hit *hit, mask lanes);

/**
 * Finds which rays of a packet meet a model before their limit.
 * @param model   The model.
 * @param packet  The rays.
 * @param[in,out] blocked  Those that are blocked; they are not asked again.
 */
void model_blocked(const Model *model, const Packet *packet, mask *blocked);

#endif
