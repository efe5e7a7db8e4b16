/**
 * @file
 * @brief BVHs of triangles that are difficult to split: rays hit their targets, equally in every
 *        engine and for any number of build threads.
 *
 * No BVH is deeper than the traversal stack. Costs determine at most 32 levels of the binary tree;
 * each level below halves the number of items, of which there are less than 2^27. No level of the
 * wide tree corresponds to less than one of the binary tree. Without this limit, triangles at
 * powers of two, from 2^48 down to the smallest number, would need one level per power.
 */
#include "bvh_queries.h"

#include "render/thread_pool.h"

/* --- layouts of triangles --------------------------------------------------------------------- */

/** Computes the vertices of a triangle. */
typedef void (*Layout)(uint64_t *state, size_t i, size_t count, Vec3d *corners);

/** Makes a small triangle at a point. See #Layout. */
static void triangle_at(uint64_t *state, Vec3d middle, double size, Vec3d *corners) {
    for (int k = 0; k < 3; k++) {
        Vec3d lateral = {random_float(state, -1, 1), random_float(state, -1, 1),
                         random_float(state, -1, 1)};
        corners[k] = vec3d_add(middle, vec3d_scale(lateral, size));
    }
}

/** All triangles are equal. See #Layout. */
static void layout_identical(uint64_t *state, size_t i, size_t count, Vec3d *corners) {
    (void)state, (void)i, (void)count;
    corners[0] = (Vec3d){0, 0, 1};
    corners[1] = (Vec3d){1, 0, 0};
    corners[2] = (Vec3d){0, 1, 0};
}

/** Nested triangles, whose boxes have the same centre. See #Layout. */
static void layout_nested(uint64_t *state, size_t i, size_t count, Vec3d *corners) {
    (void)state;
    double size = (double)(i + 1) / (double)count;
    corners[0] = (Vec3d){-size, -size, -size};
    corners[1] = (Vec3d){size, size, size};
    corners[2] = (Vec3d){size, -size, size};
}

/** Random triangles. See #Layout. */
static void layout_random(uint64_t *state, size_t i, size_t count, Vec3d *corners) {
    (void)i, (void)count;
    triangle_at(state, point_in_scene(state), 0.02, corners);
}

/** One huge triangle, the others tiny. See #Layout. */
static void layout_one_huge(uint64_t *state, size_t i, size_t count, Vec3d *corners) {
    (void)count;
    triangle_at(state, point_in_scene(state), i == 77 ? 1e4 : 1e-3, corners);
}

/** In order along a line. See #Layout. */
static void layout_line(uint64_t *state, size_t i, size_t count, Vec3d *corners) {
    double along = 4 * (double)i / (double)count - 2;
    triangle_at(state, (Vec3d){along, along / 2, -along}, 0.01, corners);
}

/** Random, at a tiny scale. See #Layout. */
static void layout_tiny(uint64_t *state, size_t i, size_t count, Vec3d *corners) {
    layout_random(state, i, count, corners);
    for (int k = 0; k < 3; k++) {
        corners[k] = vec3d_scale(corners[k], 1e-12);
    }
}

/** Random, at a huge scale. See #Layout. */
static void layout_huge(uint64_t *state, size_t i, size_t count, Vec3d *corners) {
    layout_random(state, i, count, corners);
    for (int k = 0; k < 3; k++) {
        corners[k] = vec3d_scale(corners[k], 1e12);
    }
}

/**
 * Triangles at powers of two, from the largest number to the smallest. Binned splits separate only
 * a few triangles each, so the binary tree would have one level per power. See #Layout.
 */
static void layout_powers(uint64_t *state, size_t i, size_t count, Vec3d *corners) {
    double size = exp2(48 - 1100 * (double)i / (double)count);
    triangle_at(state, (Vec3d){size, 0, 0}, 0.2 * size, corners);
}

/**
 * A nearly flat mesh: vertices deviate from the plane by less than any number with a finite
 * inverse. See #Layout.
 */
static void layout_nearly_flat(uint64_t *state, size_t i, size_t count, Vec3d *corners) {
    layout_random(state, i, count, corners);
    for (int k = 0; k < 3; k++) {
        corners[k].x = (double)(i % 3) * 1e-41;
    }
}

/** A test case of the builder. */
typedef struct BuilderCase {
    const char *name; /**< Name in messages. */
    Layout layout;    /**< Layout of its triangles. */
    size_t count;     /**< Number of triangles. */
    int packets;      /**< Packets of rays. */
} BuilderCase;

/** The test cases. */
static const BuilderCase builder_cases[] = {
    {"one triangle", layout_random, 1, 16},
    {"equal triangles", layout_identical, 10000, 2},
    {"triangles with one middle", layout_nested, 3000, 4},
    {"one huge triangle", layout_one_huge, 5000, 16},
    {"tiny triangles", layout_tiny, 5000, 16},
    {"huge triangles", layout_huge, 5000, 16},
    {"triangles along a line", layout_line, 10000 / WORKLOAD_DIVISOR, 16},
    {"random triangles", layout_random, 100000 / WORKLOAD_DIVISOR, 16},
    {"triangles at powers of two", layout_powers, 100000 / WORKLOAD_DIVISOR, 16},
    {"nearly flat triangles", layout_nearly_flat, 2000, 16},
};

/** Runs tasks on a thread pool. See #ParallelFor.run. */
static void run_parallel_for(void *workers, size_t count, void (*job)(void *, size_t),
                             void *context) {
    thread_pool_run(workers, count, job, context);
}

