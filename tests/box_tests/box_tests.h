/**
 * @file
 * @brief What is checked of the boxes that one ray meets, once for each engine's number type and
 *        width.
 */
#ifndef DIOPTRE_TESTS_BOX_TESTS_H
#define DIOPTRE_TESTS_BOX_TESTS_H

#include <stdint.h>

/** The checks of a number type and width. */
typedef struct BoxChecks {
    /** Builds a tree over random boxes. @return What is wrong with the orders of its nodes; NULL:
     *  nothing is, or they have none. */
    const char *(*nodes)(uint64_t seed);

    /** Traverses a row of boxes with a ray that goes along it and ends at the first box.
     *  @param octant That of the ray's direction. @return Number of leaves that it visits. */
    unsigned (*leaves)(unsigned octant);

    /** Tests random boxes of any size and place with random rays, in packs and alone, in engines of
     *  one lane. @return What is wrong; NULL: nothing is. */
    const char *(*packs)(uint64_t seed);
} BoxChecks;

#endif
