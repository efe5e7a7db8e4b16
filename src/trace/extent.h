/**
 * @file
 * @brief Boxes that grow, for building trees.
 */
#ifndef DIOPTRE_TRACE_EXTENT_H
#define DIOPTRE_TRACE_EXTENT_H

#include "trace/real.h"

/** Coordinates of an extent; the fourth is not used, so that four numbers fill a vector. */
enum { COORDINATES = 4 };

/** A box that grows. */
typedef struct Extent {
    scalar low[COORDINATES];  /**< Lowest coordinates. */
    scalar high[COORDINATES]; /**< Highest coordinates. */
} Extent;

/** @return An extent that holds nothing. */
static inline Extent extent_nothing(void) {
    Extent e;
    for (int i = 0; i < COORDINATES; i++) {
        e.low[i] = INFINITE;
        e.high[i] = -INFINITE;
    }
    return e;
}

/** Makes an extent hold another. @param[in,out] e The extent. @param by The other. */
static inline void extent_grow(Extent *e, const Extent *by) {
    for (int i = 0; i < COORDINATES; i++) {
        e->low[i] = by->low[i] < e->low[i] ? by->low[i] : e->low[i];
        e->high[i] = by->high[i] > e->high[i] ? by->high[i] : e->high[i];
    }
}

/** @return Half the surface of an extent: in proportion to the rays that meet it.
 *  @param e The extent, not empty. */
static inline scalar extent_area(const Extent *e) {
    scalar x = e->high[0] - e->low[0], y = e->high[1] - e->low[1], z = e->high[2] - e->low[2];
    return x * y + y * z + z * x;
}

/** Makes an extent hold twice the middle of another. @param[in,out] e The extent.
 *  @param of The other. */
static inline void extent_grow_middle(Extent *e, const Extent *of) {
    for (int i = 0; i < COORDINATES; i++) {
        scalar middle = of->low[i] + of->high[i];
        e->low[i] = middle < e->low[i] ? middle : e->low[i];
        e->high[i] = middle > e->high[i] ? middle : e->high[i];
    }
}

#endif
