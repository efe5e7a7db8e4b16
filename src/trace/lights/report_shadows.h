/**
 * @file
 * @brief Shadows as the reports find them (dioptre/report_methods.h).
 */
#ifndef DIOPTRE_TRACE_LIGHTS_REPORT_SHADOWS_H
#define DIOPTRE_TRACE_LIGHTS_REPORT_SHADOWS_H

#include "trace/lights/light.h"

/** Report A: shadow rays do not end at the light. @param[in,out] sample The light's sample. */
void report_shadow_extend(LightSample *sample);

/**
 * Report D: rays go from the light to the points, and a point is lit where the first shape that
 * they meet is its own. Transparent shapes throw shadows like all others.
 * @param shapes  All shapes.
 * @param surface  The points.
 * @param[in,out] sample  The light's sample; its transmittance is set.
 * @param[out] occluded  The points that the light does not reach.
 */
void report_shadow_by_shape(const ShapeSet *shapes, const SurfaceHit *surface, LightSample *sample,
                            mask *occluded);

#endif
