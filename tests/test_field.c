/**
 * @file
 * @brief Distance fields keep what they promise: none changes faster than the point moves, exact
 * ones say the very distance, their derivatives are theirs, and bad ones are refused.
 *
 * The tape is compiled into this test in double, one lane.
 */
#define REAL_BITS 64
#define LANES 1
#include "../src/trace/field.c"
#include "../src/trace/field_bulb.c"
#include "../src/trace/field_solids.c"

#include "field_making.h"

/** Pairs of points for each field. */
enum { PAIRS = 1000000 };
/** Points for each field whose truth is known. */
enum { POINTS = 100000 };

/** A field under test. */
typedef struct Subject {
    const char *name; /**< Its name. */
    Field *field;     /**< The field; owned. */
    FieldCode *codes; /**< Its tape; owned. */
    double size;      /**< How far from zero it is tried. */
    /** @return The true distance of a point outside; NULL: it is a bound. @param p The point. */
    double (*truth)(Vector3 p);
} Subject;

/* --- truths, by formulas of their own ----------------------------------------------------------
 */

/** @return Distance of a point to a box by its nearest point. @param p The point. @param low Lowest
 *  corner. @param high Highest. */
static double box_distance(Vector3 p, Vector3 low, Vector3 high) {
    Vector3 nearest = vector3_lowest(vector3_highest(p, low), high);
    return vector3_length(vector3_subtract(p, nearest));
}

/** @return See #Subject.truth: a ball of radius 1. @param p See there. */
static double sphere_truth(Vector3 p) {
    return fmax(vector3_length(p) - 1, 0);
}

/** @return See #Subject.truth: a box of 1, 2, 3. @param p See there. */
static double box_truth(Vector3 p) {
    return box_distance(p, (Vector3){-0.5, -1, -1.5}, (Vector3){0.5, 1, 1.5});
}

/** @return See #Subject.truth: a frame of 1, 2, 3 with bars of 0.25: all 12. @param p See there. */
static double frame_truth(Vector3 p) {
    const double half[3] = {0.5, 1, 1.5}, thick = 0.25;
    double least = HUGE_VAL;
    for (int n = 0; n < 12; n++) {
        int along = n / 4;
        double low[3], high[3];
        for (int axis = 0; axis < 3; axis++) {
            bool is_up = axis == (along + 1) % 3 ? n & 1 : n & 2;
            low[axis] = axis == along || !is_up ? -half[axis] : half[axis] - thick;
            high[axis] = axis == along || is_up ? half[axis] : -half[axis] + thick;
        }
        Vector3 a = {low[0], low[1], low[2]}, b = {high[0], high[1], high[2]};
        least = fmin(least, box_distance(p, a, b));
    }
    return least;
}

/** @return See #Subject.truth: a ring of 1 and 0.25, by its nearest middle. @param p See there. */
static double torus_truth(Vector3 p) {
    double axis = hypot(p.x, p.z), turn = atan2(p.z, p.x);
    Vector3 middle = {cos(turn), 0, sin(turn)};
    return fmax(vector3_length(vector3_subtract(p, axis > 0 ? middle : (Vector3){1, 0, 0})) - 0.25,
                0);
}

/** @return See #Subject.truth: small boxes beside the middle of cells of 1, all 125 around.
 *  @param p See there. */
static double boxes_truth(Vector3 p) {
    double least = HUGE_VAL;
    for (int n = 0; n < 125; n++) {
        Vector3 cell = {round(p.x) + n % 5 - 2, round(p.y) + n / 5 % 5 - 2,
                        round(p.z) + n / 25 - 2};
        Vector3 low = vector3_add(cell, (Vector3){0.2, -0.1, -0.45});
        Vector3 high = vector3_add(cell, (Vector3){0.5, 0.2, -0.25});
        least = fmin(least, box_distance(p, low, high));
    }
    return least;
}

/** @return See #Subject.truth: balls of 0.75 in cells of 1, five by four by one. @param p See
 * there.
 */
