/**
 * @file
 * @brief An engine: the tracer, compiled for one number type and one number of SIMD lanes.
 *
 * All engines are compiled from the same source, `src/trace/`. Each is an object of class #Engine,
 * and its only exported symbol.
 */
#ifndef DIOPTRE_ENGINE_H
#define DIOPTRE_ENGINE_H

#include "base/vec3d.h"
#include "dioptre/report_methods.h"
#include "dioptre/scene.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* --- Arbitrary output variables (AOVs): what layers show -------------------------------------- */

/** Optional AOVs, as bits of a mask. The first hit of the camera ray is always there. */
enum {
    AOV_RADIANCE = 1,  /**< From full shading: colour, ray count, lights, secondary hits. */
    AOV_STEPS = 2,     /**< The sphere-tracing steps of the camera ray. */
    AOV_UV = 4,        /**< Texture coordinates of the first hit. */
    AOV_OPERATIONS = 8 /**< The operations on distances of the camera ray. */
};

/** Number of lights that have a bit in the masks; further lights are not recorded. */
enum { AOV_MAX_LIGHTS = 64 };

/** Secondary rays of the first hit: reflected and refracted. */
enum { AOV_MAX_SECONDARY = 2 };

/** The AOVs of one pixel. */
typedef struct AovSample {
    int shape;        /**< Index of the shape hit first; -1: none. */
    double distance;  /**< Distance to it, or to a lamp that is seen, scene units; else infinite. */
    double normal[3]; /**< Outward unit normal there; zero without a hit. */
    double uv[2];     /**< Texture coordinates; with #AOV_UV. */
    double color[3];  /**< Radiance, linear; with #AOV_RADIANCE. */
    uint32_t ray_count;       /**< Rays of the pixel, of all kinds; with #AOV_RADIANCE. */
    uint32_t step_count;      /**< Sphere-tracing steps; with #AOV_STEPS. */
    uint64_t operation_count; /**< Operations on distances; with #AOV_OPERATIONS. */
    uint64_t lights_tested;   /**< Bit i: light i has a shadow ray there. */
    uint64_t lights_occluded; /**< Bit i: that shadow ray is occluded. */
    int secondary_shapes[AOV_MAX_SECONDARY]; /**< Shapes that secondary rays hit, as
                                #shape; the reflected one first. */
    uint32_t secondary_count;                /**< Number of secondary rays. */
} AovSample;

/* --- The ray tree of one pixel ---------------------------------------------------------------- */

/** The type of a ray. */
typedef enum {
    RAY_CAMERA,     /**< From the camera: the root of the tree. */
    RAY_SHADOW,     /**< From a surface to a light. */
    RAY_REFLECTION, /**< Reflected by a surface. */
    RAY_REFRACTION  /**< Refracted into or out of a transparent shape. */
} RayType;

/** Largest number of rays of a tree, to limit its memory. */
enum { RAY_TREE_MAX_NODES = 1 << 20 };

/**
 * Optics of a surface at a hit. Without secondary rays, its colour is `emission + albedo (ambient +
 * diffuse D) + specular S`. D and S are the sums of #RayTreeNode.diffuse and #RayTreeNode.specular
 * of its shadow rays, in their order.
 */
typedef struct RayTreeSurface {
    double epsilon;      /**< Offset of rays that leave the surface, scene units. */
    double ulps;         /**< The same in ulps of the largest coordinate of the point. */
    double cosine;       /**< Cosine of the angle of incidence. */
    bool is_inside;      /**< Whether the ray comes from inside. */
    bool is_transparent; /**< Whether light is refracted; otherwise the next five are unset. */
    bool is_overridden;  /**< Whether a later shape overrides the interface. */
    bool is_total;       /**< Whether reflection is total. */
    double ior_from;     /**< Index of refraction on the side of the ray. */
    double ior_to;       /**< Index of refraction on the other side of the surface. */
    double fresnel;      /**< Fresnel reflectance. */
    Rgbd emission;       /**< Emitted light. */
    Rgbd albedo;         /**< Diffuse albedo, times its weight and the texture. */
    Rgbd specular;       /**< Weight of highlights. */
    Rgbd ambient;        /**< Ambient light. */
    double diffuse;      /**< Weight of diffuse light of the lights. */
    Rgbd reflect_weight; /**< Weight of a reflected ray's colour, whether it was traced or not. */
    Rgbd refract_weight; /**< Weight of a refracted ray's colour, likewise. */
} RayTreeSurface;

