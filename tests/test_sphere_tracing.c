/**
 * @file
 * @brief Tests of sphere tracing: distance fields against analytic shapes, in every engine. There
 *        is no tunnelling and no acne, and the error of the distance is within the tolerance.
 */
#include "sdf_builders.h"

/** Rays per comparison; the environment variable `SDF_RAYS` overrides it. */
enum { RAYS = 100000 };
/** The defaults of scene files. */
static const SdfShapeParameters usual = {.tolerance = 1e-4, .max_steps = 512};

/** A field and the equivalent analytic shapes. */
typedef struct TwinTracers {
    const char *name;      /**< Their name. */
    const Engine *engine;  /**< The engine. */
    Tracer *sphere_traced; /**< A scene with the field. */
    Tracer *analytic;      /**< A scene with the shapes. */
    double size;           /**< Radius of the sphere of origins; targets are nearer to the
                                centre. */
} TwinTracers;

/** Result of a comparison. */
typedef struct TwinComparison {
    long tunnelled_count;      /**< Rays that pass through the shape and miss the field. */
    long wrong_count;          /**< Rays that hit the field but pass the shape at a distance. */
    double max_distance_error; /**< Largest error of the distance times the sine of the angle, in
                                    tolerances. */
    double max_normal_error;   /**< Largest error of the normal, radians. */
} TwinComparison;

/**
 * @return A tracer with the surface of a field; the field is released.
 * @param row  Tolerance and step limit.
 */
static Tracer *marched(const Engine *engine, Sdf *field, SdfShapeParameters row) {
    Scene *scene = create_empty_scene();
    row.field = field;
    add_sdf(scene, row);
    Tracer *tracer = create_tracer(engine, scene);
    scene_destroy(scene);
    free(field);
    return tracer;
}

