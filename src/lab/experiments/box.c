/**
 * @file
 * @brief Experiments on boxes: rays that just touch them, flat ones, and the edges of a cube.
 */
#include "base/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/sample_writer.h"

/* --- rays that just touch --- */

/** Bits of each part of a direction. */
static const double direction_bits[] = {1, 2, 3, 4, 6, 8, 10};
/** How far away a ray starts, lengths of its direction: it must be exact. */
enum { DISTANCE = 64 };

/** Lowest corner of the box that is touched. */
static const Vec3q box_low = {-1, -2, -1};
/** Its highest; a flat one is 0 high. */
static const Vec3q box_high = {1, 2, 3};

/** @return A part of a direction: a fraction of so few bits that rays are exact in float, even if
 * its quotients are not. One in five is zero. */
static Quadruple random_direction_component(Random *random, double count) {
    uint64_t steps = (uint64_t)1 << (int)count;
    bool is_zero = random_bits(random) % 5 == 0;
    Quadruple number = (Quadruple)(random_bits(random) % (2 * steps - 1)) - (Quadruple)(steps - 1);
    return is_zero ? 0 : number / (Quadruple)steps;
}

/** @return A place along one axis: an end of it, or sometimes somewhere between, in eighths. */
static Quadruple random_box_coordinate(Random *random, Quadruple low, Quadruple high) {
    uint64_t where = random_bits(random) % 5;
    Quadruple between = low + (high - low) * (Quadruple)(random_bits(random) % 9) / 8;
    return where == 0 ? between : where % 2 ? low : high;
}

/** Generates a ray that runs exactly through a point of a box's surface, see #Experiment.generate.
 */
static void generate_through_point(const ExperimentSetup *setup, Random *random, Vec3q high,
                                   ExperimentSample *sample) {
    Vec3q point = {random_box_coordinate(random, box_low.x, high.x),
                   random_box_coordinate(random, box_low.y, high.y),
                   random_box_coordinate(random, box_low.z, high.z)};
    double count = setup->level;
    Vec3q direction = {random_direction_component(random, count),
                       random_direction_component(random, count),
                       random_direction_component(random, count)};
    if (vec3q_dot(direction, direction) == 0) {
        direction.x = 1;
    }
    SampleWriter writer = {setup->type, sample->inputs};
    sample_writer_vec3(&writer, vec3q_subtract(point, vec3q_scale(direction, DISTANCE)));
    sample_writer_vec3(&writer, direction);
    sample_writer_vec3(&writer, box_low);
    sample_writer_vec3(&writer, high);
}

/** Generates a ray that touches a box, see #Experiment.generate. */
static void generate_touch(const ExperimentSetup *setup, Random *random, ExperimentSample *sample) {
    generate_through_point(setup, random, box_high, sample);
}

/** Generates a ray that touches a flat box, see #Experiment.generate. */
static void generate_flat(const ExperimentSetup *setup, Random *random, ExperimentSample *sample) {
    generate_through_point(setup, random, (Vec3q){box_high.x, box_low.y, box_high.z}, sample);
}

/** Scores whether a ray met what it touches, see #Experiment.score_sample. */
static void score_touch(const ExperimentSample *sample, const Quadruple *outputs,
                        ScoreStats *score) {
    (void)sample;
    score_outcome(score, OUTCOME_FALSE_MISS, !(outputs[0] < QUAD_NO_HIT));
}

/** @return The scene of a box. */
static Scene *box_scene(Vec3q low, Vec3q high, Error *error) {
    FixtureValue values[] = {{.name = "min"}, {.name = "max"}, {0}};
    vec3q_to_doubles(low, values[0].components);
    vec3q_to_doubles(high, values[1].components);
    return scene_fixture_with_shape("box", values, error);
}

/** @return The box, see #Experiment.create_scene. */
static Scene *scene_touch(const ExperimentSetup *setup, Error *error) {
    (void)setup;
    return box_scene(box_low, box_high, error);
}

const Experiment box_touch_experiment = {
    .name = "box-touch",
    .title = N_("Rays that just touch a box: its corners, its edges, along its faces"),
    .family = "box-slabs",
    .difficulty = N_("bits of each part of the direction"),
    .levels = direction_bits,
    .level_count = COUNT_OF(direction_bits),
    .sample_count = 50000,
    .queries_per_sample = 1,
    .timed_level = 10,
    .generate = generate_touch,
    .score_sample = score_touch,
    .create_scene = scene_touch,
};

const Experiment box_flat_experiment = {
    .name = "box-flat",
    .title = N_("Rays that meet a flat box, as trees have them around flat models"),
    .family = "box-slabs",
    .difficulty = N_("bits of each part of the direction"),
    .levels = direction_bits,
    .level_count = COUNT_OF(direction_bits),
    .sample_count = 50000,
    .queries_per_sample = 1,
    .generate = generate_flat,
    .score_sample = score_touch,
};

/* --- the edges of a cube --- */

/** Edges of the cube. */
static const double origin_distances[] = {1, 10, 1e2, 1e3, 1e4};

/** Generates a ray from inside a cube to one of its edges, see #Experiment.generate. */
static void generate_edge(const ExperimentSetup *setup, Random *random, ExperimentSample *sample) {
    Vec3q corner = far_whole_point(setup->level);
    Quadruple ends[2] = {(Quadruple)(random_bits(random) % 2),
                         (Quadruple)(random_bits(random) % 2)};
    Quadruple along = random_unit(random);
    uint64_t axis = random_bits(random) % 3;
    Vec3q edge = axis == 0   ? (Vec3q){along, ends[0], ends[1]}
                 : axis == 1 ? (Vec3q){ends[0], along, ends[1]}
                             : (Vec3q){ends[0], ends[1], along};
    Vec3q inside = {random_range(random, 0.1, 0.9), random_range(random, 0.1, 0.9),
                    random_range(random, 0.1, 0.9)};
    SampleWriter writer = {setup->type, sample->inputs};
    Vec3q origin = sample_writer_vec3(&writer, vec3q_add(corner, inside));
    Vec3q target = vec3q_add(corner, edge);
    sample_writer_vec3(&writer, vec3q_normalize(vec3q_subtract(target, origin)));
    sample_writer_vec3(&writer, corner);
    sample_writer_vec3(&writer, vec3q_add(corner, (Vec3q){1, 1, 1}));
}

/** @return The cube, see #Experiment.create_scene. */
static Scene *scene_edge(const ExperimentSetup *setup, Error *error) {
    Vec3q corner = far_whole_point(setup->level);
    return box_scene(corner, vec3q_add(corner, (Vec3q){1, 1, 1}), error);
}

const Experiment cube_edges_experiment = {
    .name = "cube-edges",
    .title = N_("Rays from inside a cube, aimed at its edges"),
    .family = "box-cube",
    .difficulty = N_("distance from the origin / edge"),
    .levels = origin_distances,
    .level_count = COUNT_OF(origin_distances),
    .sample_count = 50000,
    .queries_per_sample = 1,
    .timed_level = 1,
    .generate = generate_edge,
    .score_sample = score_hit_count,
    .create_scene = scene_edge,
    .query_engine = query_hit_count,
    .is_nearest_hit = true,
};
