/**
 * @file
 * @brief What is checked of octrees of tapes, once for each engine's number type and width.
 */
#ifndef DIOPTRE_TESTS_TAPE_OCTREE_H
#define DIOPTRE_TESTS_TAPE_OCTREE_H

#include <stdint.h>

/** What the check of random tapes found. */
typedef struct OctreeFinding {
    const char *fault;    /**< What is wrong; NULL: nothing is. */
    int point;            /**< The point of it. */
    uint64_t whole_steps; /**< Operations at all points without octrees. */
    uint64_t steps;       /**< Operations with them. */
    unsigned cells;       /**< Cells of the first octree; 0: there is none. */
} OctreeFinding;

/** A tape that is to have no octree. */
typedef enum OctreeRefusal {
    OCTREE_HUGE_BOX,      /**< Its box is larger than float can compute with. */
    OCTREE_UNKNOWN,       /**< No range of its minima is known: nothing can be left out. */
    OCTREE_REFUSAL_COUNT, /**< Number of these. */
} OctreeRefusal;

/** The checks of a number type and width. */
typedef struct OctreeChecks {
    /** Evaluates two random tapes, of which the second one has a factor and is clamped to its box,
     * at random points, with octrees and without: all bits must be equal, also of derivatives.
     * @param balls Number of balls whose union a tape is; 0: any operations. */
    OctreeFinding (*run)(uint64_t seed, int balls);

    /** @return Number of cells of a tape; 0: it has no octree. */
    unsigned (*cells)(OctreeRefusal refusal);
} OctreeChecks;

#endif
