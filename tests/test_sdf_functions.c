/**
 * @file
 * @brief Distance fields have their declared properties: Lipschitz constant 1, exact distances and
 *        exact gradients; invalid fields are refused.
 *
 * The SDF interpreter is compiled into this test in double, with one lane.
 */
#define REAL_BITS 64
#define LANES 1
#include "sdf_compiled.h"

#include "sdf_builders.h"

/** Pairs of points per field. */
enum { PAIRS = 1000000 / WORKLOAD_DIVISOR };
/** Points per field with a reference distance. */
enum { POINTS = 100000 / WORKLOAD_DIVISOR };

/** A field under test. */
typedef struct SdfCase {
    const char *name;     /**< Its name. */
    Sdf *field;           /**< The field; owned. */
    CompiledSdf compiled; /**< Its program; owned. */
    double size;          /**< Half the side of the cube of test points. */
    /** @return The reference distance of a point outside; NULL: the field is only a bound. */
    double (*truth)(Vec3d p);
} SdfCase;

/* --- reference distances ---------------------------------------------------------------------- */

/** @return Distance from a point to a box, by its nearest point. */
static double box_distance(Vec3d p, Vec3d low, Vec3d high) {
    Vec3d nearest = vec3d_min(vec3d_max(p, low), high);
    return vec3d_length(vec3d_subtract(p, nearest));
}

/** @return See #SdfCase.truth: a sphere of radius 1. */
static double sphere_distance(Vec3d p) {
    return fmax(vec3d_length(p) - 1, 0);
}

/** @return See #SdfCase.truth: a box with edges of 1, 2, 3. */
static double box_sdf_distance(Vec3d p) {
    return box_distance(p, (Vec3d){-0.5, -1, -1.5}, (Vec3d){0.5, 1, 1.5});
}

/** @return See #SdfCase.truth: a box frame with edges of 1, 2, 3 and bars of 0.25. */
static double frame_distance(Vec3d p) {
    const double half[3] = {0.5, 1, 1.5}, thick = 0.25;
    double minimum = HUGE_VAL;
    for (int n = 0; n < 12; n++) {
        int along = n / 4;
        double low[3], high[3];
        for (int axis = 0; axis < 3; axis++) {
            bool is_up = axis == (along + 1) % 3 ? n & 1 : n & 2;
            low[axis] = axis == along || !is_up ? -half[axis] : half[axis] - thick;
            high[axis] = axis == along || is_up ? half[axis] : -half[axis] + thick;
        }
        Vec3d a = {low[0], low[1], low[2]}, b = {high[0], high[1], high[2]};
        minimum = fmin(minimum, box_distance(p, a, b));
    }
    return minimum;
}

/**
 * @return See #SdfCase.truth: a torus of radii 1 and 0.25, by the nearest point of its centre line.
 */
static double torus_distance(Vec3d p) {
    double axis = hypot(p.x, p.z), turn = atan2(p.z, p.x);
    Vec3d middle = {cos(turn), 0, sin(turn)};
    return fmax(vec3d_length(vec3d_subtract(p, axis > 0 ? middle : (Vec3d){1, 0, 0})) - 0.25, 0);
}

/** @return See #SdfCase.truth: small boxes off the centres of unit cells; searches 125 cells. */
static double box_grid_distance(Vec3d p) {
    double minimum = HUGE_VAL;
    for (int n = 0; n < 125; n++) {
        Vec3d cell = {round(p.x) + n % 5 - 2, round(p.y) + n / 5 % 5 - 2, round(p.z) + n / 25 - 2};
        Vec3d low = vec3d_add(cell, (Vec3d){0.2, -0.1, -0.45});
        Vec3d high = vec3d_add(cell, (Vec3d){0.5, 0.2, -0.25});
        minimum = fmin(minimum, box_distance(p, low, high));
    }
    return minimum;
}

/** @return See #SdfCase.truth: the solids of #many_solids. */
static double many_solids_distance(Vec3d p) {
    double minimum = HUGE_VAL;
    for (int i = 0; i < MANY_SOLIDS; i++) {
        Vec3d from = vec3d_subtract(p, many_solids_place(i));
        const Vec3d half = {MANY_SOLIDS_HALF, MANY_SOLIDS_HALF, MANY_SOLIDS_HALF};
        double ball = fmax(vec3d_length(from) - MANY_SOLIDS_HALF, 0);
        double box = box_distance(from, vec3d_scale(half, -1), half);
        minimum = fmin(minimum, i % 2 ? ball : box);
    }
    return minimum;
}

