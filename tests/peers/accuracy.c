/**
 * @file
 * @brief Compares the accuracy of our engines and Embree in difficult cases with a reference in
 *        quad precision, computed from the same floats.
 *
 * The cases are distant spheres, spheres far from the origin, grazing rays at slivers, and rays to
 * the edges and vertices of a closed mesh. Embree runs in its robust mode, with single rays.
 *
 * Usage: `peer-accuracy ENGINE...`: names of our engines. Prints tables.
 */
#include "triangle_soup.h"

#include <embree3/rtcore.h>
#include <time.h>

/** Rays per line of a table. */
enum { RAYS = 200000 };
/** Largest number of our engines. */
enum { ENGINES_MAXIMUM = 4 };

/** A ray and its expected result. */
typedef struct AccuracyQuery {
    float origin[3];    /**< Origin. */
    float direction[3]; /**< Direction. */
    bool is_hit;        /**< Whether it hits anything. */
    bool is_near_edge;  /**< Whether it passes so near to an edge that only hit or miss counts:
                             the distance is discontinuous there. */
    Quadruple distance; /**< Distance, in lengths of the direction. */
} AccuracyQuery;

/** The result of one tracer. */
typedef struct AccuracyAnswer {
    bool is_hit;     /**< Whether the ray hits anything. */
    double distance; /**< Distance. */
} AccuracyAnswer;

/** A test scene, in the formats of all tracers. */
typedef struct AccuracyScene {
    Scene *scene;    /**< For our engines. */
    RTCScene embree; /**< For Embree. */
} AccuracyScene;

/** The errors of one tracer. */
typedef struct AccuracyScore {
    long misses;  /**< False misses. */
    long hits;    /**< False hits. */
    double worst; /**< Largest relative error of a distance. */
} AccuracyScore;

/** All tracers and the rays. */
typedef struct AccuracyRun {
    const Engine *engines[ENGINES_MAXIMUM]; /**< Our engines. */
    int engine_count;                       /**< Number of #engines. */
    RTCDevice device;                       /**< The Embree device. */
    AccuracyQuery *questions;               /**< The rays: #RAYS of them. */
    AccuracyAnswer *answers;                /**< Their results. */
    uint64_t random;                        /**< State of the random generator. */
} AccuracyRun;

// --- quad precision ------------------------------------------------------------------------------

/** @return Three floats as quads. */
static Vec3q vec3q_from_floats(const float v[3]) {
    return (Vec3q){(Quadruple)v[0], (Quadruple)v[1], (Quadruple)v[2]};
}

/** @return A vector as quads. */
static Vec3q vec3q_from_vec3d(Vec3d v) {
    return (Vec3q){(Quadruple)v.x, (Quadruple)v.y, (Quadruple)v.z};
}

/** Computes the expected hit of a ray and a sphere. */
static void sphere_expected(AccuracyQuery *question, Vec3d center, double radius) {
    Vec3q d = vec3q_from_floats(question->direction);
    Vec3q to = vec3q_subtract(vec3q_from_vec3d(center), vec3q_from_floats(question->origin));
    Quadruple a = vec3q_dot(d, d), b = vec3q_dot(d, to), r = (Quadruple)radius;
    Vec3q lateral = vec3q_cross(d, to);
    // The squared half chord, scaled. Rays beyond 98 % of the radius are near the edge.
    Quadruple rest = a * r * r - vec3q_dot(lateral, lateral), fraction = (Quadruple)0.0396;
    question->is_hit = rest >= 0;
    question->is_near_edge = rest < fraction * a * r * r;
    question->distance = question->is_hit ? (b - quad_sqrt(rest)) / a : 0;
}

/** Computes the expected hit of a ray and a triangle. */
static void triangle_expected(AccuracyQuery *question, const Vec3d corners[3]) {
    Vec3q o = vec3q_from_floats(question->origin), d = vec3q_from_floats(question->direction),
          to[3];
    for (int i = 0; i < 3; i++) {
        to[i] = vec3q_subtract(vec3q_from_vec3d(corners[i]), o);
    }
    Quadruple u = vec3q_dot(d, vec3q_cross(to[1], to[2]));
    Quadruple v = vec3q_dot(d, vec3q_cross(to[2], to[0]));
    Quadruple w = vec3q_dot(d, vec3q_cross(to[0], to[1]));
    Vec3q normal = vec3q_cross(vec3q_subtract(to[1], to[0]), vec3q_subtract(to[2], to[0]));
    question->is_hit = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    question->is_near_edge = !question->is_hit;
    question->distance = vec3q_dot(to[0], normal) / vec3q_dot(d, normal);
}

