/**
 * @file
 * @brief Product and quotient of quad numbers, correctly rounded.
 *
 * They stand in for those of LLVM's compiler-rt, whose product of two 128-bit significands loses a
 * carry: 1 / x with x just under 1 was 2 (LLVM 14 and 19). tests/test_quad.c judges both.
 */
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/** A whole number of 128 bits. */
typedef unsigned __int128 Bits;

/** Bits of the significand below its leading 1. */
enum { FRACTION_BITS = 112 };
/** Exponent of 1 as it is stored. */
enum { EXPONENT_BIAS = 16383 };
/** Stored exponent of infinity and NaN. */
enum { EXPONENT_SPECIAL = 32767 };
/** The leading 1 of a significand. */
#define LEADING_BIT ((Bits)1 << FRACTION_BITS)
/** The sign. */
#define SIGN_BIT ((Bits)1 << 127)
/** Infinity. */
#define INFINITY_BITS ((Bits)EXPONENT_SPECIAL << FRACTION_BITS)
/** The bit that makes a NaN quiet. */
#define QUIET_BIT (LEADING_BIT >> 1)

/** A number as sign, exponent and significand. */
typedef struct Parts {
    Bits sign;        /**< #SIGN_BIT or 0. */
    int exponent;     /**< Biased; below 1 for numbers that are not normal. */
    Bits significand; /**< With its leading 1, if the number is finite and not zero. */
} Parts;