/** @return See #SdfCase.truth: spheres of radius 0.75 in unit cells, five by four by one. */
static double ball_grid_distance(Vec3d p) {
    double minimum = HUGE_VAL;
    for (int n = 0; n < 20; n++) {
        Vec3d center = {n % 5 - 2, n / 5 - 1.5, 0};
        minimum = fmin(minimum, vec3d_length(vec3d_subtract(p, center)) - 0.75);
    }
    return fmax(minimum, 0);
}

/* --- the fields ------------------------------------------------------------------------------- */

/** Parameters of the fields, in the layout of the scene language. */
static const struct {
    double sphere;    /**< Radius. */
    double ring[2];   /**< Major and minor radius. */
    double box[4];    /**< Edges, and thickness of the bars. */
    double little[4]; /**< The same of a small box. */
} numbers = {1, {1, 0.25}, {1, 2, 3, 0.25}, {0.3, 0.3, 0.2, 0}};

/** A rotation and a translation. */
static const Transform leaning = {
    .scale = {2, 2, 2}, .rotate = {30, 45, 60}, .translate = {0.5, -1, 0.25}};

/** @return A small box off the origin. */
static Sdf *small_box(void) {
    return translate_sdf(make_sdf("box", numbers.little), 0.35, 0.05, -0.35);
}

/** The fields under test. */
static SdfCase subjects[16];
/** Number of #subjects. */
static size_t subject_count;

/**
 * Adds a field.
 * @param size  Half the side of the cube of test points.
 * @param truth  Its reference distance, or NULL.
 */
static void add_sdf_case(const char *name, Sdf *field, double size, double (*truth)(Vec3d)) {
    SdfCase *subject = &subjects[subject_count++];
    *subject = (SdfCase){name, field, compile_sdf(field), size, truth};
    assert_int_equal(field->is_exact, truth != NULL);
}

/** Creates the fields. @return 0 */
static int create_sdfs(void **state) {
    (void)state;
    const double *box = numbers.box;
    add_sdf_case("sphere", make_sdf("sphere", &numbers.sphere), 3, sphere_distance);
    add_sdf_case("box", make_sdf("box", box), 3, box_sdf_distance);
    add_sdf_case("box frame", make_sdf("box_frame", box), 3, frame_distance);
    add_sdf_case("torus", make_sdf("torus", numbers.ring), 3, torus_distance);
    add_sdf_case("repeated boxes", repeat_sdf(small_box(), (SdfRepetition){{1, 1, 1}, {0, 0, 0}}),
                 3, box_grid_distance);
    Sdf *sphere =
        transform_sdf(make_sdf("sphere", &numbers.sphere), (Transform){.scale = {.75, .75, .75}});
    add_sdf_case("counted balls", repeat_sdf(sphere, (SdfRepetition){{1, 1, 1}, {5, 4, 1}}), 4,
                 ball_grid_distance);
    add_sdf_case("Menger sponge", make_sdf("menger", NULL), 1, NULL);
    add_sdf_case("Mandelbulb", make_sdf("mandelbulb", NULL), 1.5, NULL);
    add_sdf_case("Mandelbulb, coarse", make_sdf("mandelbulb", (int[]){8, 4}), 1.5, NULL);
    add_sdf_case("Mandelbulb of power 2", make_sdf("mandelbulb", (int[]){2, 10}), 2.5, NULL);
    add_sdf_case("leaning sponge", transform_sdf(make_sdf("menger", NULL), leaning), 3, NULL);
    add_sdf_case("smooth union",
                 join_sdfs(SDF_COMBINE_SMOOTH_UNION, make_sdf("box", box),
                           translate_sdf(make_sdf("sphere", &numbers.sphere), 1, 0, 0), 0.5),
                 3, NULL);
    add_sdf_case("intersection",
                 join_sdfs(SDF_COMBINE_INTERSECTION, transform_sdf(make_sdf("box", box), leaning),
                           make_sdf("torus", numbers.ring), 0),
                 3, NULL);
    add_sdf_case("difference",
                 join_sdfs(SDF_COMBINE_DIFFERENCE, make_sdf("box", box),
                           repeat_sdf(small_box(), (SdfRepetition){{1, 1, 0}, {0, 3, 0}}), 0),
                 3, NULL);
    add_sdf_case("many solids", many_solids(MANY_SOLIDS), 4, many_solids_distance);
    add_sdf_case("rounded sponge",
                 round_sdf(transform_sdf(make_sdf("menger", NULL), leaning), 0.05), 3, NULL);
    return 0;
}

