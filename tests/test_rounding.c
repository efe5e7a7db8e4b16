/**
 * @file
 * @brief Tests of the tracer while the processor rounds in other directions, and of the layer that
 *        shows what changes.
 *
 * A bound that holds with rounding to nearest counts half an ulp per rounding. In another direction
 * a rounding is off by an ulp at most, so errors may be twice as large and no larger. Which surface
 * a ray meets must not change, except within such an error of an edge.
 */
#include "contract_scenes.h"
#include "pictures.h"
#include "triangle_soup.h"

#include "assets/meshes/mesh_builder.h"
#include "base/encoding.h"
#include "render/rounding_witness.h"

#include <fenv.h>

/** Error of a rounding in any direction, relative to that of rounding to nearest. */
enum { DIRECTED_ERROR_RATIO = 2 };

/** A direction of rounding. */
typedef struct Direction {
    const char *name; /**< Its name in messages. */
    int mode;         /**< The argument of fesetround. */
} Direction;

/** All directions, in the order of #RoundingDirection. */
static const Direction directions[ROUNDING_DIRECTION_COUNT] = {
    {"to nearest", FE_TONEAREST},
    {"upwards", FE_UPWARD},
    {"downwards", FE_DOWNWARD},
    {"towards zero", FE_TOWARDZERO},
};

/** Finds the nearest hits of rays while the processor rounds in a direction. */
static void intersect_rounded(const Engine *engine, const Tracer *tracer,
                              const Direction *direction, size_t count, const RayQueryQuad *rays,
                              RayResult *answers) {
    assert_int_equal(fesetround(direction->mode), 0);
    engine->intersect(tracer, count, rays, answers);
    assert_int_equal(fesetround(FE_TONEAREST), 0);
}

/* --- every shape ------------------------------------------------------------------------------ */

/** Rays per shape, engine and direction; a tenth in quad. */
enum { SHAPE_RAYS = 1024 };

/** Where rays come from and go to. */
typedef struct RaySpread {
    double distance; /**< Distance of their origins from a shape, in its sizes. */
    double spread;   /**< Distance of their targets from its centre, in its sizes. */
} RaySpread;

/** Rays from inside, from near and from afar, as in test_contract.c. */
static const RaySpread ray_spreads[] = {{0.5, 2}, {4, 1.5}, {1e3, 0.5}};
/** Distance from which on quad is no better than its reference. */
#define QUAD_REFERENCE_DISTANCE 100
/** Bound of test_contract.c on the error of a distance, half ulps. */
#define DISTANCE_ERROR 64

/** Checks one hit, or miss, against the reference in quad. */
static void check_rounded_hit(const ContractShape *shape, const Engine *engine,
                              const Direction *direction, const RayQueryQuad *ray,
                              const RayResult *answer) {
    ExpectedHit expected = contract_expected_hit(shape, ray);
    Quadruple ulp = DIRECTED_ERROR_RATIO * roundoff(engine);
    Vec3qa d = vec3qa_from_quads(ray->direction);
    Quadruple sizes = quad_abs(expected.t) * quad_sqrt(vec3qa_dot(d, d)) / shape->size;
    // So near to the rim, rounding the ray decides: both results are valid.
    if (expected.edge_margin < 64 * (ulp * (1 + sizes) + tolerance_of(shape))) {
        return;
    }
    bool is_hit = answer->shape == 0;
    if (is_hit != expected.is_hit || answer->occluded != is_hit) {
        fail_msg("%s in %s, rounded %s: hit %d, occluded %d, truth %d", shape->name, engine->name,
                 direction->name, is_hit, answer->occluded, expected.is_hit);
    }
    if (is_hit) {
        Vec3qa point = {{answer->point[0], answer->point[1], answer->point[2]}};
        assert_at_most(surface_distance(shape, &point) / answer->error, DIRECTED_ERROR_RATIO,
                       "%s in %s, rounded %s, point against its own bound", shape->name,
                       engine->name, direction->name);
        Quadruple off = quad_abs(answer->distance - expected.t) / quad_abs(expected.t) * sizes;
        double tolerance = tolerance_of(shape) / (double)ulp;
        // Where a ray grazes, the rounding of the ray moves the hit far along it.
        assert_at_most(off * expected.edge_margin / (ulp * (sizes + 1)),
                       fmax(DISTANCE_ERROR, tolerance), "%s in %s, rounded %s, distance, ulps",
                       shape->name, engine->name, direction->name);
    }
}

