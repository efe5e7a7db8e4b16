/**
 * @file
 * @brief What is noted of the rays of pixels. See dioptre/aov.h.
 *
 * Nobody but the layers of the window asks; where nobody does, a packet costs one look at a
 * pointer.
 */
#ifndef DIOPTRE_TRACE_TRACER_AOV_H
#define DIOPTRE_TRACE_TRACER_AOV_H

#include "trace/tracer/tracer.h"

/** Notes what rays have met. @param surface The surfaces; somebody asks for a survey of its packet.
 */
void aov_record_surfaces(const SurfaceHit *surface);

/**
 * Notes which points a lamp does not reach.
 * @param surface  The points; somebody asks for a survey of their packet.
 * @param light_index  Place of the lamp.
 * @param occluded  Those with something in their way.
 */
void aov_record_shadows(const SurfaceHit *surface, size_t light_index, const Packet *shadow,
                        const mask *occluded);

/** Surveys a grid of pixels. See #Engine.trace_aovs. @param[out] samples What is known of them. */
void aov_trace(const Tracer *tracer, const PixelGrid *grid, unsigned flags, AovSample *samples,
               RayCounts *counts);

#endif
