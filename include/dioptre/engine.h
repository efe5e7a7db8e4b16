/**
 * @file
 * @brief An engine: the whole tracer at one precision and one width.
 *
 * All engines come from the same source, `src/trace/`. Each is an object of this class; nothing
 * else of it can be seen from outside.
 */
#ifndef DIOPTRE_ENGINE_H
#define DIOPTRE_ENGINE_H

#include "dioptre/aov.h"
#include "dioptre/ray_tree.h"
#include "dioptre/scene.h"

#if defined(__SIZEOF_FLOAT128__)
/** The widest number there is: what errors are measured with. */
__extension__ typedef __float128 Quadruple;
#else
/** The widest number there is: what errors are measured with (quad on ARM and RISC-V). */
typedef long double Quadruple;
#endif

/** Where rays that leave a surface start. */
typedef enum {
    OFFSET_NONE,  /**< At the very point: shows the black points of report C. */
    OFFSET_FIXED, /**< One constant away from it, as in the reports. */
    OFFSET_BOUND  /**< As far as that hit's rounding error can reach: the default. */
} OffsetStrategy;

/** Who does work side by side, where there is much of it; NULL in #run: the caller, piece by piece.
 */
typedef struct ParallelFor {
    void *pool;       /**< Handed to #run. */
    int thread_count; /**< How many work at once. */

    /**
     * Does pieces 0 to count - 1 of some work and waits until all are done.
     * @param workers  See #pool.
     * @param count    How many pieces.
     * @param job      Does a piece.
     * @param context  Handed to it.
     */
    void (*run)(void *pool, size_t thread_count, void (*job)(void *context, size_t index),
                void *context);
} ParallelFor;

/** Whether the shapes of a scene get a tree; the picture is the same, to the bit. */
typedef enum {
    BVH_AUTO,  /**< Where they are so many that it pays: the default. */
    BVH_NEVER, /**< They are asked one by one: to measure what a tree is worth. */
    BVH_ALWAYS /**< However few they are. */
} BvhMode;

/** The tracer for one scene; what is in it, only its engine knows. */
typedef struct Tracer Tracer;

/**
 * Default of #TraceSettings.cutoff: a ray of this weight changes no pixel by half a step of 8 bits,
 * 1 / 510, at the dark end of the sRGB curve, whose slope is 12.92.
 */
#define THROUGHPUT_CUTOFF 1.5e-4

/** What a tracer is told besides the scene. */
typedef struct TraceSettings {
    int depth;   /**< How often a ray may be mirrored or refracted. */
    int samples; /**< Rays a pixel; with more than one, balls of light give soft shadows. */
    OffsetStrategy offset; /**< Where secondary rays start. */
    double epsilon;        /**< For #OFFSET_FIXED: how far away, scene units. */
    double cutoff;         /**< Weight below which a ray ends; 0: where it cannot change 8 bits. */
    ParallelFor parallel_for; /**< Who prepares the tracer. */
    BvhMode bvh; /**< Whether the shapes get a tree; the triangles of a mesh always do. */
    const Tracer *reuse_from; /**< Another tracer of the same engine, perhaps at work: the trees
                                      of its meshes are shared where the new one shows the same.
                                      Read while the new one is prepared only; NULL: none. */
    double footprint;  /**< Marched rays are on a surface when they are nearer than this share
                            of half a pixel, seen from the camera; 0: by its tolerance alone. */
    double relaxation; /**< How much longer than allowed their steps are; 0: as it pays. */
} TraceSettings;

/** What a tracer was made of. */
typedef struct TracerStats {
    size_t linear;             /**< Shapes that are asked one by one. */
    size_t in_bvh;             /**< Shapes in the tree; 0: there is none. */
    size_t bvh_threshold;      /**< Shapes with an end from which on they get a tree. */
    size_t triangles;          /**< Triangles of models, each model counted once. */
    size_t triangle_bytes;     /**< Memory of those, with their trees and normals. */
    uint64_t step_limit_count; /**< Rays so far that a distance field gave up: out of steps. */
} TracerStats;

