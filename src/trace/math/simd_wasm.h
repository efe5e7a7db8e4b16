/**
 * @file
 * @brief Instructions of WebAssembly, whose vectors have 128 bits; compare simd_x86.h.
 *
 * A vector of more lanes is several of those, and each macro a loop over them. Clang would take the
 * numbers of such a vector one by one.
 */
#ifndef DIOPTRE_TRACE_MATH_SIMD_WASM_H
#define DIOPTRE_TRACE_MATH_SIMD_WASM_H

#include <wasm_simd128.h>

/** Number of 128-bit vectors in a #real. */
#define WASM_PARTS ((int)(sizeof(real) / sizeof(v128_t)))
/** Lanes of one of them. */
#define WASM_PART_LANES (LANES / WASM_PARTS)

/** LANES numbers by parts. */
typedef union RealParts {
    real numbers;             /**< As numbers. */
    mask truths;              /**< As truth values. */
    v128_t parts[WASM_PARTS]; /**< As the processor has them. */
} RealParts;

/** LANES numbers of the next wider type by parts. */
typedef union WideParts {
    wide_scalar numbers
        __attribute__((vector_size(LANES * sizeof(wide_scalar))));        /**< As numbers. */
    int64_t truths __attribute__((vector_size(LANES * sizeof(int64_t)))); /**< As truth values. */
    v128_t parts[LANES * sizeof(wide_scalar) / sizeof(v128_t)]; /**< As the processor has them. */
} WideParts;

/** A function that is always inlined. */
#define WASM_INLINE static inline __attribute__((always_inline))

#if REAL_BITS == 32
/** Bit i set where lane i of a part is negative. */
#define WASM_BITMASK wasm_i32x4_bitmask
/** `y < x ? y : x` of two parts x, y. */
#define WASM_PMIN wasm_f32x4_pmin
/** `x < y ? y : x` of two parts x, y. */
#define WASM_PMAX wasm_f32x4_pmax
/** The square roots of a part. */
#define WASM_SQRT wasm_f32x4_sqrt
#else
#define WASM_BITMASK wasm_i64x2_bitmask
#define WASM_PMIN wasm_f64x2_pmin
#define WASM_PMAX wasm_f64x2_pmax
#define WASM_SQRT wasm_f64x2_sqrt
#endif

/** @return Bit i set where lane i of the mask is. */
WASM_INLINE unsigned wasm_bits(mask m) {
    RealParts x = {.truths = m};
    unsigned bits = 0;
    for (int i = 0; i < WASM_PARTS; i++) {
        bits |= (unsigned)WASM_BITMASK(x.parts[i]) << (i * WASM_PART_LANES);
    }
    return bits;
}

/** @return a where the mask is set, b elsewhere. */
WASM_INLINE real wasm_select(mask m, real a, real b) {
    RealParts chosen = {.truths = m}, x = {.numbers = a}, y = {.numbers = b};
    for (int i = 0; i < WASM_PARTS; i++) {
        chosen.parts[i] = wasm_v128_bitselect(x.parts[i], y.parts[i], chosen.parts[i]);
    }
    return chosen.numbers;
}

/** @return The minimum; b if either is NaN: `a < b ? a : b`. */
WASM_INLINE real wasm_min(real a, real b) {
    RealParts x = {.numbers = a}, y = {.numbers = b};
    for (int i = 0; i < WASM_PARTS; i++) {
        x.parts[i] = WASM_PMIN(y.parts[i], x.parts[i]);
    }
    return x.numbers;
}

/** @return The maximum; b if either is NaN: `a > b ? a : b`. */
WASM_INLINE real wasm_max(real a, real b) {
    RealParts x = {.numbers = a}, y = {.numbers = b};
    for (int i = 0; i < WASM_PARTS; i++) {
        x.parts[i] = WASM_PMAX(y.parts[i], x.parts[i]);
    }
    return x.numbers;
}

/** @return The square roots. */
WASM_INLINE real wasm_sqrt(real x) {
    RealParts roots = {.numbers = x};
    for (int i = 0; i < WASM_PARTS; i++) {
        roots.parts[i] = WASM_SQRT(roots.parts[i]);
    }
    return roots.numbers;
}

/** @return Whether any lane of the mask is set. */
WASM_INLINE bool wasm_any(mask m) {
    RealParts x = {.truths = m};
    v128_t united = x.parts[0];
    for (int i = 1; i < WASM_PARTS; i++) {
        united = wasm_v128_or(united, x.parts[i]);
    }
    return WASM_BITMASK(united) != 0;
}