/** Destroys the fields. @return 0 */
static int destroy_sdfs(void **state) {
    (void)state;
    for (size_t i = 0; i < subject_count; i++) {
        free(subjects[i].field);
        free(subjects[i].compiled.memory);
    }
    return 0;
}

/** @return The value of a field at a point. */
static double sdf_value(const SdfCase *subject, Vec3d p) {
    return sdf_distance(&subject->compiled.program, vec3_of(p), 1);
}

/** @return A random point in a cube around the origin. */
static Vec3d random_point(uint64_t *seed, double size) {
    return (Vec3d){size * (2 * random_unit_double(seed) - 1),
                   size * (2 * random_unit_double(seed) - 1),
                   size * (2 * random_unit_double(seed) - 1)};
}

/* --- properties ------------------------------------------------------------------------------- */

/** @return Whether a field is a Mandelbulb. */
static bool is_mandelbulb(const SdfCase *subject) {
    return subject->field->nodes[0].op == SDF_MANDELBULB;
}

/** @return The fraction of points from which a step of the field's length ends inside the solid. */
static double overstep_fraction(const SdfCase *subject) {
    uint64_t seed = 1;
    int tried = 0, wrong = 0;
    while (tried < PAIRS) {
        Vec3d p = random_point(&seed, subject->size), direction = random_point(&seed, 1);
        double allowed = sdf_value(subject, p), length = vec3d_length(direction);
        if (allowed > 0 && length > 0) {
            direction = vec3d_scale(direction, random_unit_double(&seed) * allowed / length);
            wrong += sdf_value(subject, vec3d_add(p, direction)) < 0;
            tried++;
        }
    }
    return (double)wrong / tried;
}

/**
 * The Mandelbulb is a bound up to four iterations. With more, its estimate misses thin filaments in
 * one of ten thousand places.
 */
static void test_mandelbulb(void **state) {
    (void)state;
    for (size_t i = 0; i < subject_count; i++) {
        if (is_mandelbulb(&subjects[i])) {
            bool is_coarse = subjects[i].field->nodes[0].operands[1] <= 4;
            double fraction = overstep_fraction(&subjects[i]);
            printf("  %-22s steps into it: %g\n", subjects[i].name, fraction);
            assert_at_most(fraction, is_coarse ? 0 : 2e-4, "%s, steps into it", subjects[i].name);
        }
    }
}

/** @return z^n by angles, as the Mandelbulb is defined. The y axis carries the poles. */
static Vec3d power_by_angles(Vec3d z, int n) {
    long double across = hypotl(z.x, z.z);
    long double radius = powl(hypotl(across, z.y), n);
    long double polar = n * atan2l(across, z.y), azimuth = n * atan2l(z.x, z.z);
    return (Vec3d){(double)(radius * sinl(polar) * sinl(azimuth)), (double)(radius * cosl(polar)),
                   (double)(radius * sinl(polar) * cosl(azimuth))};
}

/** Powers of points by complex numbers are those by angles, also next to the axis and on it. */
static void test_mandelbulb_power(void **state) {
    (void)state;
    static const double across[] = {1, 1e-4, 1e-17, 1e-30, 0};
    uint64_t seed = 1;
    double worst = 0;
    for (int i = 0; i < POINTS; i++) {
        int n = 2 + i % 8;
        double narrow = across[i / 8 % (int)(sizeof across / sizeof *across)];
        Vec3d p = random_point(&seed, 1.5);
        p.x *= narrow;
        p.z *= narrow;
        Vec3d expected = power_by_angles(p, n);
        Vec3 power = mandelbulb_power((Vec3){p.x, p.y, p.z}, n);
        Vec3d error = vec3d_subtract((Vec3d){power.x, power.y, power.z}, expected);
        double radius = vec3d_length(p), exact = n * pow(radius, n - 1);
        worst = fmax(worst, vec3d_length(error) / pow(radius, n));
        assert_at_most(fabs(power_derivative(radius * radius, n) / exact - 1), 1e-14,
                       "derivative of r^%d at %g", n, radius);
    }
    printf("  error of z^n, relative: %g\n", worst);
    assert_at_most(worst, 1e-14, "error of z^n, relative");
}