/** A step of sphere tracing: where the field was evaluated, and how far everything is from there.
 */
typedef struct RayMarchStep {
    double distance; /**< Along the ray, scene units. */
    double radius;   /**< Of the sphere that is free: what the field gives there, scene units; below
                          the tolerance at the hit. */
} RayMarchStep;

/** A ray of the tree. */
typedef struct RayTreeNode {
    int parent;        /**< Index of the ray that it comes from, below its own; -1: none. */
    RayType kind;      /**< Its type. */
    int depth;         /**< Number of its ancestors. */
    Vec3d origin;      /**< Its origin, scene units. */
    Vec3d direction;   /**< Its direction, a unit vector. */
    double limit;      /**< Its length, scene units: to the light, or infinity. */
    double throughput; /**< Largest channel of the product of weights from the pixel; of shadow
                            rays that of the surface. */
    Rgbd weight;       /**< Weight of its colour in that of its parent. */
    bool is_hit;       /**< Whether it hits a shape or a light; of a shadow ray: whether no light
                            arrives. */
    int shape;         /**< Index of the shape that it hits; -1: none. */
    int light;         /**< Index of the light that it is sent to, or hits; -1: none. */
    double distance;   /**< Distance of the hit, scene units; infinity: none. */
    Vec3d point;       /**< The hit point. */
    Vec3d normal;      /**< Outward unit normal there. */
    RayTreeSurface surface; /**< Optics of the surface hit; not of shadow rays. */
    Rgbd diffuse;           /**< Of shadow rays: V L f max(0, n . l), for diffuse light. */
    Rgbd specular;          /**< Of shadow rays: V L f max(0, r . v)^shininess, for highlights. */
    Rgbd transmittance; /**< Of shadow rays: fraction of the light that transparent shapes leave. */
    Vec3d engine_origin;    /**< The origin in the tracer's coordinates, as the engine has it. */
    Vec3d engine_direction; /**< The direction as the engine has it, of its length there. */
    Vec3d engine_point;     /**< The hit point in the tracer's coordinates, as the engine has it. */
    size_t first_step; /**< Of camera and secondary rays that march: index in #RayTree.steps. */
    size_t step_count; /**< Number of steps; 0: none. */
    double cosine;     /**< Of shadow rays: n . l, the cosine at the surface. */
    double falloff;    /**< Of shadow rays: the factor f of the light's intensity there. */
    Rgbd local_color;  /**< Radiance without secondary rays: of the sky, a light or a surface. */
    Rgbd color;        /**< Radiance: #local_color plus the weighted colours of secondary
                            rays; of the first ray, #RayTree.merged_light, too. */
} RayTreeNode;

/** The ray tree of one pixel. Starts as `{0}`; freed by #ray_tree_deinit. */
typedef struct RayTree {
    RayTreeNode *nodes;   /**< The rays, each after its parent; owned. */
    size_t count;         /**< Number of rays. */
    size_t capacity;      /**< Capacity of #nodes. */
    RayMarchStep *steps;  /**< Steps of sphere tracing of all rays; owned. */
    size_t step_count;    /**< Number of #steps. */
    size_t step_capacity; /**< Capacity of #steps. */
    Vec3d origin;         /**< Where in the scene the tracer's coordinates start. */
    int current;          /**< While recording: the ray being traced. */
    Rgbd merged_light;    /**< The colour of the pixel minus the sum of the first ray's terms: light
                             of rays that are merged, because there are too many, or an estimate of
                             it. A channel may be below 0. */
    bool is_truncated;    /**< Whether rays are missing, for lack of memory or beyond
                             #RAY_TREE_MAX_NODES. */
} RayTree;

/** @return Whether a tree has #RayTree.merged_light. */
static inline bool ray_tree_has_merged_light(const RayTree *tree) {
    const Rgbd *light = &tree->merged_light;
    return light->red != 0 || light->green != 0 || light->blue != 0;
}

/** Frees the rays of a tree and empties it. */
void ray_tree_deinit(RayTree *tree);

/* --- The engine ------------------------------------------------------------------------------- */

#if defined(__SIZEOF_FLOAT128__)
/** The widest number type, in which errors are measured. */
__extension__ typedef __float128 Quadruple;
#else
/** The widest number type, in which errors are measured (quad on ARM and RISC-V). */
typedef long double Quadruple;
#endif

