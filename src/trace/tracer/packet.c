/**
 * @file
 * @brief Packets and the intervals that contain them.
 */
#include "trace/tracer/packet.h"

#include "trace/bvh/slab.h"

/** The intervals that contain the rays of each lane, along one axis. */
typedef struct LaneIntervals {
    real origin_low;   /**< Lowest origins. */
    real origin_high;  /**< Highest origins. */
    real inverse_low;  /**< Lowest 1 / direction. */
    real inverse_high; /**< Highest 1 / direction. */
} LaneIntervals;

/** Extends intervals by one ray per lane. @param origin Its origin along the axis. */
INLINE void lane_intervals_extend(LaneIntervals *s, real origin, real inverse) {
    s->origin_low = real_min(origin, s->origin_low);
    s->origin_high = real_max(origin, s->origin_high);
    s->inverse_low = real_min(inverse, s->inverse_low);
    s->inverse_high = real_max(inverse, s->inverse_high);
}

/** The vectors from #first to the one before #end. */
typedef struct VectorRange {
    int first; /**< The first one. */
    int end;   /**< The one after the last. */
} VectorRange;

/** @return The interval along one axis. Inactive lanes count as a copy of an active lane. */
INLINE AxisInterval packet_axis_interval(const Packet *packet, VectorRange range, int axis) {
    const real most = real_of(INFINITE), least = real_of(-INFINITE);
    LaneIntervals s = {most, least, most, least};
    for (int v = range.first; v < range.end; v++) {
        mask active = packet->active[v];
        unsigned bits = mask_bits(active);
        real origin = vec3_component(&packet->rays[v].origin, axis);
        real inverse = vec3_component(&packet->rays[v].inverse_direction, axis);
        if (bits == ALL_LANES) {
            lane_intervals_extend(&s, origin, inverse);
        } else if (bits != 0) {
            int first = mask_first(active);
            lane_intervals_extend(&s,
                                  real_select(active, origin, real_of(real_lane(origin, first))),
                                  real_select(active, inverse, real_of(real_lane(inverse, first))));
        }
    }
    return (AxisInterval){real_reduce_min(s.origin_low), real_reduce_max(s.origin_high),
                          real_reduce_min(s.inverse_low), real_reduce_max(s.inverse_high)};
}

/** @return The intervals of some vectors with at least one active ray. */
INLINE PacketIntervals packet_range_intervals(const Packet *packet, VectorRange range) {
    real limit = real_of(0);
    for (int v = range.first; v < range.end; v++) {
        limit = real_max(real_select(packet->active[v], packet->limit[v], real_of(0)), limit);
    }
    return (PacketIntervals){.axis = {packet_axis_interval(packet, range, 0),
                                      packet_axis_interval(packet, range, 1),
                                      packet_axis_interval(packet, range, 2)},
                             .limit = real_reduce_max(limit)};
}

PacketIntervals packet_intervals(const Packet *packet) {
    return LANES == 1
               ? (PacketIntervals){0}
               : packet_range_intervals(packet, (VectorRange){0, packet_vector_count(packet)});
}

PacketIntervals packet_vector_intervals(const Packet *packet, int v) {
    return packet_range_intervals(packet, (VectorRange){v, v + 1});
}

/** @return The interval along one axis of rays to a point. @param point Its coordinate. */
INLINE AxisInterval axis_interval_to_point(real lowest, real highest, scalar point) {
    // The 0 that is added makes -0 positive, whose inverse would be the lowest of all.
    scalar low = real_reduce_min(lowest), high = real_reduce_max(highest),
           direction_low = point - high + 0, direction_high = point - low + 0;
    bool is_one_way = direction_low >= 0 || direction_high < 0;
    return (AxisInterval){low, high, is_one_way ? 1 / direction_high : -INFINITE,
                          is_one_way ? 1 / direction_low : INFINITE};
}