// --- tracers -------------------------------------------------------------------------------------

/** Traces the rays with one of our engines. */
static void query_dioptre(AccuracyRun *run, const Engine *engine, const AccuracyScene *subject) {
    static RayQuery rays[BATCH];
    static int shapes[BATCH];
    static double distances[BATCH];
    Tracer *tracer = create_tracer(engine, subject->scene);
    for (size_t done = 0; done < RAYS; done += BATCH) {
        size_t count = RAYS - done < BATCH ? RAYS - done : BATCH;
        for (size_t i = 0; i < count; i++) {
            for (int axis = 0; axis < 3; axis++) {
                rays[i].origin[axis] = (double)run->questions[done + i].origin[axis];
                rays[i].direction[axis] = (double)run->questions[done + i].direction[axis];
            }
        }
        engine->closest_hits(tracer, count, rays, shapes, distances);
        for (size_t i = 0; i < count; i++) {
            run->answers[done + i] = (AccuracyAnswer){shapes[i] >= 0, distances[i]};
        }
    }
    engine->destroy(tracer);
}

/** Traces the rays with Embree. */
static void query_embree(AccuracyRun *run, const AccuracyScene *subject) {
    for (size_t i = 0; i < RAYS; i++) {
        const AccuracyQuery *question = &run->questions[i];
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
        run->answers[i] =
            (AccuracyAnswer){ray.hit.geomID != RTC_INVALID_GEOMETRY_ID, (double)ray.ray.tfar};
    }
}

/** @return The errors of the newest results. */
static AccuracyScore score_of(const AccuracyRun *run) {
    AccuracyScore score = {0};
    for (size_t i = 0; i < RAYS; i++) {
        const AccuracyQuery *question = &run->questions[i];
        const AccuracyAnswer *answer = &run->answers[i];
        score.misses += question->is_hit && !answer->is_hit;
        score.hits += !question->is_hit && answer->is_hit;
        if (question->is_hit && answer->is_hit && !question->is_near_edge) {
            Quadruple difference = quad_abs((Quadruple)answer->distance - question->distance);
            score.worst = fmax(score.worst, (double)(difference / quad_abs(question->distance)));
        }
    }
    return score;
}

/** Prints the errors of one tracer. */
static void print_score(AccuracyScore score) {
    printf(" | %7.3f %7.3f %8.1e", 100.0 * (double)score.misses / RAYS,
           100.0 * (double)score.hits / RAYS, score.worst);
}

/** Traces the rays with all tracers and prints a line. */
static void accuracy_run(AccuracyRun *run, const AccuracyScene *subject, const char *name) {
    printf("  %-24s", name);
    for (int i = 0; i < run->engine_count; i++) {
        query_dioptre(run, run->engines[i], subject);
        print_score(score_of(run));
    }
    query_embree(run, subject);
    print_score(score_of(run));
    printf("\n");
}

/** Prints the header of a table. */
static void print_header(const AccuracyRun *run, const char *title) {
    printf("\n%s\n  %-24s", title, "");
    for (int i = 0; i < run->engine_count; i++) {
        printf(" | %-24s", run->engines[i]->name);
    }
    printf(" | %-24s\n  %-24s", "Embree, robust", "");
    for (int i = 0; i <= run->engine_count; i++) {
        printf(" | %7s %7s %8s", "% miss", "% false", "t off");
    }
    printf("\n");
}

// --- scenes in both formats ----------------------------------------------------------------------

/** Creates an Embree scene of one geometry. @return The scene, to be released. */
static RTCScene embree_scene(AccuracyRun *run, RTCGeometry geometry) {
    RTCScene scene = rtcNewScene(run->device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    assert_int_equal(rtcGetDeviceError(run->device), RTC_ERROR_NONE);
    return scene;
}

/**
 * @return A sphere for all tracers, to be destroyed.
 * @param center  Its centre, exact in float.
 * @param radius  Its radius, exact in float.
 */
static AccuracyScene sphere_accuracy_scene(AccuracyRun *run, Vec3d center, double radius) {
    AccuracyScene subject = {.scene = create_empty_scene()};
    add_shape(subject.scene, "sphere", &(SphereParameters){center, radius});
    RTCGeometry geometry = rtcNewGeometry(run->device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    float *sphere = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                            4 * sizeof *sphere, 1);
    sphere[0] = (float)center.x;
    sphere[1] = (float)center.y;
    sphere[2] = (float)center.z;
    sphere[3] = (float)radius;
    subject.embree = embree_scene(run, geometry);
    return subject;
}

/**
 * @return A mesh for all tracers, to be destroyed.
 * @param soup  Its triangles; corners exact in float.
 */
static AccuracyScene triangles_accuracy_scene(AccuracyRun *run, const TriangleSoup *soup) {
    AccuracyScene subject = {.scene = create_empty_scene()};
    add_triangle_soup(subject.scene, soup, 2);
    RTCGeometry geometry = rtcNewGeometry(run->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float *corners = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             3 * sizeof *corners, soup->position_count);
    for (size_t i = 0; i < soup->position_count; i++) {
        corners[3 * i] = (float)soup->positions[i].x;
        corners[3 * i + 1] = (float)soup->positions[i].y;
        corners[3 * i + 2] = (float)soup->positions[i].z;
    }
    void *places = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                           sizeof *soup->triangles, soup->triangle_count);
    memcpy(places, soup->triangles, soup->triangle_count * sizeof *soup->triangles);
    subject.embree = embree_scene(run, geometry);
    return subject;
}

