/**
 * @file
 * @brief Cones in the regimes where a formula can fail: nearly cylindrical, flat, needles, tiny and
 * far away; rays along the wall, through the tip, and past the mirrored cone beyond it.
 *
 * The reference is the textbook's quadratic in quad precision (tests/contract_shapes.h). All
 * numbers are exact in float, so that all engines get the same input.
 */
#include "contract_shapes.h"

#include <math.h>
#include <stdlib.h>

/** Rays per cone and engine. */
enum { RAYS = 3000 / WORKLOAD_DIVISOR };

/** Distance of a hit from the true one, across the surface: roundings of the coordinates. */
#define ROUNDINGS 64

/** A cone of a bad kind. */
typedef struct BadCone {
    const char *name; /**< Its name in messages. */
    ConeSpec spec;    /**< The cone. */
} BadCone;

/** The cones. Radii and heights differ by factors up to a million. */
static const BadCone bad_cones[] = {
    {"nearly a cylinder", {{0.5, -1, 0.25}, {0.5, 1, 0.25}, 1, 1 + 0x1p-20, true}},
    {"nearly a pipe", {{0.5, -1, 0.25}, {1, 1, 0.75}, 1 + 0x1p-20, 1, false}},
    {"a cylinder", {{0.5, -1, 0.25}, {1, 1, 0.75}, 0.75, 0.75, true}},
    {"a needle", {{-64, 0.5, 0}, {64, 0.25, 1}, 0.125, 0, true}},
    {"a flat roof", {{0, 0, 0}, {0, 0x1p-10, 0}, 1, 0, false}},
    {"a flat plate", {{0, 0, 0}, {0x1p-12, 0x1p-10, 0}, 0.5, 1, true}},
    {"a grain far away", {{1024, 512, -256}, {1024, 512 + 0x1p-10, -256}, 0x1p-11, 0, true}},
    {"a hill far away", {{65536, 0, 1024}, {65536, 300, 1024}, 400, 1, false}},
    {"3, 4, 5", {{0, 0, 0}, {0, 4, 0}, 3, 0, true}},
    {"3, 4, 5 upside down", {{0, 4, 0}, {0, 0, 0}, 0, 3, false}}};

/** Number of cones. */
enum { BAD_CONES = sizeof bad_cones / sizeof *bad_cones };

/** A cone in an engine. */
typedef struct ConeRun {
    const BadCone *cone;  /**< The cone. */
    ContractShape shape;  /**< The same for the reference. */
    const Engine *engine; /**< The engine. */
    Tracer *tracer;       /**< Its tracer. */
    double worst;         /**< Largest error of a point, over its own bound. */
} ConeRun;

