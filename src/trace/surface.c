/**
 * @file
 * @brief Materials met by rays.
 */
#include "trace/surface.h"

/** @return The share of light that is not mirrored. @param mirror The share that is. */
static Scalar3 rest_of(Scalar3 mirror) {
    return (Scalar3){1 - mirror.red, 1 - mirror.green, 1 - mirror.blue};
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
    Scalar3 mirror = scalar3_of(material->reflectivity), rest = rest_of(mirror);
    return (Surface){.emission = scalar3_of(material->emission),
                     .body = scalar3_multiply(rest, scalar3_of(material->color)),
                     .highlight = scalar3_scale(rest, (scalar)material->specular),
                     .mirror = mirror,
                     .ambient = scalar3_scale(scalar3_of(ambient), (scalar)material->ambient),
                     .diffuse = (scalar)material->diffuse,
                     .shininess = (scalar)material->shininess};
}

/** @return A material in all lanes. @param s The material. */
INLINE Surfaces surfaces_of(const Surface *s) {
    return (Surfaces){.emission = light3_of(s->emission),
                      .body = light3_of(s->body),
                      .highlight = light3_of(s->highlight),
                      .mirror = light3_of(s->mirror),
                      .ambient = light3_of(s->ambient),
                      .diffuse = real_of(s->diffuse),
                      .shininess = real_of(s->shininess)};
}

/** @return a where the mask is set, b elsewhere. @param m A mask. @param a Some. @param b Others.
 */
INLINE Surfaces surfaces_select(mask m, const Surfaces *a, const Surfaces *b) {
    return (Surfaces){.emission = light3_select(m, a->emission, b->emission),
                      .body = light3_select(m, a->body, b->body),
                      .highlight = light3_select(m, a->highlight, b->highlight),
                      .mirror = light3_select(m, a->mirror, b->mirror),
                      .ambient = light3_select(m, a->ambient, b->ambient),
                      .diffuse = real_select(m, a->diffuse, b->diffuse),
                      .shininess = real_select(m, a->shininess, b->shininess)};
}

Surfaces surfaces_gather(const Surface *surfaces, integer materials, mask active) {
    int first = any(active) ? integer_lane(materials, mask_first(active)) : 0;
    Surfaces gathered = surfaces_of(&surfaces[first]);
    active &= mask_not(materials == integer_of(first));
    // One more turn for each different material: mostly none, for neighbours meet the same thing.
    while (any(active)) {
        int material = integer_lane(materials, mask_first(active));
        mask same = active & (materials == integer_of(material));
        Surfaces one = surfaces_of(&surfaces[material]);
        gathered = surfaces_select(same, &one, &gathered);
        active &= mask_not(same);
    }
    return gathered;
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
