/**
 * @file
 * @brief Wavefronts: the rays below a few packets of camera rays, traced level by level.
 *
 * At a transparent surface a ray becomes two. Traced recursively, the rays of a packet soon go
 * apart: most lanes are idle, and a vector costs the same for one ray as for LANES. So the rays of
 * one level, those of equal #SampleContext.bounce, wait in a queue, and full packets are made of
 * them (stream compaction: Laine, Karras, Aila, *Megakernels Considered Harmful*, 2013). What a ray
 * saw waits in a node of a tree until the colours are added up, from the leaves to the root, in the
 * order of the recursion. A ray's result does not depend on the other lanes: wavefronts change the
 * time, and not one bit of the image.
 *
 * Rays of little throughput wait, too: if a pixel needs them, wavefront_resume() goes on with them
 * alone.
 */
#ifndef DIOPTRE_TRACE_TRACER_WAVEFRONT_H
#define DIOPTRE_TRACE_TRACER_WAVEFRONT_H

#include "trace/tracer/merged_rays.h"
#include "trace/tracer/tracer.h"

/** Packets of camera rays that are traced side by side: with fewer, the packets of deep levels are
 *  less full; with more, the nodes leave the cache (measured with 1, 2, 4). */
enum { WAVEFRONT_PACKETS = 2 };

/** A packet of camera rays and its results. */
typedef struct CameraPacket {
    RayState *rays;             /**< The rays. */
    Rgb *colors;                /**< Their colours, per vector. */
    Losses losses;              /**< What was ended below them. */
    mask lanes[PACKET_VECTORS]; /**< The rays that are traced; others keep their results. */
} CameraPacket;

/** @return The number of rays of a packet that are traced. */
static inline unsigned camera_packet_count(const CameraPacket *packet) {
    unsigned count = 0;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        count += mask_count(packet->lanes[v]);
    }
    return count;
}

/** @return Memory for wavefronts, released with wavefront_destroy(); NULL without memory. */
Wavefront *wavefront_create(void);

/** Releases a wavefront. @param wavefront May be NULL. */
void wavefront_destroy(Wavefront *wavefront);

/** @return The number of camera rays that may find room together: fewer where more did not, just
 *          before. */
unsigned wavefront_sample_limit(const Wavefront *wavefront);

/** @return Memory of a wavefront, for merged rays. Nothing can be resumed afterwards. */
MergeMemory wavefront_merge_memory(Wavefront *wavefront);

/**
 * Traces camera rays.
 * @param context  Rays of less throughput than its cutoff are not traced.
 * @param least_throughput  Rays of less throughput than this are not kept for wavefront_resume().
 * @param packets  The camera rays, in scenes with transparent shapes.
 * @param count  Number of packets, at most #WAVEFRONT_PACKETS.
 * @return false where the rays are too many for the memory: there are no results then.
 */
bool wavefront_trace(Wavefront *wavefront, const TraceContext *context, scalar least_throughput,
                     CameraPacket *packets, int count);

/**
 * Goes on with rays that wavefront_trace() kept, below camera rays that it traced.
 * @param context  Its cutoff is the least throughput of before.
 * @param packets  The packets of before, with some of the lanes.
 * @param count  Number of packets.
 * @return As wavefront_trace().
 */
bool wavefront_resume(Wavefront *wavefront, const TraceContext *context, CameraPacket *packets,
                      int count);

#endif
