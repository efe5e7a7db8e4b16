/**
 * @file
 * @brief How rays leave a surface: off it, so that they do not meet it again.
 */
#ifndef DIOPTRE_TRACE_DEPARTURE_H
#define DIOPTRE_TRACE_DEPARTURE_H

#include "trace/ray.h"

/** Bounds on the error of a hit that a ray goes before it is behind the surface for good: its own,
 *  and that of another surface at the same place. */
#define THROUGH_BOUNDS 2
/** Least cosine of a ray that is moved along itself: nearer to the surface it would go too far. */
#define THROUGH_COSINE ((scalar)0.0625f)

/** How rays leave a surface. */
typedef struct Departure {
    OffsetStrategy strategy; /**< Which of the three. */
    scalar epsilon;          /**< For #OFFSET_FIXED: scene units. */
} Departure;

/** @return How far from a surface rays start, scene units. @param departure How.
 *  @param hit The surface. */
INLINE real departure_far(const Departure *departure, const Hit *hit) {
    return departure->strategy == OFFSET_FIXED  ? real_of(departure->epsilon)
           : departure->strategy == OFFSET_NONE ? real_of(0)
                                                : hit->error;
}

/**
 * @return Where rays that leave a surface start: moved along the normal, to the side that they
 *         travel to, by nothing, a fixed length or the hit's own error bound (doc/tour.md, "Leaving
 *         a surface").
 * @param departure  How far.
 * @param hit        The surface.
 * @param direction  Which way they leave.
 */
INLINE Vector departure_origin(const Departure *departure, const Hit *hit, Vector direction) {
    if (departure->strategy == OFFSET_NONE) {
        return hit->point;
    }
    real far = departure_far(departure, hit);
    mask is_outwards = vector_dot(direction, hit->normal) >= 0;
    return vector_add(hit->point, vector_scale(hit->normal, real_select(is_outwards, far, -far)));
}

/**
 * @return How far behind a surface rays start that go through it, in lengths of their direction:
 *         along themselves, so that they stay on their line, until they are #THROUGH_BOUNDS bounds
 *         behind the surface.
 * @param far     See #departure_far.
 * @param cosine  Between their direction, as long as it is, and the surface's normal; not negative.
 * @param length  Of their direction.
 */
INLINE real departure_way(real far, real cosine, real length) {
    return THROUGH_BOUNDS * far / real_max(cosine, THROUGH_COSINE * length);
}

/**
 * @return Where rays start that go through a surface. Those that graze it are moved along the
 *         normal for the rest.
 * @param hit     The surface.
 * @param far     See #departure_far.
 * @param onward  The normal, on the side that the rays go to.
 * @param direction  Which way they go.
 * @param cosine  direction . onward, not negative.
 * @param way     See #departure_way.
 */
INLINE Vector departure_through(const Hit *hit, real far, Vector onward, Vector direction,
                                real cosine, real way) {
    real rest = real_max(THROUGH_BOUNDS * far - cosine * way, real_of(0));
    Vector origin = vector_add(hit->point, vector_scale(direction, way));
    return vector_add(origin, vector_scale(onward, rest));
}

#endif
