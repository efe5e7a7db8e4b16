/**
 * @file
 * @brief Experiments on rays that leave a surface: wrong offsets cause acne on mirrors and wrong
 *        exits from glass; what is thin is lost.
 */
#include "base/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/sample_writer.h"

/** Index of air over that of glass, for a ray that enters glass. */
#define IOR_RATIO (1 / 1.5)
/** Tolerance of a distance through the glass, relative. */
#define DISTANCE_TOLERANCE 0.01

/** A sphere that rays meet and leave. */
typedef struct OffsetSphere {
    Vec3q center;     /**< Its centre, exact in float. */
    Quadruple radius; /**< Its radius, exact in float. */
    double ior_ratio; /**< For refraction: #IOR_RATIO; 0: the ray is reflected. */
} OffsetSphere;

/** @return How far it is through the glass. @param point Where a ray meets the sphere, from its
 *  centre, over the radius. @param direction Of length 1. */
static Quadruple chord_length(Vec3q point, Vec3q direction) {
    // Snell's law; the distance is a chord of the sphere.
    Quadruple cosine = -vec3q_dot(point, direction);
    return 2 * quad_sqrt(1 - (Quadruple)IOR_RATIO * IOR_RATIO * (1 - cosine * cosine));
}

/** Generates a ray to a sphere from three radii away. */
static void generate_offset_ray(const ExperimentSetup *setup, const OffsetSphere *sphere,
                                Random *random, ExperimentSample *sample) {
    SampleWriter writer = {setup->type, sample->inputs};
    Vec3q outwards = random_direction(random);
    Vec3q position = vec3q_add(sphere->center, vec3q_scale(outwards, 3 * sphere->radius));
    Vec3q origin = sample_writer_vec3(&writer, position);
    Vec3q lateral = random_in_disc(random, outwards, 0.95);
    Vec3q target = vec3q_add(sphere->center, vec3q_scale(lateral, sphere->radius));
    Vec3q direction = sample_writer_vec3(&writer, vec3q_normalize(vec3q_subtract(target, origin)));
    sample_writer_vec3(&writer, sphere->center);
    sample_writer_number(&writer, sphere->radius);
    sample_writer_number(&writer, sphere->ior_ratio);
    Quadruple t = sphere_expected(origin, direction, sphere->center, sphere->radius);
    Vec3q point = vec3q_add(origin, vec3q_scale(direction, t));
    Vec3q radial = vec3q_scale(vec3q_subtract(point, sphere->center), 1 / sphere->radius);
    sample->expected[0] = sphere->radius;
    sample->expected[1] = sphere->radius * chord_length(radial, vec3q_normalize(direction));
}

/**
 * Judges a second ray.
 * @param is_wrong  Whether it met what it should not.
 * @param shift  How far it was moved.
 */
static void score_second_hit(const ExperimentSample *sample, bool is_wrong, Quadruple shift,
                             ScoreStats *score) {
    score_outcome(score, OUTCOME_WRONG, is_wrong);
    score_error(score, shift / sample->expected[0]);
}

/** Scores a reflected ray, which hits nothing. See #Experiment.score_sample. */
static void score_reflected(const ExperimentSample *sample, const Quadruple *outputs,
                            ScoreStats *score) {
    score_second_hit(sample, outputs[0] < QUAD_NO_HIT, outputs[1], score);
}

/** Scores a refracted ray, which hits the opposite side. See #Experiment.score_sample. */
static void score_refracted(const ExperimentSample *sample, const Quadruple *outputs,
                            ScoreStats *score) {
    Quadruple difference = quad_abs(outputs[0] - sample->expected[1]);
    score_second_hit(sample, !(difference < DISTANCE_TOLERANCE * sample->expected[1]), outputs[1],
                     score);
}

/** @return A ray's direction after a surface, of length 1. */
static Vec3q redirected(Vec3q d, Vec3q n, Quadruple ratio) {
    Quadruple cosine = -vec3q_dot(d, n);
    if (ratio == 0) {
        return vec3q_normalize(vec3q_add(d, vec3q_scale(n, 2 * cosine)));
    }
    Quadruple k = 1 - ratio * ratio * (1 - cosine * cosine);
    Vec3q outgoing = vec3q_scale(n, ratio * cosine - quad_sqrt(k));
    return vec3q_normalize(vec3q_add(vec3q_scale(d, ratio), outgoing));
}

/**
 * @return Where the tracer starts a second ray (src/trace/tracer/ray_offset.h).
 * @param d  Which way the second ray goes.
 */
static Vec3q tracer_ray_origin(const RayResult *hit, Vec3q d) {
    Vec3q point = vec3q_from_array(hit->point), n = vec3q_from_array(hit->normal);
    Quadruple cosine = vec3q_dot(d, n), transmit_offset = 2 * hit->error;
    if (cosine > 0) {
        return vec3q_add(point, vec3q_scale(n, hit->error));
    }
    const Quadruple least = 0.0625;
    return vec3q_add(point, vec3q_scale(d, transmit_offset / (-cosine > least ? -cosine : least)));
}

