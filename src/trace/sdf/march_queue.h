/**
 * @file
 * @brief Rays between two of their steps, in columns: rays that are finished make room for others.
 *
 * Some rays of a packet end after two steps, others after two hundred. A vector that waits for the
 * slowest of its own rays makes half of its steps for lanes that are finished. Here rays of other
 * vectors of the packet take these lanes. The path of a ray does not depend on the others, so its
 * bits are the same.
 */
#ifndef DIOPTRE_TRACE_SDF_MARCH_QUEUE_H
#define DIOPTRE_TRACE_SDF_MARCH_QUEUE_H

#include "trace/math/columns.h"
#include "trace/sdf/sphere_tracer.h"

#if LANES > 1

_Static_assert(sizeof(mask) == sizeof(real), "columns hold masks, too");

/** Rooms of a column. Fewer than LANES rays wait when the next vector begins, which adds LANES;
 * then at most half of a vector goes back. */
enum { MARCH_QUEUE_ROOMS = COLUMN_ROOMS(3 * LANES) };

// Lists of numbers in #SphereTrace: NUMBER is expanded for a real or mask, VECTOR for three reals.
// clang-format off

/** What changes in steps inside a box, and what these need. */
#define MARCH_BOX_NUMBERS(NUMBER, VECTOR)                                                          \
    NUMBER(ray) VECTOR(origin) VECTOR(unit_direction) NUMBER(t_end) NUMBER(t_limit)                \
    NUMBER(camera_ahead) NUMBER(leaving) NUMBER(side) NUMBER(t) NUMBER(step) NUMBER(radius)        \
    NUMBER(slope) NUMBER(steps)

/** The same for the cells of a grid. */
#define MARCH_GRID_NUMBERS(NUMBER, VECTOR)                                                         \
    NUMBER(stepping) NUMBER(seeking) NUMBER(entering) NUMBER(limit) VECTOR(cell)                   \
    NUMBER(cell_entry) NUMBER(box_entry) NUMBER(camera_distance) NUMBER(direction_length)          \
    VECTOR(walk.t_first_wall) VECTOR(walk.t_delta) VECTOR(walk.step) VECTOR(walk.to_center)        \
    VECTOR(walk.direction) VECTOR(inverse_direction)

/** What the cells of a grid need in the next wider type. */
#define MARCH_GRID_WIDES(VECTOR)                                                                   \
    VECTOR(grid_origin) VECTOR(grid_direction) VECTOR(local_direction)

/** What a hit needs in a box, besides what its ray has had from the beginning. */
#define MARCH_BOX_RESULTS(NUMBER, VECTOR) NUMBER(arrived) NUMBER(t)

/** The same in the cells of a grid. */
#define MARCH_GRID_RESULTS(NUMBER, VECTOR)                                                         \
    VECTOR(origin) NUMBER(camera_ahead) VECTOR(cell) NUMBER(cell_entry) NUMBER(box_entry)

// clang-format on

/** Counts a number. */
#define MARCH_COUNT_NUMBER(name) +1
/** Counts three numbers. */
#define MARCH_COUNT_VECTOR(name) +3
enum {
    MARCH_BOX_COLUMNS =
        MARCH_BOX_NUMBERS(MARCH_COUNT_NUMBER, MARCH_COUNT_VECTOR), /**< Columns of a box. */
    MARCH_COLUMNS = MARCH_BOX_COLUMNS MARCH_GRID_NUMBERS(
        MARCH_COUNT_NUMBER, MARCH_COUNT_VECTOR),              /**< Those of a grid in all. */
    MARCH_WIDE_COLUMNS = MARCH_GRID_WIDES(MARCH_COUNT_VECTOR) /**< Those of wide numbers. */
};

/** Rays that wait; the last to come is the first to go. */
typedef struct MarchQueue {
    unsigned count;                                           /**< Number of rays. */
    scalar columns[MARCH_COLUMNS][MARCH_QUEUE_ROOMS];         /**< Their numbers. */
    wide_scalar wides[MARCH_WIDE_COLUMNS][MARCH_QUEUE_ROOMS]; /**< Their wide numbers. */
} MarchQueue;

/** Adds a number of the rays to the next column. */
#define PUSH_NUMBER(name)                                                                          \
    real_compress(&(*column++)[count], real_load((const scalar *)(const void *)&trace->name), bits);