/** Destroys a test scene. */
static void accuracy_scene_destroy(AccuracyScene *subject) {
    rtcReleaseScene(subject->embree);
    scene_destroy(subject->scene);
}

/** Sets origin and direction of a ray, rounded to float. @param to Its target. */
static void aim_query(AccuracyQuery *question, Vec3d from, Vec3d to) {
    *question = (AccuracyQuery){.origin = {(float)from.x, (float)from.y, (float)from.z}};
    question->direction[0] = (float)(to.x - (double)question->origin[0]);
    question->direction[1] = (float)(to.y - (double)question->origin[1]);
    question->direction[2] = (float)(to.z - (double)question->origin[2]);
}

/** @return A random unit vector. */
static Vec3d random_unit_vector(uint64_t *state) {
    double height = 2 * random_unit_double(state) - 1, turn = 2 * M_PI * random_unit_double(state);
    double across = sqrt(1 - height * height);
    return (Vec3d){across * cos(turn), height, across * sin(turn)};
}

/** @return A vector rounded to float. */
static Vec3d vector_as_float(Vec3d v) {
    return (Vec3d){round_to_float(v.x), round_to_float(v.y), round_to_float(v.z)};
}

// --- test cases ----------------------------------------------------------------------------------

/**
 * Measures a sphere: rays from all directions that pass its centre within 1.02 radii.
 * @param center  Centre of the sphere, exact in float.
 * @param distance  Distance of the origins from the centre, radii; the radius is 1.
 */
static void measure_sphere(AccuracyRun *run, Vec3d center, double distance, const char *name) {
    for (size_t i = 0; i < RAYS; i++) {
        Vec3d out = random_unit_vector(&run->random);
        Vec3d lateral = vec3d_cross(out, random_unit_vector(&run->random));
        double by = 1.02 * sqrt(random_unit_double(&run->random));
        Vec3d eye = vec3d_add(center, vec3d_scale(out, distance));
        Vec3d aim = vec3d_add(center, vec3d_scale(vec3d_normalize(lateral), by));
        aim_query(&run->questions[i], vector_as_float(eye), aim);
        sphere_expected(&run->questions[i], center, 1);
    }
    AccuracyScene subject = sphere_accuracy_scene(run, center, 1);
    accuracy_run(run, &subject, name);
    accuracy_scene_destroy(&subject);
}

/** Measures spheres seen from far away, and spheres far from the origin. */
static void measure_spheres(AccuracyRun *run) {
    print_header(run, "A sphere of radius 1 around zero, seen from");
    measure_sphere(run, (Vec3d){0, 0, 0}, 10, "10");
    measure_sphere(run, (Vec3d){0, 0, 0}, 1e3, "1e3");
    measure_sphere(run, (Vec3d){0, 0, 0}, 1e4, "1e4");
    measure_sphere(run, (Vec3d){0, 0, 0}, 1e5, "1e5");
    measure_sphere(run, (Vec3d){0, 0, 0}, 1e6, "1e6");
    print_header(run, "A sphere of radius 1 seen from 5, its centre along each axis at");
    measure_sphere(run, (Vec3d){1e2, 1e2, 1e2}, 5, "1e2");
    measure_sphere(run, (Vec3d){1e4, 1e4, 1e4}, 5, "1e4");
    measure_sphere(run, (Vec3d){1e6, 1e6, 1e6}, 5, "1e6");
}

/**
 * Measures a sliver: grazing rays from a distance of 3, to points on it and just outside.
 * @param aspect  Ratio of its length to its height.
 * @param degrees  Angle between the rays and its plane.
 */
