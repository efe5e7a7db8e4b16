/**
 * @file
 * @brief Experiments on triangles: the edges and corners that they share, small ones, thin ones.
 */
#include "base/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/icosphere.h"
#include "lab/experiments/sample_writer.h"

/* --- a closed surface, from inside --- */

/** Radii. */
static const double origin_distances[] = {1, 10, 1e2, 1e3, 1e4};

/** @return The closed surface. See #Experiment.create_shared. @param level Its distance from the
 * origin. */
static void *build_icosphere(double level) {
    return icosphere_create(far_point(level));
}

/** @return The origin of a ray, in the inner half of the sphere. */
static Vec3q random_origin_inside(const ExperimentSetup *setup, Random *random) {
    Vec3q lateral = vec3q_scale(random_direction(random), random_range(random, 0, 0.5));
    return vec3q_round(setup->type, vec3q_add(far_point(setup->level), lateral));
}

/**
 * Writes the input of a test of a ray against a face.
 * @param ray  Origin and direction.
 * @param face  Index of the face; -1: none, a triangle without area.
 */
static void write_face_input(SampleWriter *writer, const Icosphere *ball, const Vec3q ray[2],
                             int face) {
    sample_writer_vec3(writer, ray[0]);
    sample_writer_vec3(writer, ray[1]);
    Vec3q corners[3];
    for (int k = 0; k < 3; k++) {
        corners[k] = ball->vertices[face < 0 ? 0 : ball->faces[face][k]];
    }
    sample_writer_triangle(writer, corners);
}

/**
 * Writes the inputs for all faces around one corner or two, #SAMPLE_QUERIES_MAXIMUM in all.
 * @param ray  Origin and direction.
 */
static void write_fan_faces(const ExperimentSetup *setup, const Vec3q ray[2], const int ends[2],
                            ExperimentSample *sample) {
    const Icosphere *ball = setup->shared;
    SampleWriter writer = {setup->type, sample->inputs};
    int count = 0;
    for (int end = 0; end < 2; end++) {
        for (int i = 0; i < ball->valence[ends[end]]; i++) {
            int face = ball->vertex_faces[ends[end]][i];
            const int *corners = ball->faces[face];
            bool is_included = end == 1 && (corners[0] == ends[0] || corners[1] == ends[0] ||
                                            corners[2] == ends[0]);
            if (!is_included) {
                write_face_input(&writer, ball, ray, face);
                count++;
            }
        }
    }
    for (; count < SAMPLE_QUERIES_MAXIMUM; count++) {
        write_face_input(&writer, ball, ray, -1);
    }
}

/** Generates a ray to an edge or a corner. @param fraction  How far along an edge it aims, 0 for
 * its end. */
static void generate_edge_ray(const ExperimentSetup *setup, Random *random, Quadruple fraction,
                              ExperimentSample *sample) {
    const Icosphere *ball = setup->shared;
    const int *face = ball->faces[random_bits(random) % ICOSPHERE_FACES];
    size_t first = random_bits(random) % 3;
    const int ends[2] = {face[first], fraction == 0 ? face[first] : face[(first + 1) % 3]};
    Vec3q a = ball->vertices[ends[0]], b = ball->vertices[ends[1]];
    Vec3q target = vec3q_add(a, vec3q_scale(vec3q_subtract(b, a), fraction));
    Vec3q origin = random_origin_inside(setup, random);
    Vec3q direction = vec3q_normalize(vec3q_subtract(target, origin));
    write_fan_faces(setup, (const Vec3q[]){origin, direction}, ends, sample);
}

/** Generates a ray to an edge, see #Experiment.generate. */
static void generate_edge(const ExperimentSetup *setup, Random *random, ExperimentSample *sample) {
    generate_edge_ray(setup, random, random_range(random, 0.01, 0.99), sample);
}

/** Generates a ray to a corner, see #Experiment.generate. */
static void generate_corner(const ExperimentSetup *setup, Random *random,
                            ExperimentSample *sample) {
    generate_edge_ray(setup, random, 0, sample);
}

/**
 * Scores the number of faces hit: one, where a ray leaves a closed surface. See
 * #Experiment.score_sample.
 */