/** A parallel for loop. #run is NULL: the caller runs the iterations one by one. */
typedef struct ParallelFor {
    void *pool;       /**< Passed to #run. */
    int thread_count; /**< Number of threads. */

    /**
     * Runs iterations 0 to count - 1, and returns when all are finished.
     * @param pool  See #pool.
     * @param count  Number of iterations.
     * @param job  One iteration.
     * @param context  Passed to it.
     */
    void (*run)(void *pool, size_t count, void (*job)(void *context, size_t index), void *context);
} ParallelFor;

/** Whether a BVH is built over the shapes of a scene; the image is the same, to the bit. */
typedef enum {
    BVH_AUTO,  /**< If there are enough shapes for it to be faster: the default. */
    BVH_NEVER, /**< Never: to measure the benefit of the BVH. */
    BVH_ALWAYS /**< Always. */
} BvhMode;

/** The tracer of one scene; opaque outside its engine. */
typedef struct Tracer Tracer;

/**
 * Throughput below which rays end in the first pass, where #CUTOFF_DEFAULT is the cutoff and no
 * light is brighter than 1 (see doc/cutoff.md).
 */
#define THROUGHPUT_CUTOFF 1.5e-4

/** Where in its pixel a ray goes. */
typedef enum {
    PIXEL_CENTER, /**< Through the centre, and samples around it: the default. */
    PIXEL_CORNER  /**< Half a pixel to the left and up: through the corner, without the 0.5 that
                       report A adds. */
} PixelPoint;

/** Most secondary rays of one sample of a pixel for which a further pass is begun. */
#define RAYS_PER_SAMPLE_MAXIMUM 4096

/** How a tracer traces a scene. */
typedef struct TraceSettings {
    int depth;   /**< Largest number of successive reflections and refractions;
                      #DEPTH_MAXIMUM: as many as the weight of a ray asks for. */
    int samples; /**< Rays per pixel; if more than one, spherical lights cast soft shadows. */
    OffsetStrategy offset; /**< Distance from a surface at which secondary rays start. */
    double epsilon;        /**< The distance for #OFFSET_FIXED, scene units. */
    double cutoff; /**< Largest error of a pixel by all rays that end for their low throughput,
                        in 8-bit steps of the encoded picture; 0: no ray ends for that. */
    int encoding;  /**< The #Encoding of the picture, whose steps the cutoff counts. */
    ParallelFor parallel_for; /**< Builds the tracer in parallel. */
    BvhMode bvh; /**< Whether there is a BVH over the shapes; meshes always have one of their
                    triangles. */
    const Tracer *reuse_from; /**< A tracer of the same engine, which may be tracing: BVHs of meshes
                                 that both scenes contain are shared. Read during the call only;
                                 NULL: none. */
    double footprint;       /**< Sphere tracing stops nearer to a surface than this fraction of half
                                 a pixel, as seen from the camera; 0: at the tolerance alone. */
    double relaxation;      /**< Factor of over-relaxation of its steps; 0: chosen automatically. */
    bool is_unlit;          /**< Whether lights are only seen and give no light. */
    PixelPoint pixel_point; /**< Where in its pixel a ray goes. */
    unsigned methods;       /**< Methods of the reports in place of the tracer's own: a set of
                               #ReportMethod;       0: none. */
} TraceSettings;

/** Statistics of a tracer. */
typedef struct TracerStats {
    size_t linear;             /**< Shapes that are tested one by one. */
    size_t in_bvh;             /**< Shapes in the BVH; 0: there is none. */
    size_t bvh_threshold;      /**< Number of bounded shapes from which on a BVH is built. */
    size_t triangles;          /**< Triangles of meshes; each mesh is counted once. */
    size_t triangle_bytes;     /**< Bytes of those, with their BVHs and normals. */
    double radiance_bound;     /**< No ray brings back more light; 0: no ray is reflected or
                                    refracted. */
    uint64_t step_limit_count; /**< Rays so far whose sphere tracing ended at the step limit. */
} TracerStats;

