/**
 * @file
 * @brief Hash functions.
 */
#ifndef DIOPTRE_TRACE_MATH_HASH_H
#define DIOPTRE_TRACE_MATH_HASH_H

#include <stdint.h>

/** @return A bijective hash (Wellons, *Prospecting for Hash Functions*, 2018). */
static inline uint32_t hash_u32(uint32_t x) {
    x = (x ^ x >> 16) * 0x21F0AAADu;
    x = (x ^ x >> 15) * 0xD35A2D97u;
    return x ^ x >> 15;
}

/** @return A hash of two numbers. */
static inline uint32_t hash_combine_u32(uint32_t a, uint32_t b) {
    return hash_u32(a ^ hash_u32(b + 0x9E3779B9u));
}

/** @return A hash of a hash and one more number (Steele, Lea, Flood, *Fast Splittable Pseudorandom
 *          Number Generators*, 2014: splitmix64, with one round less). */
static inline uint64_t hash_combine_u64(uint64_t hash, uint64_t number) {
    uint64_t z = (hash + number + 1) * 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    return z ^ (z >> 31);
}

#endif
