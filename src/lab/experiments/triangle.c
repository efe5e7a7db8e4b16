/**
 * @file
 * @brief Experiments on triangles: the edges and corners that they share, small ones, thin ones.
 */
#include "dioptre/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/icosphere.h"
#include "lab/experiments/pose.h"

/* --- a closed surface, from inside --- */

/** Radii. */
static const double offsets[] = {1, 10, 1e2, 1e3, 1e4};

/** @return The closed surface. See #Experiment.build. @param level Its distance from the origin. */
static void *build_ball(double level) {
    return icosphere_create(place_far(level));
}

/** @return Where a ray starts: somewhere in the middle half of the ball. @param setting Where.
 *  @param[in,out] random Where it comes from. */
static Quad3 start_inside(const Setting *setting, Random *random) {
    Quad3 beside = quad3_scale(random_direction(random), random_between(random, 0, 0.5));
    return rounded(setting->type, quad3_add(place_far(setting->level), beside));
}

/** Writes the question whether a ray meets a face. @param[in,out] writer Where to. @param ball The
 *  surface. @param ray Where it starts, and which way. @param face The face; -1: none, a triangle
 *  without area. */
static void write_face(Writer *writer, const Icosphere *ball, const Quad3 ray[2], int face) {
    write_vector(writer, ray[0]);
    write_vector(writer, ray[1]);
    for (int k = 0; k < 3; k++) {
        write_vector(writer, ball->corners[face < 0 ? 0 : ball->faces[face][k]]);
    }
}

/** Writes the questions about all faces around one corner or two, #CASE_PARTS_MAXIMUM in all.
 *  @param setting Where. @param ray Where it starts, and which way. @param ends The corners.
 *  @param[out] posed The case. */
static void write_faces(const Setting *setting, const Quad3 ray[2], const int ends[2],
                        Case *posed) {
    const Icosphere *ball = setting->world;
    Writer writer = {setting->type, posed->questions};
    int count = 0;
    for (int end = 0; end < 2; end++) {
        for (int i = 0; i < ball->valence[ends[end]]; i++) {
            int face = ball->around[ends[end]][i];
            const int *corners = ball->faces[face];
            bool is_asked = end == 1 && (corners[0] == ends[0] || corners[1] == ends[0] ||
                                         corners[2] == ends[0]);
            if (!is_asked) {
                write_face(&writer, ball, ray, face);
                count++;
            }
        }
    }
    for (; count < CASE_PARTS_MAXIMUM; count++) {
        write_face(&writer, ball, ray, -1);
    }
}

/** Poses a ray to an edge or a corner. @param setting Where. @param[in,out] random Where it comes
 *  from. @param share How far along an edge it aims, 0 for its end. @param[out] posed The case. */
static void pose_at(const Setting *setting, Random *random, Quadruple share, Case *posed) {
    const Icosphere *ball = setting->world;
    const int *face = ball->faces[random_bits(random) % ICOSPHERE_FACES];
    size_t first = random_bits(random) % 3;
    const int ends[2] = {face[first], share == 0 ? face[first] : face[(first + 1) % 3]};
    Quad3 a = ball->corners[ends[0]], b = ball->corners[ends[1]];
    Quad3 target = quad3_add(a, quad3_scale(quad3_subtract(b, a), share));
    Quad3 origin = start_inside(setting, random);
    Quad3 direction = quad3_normalize(quad3_subtract(target, origin));
    write_faces(setting, (const Quad3[]){origin, direction}, ends, posed);
}

/** Poses a ray to an edge. See #Experiment.pose. @param setting Where. @param[in,out] random Where
 *  it comes from. @param[out] posed The case. */
static void pose_edge(const Setting *setting, Random *random, Case *posed) {
    pose_at(setting, random, random_between(random, 0.01, 0.99), posed);
}

/** Poses a ray to a corner. See #Experiment.pose. @param setting Where. @param[in,out] random Where
 *  it comes from. @param[out] posed The case. */
static void pose_corner(const Setting *setting, Random *random, Case *posed) {
    pose_at(setting, random, 0, posed);
}

/** Judges how many faces were met: one, where a ray leaves a closed surface. See #Experiment.judge.
 *  @param posed Not looked at. @param answers A distance each. @param[in,out] score The score. */
static void judge_faces(const Case *posed, const Quadruple *answers, Score *score) {
    (void)posed;
    int count = 0;
    for (int i = 0; i < CASE_PARTS_MAXIMUM; i++) {
        count += answers[i] < QUAD_NONE;
    }
    score_outcome(score, OUTCOME_LEAK, count == 0);
    if (answers[1] != COUNT_UNKNOWN) {
        score_outcome(score, OUTCOME_DOUBLE_HIT, count > 1);
    }
}

