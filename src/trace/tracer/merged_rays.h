/**
 * @file
 * @brief Merged rays: below one camera ray, rays of little throughput that nearly coincide are
 *        traced as one.
 *
 * Behind n panes of glass, the number of paths grows exponentially with the number of reflections,
 * but light goes to and fro between parallel surfaces in two directions, and paths of the same
 * reflections in another order end on the same line. So the rays of one level are compared: where
 * two have gone into the same shapes, start less than a quarter of a pixel apart and differ in
 * direction by less than that, the heavier one stays and takes the throughput of both. Only rays
 * that the first pass would end at the usual cutoff, or at a coarser one that is asked for, are
 * merged: they are displaced instead of dropped.
 *
 * The order of rays, and so of their sums, does not depend on lanes or packets: all engines of a
 * number type get the same bits.
 */
#ifndef DIOPTRE_TRACE_TRACER_MERGED_RAYS_H
#define DIOPTRE_TRACE_TRACER_MERGED_RAYS_H

#include "trace/tracer/ray_merge.h"

/** Memory for merged rays; lent by a wavefront. */
typedef struct MergeMemory {
    RayQueue *level;   /**< The rays that are traced now. */
    RayQueue *next;    /**< The rays of the next level, one queue per #Child. */
    MergeTable *table; /**< Finds rays of the next level. */
} MergeMemory;

/** What merged rays bring to one camera ray. */
typedef struct MergedLight {
    scalar color[3];   /**< Its radiance. */
    scalar dropped[3]; /**< See #Losses. */
    scalar guarded[3]; /**< See #Losses. */
} MergedLight;

/**
 * Traces one camera ray, and merges the rays below it.
 * @param camera_rays  Its packet.
 * @param index  Its index there.
 * @param[in,out] counts  The rays traced are added to this.
 * @return Whether merging helped: where rays rarely coincide, tracing ends early without a result.
 */
bool trace_merged_rays(const Tracer *tracer, const MergeMemory *memory, const RayState *camera_rays,
                       int index, RayCounts *counts, MergedLight *light);

#endif
