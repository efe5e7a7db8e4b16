/**
 * @file
 * @brief Judges the laboratory's reference: the same questions in ball arithmetic (Johansson,
 *        *Arb*, 2017), whose every result comes with a bound on its error.
 *
 * Formulas are those of textbooks, with as many bits as they need. Where quad and a ball disagree,
 * or a ball stays undecided, the test says so.
 */
#include "lab/experiments/experiments.h"
#include "testing.h"

#include <math.h>

#include <acb_poly.h>
#include <arb.h>

/** Samples per level and number type. */
enum { SAMPLES = 120 };
/** Bits of the first try, and of the last. */
enum { FIRST_BITS = 256, LAST_BITS = 8192 };
/** Correct bits that a ball must have to judge quad. */
enum { JUDGE_BITS = 160 };
/** Most numbers of a sample's answer. */
enum { ANSWER_NUMBERS = 3 };

/** What a question's answer is. */
typedef enum {
    VERDICT_ANSWER,   /**< Numbers. */
    VERDICT_NONE,     /**< None: the ray misses. */
    VERDICT_UNDECIDED /**< More bits are needed. */
} Verdict;

/** A vector of balls. */
typedef struct ArbVec3 {
    arb_t at[3]; /**< Along x, y and z. */
} ArbVec3;

/** Computes an answer. @param inputs Of the first query. @param[out] answer The balls. */
typedef Verdict TruthFunction(const Quadruple *inputs, arb_t answer[ANSWER_NUMBERS], slong bits);

/* --- vectors of balls ------------------------------------------------------------------------- */

/** Sets a ball to a quad, exactly. */
static void arb_set_quad(arb_t out, Quadruple x) {
    arb_t part;
    arb_init(part);
    arb_zero(out);
    for (int i = 0; i < 3; i++) { // Three doubles have 159 bits.
        double high = (double)x;
        arb_set_d(part, high);
        arb_add(out, out, part, ARF_PREC_EXACT);
        x -= high;
    }
    arb_clear(part);
}

/** Initialises a vector, as zero. */
static void arb_vec3_init(ArbVec3 *v) {
    for (int i = 0; i < 3; i++) {
        arb_init(v->at[i]);
    }
}

/** Releases vectors. */
static void arb_vec3_clear(ArbVec3 *v, int count) {
    for (int i = 0; i < 3 * count; i++) {
        arb_clear(v[i / 3].at[i % 3]);
    }
}

/** Initialises vectors from numbers, three each. */
static void arb_vec3_init_all(ArbVec3 *v, int count, const Quadruple *numbers) {
    for (int i = 0; i < count; i++) {
        arb_vec3_init(&v[i]);
        for (int k = 0; k < 3; k++) {
            arb_set_quad(v[i].at[k], numbers[3 * i + k]);
        }
    }
}

/** a - b. */
static void arb_vec3_subtract(ArbVec3 *out, const ArbVec3 *a, const ArbVec3 *b, slong bits) {
    for (int i = 0; i < 3; i++) {
        arb_sub(out->at[i], a->at[i], b->at[i], bits);
    }
}

/** out + s v. */
static void arb_vec3_add_scaled(ArbVec3 *out, const ArbVec3 *v, const arb_t s, slong bits) {
    for (int i = 0; i < 3; i++) {
        arb_addmul(out->at[i], v->at[i], s, bits);
    }
}

/** The dot product. */
static void arb_vec3_dot(arb_t out, const ArbVec3 *a, const ArbVec3 *b, slong bits) {
    arb_dot(out, NULL, 0, (arb_srcptr)a->at, 1, (arb_srcptr)b->at, 1, 3, bits);
}

/** The cross product. @param out Neither factor. */
static void arb_vec3_cross(ArbVec3 *out, const ArbVec3 *a, const ArbVec3 *b, slong bits) {
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        arb_mul(out->at[i], a->at[j], b->at[k], bits);
        arb_submul(out->at[i], a->at[k], b->at[j], bits);
    }
}

