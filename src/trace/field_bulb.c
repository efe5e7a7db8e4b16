/**
 * @file
 * @brief The Mandelbulb: a bound of its distance by its potential.
 */
#include "trace/field_machine.h"

/** LANES complex numbers. */
typedef struct Complex {
    real re; /**< Real part. */
    real im; /**< Imaginary part. */
} Complex;

/** Where a number is nearer to 2 than to 1; any place near it would do. */
#define SQUARE_ROOT_OF_2 ((scalar)1.4142135f)
/** The natural logarithm of 2 in three pieces: their sum is right in every number type. */
#define LOGARITHM_OF_2                                                                             \
    ((scalar)0x1.62e42fefa39efp-1 + (scalar)0x1.abc9e3b39803fp-56 + (scalar)0x1.7b57a079a1934p-111)

/** @return The highest binary digit of a number. @param n At least 1. */
static inline int highest_digit(int n) {
    int digit = 1;
    while (digit <= n / 2) {
        digit *= 2;
    }
    return digit;
}

/** @return a times b. @param a Numbers. @param b Others. */
INLINE Complex complex_multiply(Complex a, Complex b) {
    return (Complex){a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

/** @return z^n, by the binary digits of n, highest first. @param z Numbers. @param n At least 1. */
INLINE Complex complex_power(Complex z, int n) {
    Complex power = z;
    for (int digit = highest_digit(n) / 2; digit > 0; digit /= 2) {
        power = complex_multiply(power, power);
        power = n & digit ? complex_multiply(power, z) : power;
    }
    return power;
}

/** @return r^n, by the binary digits of n, highest first. @param r Numbers. @param n At least 1. */
INLINE real whole_power(real r, int n) {
    real power = r;
    for (int digit = highest_digit(n) / 2; digit > 0; digit /= 2) {
        power = power * power;
        power = n & digit ? power * r : power;
    }
    return power;
}

/** Terms of the series for the logarithm that are enough. */
enum { LOGARITHM_TERMS = REAL_BITS == 32 ? 5 : REAL_BITS == 64 ? 10 : 22 };

/** @return The natural logarithms: powers of 2 are taken off until a number is near 1; there it is
 *          2 (y + y^3/3 + y^5/5 + ...) of y = (x - 1) / (x + 1). @param x Numbers, 2^-64 to 2^127.
 */
INLINE real logarithm(real x) {
    const real one = real_of(1), zero = real_of(0);
    mask is_small = x < one;
    real taken = real_select(is_small, real_of(-64), zero);
    x = real_select(is_small, x * (scalar)0x1p64f, x);
    for (int digit = 64; digit > 0; digit /= 2) {
        const scalar root = (scalar)(1ull << digit / 2), power = digit > 1 ? root * root : 2;
        mask has = x >= real_of(power);
        x = real_select(has, x * (1 / power), x);
        taken = real_select(has, taken + (scalar)digit, taken);
    }
    mask is_above = x > real_of(SQUARE_ROOT_OF_2);
    x = real_select(is_above, x * (scalar)0.5f, x);
    taken = real_select(is_above, taken + one, taken);
    real y = (x - one) / (x + one), square = y * y, sum = zero;
    for (int k = LOGARITHM_TERMS; k >= 0; k--) {
        sum = 1 / real_of((scalar)(2 * k + 1)) + square * sum;
    }
    return taken * LOGARITHM_OF_2 + 2 * (y * sum);
}

/** The orbit of LANES points. */
typedef struct Orbit {
    Vector z;        /**< Where they are. */
    real radius;     /**< How far from zero. */
    real derivative; /**< How much farther than the first points they would be apart. */
    real potential;  /**< Of the surface, at their iterate. */
} Orbit;

/**
 * @return z^n + c: the distance from zero to the n-th power, both angles times n. They come as
 * powers of complex numbers, so that no sine is needed.
 * @param z  Points.
 * @param c  What is added.
 * @param n  The power.
 */
INLINE Vector bulb_step(Vector z, Vector c, int n) {
    real across = real_sqrt(z.x * z.x + z.z * z.z);
    Complex tilt = complex_power((Complex){z.y, across}, n);
    Complex turn = {quotient(z.z, across), quotient(z.x, across)};
    turn.re = real_select(across > 0, turn.re, real_of(1));
    turn = complex_power(turn, n);
    return vector_add((Vector){tilt.im * turn.im, tilt.re, tilt.im * turn.re}, c);
}

/** Goes on with orbits that are still near zero. @param[in,out] orbit The orbits. @param c Where
 *  they began. @param n The power. @param going The lanes that go on. */
INLINE void orbit_step(Orbit *orbit, Vector c, int n, mask going) {
    real factor = (scalar)n * whole_power(orbit->radius, n - 1);
    Vector z = bulb_step(orbit->z, c, n);
    orbit->z = vector_select(going, z, orbit->z);
    orbit->radius = real_select(going, real_sqrt(vector_dot(z, z)), orbit->radius);
    orbit->derivative = real_select(going, factor * orbit->derivative + 1, orbit->derivative);
    orbit->potential = real_select(going, orbit->potential * (scalar)n, orbit->potential);
}

/** @return The bound of the distance to a Mandelbulb. @param p Points. @param numbers The step's.
 *  @param active The lanes that count. */
INLINE real mandelbulb_distance(Vector p, const scalar *numbers, mask active) {
    const int n = (int)numbers[0], iterations = (int)numbers[1];
    const real escape = real_of(numbers[4]);
    real far = real_sqrt(vector_dot(p, p));
    Orbit orbit = {p, far, real_of(1), real_of(numbers[5])};
    mask going = active & (far < escape);
    for (int i = 1; i < iterations && any(going); i++) {
        orbit_step(&orbit, p, n, going);
        going = going & (orbit.radius < escape);
    }
    real radius = real_max(orbit.radius, real_of((scalar)0x1p-60f));
    real above = logarithm(real_min(radius, real_of((scalar)0x1p100f))) - orbit.potential;
    real estimate = numbers[3] * above * radius / orbit.derivative;
    return real_max(estimate, far - numbers[2]);
}

/** Step of the differences that stand for the derivatives of a Mandelbulb: it has edges of every
 *  size, and smaller ones than this are smoothed in its shading. */
#define BULB_STEP ((scalar)0x1p-11f)

/** @return Half the difference of the distances a step away, both ways. @param m Where.
 *  @param step The step. @param numbers The step's of the tape. */
INLINE real bulb_difference(const FieldMachine *m, Vector step, const scalar *numbers) {
    return mandelbulb_distance(vector_add(m->point, step), numbers, m->active) -
           mandelbulb_distance(vector_subtract(m->point, step), numbers, m->active);
}

void field_mandelbulb_run(FieldMachine *m, const FieldCode *code) {
    const scalar *numbers = code->numbers;
    m->sample.distance = mandelbulb_distance(m->point, numbers, m->active);
    if (m->derives) {
        const real h = real_of(BULB_STEP), zero = real_of(0);
        Vector difference = {bulb_difference(m, (Vector){h, zero, zero}, numbers),
                             bulb_difference(m, (Vector){zero, h, zero}, numbers),
                             bulb_difference(m, (Vector){zero, zero, h}, numbers)};
        m->sample.gradient = vector_scale(difference, 1 / (2 * h));
    }
}
