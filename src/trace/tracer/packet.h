/**
 * @file
 * @brief Packets: rays of neighbouring pixels that travel together.
 *
 * Rays that start together meet the same few shapes. A packet is tested against a shape's box once,
 * by intervals, before any of its rays is; what it cannot meet is dropped for all of them. The test
 * uses the same operations as a ray against a slab and rounds outwards, so it never drops a shape
 * that a ray of the packet would have hit: it changes the time, not one bit of the picture.
 */
#ifndef DIOPTRE_TRACE_TRACER_PACKET_H
#define DIOPTRE_TRACE_TRACER_PACKET_H

#include "dioptre/ray_tree.h"
#include "trace/shapes/shape.h"

#if LANES > 1
/** Pixels a packet, across: a vector is a row, or half of one. */
#define PACKET_COLUMNS (LANES > 8 ? LANES : 8)
/** Pixels a packet, down: 8 by 8 rays share the cost of the intervals best. */
#define PACKET_ROWS 8
#else
/** An engine of one lane is the textbook tracer, the baseline of every chart: ray by ray. */
#define PACKET_COLUMNS 1
/** See #PACKET_COLUMNS. */
#define PACKET_ROWS 1
#endif
/** Rays a packet. */
#define PACKET_RAYS (PACKET_COLUMNS * PACKET_ROWS)
/** Vectors a packet. */
#define PACKET_VECTORS (PACKET_RAYS / LANES)

/** What is noted of the rays of a packet while they are followed. A ray that goes on has its
 *  ancestor's lane, so each note is of the same pixel as before. */
typedef struct Recorders {
    uint64_t *path_hashes; /**< A number for each ray, of the way that its light took; NULL: nobody
                           asks. See trace/tracer/path_hash.h. */
    AovSample *aovs;       /**< What is known of each ray's pixel; NULL: nobody asks. See
                                    trace/tracer/aov.h. */
    RayTree *ray_tree;     /**< Where the rays of the first lane are noted; NULL: nobody asks. See
                           trace/tracer/ray_tree_recorder.h. */
} Recorders;

/** Whose rays travel together: what their choices among the points of a lamp go by. */
typedef struct SampleContext {
    const uint32_t
        *pixel_ids; /**< A number for each ray, its pixel's own; NULL where no lamp is soft.
                     */
    const Recorders *recorders; /**< What is noted of their ways; NULL: nothing. */
    uint32_t sample;            /**< Which of the pixels' samples they are. */
    uint32_t bounce;            /**< How often they were turned. */
} SampleContext;

/** @return Where the rays of the first lane are noted; NULL: nobody asks. */
static inline RayTree *sample_context_ray_tree(const SampleContext *context) {
    return context->recorders ? context->recorders->ray_tree : NULL;
}

/** @return Of what becomes of rays at a surface. @param context Of the rays that met it. */
static inline SampleContext sample_context_next_bounce(SampleContext context) {
    context.bounce++;
    return context;
}

/** Rays that travel together. */
struct Packet {
    Ray rays[PACKET_VECTORS];    /**< The rays. */
    mask active[PACKET_VECTORS]; /**< Those that are there at all. */
    real limit[PACKET_VECTORS];  /**< How far each goes. */
    bool wants_points;           /**< Whether points and normals are wanted of what they meet; else
                                      only which shape and how far away. */
    SampleContext context;       /**< Whose they are. */
};

/** Boxes of LANES shapes side by side, so that one test answers for all of them. */
typedef struct Aabb {
    real planes[6]; /**< Lowest coordinates along x, y and z; then highest. */
} Aabb;

/** The intervals that all active rays of a packet lie in, along one axis. */
typedef struct AxisInterval {
    scalar origin_low;   /**< Lowest origin. */
    scalar origin_high;  /**< Highest origin. */
    scalar inverse_low;  /**< Lowest 1 / direction. */
    scalar inverse_high; /**< Highest 1 / direction. */
} AxisInterval;

/** What is known of all rays of a packet at once. */
typedef struct PacketIntervals {
    AxisInterval axis[3]; /**< Along x, y and z. */
    scalar limit;         /**< How far the farthest goes. */
} PacketIntervals;

/** @return How many rays of a packet are active. */
unsigned packet_active_count(const Packet *packet);

/** @return The intervals of a packet with at least one active ray. */
PacketIntervals packet_intervals(const Packet *packet);

/**
 * @return The boxes that some ray within the spans may meet; set where that cannot be excluded.
 * @param[out] nearest  For each box: no ray meets anything in it nearer than this.
 */
mask packet_intervals_may_hit(const PacketIntervals *intervals, const Aabb *boxes, real *nearest);

#endif
