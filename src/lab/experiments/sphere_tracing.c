/**
 * @file
 * @brief An experiment on sphere tracing: steps down to the ground, and the error of the distance.
 */
#include "base/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/sample_writer.h"

#include <math.h>

/** Degrees. */
static const double angles[] = {30, 10, 3, 1, 0.3, 0.1};
/** Tolerance of the surface, heights of the viewpoint. */
#define TOLERANCE 1e-4

/** Generates a viewpoint one unit above the ground, see #Experiment.generate. */
static void generate_grazing(const ExperimentSetup *setup, Random *random,
                             ExperimentSample *sample) {
    SampleWriter writer = {setup->type, sample->inputs};
    double angle = setup->level * random_range(random, 0.99, 1.01) * M_PI / 180;
    Vec3q origin = sample_writer_vec3(&writer, (Vec3q){0, random_range(random, 0.99, 1.01), 0});
    Vec3q direction = sample_writer_vec3(&writer, (Vec3q){cos(angle), -sin(angle), 0});
    sample_writer_number(&writer, TOLERANCE);
    sample->expected[0] = origin.y / -direction.y;
}

/** Scores where and after how many steps a ray stopped, see #Experiment.score_sample. */
static void score_grazing(const ExperimentSample *sample, const Quadruple *outputs,
                          ScoreStats *score) {
    score_outcome(score, OUTCOME_FALSE_MISS, !(outputs[0] < QUAD_NO_HIT));
    if (outputs[0] < QUAD_NO_HIT) {
        score_error(score, quad_abs(outputs[0] - sample->expected[0]));
        if (quad_is_number(outputs[1])) {
            score_cost(score, outputs[1]);
        }
    }
}

/**
 * @return The ground: a box larger than the reach of any ray, but hardly, because its rounding
 *        errors grow with its size. See #Experiment.create_scene.
 */
static Scene *floor_scene(const ExperimentSetup *setup, Error *error) {
    double half_length = 1.1 / tan(setup->level * M_PI / 180);
    const FixtureValue values[] = {{"size", {2 * half_length, 2, 2}}, {0}};
    return scene_fixture_with_sdf("distance.box", values, (Vec3d){0, -1, 0}, error);
}

/** Queries an engine for the distance, without the steps. See #Experiment.query_engine. */
static void query_grazing(const Engine *engine, Tracer *tracer, const ExperimentSample *sample,
                          Quadruple *outputs) {
    RayResult answer;
    const Vec3q ray[2] = {vec3q_from_array(sample->inputs), vec3q_from_array(sample->inputs + 3)};
    intersect_ray(engine, tracer, ray, &answer);
    outputs[0] = answer.shape < 0 ? QUAD_NO_HIT : answer.distance;
    outputs[1] = (Quadruple)__builtin_nan("");
}

const Experiment sphere_tracing_angle_experiment = {
    .name = "marching-angle",
    .title = N_("Marching down to the ground under ever smaller angles"),
    .family = "marching",
    .difficulty = N_("angle between ray and ground, degrees"),
    .error_label = N_("error of the distance t, heights of the viewpoint"),
    .cost_label = N_("steps of a ray"),
    .levels = angles,
    .level_count = COUNT_OF(angles),
    .sample_count = 400,
    .queries_per_sample = 1,
    .timed_level = 1,
    .generate = generate_grazing,
    .score_sample = score_grazing,
    .create_scene = floor_scene,
    .query_engine = query_grazing,
};