/** Scales a vector to length 1. */
static void arb_vec3_normalize(ArbVec3 *v, slong bits) {
    arb_t length;
    arb_init(length);
    arb_vec3_dot(length, v, v, bits);
    arb_sqrt(length, length, bits);
    for (int i = 0; i < 3; i++) {
        arb_div(v->at[i], v->at[i], length, bits);
    }
    arb_clear(length);
}

/* --- the questions ---------------------------------------------------------------------------- */

/** The nearest root above 0 of a t^2 + 2 b t + c; the three are overwritten. */
static Verdict nearest_root(arb_t a, arb_t b, arb_t c, arb_t root, slong bits) {
    Verdict verdict = VERDICT_UNDECIDED;
    arb_mul(c, c, a, bits);
    arb_neg(c, c);
    arb_addmul(c, b, b, bits); // The discriminant.
    if (arb_is_negative(c)) {
        verdict = VERDICT_NONE;
    } else if (arb_is_positive(c)) {
        arb_sqrt(c, c, bits);
        arb_neg(b, b);
        arb_sub(root, b, c, bits);
        if (arb_is_negative(root)) {
            arb_add(root, b, c, bits);
        }
        verdict = arb_is_positive(root)   ? VERDICT_ANSWER
                  : arb_is_negative(root) ? VERDICT_NONE
                                          : VERDICT_UNDECIDED;
        arb_div(root, root, a, bits);
    }
    return verdict;
}

/** A quadric with an axis: a sphere, or the wall of an upright cylinder. @param is_wall Whether
 *  heights do not count. */
static Verdict quadric_truth(const Quadruple *inputs, arb_t answer[], bool is_wall, slong bits) {
    ArbVec3 v[3]; // Origin, direction, centre.
    arb_t a, b, c, radius;
    arb_vec3_init_all(v, 3, inputs);
    arb_init(a), arb_init(b), arb_init(c), arb_init(radius);
    arb_vec3_subtract(&v[0], &v[0], &v[2], bits);
    if (is_wall) {
        arb_zero(v[0].at[1]);
        arb_zero(v[1].at[1]);
    }
    arb_set_quad(radius, inputs[9]);
    arb_vec3_dot(a, &v[1], &v[1], bits);
    arb_vec3_dot(b, &v[0], &v[1], bits);
    arb_vec3_dot(c, &v[0], &v[0], bits);
    arb_submul(c, radius, radius, bits);
    Verdict verdict = nearest_root(a, b, c, answer[0], bits);
    arb_clear(a), arb_clear(b), arb_clear(c), arb_clear(radius);
    arb_vec3_clear(v, 3);
    return verdict;
}

/** Is a #TruthFunction: the distance of a sphere. */
static Verdict sphere_truth(const Quadruple *inputs, arb_t answer[], slong bits) {
    return quadric_truth(inputs, answer, false, bits);
}

/** Is a #TruthFunction: the distance of a cylinder's wall. */
static Verdict wall_truth(const Quadruple *inputs, arb_t answer[], slong bits) {
    return quadric_truth(inputs, answer, true, bits);
}

/** Is a #TruthFunction: the distance of a plane. */
static Verdict plane_truth(const Quadruple *inputs, arb_t answer[], slong bits) {
    ArbVec3 v[4]; // Origin, direction, point, normal.
    arb_t slope;
    arb_vec3_init_all(v, 4, inputs);
    arb_init(slope);
    arb_vec3_subtract(&v[2], &v[2], &v[0], bits);
    arb_vec3_dot(answer[0], &v[2], &v[3], bits);
    arb_vec3_dot(slope, &v[1], &v[3], bits);
    arb_div(answer[0], answer[0], slope, bits);
    arb_clear(slope);
    arb_vec3_clear(v, 4);
    return arb_is_finite(answer[0]) ? VERDICT_ANSWER : VERDICT_UNDECIDED;
}

/** Is a #TruthFunction: the distance of a triangle, by its plane and the signs of the volumes that
 *  the ray makes with its edges. */
