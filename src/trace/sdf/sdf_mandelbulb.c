/**
 * @file
 * @brief The Mandelbulb: a bound of its distance from its potential.
 */
#include "trace/sdf/sdf_vm.h"

/** LANES numbers re + im i w with a real w that all operations share. Where w is a root, such as
 *  the distance from an axis, its square is all that products need. */
typedef struct Complex {
    real re; /**< Real part. */
    real im; /**< Imaginary part, divided by w. */
} Complex;

/** Upper end of the range of the series for the logarithm. */
#define SQRT_OF_2 ((scalar)1.4142135f)
/** The natural logarithm of 2 in three pieces: their sum is right in every number type. */
#define LN_OF_2                                                                                    \
    ((scalar)0x1.62e42fefa39efp-1 + (scalar)0x1.abc9e3b39803fp-56 + (scalar)0x1.7b57a079a1934p-111)

/** The power of nearly every Mandelbulb: loops over its digits are unrolled. */
#define USUAL_POWER 8

/** @return The highest binary digit of a number; known to the compiler where the number is. @param
 * n From 1. */
static inline int highest_bit(int n) {
    const int top = 31; // Of 32 bits.
    return 1 << (top - __builtin_clz((unsigned)n));
}

/** @return a times b. @param square That of w. */
INLINE Complex complex_multiply(Complex a, Complex b, real square) {
    return (Complex){a.re * b.re - square * (a.im * b.im), a.re * b.im + a.im * b.re};
}

/** @return z^n, by the binary digits of n, highest first. @param square That of w. */
INLINE Complex complex_power(Complex z, int n, real square) {
    Complex power = z;
    for (int bit = highest_bit(n) / 2; bit > 0; bit /= 2) {
        power = complex_multiply(power, power, square);
        power = n & bit ? complex_multiply(power, z, square) : power;
    }
    return power;
}

/** @return r^n, by the binary digits of n, highest first. @param n From 0. */
INLINE real real_integer_power(real r, int n) {
    real power = real_of(1);
    for (int bit = n > 0 ? highest_bit(n) : 0; bit > 0; bit /= 2) {
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
    Vec3 z;          /**< Current iterates; undefined after the escape. */
    real square;     /**< That of their distance from the origin. */
    real derivative; /**< Bound on their derivative by the first points. */
    real potential;  /**< Logarithm of the radius of the surface at this iterate. */
} MandelbulbOrbit;

/** Smallest square of a distance from the axis that has a direction: it has an inverse. */
#define ACROSS_SQUARE_MINIMUM ((scalar)0x1p-120f)

/**
 * Raises points to the power n: the radius to the n-th power, both angles times n. Powers of
 * complex numbers replace sine and cosine: with w, the distance from the y axis,
 * - the angle from the axis is that of y + i w, whose n-th power is a + i w b;
 * - the angle about the axis is that of u = (z + i x) / w.
 *
 * The result has the height a, and u^n w b across the axis. u^2 = (z + i x)^2 / w^2 needs no root:
 * u^n w is (u^2)^(n/2) w for an even n, and (u^2)^((n-1)/2) (z + i x) for an odd one.
 * @param n  The power, from 2.
 */
INLINE Vec3 mandelbulb_power(Vec3 z, int n) {
    const real one = real_of(1), zero = real_of(0);
    real x_square = z.x * z.x, z_square = z.z * z.z, square = x_square + z_square;
    Complex polar = complex_power((Complex){z.y, one}, n, square);
    mask has_direction = square > ACROSS_SQUARE_MINIMUM;
    real inverse = real_select(has_direction, one / square, zero);
    Complex twice = {(z_square - x_square) * inverse, 2 * (z.z * z.x) * inverse};
    Complex azimuth = complex_power(twice, n / 2, one);
    if (n % 2) {
        azimuth = complex_multiply(azimuth, (Complex){z.z, z.x}, one);
    } else {
        polar.im = polar.im * real_sqrt(square);
    }
    return (Vec3){polar.im * azimuth.im, polar.re, polar.im * azimuth.re};
}

/** @return n r^(n-1), the derivative of r^n. @param square r^2. */
INLINE real power_derivative(real square, int n) {
    real power = (scalar)n * real_integer_power(square, (n - 1) / 2);
    return n % 2 ? power : power * real_sqrt(square);
}

/** Iterates orbits that have not escaped. @param iterating Their lanes. */
INLINE void mandelbulb_orbit_step(MandelbulbOrbit *orbit, Vec3 c, int n, mask iterating) {
    real derivative = power_derivative(orbit->square, n) * orbit->derivative + 1;
    orbit->z = vec3_add(mandelbulb_power(orbit->z, n), c);
    orbit->square = real_select(iterating, vec3_dot(orbit->z, orbit->z), orbit->square);
    orbit->derivative = real_select(iterating, derivative, orbit->derivative);
    orbit->potential = real_select(iterating, orbit->potential * (scalar)n, orbit->potential);
}

/** @return The bound of the distance that an orbit gives. @param length Distances of its first
 *  points from the origin. */
INLINE real mandelbulb_orbit_distance(const MandelbulbOrbit *orbit, real length,
                                      const scalar *operands) {
    real radius = real_max(real_sqrt(orbit->square), real_of((scalar)0x1p-60f));
    real above = real_ln(real_min(radius, real_of((scalar)0x1p100f))) - orbit->potential;
    real estimate = operands[3] * above * radius / orbit->derivative;
    return real_max(estimate, length - operands[2]);
}

/** #sdf_mandelbulb_distances for a power and a number of vectors that may be constants. */
INLINE int mandelbulb_distances(const scalar *operands, int n, const Vec3 *points,
                                const mask *active, int count, real *distances) {
    const int iterations = (int)operands[1];
    const real escape_square = real_of(operands[4] * operands[4]);
    MandelbulbOrbit orbits[SDF_VECTORS_MAXIMUM];
    real lengths[SDF_VECTORS_MAXIMUM];
    mask iterating[SDF_VECTORS_MAXIMUM], any_iterating = mask_of(false);
    for (int v = 0; v < count; v++) {
        real square = vec3_dot(points[v], points[v]);
        lengths[v] = real_sqrt(square);
        orbits[v] = (MandelbulbOrbit){points[v], square, real_of(1), real_of(operands[5])};
        iterating[v] = active[v] & (square < escape_square);
        any_iterating |= iterating[v];
    }
    int done = 1;
    for (; done < iterations && any(any_iterating); done++) {
        any_iterating = mask_of(false);
        for (int v = 0; v < count; v++) {
            if (!any(iterating[v])) {
                continue;
            }
            mandelbulb_orbit_step(&orbits[v], points[v], n, iterating[v]);
            iterating[v] = iterating[v] & (orbits[v].square < escape_square);
            any_iterating |= iterating[v];
        }
    }
    for (int v = 0; v < count; v++) {
        distances[v] = mandelbulb_orbit_distance(&orbits[v], lengths[v], operands);
    }
    return done;
}

int sdf_mandelbulb_distances(const scalar *operands, const Vec3 *points, const mask *active,
                             int count, real *distances) {
    const int n = (int)operands[0];
    if (n != USUAL_POWER) {
        return mandelbulb_distances(operands, n, points, active, count, distances);
    }
    if (count != MARCH_VECTORS) {
        return mandelbulb_distances(operands, USUAL_POWER, points, active, count, distances);
    }
    return mandelbulb_distances(operands, USUAL_POWER, points, active, MARCH_VECTORS, distances);
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