/** @return a . b */
static double dot(const Quadruple *a, const Quadruple *b) {
    return (double)(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

/** @return The length of a - b. */
static double distance_between(const Quadruple *a, const Quadruple *b) {
    Quadruple difference[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return sqrt(dot(difference, difference));
}

/** @return Sine of the angle at which a ray meets a surface. */
static double sine(const RayQueryQuad *ray, const RayResult *hit) {
    return fabs(dot(ray->direction, hit->normal)) / sqrt(dot(ray->direction, ray->direction));
}

/**
 * @return Whether a ray passes through a shape for a length that excludes a mere touch.
 * @param hit  Its first hit.
 */
static bool passes_clearly_through(const TwinTracers *tracers, const RayQueryQuad *ray,
                                   const RayResult *hit) {
    RayQueryQuad inside = *ray;
    RayResult out;
    double length = sqrt(dot(ray->direction, ray->direction));
    double step = 16 * usual.tolerance / (length * fmax(sine(ray, hit), 1e-3));
    for (int i = 0; i < 3; i++) {
        inside.origin[i] = hit->point[i] + step * ray->direction[i];
    }
    tracers->engine->intersect(tracers->analytic, 1, &inside, &out);
    return out.shape == hit->shape && dot(ray->direction, out.normal) > 0;
}

/**
 * @return Whether a ray would hit the shape if it were two tolerances nearer. A ray that passes
 *         within the tolerance is a valid hit.
 * @param hit  Its hit with the field.
 */
static bool nearly_touches(const TwinTracers *tracers, const RayQueryQuad *ray,
                           const RayResult *hit) {
    RayQueryQuad nearer = *ray;
    RayResult answer;
    for (int i = 0; i < 3; i++) {
        nearer.origin[i] -= 2 * usual.tolerance * hit->normal[i];
    }
    tracers->engine->intersect(tracers->analytic, 1, &nearer, &answer);
    return answer.shape >= 0;
}

/** @return A random ray from around the shape towards the centre. */
static RayQueryQuad random_ray(const TwinTracers *tracers, uint64_t *seed) {
    RayQueryQuad ray;
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = random_float(seed, -tracers->size, tracers->size);
        ray.direction[i] =
            round_to_float(random_float(seed, -1, 1) * 0.4 * tracers->size - (double)ray.origin[i]);
    }
    return ray;
}

/**
 * @return Whether a ray starts within the tolerance of a surface: then it is on it, and leaves it.
 */
static bool starts_on_surface(const RayQueryQuad *ray, const RayResult *truth) {
    double length = sqrt(dot(ray->direction, ray->direction));
    return truth->shape >= 0 &&
           (double)truth->distance * length * sine(ray, truth) <= usual.tolerance;
}

/** Compares one result with that of the analytic shape. */
static void compare_one(const TwinTracers *tracers, const RayQueryQuad *ray, const RayResult *it,
                        const RayResult *truth, TwinComparison *result) {
    assert_int_equal(it->shape >= 0, it->occluded);
    if (starts_on_surface(ray, truth)) {
        return;
    }
    if (truth->shape >= 0 && it->shape >= 0) {
        double length = sqrt(dot(ray->direction, ray->direction));
        double error = fabs((double)(it->distance - truth->distance)) * length;
        double turn = distance_between(it->normal, truth->normal);
        if (error < 0.01 * tracers->size && passes_clearly_through(tracers, ray, truth)) {
            result->max_distance_error =
                fmax(result->max_distance_error, error * sine(ray, truth) / usual.tolerance);
            result->max_normal_error =
                fmax(result->max_normal_error, sine(ray, truth) > 0.1 ? turn : 0);
        }
    } else if (truth->shape >= 0) {
        result->tunnelled_count += passes_clearly_through(tracers, ray, truth);
    } else if (it->shape >= 0) {
        result->wrong_count += !nearly_touches(tracers, ray, it);
    }
}

/** @return The comparison; both tracers are destroyed. */
static TwinComparison compare(const TwinTracers *tracers) {
    const char *message = getenv("SDF_RAYS");
    long count = ray_count_for(tracers->engine, message ? atol(message) : RAYS);
    TwinComparison result = {0};
    uint64_t seed = 1;
    static RayQueryQuad rays[BATCH];
    static RayResult found[BATCH], truth[BATCH];
    for (long done = 0; done < count; done += BATCH) {
        for (int i = 0; i < BATCH; i++) {
            rays[i] = random_ray(tracers, &seed);
        }
        tracers->engine->intersect(tracers->sphere_traced, BATCH, rays, found);
        tracers->engine->intersect(tracers->analytic, BATCH, rays, truth);
        for (int i = 0; i < BATCH; i++) {
            compare_one(tracers, &rays[i], &found[i], &truth[i], &result);
        }
    }
    printf("  %-16s %-7s t %.3f tolerances / sine, normal %.1e rad, tunnelled %ld, wrong %ld\n",
           tracers->name, tracers->engine->name, result.max_distance_error, result.max_normal_error,
           result.tunnelled_count, result.wrong_count);
    tracers->engine->destroy(tracers->sphere_traced);
    tracers->engine->destroy(tracers->analytic);
    return result;
}

/** Asserts that a field equals the analytic shapes within the tolerances. */
static void assert_alike(const TwinTracers *tracers) {
    TwinComparison result = compare(tracers);
    assert_at_most(result.tunnelled_count, 0, "%s in %s, tunnelled", tracers->name,
                   tracers->engine->name);
    assert_at_most(result.wrong_count, 0, "%s in %s, wrong", tracers->name, tracers->engine->name);
    assert_at_most(result.max_distance_error, 1.01, "%s in %s, distance", tracers->name,
                   tracers->engine->name);
    assert_at_most(result.max_normal_error, 1e-4, "%s in %s, normal", tracers->name,
                   tracers->engine->name);
}

/** A sphere. */
static void sphere_twins(const Engine *engine) {
    Scene *scene = create_empty_scene();
    add_shape(scene, "sphere", &(SphereParameters){{0, 0, 0}, 1});
    assert_alike(&(TwinTracers){"sphere", engine, marched(engine, make_sdf("sphere", NULL), usual),
                                create_tracer(engine, scene), 4});
    scene_destroy(scene);
}

/** A box. */
static void box_twins(const Engine *engine) {
    Scene *scene = create_empty_scene();
    add_shape(scene, "box", &(BoxParameters){{-0.5, -1, -1.5}, {0.5, 1, 1.5}});
    Sdf *box = make_sdf("box", (double[]){1, 2, 3});
    assert_alike(&(TwinTracers){"box", engine, marched(engine, box, usual),
                                create_tracer(engine, scene), 4});
    scene_destroy(scene);
}

/** The top of a box that is as large as the ground. */
static void ground_twins(const Engine *engine) {
    Scene *scene = create_empty_scene();
    add_shape(scene, "box", &(BoxParameters){{-64, -8, -64}, {64, 0, 64}});
    Sdf *box = translate_sdf(make_sdf("box", (double[]){128, 8, 128}), 0, -4, 0);
    SdfShapeParameters patient = {.tolerance = usual.tolerance, .max_steps = 20000};
    assert_alike(&(TwinTracers){"ground", engine, marched(engine, box, patient),
                                create_tracer(engine, scene), 4});
    scene_destroy(scene);
}

/**
 * Repeated spheres off the centres of their cells, against a list. Evaluating only the point's own
 * cell would be wrong.
 */
static void repeated_twins(const Engine *engine) {
    Scene *scene = create_empty_scene();
    for (int n = 0; n < 7 * 7 * 7; n++) {
        Vec3d center = {n % 7 - 3 + 0.25, n / 7 % 7 - 3 - 0.125, n / 49 - 3 + 0.0625};
        add_shape(scene, "sphere", &(SphereParameters){center, 0.25});
    }
    Sdf *sphere = translate_sdf(make_sdf("sphere", (double[]){0.25}), 0.25, -0.125, 0.0625);
    Sdf *all = repeat_sdf(sphere, (SdfRepetition){{1, 1, 1}, {7, 7, 7}});
    assert_alike(&(TwinTracers){"repeated balls", engine, marched(engine, all, usual),
                                create_tracer(engine, scene), 6});
    scene_destroy(scene);
}

/**
 * Rotated spheres in their cells, and a rotated repetition grid: transforms that are applied once
 * per ray.
 */
static void leaning_twins(const Engine *engine) {
    Error error = {0};
    Scene *scene = create_empty_scene();
    Transform inner = {
        .scale = {0.5, 0.5, 0.5}, .rotate = {50, 0, 70}, .translate = {0.125, -0.25, 0}};
    Transform outer = {
        .scale = {1.25, 1.25, 1.25}, .rotate = {20, 30, 40}, .translate = {0.5, 0.25, -0.25}};
    assert_true(transform_keyword.finish(&outer, 0, &error));
    for (int n = 0; n < 4 * 4 * 4; n++) {
        Vec3d p = vec3d_add((Vec3d){n % 4 - 1.5, n / 4 % 4 - 1.5, n / 16 - 1.5}, inner.translate);
        const double(*m)[3] = (const double(*)[3])outer.matrix;
        Vec3d turned = {m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z,
                        m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z,
                        m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z};
        add_shape(scene, "sphere", &(SphereParameters){vec3d_add(turned, outer.translate), 0.3125});
    }
    Sdf *sphere = transform_sdf(make_sdf("sphere", (double[]){0.5}), inner);
    Sdf *all = transform_sdf(repeat_sdf(sphere, (SdfRepetition){{1, 1, 1}, {4, 4, 4}}), outer);
    assert_alike(&(TwinTracers){"leaning balls", engine, marched(engine, all, usual),
                                create_tracer(engine, scene), 6});
    scene_destroy(scene);
}

/** Spheres that extend into adjacent cells, so that all neighbours are evaluated. */
static void reaching_twins(const Engine *engine) {
    Scene *scene = create_empty_scene();
    for (int n = 0; n < 5 * 5 * 5; n++) {
        Vec3d center = {n % 5 - 2 + 0.375, n / 5 % 5 - 2 - 0.4375, n / 25 - 2 + 0.5};
        add_shape(scene, "sphere", &(SphereParameters){center, 0.25});
    }
    Sdf *sphere = translate_sdf(make_sdf("sphere", (double[]){0.25}), 0.375, -0.4375, 0.5);
    Sdf *all = repeat_sdf(sphere, (SdfRepetition){{1, 1, 1}, {5, 5, 5}});
    assert_alike(&(TwinTracers){"reaching balls", engine, marched(engine, all, usual),
                                create_tracer(engine, scene), 5});
    scene_destroy(scene);
}

/** Compares fields and analytic shapes in every engine. */
static void test_twins(void **state) {
    (void)state;
    for_every_engine(sphere_twins);
    for_every_engine(box_twins);
    for_every_engine(ground_twins);
    for_every_engine(repeated_twins);
    for_every_engine(leaning_twins);
    for_every_engine(reaching_twins);
}

/* --- leaving a surface -------------------------------------------------------------------------
 */

/** @return A box with a sphere in it and a groove, rotated: a field with all kinds of edges. */
static Sdf *edged_solid(void) {
    Sdf *box = make_sdf("box", (double[]){1.5, 1, 1});
    Sdf *sphere = translate_sdf(make_sdf("sphere", (double[]){0.5}), 0.25, 0.5, 0);
    Sdf *both = join_sdfs(SDF_COMBINE_SMOOTH_UNION, box, sphere, 0.25);
    Sdf *ring = translate_sdf(make_sdf("torus", (double[]){0.75, 0.125}), 0, 0, 0.5);
    Transform leaning = {.scale = {1, 1, 1}, .rotate = {20, 30, 40}, .translate = {0.5, 0, 0}};
    return transform_sdf(join_sdfs(SDF_COMBINE_DIFFERENCE, both, ring, 0), leaning);
}

/**
 * Rays that leave a sphere outwards hit nothing; inwards they hit the opposite side, from inside.
 */
static void check_offset_rays(const Engine *engine) {
    Tracer *tracer = marched(engine, make_sdf("sphere", NULL), usual);
    uint64_t seed = 1;
    const TwinTracers aim = {.size = 4};
    for (long left = 0; left < ray_count_for(engine, RAYS);) {
        RayQueryQuad ray = random_ray(&aim, &seed), second_ray;
        RayResult hit, again;
        engine->intersect(tracer, 1, &ray, &hit);
        if (hit.shape < 0) {
            continue;
        }
        left++;
        int side = left % 2 ? 1 : -1;
        for (int i = 0; i < 3; i++) {
            second_ray.origin[i] = hit.point[i] + side * hit.error * hit.normal[i];
            second_ray.direction[i] = random_float(&seed, -1, 1);
        }
        double cosine = dot(second_ray.direction, hit.normal) * side;
        for (int i = 0; i < 3; i++) {
            second_ray.direction[i] =
                cosine > 0 ? second_ray.direction[i] : -second_ray.direction[i];
        }
        engine->intersect(tracer, 1, &second_ray, &again);
        assert_int_equal(again.shape, side > 0 ? -1 : 0);
        if (side < 0) {
            // A chord of the unit sphere has twice the length of the cosine.
            double length = sqrt(dot(second_ray.direction, second_ray.direction));
            double chord = 2 * fabs(cosine) / length;
            double way = (double)again.distance * length;
            assert_at_most(fabs(way - chord), 0.02 + 0.02 * chord, "chord in %s", engine->name);
        }
    }
    engine->destroy(tracer);
}

/** There is no acne, in any engine. */
static void test_offset_rays(void **state) {
    (void)state;
    for_every_engine(check_offset_rays);
}

/* --- inside a solid --------------------------------------------------------------------------- */

/** @return Whether a point is in the solid of a sponge of edge 1 with two sizes of holes: in the
 * base of three, a hole has the digit 1 along two axes. */
static bool is_in_sponge(const double *p) {
    bool is_solid = true;
    for (int cells = 3; cells <= 9; cells *= 3) {
        int middles = 0;
        for (int axis = 0; axis < 3; axis++) {
            int cell = (int)floor((p[axis] + 0.5) * cells);
            is_solid = is_solid && fabs(p[axis]) < 0.5;
            middles += cell % 3 == 1;
        }
        is_solid = is_solid && middles < 2;
    }
    return is_solid;
}

/** @return Whether a point lies deeper in the solid than a number of tolerances. */
static bool is_deep_in_sponge(const Quadruple *point, double tolerances) {
    bool is_deep = true;
    for (int corner = 0; corner < 8; corner++) {
        double p[3];
        for (int axis = 0; axis < 3; axis++) {
            double margin = tolerances * usual.tolerance;
            p[axis] = (double)point[axis] + (corner >> axis & 1 ? margin : -margin);
        }
        is_deep = is_deep && is_in_sponge(p);
    }
    return is_deep;
}

/** Rays that start in the solid of a sponge, as in glass, meet nothing but its surface. */
static void check_rays_in_sponge(const Engine *engine) {
    uint64_t seed = 3;
    long false_count = 0, missed_count = 0, count = 0;
    Sdf *sponge = make_sdf("menger", NULL);
    sponge->nodes[0].operands[1] = 2; // Sizes of holes.
    Tracer *tracer = marched(engine, sponge, usual);
    for (int i = 0; i < 4000; i++) {
        RayQueryQuad ray;
        RayResult hit;
        for (int axis = 0; axis < 3; axis++) {
            ray.origin[axis] = random_float(&seed, -0.5, 0.5);
            ray.direction[axis] = random_float(&seed, -1, 1);
        }
        if (!is_deep_in_sponge(ray.origin, 64)) {
            continue;
        }
        engine->intersect(tracer, 1, &ray, &hit);
        count++;
        missed_count += hit.shape < 0;
        false_count += hit.shape >= 0 && is_deep_in_sponge(hit.point, 4);
    }
    engine->destroy(tracer);
    assert_true(count > 500);
    assert_at_most(missed_count, 0, "%s: rays that leave a sponge unseen", engine->name);
    assert_at_most(false_count, 0, "%s: surfaces within the solid of a sponge", engine->name);
}

/** @param state Not used. */
static void test_rays_in_sponge(void **state) {
    (void)state;
    for_every_engine(check_rays_in_sponge);
}

/** Mandelbulbs are seen in each number type: orbits escape before their squares overflow float. */
static void check_mandelbulb_powers(const Engine *engine) {
    /** Rays per power: enough in sanitizer builds, too; quadruple precision is slow. */
    const int count = engine->mantissa_bits > 64 ? 16 : 256;
    Error error = {0};
    const Engine *reference = engine_find("f64x1", &error);
    const TwinTracers aim = {.size = 1.2};
    static RayQueryQuad rays[BATCH];
    static RayResult found[BATCH], expected[BATCH];
    uint64_t seed = 5;
    for (int power = 2; power <= SDF_BULB_POWER_MAXIMUM; power++) {
        Sdf *fields[2];
        for (int i = 0; i < 2; i++) {
            fields[i] = make_sdf("mandelbulb", (int[]){power, 8});
        }
        Tracer *tracer = marched(engine, fields[0], usual);
        Tracer *exact = marched(reference, fields[1], usual);
        int hit_count = 0, different_count = 0;
        for (int i = 0; i < count; i++) {
            rays[i] = random_ray(&aim, &seed);
        }
        engine->intersect(tracer, (size_t)count, rays, found);
        reference->intersect(exact, (size_t)count, rays, expected);
        for (int i = 0; i < count; i++) {
            hit_count += expected[i].shape >= 0;
            different_count += found[i].shape != expected[i].shape;
        }
        engine->destroy(tracer);
        reference->destroy(exact);
        assert_true(hit_count > count / 20);
        // A ray may pass beside a hair of it by a rounding.
        assert_at_most((double)different_count / count, 0.01,
                       "%s: hits of a Mandelbulb of power %d", engine->name, power);
    }
}

/** @param state Not used. */
static void test_mandelbulb_powers(void **state) {
    (void)state;
    for_every_engine(check_mandelbulb_powers);
}

/* --- equal bits ------------------------------------------------------------------------------- */

/** Wide engines return the bits of narrow ones. */
static void check_lane_widths(const Engine *engine) {
    Error error = {0};
    const Engine *narrow = engine_find(engine->mantissa_bits == 24   ? "f32x1"
                                       : engine->mantissa_bits == 53 ? "f64x1"
                                                                     : "f128x1",
                                       &error);
    Sdf *(*const things[])(void) = {edged_solid};
    const TwinTracers aim = {.size = 4};
    uint64_t seed = 3;
    static RayQueryQuad rays[BATCH];
    static RayResult a[BATCH], b[BATCH];
    for (int kind = 0; kind < 5; kind++) {
        Sdf *fields[2];
        for (int i = 0; i < 2; i++) {
            fields[i] = kind == 0   ? things[0]()
                        : kind == 1 ? make_sdf("mandelbulb", (int[]){8, 5})
                        : kind == 2 ? many_solids(MANY_SOLIDS)
                        : kind == 3 ? many_solids_behind(translate_sdf(rooted_field(), 0.1, 0, 0),
                                                         MANY_SOLIDS)
                                    : repeat_sdf(make_sdf("menger", NULL),
                                                 (SdfRepetition){{1.5, 0, 1.25}, {0, 0, 2}});
        }
        Tracer *wide = marched(engine, fields[0], usual);
        Tracer *one = marched(narrow, fields[1], usual);
        int count = (int)ray_count_for(engine, BATCH);
        for (int i = 0; i < count; i++) {
            rays[i] = random_ray(&aim, &seed);
        }
        engine->intersect(wide, (size_t)count, rays, a);
        narrow->intersect(one, (size_t)count, rays, b);
        for (int i = 0; i < count; i++) {
            assert_int_equal(a[i].shape, b[i].shape);
            assert_memory_equal(&a[i].distance, &b[i].distance, sizeof a[i].distance);
            assert_memory_equal(a[i].point, b[i].point, sizeof a[i].point);
            assert_memory_equal(a[i].normal, b[i].normal, sizeof a[i].normal);
        }
        engine->destroy(wide);
        narrow->destroy(one);
    }
}

/** @param state Not used. */
static void test_same_bits(void **state) {
    (void)state;
    for_every_engine(check_lane_widths);
}

/* --- the order of hits ------------------------------------------------------------------------ */

/** @return A scene with surfaces of two coarse fields that cross, or with one of them.
 *  @param which Bits: 1: a torus; 2: a box. @param is_repeated Whether there are copies of the box
 *  without end. */
static Scene *crossing_fields(int which, int max_steps, bool is_repeated) {
    const SdfRepetition endless = {{2.5, 2.5, 2.5}, {0, 0, 0}};
    Scene *scene = create_empty_scene();
    for (int i = 0; i < 2; i++) {
        Sdf *field = i == 0
                         ? make_sdf("torus", (double[]){1, 0.4})
                         : translate_sdf(make_sdf("box", (double[]){0.9, 0.3, 0.9}), 0.1, 0.2, 0);
        field = i == 1 && is_repeated ? repeat_sdf(field, endless) : field;
        if (which & 1 << i) {
            add_sdf(scene, (SdfShapeParameters){field, .tolerance = 0.05, .max_steps = max_steps});
        }
        free(field);
    }
    return scene;
}

/** A ray meets the nearer of two surfaces, where it meets that surface without the other: what was
 *  hit before does not change its path, though the tolerance is coarse or the steps are few. */
static void check_crossing_fields(const Engine *engine, bool is_repeated) {
    enum { COUNT = 32768 };
    static const int limits[] = {4, 6, 8, 512};
    static RayQuery rays[COUNT];
    static int shapes[3][COUNT];
    static double distances[3][COUNT];
    uint64_t seed = 9;
    for (int i = 0; i < COUNT; i++) {
        RayQueryQuad ray = random_ray(&(TwinTracers){.size = 3}, &seed);
        for (int axis = 0; axis < 3; axis++) {
            rays[i].origin[axis] = (double)ray.origin[axis];
            rays[i].direction[axis] = (double)ray.direction[axis];
        }
    }
    for (size_t limit = 0; limit < sizeof limits / sizeof limits[0]; limit++) {
        const long count = ray_count_for(engine, COUNT);
        for (int which = 1; which <= 3; which++) {
            Scene *scene = crossing_fields(which, limits[limit], is_repeated);
            Tracer *tracer = create_tracer(engine, scene);
            scene_destroy(scene);
            engine->closest_hits(tracer, (size_t)count, rays, shapes[which - 1],
                                 distances[which - 1]);
            engine->destroy(tracer);
        }
        long both = 0;
        for (long i = 0; i < count; i++) {
            bool is_torus =
                shapes[0][i] >= 0 && (shapes[1][i] < 0 || distances[0][i] <= distances[1][i]);
            int shape = is_torus ? 0 : shapes[1][i] >= 0 ? 1 : -1;
            both += shapes[0][i] >= 0 && shapes[1][i] >= 0;
            assert_int_equal(shapes[2][i], shape);
            assert_true(shape < 0 || distances[2][i] == distances[shape][i]);
        }
        assert_true(both * 16 > count);
    }
}

/** #check_crossing_fields, in boxes and in the cells of a grid. */
static void check_order_of_hits(const Engine *engine) {
    check_crossing_fields(engine, false);
    check_crossing_fields(engine, true);
}

/** @param state Not used. */
static void test_order_of_hits(void **state) {
    (void)state;
    for_every_engine(check_order_of_hits);
}

/* --- the footprint of pixels ------------------------------------------------------------------ */

/**
 * @return A tracer with the surface of a field, viewed from the origin in a picture of 800 pixels;
 *         the field is released.
 */
static Tracer *tracer_with_footprint(const Engine *engine, Sdf *field, double footprint) {
    Error error = {0};
    Scene *scene = create_empty_scene();
    SdfShapeParameters row = {field, usual.tolerance, usual.max_steps};
    add_sdf(scene, row);
    TraceSettings settings = {.offset = OFFSET_BOUND, .footprint = footprint};
    Tracer *tracer = engine->create_tracer(scene, &settings, &error);
    assert_non_null(tracer);
    engine->set_view(tracer, scene, 800, 600);
    scene_destroy(scene);
    free(field);
    return tracer;
}

/**
 * Infinitely repeated spheres. If details below the footprint are omitted, every ray hits a sphere;
 * else some rays never stop. A hit is no farther from a sphere than the footprint.
 */
static void check_footprint_culling(const Engine *engine) {
    const double share = 4, fov = ((const SceneCamera *)scene_camera_keyword.defaults)->fov;
    const double spread = share * tan(0.5 * fov * M_PI / 180) / 800;
    const SdfRepetition endless = {{1, 1, 1}, {0, 0, 0}};
    uint64_t stalled[2];
    for (int with = 0; with < 2; with++) {
        Sdf *sphere = translate_sdf(make_sdf("sphere", (double[]){0.0625}), 0.25, 0.125, 0.25);
        Tracer *tracer =
            tracer_with_footprint(engine, repeat_sdf(sphere, endless), with ? share : 0);
        uint64_t seed = 5;
        for (long i = 0; i < ray_count_for(engine, RAYS) / 10; i++) {
            RayQueryQuad ray = random_ray(&(TwinTracers){.size = 4}, &seed);
            RayQuery plain = {.origin = {0, 0, 0}};
            int shape;
            double t, length = sqrt(dot(ray.direction, ray.direction)), error = 0;
            for (int axis = 0; axis < 3; axis++) {
                plain.direction[axis] = (double)ray.direction[axis];
            }
            engine->closest_hits(tracer, 1, &plain, &shape, &t);
            for (int axis = 0; shape >= 0 && axis < 3; axis++) {
                double x = t * plain.direction[axis] - (axis == 1 ? 0.125 : 0.25);
                error += (x - floor(x + 0.5)) * (x - floor(x + 0.5));
            }
            double tolerance = fmax(usual.tolerance, with * spread * t * length);
            double maximum = 1.01 * tolerance + 1e-6 * t * length;
            assert_at_most(shape >= 0 ? fabs(sqrt(error) - 0.0625) : 0, maximum, "off in %s",
                           engine->name);
        }
        stalled[with] = engine->stats(tracer).step_limit_count;
        engine->destroy(tracer);
    }
    assert_true(stalled[0] > 0 || engine->mantissa_bits > 64); // Quad traces too few rays for that.
    assert_int_equal(stalled[1], 0);
}

/** @param state Not used. */
static void test_footprint(void **state) {
    (void)state;
    for_every_engine(check_footprint_culling);
}

/* --- the step limit --------------------------------------------------------------------------- */

/** Rays at the step limit are counted. They are hits only near a surface. */
static void check_step_limit(const Engine *engine) {
    SdfShapeParameters hasty = {.tolerance = usual.tolerance, .max_steps = 3};
    Tracer *tracer = marched(engine, make_sdf("sphere", NULL), hasty);
    RayQueryQuad grazing = {{-4, 0.75, 0.75}, {1, 0, 0}}, straight = {{-4, 0, 0}, {1, 0, 0}};
    RayResult answer;
    engine->intersect(tracer, 1, &grazing, &answer);
    assert_int_equal(answer.shape, -1);
    assert_true(engine->stats(tracer).step_limit_count > 0);
    engine->destroy(tracer);
    tracer = marched(engine, make_sdf("sphere", NULL), hasty);
    engine->intersect(tracer, 1, &straight, &answer);
    assert_int_equal(answer.shape, 0);
    assert_int_equal(engine->stats(tracer).step_limit_count, 0);
    engine->destroy(tracer);
}

/** @return Whether a ray along the axis of a torus hits it, in its hole.
 *  @param minor Radius of the tube; that of the ring is 1. */
static bool hits_hole(const Engine *engine, double minor, int max_steps) {
    SdfShapeParameters coarse = {.tolerance = 0.02, .max_steps = max_steps};
    Tracer *tracer = marched(engine, make_sdf("torus", (double[]){1, minor}), coarse);
    RayQueryQuad along = {{0, 4, 0}, {0, -1, 0}};
    RayResult answer;
    engine->intersect(tracer, 1, &along, &answer);
    engine->destroy(tracer);
    return answer.shape >= 0;
}

/** A ray that is given up within 8 tolerances of a surface hits it; one that is farther away misses
 *  it, as one does that has steps enough. */
static void check_given_up(const Engine *engine) {
    int hits = 0;
    for (int max_steps = 1; max_steps < 8; max_steps++) {
        hits += hits_hole(engine, 0.9, max_steps);
        assert_false(hits_hole(engine, 0.5, max_steps));
    }
    assert_true(hits > 0);
    assert_false(hits_hole(engine, 0.9, 512));
}

/** @param state Not used. */
static void test_step_limit(void **state) {
    (void)state;
    for_every_engine(check_step_limit);
    for_every_engine(check_given_up);
}

/** Runs the tests. @return 0 if all pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_twins),          cmocka_unit_test(test_offset_rays),
        cmocka_unit_test(test_rays_in_sponge), cmocka_unit_test(test_mandelbulb_powers),
        cmocka_unit_test(test_same_bits),      cmocka_unit_test(test_order_of_hits),
        cmocka_unit_test(test_footprint),      cmocka_unit_test(test_step_limit),
    };
    return cmocka_run_group_tests_name("marching", tests, NULL, NULL);
}
