/**
 * @file
 * @brief Experiments on cylinders: their wall from far away, and the rim of closed ones.
 */
#include "base/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/sample_writer.h"

/* --- the wall, from far away --- */

/** Radii. */
static const double distances[] = {2, 10, 1e2, 1e3, 1e4};

/** @return Where a ray first meets an upright wall of radius 1 around the y axis; #QUAD_NO_HIT:
 *  nowhere. */
static Quadruple cylinder_wall_expected(Vec3q o, Vec3q d) {
    Quadruple a = d.x * d.x + d.z * d.z, b = -(o.x * d.x + o.z * d.z);
    Quadruple cross = d.x * o.z - d.z * o.x, c = o.x * o.x + o.z * o.z - 1;
    Quadruple discriminant = a - cross * cross;
    if (discriminant < 0) {
        return QUAD_NO_HIT;
    }
    Quadruple root = quad_sqrt(discriminant), sum = b > 0 ? b + root : b - root;
    Quadruple near = b > 0 ? c / sum : sum / a, far = b > 0 ? sum / a : c / sum;
    return near > 0 ? near : far > 0 ? far : QUAD_NO_HIT;
}

/** Generates a wall far away, that rays cross at up to 45 degrees, see #Experiment.generate. */
static void generate_wall(const ExperimentSetup *setup, Random *random, ExperimentSample *sample) {
    SampleWriter writer = {setup->type, sample->inputs};
    Vec3q around = random_direction(random);
    around = vec3q_normalize((Vec3q){around.x, 0, around.z});
    Vec3q origin = vec3q_round(setup->type, vec3q_scale(around, setup->level));
    Quadruple lateral = random_range(random, -1.02, 1.02);
    Quadruple up = random_range(random, -setup->level, setup->level);
    Vec3q target = {-around.z * lateral, up, around.x * lateral};
    sample_writer_vec3(&writer, origin);
    Vec3q direction = sample_writer_vec3(&writer, vec3q_normalize(vec3q_subtract(target, origin)));
    sample_writer_vec3(&writer, (Vec3q){0, 0, 0});
    sample_writer_number(&writer, 1);
    sample->expected[0] = cylinder_wall_expected(origin, direction);
}

/** @return A pipe that is longer than rays go up or down, see #Experiment.create_scene. */
static Scene *scene_wall(const ExperimentSetup *setup, Error *error) {
    double half_length = 4 * setup->level;
    FixtureValue values[] = {{"base", {0, -half_length, 0}},
                             {"top", {0, half_length, 0}},
                             {"radius", {1}},
                             {"capped", {0}},
                             {0}};
    return scene_fixture_with_shape("cylinder", values, error);
}

const Experiment cylinder_distance_experiment = {
    .name = "cylinder-distance",
    .title = N_("The wall of a cylinder, seen from far away"),
    .family = "cylinder-wall",
    .difficulty = N_("distance / radius"),
    .error_label = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = distances,
    .level_count = COUNT_OF(distances),
    .sample_count = 20000,
    .queries_per_sample = 1,
    .timed_level = 1e3,
    .generate = generate_wall,
    .score_sample = score_expected_distance,
    .create_scene = scene_wall,
};

/* --- the rim of a closed one --- */

/** Radii. */
static const double origin_distances[] = {1, 10, 1e2, 1e3, 1e4};
/** Height of the cylinder, radii: a float coordinate plus this is exact in float. */
enum { HEIGHT = 2 };

/** Generates a ray from inside to the rim, see #Experiment.generate. */
static void generate_rim(const ExperimentSetup *setup, Random *random, ExperimentSample *sample) {
    SampleWriter writer = {setup->type, sample->inputs};
    Vec3q base = far_whole_point(setup->level), up = {0, 1, 0};
    Vec3q inside = random_in_disc(random, up, 0.7);
    inside.y = random_range(random, 0.3, HEIGHT - 0.3);
    Vec3q origin = sample_writer_vec3(&writer, vec3q_add(base, inside));
    Vec3q rim = vec3q_normalize(random_in_disc(random, up, 1));
    rim.y = random_unit(random) < 0.5 ? 0 : HEIGHT;
    Vec3q target = vec3q_add(base, rim);
    sample_writer_vec3(&writer, vec3q_normalize(vec3q_subtract(target, origin)));
    sample_writer_vec3(&writer, base);
    sample_writer_number(&writer, 1);
    sample_writer_number(&writer, HEIGHT);
}

/** @return The closed cylinder, see #Experiment.create_scene. */
static Scene *scene_rim(const ExperimentSetup *setup, Error *error) {
    Vec3q base = far_whole_point(setup->level);
    FixtureValue values[] = {
        {.name = "base"}, {.name = "top"}, {"radius", {1}}, {"capped", {1}}, {0}};
    vec3q_to_doubles(base, values[0].components);
    vec3q_to_doubles(vec3q_add(base, (Vec3q){0, HEIGHT, 0}), values[1].components);
    return scene_fixture_with_shape("cylinder", values, error);
}

const Experiment cylinder_rim_experiment = {
    .name = "cylinder-rim",
    .title = N_("Rays from inside a closed cylinder, aimed at its rim"),
    .family = "cylinder-solid",
    .difficulty = N_("distance from the origin / radius"),
    .levels = origin_distances,
    .level_count = COUNT_OF(origin_distances),
    .sample_count = 50000,
    .queries_per_sample = 1,
    .timed_level = 1,
    .generate = generate_rim,
    .score_sample = score_hit_count,
    .create_scene = scene_rim,
    .query_engine = query_hit_count,
    .is_nearest_hit = true,
};