static void score_faces(const ExperimentSample *sample, const Quadruple *outputs,
                        ScoreStats *score) {
    (void)sample;
    int count = 0;
    for (int i = 0; i < SAMPLE_QUERIES_MAXIMUM; i++) {
        count += outputs[i] < QUAD_NO_HIT;
    }
    score_outcome(score, OUTCOME_LEAK, count == 0);
    if (outputs[1] != COUNT_UNKNOWN) {
        score_outcome(score, OUTCOME_DOUBLE_HIT, count > 1);
    }
}

/** @return The sphere as a mesh, see #Experiment.create_scene. */
static Scene *icosphere_scene(const ExperimentSetup *setup, Error *error) {
    const Icosphere *ball = setup->shared;
    Mesh counts = {.position_count = ICOSPHERE_CORNERS, .triangle_count = ICOSPHERE_FACES};
    Mesh *mesh = mesh_create(&counts, error);
    if (!mesh) {
        return NULL;
    }
    for (int i = 0; i < ICOSPHERE_CORNERS; i++) {
        Vec3q c = ball->vertices[i];
        mesh->positions[i] = (Vec3d){(double)c.x, (double)c.y, (double)c.z};
    }
    for (int i = 0; i < ICOSPHERE_FACES; i++) {
        const int *f = ball->faces[i];
        mesh->triangles[i] = (MeshTriangle){{(uint32_t)f[0], (uint32_t)f[1], (uint32_t)f[2]}};
    }
    return scene_fixture_with_mesh(mesh, error);
}

/** Queries an engine for the nearest face of the whole mesh, see #Experiment.query_engine. */
static void query_icosphere(const Engine *engine, Tracer *tracer, const ExperimentSample *sample,
                            Quadruple *outputs) {
    RayResult answer;
    const Vec3q ray[2] = {vec3q_from_array(sample->inputs), vec3q_from_array(sample->inputs + 3)};
    intersect_ray(engine, tracer, ray, &answer);
    for (int i = 0; i < SAMPLE_QUERIES_MAXIMUM; i++) {
        outputs[i] = QUAD_NO_HIT;
    }
    if (answer.shape >= 0) {
        outputs[0] = answer.distance;
        outputs[1] = COUNT_UNKNOWN;
    }
}

const Experiment triangle_edges_experiment = {
    .name = "triangle-edges",
    .title = N_("Rays from inside a closed surface of 1280 triangles, aimed at their edges"),
    .family = "triangle",
    .difficulty = N_("distance from the origin / radius"),
    .levels = origin_distances,
    .level_count = COUNT_OF(origin_distances),
    .sample_count = 10000,
    .queries_per_sample = SAMPLE_QUERIES_MAXIMUM,
    .timed_level = 1,
    .create_shared = build_icosphere,
    .generate = generate_edge,
    .score_sample = score_faces,
    .create_scene = icosphere_scene,
    .query_engine = query_icosphere,
    .is_nearest_hit = true,
};

const Experiment triangle_corners_experiment = {
    .name = "triangle-corners",
    .title = N_("Rays from inside a closed surface of 1280 triangles, aimed at their corners"),
    .family = "triangle",
    .difficulty = N_("distance from the origin / radius"),
    .levels = origin_distances,
    .level_count = COUNT_OF(origin_distances),
    .sample_count = 10000,
    .queries_per_sample = SAMPLE_QUERIES_MAXIMUM,
    .create_shared = build_icosphere,
    .generate = generate_corner,
    .score_sample = score_faces,
    .create_scene = icosphere_scene,
    .query_engine = query_icosphere,
    .is_nearest_hit = true,
};

/* --- whole numbers --- */

/** Cells of the grid in a radius. */
static const double grid_cells[] = {32, 128, 512, 2048, 8192};
/** How far from the middle rays start, in radii: all of them leave through the face they aim at. */
#define GRID_ORIGIN_RADIUS 0.25

/** @return A vector with whole coordinates. */
static Vec3q vec3q_whole(Vec3q v) {
    // Halves are added before the fraction is cut off, away from zero.
    return (Vec3q){(int)(v.x + (v.x < 0 ? -0.5 : 0.5)), (int)(v.y + (v.y < 0 ? -0.5 : 0.5)),
                   (int)(v.z + (v.z < 0 ? -0.5 : 0.5))};
}