/** Rays at a shape, in all directions of rounding. */
static void check_rounded_shape(const ContractShape *shape, const Engine *engine) {
    bool is_quad = engine->mantissa_bits > 64;
    size_t count = (size_t)(is_quad ? SHAPE_RAYS / 10 : SHAPE_RAYS) / WORKLOAD_DIVISOR;
    RayQueryQuad *rays = calloc(count, sizeof *rays);
    RayResult *answers = calloc(count, sizeof *answers);
    Tracer *tracer = tracer_with(engine, shape);
    uint64_t state = 21;
    assert_true(rays && answers);
    for (size_t k = 0; k < sizeof ray_spreads / sizeof *ray_spreads; k++) {
        if (is_quad && ray_spreads[k].distance > QUAD_REFERENCE_DISTANCE) {
            continue;
        }
        for (size_t i = 0; i < count; i++) {
            rays[i] = random_ray(shape, &state, ray_spreads[k].distance, ray_spreads[k].spread);
        }
        for (int way = 0; way < ROUNDING_DIRECTION_COUNT; way++) {
            intersect_rounded(engine, tracer, &directions[way], count, rays, answers);
            for (size_t i = 0; i < count; i++) {
                check_rounded_hit(shape, engine, &directions[way], &rays[i], &answers[i]);
            }
        }
    }
    engine->destroy(tracer);
    free(rays);
    free(answers);
}

/** No shape is missed, and no point lies off its surface, in any direction of rounding. */
static void check_rounded_shapes(const Engine *engine) {
    for (size_t i = 0; i < CONTRACT_SHAPE_COUNT; i++) {
        check_rounded_shape(&contract_shapes[i], engine);
    }
}

/** See #check_rounded_shapes. */
static void test_shapes(void **state) {
    (void)state;
    for_every_engine(check_rounded_shapes);
}

/* --- shared edges ----------------------------------------------------------------------------- */

/** Rays that are traced together: a packet of most engines. */
enum { TOGETHER = 64 };
/** Packets per closed surface, engine and direction. */
enum { EDGE_PACKETS = 200 };

/** Makes the rays of a packet from inside a closed mesh to an edge, or to one of its ends. */
static void fill_edge_rays(const TriangleSoup *mesh, uint64_t *state, RayQueryQuad *rays) {
    size_t face = (size_t)((double)mesh->triangle_count * random_unit_double(state));
    size_t from = (size_t)(3 * random_unit_double(state));
    bool is_at_vertex = random_unit_double(state) < 0.5;
    Vec3d vertex = triangle_soup_vertex(mesh, face, from);
    Vec3d edge = vec3d_subtract(triangle_soup_vertex(mesh, face, (from + 1) % 3), vertex);
    Vec3d middle = {random_float(state, -1, 1), random_float(state, -1, 1),
                    random_float(state, -1, 1)};
    for (int i = 0; i < TOGETHER; i++) {
        Vec3d eye = {middle.x + random_float(state, -0.01, 0.01),
                     middle.y + random_float(state, -0.01, 0.01), middle.z};
        double fraction = is_at_vertex ? 0 : random_unit_double(state);
        rays[i] = ray_towards(eye, vec3d_add(vertex, vec3d_scale(edge, fraction)));
    }
}

/** Counts the rays through edges of a closed mesh that leave it. */
static void count_leaks(const Engine *engine, const Scene *scene, const TriangleSoup *mesh,
                        const char *what) {
    long packets = ray_count_for(engine, EDGE_PACKETS) + 1;
    Tracer *tracer = create_tracer(engine, scene);
    for (int way = 0; way < ROUNDING_DIRECTION_COUNT; way++) {
        uint64_t state = 22;
        long leaks = 0;
        for (long n = 0; n < packets; n++) {
            RayQueryQuad rays[TOGETHER];
            RayResult answers[TOGETHER];
            fill_edge_rays(mesh, &state, rays);
            intersect_rounded(engine, tracer, &directions[way], TOGETHER, rays, answers);
            for (int i = 0; i < TOGETHER; i++) {
                leaks += answers[i].shape < 0 || !answers[i].occluded;
            }
        }
        assert_at_most(leaks, 0, "%s in %s, rounded %s: leaks of %ld rays", what, engine->name,
                       directions[way].name, packets * TOGETHER);
    }
    engine->destroy(tracer);
}

