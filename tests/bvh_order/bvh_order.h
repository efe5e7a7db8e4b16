/**
 * @file
 * @brief What is checked of the order in which a ray meets the children of nodes, once for each
 *        engine's number type and width.
 */
#ifndef DIOPTRE_TESTS_BVH_ORDER_H
#define DIOPTRE_TESTS_BVH_ORDER_H

#include <stdint.h>

/** The checks of a number type and width. */
typedef struct BvhOrderChecks {
    /** Builds a tree over random boxes. @return What is wrong with the orders of its nodes; NULL:
     *  nothing is, or they have none. */
    const char *(*nodes)(uint64_t seed);

    /** Traverses a row of boxes with a ray that goes along it and ends at the first box.
     *  @param octant That of the ray's direction. @return Number of leaves that it visits. */
    unsigned (*leaves)(unsigned octant);
} BvhOrderChecks;

#endif
