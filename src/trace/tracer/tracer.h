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

/** The sky in the engine's number type. */
typedef struct Sky {
    Rgb horizon;              /**< At the horizon and below. */
    Rgb zenith_minus_horizon; /**< What the zenith has more than the horizon. */
    bool is_gradient; /**< Whether the two differ; otherwise the direction is not looked at. */
} Sky;

/** The tracer of one scene at one precision and width. */
struct Tracer {
    Vec3d origin;            /**< Where in the scene its coordinates begin. */
    ShapeSet shapes;         /**< The shapes. */
    MeshBvhCache meshes;     /**< The meshes that they show. */
    Dielectrics dielectrics; /**< Those that let light through. */
    Material *materials;     /**< The materials; owned. */
    Light *lights;           /**< The lamps; owned. */
    size_t light_count;      /**< How many. */
    Emitters emitters;       /**< Those of them that are seen. */
    int samples;             /**< Rays a pixel. */
    bool has_soft_shadows;   /**< Whether any lamp's shadows are soft. */
    Camera camera;           /**< The camera. */
    Sky sky;                 /**< The sky. */
    Textures textures;       /**< The pictures on surfaces and in the sky. */
    RayOffset ray_offset;    /**< How rays leave surfaces. */
    int depth;               /**< How often a ray may be mirrored or refracted; 0 where none is. */
    scalar cutoff;           /**< Weight below which a ray ends. */
    bool has_specular;       /**< Whether any surface has highlights. */
};

/**
 * Finds the colours that a packet of rays brings back.
 * @param packet  The rays, of unit direction, at least one active.
 * @param interior  What they are inside of; NULL: the scene has no glass.
 * @param throughput  For each vector of rays: the largest share with which a primary of its colour
 *         enters the picture.
 * @param depth  How often the rays may still be mirrored or refracted.
 * @param[out] colors  A colour for each vector of rays.
 * @param[in,out] counts  Mirrored, refracted and shadow rays are added to this.
 */
void tracer_trace_packet(const Tracer *tracer, const Packet *packet, const InteriorList *interior,
                         const real *throughput, int depth, Rgb *colors, RayCounts *counts);

#endif
