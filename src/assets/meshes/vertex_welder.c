/**
 * @file
 * @brief A set of points with indices.
 */
#include "assets/meshes/vertex_welder.h"

#include <stdlib.h>
#include <string.h>

/** First capacity. */
enum { FIRST_CAPACITY = 1024 };

/**
 * @return The hash of a point, by the last steps of splitmix64 for each coordinate.
 * @param point      Its coordinates, without -0.
 * @param dimension  Number of coordinates.
 */
static uint64_t hash_point(const double *point, size_t dimension) {
    uint64_t mixed = 0;
    for (size_t i = 0; i < dimension; i++) {
        uint64_t bits;
        memcpy(&bits, &point[i], sizeof bits);
        mixed = (mixed + bits) * 0x9E3779B97F4A7C15u;
        mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9u;
        mixed ^= mixed >> 31;
    }
    return mixed;
}

/**
 * Finds the slot of a point, or the empty slot for it.
 * @param welder  The set, with an empty slot.
 * @param point   The point.
 * @return The slot.
 */
static uint32_t *find_slot(const VertexWelder *welder, const double *point) {
    size_t mask = welder->slot_count - 1, size = welder->dimension * sizeof *point;
    size_t i = (size_t)hash_point(point, welder->dimension) & mask;
    while (welder->slots[i] != VERTEX_WELDER_NONE &&
           memcmp(welder->points + welder->slots[i] * welder->dimension, point, size) != 0) {
        i = (i + 1) & mask;
    }
    return &welder->slots[i];
}

/** Inserts all points into a new hash table. @param welder The set, its slots empty. */
static void rehash(VertexWelder *welder) {
    for (size_t index = 0; index < welder->count; index++) {
        *find_slot(welder, welder->points + index * welder->dimension) = (uint32_t)index;
    }
}

/** Doubles the capacity. @return false without memory, or if indices are exhausted. */
static bool grow(VertexWelder *welder) {
    size_t capacity = welder->capacity ? 2 * welder->capacity : FIRST_CAPACITY;
    if (capacity > VERTEX_WELDER_NONE / 2) {
        return false;
    }
    double *points = realloc(welder->points, capacity * welder->dimension * sizeof *points);
    if (!points) {
        return false;
    }
    welder->points = points;
    uint32_t *slots = malloc(2 * capacity * sizeof *slots);
    if (!slots) {
        return false;
    }
    free(welder->slots);
    welder->slots = slots;
    welder->slot_count = 2 * capacity;
    welder->capacity = capacity;
    memset(slots, 0xFF, welder->slot_count * sizeof *slots);
    rehash(welder);
    return true;
}

bool vertex_welder_add(VertexWelder *welder, const double *point, uint32_t *index) {
    double canonical[VERTEX_WELDER_DIMENSION_MAXIMUM];
    if (welder->count == welder->capacity && !grow(welder)) {
        return false;
    }
    for (size_t i = 0; i < welder->dimension; i++) {
        // -0 becomes 0. The sum -0 + 0 would do so, but not when the processor rounds downwards.
        canonical[i] = point[i] == 0 ? 0 : point[i];
    }
    uint32_t *slot = find_slot(welder, canonical);
    if (*slot == VERTEX_WELDER_NONE) {
        *slot = (uint32_t)welder->count++;
        memcpy(welder->points + *slot * welder->dimension, canonical,
               welder->dimension * sizeof *canonical);
    }
    *index = *slot;
    return true;
}

void vertex_welder_deinit(VertexWelder *welder) {
    free(welder->points);
    free(welder->slots);
    *welder = (VertexWelder){.dimension = welder->dimension};
}
