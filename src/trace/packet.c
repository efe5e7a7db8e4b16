/**
 * @file
 * @brief Packets and their intervals.
 */
#include "trace/packet.h"

#include "trace/slab.h"

unsigned packet_count(const Packet *packet) {
    unsigned count = 0;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        count += mask_count(packet->active[v]);
    }
    return count;
}

/** @return The smallest lane, found by halves. @param x Numbers. */
INLINE scalar lowest_lane(real x) {
#if LANES == 16
    x = real_min(
        x, __builtin_shufflevector(x, x, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7));
    x = real_min(
        x, __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3, 12, 13, 14, 15, 8, 9, 10, 11));
    x = real_min(
        x, __builtin_shufflevector(x, x, 2, 3, 0, 1, 6, 7, 4, 5, 10, 11, 8, 9, 14, 15, 12, 13));
    x = real_min(
        x, __builtin_shufflevector(x, x, 1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13, 12, 15, 14));
#elif LANES == 8
    x = real_min(x, __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3));
    x = real_min(x, __builtin_shufflevector(x, x, 2, 3, 0, 1, 6, 7, 4, 5));
    x = real_min(x, __builtin_shufflevector(x, x, 1, 0, 3, 2, 5, 4, 7, 6));
#elif LANES == 4
    x = real_min(x, __builtin_shufflevector(x, x, 2, 3, 0, 1));
    x = real_min(x, __builtin_shufflevector(x, x, 1, 0, 3, 2));
#endif
    return real_lane(x, 0);
}

/** @return The largest lane. @param x Numbers. */
INLINE scalar highest_lane(real x) {
    return -lowest_lane(-x);
}

/**
 * @return A coordinate of a vector.
 * @param v     The vectors.
 * @param axis  0, 1 or 2 for x, y or z.
 */
INLINE real coordinate(const Vector *v, int axis) {
    return axis == 0 ? v->x : axis == 1 ? v->y : v->z;
}

/** The intervals that the rays of each lane lie in, along one axis. */
typedef struct LaneSpans {
    real origin_low;   /**< Lowest origins. */
    real origin_high;  /**< Highest origins. */
    real inverse_low;  /**< Lowest 1 / direction. */
    real inverse_high; /**< Highest 1 / direction. */
} LaneSpans;

/** Widens intervals by one ray a lane. @param[in,out] s The intervals.
 *  @param origin Where the rays start, along the axis. @param inverse 1 / direction. */
INLINE void spans_add(LaneSpans *s, real origin, real inverse) {
    s->origin_low = real_min(origin, s->origin_low);
    s->origin_high = real_max(origin, s->origin_high);
    s->inverse_low = real_min(inverse, s->inverse_low);
    s->inverse_high = real_max(inverse, s->inverse_high);
}

/** @return The intervals along one axis. @param packet The packet. @param axis The axis. */
INLINE Span packet_span(const Packet *packet, int axis) {
    const real most = real_of(INFINITE), least = real_of(-INFINITE);
    LaneSpans s = {most, least, most, least};
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask active = packet->active[v];
        unsigned bits = mask_bits(active);
        real origin = coordinate(&packet->rays[v].origin, axis);
        real inverse = coordinate(&packet->rays[v].inverse, axis);
        if (bits == ALL_LANES) {
            spans_add(&s, origin, inverse);
        } else if (bits != 0) {
            int first = mask_first(active);
            spans_add(&s, real_select(active, origin, real_of(real_lane(origin, first))),
                      real_select(active, inverse, real_of(real_lane(inverse, first))));
        }
    }
    return (Span){lowest_lane(s.origin_low), highest_lane(s.origin_high),
                  lowest_lane(s.inverse_low), highest_lane(s.inverse_high)};
}

Spans packet_spans(const Packet *packet) {
    real limit = real_of(0);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        limit = real_max(real_select(packet->active[v], packet->limit[v], real_of(0)), limit);
    }
    return (Spans){{packet_span(packet, 0), packet_span(packet, 1), packet_span(packet, 2)},
                   highest_lane(limit)};
}

/**
 * Narrows the interval of distances in which any ray can be between two planes, where all go up
 * along the axis. A comparison that is false for NaN leaves the interval as it is.
 * @param[in,out] near  Earliest distance, for each box.
 * @param[in,out] far   Latest distance.
 * @param span  The rays.
 * @param low   The lower planes.
 * @param high  The higher planes.
 */
INLINE void clip_upwards(real *near, real *far, const Span *span, real low, real high) {
    real slow = real_of(span->inverse_high), fast = real_of(span->inverse_low);
    real to_low = low - real_of(span->origin_high), to_high = high - real_of(span->origin_low);
    real enter = to_low * real_select(to_low > 0, fast, slow);
    real leave = to_high * real_select(to_high > 0, slow, fast);
    *near = real_max(enter, *near);
    *far = real_min(leave, *far);
}

/** @return The span of the same rays seen in a mirror: up is down. @param span A span. */
static Span span_mirrored(const Span *span) {
    return (Span){-span->origin_high, -span->origin_low, -span->inverse_high, -span->inverse_low};
}

mask spans_may_meet(const Spans *spans, const BoundsBlock *bounds, real *nearest) {
    real near = real_of(0), far = real_of(spans->limit);
    for (int axis = 0; axis < 3; axis++) {
        const Span *span = &spans->axis[axis];
        if (span->inverse_low > 0) {
            clip_upwards(&near, &far, span, bounds->planes[axis], bounds->planes[axis + 3]);
        } else if (span->inverse_high < 0) {
            Span mirrored = span_mirrored(span);
            clip_upwards(&near, &far, &mirrored, -bounds->planes[axis + 3], -bounds->planes[axis]);
        }
    }
    *nearest = near * (1 - SLAB_SLACK);
    return *nearest <= far * (1 + SLAB_SLACK);
}
