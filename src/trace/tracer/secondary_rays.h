/**
 * @file
 * @brief Secondary rays: the reflected and refracted rays that start at surfaces.
 */
#ifndef DIOPTRE_TRACE_TRACER_SECONDARY_RAYS_H
#define DIOPTRE_TRACE_TRACER_SECONDARY_RAYS_H

#include "trace/glass/dielectric.h"
#include "trace/tracer/tracer.h"

/** Rays of one type that start at the surfaces that a packet hits. */
typedef struct SecondaryRays {
    RayType type;                /**< Reflected or refracted. */
    RayState rays;               /**< The rays; active are those that can change the image. */
    Rgb weights[PACKET_VECTORS]; /**< The factors of their colours in the colours of the rays that
                                      hit the surfaces. */
} SecondaryRays;

/** The rays that start at the surfaces that a packet hits. */
typedef struct ScatteredRays {
    SecondaryRays reflected; /**< The reflected rays. */
    SecondaryRays refracted; /**< The refracted rays; set only if the scene has transparent shapes.
                              */
    InteriorList interior_behind[PACKET_VECTORS]; /**< The shapes that those are inside of. */
} ScatteredRays;

/**
 * Finds what a packet of rays hits, shades it, and generates reflected and refracted rays.
 * @param[out] colors  The colours without reflection and refraction.
 * @param[out] losses  What ends here; set only if true is returned.
 * @return Whether rays may have been generated: otherwise nothing is lost.
 */
bool shade_and_scatter(const TraceContext *context, const RayState *rays, ScatteredRays *scattered,
                       Rgb *colors, Losses *losses);

/**
 * Generates the reflected rays: r = d - 2 (d . n) n.
 * @param context  For the offset of their origins and the cutoff of their throughput.
 * @param rays  The rays that hit the surfaces.
 * @param[out] reflected  The reflected rays.
 * @param[in,out] losses  What ends here is added to this.
 */
void reflect_rays(const TraceContext *context, const RayState *rays, const SurfaceHit *surface,
                  SecondaryRays *reflected, Losses *losses);

/**
 * Generates the refracted rays. Snell's law is in trace/materials/fresnel.h.
 * @param context  For the cutoff of their throughput.
 * @param rays  The rays that hit the surfaces.
 * @param surface  The surfaces, with #SurfaceHit.dielectric.
 * @param[out] refracted  The refracted rays.
 * @param[in,out] losses  What ends here is added to this.
 */
void refract_rays(const TraceContext *context, const RayState *rays, const SurfaceHit *surface,
                  SecondaryRays *refracted, Losses *losses);

/** Adds the losses of the active rays of a packet, and the rays themselves, to those of the rays
 *  that they come from. */
void losses_add(const Packet *packet, const Losses *incoming, Losses *losses);

/**
 * Adds the colours of secondary rays, weighted, to those of the rays that hit the surfaces.
 * @param incoming  The colours of the secondary rays.
 * @param[in,out] colors  The colours of the rays that hit the surfaces.
 */
void secondary_rays_add(const SecondaryRays *secondary, const Rgb *incoming, Rgb *colors);

#endif
