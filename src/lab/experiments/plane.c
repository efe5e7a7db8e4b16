/**
 * @file
 * @brief Experiments on planes: grazing rays, and a point of the plane that lies far away.
 */
#include "base/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/sample_writer.h"

#include <math.h>

/** A plane under an eye. */
typedef struct TestPlane {
    Vec3q point;    /**< A point of it, exact in float. */
    Vec3q normal;   /**< Its normal, exact in float, of about length 1. */
    double degrees; /**< Under what angle rays meet it, degrees. */
} TestPlane;

/**
 * @return A plane through about the origin of the world.
 * @param distance  How far its point lies.
 */
static TestPlane test_plane_at(double distance, double degree) {
    const NumberType *narrowest = number_types()[0];
    Vec3q normal = vec3q_normalize((Vec3q){0.31, 0.88, -0.36});
    Vec3q along = vec3q_normalize(vec3q_cross(normal, (Vec3q){0.2, 0.5, 0.84}));
    return (TestPlane){vec3q_round(narrowest, vec3q_scale(along, distance)),
                       vec3q_round(narrowest, normal), degree};
}

/** Poses an eye one unit above the plane. @param[in,out] random Where it comes from. */
static void generate_plane_ray(const ExperimentSetup *setup, const TestPlane *ground,
                               Random *random, ExperimentSample *sample) {
    SampleWriter writer = {setup->type, sample->inputs};
    Vec3q n = ground->normal, unit = vec3q_normalize(n);
    Quadruple offset = vec3q_dot(n, ground->point);
    Vec3q base = vec3q_scale(n, offset / vec3q_dot(n, n));
    Vec3q lateral = random_in_disc(random, unit, 1);
    Vec3q along = vec3q_normalize(random_in_disc(random, unit, 1));
    double angle = ground->degrees * random_range(random, 0.95, 1.05) * M_PI / 180;
    Vec3q origin = sample_writer_vec3(&writer, vec3q_add(vec3q_add(base, unit), lateral));
    Vec3q direction = sample_writer_vec3(
        &writer, vec3q_subtract(vec3q_scale(along, cos(angle)), vec3q_scale(unit, sin(angle))));
    sample_writer_vec3(&writer, ground->point);
    sample_writer_vec3(&writer, n);
    sample_writer_number(&writer, offset);
    sample->expected[0] = (offset - vec3q_dot(n, origin)) / vec3q_dot(n, direction);
}

/** @return The scene of a plane. */
static Scene *plane_scene(const TestPlane *ground, Error *error) {
    FixtureValue values[] = {{.name = "point"}, {.name = "normal"}, {0}};
    vec3q_to_doubles(ground->point, values[0].components);
    vec3q_to_doubles(ground->normal, values[1].components);
    return scene_fixture_with_shape("plane", values, error);
}

/* --- grazing rays --- */

/** Degrees. */
static const double angles[] = {30, 10, 3, 1, 0.3, 0.1, 0.03, 0.01};

/** Poses grazing rays. See #Experiment.generate. @param[in,out] random Where it comes from. */
static void generate_angle(const ExperimentSetup *setup, Random *random, ExperimentSample *sample) {
    TestPlane ground = test_plane_at(1, setup->level);
    generate_plane_ray(setup, &ground, random, sample);
}

/** @return Its scene. See #Experiment.create_scene. */
static Scene *scene_angle(const ExperimentSetup *setup, Error *error) {
    TestPlane ground = test_plane_at(1, setup->level);
    return plane_scene(&ground, error);
}

const Experiment plane_angle_experiment = {
    .name = "plane-angle",
    .title = N_("A plane one unit below the eye, met under ever smaller angles"),
    .family = "plane",
    .difficulty = N_("angle between ray and plane, degrees"),
    .error_label = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = angles,
    .level_count = COUNT_OF(angles),
    .sample_count = 20000,
    .queries_per_sample = 1,
    .generate = generate_angle,
    .score_sample = score_expected_distance,
    .create_scene = scene_angle,
};

/* --- a point far away --- */

/** Heights of the eye. */
static const double distances[] = {1, 10, 1e2, 1e3, 1e4, 1e5, 1e6};
/** Under what angle rays meet the plane, degrees. */
#define STEEP_DEGREES 30

/** Poses a plane whose point lies far away. See #Experiment.generate. @param[in,out] random Where
 *  it comes from. */
static void generate_point(const ExperimentSetup *setup, Random *random, ExperimentSample *sample) {
    TestPlane ground = test_plane_at(setup->level, STEEP_DEGREES);
    generate_plane_ray(setup, &ground, random, sample);
}

/** @return Its scene. See #Experiment.create_scene. */
static Scene *scene_point(const ExperimentSetup *setup, Error *error) {
    TestPlane ground = test_plane_at(setup->level, STEEP_DEGREES);
    return plane_scene(&ground, error);
}

const Experiment plane_point_experiment = {
    .name = "plane-point",
    .title = N_("A plane one unit below the eye, given by a point far away"),
    .family = "plane",
    .difficulty = N_("distance of the point / height of the eye"),
    .error_label = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = distances,
    .level_count = COUNT_OF(distances),
    .sample_count = 20000,
    .queries_per_sample = 1,
    .timed_level = 1e3,
    .generate = generate_point,
    .score_sample = score_expected_distance,
    .create_scene = scene_point,
};
