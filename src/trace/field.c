/**
 * @file
 * @brief What the steps of distance fields do.
 *
 * The distances are those of Inigo Quilez (*Distance functions*); the derivatives follow from them.
 * A lane's answer never depends on the other lanes: what a step leaves out for want of a lane that
 * needs it changes no lane.
 */
#include "trace/field.h"

#include "trace/angle.h"

/** What the steps of a tape work on. */
struct FieldMachine {
    Vector point;       /**< Where. */
    FieldSample sample; /**< What the steps so far say of it. */
    mask active;        /**< The lanes that count. */
    bool derives;       /**< Whether gradients are wanted. */
};

/** Runs steps one after the other. @param machine What they work on. @param codes The steps.
 *  @param count How many. */
static void field_run(FieldMachine *machine, const FieldCode *codes, int count) {
    for (const FieldCode *code = codes; code < codes + count; code += 1 + code->body) {
        code->run(machine, code);
    }
}

/** @return 1 or -1, as the sign of numbers. @param x Numbers. */
INLINE real sign_of(real x) {
    return real_select(x < 0, real_of(-1), real_of(1));
}

/** @return The absolute values. @param v Vectors. */
INLINE Vector vector_abs(Vector v) {
    return (Vector){real_abs(v.x), real_abs(v.y), real_abs(v.z)};
}

/** @return a times b, component by component. @param a Vectors. @param b Others. */
INLINE Vector vector_multiply(Vector a, Vector b) {
    return (Vector){a.x * b.x, a.y * b.y, a.z * b.z};
}

/** @return The signs of the components. @param v Vectors. */
INLINE Vector vector_signs(Vector v) {
    return (Vector){sign_of(v.x), sign_of(v.y), sign_of(v.z)};
}

/** @return x / y; 0 where y is 0. @param x Numbers. @param y Others. */
INLINE real quotient(real x, real y) {
    return real_select(y > 0, x / y, real_of(0));
}

/** @return Half the edges of a box. @param numbers Three of a step. */
INLINE Vector vector_from(const scalar *numbers) {
    return (Vector){real_of(numbers[0]), real_of(numbers[1]), real_of(numbers[2])};
}

/* --- primitives ------------------------------------------------------------------------------- */

/** Measures a ball. See #FieldCode.run. @param m See there. @param code See there. */
static void sphere_run(FieldMachine *m, const FieldCode *code) {
    real length = real_sqrt(vector_dot(m->point, m->point));
    m->sample.distance = length - code->numbers[0];
    if (m->derives) {
        m->sample.gradient = vector_scale(m->point, quotient(real_of(1), length));
    }
}

/** @return Which way the largest component lies: 1 along the first axis that has it.
 *  @param v Vectors. @param largest Their largest component. */
INLINE Vector axis_of_largest(Vector v, real largest) {
    const real zero = real_of(0), one = real_of(1);
    mask is_x = v.x >= largest, is_y = mask_not(is_x) & (v.y >= largest);
    return (Vector){real_select(is_x, one, zero), real_select(is_y, one, zero),
                    real_select(is_x | is_y, zero, one)};
}

/**
 * @return How far points are from the corner at zero of a box that fills all that is negative.
 * @param v        The points.
 * @param derives  Whether the gradient is wanted.
 */
INLINE FieldSample corner_sample(Vector v, bool derives) {
    const real zero = real_of(0);
    Vector out = {real_max(v.x, zero), real_max(v.y, zero), real_max(v.z, zero)};
    real length = real_sqrt(vector_dot(out, out));
    real largest = real_max(v.x, real_max(v.y, v.z));
    FieldSample sample = {.distance = length + real_min(largest, zero)};
    if (derives) {
        sample.gradient = vector_select(length > 0, vector_scale(out, quotient(real_of(1), length)),
                                        axis_of_largest(v, largest));
    }
    return sample;
}

/** @return The sample of a box around zero. @param p Points. @param half Half its edges.
 *  @param derives Whether the gradient is wanted. */
