/**
 * @file
 * @brief What is checked of the compaction of wavefronts, once for each engine's number type and
 *        width.
 */
#ifndef DIOPTRE_TESTS_COMPACTION_H
#define DIOPTRE_TESTS_COMPACTION_H

#include <stdint.h>

/** What a check found. */
typedef struct CompactionFault {
    const char *what; /**< What is wrong; NULL: nothing is. */
    unsigned bits;    /**< The lanes that were chosen. */
    unsigned place;   /**< The ray that is wrong. */
} CompactionFault;

/** What is checked. */
typedef enum CompactionCheck {
    COMPACTION_PATTERNS, /**< Each choice of lanes is stored in their order, and no room beyond the
                              LANES of the vector is touched. */
    COMPACTION_STREAMS,  /**< Many vectors with random lanes: the queue has the chosen rays, whole
                            and  in order. */
    COMPACTION_PACKETS,  /**< Packets of 1 to PACKET_RAYS queued rays: each ray once, and unused
                            lanes  safe to compute with. */
    COMPACTION_JOINS,    /**< The last rays of a queue before the first of another. */
    COMPACTION_MERGES,   /**< Rays that coincide become one, with all their throughput; rays that
                              differ in anything, or weigh much, stay. */
    COMPACTION_CHECK_COUNT
} CompactionCheck;

/** The checks of a number type and width. */
typedef struct CompactionChecks {
    CompactionFault (*run[COMPACTION_CHECK_COUNT])(uint64_t seed); /**< A check of random rays. */
} CompactionChecks;

#endif