#if REAL_BITS == 32
/** The bytes of a lane of 32 bits. */
#define WASM_LANE(LANE) 0x01010101u * 4 * (LANE) + 0x03020100u
/** For each set of lanes of a part, the bytes of those lanes first. */
static const uint32_t WASM_LANES_FIRST[16][4] = {
    {WASM_LANE(0)},
    {WASM_LANE(0)},
    {WASM_LANE(1)},
    {WASM_LANE(0), WASM_LANE(1)},
    {WASM_LANE(2)},
    {WASM_LANE(0), WASM_LANE(2)},
    {WASM_LANE(1), WASM_LANE(2)},
    {WASM_LANE(0), WASM_LANE(1), WASM_LANE(2)},
    {WASM_LANE(3)},
    {WASM_LANE(0), WASM_LANE(3)},
    {WASM_LANE(1), WASM_LANE(3)},
    {WASM_LANE(0), WASM_LANE(1), WASM_LANE(3)},
    {WASM_LANE(2), WASM_LANE(3)},
    {WASM_LANE(0), WASM_LANE(2), WASM_LANE(3)},
    {WASM_LANE(1), WASM_LANE(2), WASM_LANE(3)},
    {WASM_LANE(0), WASM_LANE(1), WASM_LANE(2), WASM_LANE(3)},
};
#else
/** The bytes of a lane of 64 bits. */
#define WASM_LANE(LANE) 0x0101010101010101u * 8 * (LANE) + 0x0706050403020100u
/** For each set of lanes of a part, the bytes of those lanes first. */
static const uint64_t WASM_LANES_FIRST[4][2] = {
    {WASM_LANE(0)}, {WASM_LANE(0)}, {WASM_LANE(1)}, {WASM_LANE(0), WASM_LANE(1)}};
#endif

/** Stores the lanes of x whose bits are set, one after another, part by part, and writes over what
 *  follows. */
WASM_INLINE void wasm_compress(void *to, real x, unsigned bits) {
    RealParts from = {.numbers = x};
    for (int i = 0; i < WASM_PARTS; i++) {
        unsigned set = bits >> (i * WASM_PART_LANES) & ((1u << WASM_PART_LANES) - 1);
        wasm_v128_store(to,
                        wasm_i8x16_swizzle(from.parts[i], wasm_v128_load(WASM_LANES_FIRST[set])));
        to = (scalar *)to + __builtin_popcount(set);
    }
}

/** Bit i set where lane i of the mask m is. */
#define LANES_BITS(m) wasm_bits(m)
/** Whether any lane of the mask m is set. */
#define LANES_ANY(m) wasm_any(m)
/** Stores the lanes of x whose bits are set, one after another, and writes over what follows. */
#define LANES_COMPRESS(to, x, bits) wasm_compress(to, (real)(x), bits)
/** a where the mask m is set, b elsewhere. */
#define LANES_SELECT(m, a, b) wasm_select(m, a, b)
/** The minimum; b if either is NaN. */
#define LANES_MIN(a, b) wasm_min(a, b)
/** The maximum; b if either is NaN. */
#define LANES_MAX(a, b) wasm_max(a, b)
/** The square roots of x. */
#define LANES_SQRT(x) wasm_sqrt(x)

#if REAL_BITS == 32
/** @return The numbers in double. */
WASM_INLINE WideParts wasm_widen(real x) {
    RealParts narrow = {.numbers = x};
    WideParts result;
    for (int i = 0; i < WASM_PARTS; i++) {
        v128_t part = narrow.parts[i];
        result.parts[2 * i] = wasm_f64x2_promote_low_f32x4(part);
        result.parts[2 * i + 1] =
            wasm_f64x2_promote_low_f32x4(wasm_i32x4_shuffle(part, part, 2, 3, 2, 3));
    }
    return result;
}

/** @return The nearest floats. */
WASM_INLINE real wasm_narrow(WideParts x) {
    RealParts result;
    for (int i = 0; i < WASM_PARTS; i++) {
        v128_t low = wasm_f32x4_demote_f64x2_zero(x.parts[2 * i]);
        v128_t high = wasm_f32x4_demote_f64x2_zero(x.parts[2 * i + 1]);
        result.parts[i] = wasm_i32x4_shuffle(low, high, 0, 1, 4, 5);
    }
    return result.numbers;
}

/** @return The mask for floats: the lower half of each truth value. */
WASM_INLINE mask wasm_narrow_mask(WideParts m) {
    RealParts result;
    for (int i = 0; i < WASM_PARTS; i++) {
        result.parts[i] = wasm_i32x4_shuffle(m.parts[2 * i], m.parts[2 * i + 1], 0, 2, 4, 6);
    }
    return result.truths;
}

/** @return The square roots. */
WASM_INLINE WideParts wasm_wide_sqrt(WideParts x) {
    for (int i = 0; i < 2 * WASM_PARTS; i++) {
        x.parts[i] = wasm_f64x2_sqrt(x.parts[i]);
    }
    return x;
}

/** The floats x in double. */
#define LANES_WIDEN(x) wasm_widen(x).numbers
/** The nearest floats of the doubles x. */
#define LANES_NARROW(x) wasm_narrow((WideParts){.numbers = (x)})
/** The mask m of doubles for floats. */
#define LANES_NARROW_MASK(m) wasm_narrow_mask((WideParts){.truths = (m)})
/** The square roots of the doubles x. */
#define LANES_WIDE_SQRT(x) wasm_wide_sqrt((WideParts){.numbers = (x)}).numbers
#endif

#endif
