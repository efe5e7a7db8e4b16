/**
 * @file
 * @brief The balls of cells.h, for whoever knows no `real`: how large each is.
 */
#ifndef DIOPTRE_LAB_METHODS_SPHERE_GRID_H
#define DIOPTRE_LAB_METHODS_SPHERE_GRID_H

#include <stdint.h>

/** How far a ray is followed among them, edges of a cell. */
enum { SPHERE_GRID_REACH = 5 };
/** Radius of a ball that is neither large nor small, edges of a cell. */
#define SPHERE_GRID_MEAN_RADIUS 0.3125

/** @return What the ball of a cell is larger, -1 to 1, in steps that every number type can hold. */
static inline double sphere_grid_hash(int x, int y, int z) {
    uint32_t h = (uint32_t)x * 73856093u ^ (uint32_t)y * 19349663u ^ (uint32_t)z * 83492791u;
    h = (h ^ h >> 16) * 0x21F0AAADu;
    h = (h ^ h >> 15) * 0xD35A2D97u;
    return (double)(h >> 24) / 128 - 1;
}

/**
 * @return The radius of the ball of a cell.
 * @param spread  How much radii differ.
 */
static inline double sphere_grid_radius(int x, int y, int z, double spread) {
    return SPHERE_GRID_MEAN_RADIUS + spread * sphere_grid_hash(x, y, z);
}

#endif