static double balls_truth(Vector3 p) {
    double least = HUGE_VAL;
    for (int n = 0; n < 20; n++) {
        Vector3 center = {n % 5 - 2, n / 5 - 1.5, 0};
        least = fmin(least, vector3_length(vector3_subtract(p, center)) - 0.75);
    }
    return fmax(least, 0);
}

/* --- the fields ---------------------------------------------------------------------------------
 */

/** Numbers of the fields, as the scene language has them. */
static const struct {
    double sphere;    /**< Radius. */
    double ring[2];   /**< Major and minor. */
    double box[4];    /**< Edges, and how thick bars are. */
    double little[4]; /**< The same of a little box. */
} numbers = {1, {1, 0.25}, {1, 2, 3, 0.25}, {0.3, 0.3, 0.2, 0}};

/** Turned and moved. */
static const Transform leaning = {
    .scale = {2, 2, 2}, .rotate = {30, 45, 60}, .translate = {0.5, -1, 0.25}};

/** @return A little box beside zero. */
static Field *little_box(void) {
    return moved(single("box", numbers.little), 0.35, 0.05, -0.35);
}

/** The fields under test. */
static Subject subjects[16];
/** How many. */
static size_t subject_count;

/** Adds a field. @param name Its name. @param field It; taken. @param size How far it is tried.
 *  @param truth Its truth, or NULL. */
static void add(const char *name, Field *field, double size, double (*truth)(Vector3)) {
    Subject *subject = &subjects[subject_count++];
    *subject = (Subject){name, field, calloc((size_t)field->count, sizeof(FieldCode)), size, truth};
    field_code(subject->codes, field);
    assert_int_equal(field->is_exact, truth != NULL);
}

/** Makes the fields. @param state Not used. @return 0 */
static int start(void **state) {
    (void)state;
    const double *box = numbers.box;
    add("sphere", single("sphere", &numbers.sphere), 3, sphere_truth);
    add("box", single("box", box), 3, box_truth);
    add("box frame", single("box_frame", box), 3, frame_truth);
    add("torus", single("torus", numbers.ring), 3, torus_truth);
    add("repeated boxes", repeated(little_box(), (FieldRepeat){{1, 1, 1}, {0, 0, 0}}), 3,
        boxes_truth);
    Field *ball = placed(single("sphere", &numbers.sphere), (Transform){.scale = {.75, .75, .75}});
    add("counted balls", repeated(ball, (FieldRepeat){{1, 1, 1}, {5, 4, 1}}), 4, balls_truth);
    add("Menger sponge", single("menger", NULL), 1, NULL);
    add("Mandelbulb", single("mandelbulb", NULL), 1.5, NULL);
    add("Mandelbulb, coarse", single("mandelbulb", (int[]){8, 4}), 1.5, NULL);
    add("Mandelbulb of power 2", single("mandelbulb", (int[]){2, 10}), 2.5, NULL);
    add("leaning sponge", placed(single("menger", NULL), leaning), 3, NULL);
    add("smooth union",
        joined(FIELD_JOIN_SMOOTH, single("box", box),
               moved(single("sphere", &numbers.sphere), 1, 0, 0), 0.5),
        3, NULL);
    add("intersection",
        joined(FIELD_JOIN_INTERSECTION, placed(single("box", box), leaning),
               single("torus", numbers.ring), 0),
        3, NULL);
    add("difference",
        joined(FIELD_JOIN_DIFFERENCE, single("box", box),
               repeated(little_box(), (FieldRepeat){{1, 1, 0}, {0, 3, 0}}), 0),
        3, NULL);
    add("rounded sponge", round_off(placed(single("menger", NULL), leaning), 0.05), 3, NULL);
    return 0;
}

/** Gives the fields back. @param state Not used. @return 0 */
static int stop(void **state) {
    (void)state;
    for (size_t i = 0; i < subject_count; i++) {
        free(subjects[i].field);
        free(subjects[i].codes);
    }
    return 0;
}

/** @return What a field says. @param subject The field. @param p Where. */
static double says(const Subject *subject, Vector3 p) {
    return field_distance(subject->codes, subject->field->count, vector_of(p), 1);
}

