/**
 * @file
 * @brief Marching: fields beside their analytic twins, in every engine. Nothing is tunnelled,
 * nothing is met twice, and the distance is as good as the tolerance promises.
 */
#include "field_making.h"

/** Rays of each comparison; `SDF_RAYS` in the environment asks for others. */
enum { RAYS = 100000 };
/** As in scene files. */
static const SdfRow usual = {.tolerance = 1e-4, .max_steps = 512};

/** A field and shapes that are the same. */
typedef struct Twins {
    const char *name;     /**< Their name. */
    const Engine *engine; /**< The engine. */
    Tracer *marched;      /**< A scene with the field. */
    Tracer *analytic;     /**< A scene with the shapes. */
    double size;          /**< Rays come from so far, and aim at less. */
} Twins;

/** What comparing twins came to. */
typedef struct Comparison {
    long tunnelled;    /**< Rays that go through the shape and did not meet the field. */
    long wrong;        /**< Rays that met the field and go by at a distance. */
    double worst_t;    /**< Worst error of the distance times the sine, in tolerances. */
    double worst_turn; /**< Worst error of the normal, radians. */
} Comparison;

/** @return A tracer with the surface of a field; the field is given back. @param engine The engine.
 *  @param field The field. @param row How near, and how many steps. */
static Tracer *marched(const Engine *engine, Field *field, SdfRow row) {
    Scene *scene = empty_scene();
    row.field = field;
    add_sdf(scene, row);
    Tracer *tracer = prepare(engine, scene);
    scene_destroy(scene);
    free(field);
    return tracer;
}

