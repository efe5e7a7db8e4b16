/**
 * @file
 * @brief The tracer: from a packet of rays to its colours.
 */
#ifndef DIOPTRE_TRACE_TRACER_H
#define DIOPTRE_TRACE_TRACER_H

#include "trace/crossing.h"
#include "trace/eye.h"
#include "trace/glow.h"
#include "trace/model.h"
#include "trace/texture.h"

/** The sky in the engine's number type. */
typedef struct Backdrop {
    Light3 horizon;   /**< At the horizon and below. */
    Light3 rise;      /**< What the zenith has more than the horizon. */
    bool is_gradient; /**< Whether the two differ; otherwise the direction is not looked at. */
} Backdrop;

/** The tracer of one scene at one precision and width. */
struct Tracer {
    Vector3 origin;      /**< Where in the scene its coordinates begin. */
    ShapeList list;      /**< The shapes. */
    Models models;       /**< The meshes that they show. */
    Glass glass;         /**< Those that let light through. */
    Surface *surfaces;   /**< The materials; owned. */
    Lamp *lamps;         /**< The lamps; owned. */
    size_t lamp_count;   /**< How many. */
    Glow glow;           /**< Those of them that are seen. */
    int samples;         /**< Rays a pixel. */
    bool is_soft;        /**< Whether any lamp's shadows are soft. */
    Eye eye;             /**< The camera. */
    Backdrop backdrop;   /**< The sky. */
    Textures textures;   /**< The pictures on surfaces and in the sky. */
    Departure departure; /**< How rays leave surfaces. */
    int depth;           /**< How often a ray may be mirrored or refracted; 0 where none is. */
    scalar cutoff;       /**< Weight below which a ray ends. */
    bool shines;         /**< Whether any surface has highlights. */
};

/**
 * Finds the colours that a packet of rays brings back.
 * @param tracer  The tracer.
 * @param packet  The rays, of unit direction, at least one active.
 * @param media   What they are inside of; NULL: the scene has no glass.
 * @param weight  For each vector of rays: the largest share with which a primary of its colour
 *                enters the picture.
 * @param depth   How often the rays may still be mirrored or refracted.
 * @param[out] colors  A colour for each vector of rays.
 * @param[in,out] counts  Mirrored, refracted and shadow rays are added to this.
 */
void tracer_follow(const Tracer *tracer, const Packet *packet, const Media *media,
                   const real *weight, int depth, Light3 *colors, RayCounts *counts);

#endif