/** @return A point in a cube around zero. @param[in,out] seed A generator. @param size Half its
 *  edge. */
static Vector3 random_point(uint64_t *seed, double size) {
    return (Vector3){size * (2 * random_share(seed) - 1), size * (2 * random_share(seed) - 1),
                     size * (2 * random_share(seed) - 1)};
}

/* --- the promises -------------------------------------------------------------------------------
 */

/** @return Whether a field is a Mandelbulb. @param subject The field. */
static bool is_bulb(const Subject *subject) {
    return subject->field->steps[0].operation == FIELD_MANDELBULB;
}

/** @return The share of points from which a step that the field allows leads into its solid.
 *  @param subject The field. */
static double false_steps(const Subject *subject) {
    uint64_t seed = 1;
    int tried = 0, wrong = 0;
    while (tried < PAIRS) {
        Vector3 p = random_point(&seed, subject->size), way = random_point(&seed, 1);
        double allowed = says(subject, p), length = vector3_length(way);
        if (allowed > 0 && length > 0) {
            way = vector3_scale(way, random_share(&seed) * allowed / length);
            wrong += says(subject, vector3_add(p, way)) < 0;
            tried++;
        }
    }
    return (double)wrong / tried;
}

/** The Mandelbulb is a bound up to four iterations; then it grows hairs that its estimate does not
 *  see in one of ten thousand places. @param state Not used. */
static void test_mandelbulb(void **state) {
    (void)state;
    for (size_t i = 0; i < subject_count; i++) {
        if (is_bulb(&subjects[i])) {
            bool is_coarse = subjects[i].field->steps[0].numbers[1] <= 4;
            double share = false_steps(&subjects[i]);
            printf("  %-22s steps into it: %g\n", subjects[i].name, share);
            assert_at_most(share, is_coarse ? 0 : 2e-4, "%s, steps into it", subjects[i].name);
        }
    }
}

/** |f(p) - f(q)| <= |p - q|, near and far, on the surface and off it. @param state Not used. */
static void test_lipschitz(void **state) {
    (void)state;
    for (size_t i = 0; i < subject_count; i++) {
        const Subject *subject = &subjects[i];
        uint64_t seed = i;
        double worst = 0;
        if (is_bulb(subject)) {
            continue; // An estimate: see test_mandelbulb().
        }
        for (int n = 0; n < PAIRS; n++) {
            Vector3 p = random_point(&seed, subject->size);
            double far = subject->size * exp(-14 * random_share(&seed));
            Vector3 step = random_point(&seed, far), q = vector3_add(p, step);
            double length = vector3_length(vector3_subtract(q, p));
            double change = fabs(says(subject, p) - says(subject, q));
            // The roundings of points and distances, too.
            worst = fmax(worst, (change - 1e-14 * subject->size) / length);
        }
        printf("  %-22s |f(p) - f(q)| / |p - q| at most %.9f\n", subject->name, worst);
        assert_at_most(worst, 1 + 1e-9, "%s, change over way", subject->name);
    }
}

/** Exact fields say the distance; bounds are not asked. @param state Not used. */
static void test_truth(void **state) {
    (void)state;
    for (size_t i = 0; i < subject_count; i++) {
        const Subject *subject = &subjects[i];
        uint64_t seed = i;
        for (int n = 0; subject->truth && n < POINTS; n++) {
            Vector3 p = random_point(&seed, subject->size);
            double truth = subject->truth(p), said = says(subject, p);
            assert_at_most(fabs(fmax(said, 0) - truth), 1e-14, "%s at %g %g %g", subject->name, p.x,
                           p.y, p.z);
        }
    }
}

/** No solid reaches out of its box: outside, the field is at least the distance over its slack.
 *  @param state Not used. */
