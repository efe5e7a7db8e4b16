/**
 * @file
 * @brief Queues of rays that wait to be traced, and packets made of them.
 */
#ifndef DIOPTRE_TRACE_TRACER_RAY_QUEUE_H
#define DIOPTRE_TRACE_TRACER_RAY_QUEUE_H

#include "trace/tracer/path_nodes.h"

#include <stdlib.h>

/* --- queues ----------------------------------------------------------------------------------- */

/** Rays of one kind that wait to be traced. */
typedef struct RayQueue {
    RayColumns *columns; /**< The rays, from #RAY_COLUMN_FIRST on; owned. */
    unsigned count;      /**< Number of rays. */
} RayQueue;

/** The queues of a level: rays of one queue meet the same shapes. In the air, the first two hold
 *  the rays of each #Child. */
enum { QUEUE_INSIDE = CHILD_COUNT, QUEUE_COUNT };

/** Allocates the queues of a level. @return Whether memory sufficed. */
static inline bool ray_queues_init(RayQueue queues[QUEUE_COUNT]) {
    bool has_memory = true;
    for (int i = 0; i < QUEUE_COUNT; i++) {
        queues[i].columns = malloc(sizeof *queues[i].columns);
        has_memory = has_memory && queues[i].columns;
    }
    return has_memory;
}

/** Frees the rays of queues. */
static inline void ray_queues_deinit(RayQueue queues[QUEUE_COUNT]) {
    for (int i = 0; i < QUEUE_COUNT; i++) {
        free(queues[i].columns);
    }
}

/** @return The number of rays of all queues. */
static inline unsigned ray_queues_count(const RayQueue queues[QUEUE_COUNT]) {
    unsigned count = 0;
    for (int i = 0; i < QUEUE_COUNT; i++) {
        count += queues[i].count;
    }
    return count;
}

/** Empties queues. */
static inline void ray_queues_clear(RayQueue queues[QUEUE_COUNT]) {
    for (int i = 0; i < QUEUE_COUNT; i++) {
        queues[i].count = 0;
    }
}

/** Adds rays. @param lanes Which lanes, as bits; there is room. */
INLINE void ray_queue_add(RayQueue *queue, unsigned lanes, const RayVector *rays,
                          int interior_count) {
    ray_columns_store(queue->columns, RAY_COLUMN_FIRST + queue->count, lanes, rays, interior_count);
    queue->count += (unsigned)__builtin_popcount(lanes);
}

/* --- packets ---------------------------------------------------------------------------------- */

/** The rays of a packet in the wavefront. */
typedef struct PacketSource {
    unsigned nodes[PACKET_VECTORS];  /**< Their nodes: the first of each vector. */
    integer samples[PACKET_VECTORS]; /**< Their camera rays. */
} PacketSource;

/** A packet made of queued rays. */
typedef struct GatheredPacket {
    RayState rays;                         /**< The rays. */
    InteriorList interior[PACKET_VECTORS]; /**< The shapes that they are inside of. */
    Rgb weights[PACKET_VECTORS];           /**< See #NODE_WEIGHT. */
    integer links[PACKET_VECTORS];         /**< See #RayColumns. */
    uint32_t pixel_ids[PACKET_RAYS];       /**< See #SampleContext. */
    PacketSource source;                   /**< Their nodes. */
} GatheredPacket;

/** @return A row of #RayVector.numbers as a vector. */
INLINE Vec3 vec3_of_row(const real *row) {
    return (Vec3){row[0], row[1], row[2]};
}

/** @return A row of #RayVector.numbers as a colour. */
INLINE Rgb rgb_of_row(const real *row) {
    return (Rgb){row[0], row[1], row[2]};
}

/** Sets a vector of a packet. @param lanes The lanes that hold a ray; at least the first. */
INLINE void packet_set_vector(GatheredPacket *gathered, int v, RayVector *rays, mask lanes) {
    if (mask_bits(lanes) != ALL_LANES) {
        ray_vector_repeat_first(rays, lanes);
    }
    gathered->rays.packet.rays[v] = ray_of(vec3_of_row(rays->numbers[RAY_COLUMN_ORIGIN]),
                                           vec3_of_row(rays->numbers[RAY_COLUMN_DIRECTION]));
    gathered->rays.throughput[v] = rgb_of_row(rays->numbers[RAY_COLUMN_THROUGHPUT]);
    gathered->rays.turns[v] = rays->turns;
    gathered->interior[v] = rays->interior;
    gathered->weights[v] = rgb_of_row(rays->numbers[RAY_COLUMN_WEIGHT]);
    gathered->links[v] = rays->link;
    gathered->source.samples[v] = rays->sample;
}

/**
 * Makes a packet of queued rays.
 * @param first  Place of the first ray.
 * @param count  Number of rays, 1 to #PACKET_RAYS.
 */
static inline void packet_gather(const RayColumns *columns, int interior_count, unsigned first,
                                 unsigned count, GatheredPacket *gathered) {
    Packet *packet = &gathered->rays.packet;
    gathered->rays.interior = gathered->interior;
    packet_init(packet, (int)((count + LANES - 1) / LANES), true);
    for (int v = 0; v < packet_vector_count(packet); v++) {
        unsigned done = (unsigned)v * LANES, fill = count - done;
        packet->active[v] = fill >= LANES ? mask_of(true) : mask_of_bits((1u << fill) - 1);
        packet->limit[v] = real_of(INFINITE);
        RayVector rays = ray_columns_load(columns, first + done, interior_count);
        packet_set_vector(gathered, v, &rays, packet->active[v]);
    }
}

#endif
