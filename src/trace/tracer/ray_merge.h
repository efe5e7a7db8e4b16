/**
 * @file
 * @brief Merging of queued rays that nearly coincide.
 */
#ifndef DIOPTRE_TRACE_TRACER_RAY_MERGE_H
#define DIOPTRE_TRACE_TRACER_RAY_MERGE_H

#include "trace/math/hash.h"
#include "trace/tracer/ray_queue.h"

/** Shifts the grid of merge cells, so that no side of one is at a coordinate that is common in
 *  scenes: the starts of rays on such a plane differ by rounding errors only. */
#define MERGE_CELL_SHIFT 0.317

/** Slots of a merge table: twice as many as the rays of a level, so that few collide. */
enum { MERGE_SLOTS = 2 * RAY_COLUMN_CAPACITY };

/** Finds rays by where they start: a hash table with linear probing. */
typedef struct MergeTable {
    uint32_t levels[MERGE_SLOTS]; /**< The level that each slot was filled in; others are free. */
    unsigned places[MERGE_SLOTS]; /**< Where in its columns the ray is. */
    uint32_t level;               /**< Number of levels so far. */
} MergeTable;

/** Which rays are merged. */
typedef struct MergeLimits {
    double start_size;       /**< How far apart they may start, along each axis. */
    double direction_size;   /**< How much their directions may differ, in each component. */
    scalar light_throughput; /**< Rays of less throughput are merged; others stay as they are. */
    int interior_count;      /**< Number of columns of #RayColumns.interior that are used. */
} MergeLimits;

/** How many rays were merged. */
typedef struct MergeCounts {
    unsigned light;  /**< Rays of little throughput. */
    unsigned merged; /**< Those that another now stands for. */
} MergeCounts;

/* --- finding rays that coincide --------------------------------------------------------------- */

/** @return A number of the cell that a coordinate is in. @param size Of a cell. */
static inline uint64_t merge_cell(scalar x, double size) {
    double cell = floor((double)x / size + MERGE_CELL_SHIFT);
    uint64_t bits;
    memcpy(&bits, &cell, sizeof bits);
    return bits;
}

/** @return The slot in which the search for a ray begins: few rays with the same start go different
 *  ways. @param place Of the ray. */
static inline unsigned merge_slot(const MergeLimits *limits, const RayColumns *columns,
                                  unsigned place) {
    uint64_t hash = 0;
    for (int axis = 0; axis < 3; axis++) {
        scalar start = columns->numbers[RAY_COLUMN_ORIGIN][axis][place];
        hash = hash_combine_u64(hash, merge_cell(start, limits->start_size));
    }
    return (unsigned)(hash % MERGE_SLOTS);
}

/** @return Whether three numbers of two rays differ by at most a size each. */
static inline bool numbers_are_near(const RayColumns *a, unsigned place_a, const RayColumns *b,
                                    unsigned place_b, RayColumnGroup group, double size) {
    bool is_near = true;
    for (int axis = 0; axis < 3; axis++) {
        double x = (double)a->numbers[group][axis][place_a],
               y = (double)b->numbers[group][axis][place_b];
        is_near = is_near && fabs(x - y) <= size;
    }
    return is_near;
}

/** @return Whether two rays nearly coincide. @param a, place_a One. @param b, place_b The other. */
static inline bool rays_coincide(const MergeLimits *limits, const RayColumns *a, unsigned place_a,
                                 const RayColumns *b, unsigned place_b) {
    bool is_same = a->turns[place_a] == b->turns[place_b];
    for (int i = 0; i < limits->interior_count; i++) {
        is_same = is_same && a->interior[i][place_a] == b->interior[i][place_b];
    }
    return is_same &&
           numbers_are_near(a, place_a, b, place_b, RAY_COLUMN_ORIGIN, limits->start_size) &&
           numbers_are_near(a, place_a, b, place_b, RAY_COLUMN_DIRECTION, limits->direction_size);
}

/** @return The slot of the ray that another coincides with, or the free slot for that. */
static inline unsigned merge_find(const MergeTable *table, const MergeLimits *limits,
                                  const RayColumns *kept, const RayColumns *columns,
                                  unsigned place) {
    unsigned slot = merge_slot(limits, columns, place);
    while (table->levels[slot] == table->level &&
           !rays_coincide(limits, columns, place, kept, table->places[slot])) {
        slot = (slot + 1) % MERGE_SLOTS;
    }
    return slot;
}

/* --- merging ---------------------------------------------------------------------------------- */

/** @return The largest channel of a ray's throughput. */
static inline scalar ray_throughput(const RayColumns *columns, unsigned place) {
    const scalar red = columns->numbers[RAY_COLUMN_THROUGHPUT][0][place],
                 green = columns->numbers[RAY_COLUMN_THROUGHPUT][1][place],
                 blue = columns->numbers[RAY_COLUMN_THROUGHPUT][2][place];
    scalar most = red > green ? red : green;
    return most > blue ? most : blue;
}

/** Adds the throughput of a ray to one that stands for both. The path of the heavier one counts;
 *  its own throughput is kept in the column of weights, which merged rays do not need. */
static inline void ray_merge(const MergeLimits *limits, const RayColumns *columns, unsigned place,
                             RayColumns *kept, unsigned kept_place) {
    const scalar throughput = ray_throughput(columns, place);
    scalar *heaviest = &kept->numbers[RAY_COLUMN_WEIGHT][0][kept_place];
    scalar sums[3];
    for (int i = 0; i < 3; i++) {
        sums[i] = kept->numbers[RAY_COLUMN_THROUGHPUT][i][kept_place] +
                  columns->numbers[RAY_COLUMN_THROUGHPUT][i][place];
    }
    if (throughput > *heaviest) {
        ray_columns_copy(columns, place, kept, kept_place, 1, limits->interior_count);
        *heaviest = throughput;
    }
    for (int i = 0; i < 3; i++) {
        kept->numbers[RAY_COLUMN_THROUGHPUT][i][kept_place] = sums[i];
    }
}

/** Begins a level, without rays. */
static inline void merge_begin_level(MergeTable *table, RayQueue *level) {
    level->count = 0;
    if (++table->level == 0) {
        memset(table->levels, 0, sizeof table->levels);
        table->level = 1;
    }
}

/**
 * Adds the rays of a queue to a level, or merges them with rays of it.
 * @param table  Has the rays of the level.
 * @param level  Has room for the rays of the queue.
 * @param[in,out] counts  The rays are counted.
 */
static inline void ray_queue_merge(MergeTable *table, const MergeLimits *limits,
                                   const RayQueue *queue, RayQueue *level, MergeCounts *counts) {
    const RayColumns *columns = queue->columns;
    RayColumns *kept = level->columns;
    for (unsigned i = 0; i < queue->count; i++) {
        unsigned place = RAY_COLUMN_FIRST + i, kept_place = RAY_COLUMN_FIRST + level->count;
        scalar throughput = ray_throughput(columns, place);
        if (throughput < limits->light_throughput) {
            unsigned slot = merge_find(table, limits, kept, columns, place);
            counts->light++;
            if (table->levels[slot] == table->level) {
                ray_merge(limits, columns, place, kept, table->places[slot]);
                counts->merged++;
                continue;
            }
            table->levels[slot] = table->level;
            table->places[slot] = kept_place;
        }
        ray_columns_copy(columns, place, kept, kept_place, 1, limits->interior_count);
        kept->numbers[RAY_COLUMN_WEIGHT][0][kept_place] = throughput;
        level->count++;
    }
}

#endif