static void test_boxes(void **state) {
    (void)state;
    for (size_t i = 0; i < subject_count; i++) {
        const Subject *subject = &subjects[i];
        const Field *field = subject->field;
        uint64_t seed = i;
        for (int n = 0; n < POINTS; n++) {
            Vector3 p = random_point(&seed, 2 * subject->size);
            double beside = box_distance(p, field->low, field->high);
            assert_at_most(beside / field->slack - 1e-14, fmax(says(subject, p), 0),
                           "%s beside its box", subject->name);
        }
    }
}

/** Derivatives that are carried along agree with differences. @param state Not used. */
static void test_gradients(void **state) {
    (void)state;
    const double h = 1e-6;
    for (size_t i = 0; i < subject_count; i++) {
        const Subject *subject = &subjects[i];
        uint64_t seed = i;
        int wrong = 0;
        for (int n = 0; n < POINTS / 10; n++) {
            Vector3 p = random_point(&seed, subject->size);
            FieldSample here = field_sample(subject->codes, subject->field->count, vector_of(p), 1);
            assert_true(here.distance == says(subject, p));
            const double carried[3] = {here.gradient.x, here.gradient.y, here.gradient.z};
            for (int axis = 0; axis < 3; axis++) {
                Vector3 step = {axis == 0 ? h : 0, axis == 1 ? h : 0, axis == 2 ? h : 0};
                double up = says(subject, vector3_add(p, step));
                double down = says(subject, vector3_subtract(p, step));
                wrong += !(fabs((up - down) / (2 * h) - carried[axis]) < 1e-4);
            }
        }
        // Between two points of a difference there may be an edge; a Mandelbulb has them
        // everywhere.
        double share = is_bulb(subject) ? 0.1 : 2e-4;
        printf("  %-22s gradients unlike differences: %g\n", subject->name, wrong / (0.3 * POINTS));
        assert_at_most(wrong / (0.3 * POINTS), share, "%s, gradients", subject->name);
    }
}

/* --- limits --------------------------------------------------------------------------------------
 */

/** Ten thousand fields are refused; a long chain of unions is not deep. @param state Not used. */
static void test_limits(void **state) {
    (void)state;
    Error error = {0};
    Field *chain = single("sphere", NULL);
    for (int n = 1; n < 200; n++) {
        chain = joined(FIELD_JOIN_UNION, single("sphere", NULL), chain, 0);
    }
    assert_int_equal(chain->depth, 1);
    const Field *many[40];
    for (int n = 0; n < 40; n++) {
        many[n] = chain;
    }
    Field *out = new_field(FIELD_STEPS_MAXIMUM);
    assert_false(field_join(out, FIELD_JOIN_UNION, many, 40, 0, &error));
    assert_non_null(strstr(error.message, "4096"));
    free(chain);
    Field *deep = single("sphere", NULL);
    for (int n = 0; n < FIELD_DEPTH_MAXIMUM; n++) {
        deep = moved(deep, 0.1, 0, 0);
    }
    assert_false(field_place(out, deep, transform_keyword.defaults, &error));
    assert_non_null(strstr(error.message, "deep"));
    free(deep);
    free(out);
}

/** Copies may overlap their neighbours, but no more. @param state Not used. */
static void test_overlap(void **state) {
    (void)state;
    Error error = {0};
    Field *ball = single("sphere", NULL), *out = new_field(2);
    assert_true(field_repeat(out, ball, &(FieldRepeat){.period = {1, 0, 0}}, &error));
    assert_false(field_repeat(out, ball, &(FieldRepeat){.period = {0.99, 0, 0}}, &error));
    assert_non_null(strstr(error.message, "overlap"));
    assert_false(field_repeat(out, ball, &(FieldRepeat){{3, 3, 3}, {1.5, 0, 0}}, &error));
    free(ball);
    free(out);
}

/** Runs the tests. @return 0 if fields keep their promises. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lipschitz), cmocka_unit_test(test_mandelbulb),
        cmocka_unit_test(test_truth),     cmocka_unit_test(test_boxes),
        cmocka_unit_test(test_gradients), cmocka_unit_test(test_limits),
        cmocka_unit_test(test_overlap),
    };
    return cmocka_run_group_tests_name("fields", tests, start, stop);
}
