/**
 * @file
 * @brief What is checked of octrees of tapes, once for each engine's number type and width.
 */
#ifndef DIOPTRE_TESTS_TAPE_OCTREE_H
#define DIOPTRE_TESTS_TAPE_OCTREE_H

#include <stdint.h>

/** What the check of one random tape found. */
typedef struct OctreeFinding {
    const char *fault;    /**< What is wrong; NULL: nothing is. */
    int point;            /**< The point of it. */
    uint64_t whole_steps; /**< Steps of the whole tape at all points. */
    uint64_t steps;       /**< Steps that were executed there. */
    unsigned cells;       /**< Cells of the octree; 0: there is none. */
} OctreeFinding;

/** The check of a number type and width. */
typedef struct OctreeChecks {
    /** Evaluates a random tape at random points, with its octree and as a whole: all bits must be
     *  equal, also of derivatives. @param balls Number of balls whose union the tape is; 0: any
     *  operations. */
    OctreeFinding (*run)(uint64_t seed, int balls);
} OctreeChecks;

#endif
