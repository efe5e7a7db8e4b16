/**
 * @file
 * @brief Wavefronts that wait for the next tile.
 *
 * The memory of a wavefront is large, and memory that is used for the first time is slow. So a tile
 * takes a wavefront that another tile has returned: there are as many as threads trace at once.
 */
#ifndef DIOPTRE_TRACE_TRACER_WAVEFRONT_POOL_H
#define DIOPTRE_TRACE_TRACER_WAVEFRONT_POOL_H

/** See trace/tracer/wavefront.h. */
typedef struct Wavefront Wavefront;

/** Wavefronts that wait; any number of threads may use it at once. */
typedef struct WavefrontPool WavefrontPool;

/** @return A pool, to be freed with wavefront_pool_destroy(); NULL without memory. */
WavefrontPool *wavefront_pool_create(void);

/** Frees a pool, or NULL. No wavefront is in use. */
void wavefront_pool_destroy(WavefrontPool *pool);

/** @return A wavefront that no other thread uses, for wavefront_pool_give_back(); NULL without
 *          memory. */
Wavefront *wavefront_pool_take(WavefrontPool *pool);

/** Returns a wavefront. */
void wavefront_pool_give_back(WavefrontPool *pool, Wavefront *wavefront);

#endif
