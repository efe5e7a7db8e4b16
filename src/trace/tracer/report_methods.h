/**
 * @file
 * @brief The reports' methods within the recursion (dioptre/report_methods.h). Nothing here is
 *        called where #Tracer.methods is 0, and nothing is inlined: the code would only lengthen
 * the path of all other pictures.
 */
#ifndef DIOPTRE_TRACE_TRACER_REPORT_METHODS_H
#define DIOPTRE_TRACE_TRACER_REPORT_METHODS_H

#include "trace/lights/direct_lighting.h"
#include "trace/tracer/secondary_rays.h"
#include "trace/tracer/tracer.h"

/** The rays that report D has put into its list, per pixel. */
struct RayTally {
    real count[PACKET_VECTORS]; /**< Number of rays, those beyond the end of its list included. */
};

/** Traces a packet of camera rays. See #trace_packet. */
bool report_trace_camera_packet(const TraceContext *context, const RayState *rays, Rgb *colors,
                                Losses *losses);

/** Sets the colours of rays that met no shape: what A's secondary rays do not meet is black. */
void report_shade_background(const TraceContext *context, const SurfaceHit *surface, Rgb *colors);

/**
 * Sets the colours of the rays that hit a shape, without secondary rays.
 * @param lighting  The direct light.
 * @param textures  The colours of textures; NULL: there are none.
 * @param[in,out] colors  The colours; unchanged at surfaces that a later shape overrides.
 */
void report_shade_surfaces(const Tracer *tracer, const SurfaceHit *surface,
                           const DirectLighting *lighting, const Rgb *textures, Rgb *colors);

/**
 * Changes which secondary rays there are, and their weights.
 * @param rays  The rays that hit the surfaces.
 * @param[in,out] reflected  The reflected rays.
 * @param[in,out] refracted  The refracted rays; NULL: the scene has no transparent shape.
 */
void report_scatter(const TraceContext *context, const RayState *rays, const SurfaceHit *surface,
                    SecondaryRays *reflected, SecondaryRays *refracted);

/** Changes a light to that of a report. @param methods A set of #ReportMethod. */
void report_light_set(Light *light, unsigned methods);

#endif
