/**
 * @file
 * @brief Radii of the spheres of domain_repetition.c, without `real`: its experiment needs them
 * too.
 */
#ifndef DIOPTRE_LAB_METHODS_SPHERE_GRID_H
#define DIOPTRE_LAB_METHODS_SPHERE_GRID_H

#include <stdint.h>

/** Largest distance along a ray, in cells. */
enum { SPHERE_GRID_REACH = 5 };
/** Mean radius, in cells. */
#define SPHERE_GRID_MEAN_RADIUS 0.3125

/** @return A hash of a cell, -1 to 1, in steps of 1/128, which every number type represents. */
static inline double sphere_grid_hash(int x, int y, int z) {
    uint32_t h = (uint32_t)x * 73856093u ^ (uint32_t)y * 19349663u ^ (uint32_t)z * 83492791u;
    h = (h ^ h >> 16) * 0x21F0AAADu;
    h = (h ^ h >> 15) * 0xD35A2D97u;
    return (double)(h >> 24) / 128 - 1;
}

/** @return The radius of a cell's sphere. @param spread Largest difference from the mean. */
static inline double sphere_grid_radius(int x, int y, int z, double spread) {
    return SPHERE_GRID_MEAN_RADIUS + spread * sphere_grid_hash(x, y, z);
}

#endif
