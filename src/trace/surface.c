/**
 * @file
 * @brief Materials met by rays.
 */
#include "trace/surface.h"

/** @return What is left of one primary, never less than nothing. @param mirror The share that is
 *  mirrored. @param through The share that is let through. */
static scalar rest_of_one(scalar mirror, scalar through) {
    scalar rest = 1 - mirror - through;
    return rest > 0 ? rest : 0;
}

/** @return The share of light that is left to the body. @param mirror The share that is mirrored.
 *  @param through The share that is let through. */
static Scalar3 rest_of(Scalar3 mirror, Scalar3 through) {
    return (Scalar3){rest_of_one(mirror.red, through.red), rest_of_one(mirror.green, through.green),
                     rest_of_one(mirror.blue, through.blue)};
}

/** @return a times b, primary by primary. @param a Light. @param b Shares. */
static Scalar3 scalar3_multiply(Scalar3 a, Scalar3 b) {
    return (Scalar3){a.red * b.red, a.green * b.green, a.blue * b.blue};
}

/** @return a times s. @param a Light. @param s A factor. */
static Scalar3 scalar3_scale(Scalar3 a, scalar s) {
    return (Scalar3){a.red * s, a.green * s, a.blue * s};
}

Surface surface_of(const Material *material, Color ambient) {
    Scalar3 mirror = scalar3_of(material->reflectivity);
    Scalar3 through = scalar3_of(material->transparency), rest = rest_of(mirror, through);
    return (Surface){.emission = scalar3_of(material->emission),
                     .body = scalar3_multiply(rest, scalar3_of(material->color)),
                     .highlight = scalar3_scale(rest, (scalar)material->specular),
                     .mirror = mirror,
                     .through = through,
                     .ambient = scalar3_scale(scalar3_of(ambient), (scalar)material->ambient),
                     .diffuse = (scalar)material->diffuse,
                     .shininess = (scalar)material->shininess};
}

/**
 * @return The whole part.
 * @param x  0 to 2^31.
 */
INLINE real whole_part(real x) {
    real whole = {0};
    for (int i = 0; i < LANES; i++) {
        real_set_lane(&whole, i, (scalar)(int32_t)real_lane(x, i));
    }
    return whole;
}

real surface_power(real base, real exponent) {
    real one = real_of(1), result = one, square = base;
    real whole = whole_part(exponent), rest = exponent - whole;
    // Binary digits of the whole part, lowest first: base^1, base^2, base^4, ...
    while (any(whole >= one)) {
        real half = whole_part(whole * (scalar)0.5);
        result = real_select(whole - 2 * half >= one, result * square, result);
        square = square * square;
        whole = half;
    }
    // Binary digits of the rest, highest first: base^1/2, base^1/4, ...
    real root = base;
    while (any(rest > 0)) {
        root = real_sqrt(root);
        mask digit = rest * 2 >= one;
        result = real_select(digit, result * root, result);
        rest = real_select(digit, rest * 2 - one, rest * 2);
    }
    return result;
}
