/**
 * @file
 * @brief An experiment on the normals of distance fields: which step is best for differences?
 */
#include "base/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/sample_writer.h"

/** Steps, in radii of the sphere. */
static const double step_lengths[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10};

/** Generates a point of a sphere, see #Experiment.generate. */
static void generate_normal(const ExperimentSetup *setup, Random *random,
                            ExperimentSample *sample) {
    SampleWriter writer = {setup->type, sample->inputs};
    Vec3q point = sample_writer_vec3(&writer, random_direction(random));
    sample_writer_vec3(&writer, (Vec3q){0, 0, 0});
    sample_writer_number(&writer, 1);
    sample_writer_number(&writer, setup->level);
    Vec3q normal = vec3q_normalize(point);
    sample->expected[0] = normal.x;
    sample->expected[1] = normal.y;
    sample->expected[2] = normal.z;
}

/**
 * Scores a direction: the sine of the angle to the exact one, or 2 minus it beyond a right angle.
 * See #Experiment.score_sample.
 */
static void score_normal(const ExperimentSample *sample, const Quadruple *outputs,
                         ScoreStats *score) {
    Vec3q truth = vec3q_from_array(sample->expected), found = vec3q_from_array(outputs);
    bool is_number = quad_is_number(found.x);
    score_outcome(score, OUTCOME_NAN, !is_number);
    if (is_number) {
        Vec3q across = vec3q_cross(truth, vec3q_normalize(found));
        Quadruple sine = vec3q_length(across);
        score_error(score, vec3q_dot(truth, found) > 0 ? sine : 2 - sine);
    }
}

/** @return The sphere as a distance field, see #Experiment.create_scene. */
static Scene *normal_scene(const ExperimentSetup *setup, Error *error) {
    const FixtureValue values[] = {{"radius", {1}}, {0}};
    (void)setup;
    return scene_fixture_with_sdf("distance.sphere", values, (Vec3d){0, 0, 0}, error);
}

/** Queries an engine for the normal where a perpendicular ray hits the sphere at the
 * point, see #Experiment.query_engine. */
static void query_normal(const Engine *engine, Tracer *tracer, const ExperimentSample *sample,
                         Quadruple *outputs) {
    RayResult answer;
    Vec3q point = vec3q_from_array(sample->inputs);
    // Four times as far is exact.
    const Vec3q ray[2] = {vec3q_scale(point, 4), vec3q_scale(point, -1)};
    intersect_ray(engine, tracer, ray, &answer);
    for (int i = 0; i < 3; i++) {
        outputs[i] = answer.shape < 0 ? (Quadruple)__builtin_nan("") : answer.normal[i];
    }
}

const Experiment sdf_normal_experiment = {
    .name = "field-normal",
    .title = N_("Normals of a ball's distance field, by differences over a length"),
    .family = "gradient",
    .difficulty = N_("length of the difference / radius"),
    .error_label = N_("error of the angle, radians"),
    .levels = step_lengths,
    .level_count = COUNT_OF(step_lengths),
    .sample_count = 5000,
    .queries_per_sample = 1,
    .timed_level = TIMED_LEVEL_BEST,
    .generate = generate_normal,
    .score_sample = score_normal,
    .create_scene = normal_scene,
    .query_engine = query_normal,
};
