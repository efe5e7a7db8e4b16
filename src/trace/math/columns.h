/**
 * @file
 * @brief Columns: numbers of many rays in memory, the same number of all rays side by side.
 *
 * A vector is loaded from a column by one instruction, wherever it starts. To store chosen lanes
 * one after another is stream compaction: it makes full vectors of sparse ones.
 */
#ifndef DIOPTRE_TRACE_MATH_COLUMNS_H
#define DIOPTRE_TRACE_MATH_COLUMNS_H

#include "trace/math/vec3.h"

#include <string.h>

/** An #integer in memory. */
#if LANES > 1
typedef lane_integer integer_scalar;
#else
typedef int integer_scalar;
#endif

/** The rooms of a column for at least n numbers. A vector may be written beyond the last of them;
 *  and columns side by side must not begin at the same place of a page, where a cache holds only a
 *  few (8 or 12 ways): three cache lines of 64 bytes more keep them apart. */
#define COLUMN_ROOMS(n) ((n) + LANES + 3 * 64 / (int)sizeof(scalar))

/** @return LANES numbers of a column. */
INLINE real real_load(const scalar *from) {
    real x;
    memcpy(&x, from, sizeof x);
    return x;
}

#ifdef LANES_PERMUTE
/** Whether real_gather_near() is faster than real_gather(). */
#define HAS_GATHER_NEAR 1
#else
/** Whether real_gather_near() is faster than real_gather(). */
#define HAS_GATHER_NEAR 0
#endif

/** @return from[offsets[i]] in lane i, for offsets from 0 to LANES - 1. */
INLINE real real_gather_near(const scalar *from, integer offsets) {
#if HAS_GATHER_NEAR
    return LANES_PERMUTE(real_load(from), offsets);
#else
    return real_gather(from, offsets);
#endif
}

/** Stores LANES numbers. */
INLINE void real_store(scalar *to, real x) {
    memcpy(to, &x, sizeof x);
}

/** @return LANES integers of a column. */
INLINE integer integer_load(const integer_scalar *from) {
    integer x;
    memcpy(&x, from, sizeof x);
    return x;
}

/** Stores LANES integers. */
INLINE void integer_store(integer_scalar *to, integer x) {
    memcpy(to, &x, sizeof x);
}

/** Stores the lanes whose bits are set, one after another; what follows is written over, up to
 *  LANES numbers in all. */
INLINE void real_compress(scalar *to, real x, unsigned bits) {
#ifdef LANES_COMPRESS
    LANES_COMPRESS(to, x, bits);
#else
    // A lane that is not chosen is written over by the next: no branch depends on the bits.
    for (int i = 0; i < LANES; i++) {
        *to = real_lane(x, i);
        to += bits >> i & 1;
    }
#endif
}

/** See real_compress(). */
INLINE void integer_compress(integer_scalar *to, integer x, unsigned bits) {
#ifdef LANES_COMPRESS
    LANES_COMPRESS((void *)to, x, bits);
#else
    for (int i = 0; i < LANES; i++) {
        *to = integer_lane(x, i);
        to += bits >> i & 1;
    }
#endif
}

/** @return LANES wide numbers of a column. */
INLINE wide wide_load(const wide_scalar *from) {
    wide x;
    memcpy(&x, from, sizeof x);
    return x;
}

/** See real_compress(). */
INLINE void wide_compress(wide_scalar *to, const wide *x, unsigned bits) {
#if REAL_BITS != 32
    real_compress(to, *x, bits); // They are no wider.
#elif defined(LANES_COMPRESS_WIDE)
    LANES_COMPRESS_WIDE(to, x, bits);
#else
    for (int i = 0; i < LANES; i++) {
        *to = wide_at(x, i);
        to += bits >> i & 1;
    }
#endif
}

/** @return LANES vectors of three columns. */
INLINE Vec3 vec3_load(const scalar *x, const scalar *y, const scalar *z) {
    return (Vec3){real_load(x), real_load(y), real_load(z)};
}

#endif
