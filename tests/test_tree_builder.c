/**
 * @file
 * @brief Trees over triangles that are hard to split: what is aimed at is met, by every engine at
 *        the same place, however many threads built the tree.
 *
 * No tree is deeper than its traversal's stack: costs decide 32 levels of the binary tree at most,
 * each level below halves the number of items, of which there are less than 2^27, and no level of
 * the wide tree has less than one of the binary one. Triangles at powers of two, from 2^48 to less
 * than any number, would else be as deep as there are powers.
 */
#include "tree_questions.h"

#include "render/workers.h"

/* --- how triangles lie ----------------------------------------------------------------------- */

/** Makes the corners of a case. @param[in,out] state A generator. @param i Which triangle.
 *  @param count How many. @param[out] corners Three. */
typedef void (*Layout)(uint64_t *state, size_t i, size_t count, Vector3 *corners);

/** Makes a small triangle somewhere. See #Layout. @param state See there. @param middle Where.
 *  @param size How large. @param corners See there. */
static void triangle_at(uint64_t *state, Vector3 middle, double size, Vector3 *corners) {
    for (int k = 0; k < 3; k++) {
        Vector3 beside = {random_float(state, -1, 1), random_float(state, -1, 1),
                          random_float(state, -1, 1)};
        corners[k] = vector3_add(middle, vector3_scale(beside, size));
    }
}

/** All the same. See #Layout. @param state Not used. @param i Not used. @param count Not used.
 *  @param corners See there. */
static void lay_identical(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    (void)state, (void)i, (void)count;
    corners[0] = (Vector3){0, 0, 1};
    corners[1] = (Vector3){1, 0, 0};
    corners[2] = (Vector3){0, 1, 0};
}

/** One inside the other, the middles of all boxes the same. See #Layout. @param state Not used.
 *  @param i See there. @param count See there. @param corners See there. */
static void lay_nested(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    (void)state;
    double size = (double)(i + 1) / (double)count;
    corners[0] = (Vector3){-size, -size, -size};
    corners[1] = (Vector3){size, size, size};
    corners[2] = (Vector3){size, -size, size};
}

/** Anywhere. See #Layout. @param state See there. @param i Not used. @param count Not used.
 *  @param corners See there. */
static void lay_randomly(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    (void)i, (void)count;
    triangle_at(state, point_in_scene(state), 0.02, corners);
}

/** One huge, the others tiny. See #Layout. @param state See there. @param i See there. @param count
 *  See there. @param corners See there. */
static void lay_one_huge(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    (void)count;
    triangle_at(state, point_in_scene(state), i == 77 ? 1e4 : 1e-3, corners);
}

/** Along a line, in order. See #Layout. @param state See there. @param i See there. @param count
 *  See there. @param corners See there. */
static void lay_along_a_line(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    double along = 4 * (double)i / (double)count - 2;
    triangle_at(state, (Vector3){along, along / 2, -along}, 0.01, corners);
}

/** Anywhere, all of it tiny. See #Layout. @param state See there. @param i Not used. @param count
 *  Not used. @param corners See there. */
static void lay_tiny(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    lay_randomly(state, i, count, corners);
    for (int k = 0; k < 3; k++) {
        corners[k] = vector3_scale(corners[k], 1e-12);
    }
}

/** Anywhere, all of it huge. See #Layout. @param state See there. @param i Not used. @param count
 *  Not used. @param corners See there. */
static void lay_huge(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    lay_randomly(state, i, count, corners);
    for (int k = 0; k < 3; k++) {
        corners[k] = vector3_scale(corners[k], 1e12);
    }
}

/** From the largest number there is to the smallest, by powers of two: bins split off a few
 *  triangles at a time, and binary trees of such become as deep as there are powers. See #Layout.
 *  @param state See there. @param i See there. @param count See there. @param corners See there. */
static void lay_at_powers(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    double size = exp2(48 - 1100 * (double)i / (double)count);
    triangle_at(state, (Vector3){size, 0, 0}, 0.2 * size, corners);
}

/** A flat mesh whose corners are a little off the plane: less than any number that has a finite
 *  inverse. See #Layout. @param state See there. @param i See there. @param count See there.
 *  @param corners See there. */
static void lay_nearly_flat(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    lay_randomly(state, i, count, corners);
    for (int k = 0; k < 3; k++) {
        corners[k].x = (double)(i % 3) * 1e-41;
    }
}

/** A case of the builder. */
typedef struct BuilderCase {
    const char *name; /**< For messages. */
    Layout lay;       /**< How its triangles lie. */
    size_t count;     /**< How many. */
    int packets;      /**< Packets of rays to ask. */
} BuilderCase;

/** The cases. */
static const BuilderCase builder_cases[] = {
    {"one triangle", lay_randomly, 1, 16},
    {"equal triangles", lay_identical, 10000, 2},
    {"triangles with one middle", lay_nested, 3000, 4},
    {"one huge triangle", lay_one_huge, 5000, 16},
    {"tiny triangles", lay_tiny, 5000, 16},
    {"huge triangles", lay_huge, 5000, 16},
    {"triangles along a line", lay_along_a_line, 10000 / SLOWNESS, 16},
    {"random triangles", lay_randomly, 100000 / SLOWNESS, 16},
    {"triangles at powers of two", lay_at_powers, 100000 / SLOWNESS, 16},
    {"nearly flat triangles", lay_nearly_flat, 2000, 16},
};

/** Does what a crew is asked to. See #Crew.run. @param workers The threads. @param count See there.
 *  @param job See there. @param context See there. */
static void crew_do(void *workers, size_t count, void (*job)(void *, size_t), void *context) {
    workers_run(workers, count, job, context);
}

/** @return A tracer that several threads prepared, to be given back. @param engine The engine.
 *  @param scene The scene. @param threads How many. */
