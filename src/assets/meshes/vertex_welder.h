/**
 * @file
 * @brief A set of points with indices: equal points have the same index.
 */
#ifndef DIOPTRE_ASSETS_MESHES_VERTEX_WELDER_H
#define DIOPTRE_ASSETS_MESHES_VERTEX_WELDER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Largest number of coordinates per point. */
enum { VERTEX_WELDER_DIMENSION_MAXIMUM = 3 };
/** No index. */
#define VERTEX_WELDER_NONE UINT32_MAX

/** A set of points of one to three coordinates. Initialised to `{.dimension = ...}`. */
typedef struct VertexWelder {
    size_t dimension;  /**< Number of coordinates per point. */
    size_t count;      /**< Number of points. */
    size_t capacity;   /**< Capacity of #points, in points. */
    double *points;    /**< The points, in the order of insertion; owned. */
    size_t slot_count; /**< Number of slots of the hash table: a power of two, at least twice
                          #capacity. */
    uint32_t *slots;   /**< The hash table: indices, or #VERTEX_WELDER_NONE; owned. */
} VertexWelder;

/**
 * Adds a point, unless the set has it; 0 and -0 are equal.
 * @param welder      The set.
 * @param point       Its coordinates.
 * @param[out] index  Index of the point.
 * @return false without memory.
 */
bool vertex_welder_add(VertexWelder *welder, const double *point, uint32_t *index);

/** Releases the memory of a set. @param welder The set. */
void vertex_welder_deinit(VertexWelder *welder);

#endif
