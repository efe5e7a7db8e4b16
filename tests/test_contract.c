/**
 * @file
 * @brief The contract tests: properties of every shape in every engine.
 *
 * The shapes are in a table, each with a reference in quad precision that shares no code with the
 * tracer. Each case runs for every shape in every engine. The worst errors are printed as a table.
 * All rays and parameters are exact in float, so that all engines get the same input.
 */
#include "contract_scenes.h"
#include "workload.h"

/** Rays per case. */
enum { RAYS = 20000 };
/** Rays per case that leave a surface. */
enum { OFFSET_RAYS = 1000 };

/**
 * Margin below which a ray is grazing: for a sphere, more than 0.98 radii from the centre
 * (doc/tour.md).
 */
#define GRAZING 0.04

/* --- one shape in one engine ----------------------------------------------------------------- */

/** A shape in an engine. */
typedef struct ContractRun {
    const ContractShape *row; /**< The shape. */
    const Engine *engine;     /**< The engine. */
    Tracer *tracer;           /**< Tracer of a scene with this shape alone. */
} ContractRun;

/** Worst errors of a shape in an engine. */
typedef struct WorstErrors {
    Quadruple t;      /**< Distance, in half ulps of the larger of itself and the shape's size. */
    Quadruple point;  /**< Distance of the point from the surface, in half ulps of the larger of
                           its coordinates and the size. */
    Quadruple normal; /**< Normal, in half ulps of 1. */
    Quadruple bound;  /**< Distance from the surface, relative to the hit's own error bound. */
} WorstErrors;

/** The measured errors, for the table at the end. */
static WorstErrors worsts[CONTRACT_SHAPE_COUNT][8];

/** A test case. @param subject A shape in an engine. */
typedef void (*Case)(const ContractRun *subject, WorstErrors *worst);

/** Runs a case for every shape in every engine. */
static void for_every_shape(Case run) {
    for (size_t r = 0; r < CONTRACT_SHAPE_COUNT; r++) {
        for (size_t e = 0; engine_list()[e]; e++) {
            const Engine *engine = engine_list()[e];
            if (engine_is_supported(engine)) {
                ContractRun subject = {&contract_shapes[r], engine,
                                       tracer_with(engine, &contract_shapes[r])};
                run(&subject, &worsts[r][e]);
                engine->destroy(subject.tracer);
            }
        }
    }
}

/** @return The larger of a bound and a shape's tolerance. */
static double tolerance_or_bound(const ContractRun *subject, double bound) {
    return fmax(bound, tolerance_of(subject->row) / (double)roundoff(subject->engine));
}

/** @return Number of rays for an engine: fewer for the slow reference. */
static size_t ray_count(const ContractRun *subject) {
    const Engine *engine = subject->engine;
    // Quad is slow. Wide engines return the bits of narrow ones, which other tests compare.
    size_t rays = engine->mantissa_bits > 64 ? RAYS / 10 : engine->lanes > 1 ? RAYS / 4 : RAYS;
    return rays / WORKLOAD_DIVISOR;
}

/** @return The larger of two numbers. */
static Quadruple quad_max(Quadruple a, Quadruple b) {
    return a > b ? a : b;
}

/** @return The largest absolute coordinate. */
static Quadruple max_coordinate(const Quadruple v[3]) {
    return quad_max(quad_abs(v[0]), quad_max(quad_abs(v[1]), quad_abs(v[2])));
}

