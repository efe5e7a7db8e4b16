/**
 * @file
 * @brief A set of points: each has a place, and no two are the same.
 */
#ifndef DIOPTRE_ASSETS_MESHES_VERTEX_WELDER_H
#define DIOPTRE_ASSETS_MESHES_VERTEX_WELDER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Most coordinates that a point of a pool has. */
enum { VERTEX_WELDER_DIMENSION_MAXIMUM = 3 };
/** No place. */
#define VERTEX_WELDER_NONE UINT32_MAX

/** A set of points of one to three coordinates. Starts as `{.width = ...}`. */
typedef struct VertexWelder {
    size_t dimension;  /**< Coordinates of a point. */
    size_t count;      /**< How many points. */
    size_t capacity;   /**< How many fit. */
    double *points;    /**< The points, in the order that they came in. */
    size_t slot_count; /**< Slots of the hash table: a power of two, at least twice #capacity. */
    uint32_t *slots;   /**< The hash table: a place, or #VERTEX_WELDER_NONE. */
} VertexWelder;

/** Adds a point, unless it is there already; 0 and -0 are the same. @return false without memory.
 */
bool vertex_welder_add(VertexWelder *welder, const double *point, uint32_t *index);

/** Gives a pool's memory back. */
void vertex_welder_deinit(VertexWelder *welder);

#endif