/** @return A closed surface with corners on a grid. See #Experiment.create_shared. @param level
 *  Cells in its radius. */
static void *build_grid_sphere(double level) {
    Icosphere *ball = icosphere_create((Vec3q){0, 0, 0});
    for (int i = 0; ball && i < ball->vertex_count; i++) {
        ball->vertices[i] = vec3q_whole(vec3q_scale(ball->vertices[i], level));
    }
    return ball;
}

/** Generates a ray of whole numbers that runs exactly through a corner or the middle of an edge,
 *  see #Experiment.generate. */
static void generate_grid_ray(const ExperimentSetup *setup, Random *random,
                              ExperimentSample *sample) {
    const Icosphere *ball = setup->shared;
    const int *face = ball->faces[random_bits(random) % ICOSPHERE_FACES];
    size_t first = random_bits(random) % 3;
    bool is_corner = random_bits(random) % 2;
    const int ends[2] = {face[first], face[is_corner ? first : (first + 1) % 3]};
    Vec3q inside = vec3q_scale(random_direction(random),
                               setup->level * random_range(random, 0, GRID_ORIGIN_RADIUS));
    Vec3q origin = vec3q_whole(inside);
    Vec3q both = vec3q_add(ball->vertices[ends[0]], ball->vertices[ends[1]]);
    Vec3q direction = vec3q_subtract(both, vec3q_scale(origin, 2)); // It ends at twice the way.
    write_fan_faces(setup, (const Vec3q[]){origin, direction}, ends, sample);
}

const Experiment triangle_grid_experiment = {
    .name = "triangle-grid",
    .title = N_("Rays of whole numbers, exactly through corners and edges that are whole numbers"),
    .family = "triangle",
    .difficulty = N_("cells of the grid / radius"),
    .levels = grid_cells,
    .level_count = COUNT_OF(grid_cells),
    .sample_count = 10000,
    .queries_per_sample = SAMPLE_QUERIES_MAXIMUM,
    .timed_level = 128,
    .create_shared = build_grid_sphere,
    .generate = generate_grid_ray,
    .score_sample = score_faces,
    .create_scene = icosphere_scene,
    .query_engine = query_icosphere,
    .is_nearest_hit = true,
};

/* --- one triangle --- */

/** A triangle in view. */
typedef struct TestTriangle {
    Vec3q corners[3]; /**< Its corners, exact in float. */
    double distance;  /**< Distance of the viewpoint. */
    double sine;      /**< Sine of the angle between ray and plane. */
} TestTriangle;

/** @return Where a ray meets a triangle, in quad precision; #QUAD_NO_HIT: nowhere. */
static Quadruple triangle_expected(Vec3q o, Vec3q d, const Vec3q c[3]) {
    Vec3q e1 = vec3q_subtract(c[1], c[0]), e2 = vec3q_subtract(c[2], c[0]);
    Vec3q p = vec3q_cross(d, e2), s = vec3q_subtract(o, c[0]), r = vec3q_cross(s, e1);
    Quadruple determinant = vec3q_dot(e1, p);
    Quadruple u = vec3q_dot(s, p) / determinant, v = vec3q_dot(d, r) / determinant;
    Quadruple t = vec3q_dot(e2, r) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : QUAD_NO_HIT;
}

/** Generates a ray to somewhere inside a triangle. */
static void generate_triangle_ray(const ExperimentSetup *setup, const TestTriangle *single,
                                  Random *random, ExperimentSample *sample) {
    const Vec3q *c = single->corners;
    Vec3q e1 = vec3q_subtract(c[1], c[0]), e2 = vec3q_subtract(c[2], c[0]);
    Quadruple u = random_unit(random), v = random_unit(random) * (1 - (double)u);
    Vec3q target = vec3q_add(c[0], vec3q_add(vec3q_scale(e1, u), vec3q_scale(e2, v)));
    Vec3q normal = vec3q_normalize(vec3q_cross(e1, e2));
    Vec3q along = vec3q_normalize(random_in_disc(random, normal, 1));
    Quadruple cosine = quad_sqrt(1 - (Quadruple)single->sine * single->sine);
    Vec3q away = vec3q_add(vec3q_scale(normal, single->sine), vec3q_scale(along, cosine));
    SampleWriter writer = {setup->type, sample->inputs};
    Vec3q origin =
        sample_writer_vec3(&writer, vec3q_add(target, vec3q_scale(away, single->distance)));
    Vec3q direction = sample_writer_vec3(&writer, vec3q_normalize(vec3q_subtract(target, origin)));
    sample_writer_triangle(&writer, c);
    sample->expected[0] = triangle_expected(origin, direction, c);
}