/** Checks a result against the reference. */
static void check_result(const ContractRun *subject, const RayQueryQuad *ray,
                         const RayResult *answer, WorstErrors *worst) {
    const ContractShape *shape = subject->row;
    ExpectedHit expected = contract_expected_hit(shape, ray);
    Quadruple u = roundoff(subject->engine);
    bool is_hit = answer->shape == 0;
    assert_int_equal(is_hit, answer->occluded);
    // So near to the rim, rounding the ray decides: both results are valid.
    Vec3qa d = vec3qa_from_quads(ray->direction);
    Quadruple sizes = quad_abs(expected.t) * quad_sqrt(vec3qa_dot(d, d)) / shape->size;
    if (expected.edge_margin < 64 * (u * (1 + sizes) + tolerance_of(shape))) {
        return;
    }
    if (is_hit != expected.is_hit) {
        fail_msg("%s in %s: hit %d, truth %d, margin %g, from %g %g %g along %g %g %g", shape->name,
                 subject->engine->name, is_hit, expected.is_hit, (double)expected.edge_margin,
                 (double)ray->origin[0], (double)ray->origin[1], (double)ray->origin[2],
                 (double)ray->direction[0], (double)ray->direction[1], (double)ray->direction[2]);
    }
    if (!is_hit) {
        assert_true(answer->distance > 1e300);
        return;
    }
    Vec3qa point = {{answer->point[0], answer->point[1], answer->point[2]}};
    Quadruple off = surface_distance(shape, &point);
    worst->point =
        quad_max(worst->point, off / (u * (max_coordinate(answer->point) + shape->size)));
    worst->bound = quad_max(worst->bound, off / answer->error);
    // At grazing rays the rounding of the ray moves the point far: distance and normal are not
    // compared.
    if (expected.edge_margin < GRAZING) {
        return;
    }
    // Relative to the size: the error of a distance from an origin near the surface is at least
    // that of its coordinates.
    Quadruple off_t = quad_abs(answer->distance - expected.t) / quad_abs(expected.t) * sizes;
    worst->t = quad_max(worst->t, off_t / (u * (sizes + 1)));
    Vec3qa normal = {{answer->normal[0], answer->normal[1], answer->normal[2]}};
    Vec3qa difference = vec3qa_subtract(normal, expected.normal);
    Quadruple length = quad_sqrt(vec3qa_dot(normal, normal));
    worst->normal = quad_max(
        worst->normal, quad_max(quad_abs(length - 1), max_coordinate(difference.component)) / u);
}

/** Compares occlusion tests with full intersections. */
static void check_shadows(const ContractRun *subject, const RayQueryQuad *rays,
                          const RayResult *answers, size_t count) {
    RayQuery *plain = calloc(count, sizeof *plain);
    bool *shadowed = calloc(count, sizeof *shadowed);
    for (size_t i = 0; i < 3 * count; i++) {
        plain[i / 3].origin[i % 3] = (double)rays[i / 3].origin[i % 3];
        plain[i / 3].direction[i % 3] = (double)rays[i / 3].direction[i % 3];
    }
    subject->engine->occluded(subject->tracer, count, plain, shadowed);
    for (size_t i = 0; i < count; i++) {
        assert_int_equal(shadowed[i], answers[i].occluded);
    }
    free(plain);
    free(shadowed);
}

/** Traces rays and checks every result. */
static void query_and_check(const ContractRun *subject, const RayQueryQuad *rays, size_t count,
                            WorstErrors *worst) {
    RayResult *answers = calloc(count, sizeof *answers);
    subject->engine->intersect(subject->tracer, count, rays, answers);
    check_shadows(subject, rays, answers, count);
    for (size_t i = 0; i < count; i++) {
        check_result(subject, &rays[i], &answers[i], worst);
    }
    free(answers);
}

/** Tests random rays. */
static void query_random_rays(const ContractRun *subject, double distance, double spread,
                              WorstErrors *worst) {
    size_t count = ray_count(subject);
    RayQueryQuad *rays = calloc(count, sizeof *rays);
    uint64_t state = 1;
    for (size_t i = 0; i < count; i++) {
        rays[i] = random_ray(subject->row, &state, distance, spread);
    }
    query_and_check(subject, rays, count, worst);
    free(rays);
}

/* --- test cases ------------------------------------------------------------------------------- */

