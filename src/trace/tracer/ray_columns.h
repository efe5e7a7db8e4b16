/**
 * @file
 * @brief Rays that wait to be traced, in columns.
 */
#ifndef DIOPTRE_TRACE_TRACER_RAY_COLUMNS_H
#define DIOPTRE_TRACE_TRACER_RAY_COLUMNS_H

#include "trace/math/columns.h"
#include "trace/tracer/secondary_rays.h"

/** Most rays in columns. */
enum { RAY_COLUMN_CAPACITY = 1 << 14 };
/** Rooms before the first ray: for the last rays of other columns, to fill a packet. */
enum { RAY_COLUMN_FIRST = PACKET_RAYS };
/** Rooms of a column. */
enum { RAY_COLUMN_ROOMS = COLUMN_ROOMS(RAY_COLUMN_FIRST + RAY_COLUMN_CAPACITY) };

/** What of a ray is a number: three columns each. */
typedef enum RayColumnGroup {
    RAY_COLUMN_ORIGIN,
    RAY_COLUMN_DIRECTION,  /**< A unit vector. */
    RAY_COLUMN_THROUGHPUT, /**< See #RayState. */
    RAY_COLUMN_WEIGHT,     /**< The factor of its colour in that of the ray it comes from. */
    RAY_COLUMN_GROUP_COUNT
} RayColumnGroup;

/** Rays in columns. */
typedef struct RayColumns {
    scalar numbers[RAY_COLUMN_GROUP_COUNT][3][RAY_COLUMN_ROOMS]; /**< Numbers of the rays. */
    integer_scalar turns[RAY_COLUMN_ROOMS];                      /**< See #RayState. */
    integer_scalar link[RAY_COLUMN_ROOMS];   /**< Whose children they are: see node_link(). */
    integer_scalar sample[RAY_COLUMN_ROOMS]; /**< Their camera rays. */
    /** The shapes that they are inside of; only as many columns as the scene needs are used. */
    integer_scalar interior[INTERIOR_LIST_CAPACITY][RAY_COLUMN_ROOMS];
} RayColumns;

/** LANES rays from columns, or for them. */
typedef struct RayVector {
    real numbers[RAY_COLUMN_GROUP_COUNT][3]; /**< See #RayColumns. */
    integer turns;                           /**< See #RayColumns. */
    integer link;                            /**< See #RayColumns. */
    integer sample;                          /**< See #RayColumns. */
    InteriorList interior;                   /**< See #RayColumns. */
} RayVector;

/** @return Number of columns of #RayColumns.interior that the rays of a scene use. */
static inline int ray_columns_interior_count(const Dielectrics *dielectrics) {
    size_t shapes = dielectrics->transparent.count;
    return shapes < INTERIOR_LIST_CAPACITY ? (int)shapes : INTERIOR_LIST_CAPACITY;
}

/** @return A vector of rays for columns. @param weight, link, sample See #RayColumns. */
INLINE RayVector ray_vector_of(const RayState *rays, int v, Rgb weight, integer link,
                               integer sample) {
    const Vec3 *origin = &rays->packet.rays[v].origin, *direction = &rays->packet.rays[v].direction;
    const Rgb *throughput = &rays->throughput[v];
    return (RayVector){.numbers = {{origin->x, origin->y, origin->z},
                                   {direction->x, direction->y, direction->z},
                                   {throughput->red, throughput->green, throughput->blue},
                                   {weight.red, weight.green, weight.blue}},
                       .turns = rays->turns[v],
                       .link = link,
                       .sample = sample,
                       .interior = rays->interior[v]};
}

/** Stores chosen rays one after another. @param first Place of the first. @param bits The lanes.
 *  @param interior_count Number of columns of #RayColumns.interior that are used. */
INLINE void ray_columns_store(RayColumns *columns, unsigned first, unsigned bits,
                              const RayVector *rays, int interior_count) {
    for (int group = 0; group < RAY_COLUMN_GROUP_COUNT; group++) {
        for (int i = 0; i < 3; i++) {
            real_compress(&columns->numbers[group][i][first], rays->numbers[group][i], bits);
        }
    }
    integer_compress(&columns->turns[first], rays->turns, bits);
    integer_compress(&columns->link[first], rays->link, bits);
    integer_compress(&columns->sample[first], rays->sample, bits);
    for (int i = 0; i < interior_count; i++) {
        integer_compress(&columns->interior[i][first], rays->interior.shapes[i], bits);
    }
}

/** @return LANES rays. @param first Place of the first. @param interior_count As they were stored.
 */
INLINE RayVector ray_columns_load(const RayColumns *columns, unsigned first, int interior_count) {
    RayVector rays;
    for (int group = 0; group < RAY_COLUMN_GROUP_COUNT; group++) {
        for (int i = 0; i < 3; i++) {
            rays.numbers[group][i] = real_load(&columns->numbers[group][i][first]);
        }
    }
    rays.turns = integer_load(&columns->turns[first]);
    rays.link = integer_load(&columns->link[first]);
    rays.sample = integer_load(&columns->sample[first]);
    for (int i = 0; i < INTERIOR_LIST_CAPACITY; i++) {
        rays.interior.shapes[i] =
            i < interior_count ? integer_load(&columns->interior[i][first]) : integer_of(-1);
    }
    return rays;
}

/** Copies rays. @param first Place of the first. @param to_first Its new place. */
static inline void ray_columns_copy(const RayColumns *columns, unsigned first, RayColumns *to,
                                    unsigned to_first, unsigned count, int interior_count) {
    const size_t reals = count * sizeof(scalar), integers = count * sizeof(integer_scalar);
    for (int group = 0; group < RAY_COLUMN_GROUP_COUNT; group++) {
        for (int i = 0; i < 3; i++) {
            memcpy(&to->numbers[group][i][to_first], &columns->numbers[group][i][first], reals);
        }
    }
    memcpy(&to->turns[to_first], &columns->turns[first], integers);
    memcpy(&to->link[to_first], &columns->link[first], integers);
    memcpy(&to->sample[to_first], &columns->sample[first], integers);
    for (int i = 0; i < interior_count; i++) {
        memcpy(&to->interior[i][to_first], &columns->interior[i][first], integers);
    }
}

/** @return x, with the number of the first lane in all lanes but those. */
INLINE real real_repeat_first(real x, mask lanes) {
    return real_select(lanes, x, real_of(real_lane(x, 0)));
}

/** @return x, with the integer of the first lane in all lanes but those. */
INLINE integer integer_repeat_first(integer x, mask lanes) {
    return integer_select(lanes, x, integer_of(integer_lane(x, 0)));
}

/** Makes all lanes but those a copy of the first ray, which is safe to compute with. */
INLINE void ray_vector_repeat_first(RayVector *rays, mask lanes) {
    for (int group = 0; group < RAY_COLUMN_GROUP_COUNT; group++) {
        for (int i = 0; i < 3; i++) {
            rays->numbers[group][i] = real_repeat_first(rays->numbers[group][i], lanes);
        }
    }
    rays->turns = integer_repeat_first(rays->turns, lanes);
    rays->link = integer_repeat_first(rays->link, lanes);
    rays->sample = integer_repeat_first(rays->sample, lanes);
    for (int i = 0; i < INTERIOR_LIST_CAPACITY; i++) {
        rays->interior.shapes[i] = integer_repeat_first(rays->interior.shapes[i], lanes);
    }
}

#endif
