/**
 * @file
 * @brief The tracer: from a packet of rays to its colours.
 */
#ifndef DIOPTRE_TRACE_TRACER_TRACER_H
#define DIOPTRE_TRACE_TRACER_TRACER_H

#include "trace/glass/dielectric.h"
#include "trace/lights/emitters.h"
#include "trace/materials/textures.h"
#include "trace/mesh/mesh_bvh.h"
#include "trace/tracer/camera.h"
#include "trace/tracer/loss_budget.h"
#include "trace/tracer/wavefront_pool.h"

/** The sky in the engine's number type. */
typedef struct Sky {
    Rgb horizon;              /**< Radiance at the horizon and below. */
    Rgb zenith_minus_horizon; /**< Radiance at the zenith, less that at the horizon. */
    bool is_gradient;         /**< Whether the two differ; otherwise the direction has no effect. */
} Sky;

/** The tracer of one scene at one precision and width. */
struct Tracer {
    Vec3d origin;              /**< The origin of the tracer's coordinates, in scene coordinates. */
    ShapeSet shapes;           /**< The shapes. */
    MeshBvhCache meshes;       /**< The meshes of the shapes. */
    Dielectrics dielectrics;   /**< The transparent shapes. */
    Material *materials;       /**< The materials; owned. */
    Light *lights;             /**< The lights; owned. */
    size_t light_count;        /**< Number of lights that give light. */
    size_t seen_light_count;   /**< Number of lights; those with an area are seen. */
    Emitters emitters;         /**< The visible lights. */
    int samples;               /**< Rays per pixel. */
    bool has_soft_shadows;     /**< Whether any light casts soft shadows. */
    Camera camera;             /**< The camera. */
    PixelPoint pixel_point;    /**< Where in its pixel a ray goes. */
    Sky sky;                   /**< The sky. */
    Textures textures;         /**< The textures of surfaces and sky. */
    RayOffset ray_offset;      /**< How far from surfaces secondary rays start. */
    int depth;                 /**< Most reflections and refractions in succession; 0 if no material
                                    reflects or transmits. */
    LossBudget loss_budget;    /**< What may be ended below a camera ray. */
    unsigned methods;          /**< #TraceSettings.methods */
    WavefrontPool *wavefronts; /**< Memory of tiles with transparent shapes; owned; NULL: rays are
                                    traced recursively. */
};

/** See trace/tracer/report_methods.h. */
typedef struct RayTally RayTally;

/** What all rays of one pass over a packet share. */
typedef struct TraceContext {
    const Tracer *tracer; /**< The scene. */
    RayCounts *counts;    /**< The rays traced are added to this. */
    scalar cutoff;        /**< Rays of less throughput end. */
    RayTally *tally;      /**< Rays per pixel, for report D's mean; NULL: not counted. */
} TraceContext;

/**
 * Traces a packet of rays, recursively.
 * @param rays  The rays; at least one is active.
 * @param[out] colors  The radiance that arrives along each ray.
 * @param[out] losses  What was ended below each, and how many rays were traced there; set only if
 *         true is returned.
 * @return Whether rays may have been generated: otherwise nothing is lost.
 */
bool trace_packet(const TraceContext *context, const RayState *rays, Rgb *colors, Losses *losses);

#endif