/** Queries an engine for both rays, see #Experiment.query_engine. */
static void query_second_ray(const Engine *engine, Tracer *tracer, const ExperimentSample *sample,
                             Quadruple *outputs) {
    const Quadruple *q = sample->inputs;
    const Vec3q first[2] = {vec3q_from_array(q), vec3q_from_array(q + 3)};
    RayResult hit, again;
    intersect_ray(engine, tracer, first, &hit);
    Vec3q outgoing = redirected(first[1], vec3q_from_array(hit.normal), q[10]);
    Vec3q start = tracer_ray_origin(&hit, outgoing);
    intersect_ray(engine, tracer, (const Vec3q[]){start, outgoing}, &again);
    outputs[0] = again.shape < 0 ? QUAD_NO_HIT : again.distance;
    outputs[1] = vec3q_length(vec3q_subtract(start, vec3q_from_array(hit.point)));
}

/* --- small and large --- */

/** Scene units. */
static const double sphere_radii[] = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1,
                                      10,   1e2,  1e3,  1e4,  1e5,  1e6};

/** @return A sphere at one radius from the origin. */
static OffsetSphere offset_sphere_at(double radius, double ratio) {
    return (OffsetSphere){far_point(radius), number_types()[0]->round(radius), ratio};
}

/** Generates a mirror, small or large, see #Experiment.generate. */
static void generate_mirror_scale(const ExperimentSetup *setup, Random *random,
                                  ExperimentSample *sample) {
    OffsetSphere sphere = offset_sphere_at(setup->level, 0);
    generate_offset_ray(setup, &sphere, random, sample);
}

/** Generates a glass sphere, small or large, see #Experiment.generate. */
static void generate_glass_scale(const ExperimentSetup *setup, Random *random,
                                 ExperimentSample *sample) {
    OffsetSphere sphere = offset_sphere_at(setup->level, IOR_RATIO);
    generate_offset_ray(setup, &sphere, random, sample);
}

/** Is an #Experiment.create_scene. */
static Scene *scene_scale(const ExperimentSetup *setup, Error *error) {
    OffsetSphere sphere = offset_sphere_at(setup->level, 0);
    return sphere_scene(sphere.center, (double)sphere.radius, error);
}

const Experiment mirror_scale_experiment = {
    .name = "mirror-scale",
    .title = N_("Rays that leave a mirroring sphere, small and large: which meet it again?"),
    .family = "leaving",
    .difficulty = N_("radius, scene units"),
    .error_label = N_("shift of the start over the radius"),
    .levels = sphere_radii,
    .level_count = COUNT_OF(sphere_radii),
    .sample_count = 10000,
    .queries_per_sample = 1,
    .timed_level = 1e3,
    .generate = generate_mirror_scale,
    .score_sample = score_reflected,
    .create_scene = scene_scale,
    .query_engine = query_second_ray,
};

const Experiment glass_scale_experiment = {
    .name = "glass-scale",
    .title = N_("Rays that go into a sphere of glass, small and large: which come out wrong?"),
    .family = "leaving",
    .difficulty = N_("radius, scene units"),
    .error_label = N_("shift of the start over the radius"),
    .levels = sphere_radii,
    .level_count = COUNT_OF(sphere_radii),
    .sample_count = 10000,
    .queries_per_sample = 1,
    .timed_level = 1e3,
    .generate = generate_glass_scale,
    .score_sample = score_refracted,
    .create_scene = scene_scale,
    .query_engine = query_second_ray,
};

/* --- far from the origin of the world --- */

/** Radii. */
static const double offsets[] = {1, 10, 1e2, 1e3, 1e4, 1e5};

/** Generates a mirror far away, see #Experiment.generate. */
static void generate_mirror_offset(const ExperimentSetup *setup, Random *random,
                                   ExperimentSample *sample) {
    generate_offset_ray(setup, &(OffsetSphere){far_point(setup->level), 1, 0}, random, sample);
}

/** Generates a glass sphere far away, see #Experiment.generate. */
static void generate_glass_offset(const ExperimentSetup *setup, Random *random,
                                  ExperimentSample *sample) {
    generate_offset_ray(setup, &(OffsetSphere){far_point(setup->level), 1, IOR_RATIO}, random,
                        sample);
}

const Experiment mirror_offset_experiment = {
    .name = "mirror-world",
    .title = N_("Rays that leave a mirroring sphere far from the origin: which meet it again?"),
    .family = "leaving",
    .difficulty = N_("distance from the origin / radius"),
    .error_label = N_("shift of the start over the radius"),
    .levels = offsets,
    .level_count = COUNT_OF(offsets),
    .sample_count = 10000,
    .queries_per_sample = 1,
    .generate = generate_mirror_offset,
    .score_sample = score_reflected,
    .create_scene = create_far_sphere_scene,
    .query_engine = query_second_ray,
};