/** Rays near the shape and in it, hits and misses; the errors go into the table. */
static void case_near(const ContractRun *subject, WorstErrors *worst) {
    query_random_rays(subject, 4, 1.5, worst);
    query_random_rays(subject, 0.5, 2, worst);
    bool is_float = subject->engine->mantissa_bits == 24;
    const char *name = subject->engine->name, *shape = subject->row->name;
    // Float computes differences in double and rounds a few times afterwards. The other types have
    // no wider type, so their error grows with the distance. A transformed ray is rounded once
    // more.
    double t_bound = subject->row->transform && is_float ? 12
                     : strcmp(shape, "box") == 0         ? 8
                     : is_float                          ? 4
                                                         : 64;
    assert_at_most(worst->t, tolerance_or_bound(subject, t_bound), "%s in %s, distance, half ulps",
                   shape, name);
    assert_at_most(worst->point, tolerance_or_bound(subject, 8), "%s in %s, point, half ulps",
                   shape, name);
    // Uneven scales rotate normals and their rounding errors. In quad, the error of the reference
    // is of the same magnitude.
    double float_bound = subject->row->transform ? 16 : 6;
    double normal_bound = is_float ? float_bound : subject->engine->mantissa_bits > 64 ? 1024 : 64;
    assert_at_most(worst->normal, tolerance_or_bound(subject, normal_bound),
                   "%s in %s, normal, half ulps", shape, name);
    assert_at_most(worst->bound, 1, "%s in %s, point against its own bound", shape, name);
}

/** Distances of a thousand and ten thousand sizes. */
static void case_far(const ContractRun *subject, WorstErrors *unused) {
    (void)unused;
    if (subject->engine->mantissa_bits > 64) {
        return; // The reference is not more precise than the engine.
    }
    for (double distance = 1e3; distance < 1e5; distance *= 10) {
        WorstErrors worst = {0};
        query_random_rays(subject, distance, 0.5, &worst);
        assert_at_most(worst.t, tolerance_or_bound(subject, 64),
                       "%s in %s at %g sizes, distance, half ulps", subject->row->name,
                       subject->engine->name, distance);
        assert_at_most(worst.bound, 1, "%s in %s at %g sizes, point against its own bound",
                       subject->row->name, subject->engine->name, distance);
    }
}

/** Rays that point away from the shape: no hit. */
static void case_behind(const ContractRun *subject, WorstErrors *unused) {
    (void)unused;
    uint64_t state = 2;
    for (int n = 0; n < OFFSET_RAYS; n++) {
        RayQueryQuad ray = random_ray(subject->row, &state, 6, 0.5);
        ExpectedHit ahead = contract_expected_hit(subject->row, &ray);
        for (int i = 0; i < 3; i++) {
            ray.direction[i] = -ray.direction[i];
        }
        ExpectedHit behind = contract_expected_hit(subject->row, &ray);
        if (ahead.is_hit && !behind.is_hit) {
            RayResult answer;
            subject->engine->intersect(subject->tracer, 1, &ray, &answer);
            assert_int_equal(answer.shape, -1);
            assert_false(answer.occluded);
        }
    }
}

/** Directions of any length: for powers of two equal bits, else equal up to rounding. */
static void case_length(const ContractRun *subject, WorstErrors *unused) {
    (void)unused;
    uint64_t state = 3;
    for (int n = 0; n < OFFSET_RAYS; n++) {
        RayQueryQuad ray = random_ray(subject->row, &state, 5, 1), longer = ray;
        double factor = ldexp(1, n % 41 - 20);
        for (int i = 0; i < 3; i++) {
            longer.direction[i] *= factor;
        }
        RayResult a, b;
        subject->engine->intersect(subject->tracer, 1, &ray, &a);
        subject->engine->intersect(subject->tracer, 1, &longer, &b);
        assert_int_equal(a.shape, b.shape);
        assert_memory_equal(a.point, b.point, sizeof a.point);
        assert_memory_equal(a.normal, b.normal, sizeof a.normal);
        assert_true(a.shape < 0 || a.distance == b.distance * factor);
    }
}

