/**
 * @file
 * @brief Points that fill a square evenly, however many of them are taken: where in a pixel its
 * rays go, and to which points of a lamp.
 *
 * Sobol's sequence in two dimensions: of the first 2^k points, one lies in each of the 2^k
 * rectangles of any shape a x b with a b = 2^-k. Owen's scrambling moves the points and keeps this;
 * it makes the mean of n samples converge faster and hides the grid that the points would lie on
 * (Sobol, *On the Distribution of Points in a Cube and the Approximate Evaluation of Integrals*,
 * 1967; Burley, *Practical Hash-Based Owen Scrambling*, 2020). All of it is integers: the same on
 * every machine, whatever the number type and the lanes.
 */
#ifndef DIOPTRE_TRACE_MATH_SOBOL_H
#define DIOPTRE_TRACE_MATH_SOBOL_H

#include <stdint.h>

/** A point of the unit square, in shares of 2^32. */
typedef struct SobolPoint {
    uint32_t x; /**< From the left. */
    uint32_t y; /**< From the bottom. */
} SobolPoint;

/** @return A number whose bits all depend on all bits of another; different ones for different ones
 *  (Wellons, *Prospecting for Hash Functions*, 2018). */
static inline uint32_t hash_u32(uint32_t x) {
    x = (x ^ x >> 16) * 0x21F0AAADu;
    x = (x ^ x >> 15) * 0xD35A2D97u;
    return x ^ x >> 15;
}

/** @return One number that depends on both. */
static inline uint32_t hash_combine_u32(uint32_t a, uint32_t b) {
    return hash_u32(a ^ hash_u32(b + 0x9E3779B9u));
}

/** @return The bits in the opposite order. */
static inline uint32_t reverse_bits_u32(uint32_t x) {
    x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
    x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
    x = (x >> 4 & 0x0F0F0F0Fu) | (x & 0x0F0F0F0Fu) << 4;
    x = (x >> 8 & 0x00FF00FFu) | (x & 0x00FF00FFu) << 8;
    return x >> 16 | x << 16;
}

/** @return Owen's scrambling of a number: each bit is flipped or not, depending on those above it.
 */
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

/**
 * @return A point of the sequence.
 * @param seed  Which scrambling of the sequence.
 */
static inline SobolPoint sobol_point(uint32_t index, uint32_t seed) {
    // Scrambling the index takes the points in another order: any first 2^k stay a whole net.
    uint32_t scrambled_index = owen_scramble(index, seed);
    return (SobolPoint){
        owen_scramble(reverse_bits_u32(scrambled_index), hash_u32(seed + 1)),
        owen_scramble(sobol_second_dimension(scrambled_index), hash_u32(seed + 2)),
    };
}

#endif