const Experiment glass_offset_experiment = {
    .name = "glass-world",
    .title = N_("Rays that go into a sphere of glass far from the origin: which come out wrong?"),
    .family = "leaving",
    .difficulty = N_("distance from the origin / radius"),
    .error_label = N_("shift of the start over the radius"),
    .levels = offsets,
    .level_count = COUNT_OF(offsets),
    .sample_count = 10000,
    .queries_per_sample = 1,
    .generate = generate_glass_offset,
    .score_sample = score_refracted,
    .create_scene = create_far_sphere_scene,
    .query_engine = query_second_ray,
};

/* --- through two spheres close to each other --- */

/** Distances of the spheres, in radii of the inner one; 4e-5: a cornea. */
static const double gaps[] = {1e-1, 1e-2, 1e-3, 1e-4, 4e-5, 1e-5, 1e-6};
/** Surfaces that a ray through both meets. */
enum { SHELL_SURFACES = 4 };
/** Hits after which a ray is given up. */
enum { SHELL_HITS = 8 };

/** @return The radius of the outer sphere, exact in float. */
static Quadruple outer_radius(double gap) {
    return number_types()[0]->round(1 + (Quadruple)gap);
}

/** Generates a ray through both spheres, see #Experiment.generate. */
static void generate_shells(const ExperimentSetup *setup, Random *random,
                            ExperimentSample *sample) {
    SampleWriter writer = {setup->type, sample->inputs};
    Vec3q center = far_point(1), outwards = random_direction(random);
    Vec3q origin = sample_writer_vec3(&writer, vec3q_add(center, vec3q_scale(outwards, 3)));
    Vec3q target = vec3q_add(center, random_in_disc(random, outwards, 0.95));
    sample_writer_vec3(&writer, vec3q_normalize(vec3q_subtract(target, origin)));
    sample_writer_vec3(&writer, center);
    sample_writer_number(&writer, outer_radius(setup->level));
    sample_writer_number(&writer, 1);
}

/** Scores what a ray met: too little, too much, not in order. See #Experiment.score_sample. */
static void score_shells(const ExperimentSample *sample, const Quadruple *outputs,
                         ScoreStats *score) {
    (void)sample;
    score_outcome(score, OUTCOME_LEAK, outputs[1] < SHELL_SURFACES);
    score_outcome(score, OUTCOME_DOUBLE_HIT, outputs[1] > SHELL_SURFACES);
    score_outcome(score, OUTCOME_WRONG, outputs[0] < SHELL_SURFACES);
    score_cost(score, SHELL_SURFACES - outputs[0]);
}

/** @return Both spheres, the outer one first, see #Experiment.create_scene. */
static Scene *scene_shells(const ExperimentSetup *setup, Error *error) {
    FixtureValue inner[] = {{.name = "center"}, {"radius", {1}}, {0}};
    vec3q_to_doubles(far_point(1), inner[0].components);
    Scene *scene = sphere_scene(far_point(1), (double)outer_radius(setup->level), error);
    if (scene && !scene_fixture_add_shape(scene, "sphere", inner, error)) {
        scene_destroy(scene);
        scene = NULL;
    }
    return scene;
}

/** Sends a ray straight through, anew from each hit as the tracer's transmitted rays start. See
 *  #Experiment.query_engine. */
static void query_shells(const Engine *engine, Tracer *tracer, const ExperimentSample *sample,
                         Quadruple *outputs) {
    static const int expected[SHELL_SURFACES] = {0, 1, 1, 0};
    Vec3q ray[2] = {vec3q_from_array(sample->inputs), vec3q_from_array(sample->inputs + 3)};
    RayResult hit;
    int in_order = 0, count = 0;
    intersect_ray(engine, tracer, ray, &hit);
    for (; count < SHELL_HITS && hit.shape >= 0; count++) {
        in_order += count < SHELL_SURFACES && in_order == count && hit.shape == expected[count];
        Vec3q normal = vec3q_from_array(hit.normal);
        if (vec3q_dot(ray[1], normal) > 0) { // The side that the ray goes to is behind the surface.
            normal = vec3q_scale(normal, -1);
        }
        hit.normal[0] = normal.x;
        hit.normal[1] = normal.y;
        hit.normal[2] = normal.z;
        ray[0] = tracer_ray_origin(&hit, ray[1]);
        intersect_ray(engine, tracer, ray, &hit);
    }
    outputs[0] = in_order;
    outputs[1] = count;
}

const Experiment shells_gap_experiment = {
    .name = "shells-gap",
    .title = N_("Rays straight through two spheres close to each other: which surfaces are lost?"),
    .family = "shells",
    .difficulty = N_("distance of the spheres / radius"),
    .cost_label = N_("surfaces of four that are lost"),
    .levels = gaps,
    .level_count = COUNT_OF(gaps),
    .sample_count = 10000,
    .queries_per_sample = 1,
    .timed_level = 4e-5,
    .generate = generate_shells,
    .score_sample = score_shells,
    .create_scene = scene_shells,
    .query_engine = query_shells,
};