/** @return A number rounded to an engine's type. */
static Quadruple rounded(const Engine *engine, Quadruple x) {
    return engine->mantissa_bits == 24   ? (Quadruple)(float)x
           : engine->mantissa_bits == 53 ? (Quadruple)(double)x
                                         : x;
}

/**
 * @return A ray that leaves a hit on one side. Its origin is moved by the hit's own error bound.
 * @param engine  The engine, whose number type it is rounded to.
 * @param side  1: outwards; -1: inwards.
 */
static RayQueryQuad offset_ray(const Engine *engine, const RayResult *hit, int side,
                               uint64_t *state) {
    RayQueryQuad ray;
    Quadruple cosine = 0;
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = rounded(engine, hit->point[i] + side * hit->error * hit->normal[i]);
        ray.direction[i] = random_float(state, -1, 1);
        cosine += ray.direction[i] * hit->normal[i];
    }
    for (int i = 0; i < 3; i++) {
        ray.direction[i] = cosine * side > 0 ? ray.direction[i] : -ray.direction[i];
    }
    return ray;
}

/**
 * Rays that leave the surface: of 1000 rays outwards none hits it again, and of 1000 inwards each
 * hits only the opposite side.
 */
static void case_offset(const ContractRun *subject, WorstErrors *unused) {
    (void)unused;
    uint64_t state = 4;
    int hits_again[2] = {0, 0}, left = 0;
    while (left < OFFSET_RAYS) {
        RayQueryQuad ray = random_ray(subject->row, &state, 20, 0.9);
        RayResult hit, again;
        subject->engine->intersect(subject->tracer, 1, &ray, &hit);
        if (hit.shape < 0) {
            continue;
        }
        left++;
        RayQueryQuad out = offset_ray(subject->engine, &hit, 1, &state);
        subject->engine->intersect(subject->tracer, 1, &out, &again);
        hits_again[0] += again.shape >= 0 || again.occluded;
        RayQueryQuad in = offset_ray(subject->engine, &hit, -1, &state);
        subject->engine->intersect(subject->tracer, 1, &in, &again);
        ExpectedHit expected = contract_expected_hit(subject->row, &in);
        bool is_right =
            again.shape < 0
                ? !subject->row->is_solid && !expected.is_hit
                : expected.is_hit && quad_abs(again.distance - expected.t) <=
                                         expected.t / 100 + 2048 * tolerance_of(subject->row);
        hits_again[1] += !is_right;
    }
    assert_at_most(hits_again[0], 0, "%s in %s, met again outwards", subject->row->name,
                   subject->engine->name);
    assert_at_most(hits_again[1], 0, "%s in %s, wrong inwards", subject->row->name,
                   subject->engine->name);
}

/**
 * Directions that are NaN, infinite, zero or parallel to an axis, with all signs of zero: results
 * contain no NaN, and are correct for valid input.
 */
static void case_degenerate(const ContractRun *subject, WorstErrors *unused) {
    (void)unused;
    static const double odd[] = {0.0, -0.0, 1, -1, NAN, INFINITY, -INFINITY, 1e30, 1e-40};
    enum { ODD = sizeof odd / sizeof *odd };
    for (int n = 0; n < ODD * ODD * ODD * ODD; n++) {
        const double *center = subject->row->center;
        RayQueryQuad ray = {
            .direction = {odd[n % ODD], odd[n / ODD % ODD], odd[n / ODD / ODD % ODD]},
            .origin = {center[0], center[1], center[2] + odd[n / ODD / ODD / ODD]}};
        RayResult answer;
        subject->engine->intersect(subject->tracer, 1, &ray, &answer);
        bool is_finite = true, is_bad = false;
        for (int i = 0; i < 3; i++) {
            is_finite = is_finite && isfinite((double)answer.point[i] + (double)answer.normal[i]);
            is_bad = is_bad || isnan((double)ray.direction[i]) || isnan((double)ray.origin[i]);
        }
        if (!(answer.shape < 0 || (is_finite && answer.distance > 0 && !is_bad))) {
            fail_msg("%s in %s: from %g %g %g along %g %g %g: t %g, point %g %g %g",
                     subject->row->name, subject->engine->name, (double)ray.origin[0],
                     (double)ray.origin[1], (double)ray.origin[2], (double)ray.direction[0],
                     (double)ray.direction[1], (double)ray.direction[2], (double)answer.distance,
                     (double)answer.point[0], (double)answer.point[1], (double)answer.point[2]);
        }
    }
}

