/**
 * @file
 * @brief Experiments on spheres: far from the viewpoint, far from the origin, small, large,
 * underfoot.
 */
#include "base/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/sample_writer.h"

/** A sphere in view. */
typedef struct SphereView {
    Vec3q center;     /**< Its centre. */
    Quadruple radius; /**< Its radius. */
    double distance;  /**< From its centre to the viewpoint, radii. */
} SphereView;

/** Radii around the centre that rays aim at: a few pass beside the sphere. */
#define AIM_RADIUS 1.02

/** Writes the inputs. @param ray Origin and direction. */
static void sphere_write_input(const NumberType *type, const Vec3q ray[2], const SphereView *view,
                               ExperimentSample *sample) {
    SampleWriter writer = {type, sample->inputs};
    Vec3q origin = sample_writer_vec3(&writer, ray[0]);
    Vec3q direction = sample_writer_vec3(&writer, ray[1]);
    Vec3q center = sample_writer_vec3(&writer, view->center);
    Quadruple radius = sample_writer_number(&writer, view->radius);
    sample->expected[0] = sphere_expected(origin, direction, center, radius);
}

/** Generates a ray from around a sphere to a disc around its centre. */
static void generate_view(const NumberType *type, const SphereView *view, Random *random,
                          ExperimentSample *sample) {
    Vec3q outwards = random_direction(random);
    Vec3q origin = vec3q_add(view->center, vec3q_scale(outwards, view->distance * view->radius));
    origin = vec3q_round(type, origin);
    Vec3q aim = random_in_disc(random, outwards, AIM_RADIUS);
    Vec3q target = vec3q_add(view->center, vec3q_scale(aim, view->radius));
    Vec3q direction = vec3q_normalize(vec3q_subtract(target, origin));
    sphere_write_input(type, (const Vec3q[]){origin, direction}, view, sample);
}

/* --- far from the viewpoint
 * ---------------------------------------------------------------------------
 */

/** Radii. */
static const double distances[] = {1.01, 2, 10, 1e2, 1e3, 1e4, 1e5, 1e6};

/** Generates a sphere far away, see #Experiment.generate. */
static void generate_distance(const ExperimentSetup *setup, Random *random,
                              ExperimentSample *sample) {
    SphereView view = {.radius = 1, .distance = setup->level};
    generate_view(setup->type, &view, random, sample);
}

/** Is an #Experiment.create_scene. */
static Scene *scene_distance(const ExperimentSetup *setup, Error *error) {
    (void)setup;
    return sphere_scene((Vec3q){0, 0, 0}, 1, error);
}

const Experiment sphere_distance_experiment = {
    .name = "sphere-distance",
    .title = N_("A sphere, seen from far away"),
    .family = "sphere",
    .difficulty = N_("distance / radius"),
    .error_label = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = distances,
    .level_count = COUNT_OF(distances),
    .sample_count = 50000,
    .queries_per_sample = 1,
    .timed_level = 1e2,
    .generate = generate_distance,
    .score_sample = score_expected_distance,
    .create_scene = scene_distance,
};

/* --- far from the origin of the world ------------------------------------------------------------
 */

/** Radii. */
static const double origin_distances[] = {1, 10, 1e2, 1e3, 1e4, 1e5, 1e6};

/** Generates a sphere, ten radii away, far from the origin, see #Experiment.generate. */
static void generate_offset(const ExperimentSetup *setup, Random *random,
                            ExperimentSample *sample) {
    SphereView view = {.center = far_point(setup->level), .radius = 1, .distance = 10};
    generate_view(setup->type, &view, random, sample);
}

const Experiment sphere_offset_experiment = {
    .name = "sphere-world",
    .title = N_("A sphere and an eye ten radii away, both far from the origin of the world"),
    .family = "sphere",
    .difficulty = N_("distance from the origin / radius"),
    .error_label = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = origin_distances,
    .level_count = COUNT_OF(origin_distances),
    .sample_count = 20000,
    .queries_per_sample = 1,
    .generate = generate_offset,
    .score_sample = score_expected_distance,
    .create_scene = create_far_sphere_scene,
};

/* --- small and large -----------------------------------------------------------------------------
 */

/** Scene units; as powers of two the figures would be the same to the bit. */
static const double sphere_radii[] = {1e-6, 1e-4, 1e-2, 1, 1e2, 1e4, 1e6};

/** Generates a sphere, ten radii away, see #Experiment.generate. */
static void generate_scale(const ExperimentSetup *setup, Random *random, ExperimentSample *sample) {
    SphereView view = {.radius = number_types()[0]->round(setup->level), .distance = 10};
    generate_view(setup->type, &view, random, sample);
}

/** Is an #Experiment.create_scene. */
static Scene *scene_scale(const ExperimentSetup *setup, Error *error) {
    return sphere_scene((Vec3q){0, 0, 0}, (double)number_types()[0]->round(setup->level), error);
}

const Experiment sphere_scale_experiment = {
    .name = "sphere-scale",
    .title = N_("A sphere, small and large, ten radii away"),
    .family = "sphere",
    .difficulty = N_("radius, scene units"),
    .error_label = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = sphere_radii,
    .level_count = COUNT_OF(sphere_radii),
    .sample_count = 20000,
    .queries_per_sample = 1,
    .generate = generate_scale,
    .score_sample = score_expected_distance,
    .create_scene = scene_scale,
};

/* --- underfoot
 * ------------------------------------------------------------------------------------ */

/** Radii, in heights of the viewpoint. */
static const double ground_radii[] = {1e1, 1e2, 1e3, 1e4, 1e5, 1e6};

/** @return The centre of the ground, directly below the viewpoint; not on an axis. */
static Vec3q ground_center(double radius) {
    return far_point(radius);
}

/** Generates a viewpoint one unit above a large sphere, looking down at 5 to 90 degrees, see
 * #Experiment.generate. */
static void generate_ground(const ExperimentSetup *setup, Random *random,
                            ExperimentSample *sample) {
    SphereView view = {.center = ground_center(setup->level), .radius = setup->level};
    // Somewhere on the ground, so that no single rounding of the viewpoint decides all samples.
    Vec3q walk = random_in_disc(random, (Vec3q){0, 1, 0}, 10);
    Vec3q up = vec3q_normalize(vec3q_subtract(walk, view.center));
    Vec3q origin = vec3q_add(view.center, vec3q_scale(up, setup->level + 1));
    Vec3q along = vec3q_normalize(random_in_disc(random, up, 1));
    double down = random_range(random, 0.087, 1); // The sine of 5 degrees, to 1.
    Vec3q direction = vec3q_subtract(vec3q_scale(along, quad_sqrt(1 - (Quadruple)down * down)),
                                     vec3q_scale(up, down));
    sphere_write_input(setup->type, (const Vec3q[]){origin, direction}, &view, sample);
}

/** Is an #Experiment.create_scene. */
static Scene *scene_ground(const ExperimentSetup *setup, Error *error) {
    return sphere_scene(ground_center(setup->level), setup->level, error);
}

const Experiment sphere_ground_experiment = {
    .name = "sphere-ground",
    .title = N_("A sphere as the ground, the eye one unit above it"),
    .family = "sphere",
    .difficulty = N_("radius / height of the eye"),
    .error_label = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = ground_radii,
    .level_count = COUNT_OF(ground_radii),
    .sample_count = 20000,
    .queries_per_sample = 1,
    .timed_level = 1e5,
    .generate = generate_ground,
    .score_sample = score_expected_distance,
    .create_scene = scene_ground,
};