static Verdict triangle_truth(const Quadruple *inputs, arb_t answer[], slong bits) {
    ArbVec3 v[5], normal, edge, cross; // Origin, direction, three corners.
    arb_t slope, volume;
    int positive = 0, negative = 0;
    arb_vec3_init_all(v, 5, inputs);
    arb_vec3_init(&normal), arb_vec3_init(&edge), arb_vec3_init(&cross);
    arb_init(slope), arb_init(volume);
    for (int i = 2; i < 5; i++) {
        arb_vec3_subtract(&v[i], &v[i], &v[0], bits);
    }
    for (int i = 0; i < 3; i++) {
        arb_vec3_cross(&cross, &v[2 + i], &v[2 + (i + 1) % 3], bits);
        arb_vec3_dot(volume, &cross, &v[1], bits);
        positive += arb_is_positive(volume);
        negative += arb_is_negative(volume);
    }
    arb_vec3_subtract(&edge, &v[3], &v[2], bits);
    arb_vec3_subtract(&cross, &v[4], &v[2], bits);
    arb_vec3_cross(&normal, &edge, &cross, bits);
    arb_vec3_dot(answer[0], &normal, &v[2], bits);
    arb_vec3_dot(slope, &normal, &v[1], bits);
    arb_div(answer[0], answer[0], slope, bits);
    Verdict verdict = positive > 0 && negative > 0     ? VERDICT_NONE
                      : positive == 3 || negative == 3 ? VERDICT_ANSWER
                                                       : VERDICT_UNDECIDED;
    arb_clear(slope), arb_clear(volume);
    arb_vec3_clear(&normal, 1), arb_vec3_clear(&edge, 1), arb_vec3_clear(&cross, 1);
    arb_vec3_clear(v, 5);
    return verdict;
}

/** Is a #TruthFunction: the polar angle of a point on a sphere. */
static Verdict angle_truth(const Quadruple *inputs, arb_t answer[], slong bits) {
    ArbVec3 v[2]; // Point, centre.
    arb_vec3_init_all(v, 2, inputs);
    arb_vec3_subtract(&v[0], &v[0], &v[1], bits);
    arb_set(v[1].at[1], v[0].at[1]);
    arb_zero(v[0].at[1]);
    arb_vec3_dot(answer[0], &v[0], &v[0], bits);
    arb_sqrt(answer[0], answer[0], bits);
    arb_atan2(answer[0], answer[0], v[1].at[1], bits);
    arb_vec3_clear(v, 2);
    return VERDICT_ANSWER;
}

/** Adds half the square of (x - y) / (x + y). */
static void arb_add_polarisation(arb_t out, const arb_t x, const arb_t y, slong bits) {
    arb_t difference, sum;
    arb_init(difference), arb_init(sum);
    arb_sub(difference, x, y, bits);
    arb_add(sum, x, y, bits);
    arb_div(difference, difference, sum, bits);
    arb_mul(difference, difference, difference, bits);
    arb_mul_2exp_si(difference, difference, -1);
    arb_add(out, out, difference, bits);
    arb_clear(difference), arb_clear(sum);
}

/** Is a #TruthFunction: the reflectance of glass, with the refracted angle's cosine from its sine.
 */
static Verdict fresnel_truth(const Quadruple *inputs, arb_t answer[], slong bits) {
    arb_t cosine, index, beyond, x, y;
    arb_init(cosine), arb_init(index), arb_init(beyond), arb_init(x), arb_init(y);
    arb_set_quad(cosine, inputs[0]);
    arb_set_quad(index, inputs[1]);
    arb_mul(x, cosine, cosine, bits);
    arb_sub_si(x, x, 1, bits);
    arb_mul(y, index, index, bits);
    arb_div(beyond, x, y, bits);
    arb_add_si(beyond, beyond, 1, bits);
    Verdict verdict = arb_is_positive(beyond) ? VERDICT_ANSWER : VERDICT_UNDECIDED;
    arb_sqrt(beyond, beyond, bits);
    arb_zero(answer[0]);
    arb_mul(x, index, beyond, bits);
    arb_add_polarisation(answer[0], cosine, x, bits);
    arb_mul(y, index, cosine, bits);
    arb_add_polarisation(answer[0], y, beyond, bits);
    arb_clear(cosine), arb_clear(index), arb_clear(beyond), arb_clear(x), arb_clear(y);
    return verdict;
}