/** Rays along the axes, through the centre and off it. */
static void case_axes(const ContractRun *subject, WorstErrors *worst) {
    for (int n = 0; n < 3 * 2 * 2 * 81; n++) {
        int axis = n % 3, up = n / 3 % 2 ? 1 : -1;
        double zero = n / 6 % 2 ? 0.0 : -0.0;
        RayQueryQuad ray = {.direction = {zero, zero, zero}};
        for (int i = 0; i < 3; i++) {
            ray.origin[i] = subject->row->center[i];
        }
        ray.direction[axis] = up;
        ray.origin[axis] -= 8 * up;
        ray.origin[(axis + 1) % 3] += 0.25 * (n / 12 % 9 - 4);
        ray.origin[(axis + 2) % 3] += 0.25 * (n / 108 % 9 - 4);
        query_and_check(subject, &ray, 1, worst);
    }
}

/** Wide engines return the bits of the narrow one. */
static void case_lanes(const ContractRun *subject, WorstErrors *unused) {
    (void)unused;
    Error error;
    const Engine *one = engine_find(subject->engine->mantissa_bits == 24   ? "f32x1"
                                    : subject->engine->mantissa_bits == 53 ? "f64x1"
                                                                           : "f128x1",
                                    &error);
    Tracer *tracer = tracer_with(one, subject->row);
    uint64_t state = 5;
    RayQueryQuad rays[101];
    RayResult a[101], b[101];
    for (int n = 0; n < OFFSET_RAYS / 10; n++) {
        size_t count = 1 + (size_t)n % 101;
        for (size_t i = 0; i < count; i++) {
            rays[i] = random_ray(subject->row, &state, 3 + n, 1.2);
        }
        subject->engine->intersect(subject->tracer, count, rays, a);
        one->intersect(tracer, count, rays, b);
        for (size_t i = 0; i < count; i++) {
            assert_int_equal(a[i].shape, b[i].shape);
            assert_int_equal(a[i].occluded, b[i].occluded);
            assert_memory_equal(&a[i].distance, &b[i].distance, sizeof a[i].distance);
            assert_memory_equal(a[i].point, b[i].point, sizeof a[i].point);
            assert_memory_equal(a[i].normal, b[i].normal, sizeof a[i].normal);
            assert_memory_equal(&a[i].error, &b[i].error, sizeof a[i].error);
        }
    }
    one->destroy(tracer);
}

/* --- cmocka ---------------------------------------------------------------------------------- */

/** Every shape class is in the table. */
static void test_every_shape_has_a_row(void **state) {
    (void)state;
    for (const Keyword *const *keyword = scene_shape_keywords; *keyword; keyword++) {
        size_t r = 0;
        while (r < CONTRACT_SHAPE_COUNT &&
               strcmp(contract_shapes[r].keyword, (*keyword)->name) != 0) {
            r++;
        }
        assert_at_most(r, CONTRACT_SHAPE_COUNT - 1, "the row of %s", (*keyword)->name);
    }
}

/**
 * The bounding box of the scene's shape equals that of the tracer, up to rounding and tolerances.
 */