/** @return The ball as a model. See #Experiment.scene. @param setting Where. @param[out] error What
 *  is wrong. */
static Scene *scene_ball(const Setting *setting, Error *error) {
    const Icosphere *ball = setting->world;
    Mesh counts = {.position_count = ICOSPHERE_CORNERS, .triangle_count = ICOSPHERE_FACES};
    Mesh *mesh = mesh_create(&counts, error);
    if (!mesh) {
        return NULL;
    }
    for (int i = 0; i < ICOSPHERE_CORNERS; i++) {
        Quad3 c = ball->corners[i];
        mesh->positions[i] = (Vector3){(double)c.x, (double)c.y, (double)c.z};
    }
    for (int i = 0; i < ICOSPHERE_FACES; i++) {
        const int *f = ball->faces[i];
        mesh->triangles[i] = (MeshTriangle){{(uint32_t)f[0], (uint32_t)f[1], (uint32_t)f[2]}};
    }
    return stage_with_mesh(mesh, error);
}

/** Asks an engine for the nearest face of the whole ball. See #Experiment.ask. @param engine The
 *  engine. @param tracer Its tracer. @param posed The case. @param[out] answers One of them. */
static void ask_ball(const Engine *engine, Tracer *tracer, const Case *posed, Quadruple *answers) {
    RayAnswer answer;
    const Quad3 ray[2] = {quad3_of(posed->questions), quad3_of(posed->questions + 3)};
    engine_ask(engine, tracer, ray, &answer);
    for (int i = 0; i < CASE_PARTS_MAXIMUM; i++) {
        answers[i] = QUAD_NONE;
    }
    if (answer.shape >= 0) {
        answers[0] = answer.distance;
        answers[1] = COUNT_UNKNOWN;
    }
}

const Experiment triangle_edges_experiment = {
    .name = "triangle-edges",
    .title = N_("Rays from inside a closed surface of 1280 triangles, aimed at their edges"),
    .family = "triangle",
    .stress = N_("distance from the origin / radius"),
    .levels = offsets,
    .level_count = COUNT_OF(offsets),
    .cases = 10000,
    .parts = CASE_PARTS_MAXIMUM,
    .timed = 1,
    .build = build_ball,
    .pose = pose_edge,
    .judge = judge_faces,
    .scene = scene_ball,
    .ask = ask_ball,
};

const Experiment triangle_corners_experiment = {
    .name = "triangle-corners",
    .title = N_("Rays from inside a closed surface of 1280 triangles, aimed at their corners"),
    .family = "triangle",
    .stress = N_("distance from the origin / radius"),
    .levels = offsets,
    .level_count = COUNT_OF(offsets),
    .cases = 10000,
    .parts = CASE_PARTS_MAXIMUM,
    .build = build_ball,
    .pose = pose_corner,
    .judge = judge_faces,
    .scene = scene_ball,
    .ask = ask_ball,
};

/* --- one triangle --- */

/** A triangle that is looked at. */
typedef struct Single {
    Quad3 corners[3]; /**< Its corners, exact in float. */
    double distance;  /**< From where. */
    double sine;      /**< Of the angle under which it is met. */
} Single;

/** @return Where a ray meets a triangle, in quad precision; #QUAD_NONE: nowhere. @param o Where it
 *  starts. @param d Which way. @param c The corners. */
static Quadruple triangle_truth(Quad3 o, Quad3 d, const Quad3 c[3]) {
    Quad3 e1 = quad3_subtract(c[1], c[0]), e2 = quad3_subtract(c[2], c[0]);
    Quad3 p = quad3_cross(d, e2), s = quad3_subtract(o, c[0]), r = quad3_cross(s, e1);
    Quadruple determinant = quad3_dot(e1, p);
    Quadruple u = quad3_dot(s, p) / determinant, v = quad3_dot(d, r) / determinant;
    Quadruple t = quad3_dot(e2, r) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : QUAD_NONE;
}