/** Is a #TruthFunction: the distance of a disk. */
static Verdict disk_truth(const Quadruple *inputs, arb_t answer[], slong bits) {
    ArbVec3 v[4]; // Origin, direction, centre, normal.
    arb_t slope, radius;
    arb_vec3_init_all(v, 4, inputs);
    arb_init(slope), arb_init(radius);
    arb_vec3_subtract(&v[2], &v[2], &v[0], bits);
    arb_vec3_dot(answer[0], &v[2], &v[3], bits);
    arb_vec3_dot(slope, &v[1], &v[3], bits);
    arb_div(answer[0], answer[0], slope, bits);
    arb_neg(slope, answer[0]);
    arb_vec3_add_scaled(&v[2], &v[1], slope, bits); // From the point to the centre.
    arb_set_quad(radius, inputs[12]);
    arb_vec3_dot(slope, &v[2], &v[2], bits);
    arb_submul(slope, radius, radius, bits);
    Verdict verdict = arb_is_negative(slope)   ? VERDICT_ANSWER
                      : arb_is_positive(slope) ? VERDICT_NONE
                                               : VERDICT_UNDECIDED;
    arb_clear(slope), arb_clear(radius);
    arb_vec3_clear(v, 4);
    return verdict;
}

/** Is a #TruthFunction: the distance of an ellipsoid. */
static Verdict ellipsoid_truth(const Quadruple *inputs, arb_t answer[], slong bits) {
    ArbVec3 v[4]; // Origin, direction, centre, half-axes.
    arb_t a, b, c;
    arb_vec3_init_all(v, 4, inputs);
    arb_init(a), arb_init(b), arb_init(c);
    arb_vec3_subtract(&v[0], &v[0], &v[2], bits);
    for (int i = 0; i < 6; i++) {
        arb_div(v[i / 3].at[i % 3], v[i / 3].at[i % 3], v[3].at[i % 3], bits);
    }
    arb_vec3_dot(a, &v[1], &v[1], bits);
    arb_vec3_dot(b, &v[0], &v[1], bits);
    arb_vec3_dot(c, &v[0], &v[0], bits);
    arb_sub_si(c, c, 1, bits);
    Verdict verdict = nearest_root(a, b, c, answer[0], bits);
    arb_clear(a), arb_clear(b), arb_clear(c);
    arb_vec3_clear(v, 4);
    return verdict;
}

/** Sets the quartic (p.p + R^2 - r^2)^2 - 4 R^2 (p.x^2 + p.y^2), p = o + t d, of a torus. */
static void torus_quartic(acb_poly_t quartic, const Quadruple *inputs, slong bits) {
    ArbVec3 v[3]; // Origin, direction, centre.
    arb_poly_t coordinate, squares[3], real;
    arb_t radius;
    arb_vec3_init_all(v, 3, inputs);
    arb_vec3_subtract(&v[0], &v[0], &v[2], bits);
    arb_poly_init(coordinate), arb_poly_init(real);
    arb_init(radius);
    for (int i = 0; i < 3; i++) {
        arb_poly_init(squares[i]);
        arb_poly_set_coeff_arb(coordinate, 0, v[0].at[i]);
        arb_poly_set_coeff_arb(coordinate, 1, v[1].at[i]);
        arb_poly_mul(squares[i], coordinate, coordinate, bits);
    }
    arb_poly_add(squares[0], squares[0], squares[1], bits);
    arb_poly_add(real, squares[0], squares[2], bits);
    arb_set_quad(radius, inputs[12] * inputs[12] - inputs[13] * inputs[13]); // Exact: few bits.
    arb_poly_set_arb(squares[1], radius);
    arb_poly_add(real, real, squares[1], bits);
    arb_poly_mul(real, real, real, bits);
    arb_set_quad(radius, 4 * inputs[12] * inputs[12]);
    arb_poly_scalar_mul(squares[0], squares[0], radius, bits);
    arb_poly_sub(real, real, squares[0], bits);
    acb_poly_set_arb_poly(quartic, real);
    for (int i = 0; i < 3; i++) {
        arb_poly_clear(squares[i]);
    }
    arb_poly_clear(coordinate), arb_poly_clear(real);
    arb_clear(radius);
    arb_vec3_clear(v, 3);
}

