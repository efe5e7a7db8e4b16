/**
 * @file
 * @brief Shafts: planes through one point between which all rays of a packet run.
 *
 * A shape beyond one of the planes is missed by all rays. How far a shape reaches along the normal
 * of a plane is its support function (#ShapeClass.support), which is short for each convex shape:
 * the planes of a shaft are in the lanes of a vector, so one call asks for all (Haines, Wallace,
 * *Shaft Culling for Efficient Ray-Cast Radiosity*, 1991).
 */
#ifndef DIOPTRE_TRACE_TRACER_SHAFT_H
#define DIOPTRE_TRACE_TRACER_SHAFT_H

#include "trace/tracer/packet.h"

/** Most planes of a shaft: two per pair of axes. */
enum { SHAFT_PLANES = 6 };
/** Vectors with a plane in each lane. */
enum { SHAFT_VECTORS = (SHAFT_PLANES + LANES - 1) / LANES };
/** #Shaft.vector_count of a shaft that is computed when a shape asks for it. */
enum { SHAFT_NOT_SET = -1 };

/** A shaft: all points p of the rays have inward . (p - apex) >= -slack for each plane. */
typedef struct Shaft {
    Vec3s apex;                 /**< The point. */
    int vector_count;           /**< Number of vectors with planes; 0: nothing is missed. */
    Vec3 inward[SHAFT_VECTORS]; /**< Normals of the planes, of any length; 0: no plane. */
    real slack[SHAFT_VECTORS];  /**< See above; 0 or more. */
} Shaft;

/** Finds the shaft of a beam: its sides. Rays may be beside them by #NARROW_BEAM_SLACK, which
 * supports contain. A beam that is not narrow, or a single ray, has no planes. */
INLINE void beam_shaft(const Beam *beam, Shaft *shaft) {
    const Vec3 axis = vec3_splat(beam->axis), across = vec3_splat(beam->across),
               up = vec3_splat(beam->up);
    // One side of the beam per lane: right, left, upper, lower. Further lanes repeat them.
    const mask is_up = (lane_numbers() & 2) == 2, is_opposite = (lane_numbers() & 1) == 1;
    Vec3 sideways = vec3_select(is_up, up, across), along = vec3_select(is_up, across, up);
    real sign = real_select(is_opposite, real_of(-1), real_of(1));
    Vec3 normal = vec3_cross(vec3_add(axis, vec3_scale(sideways, sign)), along);
    real inwards = real_select(vec3_dot(normal, axis) < 0, real_of(-1), real_of(1));
    const bool has_width = vec3s_abs_sum(beam->across) > 0 && vec3s_abs_sum(beam->up) > 0;
    shaft->apex = beam->origin;
    shaft->vector_count = has_width && beam_is_narrow(beam) ? 1 : 0;
    shaft->inward[0] = vec3_scale(normal, inwards);
    shaft->slack[0] = real_of(0);
}

/** Finds the shaft of rays that end at a point: planes along one axis each, which touch the box
 * of the origins. @param intervals Those of the rays; they have a #PacketIntervals.region. */
void intervals_shaft(const PacketIntervals *intervals, Shaft *shaft);

/** @return Whether all rays in a shaft surely miss a shape, which has a #ShapeClass.support. */
INLINE bool shaft_misses(const Shaft *shaft, const Shape *shape) {
    bool is_missed = false;
    for (int i = 0; i < shaft->vector_count && !is_missed; i++) {
        real reach = shape->class->support(shape, shaft->apex, shaft->inward[i]);
        is_missed = any(reach < -shaft->slack[i]);
    }
    return is_missed;
}

#endif
