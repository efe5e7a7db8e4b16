/**
 * @file
 * @brief Sobol's sequence: sample points in the unit square, for pixels and for spherical lights.
 *
 * Of its first 2^k points, one lies in each of the 2^k rectangles of any shape a x b with a b =
 * 2^-k (Sobol, *On the Distribution of Points in a Cube and the Approximate Evaluation of
 * Integrals*, 1967). Owen's scrambling keeps this property; the mean of n samples converges faster,
 * and the points do not lie on a grid (Burley, *Practical Hash-Based Owen Scrambling*, 2020). Only
 * integers are used: the points are the same on every machine and in every engine.
 */
#ifndef DIOPTRE_TRACE_MATH_SOBOL_H
#define DIOPTRE_TRACE_MATH_SOBOL_H

#include "trace/math/hash.h"

/** A point of the unit square, in units of 2^-32. */
typedef struct SobolPoint {
    uint32_t x; /**< From the left. */
    uint32_t y; /**< From the bottom. */
} SobolPoint;

/** @return The bits in reverse order. */
static inline uint32_t reverse_bits_u32(uint32_t x) {
    x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
    x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
    x = (x >> 4 & 0x0F0F0F0Fu) | (x & 0x0F0F0F0Fu) << 4;
    x = (x >> 8 & 0x00FF00FFu) | (x & 0x00FF00FFu) << 8;
    return x >> 16 | x << 16;
}

/** @return Owen's scrambling: each bit is flipped or not, depending on the bits above it. */
static inline uint32_t owen_scramble(uint32_t x, uint32_t seed) {
    x = reverse_bits_u32(x);
    x ^= x * 0x3D20ADEAu;
    x += seed;
    x *= seed >> 16 | 1;
    x ^= x * 0x05526C56u;
    x ^= x * 0x53A22864u;
    return reverse_bits_u32(x);
}

/** @return The second coordinate of Sobol's sequence. */
static inline uint32_t sobol_second_dimension(uint32_t index) {
    uint32_t y = 0;
    for (uint32_t direction = 0x80000000u; index; index >>= 1, direction ^= direction >> 1) {
        y ^= index & 1 ? direction : 0;
    }
    return y;
}

/** @return A point of the sequence. @param seed Selects the scrambling. */
static inline SobolPoint sobol_point(uint32_t index, uint32_t seed) {
    // A scrambled index permutes the points so that the first 2^k are still evenly distributed.
    uint32_t scrambled_index = owen_scramble(index, seed);
    return (SobolPoint){
        owen_scramble(reverse_bits_u32(scrambled_index), hash_u32(seed + 1)),
        owen_scramble(sobol_second_dimension(scrambled_index), hash_u32(seed + 2)),
    };
}

#endif
