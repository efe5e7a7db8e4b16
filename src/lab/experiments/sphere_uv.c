/**
 * @file
 * @brief An experiment on pictures on spheres: how far from the pole is a point?
 */
#include "base/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/sample_writer.h"

#include <math.h>

/** Radians from the pole. */
static const double angles[] = {1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7};

/** @return The centre of the sphere: so that points of it are rounded. */
static Vec3q sphere_center(void) {
    return far_point(2);
}

/** @return Where a ray meets the sphere, rounded as a tracer rounds it: P = o + t d. */
static Vec3q rounded_hit_point(const NumberType *type, Vec3q o, Vec3q d) {
    Quadruple t = type->round(sphere_expected(o, d, sphere_center(), 1));
    Vec3q displacement = vec3q_round(type, vec3q_scale(d, t));
    return vec3q_round(type, vec3q_add(o, displacement));
}

/** Poses a point near the pole, met from ten radii above. See #Experiment.generate. @param[in,out]
 *  random Where it comes from. */
static void generate_pole_hit(const ExperimentSetup *setup, Random *random,
                              ExperimentSample *sample) {
    const NumberType *type = setup->type;
    SampleWriter writer = {type, sample->inputs};
    double angle = setup->level * random_range(random, 0.5, 1);
    Vec3q up = {0, 1, 0}, along = vec3q_normalize(random_in_disc(random, up, 1));
    Vec3q radial = vec3q_add(vec3q_scale(up, cos(angle)), vec3q_scale(along, sin(angle)));
    Vec3q target = vec3q_add(sphere_center(), vec3q_normalize(radial));
    Vec3q lateral = random_in_disc(random, up, 5);
    Vec3q eye = vec3q_add(target, vec3q_add(vec3q_scale(radial, 10), lateral));
    Vec3q o = vec3q_round(type, eye);
    Vec3q d = vec3q_round(type, vec3q_normalize(vec3q_subtract(target, o)));
    Vec3q point = sample_writer_vec3(&writer, rounded_hit_point(type, o, d));
    Vec3q center = sample_writer_vec3(&writer, sphere_center());
    sample_writer_number(&writer, 1);
    Vec3q n = vec3q_subtract(point, center);
    sample->expected[0] = quad_atan2(quad_sqrt(n.x * n.x + n.z * n.z), n.y);
}

/** Judges an angle. See #Experiment.score_sample. */
static void score_polar_angle(const ExperimentSample *sample, const Quadruple *outputs,
                              ScoreStats *score) {
    bool is_number = quad_is_number(outputs[0]);
    score_outcome(score, OUTCOME_NAN, !is_number);
    if (is_number) {
        score_error(score, quad_abs(outputs[0] - sample->expected[0]));
    }
}

/** @return The sphere. See #Experiment.create_scene. */
static Scene *pole_scene(const ExperimentSetup *setup, Error *error) {
    (void)setup;
    return sphere_scene(sphere_center(), 1, error);
}

/** Asks an engine with a ray straight down onto the point. See #Experiment.query_engine. */
static void query_polar_angle(const Engine *engine, Tracer *tracer, const ExperimentSample *sample,
                              Quadruple *outputs) {
    Vec3q point = vec3q_from_array(sample->inputs), center = vec3q_from_array(sample->inputs + 3);
    Vec3q radial = vec3q_subtract(point, center);
    RayResult hit;
    intersect_ray(engine, tracer,
                  (const Vec3q[]){vec3q_add(point, radial), vec3q_scale(radial, -1)}, &hit);
    outputs[0] = (1 - hit.uv[1]) * (Quadruple)M_PI;
}

const Experiment sphere_pole_experiment = {
    .name = "sphere-pole",
    .title = N_("Latitude on a sphere, near its pole"),
    .family = "latitude",
    .difficulty = N_("angle from the pole, radians"),
    .error_label = N_("error of the angle, radians"),
    .levels = angles,
    .level_count = COUNT_OF(angles),
    .sample_count = 20000,
    .queries_per_sample = 1,
    .timed_level = 1e-3,
    .generate = generate_pole_hit,
    .score_sample = score_polar_angle,
    .create_scene = pole_scene,
    .query_engine = query_polar_angle,
};
