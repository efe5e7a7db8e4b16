/**
 * @file
 * @brief Asks our engines and Embree the same questions where methods fail, and compares all
 * answers with the truth, worked out in quads from the very same floats.
 *
 * Spheres far away and far from zero, slivers that are grazed, and rays aimed at the edges and
 * corners of a closed mesh. Embree is asked in its robust mode, ray by ray.
 *
 * Usage: `peer-accuracy ENGINE...`: which of our engines. Prints tables.
 */
#include "triangles.h"

#include <embree3/rtcore.h>
#include <time.h>

/** Rays of one line of a table. */
enum { RAYS = 200000 };
/** Most of our engines. */
enum { ENGINES_MAXIMUM = 4 };

/** A ray and what it truly meets. */
typedef struct Question {
    float origin[3];    /**< Where it starts. */
    float direction[3]; /**< Which way. */
    bool is_hit;        /**< Whether it meets anything. */
    bool is_near_edge;  /**< Whether it passes so near the edge that only the answer counts, and not
                             how far: the distance jumps there. */
    Quadruple distance; /**< How far, in lengths of its direction. */
} Question;

/** What somebody says. */
typedef struct Answer {
    bool is_hit;     /**< Whether the ray meets anything. */
    double distance; /**< How far. */
} Answer;

/** What is asked about: one scene, in everybody's form. */
typedef struct Subject {
    Scene *scene;    /**< For our engines. */
    RTCScene embree; /**< For Embree. */
} Subject;

/** How wrong somebody was. */
typedef struct Score {
    long misses;  /**< Rays that meet something and were said not to. */
    long hits;    /**< Rays that meet nothing and were said to. */
    double worst; /**< Largest relative error of a distance. */
} Score;

/** Everybody, and the questions. */
typedef struct Contest {
    const Engine *engines[ENGINES_MAXIMUM]; /**< Ours. */
    int engine_count;                       /**< How many. */
    RTCDevice device;                       /**< Embree. */
    Question *questions;                    /**< #RAYS of them. */
    Answer *answers;                        /**< As many. */
    uint64_t random;                        /**< A generator. */
} Contest;

// --- quads ---------------------------------------------------------------------------------------

/** @return Three floats as quads. @param v The floats. */
static Quad3 quad3_of_floats(const float v[3]) {
    return (Quad3){(Quadruple)v[0], (Quadruple)v[1], (Quadruple)v[2]};
}

/** @return A vector as quads. @param v The vector. */
static Quad3 quad3_of_vector(Vector3 v) {
    return (Quad3){(Quadruple)v.x, (Quadruple)v.y, (Quadruple)v.z};
}

/** Finds where a ray truly meets a sphere. @param[in,out] question The ray. @param center The
 *  sphere's. @param radius The sphere's. */
static void sphere_truth(Question *question, Vector3 center, double radius) {
    Quad3 d = quad3_of_floats(question->direction);
    Quad3 to = quad3_subtract(quad3_of_vector(center), quad3_of_floats(question->origin));
    Quadruple a = quad3_dot(d, d), b = quad3_dot(d, to), r = (Quadruple)radius;
    Quad3 aside = quad3_cross(d, to);
    // What is left of the square of half a chord; near the edge 2 % of the radius is said to be.
    Quadruple rest = a * r * r - quad3_dot(aside, aside), share = (Quadruple)0.0396;
    question->is_hit = rest >= 0;
    question->is_near_edge = rest < share * a * r * r;
    question->distance = question->is_hit ? (b - quad_sqrt(rest)) / a : 0;
}

/** Finds where a ray truly meets a triangle. @param[in,out] question The ray. @param corners The
 *  triangle's. */
static void triangle_truth(Question *question, const Vector3 corners[3]) {
    Quad3 o = quad3_of_floats(question->origin), d = quad3_of_floats(question->direction), to[3];
    for (int i = 0; i < 3; i++) {
        to[i] = quad3_subtract(quad3_of_vector(corners[i]), o);
    }
    Quadruple u = quad3_dot(d, quad3_cross(to[1], to[2]));
    Quadruple v = quad3_dot(d, quad3_cross(to[2], to[0]));
    Quadruple w = quad3_dot(d, quad3_cross(to[0], to[1]));
    Quad3 normal = quad3_cross(quad3_subtract(to[1], to[0]), quad3_subtract(to[2], to[0]));
    question->is_hit = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    question->is_near_edge = !question->is_hit;
    question->distance = quad3_dot(to[0], normal) / quad3_dot(d, normal);
}

// --- everybody -----------------------------------------------------------------------------------

/** Asks one of our engines. @param contest The contest. @param engine Which. @param subject About
 *  what. */