PacketIntervals intervals_to_point(Vec3 low, Vec3 high, const Vec3 *point, scalar limit) {
    const scalar end[3] = {real_lane(point->x, 0), real_lane(point->y, 0), real_lane(point->z, 0)};
    PacketIntervals intervals = {.axis = {axis_interval_to_point(low.x, high.x, end[0]),
                                          axis_interval_to_point(low.y, high.y, end[1]),
                                          axis_interval_to_point(low.z, high.z, end[2])},
                                 .limit = limit,
                                 .has_region = limit <= 1,
                                 .target = {end[0], end[1], end[2]}};
    for (int axis = 0; axis < 3; axis++) {
        const AxisInterval *interval = &intervals.axis[axis];
        scalar lowest = interval->origin_low < end[axis] ? interval->origin_low : end[axis];
        scalar highest = interval->origin_high > end[axis] ? interval->origin_high : end[axis];
        scalar slack = REGION_SLACK * (highest - lowest);
        intervals.region.low[axis] = lowest - slack;
        intervals.region.high[axis] = highest + slack;
    }
    return intervals;
}

PacketIntervals packet_intervals_to_point(const Packet *packet, const Vec3 *point) {
    const real most = real_of(INFINITE), least = real_of(-INFINITE);
    Vec3 low = {most, most, most}, high = {least, least, least};
    real limit = real_of(0);
    for (int v = 0; v < packet_vector_count(packet); v++) {
        mask active = packet->active[v];
        unsigned bits = mask_bits(active);
        Vec3 origin = packet->rays[v].origin;
        if (bits == 0) {
            continue;
        }
        if (bits != ALL_LANES) {
            int first = mask_first(active);
            Vec3 other = {real_of(real_lane(origin.x, first)), real_of(real_lane(origin.y, first)),
                          real_of(real_lane(origin.z, first))};
            origin = vec3_select(active, origin, other);
        }
        low = vec3_min(origin, low);
        high = vec3_max(origin, high);
        limit = real_max(real_select(active, packet->limit[v], real_of(0)), limit);
    }
    return intervals_to_point(low, high, point, real_reduce_max(limit));
}

/** @return The interval of a beam along one axis. @param axis, half_width The component of its
 * axis, and how far others are from it. @param length Shortest and longest of its directions,
 * before they are normalized. */
static AxisInterval beam_axis_interval(scalar origin, scalar axis, scalar half_width,
                                       const scalar length[2]) {
    scalar low = axis - half_width, high = axis + half_width;
    AxisInterval both_ways = {origin, origin, -INFINITE, INFINITE};
    return low > 0    ? (AxisInterval){origin, origin, length[0] / high, length[1] / low}
           : high < 0 ? (AxisInterval){origin, origin, length[1] / high, length[0] / low}
                      : both_ways;
}

bool beam_is_narrow(const Beam *beam) {
    scalar width = vec3s_abs_sum(beam->across) + vec3s_abs_sum(beam->up);
    return 4 * width * width < vec3s_dot(beam->axis, beam->axis);
}

bool intervals_miss_sphere(const PacketIntervals *intervals, Vec3sw center, wide_scalar radius) {
    const AxisInterval *axis = intervals->axis;
    const Vec3sw target = vec3s_widen(intervals->target),
                 low = vec3s_widen(
                     (Vec3s){axis[0].origin_low, axis[1].origin_low, axis[2].origin_low}),
                 high = vec3s_widen(
                     (Vec3s){axis[0].origin_high, axis[1].origin_high, axis[2].origin_high}),
                 half = vec3sw_scale(vec3sw_subtract(high, low), (wide_scalar)0.5),
                 // The target first: then all roundings are relative to lengths of rays.
        a = vec3sw_subtract(vec3sw_subtract(high, target), half),
                 b = vec3sw_subtract(center, target);
    const scalar slack =
        COSINE_SLACK * (vec3s_abs_sum(vec3s_narrow(a)) + vec3s_abs_sum(vec3s_narrow(b)));
    const wide_scalar ball_squared = vec3sw_dot(half, half), ball = WIDE_SQRT(ball_squared),
                      r = radius + (wide_scalar)slack, a_along = vec3sw_dot(a, a) - ball_squared,
                      b_along = vec3sw_dot(b, b) - r * r;
    return a_along > 0 && b_along > 0 && vec3sw_dot(a, b) + ball * r < WIDE_SQRT(a_along * b_along);
}