/** @return The largest coordinate of a vector of three. */
static double largest(const double v[3]) {
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

/** @return Length of the axis plus the larger radius. */
static double size_of(const ConeSpec *spec) {
    double way[3] = {spec->top[0] - spec->base[0], spec->top[1] - spec->base[1],
                     spec->top[2] - spec->base[2]};
    return largest(way) + fmax(spec->radius, spec->top_radius);
}

/** @return The rows that the reference needs. */
static ContractShape shape_of(const ConeSpec *spec) {
    return (ContractShape){.name = "cone",
                           .keyword = "cone",
                           .parameters = spec,
                           .is_solid = spec->capped,
                           .size = size_of(spec),
                           .center = {(spec->base[0] + spec->top[0]) / 2,
                                      (spec->base[1] + spec->top[1]) / 2,
                                      (spec->base[2] + spec->top[2]) / 2},
                           .expected_hit = cone_expected_hit,
                           .tangent = cone_tangent};
}

/** Checks a ray: whether it hits, where, and that the point is as near as it says. */
static void check_ray(ConeRun *run, const RayQueryQuad *ray) {
    RayResult answer;
    run->engine->intersect(run->tracer, 1, ray, &answer);
    ExpectedHit expected = contract_expected_hit(&run->shape, ray);
    Vec3qa d = vec3qa_normalize(vec3qa_from_quads(ray->direction));
    Vec3qa o = vec3qa_from_quads(ray->origin);
    Quadruple length =
        quad_sqrt(vec3qa_dot(vec3qa_from_quads(ray->direction), vec3qa_from_quads(ray->direction)));
    Quadruple reach = quad_sqrt(vec3qa_dot(o, o)) + run->shape.size;
    Quadruple u = roundoff(run->engine);
    bool is_hit = answer.shape == 0;
    assert_int_equal(is_hit, answer.occluded);
    // The margin is relative to the larger radius.
    const ConeSpec *spec = run->shape.parameters;
    Quadruple radius = fmax(spec->radius, spec->top_radius);
    Quadruple least = ROUNDINGS * u * reach / radius + tolerance_of(&run->shape);
    if (!(expected.edge_margin >= least)) { // NaN at a tip.
        return;
    }
    if (is_hit != expected.is_hit) {
        fail_msg("%s in %s: hit %d, truth %d, margin %g, from %g %g %g along %g %g %g",
                 run->cone->name, run->engine->name, is_hit, expected.is_hit,
                 (double)expected.edge_margin, (double)ray->origin[0], (double)ray->origin[1],
                 (double)ray->origin[2], (double)ray->direction[0], (double)ray->direction[1],
                 (double)ray->direction[2]);
    }
    // In quad, the reference is not more precise than the engine.
    if (!is_hit || run->engine->mantissa_bits > 64) {
        return;
    }
    Vec3qa point = {{answer.point[0], answer.point[1], answer.point[2]}};
    Quadruple off = surface_distance(&run->shape, &point);
    run->worst = fmax(run->worst, (double)(off / answer.error));
    assert_at_most(off / answer.error, 1, "%s in %s, point against its own bound", run->cone->name,
                   run->engine->name);
    Quadruple sine = quad_abs(vec3qa_dot(d, expected.normal));
    Quadruple across = quad_abs(answer.distance - expected.t) * length * sine;
    assert_at_most(across / (u * reach), ROUNDINGS, "%s in %s, distance, half ulps",
                   run->cone->name, run->engine->name);
}

/** Makes rays for a cone. */
typedef void RayFamily(ConeRun *run);

/** Runs a family of rays for every cone in every engine. */
static void for_every_cone(RayFamily *family) {
    for (size_t i = 0; i < BAD_CONES; i++) {
        for (size_t e = 0; engine_list()[e]; e++) {
            const Engine *engine = engine_list()[e];
            if (!engine_is_supported(engine)) {
                continue;
            }
            Scene *scene = create_empty_scene();
            add_shape(scene, "cone", &bad_cones[i].spec);
            ConeRun run = {&bad_cones[i], shape_of(&bad_cones[i].spec), engine,
                           create_tracer(engine, scene), 0};
            family(&run);
            engine->destroy(run.tracer);
            scene_destroy(scene);
        }
    }
}

/** @return Number of rays: fewer for the slow reference. */
static int ray_count(const ConeRun *run) {
    return run->engine->mantissa_bits > 64 ? RAYS / 10 : RAYS;
}

/** @return A ray between two points, rounded to float. */
static RayQueryQuad ray_between(const double from[3], const double to[3]) {
    RayQueryQuad ray;
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = round_to_float(from[i]);
        ray.direction[i] = round_to_float(to[i] - (double)ray.origin[i]);
    }
    return ray;
}

/** Sets a random point in a cube around a cone. @param sizes Half its edge, in sizes. */
static void random_point(const ConeRun *run, uint64_t *state, double sizes, double point[3]) {
    for (int i = 0; i < 3; i++) {
        double reach = sizes * run->shape.size;
        point[i] = run->shape.center[i] + random_float(state, -reach, reach);
    }
}

/** Random rays from near and far. */
static void shoot_at_random(ConeRun *run) {
    uint64_t state = 11;
    for (int n = 0; n < ray_count(run); n++) {
        double from[3], to[3];
        random_point(run, &state, ldexp(1, n % 10), from);
        random_point(run, &state, 0.5, to);
        RayQueryQuad ray = ray_between(from, to);
        check_ray(run, &ray);
    }
}

