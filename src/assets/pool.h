/**
 * @file
 * @brief A set of points: each has a place, and no two are the same.
 */
#ifndef ASSETS_POOL_H
#define ASSETS_POOL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Most coordinates that a point of a pool has. */
enum { POOL_WIDTH_MAXIMUM = 3 };
/** No place. */
#define POOL_NOWHERE UINT32_MAX

/** A set of points of one to three coordinates. Starts as `{.width = ...}`. */
typedef struct Pool {
    size_t width;      /**< Coordinates of a point. */
    size_t count;      /**< How many points. */
    size_t capacity;   /**< How many fit. */
    double *points;    /**< The points, in the order that they came in. */
    size_t slot_count; /**< Slots of the hash table: a power of two, at least twice #capacity. */
    uint32_t *slots;   /**< The hash table: a place, or #POOL_NOWHERE. */
} Pool;

/**
 * Adds a point, unless it is there already; 0 and -0 are the same.
 * @param pool        The pool.
 * @param point       Its coordinates; finite.
 * @param[out] place  Its place.
 * @return false without memory.
 */
bool pool_add(Pool *pool, const double *point, uint32_t *place);

/** Gives a pool's memory back. @param pool The pool. */
void pool_release(Pool *pool);

#endif