/** A rectangle of pixels, all of them or every n-th, traced with one ray each. */
typedef struct PixelGrid {
    int x;       /**< First column, from the left. */
    int y;       /**< First row, from the top. */
    int columns; /**< Columns of rays, at least 1. */
    int rows;    /**< Rows of rays, at least 1. */
    int stride;  /**< Pixels from one ray to the next, in both directions, at least 1. */
    int sample;  /**< Index of the sample in its pixel; 0 is the centre. */
    const uint16_t *selected; /**< The pixels that are traced, as `row * columns + column`; #stride
                                 is 1. NULL: all. */
    size_t selected_count;    /**< Number of those, at least 1. */
    uint64_t *path_hashes; /**< Receives a hash per ray, in the order of the colours, of its path:
                              the shapes and faces that it hits, and the lights that it sees.
                              Engines disagree only where rounding puts a ray on the other side
                              of an edge. NULL: none. */
    RayTree *ray_tree; /**< Receives the rays of a grid of one pixel; an empty tree. NULL: none. */
    bool (*is_stopped)(const void *context); /**< Asked between parts of scenes with glass, where a
                                                  pixel may take milliseconds: once true, the
                                                colours that are left are not set. NULL: never. */
    const void *stop_context;                /**< Passed to #is_stopped. */
} PixelGrid;

/** Numbers of rays traced. */
typedef struct RayCounts {
    uint64_t camera;           /**< From the camera. */
    uint64_t reflection;       /**< Reflected. */
    uint64_t refraction;       /**< Refracted. */
    uint64_t shadow;           /**< To a light. */
    uint64_t total_reflection; /**< Rays that were totally reflected at an interface; counted as
                                  reflected rays, too. */
    uint64_t unresolved;     /**< Camera rays below which more was ended than the cutoff allows. */
    double unresolved_steps; /**< Largest error of those, 8-bit steps at most; 0: there are none. */
} RayCounts;

/** @return The number of all rays. */
static inline uint64_t ray_counts_sum(const RayCounts *counts) {
    return counts->camera + counts->reflection + counts->refraction + counts->shadow;
}

/** A ray query in full precision. */
typedef struct RayQueryQuad {
    Quadruple origin[3];    /**< Origin; rounded to the engine's number type. */
    Quadruple direction[3]; /**< Direction, of any length but 0; rounded likewise. */
} RayQueryQuad;

/** A ray query in bulk, for speed. */
typedef struct RayQuery {
    double origin[3];    /**< Origin; rounded to the engine's number type. */
    double direction[3]; /**< Direction, of any length but 0; rounded likewise. */
} RayQuery;

/** The result of a query. */
typedef struct RayResult {
    int shape;           /**< Index of the nearest shape in the scene; -1: none. */
    bool occluded;       /**< The result of `is_occluding`, with an infinite limit. */
    Quadruple distance;  /**< Distance in lengths of the direction. */
    Quadruple point[3];  /**< The hit point. */
    Quadruple normal[3]; /**< The surface's outward unit normal there. */
    Quadruple error;     /**< Error bound: distance from the point to the surface, at most. */
    Quadruple uv[2]; /**< Texture coordinates; of a mesh only if the scene has a texture for it. */
} RayResult;

/** The processor features that an engine needs. */
typedef enum {
    ENGINE_NEEDS_NOTHING, /**< None: it runs on every processor. */
    ENGINE_NEEDS_AVX2,    /**< AVX2. */
    ENGINE_NEEDS_AVX512   /**< AVX-512 with DQ and VL. */
} EngineNeeds;