/** A closed surface has no leak, be it a mesh or single triangles. */
static void check_closed_surfaces(const Engine *engine) {
    TriangleSoup mesh = icosphere_triangles(3);
    Scene *scene = create_empty_scene(), *triangles = create_empty_scene();
    add_triangle_soup(scene, &mesh, 2);
    for (size_t i = 0; i < mesh.triangle_count; i++) {
        TriangleParameters face = {0};
        for (size_t corner = 0; corner < 3; corner++) {
            face.corners[corner] = triangle_soup_vertex(&mesh, i, corner);
        }
        add_shape(triangles, "triangle", &face);
    }
    count_leaks(engine, scene, &mesh, "mesh");
    count_leaks(engine, triangles, &mesh, "triangles");
    triangle_soup_destroy(&mesh);
    scene_destroy(scene);
    scene_destroy(triangles);
}

/** See #check_closed_surfaces. */
static void test_edges(void **state) {
    (void)state;
    for_every_engine(check_closed_surfaces);
}

/* --- pictures --------------------------------------------------------------------------------- */

/** Size of the pictures; a quarter of it each way in quad. */
enum { PICTURE_WIDTH = 160, PICTURE_HEIGHT = 120, QUAD_DIVISOR = 4 };

/** The light of a picture. */
typedef struct Light {
    int width;   /**< Pixels. */
    int height;  /**< Pixels. */
    double *rgb; /**< Red of all pixels, then green, then blue; owned. */
} Light;

/** @return The picture of a scene; the tracer is created while rounding in the same direction. */
static Light trace_rounded_picture(const Engine *engine, const Scene *scene, int way) {
    int divisor = engine->mantissa_bits > 64 ? QUAD_DIVISOR : 1;
    Light light = {PICTURE_WIDTH / divisor, PICTURE_HEIGHT / divisor, NULL};
    PixelGrid grid = {.columns = light.width, .rows = light.height, .stride = 1};
    RayCounts counts = {0};
    light.rgb = calloc(3 * (size_t)light.width * (size_t)light.height, sizeof *light.rgb);
    assert_non_null(light.rgb);
    assert_int_equal(fesetround(directions[way].mode), 0);
    Tracer *tracer = create_tracer(engine, scene);
    engine->set_view(tracer, scene, light.width, light.height);
    assert_true(trace_rounded(engine, (RoundingDirection)way, tracer, &grid, light.rgb, &counts));
    assert_int_equal(fegetround(), directions[way].mode);
    assert_int_equal(fesetround(FE_TONEAREST), 0);
    engine->destroy(tracer);
    return light;
}

/** @return Number of pixels that differ by more than a step of 8 bits. */
static int count_changed(const Light *a, const Light *b) {
    size_t pixels = (size_t)a->width * (size_t)a->height;
    int changed = 0;
    for (size_t i = 0; i < pixels; i++) {
        double worst = 0;
        for (size_t c = 0; c < 3; c++) {
            double x = encoding_encode(ENCODING_SRGB, fmin(a->rgb[c * pixels + i], 1));
            double y = encoding_encode(ENCODING_SRGB, fmin(b->rgb[c * pixels + i], 1));
            worst = fmax(worst, fabs(x - y));
        }
        changed += worst > 1;
    }
    return changed;
}

/** Adds a face of an OBJ file, of triangles from its first corner. @param text Its indices. */
static void add_obj_face(MeshBuilder *builder, const double (*vertices)[3], char *text) {
    MeshCorner corners[3];
    memset(corners, 0, sizeof corners);
    int count = 0;
    for (char *word = strtok(text, " \n"); word; word = strtok(NULL, " \n")) {
        int k = count < 2 ? count : 2;
        if (count > 2) {
            corners[1] = corners[2];
        }
        memcpy(corners[k].position, vertices[atol(word) - 1], sizeof corners[k].position);
        count++;
        assert_true(count < 3 || mesh_builder_add(builder, corners));
    }
}

/**
 * Builds a mesh of an OBJ file as the worker does, which is a process of its own and cannot be told
 * how to round. Zeros keep the sign that the file gives them.
 * @param way  The direction in which numbers are rounded, once they are read.
 * @return The mesh, to be released.
 */