/** Adds three. */
#define PUSH_VECTOR(name) PUSH_NUMBER(name.x) PUSH_NUMBER(name.y) PUSH_NUMBER(name.z)
/** Adds three wide numbers. */
#define PUSH_WIDE_VECTOR(name)                                                                     \
    wide_compress(&(*wides++)[count], &trace->name.x, bits);                                       \
    wide_compress(&(*wides++)[count], &trace->name.y, bits);                                       \
    wide_compress(&(*wides++)[count], &trace->name.z, bits);

/** Adds rays. @param bits Their lanes. @param is_repeated Whether the field has a grid. */
static void march_queue_push(MarchQueue *queue, const SphereTrace *trace, unsigned bits,
                             bool is_repeated) {
    const unsigned count = queue->count;
    scalar(*column)[MARCH_QUEUE_ROOMS] = queue->columns;
    MARCH_BOX_NUMBERS(PUSH_NUMBER, PUSH_VECTOR)
    if (is_repeated) {
        wide_scalar(*wides)[MARCH_QUEUE_ROOMS] = queue->wides;
        MARCH_GRID_NUMBERS(PUSH_NUMBER, PUSH_VECTOR)
        MARCH_GRID_WIDES(PUSH_WIDE_VECTOR)
    }
    queue->count = count + (unsigned)__builtin_popcount(bits);
}

#undef PUSH_NUMBER
#undef PUSH_VECTOR
#undef PUSH_WIDE_VECTOR

/** Takes a number of the rays from the next column. */
#define POP_NUMBER(name) real_store((scalar *)(void *)&trace->name, real_load(&(*column++)[count]));
/** Takes three. */
#define POP_VECTOR(name) POP_NUMBER(name.x) POP_NUMBER(name.y) POP_NUMBER(name.z)
/** Takes three wide numbers. */
#define POP_WIDE_VECTOR(name)                                                                      \
    trace->name.x = wide_load(&(*wides++)[count]);                                                 \
    trace->name.y = wide_load(&(*wides++)[count]);                                                 \
    trace->name.z = wide_load(&(*wides++)[count]);

/** Takes up to LANES rays. @param is_repeated Whether the field has a grid. */
INLINE void march_queue_pop(MarchQueue *queue, SphereTrace *trace, bool is_repeated) {
    const unsigned taken = queue->count < LANES ? queue->count : LANES,
                   count = queue->count - taken;
    scalar(*column)[MARCH_QUEUE_ROOMS] = queue->columns;
    MARCH_BOX_NUMBERS(POP_NUMBER, POP_VECTOR)
    if (is_repeated) {
        wide_scalar(*wides)[MARCH_QUEUE_ROOMS] = queue->wides;
        MARCH_GRID_NUMBERS(POP_NUMBER, POP_VECTOR)
        MARCH_GRID_WIDES(POP_WIDE_VECTOR)
    }
    queue->count = count;
    mask lanes = lane_numbers() < integer_of((int)taken);
    trace->stepping = is_repeated ? trace->stepping & lanes : lanes;
    trace->seeking = trace->seeking & lanes;
    trace->entering = trace->entering & lanes;
}

#undef POP_NUMBER
#undef POP_VECTOR
#undef POP_WIDE_VECTOR

/** Copies a number of one ray. */
#define COPY_NUMBER(name)                                                                          \
    ((stored_scalar *)(void *)&home->name)[to] =                                                   \
        ((const stored_scalar *)(const void *)&trace->name)[from];
/** Copies three. */
#define COPY_VECTOR(name) COPY_NUMBER(name.x) COPY_NUMBER(name.y) COPY_NUMBER(name.z)

/** Writes the results of rays that have arrived to the vectors that they come from. @param traces
 *  Those of the packet. */
INLINE void march_results_write(const SphereTrace *trace, SphereTrace *traces, bool is_repeated) {
    for (unsigned bits = mask_bits(trace->arrived); bits; bits &= bits - 1) {
        int from = __builtin_ctz(bits), ray = integer_at(&trace->ray, from), to = ray % LANES;
        SphereTrace *home = &traces[ray / LANES];
        MARCH_BOX_RESULTS(COPY_NUMBER, COPY_VECTOR)
        if (is_repeated) {
            MARCH_GRID_RESULTS(COPY_NUMBER, COPY_VECTOR)
        }
    }
}

#undef COPY_NUMBER
#undef COPY_VECTOR

#endif

#endif
