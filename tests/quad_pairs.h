/**
 * @file
 * @brief Judges products and quotients of quad numbers by exact arithmetic of whole numbers.
 *
 * The reference of all errors is in quad, and its operations come from a library: libgcc on the
 * desktop, src/web/libc/quad.c in a page. LLVM's compiler-rt, as of versions 14 and 19, fails here.
 */
#ifndef DIOPTRE_TESTS_QUAD_PAIRS_H
#define DIOPTRE_TESTS_QUAD_PAIRS_H

#include "dioptre/engine.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/** A whole number of 128 bits. */
__extension__ typedef unsigned __int128 Bits128;

/** A whole number of 256 bits. */
typedef struct Bits256 {
    Bits128 high; /**< The upper half. */
    Bits128 low;  /**< The lower half. */
} Bits256;

/** Bits of a significand below its leading 1. */
enum { QUAD_FRACTION_BITS = 112 };
/** Exponent of 1 as it is stored. */
enum { QUAD_BIAS = 16383 };
/** The leading 1 of a significand. */
#define QUAD_LEADING ((Bits128)1 << QUAD_FRACTION_BITS)

/** @return The next number of a generator (xorshift). @param[in,out] state Not 0. */
static inline uint64_t next_random(uint64_t *state) {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state;
}

/**
 * @return A significand in which carries run far: near 1, near 2, runs of zeros or ones.
 * @param[in,out] state  The generator.
 */
static inline Bits128 next_significand(uint64_t *state) {
    enum { KINDS = 6 };
    Bits128 any = (Bits128)next_random(state) << 64 | next_random(state);
    Bits128 few = any >> (next_random(state) % 120 + 8), mask = QUAD_LEADING - 1;
    switch (next_random(state) % KINDS) {
    case 0:
        return QUAD_LEADING | (few & mask);
    case 1:
        return QUAD_LEADING | (mask - (few & mask));
    case 2:
        return QUAD_LEADING | (few << next_random(state) % 64 & mask);
    case 3:
        return QUAD_LEADING | ((Bits128)1 << next_random(state) % QUAD_FRACTION_BITS);
    case 4:
        return QUAD_LEADING | (mask ^ ((Bits128)1 << next_random(state) % QUAD_FRACTION_BITS));
    default:
        return QUAD_LEADING | (any & mask);
    }
}

/** @return The number of a significand, 1 to 2. */
static inline Quadruple quad_of(Bits128 significand) {
    Bits128 bits = (Bits128)QUAD_BIAS << QUAD_FRACTION_BITS | (significand & (QUAD_LEADING - 1));
    Quadruple x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/** @return The significand of a number. @param[out] exponent Its exponent; 0 for 1 to 2. */
static inline Bits128 quad_split(Quadruple x, int *exponent) {
    Bits128 bits;
    memcpy(&bits, &x, sizeof bits);
    *exponent = (int)(bits >> QUAD_FRACTION_BITS) - QUAD_BIAS;
    return (bits & (QUAD_LEADING - 1)) | QUAD_LEADING;
}

/** @return The exact product. */
static inline Bits256 multiply_exactly(Bits128 a, Bits128 b) {
    Bits128 a1 = a >> 64, a0 = (uint64_t)a, b1 = b >> 64, b0 = (uint64_t)b;
    Bits128 low = a0 * b0, high = a1 * b1, cross = a1 * b0, other = a0 * b1;
    Bits128 middle = (low >> 64) + (uint64_t)cross + (uint64_t)other;
    return (Bits256){high + (cross >> 64) + (other >> 64) + (middle >> 64),
                     middle << 64 | (uint64_t)low};
}

/** @return A number, shifted to the left by 1 to 127 bits. */
static inline Bits256 shift_left(Bits128 x, int count) {
    return (Bits256){x >> (128 - count), x << count};
}

/** @return |a - b|. */
static inline Bits256 distance_between(Bits256 a, Bits256 b) {
    bool is_less = a.high < b.high || (a.high == b.high && a.low < b.low);
    Bits256 x = is_less ? b : a, y = is_less ? a : b;
    return (Bits256){x.high - y.high - (x.low < y.low), x.low - y.low};
}

/** @return Whether x * y is rounded to the nearest, halves to even. */
static inline bool product_is_right(Bits128 a, Bits128 b) {
    int exponent;
    Bits128 rounded = quad_split(quad_of(a) * quad_of(b), &exponent);
    int shift = QUAD_FRACTION_BITS + exponent;
    if (exponent < 0 || exponent > 1) {
        return false; // 4 is not reached: (2 - ulp)^2 rounds to below it.
    }
    Bits256 error = distance_between(multiply_exactly(a, b), shift_left(rounded, shift));
    Bits128 half = (Bits128)1 << (shift - 1);
    return error.high == 0 && (error.low < half || (error.low == half && rounded % 2 == 0));
}

/** @return Whether x / y is rounded to the nearest; a quotient is never half way. */
static inline bool quotient_is_right(Bits128 a, Bits128 b) {
    int exponent;
    Bits128 rounded = quad_split(quad_of(a) / quad_of(b), &exponent);
    if (exponent < -1 || exponent > 0) {
        return false;
    }
    Bits256 error = distance_between(shift_left(a, QUAD_FRACTION_BITS - exponent),
                                     multiply_exactly(rounded, b));
    return error.high == 0 && error.low <= b / 2;
}

/** @return How many of some pairs are multiplied or divided wrongly. @param count Number of pairs.
 */
static inline int count_wrong_pairs(int count) {
    uint64_t state = 0x9E3779B97F4A7C15;
    int wrong = 0;
    for (int i = 0; i < count; i++) {
        Bits128 a = next_significand(&state), b = next_significand(&state);
        wrong += !product_is_right(a, b) || !quotient_is_right(a, b);
    }
    return wrong;
}

#endif
