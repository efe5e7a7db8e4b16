/**
 * @file
 * @brief A set of points.
 */
#include "assets/pool.h"

#include <stdlib.h>
#include <string.h>

/** Points that fit at first. */
enum { FIRST_CAPACITY = 1024 };

/**
 * @return A point's hash: its bits, each well mixed into all others (by splitmix64's last steps).
 * @param point  Its coordinates, without -0.
 * @param width  How many.
 */
static uint64_t hash(const double *point, size_t width) {
    uint64_t mixed = 0;
    for (size_t i = 0; i < width; i++) {
        uint64_t bits;
        memcpy(&bits, &point[i], sizeof bits);
        mixed = (mixed + bits) * 0x9E3779B97F4A7C15u;
        mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9u;
        mixed ^= mixed >> 31;
    }
    return mixed;
}

/**
 * Finds the slot of a point, or the empty one where it belongs.
 * @param pool   The pool, with an empty slot.
 * @param point  The point.
 * @return The slot.
 */
static uint32_t *find_slot(const Pool *pool, const double *point) {
    size_t mask = pool->slot_count - 1, size = pool->width * sizeof *point;
    size_t i = (size_t)hash(point, pool->width) & mask;
    while (pool->slots[i] != POOL_NOWHERE &&
           memcmp(pool->points + pool->slots[i] * pool->width, point, size) != 0) {
        i = (i + 1) & mask;
    }
    return &pool->slots[i];
}

/** Enters all points in a new table. @param pool The pool, its slots empty. */
static void enter_all(Pool *pool) {
    for (size_t place = 0; place < pool->count; place++) {
        *find_slot(pool, pool->points + place * pool->width) = (uint32_t)place;
    }
}

/**
 * Makes room for twice as many points.
 * @param pool  The pool.
 * @return false without memory, or at the largest number of places.
 */
static bool grow(Pool *pool) {
    size_t capacity = pool->capacity ? 2 * pool->capacity : FIRST_CAPACITY;
    if (capacity > POOL_NOWHERE / 2) {
        return false;
    }
    double *points = realloc(pool->points, capacity * pool->width * sizeof *points);
    if (!points) {
        return false;
    }
    pool->points = points;
    uint32_t *slots = malloc(2 * capacity * sizeof *slots);
    if (!slots) {
        return false;
    }
    free(pool->slots);
    pool->slots = slots;
    pool->slot_count = 2 * capacity;
    pool->capacity = capacity;
    memset(slots, 0xFF, pool->slot_count * sizeof *slots);
    enter_all(pool);
    return true;
}

bool pool_add(Pool *pool, const double *point, uint32_t *place) {
    double clean[POOL_WIDTH_MAXIMUM];
    if (pool->count == pool->capacity && !grow(pool)) {
        return false;
    }
    for (size_t i = 0; i < pool->width; i++) {
        clean[i] = point[i] + 0.0; // -0 becomes 0.
    }
    uint32_t *slot = find_slot(pool, clean);
    if (*slot == POOL_NOWHERE) {
        *slot = (uint32_t)pool->count++;
        memcpy(pool->points + *slot * pool->width, clean, pool->width * sizeof *clean);
    }
    *place = *slot;
    return true;
}

void pool_release(Pool *pool) {
    free(pool->points);
    free(pool->slots);
    *pool = (Pool){.width = pool->width};
}