/** @return A tracer created with several threads, to be destroyed. */
static Tracer *create_tracer_with_threads(const Engine *engine, const Scene *scene, int threads) {
    Error error = {0};
    ThreadPool *workers = thread_pool_create(threads, &error);
    assert_non_null(workers);
    TraceSettings settings = {
        .depth = 1, .offset = OFFSET_BOUND, .parallel_for = {workers, threads, run_parallel_for}};
    Tracer *tracer = engine->create_tracer(scene, &settings, &error);
    assert_non_null(tracer);
    thread_pool_destroy(workers);
    return tracer;
}

/** @return The largest absolute coordinate of a triangle. */
static double largest_coordinate(const Vec3d *corners) {
    double largest = 0;
    for (int k = 0; k < 3; k++) {
        largest = fmax(largest, vec3d_max_abs(corners[k]));
    }
    return largest;
}

/** Points a ray at the centre of a triangle, from approximately above it. */
static void aim_at_triangle(const Vec3d *corners, uint64_t *state, RayQueryQuad *ray) {
    double size = largest_coordinate(corners);
    Vec3d sides[2], middle = {0, 0, 0};
    for (int k = 0; k < 3; k++) {
        middle = vec3d_add(middle, vec3d_scale(corners[k], 1.0 / 3));
    }
    for (int k = 0; k < 2; k++) {
        sides[k] = vec3d_scale(vec3d_subtract(corners[k + 1], corners[0]), 1 / size);
    }
    Vec3d away = vec3d_normalize(vec3d_cross(sides[0], sides[1]));
    away = vec3d_add(away, (Vec3d){random_float(state, -0.3, 0.3), random_float(state, -0.3, 0.3),
                                   random_float(state, -0.3, 0.3)});
    Vec3d eye = point_as_float(vec3d_add(middle, vec3d_scale(away, size)));
    *ray = ray_towards(eye, point_as_float(middle));
    for (int k = 0; k < 3; k++) {
        ray->direction[k] = round_to_float((double)ray->direction[k]);
    }
}

/**
 * Fills a packet: the first ray, or all of them, go to triangles.
 * @param is_coherent Whether the others go near the first.
 */
static void fill_aimed(const TriangleSoup *mesh, uint64_t *state, bool is_coherent,
                       RayQueryQuad *rays) {
    for (int i = 0; i < RAYS_PER_QUERY; i++) {
        const Vec3d *corners;
        do {
            size_t which = (size_t)((double)mesh->triangle_count * random_unit_double(state));
            corners = &mesh->positions[3 * which];
            // Products of smaller ones underflow in float.
        } while (largest_coordinate(corners) < 1e-13);
        if (i == 0 || !is_coherent) {
            aim_at_triangle(corners, state, &rays[i]);
            continue;
        }
        rays[i] = rays[0];
        for (int k = 0; k < 3; k++) {
            rays[i].direction[k] =
                round_to_float((double)rays[0].direction[k] * random_float(state, 0.9, 1.1));
        }
    }
}

/**
 * Checks a case in all engines of a number type: targets are hit or occluded, and all engines agree
 * for any number of build threads.
 * @param reference  The engine of one lane.
 */
static void check_build_case(const Engine *reference, const BuilderCase *builder,
                             const TriangleSoup *mesh, const Scene *scene) {
    Tracer *tracers[ENGINES_MAXIMUM], *alone = create_tracer(reference, scene);
    uint64_t state = 9;
    RayQueryQuad rays[16][RAYS_PER_QUERY];
    RayResult wanted[16][RAYS_PER_QUERY];
    for (int n = 0; n < builder->packets; n++) {
        fill_aimed(mesh, &state, n % 2, rays[n]);
        reference->intersect(alone, RAYS_PER_QUERY, rays[n], wanted[n]);
        for (int i = 0; i < (n % 2 ? 1 : RAYS_PER_QUERY); i++) {
            assert_int_equal(wanted[n][i].shape, 0);
            assert_at_most(wanted[n][i].distance, 1 + 1e-4, "%s in %s", builder->name,
                           reference->name);
        }
    }
    reference->destroy(alone);
    const int threads[] = {1, 2, 7};
    // Large cases are built with all threads only.
    for (size_t t = builder->count < 50000 ? 0 : 2; t < sizeof threads / sizeof *threads; t++) {
        for (size_t e = 0; engine_list()[e]; e++) {
            tracers[e] = engine_matches_type(engine_list()[e], reference)
                             ? create_tracer_with_threads(engine_list()[e], scene, threads[t])
                             : NULL;
        }
        assert_engines_agree(reference, builder->name, tracers, builder->packets * RAYS_PER_QUERY,
                             rays[0], wanted[0]);
        destroy_tracers(tracers);
    }
}

/**
 * Triangles that are difficult to split.
 * @param reference  The engine of one lane.
 */
static void check_hard_triangles(const Engine *reference) {
    /** Number of triangles that the reference engine builds in a second. */
    const size_t few = 10000;
    for (size_t n = 0; n < sizeof builder_cases / sizeof *builder_cases; n++) {
        const BuilderCase *builder = &builder_cases[n];
        if (reference->mantissa_bits > 64 && builder->count >= few) {
            continue;
        }
        uint64_t state = 10;
        TriangleSoup mesh = triangle_soup_create(builder->count);
        for (size_t i = 0; i < builder->count; i++) {
            builder->layout(&state, i, builder->count, &mesh.positions[3 * i]);
        }
        Scene *scene = create_empty_scene();
        add_triangle_soup(scene, &mesh, 2);
        check_build_case(reference, builder, &mesh, scene);
        scene_destroy(scene);
        triangle_soup_destroy(&mesh);
    }
}

/** See #check_hard_triangles. */
static void test_bvh_builder(void **state) {
    (void)state;
    for_every_type(check_hard_triangles);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bvh_builder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
