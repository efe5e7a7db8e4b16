/**
 * @file
 * @brief Materials met by rays.
 */
#include "trace/materials/material.h"

/** @return What is left of one primary, never less than nothing. @param reflectance The share that
 * is mirrored. @param transmittance The share that is let through. */
static scalar diffuse_fraction_channel(scalar reflectance, scalar transmittance) {
    scalar remaining = 1 - reflectance - transmittance;
    return remaining > 0 ? remaining : 0;
}

/** @return The share of light that is left to the body. @param reflectance The share that is
 * mirrored.
 *  @param transmittance The share that is let through. */
static Rgbs diffuse_fraction(Rgbs reflectance, Rgbs transmittance) {
    return (Rgbs){diffuse_fraction_channel(reflectance.red, transmittance.red),
                  diffuse_fraction_channel(reflectance.green, transmittance.green),
                  diffuse_fraction_channel(reflectance.blue, transmittance.blue)};
}

/** @return a times b, primary by primary. */
static Rgbs rgbs_multiply(Rgbs a, Rgbs b) {
    return (Rgbs){a.red * b.red, a.green * b.green, a.blue * b.blue};
}

/** @return a times s. */
static Rgbs rgbs_scale(Rgbs a, scalar s) {
    return (Rgbs){a.red * s, a.green * s, a.blue * s};
}

Material material_of(const SceneMaterial *material, Rgbd ambient) {
    Rgbs reflectance = rgbs_of(material->reflectivity);
    Rgbs transmittance = rgbs_of(material->transparency),
         remaining = diffuse_fraction(reflectance, transmittance);
    return (Material){.emission = rgbs_of(material->emission),
                      .albedo = rgbs_multiply(remaining, rgbs_of(material->color)),
                      .specular = rgbs_scale(remaining, (scalar)material->specular),
                      .reflectance = reflectance,
                      .transmittance = transmittance,
                      .ambient = rgbs_scale(rgbs_of(ambient), (scalar)material->ambient),
                      .diffuse = (scalar)material->diffuse,
                      .shininess = (scalar)material->shininess};
}

/** @return The whole part. */
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
    // Binary digits of the whole part, lowest first: base^1, base^2, base^4, ...
    while (any(whole >= one)) {
        real half = real_truncate(whole * (scalar)0.5);
        result = real_select(whole - 2 * half >= one, result * square, result);
        square = square * square;
        whole = half;
    }
    // Binary digits of the rest, highest first: base^1/2, base^1/4, ...
    real root = base;
    while (any(remaining > 0)) {
        root = real_sqrt(root);
        mask digit = remaining * 2 >= one;
        result = real_select(digit, result * root, result);
        remaining = real_select(digit, remaining * 2 - one, remaining * 2);
    }
    return result;
}
