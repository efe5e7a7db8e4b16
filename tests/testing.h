/**
 * @file
 * @brief What the tests share: assertions that say what was measured, random numbers, ulps.
 */
#ifndef DIOPTRE_TESTING_H
#define DIOPTRE_TESTING_H

#include "dioptre/engine.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

/** Fails unless a measured value is at most a bound, and says both. NaN fails. */
#define assert_at_most(value, bound, ...)                                                          \
    do {                                                                                           \
        double measured_ = (double)(value), bound_ = (double)(bound);                              \
        if (!(measured_ <= bound_)) {                                                              \
            char what_[256];                                                                       \
            snprintf(what_, sizeof what_, __VA_ARGS__);                                            \
            fail_msg("%s: %g, at most %g allowed", what_, measured_, bound_);                      \
        }                                                                                          \
    } while (0)

/** @return A number, uniform in 0 to 1. @param[in,out] state A generator (splitmix64). */
static inline double random_share(uint64_t *state) {
    uint64_t z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/** @return A number, uniform in a range and exact in float. @param[in,out] state A generator.
 *  @param low Lowest. @param high Highest. */
static inline double random_float(uint64_t *state, double low, double high) {
    return (double)(float)(low + (high - low) * random_share(state));
}

/** @return A quad's square root by Newton's method: independent of any library's. @param x At least
 *  0. */
static inline Quadruple quad_sqrt(Quadruple x) {
    Quadruple root = (Quadruple)sqrt((double)x);
    for (int i = 0; i < 4 && root > 0; i++) {
        root = (root + x / root) / 2;
    }
    return root;
}

/** @return The absolute value. @param x Any number. */
static inline Quadruple quad_abs(Quadruple x) {
    return x < 0 ? -x : x;
}

/** @return Half an ulp of 1 of an engine's number type. @param engine The engine. */
static inline Quadruple roundoff(const Engine *engine) {
    Quadruple u = 1;
    for (int i = 0; i < engine->mantissa_bits; i++) {
        u /= 2;
    }
    return u;
}

#endif
