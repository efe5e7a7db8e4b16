/**
 * @file
 * @brief Packs: numbers of several boxes, or of the corners of a polygon, side by side.
 *
 * In engines of several lanes a pack is a vector. Engines of one lane have packs of 16 bytes, the
 * vectors of every processor of today. That of quadruple precision has packs of float: each
 * operation on its own numbers is a call.
 */
#ifndef DIOPTRE_TRACE_MATH_PACK_H
#define DIOPTRE_TRACE_MATH_PACK_H

#include "trace/math/real.h"

#if REAL_BITS > 64
/** A number of a pack. */
typedef float pack_scalar;
#else
/** A number of a pack. */
typedef scalar pack_scalar;
#endif
#if LANES > 1
/** A pack of numbers. */
typedef real PackReal;
/** A pack of truth values. */
typedef mask PackMask;
#else
/** A pack of numbers. */
typedef pack_scalar PackReal __attribute__((vector_size(16)));
/** A pack of truth values: 0 or all bits set. */
typedef lane_integer PackMask __attribute__((vector_size(16)));
#endif
/** A #pack_scalar in memory. */
typedef pack_scalar stored_pack_scalar __attribute__((may_alias));

/** Number of numbers in a pack. */
enum { PACK_LANES = sizeof(PackReal) / sizeof(pack_scalar) };

/** @return The number at a place of some packs. */
INLINE pack_scalar pack_lane(const PackReal *packs, int i) {
    return ((const stored_pack_scalar *)packs)[i];
}

/** Sets the number at a place of some packs. */
INLINE void pack_set_lane(PackReal *packs, int i, pack_scalar x) {
    ((stored_pack_scalar *)packs)[i] = x;
}

/** @return The smaller numbers, like #real_min. */
INLINE PackReal pack_min(PackReal a, PackReal b) {
    return PACK_MIN(a, b);
}

/** @return The larger numbers, like #real_max. */
INLINE PackReal pack_max(PackReal a, PackReal b) {
    return PACK_MAX(a, b);
}

#endif
