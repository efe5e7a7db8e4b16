/**
 * @file
 * @brief Packets: rays of neighbouring pixels that are traced together.
 *
 * Neighbouring rays hit the same few shapes. A packet is tested against the bounding box of a shape
 * once, by interval arithmetic, before its rays are tested against the shape. The interval test
 * uses the operations of the ray-slab test and rounds outwards, so it never drops a shape that a
 * ray of the packet hits: it changes the time, and not one bit of the image.
 */
#ifndef DIOPTRE_TRACE_TRACER_PACKET_H
#define DIOPTRE_TRACE_TRACER_PACKET_H

#include "dioptre/engine.h"
#include "trace/shapes/shape.h"

#if LANES > 1
/** Pixels per packet, across. A vector is a row of pixels, or half a row. */
#define PACKET_COLUMNS (LANES > 8 ? LANES : 8)
/** Pixels per packet, down. Packets of 8 by 8 rays were the fastest (measured). */
#define PACKET_ROWS 8
#else
/** An engine of one lane traces one ray at a time: the baseline of all charts. */
#define PACKET_COLUMNS 1
/** See #PACKET_COLUMNS. */
#define PACKET_ROWS 1
#endif
/** Rays per packet. */
#define PACKET_RAYS (PACKET_COLUMNS * PACKET_ROWS)
/** Vectors per packet. */
#define PACKET_VECTORS (PACKET_RAYS / LANES)

/** What is recorded of the rays of a packet. A secondary ray is in the lane of its camera ray, so
 *  each record belongs to one pixel. */
typedef struct Recorders {
    uint64_t *path_hashes; /**< One hash per ray, see trace/tracer/path_hash.h; NULL: none. */
    AovSample *aovs;       /**< One sample per ray, see trace/tracer/aov.h; NULL: none. */
    RayTree *ray_tree;     /**< The rays of the first lane, see trace/tracer/ray_tree_recorder.h;
                                NULL: none. */
} Recorders;

/** What identifies the samples that the rays of a packet belong to. */
typedef struct SampleContext {
    const uint32_t *pixel_ids; /**< One number per ray, unique to its pixel, that selects its sample
                                    points on lights; NULL: no light has soft shadows. */
    const Recorders *recorders; /**< What is recorded; NULL: nothing. */
    uint32_t sample;            /**< Index of the sample in its pixel. */
    uint32_t bounce;            /**< Number of reflections and refractions so far. */
    RayType type;               /**< The type of the rays; not set in a wavefront. */
} SampleContext;

/** @return The ray tree that the rays of the first lane are recorded in; NULL: none. */
static inline RayTree *sample_context_ray_tree(const SampleContext *context) {
    return context->recorders ? context->recorders->ray_tree : NULL;
}

/** Rays from one point in the directions axis + a across + b up, where a and b are -1 to 1; then
 *  normalized. */
struct Beam {
    Vec3s origin; /**< The point. */
    Vec3s axis;   /**< To the middle. */
    Vec3s across; /**< From the middle to the right edge. */
    Vec3s up;     /**< From the middle to the upper edge. */
};

/** Rays that are traced together. */
struct Packet {
    Ray rays[PACKET_VECTORS];    /**< The rays. */
    mask active[PACKET_VECTORS]; /**< The lanes that hold a ray. */
    real limit[PACKET_VECTORS];  /**< The largest distance that counts. */
    bool wants_points;           /**< Whether hit points and normals are needed, not only shapes and
                                      distances. */
    bool has_beam;               /**< Whether all rays are within #beam. */
    int vector_count;            /**< Vectors that hold rays, the first ones: of others, nothing is
                                      set, here and in what is found for the rays. */
    Beam beam;                   /**< A beam of camera rays. */
    const Shape *only_shape;     /**< The only shape that #beam meets, as far as box and class tell;
                                      NULL: nobody knows. Read only with a beam. */
    SampleContext context;       /**< The samples that the rays belong to. */
};

/** @return See #Packet.vector_count; in engines of one lane a constant. */
INLINE int packet_vector_count(const Packet *packet) {
    return PACKET_VECTORS == 1 ? 1 : packet->vector_count;
}

/** Begins a packet without a beam. @param vector_count, wants_points See #Packet. */
INLINE void packet_init(Packet *packet, int vector_count, bool wants_points) {
    if (PACKET_VECTORS > 1) { // See packet_vector_count().
        packet->vector_count = vector_count;
    }
    packet->wants_points = wants_points;
    packet->has_beam = false;
}

/** A packet on its path from the camera through the scene. */
typedef struct RayState {
    Packet packet;                       /**< The rays; their directions are unit vectors. */
    Rgb throughput[PACKET_VECTORS];      /**< The factor of a ray's colour in its pixel. */
    integer turns[PACKET_VECTORS];       /**< Number of reflections and refractions so far; surfaces
                                              that a later shape overrides are none. */
    const struct InteriorList *interior; /**< The transparent shapes that each vector of rays is
                                              inside of; NULL: the scene has none. */
} RayState;

/** What a packet lacks of its light because rays below were ended, and what it cost. */
typedef struct Losses {
    Rgb dropped[PACKET_VECTORS]; /**< Sum of the throughputs of rays that ended for their weight. */
    Rgb guarded[PACKET_VECTORS]; /**< Sum of the throughputs of rays that the guard of the
                                      recursion ended. */
    real rays[PACKET_VECTORS];   /**< Number of secondary rays. */
} Losses;

/** The bounding boxes of LANES shapes, for one test of all of them. */
typedef struct Aabb {
    real planes[6]; /**< Lowest coordinates along x, y and z; then highest. */
} Aabb;