/** |f(p) - f(q)| <= |p - q|, near and far, on the surface and off it. */
static void test_lipschitz(void **state) {
    (void)state;
    for (size_t i = 0; i < subject_count; i++) {
        const SdfCase *subject = &subjects[i];
        uint64_t seed = i;
        double worst = 0;
        if (is_mandelbulb(subject)) {
            continue; // An estimate: see test_mandelbulb().
        }
        for (int n = 0; n < PAIRS; n++) {
            Vec3d p = random_point(&seed, subject->size);
            double far = subject->size * exp(-14 * random_unit_double(&seed));
            Vec3d step = random_point(&seed, far), q = vec3d_add(p, step);
            double length = vec3d_length(vec3d_subtract(q, p));
            double change = fabs(sdf_value(subject, p) - sdf_value(subject, q));
            // Allow for rounding errors of points and distances.
            worst = fmax(worst, (change - 1e-14 * subject->size) / length);
        }
        printf("  %-22s |f(p) - f(q)| / |p - q| at most %.9f\n", subject->name, worst);
        assert_at_most(worst, 1 + 1e-9, "%s, change over way", subject->name);
    }
}

/** Exact fields equal the reference distance; bounds are skipped. */
static void test_distances(void **state) {
    (void)state;
    for (size_t i = 0; i < subject_count; i++) {
        const SdfCase *subject = &subjects[i];
        uint64_t seed = i;
        for (int n = 0; subject->truth && n < POINTS; n++) {
            Vec3d p = random_point(&seed, subject->size);
            double truth = subject->truth(p), value = sdf_value(subject, p);
            assert_at_most(fabs(fmax(value, 0) - truth), 1e-14, "%s at %g %g %g", subject->name,
                           p.x, p.y, p.z);
        }
    }
}

/**
 * Bounding boxes contain the solids: outside, the field is at least the distance divided by its
 * slack.
 */
static void test_boxes(void **state) {
    (void)state;
    for (size_t i = 0; i < subject_count; i++) {
        const SdfCase *subject = &subjects[i];
        const Sdf *field = subject->field;
        uint64_t seed = i;
        for (int n = 0; n < POINTS; n++) {
            Vec3d p = random_point(&seed, 2 * subject->size);
            double lateral = box_distance(p, field->low, field->high);
            assert_at_most(lateral / field->bound_slack - 1e-14, fmax(sdf_value(subject, p), 0),
                           "%s beside its box", subject->name);
        }
    }
}

/** Analytic gradients agree with finite differences. */
static void test_gradients(void **state) {
    (void)state;
    const double h = 1e-6;
    for (size_t i = 0; i < subject_count; i++) {
        const SdfCase *subject = &subjects[i];
        uint64_t seed = i;
        int wrong = 0;
        for (int n = 0; n < POINTS / 10; n++) {
            Vec3d p = random_point(&seed, subject->size);
            SdfSample here = sdf_sample(&subject->compiled.program, vec3_of(p), 1);
            assert_true(here.distance == sdf_value(subject, p));
            const double carried[3] = {here.gradient.x, here.gradient.y, here.gradient.z};
            for (int axis = 0; axis < 3; axis++) {
                Vec3d step = {axis == 0 ? h : 0, axis == 1 ? h : 0, axis == 2 ? h : 0};
                double up = sdf_value(subject, vec3d_add(p, step));
                double down = sdf_value(subject, vec3d_subtract(p, step));
                wrong += !(fabs((up - down) / (2 * h) - carried[axis]) < 1e-4);
            }
        }
        // An edge may lie between the two points of a difference; a Mandelbulb has edges
        // everywhere.
        double fraction = is_mandelbulb(subject) ? 0.1 : 2e-4;
        printf("  %-22s gradients unlike differences: %g\n", subject->name, wrong / (0.3 * POINTS));
        assert_at_most(wrong / (0.3 * POINTS), fraction, "%s, gradients", subject->name);
    }
}

/* --- limits ----------------------------------------------------------------------------------- */