static void ask_ours(Contest *contest, const Engine *engine, const Subject *subject) {
    static PlainRay rays[BATCH];
    static int shapes[BATCH];
    static double distances[BATCH];
    Tracer *tracer = prepare(engine, subject->scene);
    for (size_t done = 0; done < RAYS; done += BATCH) {
        size_t count = RAYS - done < BATCH ? RAYS - done : BATCH;
        for (size_t i = 0; i < count; i++) {
            for (int axis = 0; axis < 3; axis++) {
                rays[i].origin[axis] = (double)contest->questions[done + i].origin[axis];
                rays[i].direction[axis] = (double)contest->questions[done + i].direction[axis];
            }
        }
        engine->nearest(tracer, count, rays, shapes, distances);
        for (size_t i = 0; i < count; i++) {
            contest->answers[done + i] = (Answer){shapes[i] >= 0, distances[i]};
        }
    }
    engine->release(tracer);
}

/** Asks Embree. @param contest The contest. @param subject About what. */
static void ask_embree(Contest *contest, const Subject *subject) {
    for (size_t i = 0; i < RAYS; i++) {
        const Question *question = &contest->questions[i];
        struct RTCIntersectContext context;
        struct RTCRayHit ray = {.ray = {.org_x = question->origin[0],
                                        .org_y = question->origin[1],
                                        .org_z = question->origin[2],
                                        .dir_x = question->direction[0],
                                        .dir_y = question->direction[1],
                                        .dir_z = question->direction[2],
                                        .tfar = INFINITY,
                                        .mask = UINT32_MAX},
                                .hit = {.geomID = RTC_INVALID_GEOMETRY_ID}};
        rtcInitIntersectContext(&context);
        rtcIntersect1(subject->embree, &context, &ray);
        contest->answers[i] =
            (Answer){ray.hit.geomID != RTC_INVALID_GEOMETRY_ID, (double)ray.ray.tfar};
    }
}

/** @return How wrong the newest answers are. @param contest The contest. */
static Score score_of(const Contest *contest) {
    Score score = {0};
    for (size_t i = 0; i < RAYS; i++) {
        const Question *question = &contest->questions[i];
        const Answer *answer = &contest->answers[i];
        score.misses += question->is_hit && !answer->is_hit;
        score.hits += !question->is_hit && answer->is_hit;
        if (question->is_hit && answer->is_hit && !question->is_near_edge) {
            Quadruple off = quad_abs((Quadruple)answer->distance - question->distance);
            score.worst = fmax(score.worst, (double)(off / quad_abs(question->distance)));
        }
    }
    return score;
}

/** Prints how wrong somebody was. @param score How wrong. */
static void score_print(Score score) {
    printf(" | %7.3f %7.3f %8.1e", 100.0 * (double)score.misses / RAYS,
           100.0 * (double)score.hits / RAYS, score.worst);
}

/** Asks everybody and prints a line. @param contest The contest, with questions. @param subject
 *  About what. @param name The line's. */
static void contest_run(Contest *contest, const Subject *subject, const char *name) {
    printf("  %-24s", name);
    for (int i = 0; i < contest->engine_count; i++) {
        ask_ours(contest, contest->engines[i], subject);
        score_print(score_of(contest));
    }
    ask_embree(contest, subject);
    score_print(score_of(contest));
    printf("\n");
}

/** Prints the heads of a table. @param contest The contest. @param title The table's. */
static void head_print(const Contest *contest, const char *title) {
    printf("\n%s\n  %-24s", title, "");
    for (int i = 0; i < contest->engine_count; i++) {
        printf(" | %-24s", contest->engines[i]->name);
    }
    printf(" | %-24s\n  %-24s", "Embree, robust", "");
    for (int i = 0; i <= contest->engine_count; i++) {
        printf(" | %7s %7s %8s", "% miss", "% false", "t off");
    }
    printf("\n");
}

// --- scenes in both forms ------------------------------------------------------------------------

/** Adds an Embree geometry as the only one. @param contest The contest. @param geometry It; given
 *  back. @return Its scene, to be given back. */