/** @return The scene of a triangle. */
static Scene *test_triangle_scene(const TestTriangle *single, Error *error) {
    FixtureValue values[] = {{.name = "a"}, {.name = "b"}, {.name = "c"}, {0}};
    for (int k = 0; k < 3; k++) {
        vec3q_to_doubles(single->corners[k], values[k].components);
    }
    return scene_fixture_with_shape("triangle", values, error);
}

/** @return A right triangle, in no special direction, all float. */
static TestTriangle right_triangle(double a, double b) {
    const NumberType *narrowest = number_types()[0];
    Vec3q x = vec3q_normalize((Vec3q){0.8, 0.36, -0.48});
    Vec3q y = vec3q_normalize(vec3q_cross(x, (Vec3q){0.3, 0.9, 0.2}));
    return (TestTriangle){.corners = {{0, 0, 0},
                                      vec3q_round(narrowest, vec3q_scale(x, a)),
                                      vec3q_round(narrowest, vec3q_scale(y, b))}};
}

/** Scene units. */
static const double leg_lengths[] = {1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};

/** @return A small triangle. */
static TestTriangle small_triangle(double leg) {
    TestTriangle single = right_triangle(leg, leg);
    single.distance = 3 * leg;
    single.sine = 0.8;
    return single;
}

/** Generates a small triangle, see #Experiment.generate. */
static void generate_small(const ExperimentSetup *setup, Random *random, ExperimentSample *sample) {
    TestTriangle single = small_triangle(setup->level);
    generate_triangle_ray(setup, &single, random, sample);
}

/** Is an #Experiment.create_scene. */
static Scene *scene_small(const ExperimentSetup *setup, Error *error) {
    TestTriangle single = small_triangle(setup->level);
    return test_triangle_scene(&single, error);
}

const Experiment triangle_small_experiment = {
    .name = "triangle-small",
    .title = N_("A right triangle, ever smaller, three legs away"),
    .family = "triangle",
    .difficulty = N_("leg, scene units"),
    .error_label = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = leg_lengths,
    .level_count = COUNT_OF(leg_lengths),
    .sample_count = 5000,
    .queries_per_sample = 1,
    .generate = generate_small,
    .score_sample = score_expected_distance,
    .create_scene = scene_small,
};

/** Length over width. */
static const double aspects[] = {1, 10, 1e2, 1e3, 1e4, 1e5, 1e6};

/** @return A thin triangle. */
static TestTriangle thin_triangle(double aspect) {
    TestTriangle single = right_triangle(1, 1 / aspect);
    single.distance = 10;
    single.sine = 0.1;
    return single;
}

/** Generates a thin triangle, see #Experiment.generate. */
static void generate_thin(const ExperimentSetup *setup, Random *random, ExperimentSample *sample) {
    TestTriangle single = thin_triangle(setup->level);
    generate_triangle_ray(setup, &single, random, sample);
}

/** Is an #Experiment.create_scene. */
static Scene *scene_thin(const ExperimentSetup *setup, Error *error) {
    TestTriangle single = thin_triangle(setup->level);
    return test_triangle_scene(&single, error);
}

const Experiment triangle_thin_experiment = {
    .name = "triangle-thin",
    .title = N_("A right triangle of length 1, ever thinner, ten units away, under six degrees"),
    .family = "triangle",
    .difficulty = N_("length / width"),
    .error_label = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = aspects,
    .level_count = COUNT_OF(aspects),
    .sample_count = 5000,
    .queries_per_sample = 1,
    .timed_level = 1e4,
    .generate = generate_thin,
    .score_sample = score_expected_distance,
    .create_scene = scene_thin,
};