INLINE FieldSample box_sample(Vector p, Vector half, bool derives) {
    FieldSample sample = corner_sample(vector_subtract(vector_abs(p), half), derives);
    if (derives) {
        sample.gradient = vector_multiply(sample.gradient, vector_signs(p));
    }
    return sample;
}

/** Measures a box. See #FieldCode.run. @param m See there. @param code See there. */
static void box_run(FieldMachine *m, const FieldCode *code) {
    m->sample = box_sample(m->point, vector_from(code->numbers), m->derives);
}

/** @return The nearer of two samples. @param a A sample. @param b Another. @param derives Whether
 *  gradients are wanted. */
INLINE FieldSample sample_nearer(FieldSample a, FieldSample b, bool derives) {
    FieldSample nearer = {.distance = real_min(b.distance, a.distance)};
    if (derives) {
        nearer.gradient = vector_select(b.distance < a.distance, b.gradient, a.gradient);
    }
    return nearer;
}

/** Measures the bars of a frame: of each eighth of space three, which meet in its corner. See
 *  #FieldCode.run. @param m See there. @param code See there. */
static void box_frame_run(FieldMachine *m, const FieldCode *code) {
    real e = real_of(code->numbers[3]);
    Vector thick = {e, e, e};
    Vector p = vector_subtract(vector_abs(m->point), vector_from(code->numbers));
    Vector middle = vector_add(p, thick), q = vector_subtract(vector_abs(middle), thick);
    Vector turn = vector_signs(middle);
    FieldSample bars[3] = {corner_sample((Vector){p.x, q.y, q.z}, m->derives),
                           corner_sample((Vector){q.x, p.y, q.z}, m->derives),
                           corner_sample((Vector){q.x, q.y, p.z}, m->derives)};
    if (m->derives) {
        // Across a bar the distance was folded at its middle.
        const real one = real_of(1);
        Vector turns[3] = {{one, turn.y, turn.z}, {turn.x, one, turn.z}, {turn.x, turn.y, one}};
        for (int i = 0; i < 3; i++) {
            bars[i].gradient = vector_multiply(bars[i].gradient, turns[i]);
        }
    }
    m->sample = sample_nearer(sample_nearer(bars[0], bars[1], m->derives), bars[2], m->derives);
    if (m->derives) {
        m->sample.gradient = vector_multiply(m->sample.gradient, vector_signs(m->point));
    }
}

/** Measures a ring. See #FieldCode.run. @param m See there. @param code See there. */
static void torus_run(FieldMachine *m, const FieldCode *code) {
    Vector p = m->point;
    real axis = real_sqrt(p.x * p.x + p.z * p.z), across = axis - code->numbers[0];
    real length = real_sqrt(across * across + p.y * p.y);
    m->sample.distance = length - code->numbers[1];
    if (m->derives) {
        real outwards = quotient(quotient(across, length), axis);
        m->sample.gradient = (Vector){p.x * outwards, quotient(p.y, length), p.z * outwards};
    }
}

/**
 * @return How deep points are within the holes of one size along one axis: between the two sides of
 *         a hole positive.
 * @param x            Coordinates, in half edges of the sponge.
 * @param per_cell     How many cells are as wide as the sponge.
 * @param[out] slope   1 or -1: how that changes with the coordinate.
 */
INLINE real hole_depth(real x, scalar per_cell, real *slope) {
    real cells = x * per_cell, cell = 2 * real_floor((scalar)0.5f * cells + (scalar)0.5f);
    real in_cell = cells - cell, folded = 3 * real_abs(in_cell) - 2;
    *slope = sign_of(folded) * sign_of(in_cell);
    return (real_abs(folded) - 1) / real_of(3 * per_cell);
}

/** @return What the holes of one size cut out: square, along all three axes; positive inside them.
 *  @param p Points, in half edges of the sponge. @param per_cell Cells as wide as the sponge. */