static RTCScene embree_scene(Contest *contest, RTCGeometry geometry) {
    RTCScene scene = rtcNewScene(contest->device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    assert_int_equal(rtcGetDeviceError(contest->device), RTC_ERROR_NONE);
    return scene;
}

/** @return A sphere for everybody, to be given back. @param contest The contest. @param center Its
 *  centre, exact in float. @param radius Its radius, exact in float. */
static Subject sphere_subject(Contest *contest, Vector3 center, double radius) {
    Subject subject = {.scene = empty_scene()};
    add_shape(subject.scene, "sphere", &(SphereParameters){center, radius});
    RTCGeometry geometry = rtcNewGeometry(contest->device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    float *sphere = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                            4 * sizeof *sphere, 1);
    sphere[0] = (float)center.x;
    sphere[1] = (float)center.y;
    sphere[2] = (float)center.z;
    sphere[3] = (float)radius;
    subject.embree = embree_scene(contest, geometry);
    return subject;
}

/** @return Triangles for everybody, to be given back. @param contest The contest.
 *  @param triangles They; corners exact in float. */
static Subject triangles_subject(Contest *contest, const Triangles *triangles) {
    Subject subject = {.scene = empty_scene()};
    add_triangles(subject.scene, triangles, 2);
    RTCGeometry geometry = rtcNewGeometry(contest->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float *corners = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             3 * sizeof *corners, triangles->position_count);
    for (size_t i = 0; i < triangles->position_count; i++) {
        corners[3 * i] = (float)triangles->positions[i].x;
        corners[3 * i + 1] = (float)triangles->positions[i].y;
        corners[3 * i + 2] = (float)triangles->positions[i].z;
    }
    void *places = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                           sizeof *triangles->triangles, triangles->triangle_count);
    memcpy(places, triangles->triangles, triangles->triangle_count * sizeof *triangles->triangles);
    subject.embree = embree_scene(contest, geometry);
    return subject;
}

/** Gives a subject back. @param subject It. */
static void subject_release(Subject *subject) {
    rtcReleaseScene(subject->embree);
    scene_destroy(subject->scene);
}

/** Aims a ray. @param[out] question The ray. @param from Where it starts. @param to Where it is
 *  aimed at; both are rounded. */
static void question_aim(Question *question, Vector3 from, Vector3 to) {
    *question = (Question){.origin = {(float)from.x, (float)from.y, (float)from.z}};
    question->direction[0] = (float)(to.x - (double)question->origin[0]);
    question->direction[1] = (float)(to.y - (double)question->origin[1]);
    question->direction[2] = (float)(to.z - (double)question->origin[2]);
}

/** @return A unit vector, any. @param[in,out] state A generator. */
static Vector3 any_direction(uint64_t *state) {
    double height = 2 * random_share(state) - 1, turn = 2 * M_PI * random_share(state);
    double across = sqrt(1 - height * height);
    return (Vector3){across * cos(turn), height, across * sin(turn)};
}

/** @return The nearest vector of floats. @param v A vector. */
static Vector3 vector_as_float(Vector3 v) {
    return (Vector3){as_float(v.x), as_float(v.y), as_float(v.z)};
}

// --- the questions -------------------------------------------------------------------------------

/**
 * Asks about a sphere: rays from all around that pass its centre at up to 1.02 radii.
 * @param contest   The contest.
 * @param center    The sphere's, exact in float.
 * @param distance  From its centre, radii; the radius is 1.
 * @param name      The line's.
 */
static void ask_sphere(Contest *contest, Vector3 center, double distance, const char *name) {
    for (size_t i = 0; i < RAYS; i++) {
        Vector3 out = any_direction(&contest->random);
        Vector3 aside = vector3_cross(out, any_direction(&contest->random));
        double by = 1.02 * sqrt(random_share(&contest->random));
        Vector3 eye = vector3_add(center, vector3_scale(out, distance));
        Vector3 aim = vector3_add(center, vector3_scale(vector3_normalize(aside), by));
        question_aim(&contest->questions[i], vector_as_float(eye), aim);
        sphere_truth(&contest->questions[i], center, 1);
    }
    Subject subject = sphere_subject(contest, center, 1);
    contest_run(contest, &subject, name);
    subject_release(&subject);
}

/** Spheres seen from far away, and spheres far from zero. @param contest The contest. */
static void ask_spheres(Contest *contest) {
    head_print(contest, "A sphere of radius 1 around zero, seen from");
    ask_sphere(contest, (Vector3){0, 0, 0}, 10, "10");
    ask_sphere(contest, (Vector3){0, 0, 0}, 1e3, "1e3");
    ask_sphere(contest, (Vector3){0, 0, 0}, 1e4, "1e4");
    ask_sphere(contest, (Vector3){0, 0, 0}, 1e5, "1e5");
    ask_sphere(contest, (Vector3){0, 0, 0}, 1e6, "1e6");
    head_print(contest, "A sphere of radius 1 seen from 5, its centre along each axis at");
    ask_sphere(contest, (Vector3){1e2, 1e2, 1e2}, 5, "1e2");
    ask_sphere(contest, (Vector3){1e4, 1e4, 1e4}, 5, "1e4");
    ask_sphere(contest, (Vector3){1e6, 1e6, 1e6}, 5, "1e6");
}

/**
 * Asks about a sliver: rays from 3 away that graze it, aimed at it and a little beside it.
 * @param contest  The contest.
 * @param aspect   How many times as long as it is high.
 * @param degrees  Between the rays and its plane.
 */
