/**
 * @file
 * @brief An experiment on reflections: the error of a direction after many of them.
 */
#include "base/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/sample_writer.h"

#include <math.h>
#include <string.h>

/** Numbers of reflections. */
static const double bounce_counts[] = {1, 2, 3, 4, 5, 6, 8, 10, 12};

/** Centres of the spheres: the corners of a tetrahedron. */
static const Vec3q sphere_centers[4] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
/** @return Radius of the spheres, exact in float: they nearly touch, so that rays stay between
 * them.
 */
static Quadruple sphere_radius(void) {
    return number_types()[0]->round(1.3);
}

/**
 * Generates a ray between the spheres, see #Experiment.generate. The reference is the result of the
 * first method in quad, for the direction scaled to length 1: the methods take that for granted,
 * and a direction in float is 6e-8 too long or too short. Its error is negligible then
 * (tests/test_arb.c).
 */
static void generate_bounces(const ExperimentSetup *setup, Random *random,
                             ExperimentSample *sample) {
    SampleWriter writer = {setup->type, sample->inputs};
    sample_writer_vec3(&writer, vec3q_scale(random_direction(random), 0.1));
    Vec3q direction = sample_writer_vec3(&writer, random_direction(random));
    for (int i = 0; i < 4; i++) {
        sample_writer_vec3(&writer, sphere_centers[i]);
    }
    sample_writer_number(&writer, sphere_radius());
    sample_writer_number(&writer, setup->level);
    const NumberType *const *widest = number_types();
    while (widest[1]) {
        widest++;
    }
    const MethodFamily *family = number_type_family(*widest, "bounces");
    Quadruple exact[METHOD_NUMBERS_MAXIMUM];
    memcpy(exact, sample->inputs, sizeof exact);
    writer = (SampleWriter){*widest, exact + 3};
    sample_writer_vec3(&writer, vec3q_normalize(direction));
    (*widest)->evaluate(family, family->methods, 1, exact, sample->expected);
}

/** Scores a direction, see #Experiment.score_sample. */
static void score_direction(const ExperimentSample *sample, const Quadruple *outputs,
                            ScoreStats *score) {
    Vec3q truth = vec3q_from_array(sample->expected), found = vec3q_from_array(outputs);
    // Rays that leave the spheres are not scored.
    if (quad_is_number(truth.x) && quad_is_number(found.x)) {
        Vec3q difference = vec3q_subtract(vec3q_normalize(found), vec3q_normalize(truth));
        score_error(score, vec3q_length(difference));
    }
}

/** @return The four spheres, see #Experiment.create_scene. */
static Scene *scene_bounces(const ExperimentSetup *setup, Error *error) {
    (void)setup;
    Scene *scene = sphere_scene(sphere_centers[0], (double)sphere_radius(), error);
    for (int i = 1; i < 4 && scene; i++) {
        FixtureValue values[] = {{.name = "center"}, {"radius", {(double)sphere_radius()}}, {0}};
        vec3q_to_doubles(sphere_centers[i], values[0].components);
        if (!scene_fixture_add_shape(scene, "sphere", values, error)) {
            scene_destroy(scene);
            scene = NULL;
        }
    }
    return scene;
}

/** Queries an engine for one hit after the other, see #Experiment.query_engine. The reflection is
 *  computed in quad, and rounded with the next ray. */
static void query_bounces(const Engine *engine, Tracer *tracer, const ExperimentSample *sample,
                          Quadruple *outputs) {
    Vec3q ray[2] = {vec3q_from_array(sample->inputs), vec3q_from_array(sample->inputs + 3)};
    for (int i = 0; i < (int)sample->inputs[19]; i++) {
        RayResult hit;
        intersect_ray(engine, tracer, ray, &hit);
        if (hit.shape < 0) {
            ray[1].x = (Quadruple)NAN;
            break;
        }
        Vec3q normal = vec3q_from_array(hit.normal);
        ray[0] = vec3q_add(vec3q_from_array(hit.point), vec3q_scale(normal, hit.error));
        ray[1] = vec3q_add(ray[1], vec3q_scale(normal, -2 * vec3q_dot(ray[1], normal)));
    }
    outputs[0] = ray[1].x;
    outputs[1] = ray[1].y;
    outputs[2] = ray[1].z;
}

const Experiment mirror_bounces_experiment = {
    .name = "mirror-bounces",
    .title = N_("A ray between four mirroring balls: its direction after many mirrorings"),
    .family = "bounces",
    .difficulty = N_("mirrorings"),
    .error_label = N_("error of the direction, radians"),
    .levels = bounce_counts,
    .level_count = COUNT_OF(bounce_counts),
    .sample_count = 4000,
    .queries_per_sample = 1,
    .timed_level = 5,
    .generate = generate_bounces,
    .score_sample = score_direction,
    .create_scene = scene_bounces,
    .query_engine = query_bounces,
};