static void test_described_bounds(void **state) {
    (void)state;
    const Engine *engine = engine_list()[0];
    for (size_t r = 0; r < CONTRACT_SHAPE_COUNT; r++) {
        const ContractShape *row = &contract_shapes[r];
        Scene *scene = scene_with(row);
        Tracer *tracer = create_tracer(engine, scene);
        Aabbd described = scene_bounds(scene);
        Vec3d low, high;
        engine->bounds(tracer, &low, &high);
        assert_int_equal(described.low.x <= described.high.x, low.x <= high.x);
        if (low.x <= high.x) {
            double low_error = vec3d_max_abs(vec3d_subtract(described.low, low));
            double high_error = vec3d_max_abs(vec3d_subtract(described.high, high));
            double bound = 1e-5 * row->size + 4 * (double)tolerance_of(row);
            assert_at_most(fmax(low_error, high_error), bound, "the box of %s", row->name);
        }
        engine->destroy(tracer);
        scene_destroy(scene);
    }
}

/** @param state Not used. */
static void test_near(void **state) {
    (void)state;
    for_every_shape(case_near);
}

/** @param state Not used. */
static void test_far(void **state) {
    (void)state;
    for_every_shape(case_far);
}

/** @param state Not used. */
static void test_behind(void **state) {
    (void)state;
    for_every_shape(case_behind);
}

/** @param state Not used. */
static void test_length(void **state) {
    (void)state;
    for_every_shape(case_length);
}

/** @param state Not used. */
static void test_offset(void **state) {
    (void)state;
    for_every_shape(case_offset);
}

/** @param state Not used. */
static void test_degenerate(void **state) {
    (void)state;
    for_every_shape(case_degenerate);
}

/** @param state Not used. */
static void test_axes(void **state) {
    (void)state;
    for_every_shape(case_axes);
}

/** @param state Not used. */
static void test_lanes(void **state) {
    (void)state;
    for_every_shape(case_lanes);
}

/** More precise engines have smaller errors: double does not compute in float. */
static void test_precision(void **state) {
    (void)state;
    for (size_t r = 0; r < CONTRACT_SHAPE_COUNT; r++) {
        Quadruple absolute[3] = {0, 0, 0};
        for (size_t e = 0; engine_list()[e]; e++) {
            int bits = engine_list()[e]->mantissa_bits;
            int which = bits == 24 ? 0 : bits == 53 ? 1 : 2;
            absolute[which] =
                quad_max(absolute[which], worsts[r][e].t * roundoff(engine_list()[e]));
        }
        assert_true(tolerance_of(&contract_shapes[r]) > 0 || absolute[1] < absolute[0] / 1e4);
        assert_true(tolerance_of(&contract_shapes[r]) > 0 || absolute[2] < absolute[1] / 1e4);
    }
}

/** Prints the table of worst errors. @return 0 */
static int print_table(void **state) {
    (void)state;
    printf("worst errors, half ulps     distance     point    normal   point/bound\n");
    for (size_t r = 0; r < CONTRACT_SHAPE_COUNT; r++) {
        for (size_t e = 0; engine_list()[e]; e++) {
            const WorstErrors *w = &worsts[r][e];
            printf("  %-17s %-8s %8.2f %9.2f %9.2f %13.3f\n", contract_shapes[r].name,
                   engine_list()[e]->name, (double)w->t, (double)w->point, (double)w->normal,
                   (double)w->bound);
        }
    }
    return 0;
}

/** Runs the tests. @return 0 if all pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_shape_has_a_row),
        cmocka_unit_test(test_described_bounds),
        cmocka_unit_test(test_near),
        cmocka_unit_test(test_axes),
        cmocka_unit_test(test_precision),
        cmocka_unit_test(test_far),
        cmocka_unit_test(test_behind),
        cmocka_unit_test(test_length),
        cmocka_unit_test(test_offset),
        cmocka_unit_test(test_degenerate),
        cmocka_unit_test(test_lanes),
    };
    return cmocka_run_group_tests_name("contract", tests, init_transforms, print_table);
}
