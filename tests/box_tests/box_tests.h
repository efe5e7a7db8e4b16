/**
 * @file
 * @brief What is checked of the boxes that rays meet, once for each engine's number type and width.
 */
#ifndef DIOPTRE_TESTS_BOX_TESTS_H
#define DIOPTRE_TESTS_BOX_TESTS_H

#include <stdint.h>

/** What is checked. */
typedef enum BoxCheck {
    BOX_ORDERS,    /**< The orders of a node have each child once, from far to near. */
    BOX_ROW,       /**< A ray along a row of boxes, in any octant, that ends at the first one visits
                        one leaf. */
    BOX_PACKS,     /**< A pack has each box that a ray meets by the test of one box, and no lower
                        bound beyond its; random boxes and rays of any size. */
    BOX_QUADS,     /**< One ray meets a quad, all of whose edges it passes at once, where it meets
                        its polygon, edge by edge: through corners, along edges, beyond the range. */
    BOX_INTERVALS, /**< The same as BOX_PACKS for the intervals of a packet, and for those of a
                      vector. */
    BOX_CHECK_COUNT
} BoxCheck;

/** The checks of a number type and width. */
typedef struct BoxChecks {
    /** A check. @return What is wrong; NULL: nothing is. NULL: the engine has no such thing. */
    const char *(*run[BOX_CHECK_COUNT])(uint64_t seed);
} BoxChecks;

#endif
