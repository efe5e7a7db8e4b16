/**
 * @file
 * @brief Permutations of the lanes of a vector, and orders of lanes that take four bits per place.
 */
#ifndef DIOPTRE_TRACE_MATH_PERMUTE_H
#define DIOPTRE_TRACE_MATH_PERMUTE_H

#include "trace/math/wide.h"

#ifdef LANES_PERMUTE
#if LANES == 16
/** An order of lanes: four bits per place. */
typedef uint64_t lane_order;
#else
/** An order of lanes: four bits per place. */
typedef uint32_t lane_order;
#endif

/** @return The lowest bit of a place in an order. 64 bits fill two lanes of a vector: one half has
 *          the even places, the other one the odd ones. */
INLINE int lane_order_shift(int place) {
    return LANES == 16 ? place % 2 * 32 + place / 2 * 4 : place * 4;
}

/** @return An order with a lane at a place that was 0. */
INLINE lane_order lane_order_with(lane_order order, int place, int lane) {
    return order | (lane_order)lane << lane_order_shift(place);
}

/** @return The lane at a place. */
INLINE int lane_order_at(lane_order order, int place) {
    return (int)(order >> lane_order_shift(place) & 15);
}

/** @return The lanes of an order, as real_permute() reads them: with further bits above. */
INLINE integer lane_order_unpack(lane_order order) {
    integer shifts = (LANES == 16 ? lane_numbers() >> 1 : lane_numbers()) * 4;
    return LANES_SHIFT_RIGHT(LANES_OF_BITS(order), shifts);
}

/** See real_permute(). */
INLINE integer integer_permute(integer x, integer lanes) {
    return (integer)LANES_PERMUTE(x, lanes);
}

#endif

/** @return Lane lanes[i] of numbers in memory in lane i; where no instruction permutes lanes, all
 *          lanes[i] must be the same. */
INLINE real real_permute(const real *x, integer lanes) {
#ifdef LANES_PERMUTE
    return LANES_PERMUTE(*x, lanes);
#else
    return real_of(real_at(x, integer_lane(lanes, 0)));
#endif
}

#ifdef LANES_PERMUTE_HALVES
/** Whether wide_permute() takes any lanes. */
#define HAS_WIDE_PERMUTE 1
#else
/** Whether wide_permute() takes any lanes. */
#define HAS_WIDE_PERMUTE 0
#endif

/** See real_permute(); if not #HAS_WIDE_PERMUTE, all lanes[i] must be the same. */
INLINE wide wide_permute(const wide *x, integer lanes) {
#ifdef LANES_PERMUTE_HALVES
    const WideHalves from = {*x};
    WideHalves to;
    to.halves[0] = LANES_PERMUTE_HALVES(from.halves[0], from.halves[1], LANES_HALF(lanes, 0));
    to.halves[1] = LANES_PERMUTE_HALVES(from.halves[0], from.halves[1], LANES_HALF(lanes, 1));
    return to.whole;
#else
    return wide_of(wide_at(x, integer_lane(lanes, 0)));
#endif
}

#endif