PacketIntervals beam_intervals(const Beam *beam) {
    const Vec3s *o = &beam->origin, *a = &beam->axis, *r = &beam->across, *u = &beam->up;
    scalar middle = SCALAR_SQRT(vec3s_dot(*a, *a));
    scalar width = vec3s_abs_sum(*r) + vec3s_abs_sum(*u), slack = BEAM_SLACK * (middle + width);
    scalar shortest = middle - width - slack;
    const scalar length[2] = {shortest > 0 ? shortest : 0, middle + width + slack};
    return (PacketIntervals){
        .axis =
            {beam_axis_interval(o->x, a->x, scalar_abs(r->x) + scalar_abs(u->x) + slack, length),
             beam_axis_interval(o->y, a->y, scalar_abs(r->y) + scalar_abs(u->y) + slack, length),
             beam_axis_interval(o->z, a->z, scalar_abs(r->z) + scalar_abs(u->z) + slack, length)},
        .limit = INFINITE};
}

/** Clips the interval of distances in which any ray can be between two planes, for rays whose
 *  directions are positive along the axis. NaN, for which comparisons are false, clips nothing.
 *  @param[in,out] near Lower bound of the distance, per box. */
INLINE void interval_clip_positive(real *near, real *far, const AxisInterval *interval, real low,
                                   real high) {
    real max_inverse = real_of(interval->inverse_high),
         min_inverse = real_of(interval->inverse_low);
    real to_low = low - real_of(interval->origin_high),
         to_high = high - real_of(interval->origin_low);
    real enter = to_low * real_select(to_low > 0, min_inverse, max_inverse);
    real leave = to_high * real_select(to_high < 0, min_inverse, max_inverse);
    *near = real_max(enter, *near);
    *far = real_min(leave, *far);
}

/** @return The interval of the rays, negated. */
static AxisInterval axis_interval_negated(const AxisInterval *interval) {
    return (AxisInterval){-interval->origin_high, -interval->origin_low, -interval->inverse_high,
                          -interval->inverse_low};
}

/** @return The boxes that meet the region of rays. */
static mask boxes_meet_region(const Aabb *boxes, const Aabbs *region) {
    mask meets = mask_of(true);
    for (int axis = 0; axis < 3; axis++) {
        mask begins = boxes->planes[axis] <= real_of(region->high[axis]);
        mask ends = boxes->planes[axis + 3] >= real_of(region->low[axis]);
        meets &= begins & ends;
    }
    return meets;
}

mask packet_intervals_may_hit(const PacketIntervals *intervals, const Aabb *boxes, real *nearest) {
    real near = real_of(0), far = real_of(intervals->limit);
    for (int axis = 0; axis < 3; axis++) {
        const AxisInterval *interval = &intervals->axis[axis];
        if (interval->inverse_low > 0) {
            interval_clip_positive(&near, &far, interval, boxes->planes[axis],
                                   boxes->planes[axis + 3]);
        } else if (interval->inverse_high < 0) {
            AxisInterval negated = axis_interval_negated(interval);
            interval_clip_positive(&near, &far, &negated, -boxes->planes[axis + 3],
                                   -boxes->planes[axis]);
        }
    }
    *nearest = near * (1 - SLAB_SLACK);
    mask may_hit = *nearest <= far * (1 + SLAB_SLACK);
    return intervals->has_region ? may_hit & boxes_meet_region(boxes, &intervals->region) : may_hit;
}