/** Is a #TruthFunction: the distance of a torus, by all roots of its quartic. */
static Verdict torus_truth(const Quadruple *inputs, arb_t answer[], slong bits) {
    acb_poly_t quartic;
    acb_poly_init(quartic);
    torus_quartic(quartic, inputs, bits);
    acb_ptr roots = _acb_vec_init(4);
    Verdict verdict = VERDICT_UNDECIDED;
    // Only roots that are isolated come back all at once; then a ball on the real axis is real.
    if (acb_poly_find_roots(roots, quartic, NULL, 0, bits) == 4 &&
        acb_poly_validate_real_roots(roots, quartic, bits)) {
        verdict = VERDICT_NONE;
        for (int i = 0; i < 4; i++) {
            bool is_real = arb_contains_zero(acb_imagref(&roots[i]));
            if (is_real && arb_is_positive(acb_realref(&roots[i])) &&
                (verdict == VERDICT_NONE || arb_lt(acb_realref(&roots[i]), answer[0]))) {
                arb_set(answer[0], acb_realref(&roots[i]));
                verdict = VERDICT_ANSWER;
            }
        }
    }
    _acb_vec_clear(roots, 4);
    acb_poly_clear(quartic);
    return verdict;
}

/** Finds the nearest of four spheres. @param from The sphere that the ray leaves; -1: none.
 *  @param[out] nearest Its distance.
 *  @return Its index; -1: none; -2: undecided. */
static int nearest_of_four(const ArbVec3 *ray, const ArbVec3 *centers, const arb_t radius, int from,
                           arb_t nearest, slong bits) {
    ArbVec3 f;
    arb_t a, b, c, t;
    int found = -1;
    arb_vec3_init(&f);
    arb_init(a), arb_init(b), arb_init(c), arb_init(t);
    for (int i = 0; i < 4 && found > -2; i++) {
        arb_vec3_subtract(&f, &ray[0], &centers[i], bits);
        arb_vec3_dot(a, &ray[1], &ray[1], bits);
        arb_vec3_dot(b, &f, &ray[1], bits);
        arb_vec3_dot(c, &f, &f, bits);
        arb_submul(c, radius, radius, bits);
        Verdict verdict = i == from ? VERDICT_NONE : nearest_root(a, b, c, t, bits);
        if (verdict == VERDICT_UNDECIDED ||
            (found >= 0 && verdict == VERDICT_ANSWER && arb_overlaps(t, nearest))) {
            found = -2;
        } else if (verdict == VERDICT_ANSWER && (found < 0 || arb_lt(t, nearest))) {
            arb_set(nearest, t);
            found = i;
        }
    }
    arb_vec3_clear(&f, 1);
    arb_clear(a), arb_clear(b), arb_clear(c), arb_clear(t);
    return found;
}

/** Is a #TruthFunction: the direction after many reflections between four spheres. */
static Verdict bounces_truth(const Quadruple *inputs, arb_t answer[], slong bits) {
    ArbVec3 v[6], normal; // Origin, direction, four centres.
    arb_t radius, t;
    int sphere = -1;
    arb_vec3_init_all(v, 6, inputs);
    arb_vec3_init(&normal);
    arb_init(radius), arb_init(t);
    arb_set_quad(radius, inputs[18]);
    arb_vec3_normalize(&v[1], bits);
    for (int i = 0; i < (int)inputs[19] && (i == 0 || sphere >= 0); i++) {
        sphere = nearest_of_four(v, v + 2, radius, sphere, t, bits);
        if (sphere >= 0) {
            arb_vec3_add_scaled(&v[0], &v[1], t, bits);
            arb_vec3_subtract(&normal, &v[0], &v[2 + sphere], bits);
            arb_vec3_normalize(&normal, bits);
            arb_vec3_dot(t, &normal, &v[1], bits);
            arb_mul_si(t, t, -2, bits);
            arb_vec3_add_scaled(&v[1], &normal, t, bits);
        }
    }
    for (int i = 0; i < 3; i++) {
        arb_set(answer[i], v[1].at[i]);
    }
    arb_clear(radius), arb_clear(t);
    arb_vec3_clear(&normal, 1);
    arb_vec3_clear(v, 6);
    return sphere >= 0 ? VERDICT_ANSWER : sphere == -1 ? VERDICT_NONE : VERDICT_UNDECIDED;
}