/** The intervals that contain all active rays of a packet, along one axis. */
typedef struct AxisInterval {
    scalar origin_low;   /**< Lowest origin. */
    scalar origin_high;  /**< Highest origin. */
    scalar inverse_low;  /**< Lowest 1 / direction. */
    scalar inverse_high; /**< Highest 1 / direction. */
} AxisInterval;

/** The intervals that contain all active rays of a packet. */
struct PacketIntervals {
    AxisInterval axis[3]; /**< Along x, y and z. */
    scalar limit;         /**< The largest limit. */
    bool has_region;      /**< Whether there is a #region: rays that end at a point, or before it,
                               have one. */
    Aabbs region; /**< A box that contains all rays from their origins to the point, enlarged
                       by roundings. */
    Vec3s target; /**< That point; set only with a region. */
};

/** Replaces the colours and losses of some rays. @param lanes Those. */
INLINE void results_replace(const mask *lanes, const Rgb *new_colors, const Losses *new_losses,
                            Rgb *colors, Losses *losses) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask m = lanes[v];
        colors[v] = rgb_select(m, new_colors[v], colors[v]);
        losses->dropped[v] = rgb_select(m, new_losses->dropped[v], losses->dropped[v]);
        losses->guarded[v] = rgb_select(m, new_losses->guarded[v], losses->guarded[v]);
        losses->rays[v] = real_select(m, new_losses->rays[v], losses->rays[v]);
    }
}

/** Sets the losses of some vectors to 0. */
INLINE void losses_clear(Losses *losses, int vector_count) {
    const Rgb nothing = {real_of(0), real_of(0), real_of(0)};
    for (int v = 0; v < vector_count; v++) {
        losses->dropped[v] = losses->guarded[v] = nothing;
        losses->rays[v] = real_of(0);
    }
}

/** @return The number of active rays. */
INLINE unsigned packet_active_count(const Packet *packet) {
    unsigned count = 0;
    for (int v = 0; v < packet_vector_count(packet); v++) {
        count += mask_count(packet->active[v]);
    }
    return count;
}

/** @return The intervals of a packet with at least one active ray. Engines of one lane test each
 * box for its ray: their intervals are empty. */
PacketIntervals packet_intervals(const Packet *packet);

/** @return The intervals of one vector of a packet, with at least one active ray. */
PacketIntervals packet_vector_intervals(const Packet *packet, int v);

/** Bound on the roundings of a direction of a beam and its inverse, in lengths of the beam's axis
 *  and edges: each component has a dozen, relative to the camera's vectors, which are at right
 *  angles and so no longer than the axis. */
#define BEAM_SLACK (64 * ROUNDOFF)

/** How far a ray may be beside a narrow beam, in lengths of the ray: BEAM_SLACK of lengths that are
 *  up to three times its own; and a quarter of this is left for roundings. */
#define NARROW_BEAM_SLACK (4 * BEAM_SLACK)

/** Slack of intervals_miss_sphere(), in lengths of the rays: it compares cosines, and roundings of
 * the wide precision, 2^-53, hide angles up to a few times their root, 2^-26. */
#define COSINE_SLACK (NARROW_BEAM_SLACK > (scalar)0x1p-22 ? NARROW_BEAM_SLACK : (scalar)0x1p-22)

/** @return Whether a beam is narrow: no direction is shorter than half its axis. */
bool beam_is_narrow(const Beam *beam);

/** @return The intervals of a packet whose rays all end at one point, with at least one active ray.
 *          Only their origins and limits are read: the direction and its inverse are monotonic in
 *          them, also as they are rounded, so the intervals are those of packet_intervals(). An
 *          axis along which rays go both ways clips nothing; but up to limits of 1, all rays lie
 *          between their origins and the point, in a region. */
PacketIntervals packet_intervals_to_point(const Packet *packet, const Vec3 *point);

/** @return The same. @param low, high Least and greatest origins, per lane. @param limit The
 * largest limit. */
PacketIntervals intervals_to_point(Vec3 low, Vec3 high, const Vec3 *point, scalar limit);

/** @return Intervals that contain all rays of a beam, rounding included. An axis along which rays
 *          go both ways clips nothing. */
PacketIntervals beam_intervals(const Beam *beam);

/**
 * @return Whether rays to a point surely miss a sphere.
 *
 * From the point, the ball around the origins has a direction a and an apparent radius of angle
 * alpha, the sphere b and beta. Both are apart if the angle between a and b is larger than alpha +
 * beta, that is, its cosine smaller:
 *
 *     a . b < |a| |b| (cos alpha cos beta - sin alpha sin beta)
 *
 * With |a| sin alpha and |b| sin beta, the radii, that takes one root (shaft culling: Haines,
 * Wallace, *Shaft Culling for Efficient Ray-Cast Radiosity*, 1991). The product of four lengths
 * does not overflow: |b| is at most a few times #LENGTH_MAXIMUM, and where |a| is 2^22 times as
 * long, the slack alone exceeds |b|.
 * @param intervals Those of rays with a #PacketIntervals.region.
 */
bool intervals_miss_sphere(const PacketIntervals *intervals, Vec3sw center, wide_scalar radius);

/**
 * @return The boxes that rays within the intervals may hit; set where that cannot be excluded.
 * @param[out] nearest  For each box, a lower bound of the distance of any hit in it.
 */
mask packet_intervals_may_hit(const PacketIntervals *intervals, const Aabb *boxes, real *nearest);

#endif