/** Rays to points of the axis, the tip among them, and on beyond it. */
static void shoot_at_axis(ConeRun *run) {
    uint64_t state = 12;
    const ConeSpec *spec = run->shape.parameters;
    for (int n = 0; n < ray_count(run); n++) {
        double from[3], to[3], share = (n % 9 - 2) / 4.0;
        random_point(run, &state, 3, from);
        for (int i = 0; i < 3; i++) {
            to[i] = spec->base[i] + share * (spec->top[i] - spec->base[i]);
        }
        RayQueryQuad ray = ray_between(from, to);
        check_ray(run, &ray);
    }
}

/** Rays along the wall, inside and outside: one root of the quadratic is at infinity. */
static void shoot_along_wall(ConeRun *run) {
    uint64_t state = 13;
    const ConeSpec *spec = run->shape.parameters;
    for (int n = 0; n < ray_count(run); n++) {
        double from[3], to[3], side[3] = {n % 3 == 0, n % 3 == 1, n % 3 == 2};
        for (int i = 0; i < 3; i++) {
            from[i] = spec->base[i] + spec->radius * side[i];
            to[i] = spec->top[i] + spec->top_radius * side[i];
        }
        RayQueryQuad ray = ray_between(from, to);
        for (int i = 0; i < 3; i++) {
            double offset = random_float(&state, -1, 1) * run->shape.size;
            ray.origin[i] = round_to_float((double)ray.origin[i] + offset -
                                           4 * (n % 2) * (double)ray.direction[i]);
        }
        check_ray(run, &ray);
    }
}

/** @param state Not used. */
static void test_random_rays(void **state) {
    (void)state;
    for_every_cone(shoot_at_random);
}

/** @param state Not used. */
static void test_axis(void **state) {
    (void)state;
    for_every_cone(shoot_at_axis);
}

/** @param state Not used. */
static void test_wall(void **state) {
    (void)state;
    for_every_cone(shoot_along_wall);
}

/** @return The tracer of a scene of one shape, to be destroyed. */
static Tracer *tracer_of(const Engine *engine, const char *name, const void *parameters) {
    Scene *scene = create_empty_scene();
    add_shape(scene, name, parameters);
    Tracer *tracer = create_tracer(engine, scene);
    scene_destroy(scene);
    return tracer;
}

/** @return The result of a ray in a scene of one shape. */
static RayResult trace_one(const Engine *engine, const char *name, const void *parameters,
                           const RayQueryQuad *ray) {
    Tracer *tracer = tracer_of(engine, name, parameters);
    RayResult answer;
    engine->intersect(tracer, 1, ray, &answer);
    engine->destroy(tracer);
    return answer;
}

/** Beyond the tip of a cone is nothing, where its equation has a mirrored cone; on its wall of 3, 4
 *  and 5 a ray enters at a known point. */
static void test_closed_form(void **state) {
    (void)state;
    static const ConeSpec spec = {{0, 0, 0}, {0, 4, 0}, 3, 0, false};
    static const RayQueryQuad beyond = {{-10, 6, 0}, {1, 0, 0}};
    static const RayQueryQuad level = {{-10, 2, 0}, {1, 0, 0}};
    static const RayQueryQuad along = {{3, 4, 0}, {3, -4, 0}};
    static const RayQueryQuad inside = {{0, 1, 0}, {3, -4, 0}};
    for (size_t e = 0; engine_list()[e]; e++) {
        const Engine *engine = engine_list()[e];
        if (!engine_is_supported(engine)) {
            continue;
        }
        assert_int_equal(trace_one(engine, "cone", &spec, &beyond).shape, -1);
        RayResult hit = trace_one(engine, "cone", &spec, &level);
        assert_int_equal(hit.shape, 0);
        Quadruple u = roundoff(engine);
        // At height 2 the radius is 1.5; the normal is (-4, 3, 0) / 5.
        assert_at_most(quad_abs(hit.distance - (Quadruple)8.5), 16 * u * 10, "distance");
        assert_at_most(quad_abs(hit.normal[0] + (Quadruple)4 / 5), 16 * u, "normal x");
        assert_at_most(quad_abs(hit.normal[1] - (Quadruple)3 / 5), 16 * u, "normal y");
        // Along the wall, from 3 beside it: never met. From the axis to it: neither.
        assert_int_equal(trace_one(engine, "cone", &spec, &along).shape, -1);
        assert_int_equal(trace_one(engine, "cone", &spec, &inside).shape, -1);
    }
}

