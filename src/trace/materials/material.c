/**
 * @file
 * @brief Materials in the engine's number type.
 */
#include "trace/materials/material.h"

/** @return 1 - R - T of a channel, not negative. */
static scalar diffuse_fraction_channel(scalar reflectance, scalar transmittance) {
    scalar remaining = 1 - reflectance - transmittance;
    return remaining > 0 ? remaining : 0;
}

/** @return max(0, 1 - R - T): the fraction of light that is neither reflected nor transmitted. */
static Rgbs diffuse_fraction(Rgbs reflectance, Rgbs transmittance) {
    return (Rgbs){diffuse_fraction_channel(reflectance.red, transmittance.red),
                  diffuse_fraction_channel(reflectance.green, transmittance.green),
                  diffuse_fraction_channel(reflectance.blue, transmittance.blue)};
}

/** @return a times b, channel by channel. */
static Rgbs rgbs_multiply(Rgbs a, Rgbs b) {
    return (Rgbs){a.red * b.red, a.green * b.green, a.blue * b.blue};
}

/** @return a times s. */
static Rgbs rgbs_scale(Rgbs a, scalar s) {
    return (Rgbs){a.red * s, a.green * s, a.blue * s};
}

/** @return Whether any channel is above 0. */
static bool rgbs_is_positive(Rgbs c) {
    return c.red > 0 || c.green > 0 || c.blue > 0;
}

Material material_of(const SceneMaterial *scene, Rgbd ambient_light) {
    Rgbs rest = diffuse_fraction(rgbs_of(scene->reflectivity), rgbs_of(scene->transparency));
#define PROPERTY(name, value) .name = value,
    Material material = {MATERIAL_PROPERTIES(PROPERTY, PROPERTY)};
#undef PROPERTY
    bool turns = rgbs_is_positive(material.reflectance) || rgbs_is_positive(material.transmittance);
    material.traits =
        (rgbs_is_positive(material.specular) ? MATERIAL_SHINES : 0) | (turns ? MATERIAL_TURNS : 0);
    return material;
}

/** @return The integer part of a number below 2^31. */
INLINE real real_truncate(real x) {
    real whole = {0};
    for (int i = 0; i < LANES; i++) {
        real_set_lane(&whole, i, (scalar)(int32_t)real_lane(x, i));
    }
    return whole;
}

real real_pow(real base, real exponent) {
    real one = real_of(1), result = one, square = base;
    real whole = real_truncate(exponent), remaining = exponent - whole;
    // Binary digits of the integer part, lowest first: base^1, base^2, base^4, ...
    while (any(whole >= one)) {
        real half = real_truncate(whole * (scalar)0.5);
        result = real_select(whole - 2 * half >= one, result * square, result);
        square = square * square;
        whole = half;
    }
    // Binary digits of the fraction, highest first: base^1/2, base^1/4, ...
    real root = base;
    while (any(remaining > 0)) {
        root = real_sqrt(root);
        mask digit = remaining * 2 >= one;
        result = real_select(digit, result * root, result);
        remaining = real_select(digit, remaining * 2 - one, remaining * 2);
    }
    return result;
}
