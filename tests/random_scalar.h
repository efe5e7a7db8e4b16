/**
 * @file
 * @brief Random numbers in the number type of an engine, for tests that are compiled once per
 * engine.
 */
#ifndef DIOPTRE_TESTS_RANDOM_SCALAR_H
#define DIOPTRE_TESTS_RANDOM_SCALAR_H

#include "trace/math/real.h"

/** @return A random number, 0 to 1 (Knuth's linear congruential generator). */
static inline scalar random_scalar(uint64_t *state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (scalar)(*state >> 40) / (scalar)0x1000000;
}

#endif