/** Compares the hits of a cone of equal radii with those of the cylinder. */
static void compare_with_cylinder(const Engine *engine) {
    static const ConeSpec cone = {{0.5, -1, 0.25}, {1, 1, 0.75}, 0.75, 0.75, true};
    static const CylinderSpec cylinder = {{0.5, -1, 0.25}, {1, 1, 0.75}, 0.75, true};
    Tracer *tracers[2] = {tracer_of(engine, "cone", &cone),
                          tracer_of(engine, "cylinder", &cylinder)};
    const double bound = 1024 * (double)roundoff(engine);
    uint64_t seed = 14;
    for (int n = 0; n < RAYS / 10; n++) {
        double from[3], to[3];
        for (int i = 0; i < 3; i++) {
            from[i] = random_float(&seed, -4, 4);
            to[i] = random_float(&seed, -0.5, 0.5);
        }
        RayQueryQuad ray = ray_between(from, to);
        RayResult a, b;
        engine->intersect(tracers[0], 1, &ray, &a);
        engine->intersect(tracers[1], 1, &ray, &b);
        if (cylinder_expected_hit(&cylinder, &ray).edge_margin < 1e-3) {
            continue;
        }
        assert_int_equal(a.shape, b.shape);
        if (a.shape == 0) {
            assert_at_most(quad_abs(a.distance - b.distance) / b.distance, bound, "t");
            assert_at_most(quad_abs(a.uv[1] - b.uv[1]), bound, "v");
            // 0 and 1 are the same angle.
            Quadruple turn = quad_abs(a.uv[0] - b.uv[0]);
            assert_at_most(quad_min(turn, quad_abs(1 - turn)), bound, "u");
        }
    }
    engine->destroy(tracers[0]);
    engine->destroy(tracers[1]);
}

/** A cone of equal radii has the hits of the cylinder, and its texture coordinates. */
static void test_cylinder(void **state) {
    (void)state;
    for (size_t e = 0; engine_list()[e]; e++) {
        if (engine_is_supported(engine_list()[e])) {
            compare_with_cylinder(engine_list()[e]);
        }
    }
}

/** Texture coordinates of a frustum: height along the wall, and disks of their own radii. */
static void test_texture(void **state) {
    (void)state;
    static const ConeSpec spec = {{0, 0, 0}, {0, 4, 0}, 3, 1, true};
    static const RayQueryQuad at_wall = {{10, 1, 0}, {-1, 0, 0}};
    static const RayQueryQuad on_top = {{0.5, 10, 0}, {0, -1, 0}};
    static const RayQueryQuad on_base = {{0, -10, 1.5}, {0, 1, 0}};
    for (size_t e = 0; engine_list()[e]; e++) {
        const Engine *engine = engine_list()[e];
        if (!engine_is_supported(engine)) {
            continue;
        }
        double u = 64 * (double)roundoff(engine);
        RayResult wall = trace_one(engine, "cone", &spec, &at_wall);
        assert_at_most(quad_abs(wall.uv[1] - (Quadruple)0.25), u, "height on the wall");
        RayResult top = trace_one(engine, "cone", &spec, &on_top);
        RayResult base = trace_one(engine, "cone", &spec, &on_base);
        // Half a radius from the middle, in a picture that is two radii wide.
        for (int k = 0; k < 2; k++) {
            const RayResult *hit = k ? &base : &top;
            Quadruple x = hit->uv[0] - (Quadruple)0.5, y = hit->uv[1] - (Quadruple)0.5;
            assert_at_most(quad_abs(quad_sqrt(x * x + y * y) - (Quadruple)0.25), u,
                           "radius on an end");
        }
    }
}

/** Runs the tests. @return 0 if all pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_rays), cmocka_unit_test(test_axis),
        cmocka_unit_test(test_wall),        cmocka_unit_test(test_closed_form),
        cmocka_unit_test(test_cylinder),    cmocka_unit_test(test_texture),
    };
    return cmocka_run_group_tests_name("cone", tests, NULL, NULL);
}