/** Poses a ray to somewhere inside a triangle. @param setting Where. @param single The triangle.
 *  @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose_single(const Setting *setting, const Single *single, Random *random, Case *posed) {
    const Quad3 *c = single->corners;
    Quad3 e1 = quad3_subtract(c[1], c[0]), e2 = quad3_subtract(c[2], c[0]);
    Quadruple u = random_share(random), v = random_share(random) * (1 - (double)u);
    Quad3 target = quad3_add(c[0], quad3_add(quad3_scale(e1, u), quad3_scale(e2, v)));
    Quad3 normal = quad3_normalize(quad3_cross(e1, e2));
    Quad3 along = quad3_normalize(random_across(random, normal, 1));
    Quadruple cosine = quad_sqrt(1 - (Quadruple)single->sine * single->sine);
    Quad3 away = quad3_add(quad3_scale(normal, single->sine), quad3_scale(along, cosine));
    Writer writer = {setting->type, posed->questions};
    Quad3 origin = write_vector(&writer, quad3_add(target, quad3_scale(away, single->distance)));
    Quad3 direction = write_vector(&writer, quad3_normalize(quad3_subtract(target, origin)));
    for (int k = 0; k < 3; k++) {
        write_vector(&writer, c[k]);
    }
    posed->truth[0] = triangle_truth(origin, direction, c);
}

/** @return The scene of a triangle. @param single The triangle. @param[out] error What is wrong. */
static Scene *single_scene(const Single *single, Error *error) {
    StageValue values[] = {{.name = "a"}, {.name = "b"}, {.name = "c"}, {0}};
    for (int k = 0; k < 3; k++) {
        to_numbers(single->corners[k], values[k].numbers);
    }
    return stage_with("triangle", values, error);
}

/** @return A right triangle, in no special direction, all float. @param a A leg. @param b The
 *  other. */
static Single right_triangle(double a, double b) {
    const NumberType *narrowest = number_types()[0];
    Quad3 x = quad3_normalize((Quad3){0.8, 0.36, -0.48});
    Quad3 y = quad3_normalize(quad3_cross(x, (Quad3){0.3, 0.9, 0.2}));
    return (Single){.corners = {{0, 0, 0},
                                rounded(narrowest, quad3_scale(x, a)),
                                rounded(narrowest, quad3_scale(y, b))}};
}

/** Scene units. */
static const double legs[] = {1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};

/** @return A small triangle. @param leg How small. */
static Single small_triangle(double leg) {
    Single single = right_triangle(leg, leg);
    single.distance = 3 * leg;
    single.sine = 0.8;
    return single;
}

/** Poses a small triangle. See #Experiment.pose. @param setting Where. @param[in,out] random Where
 *  it comes from. @param[out] posed The case. */
static void pose_small(const Setting *setting, Random *random, Case *posed) {
    Single single = small_triangle(setting->level);
    pose_single(setting, &single, random, posed);
}

/** @return Its scene. See #Experiment.scene. @param setting Where. @param[out] error What is wrong.
 */
static Scene *scene_small(const Setting *setting, Error *error) {
    Single single = small_triangle(setting->level);
    return single_scene(&single, error);
}

const Experiment triangle_small_experiment = {
    .name = "triangle-small",
    .title = N_("A right triangle, ever smaller, three legs away"),
    .family = "triangle",
    .stress = N_("leg, scene units"),
    .error = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = legs,
    .level_count = COUNT_OF(legs),
    .cases = 5000,
    .parts = 1,
    .pose = pose_small,
    .judge = judge_distance,
    .scene = scene_small,
};

/** Length over width. */
static const double aspects[] = {1, 10, 1e2, 1e3, 1e4, 1e5, 1e6};

/** @return A thin triangle. @param aspect How thin. */
static Single thin_triangle(double aspect) {
    Single single = right_triangle(1, 1 / aspect);
    single.distance = 10;
    single.sine = 0.1;
    return single;
}

/** Poses a thin triangle. See #Experiment.pose. @param setting Where. @param[in,out] random Where
 *  it comes from. @param[out] posed The case. */
static void pose_thin(const Setting *setting, Random *random, Case *posed) {
    Single single = thin_triangle(setting->level);
    pose_single(setting, &single, random, posed);
}

/** @return Its scene. See #Experiment.scene. @param setting Where. @param[out] error What is wrong.
 */
static Scene *scene_thin(const Setting *setting, Error *error) {
    Single single = thin_triangle(setting->level);
    return single_scene(&single, error);
}

const Experiment triangle_thin_experiment = {
    .name = "triangle-thin",
    .title = N_("A right triangle of length 1, ever thinner, ten units away, under six degrees"),
    .family = "triangle",
    .stress = N_("length / width"),
    .error = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = aspects,
    .level_count = COUNT_OF(aspects),
    .cases = 5000,
    .parts = 1,
    .timed = 1e4,
    .pose = pose_thin,
    .judge = judge_distance,
    .scene = scene_thin,
};