/* --- the judge -------------------------------------------------------------------------------- */

/** A reference that is judged, and what it claims. */
typedef struct Claim {
    const Experiment *experiment; /**< Whose reference. */
    TruthFunction *truth;         /**< The same question. */
    int numbers;                  /**< Numbers of an answer. */
    double ulps;                  /**< Largest error of the reference, ulps of double. */
} Claim;

/**
 * A hundredth of half an ulp of long double, the widest type that quad is held against in charts:
 * 2^-64 / 100, in ulps of double.
 */
#define NEGLIGIBLE 2.4e-6

/** All references that are formulas. The others count: leaks, steps, second hits. */
static const Claim claims[] = {
    {&sphere_distance_experiment, sphere_truth, 1, NEGLIGIBLE},
    {&sphere_offset_experiment, sphere_truth, 1, NEGLIGIBLE},
    {&sphere_scale_experiment, sphere_truth, 1, NEGLIGIBLE},
    {&sphere_ground_experiment, sphere_truth, 1, NEGLIGIBLE},
    {&cylinder_distance_experiment, wall_truth, 1, NEGLIGIBLE},
    {&plane_angle_experiment, plane_truth, 1, NEGLIGIBLE},
    {&plane_point_experiment, plane_truth, 1, NEGLIGIBLE},
    {&triangle_small_experiment, triangle_truth, 1, NEGLIGIBLE},
    {&triangle_thin_experiment, triangle_truth, 1, NEGLIGIBLE},
    {&sphere_pole_experiment, angle_truth, 1, NEGLIGIBLE},
    {&fresnel_into_experiment, fresnel_truth, 1, NEGLIGIBLE},
    {&fresnel_out_experiment, fresnel_truth, 1, NEGLIGIBLE},
    {&disk_distance_experiment, disk_truth, 1, NEGLIGIBLE},
    {&ellipsoid_distance_experiment, ellipsoid_truth, 1, NEGLIGIBLE},
    {&torus_distance_experiment, torus_truth, 1, NEGLIGIBLE},
    {&mirror_bounces_experiment, bounces_truth, 3, NEGLIGIBLE},
};

/** What a judge finds. */
typedef struct Findings {
    double worst;     /**< Largest error of the reference, ulps of double. */
    double level;     /**< Where. */
    size_t judged;    /**< Samples. */
    size_t disagreed; /**< Samples where quad and the balls differ on whether there is an answer. */
    size_t undecided; /**< Samples that #LAST_BITS bits do not decide. */
} Findings;

/** @return Whether all balls are narrow enough. */
static bool is_sharp(const Claim *claim, arb_t answer[]) {
    bool is_all = true;
    for (int i = 0; i < claim->numbers; i++) {
        is_all = is_all && arb_rel_accuracy_bits(answer[i]) >= JUDGE_BITS;
    }
    return is_all;
}

/** @return The error of a reference, relative to its largest number, ulps of double. */
static double error_ulps(const Claim *claim, const Quadruple *expected, arb_t answer[]) {
    double error = 0, size = 0;
    arb_t difference;
    arf_t bound;
    arb_init(difference);
    arf_init(bound);
    for (int i = 0; i < claim->numbers; i++) {
        arb_set_quad(difference, expected[i]);
        arb_sub(difference, difference, answer[i], LAST_BITS);
        arb_get_abs_ubound_arf(bound, difference, 53);
        error = fmax(error, arf_get_d(bound, ARF_RND_UP));
        size = fmax(size, fabs((double)expected[i]));
    }
    arb_clear(difference);
    arf_clear(bound);
    return ldexp(error / size, 52);
}