static Mesh *build_mesh_rounded(const char *path, int way) {
    /** Longest line, and most vertices, of the files. */
    enum { LINE_SIZE = 256, VERTICES = 1 << 14 };
    static double vertices[VERTICES][3];
    char line[LINE_SIZE];
    Error error = {0};
    size_t count = 0;
    MeshBuilder builder;
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    mesh_builder_init(&builder, &error);
    while (fgets(line, sizeof line, file)) {
        double *v = vertices[count];
        if (sscanf(line, "v %lf %lf %lf", &v[0], &v[1], &v[2]) == 3) {
            assert_true(++count < VERTICES);
        } else if (strncmp(line, "f ", 2) == 0) {
            assert_int_equal(fesetround(directions[way].mode), 0);
            add_obj_face(&builder, (const double(*)[3])vertices, line + 2);
            assert_int_equal(fesetround(FE_TONEAREST), 0);
        }
    }
    fclose(file);
    Mesh counts;
    assert_int_equal(fesetround(directions[way].mode), 0);
    assert_true(mesh_builder_finish(&builder, &counts));
    Mesh *mesh = mesh_create(&counts, &error);
    assert_non_null(mesh);
    mesh_builder_copy(&builder, mesh);
    mesh_update_bounds(mesh);
    assert_int_equal(fesetround(FE_TONEAREST), 0);
    mesh_builder_deinit(&builder);
    return mesh;
}

/** Replaces the meshes of a scene by those that are built while rounding in a direction. */
static void build_meshes_rounded(Scene *scene, int way) {
    for (size_t i = 0; i < scene->mesh_count; i++) {
        mesh_release(scene->meshes[i].mesh);
        scene->meshes[i].mesh = build_mesh_rounded(scene->meshes[i].file.path, way);
    }
}

/**
 * In double and quad no pixel of two scenes with meshes changes by more than a step, in whichever
 * direction everything is rounded: the building of the mesh, too, where a zero's sign once parted
 * vertices that are one.
 */
static void check_mesh_pictures(const Engine *engine) {
    static const char *const paths[] = {"scenes/teapot.lua", "scenes/figure-16.lua"};
    for (size_t i = 0; i < sizeof paths / sizeof *paths && engine->mantissa_bits > 24; i++) {
        Scene *scene = load_scene(paths[i]);
        Light nearest = {0};
        for (int way = 0; way < ROUNDING_DIRECTION_COUNT; way++) {
            build_meshes_rounded(scene, way);
            Light light = trace_rounded_picture(engine, scene, way);
            if (way == ROUNDING_NEAREST) {
                nearest = light;
                continue;
            }
            assert_at_most(count_changed(&nearest, &light), 0, "%s in %s, rounded %s, pixels",
                           paths[i], engine->name, directions[way].name);
            free(light.rgb);
        }
        free(nearest.rgb);
        scene_destroy(scene);
    }
}

/** See #check_mesh_pictures. */
static void test_mesh_pictures(void **state) {
    (void)state;
    for_every_engine(check_mesh_pictures);
}

/**
 * In the box, rays of the diagonal meet two walls at the same distance: some of these pixels change
 * in every number type.
 */
static void check_ties(const Engine *engine) {
    Scene *scene = load_scene("scenes/box.lua");
    Light nearest = trace_rounded_picture(engine, scene, ROUNDING_NEAREST);
    int changed = 0;
    for (int way = ROUNDING_UPWARD; way <= ROUNDING_DOWNWARD; way++) {
        Light light = trace_rounded_picture(engine, scene, way);
        changed += count_changed(&nearest, &light);
        free(light.rgb);
    }
    assert_true(changed > 0);
    free(nearest.rgb);
    scene_destroy(scene);
}

/** See #check_ties. */
static void test_ties(void **state) {
    (void)state;
    for_every_engine(check_ties);
}

/** Engines of one number type draw the same bits, in every direction of rounding. */
static void test_same_bits(void **state) {
    (void)state;
    static const char *const pairs[][2] = {{"f32x8", "f32x1"}, {"f64x4", "f64x1"}};
    static const char *const paths[] = {"scenes/box.lua", "scenes/glass-teapot.lua",
                                        "scenes/report-d-shapes.lua"};
    for (size_t i = 0; i < sizeof paths / sizeof *paths; i++) {
        Scene *scene = load_scene(paths[i]);
        for (size_t k = 0; k < 2 * ROUNDING_DIRECTION_COUNT; k++) {
            Error error = {0};
            const Engine *wide = engine_find(pairs[k % 2][0], &error),
                         *narrow = engine_find(pairs[k % 2][1], &error);
            if (wide && narrow) {
                Light a = trace_rounded_picture(wide, scene, (int)k / 2);
                Light b = trace_rounded_picture(narrow, scene, (int)k / 2);
                assert_memory_equal(a.rgb, b.rgb,
                                    3 * (size_t)a.width * (size_t)a.height * sizeof *a.rgb);
                free(a.rgb);
                free(b.rgb);
            }
        }
        scene_destroy(scene);
    }
}

/* --- the layer -------------------------------------------------------------------------------- */