/** @return The bits of a number. */
static Bits bits_of(long double x) {
    Bits bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/** @return The number of bits. */
static long double number_of(Bits bits) {
    long double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/** @return The number of zero bits before the first 1. @param bits Not 0. */
static int leading_zeros(Bits bits) {
    uint64_t high = (uint64_t)(bits >> 64);
    return high ? __builtin_clzll(high) : 64 + __builtin_clzll((uint64_t)bits);
}

/** @return The parts of a number that is finite and not 0. */
static Parts split(Bits bits) {
    Parts parts = {.sign = bits & SIGN_BIT,
                   .exponent = (int)(bits >> FRACTION_BITS) & EXPONENT_SPECIAL,
                   .significand = bits & (LEADING_BIT - 1)};
    if (parts.exponent > 0) {
        parts.significand |= LEADING_BIT;
    } else {
        int shift = leading_zeros(parts.significand) - (127 - FRACTION_BITS);
        parts.significand <<= shift;
        parts.exponent = 1 - shift;
    }
    return parts;
}

/**
 * Rounds to nearest, ties to even.
 * @param sign         #SIGN_BIT or 0.
 * @param exponent     Biased exponent.
 * @param significand  From #LEADING_BIT to below twice that.
 * @param rest         Bits below it; the first is worth half of its last bit.
 * @param is_inexact   Whether there are more bits below those.
 * @return The number.
 */
static long double round_parts(Bits sign, int exponent, Bits significand, Bits rest,
                               bool is_inexact) {
    if (exponent >= EXPONENT_SPECIAL) {
        return number_of(sign | INFINITY_BITS);
    }
    if (exponent < 1) {
        int shift = 1 - exponent;
        if (shift > FRACTION_BITS + 2) {
            return number_of(sign);
        }
        is_inexact = is_inexact || rest != 0;
        rest = significand << (128 - shift);
        significand >>= shift;
        exponent = 0;
    } else {
        significand &= LEADING_BIT - 1;
    }
    Bits result = (Bits)exponent << FRACTION_BITS | significand;
    bool is_half = rest == SIGN_BIT && !is_inexact;
    if (is_half ? result & 1 : rest >= SIGN_BIT) {
        result++; // A carry into the exponent is right: up to the next power of two, or infinity.
    }
    return number_of(sign | result);
}

/** @return Whether the bits are those of a NaN. */
static bool is_nan(Bits bits) {
    return (bits & ~SIGN_BIT) > INFINITY_BITS;
}

/**
 * Multiplies two significands exactly.
 * @param[out] high  The upper 128 bits of the product.
 * @return The lower ones.
 */
static Bits multiply_whole(Bits a, Bits b, Bits *high) {
    uint64_t product[8] = {0}; // Digits of 32 bits, the last first.
    for (int i = 0; i < 4; i++) {
        uint64_t carry = 0, digit = (uint32_t)(a >> (32 * i));
        for (int j = 0; j < 4; j++) {
            uint64_t sum = digit * (uint32_t)(b >> (32 * j)) + product[i + j] + carry;
            product[i + j] = (uint32_t)sum;
            carry = sum >> 32;
        }
        product[i + 4] = carry;
    }
    *high = (Bits)product[7] << 96 | (Bits)product[6] << 64 | (Bits)product[5] << 32 | product[4];
    return (Bits)product[3] << 96 | (Bits)product[2] << 64 | (Bits)product[1] << 32 | product[0];
}

/** @return The product; the compiler calls it for `*`. */
long double __multf3(long double x, long double y) {
    Bits a = bits_of(x), b = bits_of(y), sign = (a ^ b) & SIGN_BIT;
    Bits abs_a = a & ~SIGN_BIT, abs_b = b & ~SIGN_BIT;
    if (is_nan(a) || is_nan(b)) {
        return number_of((is_nan(a) ? a : b) | QUIET_BIT);
    }
    if (abs_a == INFINITY_BITS || abs_b == INFINITY_BITS) {
        return number_of(abs_a && abs_b ? sign | INFINITY_BITS : INFINITY_BITS | QUIET_BIT);
    }
    if (!abs_a || !abs_b) {
        return number_of(sign);
    }
    Parts p = split(a), q = split(b);
    // The product of 1.x and 1.y is below 4. After a shift by 15 bits, the upper half is the
    // significand, from 2 on, or half of it.
    Bits high, low = multiply_whole(p.significand << 15, q.significand, &high);
    int exponent = p.exponent + q.exponent - EXPONENT_BIAS;
    if (high & LEADING_BIT) {
        exponent++;
    } else {
        high = high << 1 | low >> 127;
        low <<= 1;
    }
    return round_parts(sign, exponent, high, low, false);
}

/** @return The quotient; the compiler calls it for `/`. */
long double __divtf3(long double x, long double y) {
    Bits a = bits_of(x), b = bits_of(y), sign = (a ^ b) & SIGN_BIT;
    Bits abs_a = a & ~SIGN_BIT, abs_b = b & ~SIGN_BIT;
    if (is_nan(a) || is_nan(b)) {
        return number_of((is_nan(a) ? a : b) | QUIET_BIT);
    }
    if (abs_a == abs_b && (!abs_a || abs_a == INFINITY_BITS)) {
        return number_of(INFINITY_BITS | QUIET_BIT);
    }
    if (abs_a == INFINITY_BITS || !abs_b) {
        return number_of(sign | INFINITY_BITS);
    }
    if (!abs_a || abs_b == INFINITY_BITS) {
        return number_of(sign);
    }
    Parts p = split(a), q = split(b);
    int exponent = p.exponent - q.exponent + EXPONENT_BIAS;
    Bits rest = p.significand, quotient = 0;
    if (rest < q.significand) {
        rest <<= 1;
        exponent--;
    }
    for (int i = 0; i <= FRACTION_BITS; i++) {
        quotient <<= 1;
        if (rest >= q.significand) {
            rest -= q.significand;
            quotient |= 1;
        }
        rest <<= 1;
    }
    // The rest is twice what is left, below twice the divisor: half a unit or more is one bit.
    bool is_above_half = rest >= q.significand;
    bool is_inexact = is_above_half ? rest > q.significand : rest > 0;
    return round_parts(sign, exponent, quotient, is_above_half ? SIGN_BIT : 0, is_inexact);
}