static Tracer *prepare_with(const Engine *engine, const Scene *scene, int threads) {
    Error error = {0};
    Workers *workers = workers_create(threads, &error);
    assert_non_null(workers);
    TraceSettings settings = {
        .depth = 1, .offset = OFFSET_BOUND, .crew = {workers, threads, crew_do}};
    Tracer *tracer = engine->prepare(scene, &settings, &error);
    assert_non_null(tracer);
    workers_destroy(workers);
    return tracer;
}

/** @return The largest coordinate of a triangle. @param corners Its corners. */
static double largest_of(const Vector3 *corners) {
    double largest = 0;
    for (int k = 0; k < 3; k++) {
        largest = fmax(largest, vector3_largest(corners[k]));
    }
    return largest;
}

/** Aims a ray at the middle of a triangle, from about above it. @param corners The triangle.
 *  @param[in,out] state A generator. @param[out] ray The ray. */
static void aim_at_triangle(const Vector3 *corners, uint64_t *state, RayQuery *ray) {
    double size = largest_of(corners);
    Vector3 sides[2], middle = {0, 0, 0};
    for (int k = 0; k < 3; k++) {
        middle = vector3_add(middle, vector3_scale(corners[k], 1.0 / 3));
    }
    for (int k = 0; k < 2; k++) {
        sides[k] = vector3_scale(vector3_subtract(corners[k + 1], corners[0]), 1 / size);
    }
    Vector3 away = vector3_normalize(vector3_cross(sides[0], sides[1]));
    away =
        vector3_add(away, (Vector3){random_float(state, -0.3, 0.3), random_float(state, -0.3, 0.3),
                                    random_float(state, -0.3, 0.3)});
    Vector3 eye = rounded(vector3_add(middle, vector3_scale(away, size)));
    *ray = ray_towards(eye, rounded(middle));
    for (int k = 0; k < 3; k++) {
        ray->direction[k] = as_float((double)ray->direction[k]);
    }
}

/** Fills a packet: the first ray, or all of them, aimed at triangles. @param mesh The triangles.
 *  @param[in,out] state A generator. @param is_coherent Whether the others go beside the first.
 *  @param[out] rays The rays. */
static void fill_aimed(const Triangles *mesh, uint64_t *state, bool is_coherent, RayQuery *rays) {
    for (int i = 0; i < TOGETHER; i++) {
        const Vector3 *corners;
        do {
            size_t which = (size_t)((double)mesh->triangle_count * random_share(state));
            corners = &mesh->positions[3 * which];
            // Products of smaller ones are no floats any more.
        } while (largest_of(corners) < 1e-13);
        if (i == 0 || !is_coherent) {
            aim_at_triangle(corners, state, &rays[i]);
            continue;
        }
        rays[i] = rays[0];
        for (int k = 0; k < 3; k++) {
            rays[i].direction[k] =
                as_float((double)rays[0].direction[k] * random_float(state, 0.9, 1.1));
        }
    }
}

/** Checks a case in all engines of a number type: what is aimed at is met or hidden, and all say
 * the same, whoever built the tree. @param reference The engine of one lane. @param builder The
 * case.
 *  @param mesh Its triangles. @param scene The scene. */
static void ask_case(const Engine *reference, const BuilderCase *builder, const Triangles *mesh,
                     const Scene *scene) {
    Tracer *tracers[ENGINES_MOST], *alone = prepare(reference, scene);
    uint64_t state = 9;
    RayQuery rays[16][TOGETHER];
    RayAnswer wanted[16][TOGETHER];
    for (int n = 0; n < builder->packets; n++) {
        fill_aimed(mesh, &state, n % 2, rays[n]);
        reference->intersect(alone, TOGETHER, rays[n], wanted[n]);
        for (int i = 0; i < (n % 2 ? 1 : TOGETHER); i++) {
            assert_int_equal(wanted[n][i].shape, 0);
            assert_at_most(wanted[n][i].distance, 1 + 1e-4, "%s in %s", builder->name,
                           reference->name);
        }
    }
    reference->release(alone);
    const int threads[] = {1, 2, 7};
    // What takes long to build is built by all threads only.
    for (size_t t = builder->count < 50000 ? 0 : 2; t < sizeof threads / sizeof *threads; t++) {
        for (size_t e = 0; engine_list()[e]; e++) {
            tracers[e] = is_of_type(engine_list()[e], reference)
                             ? prepare_with(engine_list()[e], scene, threads[t])
                             : NULL;
        }
        assert_all_say(reference, builder->name, tracers, builder->packets * TOGETHER, rays[0],
                       wanted[0]);
        release_all(tracers);
    }
}

/** Triangles that are hard to split. @param reference The engine of one lane. */
static void bad_triangles(const Engine *reference) {
    /** What the reference engine builds in a second. */
    const size_t few = 10000;
    for (size_t n = 0; n < sizeof builder_cases / sizeof *builder_cases; n++) {
        const BuilderCase *builder = &builder_cases[n];
        if (reference->mantissa_bits > 64 && builder->count >= few) {
            continue;
        }
        uint64_t state = 10;
        Triangles mesh = triangles_create(builder->count);
        for (size_t i = 0; i < builder->count; i++) {
            builder->lay(&state, i, builder->count, &mesh.positions[3 * i]);
        }
        Scene *scene = empty_scene();
        add_triangles(scene, &mesh, 2);
        ask_case(reference, builder, &mesh, scene);
        scene_destroy(scene);
        triangles_release(&mesh);
    }
}

/** See #bad_triangles. @param state Not used. */
static void test_builder(void **state) {
    (void)state;
    for_every_type(bad_triangles);
}

/** Runs the tests. @return How many failed. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_builder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