/** @return The statistics of a layer of a scene. */
static LayerStats measure_layer(const char *path, const char *engine, Layer layer) {
    Error error = {0};
    LayerStats stats = {0};
    Scene *scene = load_scene(path);
    RenderSettings settings = small_settings(scene, engine, 3);
    settings.samples = 1;
    Renderer *renderer = create_renderer(scene, &settings);
    assert_true(renderer_measure_layer(renderer, scene, layer, NULL, &stats, &error));
    assert_int_equal((int)stats.pixel_count, WIDTH * HEIGHT);
    renderer_destroy(renderer);
    scene_destroy(scene);
    return stats;
}

/** A thread gets its own direction back, and different directions give different bits. */
static void test_direction_is_restored(void **state) {
    (void)state;
    Error error = {0};
    const Engine *engine = engine_find("f64x1", &error);
    Scene *scene = load_scene("scenes/chess.lua");
    Tracer *tracer = create_tracer(engine, scene);
    PixelGrid grid = {.x = 9, .y = 20, .columns = 8, .rows = 8, .stride = 1};
    RayCounts counts = {0};
    double rgb[ROUNDING_DIRECTION_COUNT][3 * 64];
    engine->set_view(tracer, scene, 40, 30);
    assert_true(rounding_is_supported());
    assert_int_equal(fegetround(), FE_TONEAREST);
    for (int way = 0; way < ROUNDING_DIRECTION_COUNT; way++) {
        assert_true(
            trace_rounded(engine, (RoundingDirection)way, tracer, &grid, rgb[way], &counts));
        assert_int_equal(fegetround(), FE_TONEAREST);
        assert_true(way == 0 || memcmp(rgb[way], rgb[way - 1], sizeof rgb[way]) != 0);
    }
    engine->destroy(tracer);
    scene_destroy(scene);
}

/** Fails unless a share of pixels is about that of doc/laboratory.md. */
static void assert_documented_share(const LayerStats *stats, double percent) {
    double share = 100 * (double)stats->artifact_pixels / (double)stats->pixel_count;
    assert_at_most(fabs(share - percent), percent / 2, "share of pixels %g %%, not about %g %%",
                   share, percent);
}

/**
 * The layer finds pixels of `chess.lua` that hang on the last bit in float, no fewer than those
 * that are wrong, and none in double.
 */
static void test_layer(void **state) {
    (void)state;
    LayerStats single = measure_layer("scenes/chess.lua", "f32x8", LAYER_ROUNDING);
    LayerStats wrong = measure_layer("scenes/chess.lua", "f32x8", LAYER_ERROR);
    LayerStats twofold =
        measure_layer("scenes/chess.lua", engine_with_role(ENGINE_DOUBLE)->name, LAYER_ROUNDING);
    printf("chess: in float %g and in double %g of %g pixels hang on the last bit; %g are wrong\n",
           (double)single.artifact_pixels, (double)twofold.artifact_pixels,
           (double)single.pixel_count, (double)wrong.artifact_pixels);
    assert_true(wrong.artifact_pixels > 0 && single.artifact_pixels >= wrong.artifact_pixels);
    assert_int_equal((int)twofold.artifact_pixels, 0);
    assert_documented_share(&single, 0.4);
    assert_documented_share(&wrong, 0.1);
}

/**
 * Where an error is the same in all directions the layer sees nothing: in float, the ground of a
 * radius of a million units is wrong in many more pixels than change.
 */
static void test_blind_spot(void **state) {
    (void)state;
    LayerStats seen = measure_layer("tests/scenes/ground-sphere.lua", "f32x8", LAYER_ROUNDING);
    LayerStats wrong = measure_layer("tests/scenes/ground-sphere.lua", "f32x8", LAYER_ERROR);
    printf("ground-sphere: in float %g of %g pixels hang on the last bit, and %g are wrong\n",
           (double)seen.artifact_pixels, (double)seen.pixel_count, (double)wrong.artifact_pixels);
    assert_true(wrong.artifact_pixels > 5 * seen.artifact_pixels);
    assert_documented_share(&seen, 0.1);
    assert_documented_share(&wrong, 1.0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shapes),        cmocka_unit_test(test_edges),
        cmocka_unit_test(test_mesh_pictures), cmocka_unit_test(test_ties),
        cmocka_unit_test(test_same_bits),     cmocka_unit_test(test_direction_is_restored),
        cmocka_unit_test(test_layer),         cmocka_unit_test(test_blind_spot),
    };
    return cmocka_run_group_tests_name("rounding", tests, init_transforms, NULL);
}