static void measure_sliver(AccuracyRun *run, double aspect, double degrees) {
    char name[64];
    double angle = degrees * M_PI / 180;
    TriangleSoup sliver = triangle_soup_create(1);
    const Vec3d corners[3] = {vector_as_float((Vec3d){-0.51, 0.13, 0.07}),
                              vector_as_float((Vec3d){0.49, 0.21, 0.11}),
                              vector_as_float((Vec3d){0.02, 0.15 + 1 / aspect, 0.1})};
    memcpy(sliver.positions, corners, sizeof corners);
    Vec3d along = vec3d_normalize(vec3d_subtract(corners[1], corners[0]));
    Vec3d side = vec3d_subtract(corners[2], corners[0]);
    Vec3d normal = vec3d_normalize(vec3d_cross(along, side));
    Vec3d out = vec3d_add(vec3d_scale(along, cos(angle)), vec3d_scale(normal, sin(angle)));
    for (size_t i = 0; i < RAYS; i++) {
        double u = random_unit_double(&run->random),
               v = 1.1 * random_unit_double(&run->random) - 0.05;
        Vec3d base = vec3d_scale(vec3d_subtract(corners[1], corners[0]), u * (1 - v));
        Vec3d aim = vec3d_add(vec3d_add(corners[0], base), vec3d_scale(side, v));
        aim_query(&run->questions[i], vector_as_float(vec3d_add(aim, vec3d_scale(out, 3))), aim);
        triangle_expected(&run->questions[i], corners);
    }
    AccuracyScene subject = triangles_accuracy_scene(run, &sliver);
    snprintf(name, sizeof name, "1 : %g, %g degrees", aspect, degrees);
    accuracy_run(run, &subject, name);
    accuracy_scene_destroy(&subject);
    triangle_soup_destroy(&sliver);
}

/** Measures slivers. */
static void measure_slivers(AccuracyRun *run) {
    print_header(run, "A triangle of edge 1, its height, and the rays' angle to it");
    measure_sliver(run, 1, 30);
    measure_sliver(run, 1, 0.1);
    measure_sliver(run, 1e3, 30);
    measure_sliver(run, 1e3, 0.1);
    measure_sliver(run, 1e5, 30);
    measure_sliver(run, 1e5, 0.1);
}

/**
 * Measures a closed mesh: rays from inside, which all hit it.
 * @param at_corner Whether rays go to vertices instead of edges.
 */
static void measure_mesh(AccuracyRun *run, const TriangleSoup *mesh, bool at_corner,
                         const char *name) {
    for (size_t i = 0; i < RAYS; i++) {
        uint64_t *state = &run->random;
        size_t face = (size_t)((double)mesh->triangle_count * random_unit_double(state));
        size_t from = (size_t)(3 * random_unit_double(state));
        Vec3d corner = triangle_soup_vertex(mesh, face, from);
        Vec3d edge = vec3d_subtract(triangle_soup_vertex(mesh, face, (from + 1) % 3), corner);
        Vec3d eye = {random_float(state, -1, 1), random_float(state, -1, 1),
                     random_float(state, -1, 1)};
        double fraction = at_corner ? 0 : random_unit_double(state);
        AccuracyQuery *question = &run->questions[i];
        aim_query(question, eye, vec3d_add(corner, vec3d_scale(edge, fraction)));
        // The distance is not compared: rounding decides which triangle is hit.
        question->is_hit = question->is_near_edge = true;
    }
    AccuracyScene subject = triangles_accuracy_scene(run, mesh);
    accuracy_run(run, &subject, name);
    accuracy_scene_destroy(&subject);
}

/** Measures closed meshes. */
static void measure_meshes(AccuracyRun *run) {
    TriangleSoup mesh = icosphere_triangles(3);
    print_header(run, "Inside a closed mesh of 1280 triangles, at its");
    measure_mesh(run, &mesh, false, "edges");
    measure_mesh(run, &mesh, true, "corners");
    triangle_soup_destroy(&mesh);
}

/** Runs all cases. @return 0 */
int main(int argc, char **argv) {
    AccuracyRun run = {.device = rtcNewDevice("threads=1"), .random = 20261121};
    run.questions = calloc(RAYS, sizeof *run.questions);
    run.answers = calloc(RAYS, sizeof *run.answers);
    for (int i = 1; i < argc && run.engine_count < ENGINES_MAXIMUM; i++) {
        Error error = {0};
        run.engines[run.engine_count] = engine_find(argv[i], &error);
        if (!run.engines[run.engine_count++]) {
            fprintf(stderr, "peer-accuracy: %s\n", error.message);
            return EXIT_FAILURE;
        }
    }
    measure_spheres(&run);
    measure_slivers(&run);
    measure_meshes(&run);
    rtcReleaseDevice(run.device);
    free(run.questions);
    free(run.answers);
    return EXIT_SUCCESS;
}