/** Judges a sample. */
static void judge_sample(const Claim *claim, const ExperimentSample *sample, double level,
                         Findings *findings) {
    arb_t answer[ANSWER_NUMBERS];
    Verdict verdict = VERDICT_UNDECIDED;
    const Quadruple *expected = sample->expected;
    bool is_expected = expected[0] < QUAD_NO_HIT; // Neither infinite nor NaN.
    for (int i = 0; i < ANSWER_NUMBERS; i++) {
        arb_init(answer[i]);
    }
    for (slong bits = FIRST_BITS; bits <= LAST_BITS && verdict == VERDICT_UNDECIDED; bits *= 2) {
        verdict = claim->truth(sample->inputs, answer, bits);
        if (verdict == VERDICT_ANSWER && !is_sharp(claim, answer)) {
            verdict = VERDICT_UNDECIDED;
        }
    }
    findings->judged++;
    findings->undecided += verdict == VERDICT_UNDECIDED;
    findings->disagreed +=
        verdict != VERDICT_UNDECIDED && (verdict == VERDICT_ANSWER) != is_expected;
    if (verdict == VERDICT_ANSWER && is_expected) {
        double error = error_ulps(claim, expected, answer);
        if (error > findings->worst) {
            findings->worst = error;
            findings->level = level;
        }
    }
    for (int i = 0; i < ANSWER_NUMBERS; i++) {
        arb_clear(answer[i]);
    }
}

/** Judges a reference at all levels, for inputs in float and in double. */
static Findings judge(const Claim *claim) {
    Findings findings = {0};
    const Experiment *e = claim->experiment;
    for (size_t i = 0; i < 2 * e->level_count; i++) {
        ExperimentSetup setup = {number_types()[i % 2], e->levels[i / 2], NULL};
        Random random = {20261122};
        for (int n = 0; n < SAMPLES; n++) {
            ExperimentSample sample = {{0}, {0}};
            e->generate(&setup, &random, &sample);
            judge_sample(claim, &sample, setup.level, &findings);
        }
    }
    return findings;
}

/** Every reference is as exact as it claims. */
static void test_references(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof claims / sizeof *claims; i++) {
        const char *name = claims[i].experiment->name;
        Findings found = judge(&claims[i]);
        print_message("worst errors of the reference of %s, ulps of double: %.2g at %g; quad is "
                      "unsure of %zu answers of %zu\n",
                      name, found.worst, found.level, found.disagreed + found.undecided,
                      found.judged);
        assert_at_most(found.worst, claims[i].ulps, "%s", name);
        assert_int_equal(found.disagreed, 0);
        assert_int_equal(found.undecided, 0);
    }
}

/** The judge notices a reference that is off by its claim, and one that says the opposite. */
static void test_judge(void **state) {
    (void)state;
    ExperimentSetup setup = {number_types()[0], 10, NULL};
    ExperimentSample sample = {{0}, {0}};
    Random random = {1};
    Findings found = {0};
    do {
        sphere_distance_experiment.generate(&setup, &random, &sample);
    } while (!(sample.expected[0] < QUAD_NO_HIT));
    sample.expected[0] *= 1 + (Quadruple)ldexp(2 * NEGLIGIBLE, -52);
    judge_sample(&claims[0], &sample, 10, &found);
    assert_true(found.worst > NEGLIGIBLE && found.worst < 4 * NEGLIGIBLE);
    assert_int_equal(found.disagreed, 0);
    sample.expected[0] = QUAD_NO_HIT;
    judge_sample(&claims[0], &sample, 10, &found);
    assert_int_equal(found.disagreed, 1);
    // A ray that touches: no number of bits decides.
    const Quadruple touching[10] = {0, 1, -2, 0, 0, 1, 0, 0, 0, 1};
    memcpy(sample.inputs, touching, sizeof touching);
    judge_sample(&claims[0], &sample, 10, &found);
    assert_int_equal(found.undecided, 1);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_references),
                                       cmocka_unit_test(test_judge)};
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    flint_cleanup();
    return failed;
}