INLINE FieldSample holes_sample(Vector p, scalar per_cell) {
    Vector slope, depth = {hole_depth(p.x, per_cell, &slope.x), hole_depth(p.y, per_cell, &slope.y),
                           hole_depth(p.z, per_cell, &slope.z)};
    // A point is in a hole along some axis if it is between the sides along the two others: the
    // middle one of three numbers decides.
    real low = real_min(depth.x, depth.y), high = real_max(depth.x, depth.y);
    real middle = real_max(low, real_min(high, depth.z));
    Vector apart = {-real_abs(depth.x - middle), -real_abs(depth.y - middle),
                    -real_abs(depth.z - middle)};
    return (FieldSample){middle, vector_multiply(axis_of_largest(apart, real_of(0)), slope)};
}

/** Measures a sponge: a box without its holes. See #FieldCode.run. @param m See there.
 *  @param code See there. */
static void menger_run(FieldMachine *m, const FieldCode *code) {
    const real one = real_of(1), half = real_of(code->numbers[0]);
    Vector p = vector_scale(m->point, one / half);
    FieldSample sponge = box_sample(p, (Vector){one, one, one}, m->derives);
    scalar per_cell = 1;
    for (int i = 0; i < (int)code->numbers[1]; i++) {
        FieldSample holes = holes_sample(p, per_cell);
        mask is_cut = holes.distance > sponge.distance;
        sponge.distance = real_select(is_cut, holes.distance, sponge.distance);
        if (m->derives) {
            sponge.gradient = vector_select(is_cut, holes.gradient, sponge.gradient);
        }
        per_cell *= 3;
    }
    m->sample = sponge;
    m->sample.distance = sponge.distance * half;
}

/* --- the Mandelbulb --------------------------------------------------------------------------- */

/** LANES complex numbers. */
typedef struct Complex {
    real re; /**< Real part. */
    real im; /**< Imaginary part. */
} Complex;