/** A rectangle of pixels, all of them or every n-th, to be traced with one ray each. */
typedef struct PixelGrid {
    int x;                    /**< First column, from the left. */
    int y;                    /**< First row, from the top. */
    int columns;              /**< How many columns of rays, at least 1. */
    int rows;                 /**< How many rows of rays, at least 1. */
    int stride;               /**< Pixels from one ray to the next, both ways, at least 1. */
    int sample;               /**< Which of a pixel's samples; 0 is its centre. */
    const uint16_t *selected; /**< Only these get a ray, of a grid of stride 1: `row * columns +
                                 column` of each; NULL: all do. */
    size_t selected_count;    /**< How many, at least 1. */
    uint64_t *path_hashes; /**< Where a number goes for each ray, in the order of its colour, that
                           says which way its light took: what it met, on which side of its
                           edges, and which lamps it saw. It is the same in all engines but
                           where roundings put a ray on the other side of an edge. NULL: they
                           are not wanted. */
    RayTree *ray_tree; /**< Where the rays of a grid of one pixel are noted, an empty tree; NULL:
                       nobody asks. */
} PixelGrid;

/** How many rays were traced. */
typedef struct RayCounts {
    uint64_t camera;           /**< From the camera. */
    uint64_t reflection;       /**< Mirrored. */
    uint64_t refraction;       /**< Refracted. */
    uint64_t shadow;           /**< To a light. */
    uint64_t total_reflection; /**< How often there was no way to refract a ray: not rays of their
                                  own. */
} RayCounts;

/** @return How many rays were traced in all. @param counts Rays. */
static inline uint64_t ray_counts_sum(const RayCounts *counts) {
    return counts->camera + counts->reflection + counts->refraction + counts->shadow;
}

/** A ray as a question to an engine from outside. */
typedef struct RayQueryQuad {
    Quadruple origin[3];    /**< Where it starts; rounded to the engine's number type. */
    Quadruple direction[3]; /**< Which way, of any length but 0; rounded likewise. */
} RayQueryQuad;

/** A ray as a question in bulk, where only the answer's speed counts. */
typedef struct RayQuery {
    double origin[3];    /**< Where it starts; rounded to the engine's number type. */
    double direction[3]; /**< Which way, of any length but 0; rounded likewise. */
} RayQuery;

/** What an engine answers. */
typedef struct RayResult {
    int shape;           /**< Place of the nearest shape in the scene, or -1: nothing. */
    bool occluded;       /**< What `is_blocking` said, with the limit at infinity. */
    Quadruple distance;  /**< In lengths of the direction. */
    Quadruple point[3];  /**< Where. */
    Quadruple normal[3]; /**< The surface's unit normal there, outwards. */
    Quadruple error;     /**< Bound on how far the point can be off the surface. */
    Quadruple uv[2];     /**< Where on a picture: (u, v). Of meshes only if a shape shows one. */
} RayResult;

/** What an engine needs of the processor. */
typedef enum {
    ENGINE_NEEDS_NOTHING, /**< It runs everywhere. */
    ENGINE_NEEDS_AVX2,    /**< AVX2. */
    ENGINE_NEEDS_AVX512   /**< AVX-512 DQ and VL. */
} EngineNeeds;