/** Ten thousand fields are refused; a long chain of unions needs little depth. */
static void test_limits(void **state) {
    (void)state;
    Error error = {0};
    Sdf *chain = make_sdf("sphere", NULL);
    for (int n = 1; n < 200; n++) {
        chain = join_sdfs(SDF_COMBINE_UNION, make_sdf("sphere", NULL), chain, 0);
    }
    assert_int_equal(chain->depth, 1);
    const Sdf *many[40];
    for (int n = 0; n < 40; n++) {
        many[n] = chain;
    }
    Sdf *out = allocate_sdf(SDF_NODES_MAXIMUM);
    assert_false(sdf_combine(out, SDF_COMBINE_UNION, many, 40, 0, &error));
    assert_non_null(strstr(error.message, "4096"));
    free(chain);
    Sdf *deep = make_sdf("sphere", NULL);
    for (int n = 0; n < SDF_DEPTH_MAXIMUM; n++) {
        deep = translate_sdf(deep, 0.1, 0, 0);
    }
    assert_false(sdf_transform(out, deep, transform_keyword.defaults, &error));
    assert_non_null(strstr(error.message, "deep"));
    free(deep);
    free(out);
}

/** Repeated copies may overlap their direct neighbours only. */
static void test_overlap(void **state) {
    (void)state;
    Error error = {0};
    Sdf *sphere = make_sdf("sphere", NULL), *out = allocate_sdf(2);
    assert_true(sdf_repeat(out, sphere, &(SdfRepetition){.period = {1, 0, 0}}, &error));
    assert_false(sdf_repeat(out, sphere, &(SdfRepetition){.period = {0.99, 0, 0}}, &error));
    assert_non_null(strstr(error.message, "overlap"));
    assert_false(sdf_repeat(out, sphere, &(SdfRepetition){{3, 3, 3}, {1.5, 0, 0}}, &error));
    free(sphere);
    free(out);
}

/* --- runs of unions --------------------------------------------------------------------------- */

/** Executes the parts of a run of unions in their order. See #SdfInstruction.execute. */
static void run_in_order(SdfVm *vm, const SdfInstruction *run) {
    sdf_vm_run(vm, run + 1, run->body_count);
}

/** A run of unions gives the bits of its parts in their order, the gradient of the first of those
 * that are equally near too; so does a run that is longer than the longest, and one in a body. */
static void test_union_runs(void **state) {
    (void)state;
    const int counts[] = {9, 10, MANY_SOLIDS, 2 * SDF_UNION_RUN_PARTS + 20};
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {
        Sdf *field = many_solids(counts[k]);
        field = k % 2 ? round_sdf(transform_sdf(field, leaning), 0.05) : field;
        CompiledSdf runs = compile_sdf(field), in_order = compile_sdf(field);
        int found = 0;
        for (int i = 0; i < in_order.program.count; i++) {
            SdfInstruction *instruction = &in_order.program.instructions[i];
            found += instruction->execute == sdf_op_union_run;
            instruction->execute =
                instruction->execute == sdf_op_union_run ? run_in_order : instruction->execute;
        }
        assert_int_equal(found, counts[k] > SDF_UNION_RUN_PARTS ? 3 : 1);
        uint64_t seed = 7;
        for (int n = 0; n < POINTS / 4; n++) {
            Vec3d p = random_point(&seed, 4);
            // Every second point lies in a plane of centres, or halfway between two.
            p.x = n % 2 ? 0.5 * MANY_SOLIDS_STEP * round(p.x) : p.x;
            double distance = sdf_distance(&runs.program, vec3_of(p), 1);
            SdfSample fast = sdf_sample(&runs.program, vec3_of(p), 1);
            SdfSample slow = sdf_sample(&in_order.program, vec3_of(p), 1);
            assert_true(distance == slow.distance);
            assert_memory_equal(&fast, &slow, sizeof fast);
        }
        free(runs.memory);
        free(in_order.memory);
        free(field);
    }
}

/** Runs the tests. @return 0 if all pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lipschitz),
        cmocka_unit_test(test_union_runs),
        cmocka_unit_test(test_mandelbulb),
        cmocka_unit_test(test_distances),
        cmocka_unit_test(test_boxes),
        cmocka_unit_test(test_gradients),
        cmocka_unit_test(test_mandelbulb_power),
        cmocka_unit_test(test_limits),
        cmocka_unit_test(test_overlap),
    };
    return cmocka_run_group_tests_name("fields", tests, create_sdfs, destroy_sdfs);
}
