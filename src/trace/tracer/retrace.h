/**
 * @file
 * @brief Passes over camera rays: rays below which too much was ended are traced again.
 *
 * How much light a ray of low throughput would have brought is not known beforehand. So the first
 * pass ends rays at a throughput that suffices for most pixels, and adds up what it ends. Where
 * that could be worth more than the cutoff allows, a further pass follows, in which rays end at an
 * eighth of the throughput, and so on, while a pass promises to help and is not too much work. The
 * work of all passes is a geometric series. What still lacks light gets an estimate of it, and is
 * counted.
 *
 * In a recursion each pass traces the camera ray again. A wavefront keeps the rays that its pass
 * ended and the next will not: every other pass goes on with those alone. Camera rays that find no
 * room in a wavefront are divided into smaller groups; one alone is traced recursively.
 */
#ifndef DIOPTRE_TRACE_TRACER_RETRACE_H
#define DIOPTRE_TRACE_TRACER_RETRACE_H

#include "trace/tracer/wavefront.h"

/**
 * Traces camera rays until what is missing below each is worth less than the cutoff of the tracer,
 * or can be found no more.
 * @param tracer  The tracer.
 * @param[in,out] rays  The camera rays; those that are active are the same afterwards. What is
 *         recorded of a ray is that of its last pass.
 * @param[out] colors  The radiance that arrives along each ray.
 * @param[in,out] counts  The rays of all passes are added to this; for a ray tree those of the
 * last.
 */
void trace_camera_rays(const Tracer *tracer, RayState *rays, Rgb *colors, RayCounts *counts);

/**
 * Does what trace_camera_rays() does, for some packets together, and faster.
 * @param tracer  A tracer with transparent shapes that follows no report.
 * @param wavefront  Memory for the rays.
 * @param packets  The packets, with #CameraPacket.rays and #CameraPacket.colors; nothing is
 * recorded of their rays.
 * @param count  Number of packets, at most #WAVEFRONT_PACKETS.
 * @param[in,out] counts  The rays of all passes are added to this.
 */
void trace_camera_packets(const Tracer *tracer, Wavefront *wavefront, CameraPacket *packets,
                          int count, RayCounts *counts);

#endif