/** The vtable of an engine. */
typedef struct Engine {
    const char *name;  /**< Number type and lanes, such as `f32x8`. */
    int lanes;         /**< Number of SIMD lanes. */
    int mantissa_bits; /**< Bits of the significand, the leading 1 included: 24, 53 or 113. */
    EngineNeeds needs; /**< The processor features that it needs. */

    /**
     * Creates the tracer of a scene.
     * @param scene  The scene; read during the call only.
     * @param settings  How it is traced.
     * @param[out] error  Why there is no tracer.
     * @return The tracer, owned by the caller; NULL if memory is exhausted.
     */
    Tracer *(*create_tracer)(const Scene *scene, const TraceSettings *settings, Error *error);

    /**
     * Sets camera, lights and image size from a scene with unchanged shapes.
     * @param tracer  The tracer.
     * @param scene  The scene, with as many lights as before.
     * @param width  Pixels of the whole image.
     * @param height  Pixels of the whole image.
     */
    void (*set_view)(Tracer *tracer, const Scene *scene, int width, int height);

    /**
     * Traces one ray for each pixel of a grid. Any number of threads may call this at once.
     * @param tracer  The tracer, after #set_view.
     * @param grid  The pixels.
     * @param[out] rgb  Linear colours: the red of all rays, row by row or in the order of
     *         #PixelGrid.selected, then green, then blue.
     * @param[in,out] counts  The rays traced are added to this.
     */
    void (*trace)(const Tracer *tracer, const PixelGrid *grid, double *rgb, RayCounts *counts);

    /**
     * Finds the nearest hits of the camera rays of a grid, without shading and secondary rays.
     * @param tracer  The tracer, after #set_view.
     * @param grid  The pixels.
     * @param[out] shapes  Indices of the shapes, row by row; -1: none.
     * @param[out] distances  Distances, row by row; infinity: none.
     */
    void (*trace_primary)(const Tracer *tracer, const PixelGrid *grid, int *shapes,
                          double *distances);

    /**
     * Finds arbitrary output variables of the pixels of a grid. Any number of threads may call this
     * at once.
     * @param tracer  The tracer, after #set_view.
     * @param grid  The pixels; none may be selected.
     * @param flags  What is needed besides the first hits: #AOV_RADIANCE, #AOV_STEPS, #AOV_UV,
     *               #AOV_OPERATIONS.
     * @param[out] samples  The variables, row by row.
     * @param[in,out] counts  The rays traced are added to this.
     */
    void (*trace_aovs)(const Tracer *tracer, const PixelGrid *grid, unsigned flags,
                       AovSample *samples, RayCounts *counts);

    /**
     * Finds the nearest hits of rays.
     * @param tracer  The tracer.
     * @param count  Number of rays.
     * @param rays  The rays.
     * @param[out] shapes  Index of the shape that each ray hits; -1: none.
     * @param[out] distances  Distances in lengths of the directions; infinity: none.
     */
    void (*closest_hits)(const Tracer *tracer, size_t count, const RayQuery *rays, int *shapes,
                         double *distances);

    /**
     * Finds which rays hit any shape, at any distance: faster than the nearest hit.
     * @param tracer  The tracer.
     * @param count  Number of rays.
     * @param rays  The rays.
     * @param[out] occluded  Whether each ray hits a shape.
     */
    void (*occluded)(const Tracer *tracer, size_t count, const RayQuery *rays, bool *occluded);

    /**
     * Finds all properties of the nearest hits of rays, exactly as the engine computes them.
     * @param tracer  The tracer.
     * @param count  Number of rays.
     * @param queries  The rays.
     * @param[out] results  One result per ray.
     */
    void (*intersect)(const Tracer *tracer, size_t count, const RayQueryQuad *queries,
                      RayResult *results);

    /**
     * Finds the bounding box of all bounded shapes.
     * @param tracer  The tracer.
     * @param[out] low  Its lowest corner.
     * @param[out] high  Its highest corner; below the lowest if no shape is bounded.
     */
    void (*bounds)(const Tracer *tracer, Vec3d *low, Vec3d *high);

    /** @return The statistics of a tracer. */
    TracerStats (*stats)(const Tracer *tracer);

    /** Frees a tracer, or NULL. */
    void (*destroy)(Tracer *tracer);
} Engine;

/** @return The engines that this program was built with, the preferred first; then NULL. */
const Engine *const *engine_list(void);

/** @return Whether the processor has the features that an engine needs. */
bool engine_is_supported(const Engine *engine);

/**
 * Finds an engine.
 * @param name  Its name, or `auto` for the fastest of this processor, see #ENGINE_FASTEST.
 * @param[out] error  The names that exist, or the feature that the processor lacks.
 * @return The engine; NULL if none has the name or the processor cannot run it.
 */
const Engine *engine_find(const char *name, Error *error);

/** The purpose of an engine. */
typedef enum {
    ENGINE_FASTEST,  /**< The default: the first of #engine_list that the processor can run, or that
                        of AVX-512 where it was measured to be faster. */
    ENGINE_DOUBLE,   /**< For scenes in which single precision shows errors. */
    ENGINE_REFERENCE /**< Errors are measured against it: more bits than double. */
} EngineRole;

/** @return The preferred engine for a purpose that this processor can run; NULL: none is built. */
const Engine *engine_with_role(EngineRole role);

/** @return Why #ENGINE_FASTEST is what it is on this processor, in English. */
const char *engine_fastest_reason(void);

/** @return The engine with one lane of the same number type, whose bits are the same; the engine
 *          itself where no such engine is built. */
const Engine *engine_scalar(const Engine *engine);

#endif
