/**
 * @file
 * @brief The Mandelbulb: a bound of its distance from its potential.
 */
#include "trace/sdf/sdf_vm.h"

/** LANES complex numbers. */
typedef struct Complex {
    real re; /**< Real part. */
    real im; /**< Imaginary part. */
} Complex;

/** Upper end of the range of the series for the logarithm. */
#define SQRT_OF_2 ((scalar)1.4142135f)
/** The natural logarithm of 2 in three pieces: their sum is right in every number type. */
#define LN_OF_2                                                                                    \
    ((scalar)0x1.62e42fefa39efp-1 + (scalar)0x1.abc9e3b39803fp-56 + (scalar)0x1.7b57a079a1934p-111)

/** @return The highest binary digit of a number. */
static inline int highest_bit(int n) {
    int bit = 1;
    while (bit <= n / 2) {
        bit *= 2;
    }
    return bit;
}

/** @return a times b. */
INLINE Complex complex_multiply(Complex a, Complex b) {
    return (Complex){a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

/** @return z^n, by the binary digits of n, highest first. */
INLINE Complex complex_power(Complex z, int n) {
    Complex power = z;
    for (int bit = highest_bit(n) / 2; bit > 0; bit /= 2) {
        power = complex_multiply(power, power);
        power = n & bit ? complex_multiply(power, z) : power;
    }
    return power;
}

/** @return r^n, by the binary digits of n, highest first. */
INLINE real real_integer_power(real r, int n) {
    real power = r;
    for (int bit = highest_bit(n) / 2; bit > 0; bit /= 2) {
        power = power * power;
        power = n & bit ? power * r : power;
    }
    return power;
}

/** Number of terms of the series for the logarithm. */
enum { LN_SERIES_TERMS = REAL_BITS == 32 ? 5 : REAL_BITS == 64 ? 10 : 22 };

/** Divides numbers by powers of two, so that they are 1 to 2. @param[in,out] x Numbers, 2^-64 to
 *  2^127. @return The logarithms of the powers to the base 2. */
INLINE real real_split_power(real *x) {
#if LANES > 1
    // The exponent lies above the fraction. That of 1 replaces it.
    const int shift = REAL_BITS == 32 ? 23 : 52;
    const lane_integer one = (lane_integer)(REAL_BITS == 32 ? 127 : 1023) << shift;
    const integer bits = (integer)*x;
    *x = (real)((bits & (((lane_integer)1 << shift) - 1)) | one);
    return __builtin_convertvector((bits - one) >> shift, real);
#else
    const real one = real_of(1), zero = real_of(0);
    mask is_small = *x < one;
    real exponent = real_select(is_small, real_of(-64), zero);
    *x = real_select(is_small, *x * (scalar)0x1p64f, *x);
    for (int bit = 64; bit > 0; bit /= 2) {
        const scalar root = (scalar)(1ull << bit / 2), power = bit > 1 ? root * root : 2;
        mask has = *x >= real_of(power);
        *x = real_select(has, *x * (1 / power), *x);
        exponent = real_select(has, exponent + (scalar)bit, exponent);
    }
    return exponent;
#endif
}

/** @return The natural logarithms. After division by a power of two x is near 1, and the logarithm
 * is 2 (y + y^3/3 + y^5/5 + ...) with y = (x - 1) / (x + 1). @param x Numbers, 2^-64 to 2^127. */
INLINE real real_ln(real x) {
    const real one = real_of(1);
    real exponent = real_split_power(&x), sum = real_of(0);
    mask is_above = x > real_of(SQRT_OF_2);
    x = real_select(is_above, x * (scalar)0.5f, x);
    exponent = real_select(is_above, exponent + one, exponent);
    real y = (x - one) / (x + one), square = y * y;
    for (int k = LN_SERIES_TERMS; k >= 0; k--) {
        sum = 1 / real_of((scalar)(2 * k + 1)) + square * sum;
    }
    return exponent * LN_OF_2 + 2 * (y * sum);
}

/** The orbit of LANES points. */
typedef struct MandelbulbOrbit {
    Vec3 z;          /**< Current iterates. */
    real radius;     /**< Their distance from the origin. */
    real derivative; /**< Bound on their derivative by the first points. */
    real potential;  /**< Logarithm of the radius of the surface at this iterate. */
} MandelbulbOrbit;

/** @return z^n + c: the radius to the n-th power, both angles times n. Powers of complex numbers
 *  replace sine and cosine. */
INLINE Vec3 mandelbulb_iterate(Vec3 z, Vec3 c, int n) {
    real across = real_sqrt(z.x * z.x + z.z * z.z);
    Complex polar = complex_power((Complex){z.y, across}, n);
    Complex azimuth = {real_divide_or_zero(z.z, across), real_divide_or_zero(z.x, across)};
    azimuth.re = real_select(across > 0, azimuth.re, real_of(1));
    azimuth = complex_power(azimuth, n);
    return vec3_add((Vec3){polar.im * azimuth.im, polar.re, polar.im * azimuth.re}, c);
}

/** Iterates orbits that have not escaped. @param iterating Their lanes. */
INLINE void mandelbulb_orbit_step(MandelbulbOrbit *orbit, Vec3 c, int n, mask iterating) {
    real factor = (scalar)n * real_integer_power(orbit->radius, n - 1);
    Vec3 z = mandelbulb_iterate(orbit->z, c, n);
    orbit->z = vec3_select(iterating, z, orbit->z);
    orbit->radius = real_select(iterating, real_sqrt(vec3_dot(z, z)), orbit->radius);
    orbit->derivative = real_select(iterating, factor * orbit->derivative + 1, orbit->derivative);
    orbit->potential = real_select(iterating, orbit->potential * (scalar)n, orbit->potential);
}

/** @return The bound of the distance that an orbit gives. @param length Distances of its first
 *  points from the origin. */
INLINE real mandelbulb_orbit_distance(const MandelbulbOrbit *orbit, real length,
                                      const scalar *operands) {
    real radius = real_max(orbit->radius, real_of((scalar)0x1p-60f));
    real above = real_ln(real_min(radius, real_of((scalar)0x1p100f))) - orbit->potential;
    real estimate = operands[3] * above * radius / orbit->derivative;
    return real_max(estimate, length - operands[2]);
}

int sdf_mandelbulb_distances(const scalar *operands, const Vec3 *points, const mask *active,
                             int count, real *distances) {
    const int n = (int)operands[0], iterations = (int)operands[1];
    const real escape = real_of(operands[4]);
    MandelbulbOrbit orbits[SDF_VECTORS_MAXIMUM];
    real lengths[SDF_VECTORS_MAXIMUM];
    mask iterating[SDF_VECTORS_MAXIMUM], any_iterating = mask_of(false);
    for (int v = 0; v < count; v++) {
        lengths[v] = real_sqrt(vec3_dot(points[v], points[v]));
        orbits[v] = (MandelbulbOrbit){points[v], lengths[v], real_of(1), real_of(operands[5])};
        iterating[v] = active[v] & (lengths[v] < escape);
        any_iterating |= iterating[v];
    }
    int done = 1;
    for (; done < iterations && any(any_iterating); done++) {
        any_iterating = mask_of(false);
        for (int v = 0; v < count; v++) {
            mandelbulb_orbit_step(&orbits[v], points[v], n, iterating[v]);
            iterating[v] = iterating[v] & (orbits[v].radius < escape);
            any_iterating |= iterating[v];
        }
    }
    for (int v = 0; v < count; v++) {
        distances[v] = mandelbulb_orbit_distance(&orbits[v], lengths[v], operands);
    }
    return done;
}

/** Step of the central differences for the gradient: the fractal has details of every size, and the
 *  shading smooths smaller ones than this. */
#define MANDELBULB_GRADIENT_STEP ((scalar)0x1p-11f)

/** @return The gradient at points, by central differences. @param active Lanes that count. */
INLINE Vec3 mandelbulb_gradient(const scalar *operands, Vec3 p, mask active) {
    const real h = real_of(MANDELBULB_GRADIENT_STEP);
    const Vec3 points[SDF_VECTORS_MAXIMUM] = {{p.x + h, p.y, p.z}, {p.x - h, p.y, p.z},
                                              {p.x, p.y + h, p.z}, {p.x, p.y - h, p.z},
                                              {p.x, p.y, p.z + h}, {p.x, p.y, p.z - h}};
    const mask all[SDF_VECTORS_MAXIMUM] = {active, active, active, active, active, active};
    real d[SDF_VECTORS_MAXIMUM];
    sdf_mandelbulb_distances(operands, points, all, SDF_VECTORS_MAXIMUM, d);
    return vec3_scale((Vec3){d[0] - d[1], d[2] - d[3], d[4] - d[5]}, 1 / (2 * h));
}

void sdf_op_mandelbulb(SdfVm *vm, const SdfInstruction *instruction) {
    const scalar *operands = instruction->operands;
    // The first iteration is the instruction itself.
    vm->operations += (uint32_t)sdf_mandelbulb_distances(operands, &vm->point, &vm->active, 1,
                                                         &vm->sample.distance) -
                      1;
    if (vm->wants_gradient) {
        vm->sample.gradient = mandelbulb_gradient(operands, vm->point, vm->active);
    }
}
