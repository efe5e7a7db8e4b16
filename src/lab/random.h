/**
 * @file
 * @brief Pseudo-random numbers, the same in every run and on every machine (Steele, Lea, Flood,
 *        *Fast Splittable Pseudorandom Number Generators*, OOPSLA 2014).
 */
#ifndef DIOPTRE_LAB_RANDOM_H
#define DIOPTRE_LAB_RANDOM_H

#include "lab/vec3q.h"

#include <stdint.h>

/** State of a sequence. */
typedef struct Random {
    uint64_t state; /**< Initialized with any seed. */
} Random;

/** @return 64 random bits. */
uint64_t random_bits(Random *random);

/** @return A number, uniform in 0 to 1. */
double random_unit(Random *random);

/** @return A number, uniform in a range. */
double random_range(Random *random, double low, double high);

/** @return A direction, uniform on the sphere, of length 1. */
Vec3q random_direction(Random *random);

/**
 * @return A vector perpendicular to a direction, uniform in a disc.
 * @param axis  The direction, of length 1.
 */
Vec3q random_in_disc(Random *random, Vec3q axis, double radius);

#endif