/** The tracer at one precision and width. */
typedef struct Engine {
    const char *name;  /**< Such as `f32x8`: type, bits and lanes. */
    int lanes;         /**< Rays at once. */
    int mantissa_bits; /**< Of its number type, the leading 1 included: 24, 53, 113. */
    EngineNeeds needs; /**< What the processor must be able to do. */

    /**
     * Makes the tracer for a scene, with only what this scene needs.
     * @param scene     The scene; read during this call only.
     * @param settings  Depth, offset, tree and crew.
     * @param[out] error  What is wrong.
     * @return The tracer, to be given back with #destroy; NULL without memory.
     */
    Tracer *(*create_tracer)(const Scene *scene, const TraceSettings *settings, Error *error);

    /**
     * Takes camera, lights and picture size anew from a scene whose shapes are the same.
     * @param tracer  The tracer.
     * @param scene   The scene, with as many lights as before.
     * @param width   Pixels of the whole picture.
     * @param height  Pixels of the whole picture.
     */
    void (*set_view)(Tracer *tracer, const Scene *scene, int width, int height);

    /**
     * Traces one ray for each point of a grid of pixels, or for the chosen ones. Any number of
     * threads may trace at once.
     * @param tracer       The tracer, after #set_view.
     * @param grid         Which pixels.
     * @param[out] rgb     Linear colours: the red of all rays, row by row or in the order of the
     *                     chosen, then green, then blue.
     * @param[in,out] counts  The rays traced are added to this.
     */
    void (*trace)(const Tracer *tracer, const PixelGrid *grid, double *rgb, RayCounts *counts);

    /**
     * Only finds the nearest hit of each pixel's ray: no shading, no other rays.
     * @param tracer         The tracer, after #set_view.
     * @param grid           Which pixels.
     * @param[out] shapes    The shape met, or -1, row by row.
     * @param[out] distances How far, or infinity, row by row.
     */
    void (*trace_primary)(const Tracer *tracer, const PixelGrid *grid, int *shapes,
                          double *distances);

    /**
     * Surveys a grid of pixels: what their rays do, in numbers. Any number of threads may at once.
     * @param tracer       The tracer, after #set_view.
     * @param grid         Which pixels, all of them.
     * @param wanted       What of them besides what they meet first: #AOV_RADIANCE and so on.
     * @param[out] points  What is known of them, row by row.
     * @param[in,out] counts  The rays traced are added to this.
     */
    void (*trace_aovs)(const Tracer *tracer, const PixelGrid *grid, unsigned wanted,
                       AovSample *points, RayCounts *counts);

    /**
     * Finds the nearest hit of any rays: no shading, no other rays.
     * @param tracer         The tracer.
     * @param count          How many.
     * @param rays           The rays.
     * @param[out] shapes    The shape that each meets, or -1.
     * @param[out] distances How far, in lengths of its direction, or infinity.
     */
    void (*closest_hits)(const Tracer *tracer, size_t count, const RayQuery *rays, int *shapes,
                         double *distances);

    /**
     * Finds which of any rays meet anything at all, however far: less work than the nearest hit.
     * @param tracer         The tracer.
     * @param count          How many.
     * @param rays           The rays.
     * @param[out] shadowed  Whether each meets anything.
     */
    void (*occluded)(const Tracer *tracer, size_t count, const RayQuery *rays, bool *shadowed);

    /**
     * Answers any rays in full, with every bit of the engine's numbers: for tests and probes.
     * @param tracer        The tracer.
     * @param count         How many.
     * @param queries       The rays.
     * @param[out] answers  As many answers.
     */
    void (*intersect)(const Tracer *tracer, size_t count, const RayQueryQuad *queries,
                      RayResult *answers);

    /**
     * Finds where a box holds all bounded shapes.
     * @param tracer     The tracer.
     * @param[out] low   Its lowest corner.
     * @param[out] high  Its highest; lower than the lowest where no shape is bounded.
     */
    void (*bounds)(const Tracer *tracer, Vec3d *low, Vec3d *high);

    /** @return What a tracer was made of. @param tracer The tracer. */
    TracerStats (*stats)(const Tracer *tracer);

    /** Gives a tracer back. @param tracer The tracer, or NULL. */
    void (*destroy)(Tracer *tracer);
} Engine;

/**
 * @return The engines that this program was built with, the preferred first; ended by NULL.
 */
const Engine *const *engine_list(void);

/**
 * @return Whether this machine's processor can run an engine.
 * @param engine  The engine.
 */
bool engine_is_supported(const Engine *engine);

/**
 * Finds an engine.
 * @param name        Its name, or `auto` for the first of #engine_list that the processor can run.
 * @param[out] error  Which names there are, or what the processor lacks.
 * @return The engine, or NULL.
 */
const Engine *engine_find(const char *name, Error *error);

/** The purpose that an engine is chosen for. */
typedef enum {
    ENGINE_FASTEST,  /**< The default: the preferred engine of this processor. */
    ENGINE_DOUBLE,   /**< Where single precision shows errors. */
    ENGINE_REFERENCE /**< Errors are measured against it: more bits than double. */
} EngineRole;

/** @return The preferred engine for a purpose that this processor can run; NULL: none is built. */
const Engine *engine_with_role(EngineRole role);

/** @return The engine with one lane of the same number type, whose bits are the same; the engine
 *          itself where no such engine is built. */
const Engine *engine_scalar(const Engine *engine);

#endif