/** @return a times b. @param a Numbers. @param b Others. */
INLINE Complex complex_multiply(Complex a, Complex b) {
    return (Complex){a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

/** @return z^n, by the binary digits of n. @param z Numbers. @param n At least 1. */
INLINE Complex complex_power(Complex z, int n) {
    Complex power = {real_of(1), real_of(0)};
    for (; n > 0; n /= 2) {
        power = n % 2 ? complex_multiply(power, z) : power;
        z = complex_multiply(z, z);
    }
    return power;
}

/** @return r^n, by the binary digits of n. @param r Numbers. @param n At least 0. */
INLINE real whole_power(real r, int n) {
    real power = real_of(1);
    for (; n > 0; n /= 2) {
        power = n % 2 ? power * r : power;
        r = r * r;
    }
    return power;
}

/** Square roots that bring a number near 1, and terms of the series that then are enough. */
enum { LOGARITHM_ROOTS = 8, LOGARITHM_TERMS = REAL_BITS == 32 ? 4 : REAL_BITS == 64 ? 9 : 19 };

/** @return The natural logarithms: by square roots near to 1, then by 2 (y + y^3/3 + y^5/5 + ...)
 *          of y = (x - 1) / (x + 1). @param x Numbers, 2^-100 to 2^100. */
INLINE real logarithm(real x) {
    const real one = real_of(1);
    for (int i = 0; i < LOGARITHM_ROOTS; i++) {
        x = real_sqrt(x);
    }
    real y = (x - one) / (x + one), square = y * y, sum = real_of(0);
    for (int k = LOGARITHM_TERMS; k >= 0; k--) {
        sum = 1 / real_of((scalar)(2 * k + 1)) + square * sum;
    }
    return 2 * (1 << LOGARITHM_ROOTS) * (y * sum);
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

/** Measures a Mandelbulb. See #FieldCode.run. @param m See there. @param code See there. */
static void mandelbulb_run(FieldMachine *m, const FieldCode *code) {
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

/* --- operations on one field ------------------------------------------------------------------ */

/** Moves the surface outwards. See #FieldCode.run. @param m See there. @param code See there. */
static void round_run(FieldMachine *m, const FieldCode *code) {
    m->sample.distance = m->sample.distance - code->numbers[0];
}

/** @return Three rows of a matrix with a vector. @param rows The matrix. @param v Vectors. */
INLINE Vector rows_apply(const scalar *rows, Vector v) {
    return (Vector){rows[0] * v.x + rows[1] * v.y + rows[2] * v.z,
                    rows[3] * v.x + rows[4] * v.y + rows[5] * v.z,
                    rows[6] * v.x + rows[7] * v.y + rows[8] * v.z};
}

/** @return The same with its columns. @param rows The matrix. @param v Vectors. */
INLINE Vector columns_apply(const scalar *rows, Vector v) {
    return (Vector){rows[0] * v.x + rows[3] * v.y + rows[6] * v.z,
                    rows[1] * v.x + rows[4] * v.y + rows[7] * v.z,
                    rows[2] * v.x + rows[5] * v.y + rows[8] * v.z};
}

/** Scales, turns and moves: the point goes the other way. See #FieldCode.run. @param m See there.
 *  @param code See there. */
static void place_run(FieldMachine *m, const FieldCode *code) {
    const Vector outside = m->point;
    const scalar *n = code->numbers;
    m->point = rows_apply(n, vector_subtract(outside, vector_from(n + 9)));
    field_run(m, code + 1, code->body);
    m->point = outside;
    m->sample.distance = m->sample.distance * n[12];
    if (m->derives) {
        m->sample.gradient = vector_scale(columns_apply(n, m->sample.gradient), real_of(n[12]));
    }
}

/**
 * @return How far points are beside a box, along the axis where it is most; negative inside.
 * @param corners  The box: three lowest coordinates, three highest.
 * @param p        Points.
 */
INLINE real box_beside(const scalar *corners, Vector p) {
    real x = real_max(corners[0] - p.x, p.x - corners[3]);
    real y = real_max(corners[1] - p.y, p.y - corners[4]);
    real z = real_max(corners[2] - p.z, p.z - corners[5]);
    return real_max(x, real_max(y, z));
}

/** @return Distances that are at least those to the field's box: both are bounds of it.
 *  @param distance Distances. @param beside What box_beside() says. */
INLINE real at_least_beside(real distance, real beside) {
    return real_select(beside > 0, real_max(distance, beside), distance);
}

/** The cells of a repeated field around LANES points, along one axis. */
typedef struct Cells {
    real own;    /**< Number of the cell that each is in. */
    real side;   /**< 1 or -1: on which side of its middle. */
    real period; /**< From one to the next; 0: there is one only. */
    real limit;  /**< Number of the last one. */
    int count;   /**< How many are to be asked. */
} Cells;

/** @return The cells around points. @param x Coordinates. @param numbers Those of the step for
 *  this axis: every third. */
INLINE Cells cells_of(real x, const scalar *numbers) {
    real half = real_of(numbers[3]), limit = real_of(numbers[6]);
    if (!(numbers[0] > 0)) {
        return (Cells){real_of(0), real_of(1), real_of(0), real_of(0), 1};
    }
    real own = real_floor(x / real_of(numbers[0]) + ((scalar)0.5f - half)) + half;
    own = real_max(-limit, real_min(own, limit));
    return (Cells){own, sign_of(x - own * numbers[0]), real_of(numbers[0]), limit,
                   1 + (int)numbers[9]};
}

/** @return Coordinates as seen from a cell. @param cells The cells. @param x Coordinates.
 *  @param which 0: the own one, 1: the nearer neighbour, 2: the farther. */
INLINE real cell_local(const Cells *cells, real x, int which) {
    const scalar steps[3] = {0, 1, -1};
    real number = cells->own + cells->side * steps[which];
    number = real_max(-cells->limit, real_min(number, cells->limit));
    return x - number * cells->period;
}

/**
 * Takes a copy of a repeated field into account, if it can be nearer than those so far.
 * @param m        The machine, at the copy's own point.
 * @param code     The step.
 * @param nearest  The nearest so far.
 */
INLINE void copy_run(FieldMachine *m, const FieldCode *code, FieldSample *nearest) {
    const mask all = m->active;
    real beside = box_beside(code->numbers + 12, m->point);
    m->active = all & mask_not((beside > 0) & (beside >= nearest->distance));
    if (any(m->active)) {
        field_run(m, code + 1, code->body);
        real distance = at_least_beside(m->sample.distance, beside);
        mask is_nearer = m->active & (distance < nearest->distance);
        nearest->distance = real_select(is_nearer, distance, nearest->distance);
        if (m->derives) {
            nearest->gradient = vector_select(is_nearer, m->sample.gradient, nearest->gradient);
        }
    }
    m->active = all;
}

/** Repeats a field: the nearest of the copies in the cells around. See #FieldCode.run. @param m See
 *  there. @param code See there. */
static void repeat_run(FieldMachine *m, const FieldCode *code) {
    const Vector p = m->point;
    const real none = real_of(0);
    Cells x = cells_of(p.x, code->numbers), y = cells_of(p.y, code->numbers + 1),
          z = cells_of(p.z, code->numbers + 2);
    FieldSample nearest = {real_of(INFINITE), {none, none, none}};
    for (int i = 0; i < x.count * y.count * z.count; i++) {
        m->point =
            (Vector){cell_local(&x, p.x, i % x.count), cell_local(&y, p.y, i / x.count % y.count),
                     cell_local(&z, p.z, i / x.count / y.count)};
        copy_run(m, code, &nearest);
    }
    m->point = p;
    m->sample = nearest;
}

/* --- operations on two fields ----------------------------------------------------------------- */

/**
 * Runs a body only where it can change something.
 * @param m        The machine.
 * @param code     The step.
 * @param[in,out] matters  Lanes where it may; afterwards those that count.
 * @param beside   How far the points are beside its box.
 * @param[out] body  What it says.
 * @return Whether it was run.
 */
INLINE bool body_run(FieldMachine *m, const FieldCode *code, mask *matters, real beside,
                     FieldSample *body) {
    const mask all = m->active;
    *matters = *matters & all;
    if (!any(*matters)) {
        return false;
    }
    m->active = *matters;
    field_run(m, code + 1, code->body);
    m->active = all;
    *body = m->sample;
    body->distance = at_least_beside(body->distance, beside);
    return true;
}

/** The nearer of two fields. See #FieldCode.run. @param m See there. @param code See there. */
static void union_run(FieldMachine *m, const FieldCode *code) {
    FieldSample first = m->sample, second;
    real beside = box_beside(code->numbers, m->point);
    mask matters = mask_not((beside > 0) & (beside >= first.distance));
    if (body_run(m, code, &matters, beside, &second)) {
        second.distance = real_select(matters, second.distance, first.distance);
        second = sample_nearer(first, second, m->derives);
    } else {
        second = first;
    }
    m->sample = second;
}

/** The nearer of two fields, whose seam is filled. See #FieldCode.run. @param m See there.
 *  @param code See there. */
static void smooth_union_run(FieldMachine *m, const FieldCode *code) {
    FieldSample first = m->sample, second;
    const real radius = real_of(code->numbers[6]), zero = real_of(0);
    real beside = box_beside(code->numbers, m->point);
    mask matters = mask_not((beside > 0) & (beside >= first.distance + radius));
    if (!body_run(m, code, &matters, beside, &second)) {
        m->sample = first;
        return;
    }
    real apart = real_abs(first.distance - second.distance);
    real share = real_max(radius - apart, zero) / radius;
    FieldSample melted = sample_nearer(first, second, m->derives);
    melted.distance = melted.distance - share * share * radius * (scalar)0.25f;
    if (m->derives) {
        // The farther one has half the share.
        mask is_second = second.distance < first.distance;
        Vector far = vector_select(is_second, first.gradient, second.gradient);
        Vector near = vector_scale(melted.gradient, 1 - (scalar)0.5f * share);
        melted.gradient = vector_add(near, vector_scale(far, (scalar)0.5f * share));
    }
    m->sample.distance = real_select(matters, melted.distance, first.distance);
    if (m->derives) {
        m->sample.gradient = vector_select(matters, melted.gradient, first.gradient);
    }
}

/** @return The farther of two samples. @param a A sample. @param b Another. @param derives Whether
 *  gradients are wanted. */
INLINE FieldSample sample_farther(FieldSample a, FieldSample b, bool derives) {
    FieldSample farther = {.distance = real_max(b.distance, a.distance)};
    if (derives) {
        farther.gradient = vector_select(b.distance > a.distance, b.gradient, a.gradient);
    }
    return farther;
}

/** What is in both of two fields. See #FieldCode.run. @param m See there. @param code See there. */
static void intersection_run(FieldMachine *m, const FieldCode *code) {
    FieldSample first = m->sample;
    field_run(m, code + 1, code->body);
    m->sample = sample_farther(first, m->sample, m->derives);
}

/** What is in one field and not in the other. See #FieldCode.run. @param m See there.
 *  @param code See there. */
static void difference_run(FieldMachine *m, const FieldCode *code) {
    FieldSample first = m->sample, second;
    real beside = box_beside(code->numbers, m->point);
    mask matters = mask_not((beside > 0) & (first.distance >= -beside));
    if (body_run(m, code, &matters, beside, &second)) {
        second.distance = real_select(matters, -second.distance, first.distance);
        second.gradient = m->derives ? vector_scale(second.gradient, real_of(-1)) : first.gradient;
        first = sample_farther(first, second, m->derives);
    }
    m->sample = first;
}

/* --- tapes ------------------------------------------------------------------------------------ */

void field_code(FieldCode *codes, const Field *field) {
    static void (*const runs[])(FieldMachine *,
                                const FieldCode *) = {[FIELD_SPHERE] = sphere_run,
                                                      [FIELD_BOX] = box_run,
                                                      [FIELD_BOX_FRAME] = box_frame_run,
                                                      [FIELD_TORUS] = torus_run,
                                                      [FIELD_MENGER] = menger_run,
                                                      [FIELD_MANDELBULB] = mandelbulb_run,
                                                      [FIELD_ROUND] = round_run,
                                                      [FIELD_PLACE] = place_run,
                                                      [FIELD_REPEAT] = repeat_run,
                                                      [FIELD_UNION] = union_run,
                                                      [FIELD_SMOOTH_UNION] = smooth_union_run,
                                                      [FIELD_INTERSECTION] = intersection_run,
                                                      [FIELD_DIFFERENCE] = difference_run};
    for (int i = 0; i < field->count; i++) {
        const FieldStep *step = &field->steps[i];
        codes[i].run = runs[step->operation];
        codes[i].body = step->body;
        for (int n = 0; n < FIELD_NUMBERS; n++) {
            codes[i].numbers[n] = (scalar)step->numbers[n];
        }
    }
}

/** @return What a tape says of points. @param codes The tape. @param count How many steps.
 *  @param point The points. @param active The lanes that count. @param derives Whether gradients
 *  are wanted. */
static FieldSample tape_run(const FieldCode *codes, int count, Vector point, mask active,
                            bool derives) {
    const real zero = real_of(0);
    FieldMachine machine = {
        .point = point, .sample = {zero, {zero, zero, zero}}, .active = active, .derives = derives};
    field_run(&machine, codes, count);
    return machine.sample;
}

real field_distance(const FieldCode *codes, int count, Vector point, mask active) {
    return tape_run(codes, count, point, active, false).distance;
}

FieldSample field_sample(const FieldCode *codes, int count, Vector point, mask active) {
    return tape_run(codes, count, point, active, true);
}