/** @return a . b @param a Three numbers. @param b Three numbers. */
static double dot(const Quadruple *a, const Quadruple *b) {
    return (double)(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

/** @return The length of a - b. @param a Three numbers. @param b Three numbers. */
static double apart(const Quadruple *a, const Quadruple *b) {
    Quadruple difference[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return sqrt(dot(difference, difference));
}

/** @return Sine of the angle at which a ray meets a surface. @param ray The ray. @param hit Where.
 */
static double sine(const RayQuery *ray, const RayAnswer *hit) {
    return fabs(dot(ray->direction, hit->normal)) / sqrt(dot(ray->direction, ray->direction));
}

/**
 * @return Whether a ray goes into a shape for so long that nobody can say it just touches it.
 * @param twins  The shape.
 * @param ray    The ray.
 * @param hit    Where it meets it first.
 */
static bool goes_through(const Twins *twins, const RayQuery *ray, const RayAnswer *hit) {
    RayQuery inside = *ray;
    RayAnswer out;
    double length = sqrt(dot(ray->direction, ray->direction));
    double step = 16 * usual.tolerance / (length * fmax(sine(ray, hit), 1e-3));
    for (int i = 0; i < 3; i++) {
        inside.origin[i] = hit->point[i] + step * ray->direction[i];
    }
    twins->engine->intersect(twins->analytic, 1, &inside, &out);
    return out.shape == hit->shape && dot(ray->direction, out.normal) > 0;
}

/**
 * @return Whether a ray would meet a shape if it were two tolerances nearer: who goes by within the
 *         tolerance counts as a hit.
 * @param twins  The shape.
 * @param ray    The ray.
 * @param hit    Where it meets the field.
 */
static bool touches(const Twins *twins, const RayQuery *ray, const RayAnswer *hit) {
    RayQuery nearer = *ray;
    RayAnswer answer;
    for (int i = 0; i < 3; i++) {
        nearer.origin[i] -= 2 * usual.tolerance * hit->normal[i];
    }
    twins->engine->intersect(twins->analytic, 1, &nearer, &answer);
    return answer.shape >= 0;
}

/** @return A ray from around towards the middle. @param twins What it aims at. @param[in,out] seed
 * A generator. */
static RayQuery random_ray(const Twins *twins, uint64_t *seed) {
    RayQuery ray;
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = random_float(seed, -twins->size, twins->size);
        ray.direction[i] =
            as_float(random_float(seed, -1, 1) * 0.4 * twins->size - (double)ray.origin[i]);
    }
    return ray;
}

/** @return Whether a ray starts within the tolerance of a surface: then it is on it, and leaves it.
 *  @param ray The ray. @param truth What it meets. */
static bool starts_on(const RayQuery *ray, const RayAnswer *truth) {
    double length = sqrt(dot(ray->direction, ray->direction));
    return truth->shape >= 0 &&
           (double)truth->distance * length * sine(ray, truth) <= usual.tolerance;
}

/** Compares one answer with its twin. @param twins What was asked. @param ray The ray.
 *  @param it What marching found. @param truth What there is. @param[in,out] result The errors. */
static void compare_one(const Twins *twins, const RayQuery *ray, const RayAnswer *it,
                        const RayAnswer *truth, Comparison *result) {
    assert_int_equal(it->shape >= 0, it->blocked);
    if (starts_on(ray, truth)) {
        return;
    }
    if (truth->shape >= 0 && it->shape >= 0) {
        double length = sqrt(dot(ray->direction, ray->direction));
        double off = fabs((double)(it->distance - truth->distance)) * length;
        double turn = apart(it->normal, truth->normal);
        if (off < 0.01 * twins->size && goes_through(twins, ray, truth)) {
            result->worst_t = fmax(result->worst_t, off * sine(ray, truth) / usual.tolerance);
            result->worst_turn = fmax(result->worst_turn, sine(ray, truth) > 0.1 ? turn : 0);
        }
    } else if (truth->shape >= 0) {
        result->tunnelled += goes_through(twins, ray, truth);
    } else if (it->shape >= 0) {
        result->wrong += !touches(twins, ray, it);
    }
}

/** @return What comparing twins came to; both are given back. @param twins The twins. */
static Comparison compare(const Twins *twins) {
    const char *asked = getenv("SDF_RAYS");
    long count = scaled(twins->engine, asked ? atol(asked) : RAYS);
    Comparison result = {0};
    uint64_t seed = 1;
    static RayQuery rays[BATCH];
    static RayAnswer found[BATCH], truth[BATCH];
    for (long done = 0; done < count; done += BATCH) {
        for (int i = 0; i < BATCH; i++) {
            rays[i] = random_ray(twins, &seed);
        }
        twins->engine->intersect(twins->marched, BATCH, rays, found);
        twins->engine->intersect(twins->analytic, BATCH, rays, truth);
        for (int i = 0; i < BATCH; i++) {
            compare_one(twins, &rays[i], &found[i], &truth[i], &result);
        }
    }
    printf("  %-16s %-7s t %.3f tolerances / sine, normal %.1e rad, tunnelled %ld, wrong %ld\n",
           twins->name, twins->engine->name, result.worst_t, result.worst_turn, result.tunnelled,
           result.wrong);
    twins->engine->release(twins->marched);
    twins->engine->release(twins->analytic);
    return result;
}

/** Asserts that a field is as good as its twin. @param twins The twins. */
static void assert_alike(const Twins *twins) {
    Comparison result = compare(twins);
    assert_at_most(result.tunnelled, 0, "%s in %s, tunnelled", twins->name, twins->engine->name);
    assert_at_most(result.wrong, 0, "%s in %s, wrong", twins->name, twins->engine->name);
    assert_at_most(result.worst_t, 1.01, "%s in %s, distance", twins->name, twins->engine->name);
    assert_at_most(result.worst_turn, 1e-4, "%s in %s, normal", twins->name, twins->engine->name);
}

/** A ball. @param engine The engine. */
static void sphere_twins(const Engine *engine) {
    Scene *scene = empty_scene();
    add_shape(scene, "sphere", &(SphereParameters){{0, 0, 0}, 1});
    assert_alike(&(Twins){"sphere", engine, marched(engine, single("sphere", NULL), usual),
                          prepare(engine, scene), 4});
    scene_destroy(scene);
}

/** A box. @param engine The engine. */
static void box_twins(const Engine *engine) {
    Scene *scene = empty_scene();
    add_shape(scene, "box", &(BoxParameters){{-0.5, -1, -1.5}, {0.5, 1, 1.5}});
    Field *box = single("box", (double[]){1, 2, 3});
    assert_alike(&(Twins){"box", engine, marched(engine, box, usual), prepare(engine, scene), 4});
    scene_destroy(scene);
}

/** The top of a box that is as large as the ground. @param engine The engine. */
static void ground_twins(const Engine *engine) {
    Scene *scene = empty_scene();
    add_shape(scene, "box", &(BoxParameters){{-64, -8, -64}, {64, 0, 64}});
    Field *box = moved(single("box", (double[]){128, 8, 128}), 0, -4, 0);
    SdfRow patient = {.tolerance = usual.tolerance, .max_steps = 20000};
    assert_alike(
        &(Twins){"ground", engine, marched(engine, box, patient), prepare(engine, scene), 4});
    scene_destroy(scene);
}

/** Repeated balls beside the middle of their cells, which the shortcut of asking the own cell only
 *  gets wrong, and the same as a list. @param engine The engine. */
static void repeated_twins(const Engine *engine) {
    Scene *scene = empty_scene();
    for (int n = 0; n < 7 * 7 * 7; n++) {
        Vector3 center = {n % 7 - 3 + 0.25, n / 7 % 7 - 3 - 0.125, n / 49 - 3 + 0.0625};
        add_shape(scene, "sphere", &(SphereParameters){center, 0.25});
    }
    Field *ball = moved(single("sphere", (double[]){0.25}), 0.25, -0.125, 0.0625);
    Field *all = repeated(ball, (FieldRepeat){{1, 1, 1}, {7, 7, 7}});
    assert_alike(
        &(Twins){"repeated balls", engine, marched(engine, all, usual), prepare(engine, scene), 6});
    scene_destroy(scene);
}

/** Repeated balls that stand leaning in their cells, and all of them leaning: what is done to the
 *  ray once, before its first step. @param engine The engine. */
static void leaning_twins(const Engine *engine) {
    Error error = {0};
    Scene *scene = empty_scene();
    Transform inner = {
        .scale = {0.5, 0.5, 0.5}, .rotate = {50, 0, 70}, .translate = {0.125, -0.25, 0}};
    Transform outer = {
        .scale = {1.25, 1.25, 1.25}, .rotate = {20, 30, 40}, .translate = {0.5, 0.25, -0.25}};
    assert_true(transform_keyword.finish(&outer, 0, &error));
    for (int n = 0; n < 4 * 4 * 4; n++) {
        Vector3 p =
            vector3_add((Vector3){n % 4 - 1.5, n / 4 % 4 - 1.5, n / 16 - 1.5}, inner.translate);
        const double(*m)[3] = (const double(*)[3])outer.linear;
        Vector3 turned = {m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z,
                          m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z,
                          m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z};
        add_shape(scene, "sphere",
                  &(SphereParameters){vector3_add(turned, outer.translate), 0.3125});
    }
    Field *ball = placed(single("sphere", (double[]){0.5}), inner);
    Field *all = placed(repeated(ball, (FieldRepeat){{1, 1, 1}, {4, 4, 4}}), outer);
    assert_alike(
        &(Twins){"leaning balls", engine, marched(engine, all, usual), prepare(engine, scene), 6});
    scene_destroy(scene);
}

/** Balls that reach into the cells around, so that all neighbours are asked. @param engine The
 *  engine. */
static void reaching_twins(const Engine *engine) {
    Scene *scene = empty_scene();
    for (int n = 0; n < 5 * 5 * 5; n++) {
        Vector3 center = {n % 5 - 2 + 0.375, n / 5 % 5 - 2 - 0.4375, n / 25 - 2 + 0.5};
        add_shape(scene, "sphere", &(SphereParameters){center, 0.25});
    }
    Field *ball = moved(single("sphere", (double[]){0.25}), 0.375, -0.4375, 0.5);
    Field *all = repeated(ball, (FieldRepeat){{1, 1, 1}, {5, 5, 5}});
    assert_alike(
        &(Twins){"reaching balls", engine, marched(engine, all, usual), prepare(engine, scene), 5});
    scene_destroy(scene);
}

/** Twins in every engine. @param state Not used. */
static void test_twins(void **state) {
    (void)state;
    in_every_engine(sphere_twins);
    in_every_engine(box_twins);
    in_every_engine(ground_twins);
    in_every_engine(repeated_twins);
    in_every_engine(leaning_twins);
    in_every_engine(reaching_twins);
}

/* --- leaving a surface -------------------------------------------------------------------------
 */

/** @return A box with a ball in it and a groove, turned: something that has all kinds of edges. */
static Field *thing(void) {
    Field *box = single("box", (double[]){1.5, 1, 1});
    Field *ball = moved(single("sphere", (double[]){0.5}), 0.25, 0.5, 0);
    Field *both = joined(FIELD_JOIN_SMOOTH, box, ball, 0.25);
    Field *ring = moved(single("torus", (double[]){0.75, 0.125}), 0, 0, 0.5);
    Transform leaning = {.scale = {1, 1, 1}, .rotate = {20, 30, 40}, .translate = {0.5, 0, 0}};
    return placed(joined(FIELD_JOIN_DIFFERENCE, both, ring, 0), leaning);
}

/** Rays that leave a ball outwards meet nothing, and inwards the other side, from inside.
 *  @param engine The engine. */
static void leave(const Engine *engine) {
    Tracer *tracer = marched(engine, single("sphere", NULL), usual);
    uint64_t seed = 1;
    const Twins aim = {.size = 4};
    for (long left = 0; left < scaled(engine, RAYS);) {
        RayQuery ray = random_ray(&aim, &seed), leaving;
        RayAnswer hit, again;
        engine->intersect(tracer, 1, &ray, &hit);
        if (hit.shape < 0) {
            continue;
        }
        left++;
        int side = left % 2 ? 1 : -1;
        for (int i = 0; i < 3; i++) {
            leaving.origin[i] = hit.point[i] + side * hit.error * hit.normal[i];
            leaving.direction[i] = random_float(&seed, -1, 1);
        }
        double cosine = dot(leaving.direction, hit.normal) * side;
        for (int i = 0; i < 3; i++) {
            leaving.direction[i] = cosine > 0 ? leaving.direction[i] : -leaving.direction[i];
        }
        engine->intersect(tracer, 1, &leaving, &again);
        assert_int_equal(again.shape, side > 0 ? -1 : 0);
        if (side < 0) {
            // A chord of a ball is as long as twice the cosine.
            double length = sqrt(dot(leaving.direction, leaving.direction));
            double chord = 2 * fabs(cosine) / length;
            double way = (double)again.distance * length;
            assert_at_most(fabs(way - chord), 0.02 + 0.02 * chord, "chord in %s", engine->name);
        }
    }
    engine->release(tracer);
}

/** No acne, in any engine. @param state Not used. */
static void test_leaving(void **state) {
    (void)state;
    in_every_engine(leave);
}

/* --- the same bits ------------------------------------------------------------------------------
 */

/** Wide engines give the bits of narrow ones. @param engine The engine. */
static void same_bits(const Engine *engine) {
    Error error = {0};
    const Engine *narrow = engine_find(engine->mantissa_bits == 24   ? "f32x1"
                                       : engine->mantissa_bits == 53 ? "f64x1"
                                                                     : "f128x1",
                                       &error);
    Field *(*const things[])(void) = {thing};
    const Twins aim = {.size = 4};
    uint64_t seed = 3;
    static RayQuery rays[BATCH];
    static RayAnswer a[BATCH], b[BATCH];
    for (int kind = 0; kind < 3; kind++) {
        Field *fields[2];
        for (int i = 0; i < 2; i++) {
            fields[i] = kind == 0   ? things[0]()
                        : kind == 1 ? single("mandelbulb", (int[]){8, 5})
                                    : repeated(single("menger", NULL),
                                               (FieldRepeat){{1.5, 0, 1.25}, {0, 0, 2}});
        }
        Tracer *wide = marched(engine, fields[0], usual);
        Tracer *one = marched(narrow, fields[1], usual);
        int count = (int)scaled(engine, BATCH);
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
        engine->release(wide);
        narrow->release(one);
    }
}

/** @param state Not used. */
static void test_same_bits(void **state) {
    (void)state;
    in_every_engine(same_bits);
}

/* --- the footprint of pixels ---------------------------------------------------------------------
 */

/** @return A tracer with the surface of a field, seen from zero in a picture of 800 pixels; the
 *          field is given back. @param engine The engine. @param field The field.
 *  @param footprint See #TraceSettings.footprint. */
static Tracer *seen(const Engine *engine, Field *field, double footprint) {
    Error error = {0};
    Scene *scene = empty_scene();
    SdfRow row = {field, usual.tolerance, usual.max_steps};
    add_sdf(scene, row);
    TraceSettings settings = {.offset = OFFSET_BOUND, .footprint = footprint};
    Tracer *tracer = engine->prepare(scene, &settings, &error);
    assert_non_null(tracer);
    engine->look(tracer, scene, 800, 600);
    scene_destroy(scene);
    free(field);
    return tracer;
}

/** Balls without end: every ray meets one, if what is smaller than the footprint is left out; else
 *  some go on for ever. What is met is no farther from a ball than the footprint. @param engine The
 *  engine. */
static void leave_out(const Engine *engine) {
    const double share = 4, fov = ((const Camera *)camera_keyword.defaults)->fov;
    const double spread = share * tan(0.5 * fov * M_PI / 180) / 800;
    const FieldRepeat endless = {{1, 1, 1}, {0, 0, 0}};
    uint64_t stalled[2];
    for (int with = 0; with < 2; with++) {
        Field *ball = moved(single("sphere", (double[]){0.0625}), 0.25, 0.125, 0.25);
        Tracer *tracer = seen(engine, repeated(ball, endless), with ? share : 0);
        uint64_t seed = 5;
        for (long i = 0; i < scaled(engine, RAYS) / 10; i++) {
            RayQuery ray = random_ray(&(Twins){.size = 4}, &seed);
            PlainRay plain = {.origin = {0, 0, 0}};
            int shape;
            double t, length = sqrt(dot(ray.direction, ray.direction)), off = 0;
            for (int axis = 0; axis < 3; axis++) {
                plain.direction[axis] = (double)ray.direction[axis];
            }
            engine->nearest(tracer, 1, &plain, &shape, &t);
            for (int axis = 0; shape >= 0 && axis < 3; axis++) {
                double x = t * plain.direction[axis] - (axis == 1 ? 0.125 : 0.25);
                off += (x - floor(x + 0.5)) * (x - floor(x + 0.5));
            }
            double tolerance = fmax(usual.tolerance, with * spread * t * length);
            double most = 1.01 * tolerance + 1e-6 * t * length;
            assert_at_most(shape >= 0 ? fabs(sqrt(off) - 0.0625) : 0, most, "off in %s",
                           engine->name);
        }
        stalled[with] = engine->contents(tracer).stalled;
        engine->release(tracer);
    }
    assert_true(stalled[0] > 0 || engine->mantissa_bits > 64); // That one is asked too little.
    assert_int_equal(stalled[1], 0);
}

/** @param state Not used. */
static void test_footprint(void **state) {
    (void)state;
    in_every_engine(leave_out);
}

/* --- running out of steps ------------------------------------------------------------------------
 */

/** Rays that run out of steps are counted, and are no hits unless they came near. @param engine The
 *  engine. */
static void stall(const Engine *engine) {
    SdfRow hasty = {.tolerance = usual.tolerance, .max_steps = 3};
    Tracer *tracer = marched(engine, single("sphere", NULL), hasty);
    RayQuery grazing = {{-4, 0.75, 0.75}, {1, 0, 0}}, straight = {{-4, 0, 0}, {1, 0, 0}};
    RayAnswer answer;
    engine->intersect(tracer, 1, &grazing, &answer);
    assert_int_equal(answer.shape, -1);
    assert_true(engine->contents(tracer).stalled > 0);
    engine->release(tracer);
    tracer = marched(engine, single("sphere", NULL), hasty);
    engine->intersect(tracer, 1, &straight, &answer);
    assert_int_equal(answer.shape, 0);
    assert_int_equal(engine->contents(tracer).stalled, 0);
    engine->release(tracer);
}

/** @param state Not used. */
static void test_stalls(void **state) {
    (void)state;
    in_every_engine(stall);
}

/** Runs the tests. @return 0 if marching is right. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_twins),     cmocka_unit_test(test_leaving),
        cmocka_unit_test(test_same_bits), cmocka_unit_test(test_footprint),
        cmocka_unit_test(test_stalls),
    };
    return cmocka_run_group_tests_name("marching", tests, NULL, NULL);
}