static void ask_sliver(Contest *contest, double aspect, double degrees) {
    char name[64];
    double angle = degrees * M_PI / 180;
    Triangles sliver = triangles_create(1);
    const Vector3 corners[3] = {vector_as_float((Vector3){-0.51, 0.13, 0.07}),
                                vector_as_float((Vector3){0.49, 0.21, 0.11}),
                                vector_as_float((Vector3){0.02, 0.15 + 1 / aspect, 0.1})};
    memcpy(sliver.positions, corners, sizeof corners);
    Vector3 along = vector3_normalize(vector3_subtract(corners[1], corners[0]));
    Vector3 side = vector3_subtract(corners[2], corners[0]);
    Vector3 normal = vector3_normalize(vector3_cross(along, side));
    Vector3 out = vector3_add(vector3_scale(along, cos(angle)), vector3_scale(normal, sin(angle)));
    for (size_t i = 0; i < RAYS; i++) {
        double u = random_share(&contest->random), v = 1.1 * random_share(&contest->random) - 0.05;
        Vector3 base = vector3_scale(vector3_subtract(corners[1], corners[0]), u * (1 - v));
        Vector3 aim = vector3_add(vector3_add(corners[0], base), vector3_scale(side, v));
        question_aim(&contest->questions[i],
                     vector_as_float(vector3_add(aim, vector3_scale(out, 3))), aim);
        triangle_truth(&contest->questions[i], corners);
    }
    Subject subject = triangles_subject(contest, &sliver);
    snprintf(name, sizeof name, "1 : %g, %g degrees", aspect, degrees);
    contest_run(contest, &subject, name);
    subject_release(&subject);
    triangles_release(&sliver);
}

/** Slivers. @param contest The contest. */
static void ask_slivers(Contest *contest) {
    head_print(contest, "A triangle of edge 1, its height, and the rays' angle to it");
    ask_sliver(contest, 1, 30);
    ask_sliver(contest, 1, 0.1);
    ask_sliver(contest, 1e3, 30);
    ask_sliver(contest, 1e3, 0.1);
    ask_sliver(contest, 1e5, 30);
    ask_sliver(contest, 1e5, 0.1);
}

/**
 * Asks about a closed mesh: rays from inside; each meets it.
 * @param contest    The contest.
 * @param mesh       The mesh.
 * @param at_corner  Whether the rays are aimed at corners, not edges.
 * @param name       The line's.
 */
static void ask_mesh(Contest *contest, const Triangles *mesh, bool at_corner, const char *name) {
    for (size_t i = 0; i < RAYS; i++) {
        uint64_t *state = &contest->random;
        size_t face = (size_t)((double)mesh->triangle_count * random_share(state));
        size_t from = (size_t)(3 * random_share(state));
        Vector3 corner = triangles_corner(mesh, face, from);
        Vector3 edge = vector3_subtract(triangles_corner(mesh, face, (from + 1) % 3), corner);
        Vector3 eye = {random_float(state, -1, 1), random_float(state, -1, 1),
                       random_float(state, -1, 1)};
        double share = at_corner ? 0 : random_share(state);
        Question *question = &contest->questions[i];
        question_aim(question, eye, vector3_add(corner, vector3_scale(edge, share)));
        // How far is not asked: which of the triangles is met is a matter of the last bit.
        question->is_hit = question->is_near_edge = true;
    }
    Subject subject = triangles_subject(contest, mesh);
    contest_run(contest, &subject, name);
    subject_release(&subject);
}

/** A closed mesh. @param contest The contest. */
static void ask_meshes(Contest *contest) {
    Triangles mesh = icosphere(3);
    head_print(contest, "Inside a closed mesh of 1280 triangles, at its");
    ask_mesh(contest, &mesh, false, "edges");
    ask_mesh(contest, &mesh, true, "corners");
    triangles_release(&mesh);
}

/**
 * Asks everything.
 * @param argc  Number of words.
 * @param argv  The words.
 * @return 0
 */
int main(int argc, char **argv) {
    Contest contest = {.device = rtcNewDevice("threads=1"), .random = 20261121};
    contest.questions = calloc(RAYS, sizeof *contest.questions);
    contest.answers = calloc(RAYS, sizeof *contest.answers);
    for (int i = 1; i < argc && contest.engine_count < ENGINES_MAXIMUM; i++) {
        Error error = {0};
        contest.engines[contest.engine_count] = engine_find(argv[i], &error);
        if (!contest.engines[contest.engine_count++]) {
            fprintf(stderr, "peer-accuracy: %s\n", error.message);
            return EXIT_FAILURE;
        }
    }
    ask_spheres(&contest);
    ask_slivers(&contest);
    ask_meshes(&contest);
    rtcReleaseDevice(contest.device);
    free(contest.questions);
    free(contest.answers);
    return EXIT_SUCCESS;
}
