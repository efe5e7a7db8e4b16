/**
 * @file
 * @brief Recording of arbitrary output variables (AOVs). See dioptre/engine.h.
 *
 * AOVs are recorded for debug views only. Without a recorder, a packet costs one test of a pointer.
 */
#ifndef DIOPTRE_TRACE_TRACER_AOV_H
#define DIOPTRE_TRACE_TRACER_AOV_H

#include "trace/tracer/tracer.h"

/** Records the hits of a packet with #Recorders.aovs. */
void aov_record_surfaces(const SurfaceHit *surface);

/**
 * Records the shadow rays of a packet with #Recorders.aovs.
 * @param surface  The points that they start from.
 * @param light_index  Index of the light in the scene.
 * @param occluded  The rays that do not reach it.
 */
void aov_record_shadows(const SurfaceHit *surface, size_t light_index, const Packet *shadow,
                        const mask *occluded);

/** Records a grid of pixels. See #Engine.trace_aovs. */
void aov_trace(const Tracer *tracer, const PixelGrid *grid, unsigned flags, AovSample *samples,
               RayCounts *counts);

#endif
