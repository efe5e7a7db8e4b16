/**
 * @file
 * @brief Experiments on boxes: rays that just touch them, flat ones, and the edges of a cube.
 */
#include "dioptre/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/pose.h"

/* --- rays that just touch --- */

/** Bits of each part of a direction. */
static const double bits[] = {1, 2, 3, 4, 6, 8, 10};
/** How far away a ray starts, lengths of its direction: it must be exact. */
enum { DISTANCE = 64 };

/** Lowest corner of the box that is touched. */
static const Quad3 box_low = {-1, -2, -1};
/** Its highest; a flat one is 0 high. */
static const Quad3 box_high = {1, 2, 3};

/** @return A part of a direction: a fraction of so few bits that rays are exact in float, even if
 *          its quotients are not. One in five is zero. @param[in,out] random Where it comes from.
 *  @param count How many bits. */
static Quadruple part(Random *random, double count) {
    uint64_t steps = (uint64_t)1 << (int)count;
    bool is_zero = random_bits(random) % 5 == 0;
    Quadruple number = (Quadruple)(random_bits(random) % (2 * steps - 1)) - (Quadruple)(steps - 1);
    return is_zero ? 0 : number / (Quadruple)steps;
}

/** @return A place along one axis: an end of it, or sometimes somewhere between, in eighths.
 *  @param[in,out] random Where it comes from. @param low An end. @param high The other. */
static Quadruple touched(Random *random, Quadruple low, Quadruple high) {
    uint64_t where = random_bits(random) % 5;
    Quadruple between = low + (high - low) * (Quadruple)(random_bits(random) % 9) / 8;
    return where == 0 ? between : where % 2 ? low : high;
}

/** Poses a ray that runs exactly through a point of a box's surface. See #Experiment.pose.
 *  @param setting Where. @param[in,out] random Where it comes from. @param high The box's highest
 *  corner. @param[out] posed The case. */
static void pose_through(const Setting *setting, Random *random, Quad3 high, Case *posed) {
    Quad3 point = {touched(random, box_low.x, high.x), touched(random, box_low.y, high.y),
                   touched(random, box_low.z, high.z)};
    double count = setting->level;
    Quad3 direction = {part(random, count), part(random, count), part(random, count)};
    if (quad3_dot(direction, direction) == 0) {
        direction.x = 1;
    }
    Writer writer = {setting->type, posed->questions};
    write_vector(&writer, quad3_subtract(point, quad3_scale(direction, DISTANCE)));
    write_vector(&writer, direction);
    write_vector(&writer, box_low);
    write_vector(&writer, high);
}

/** Poses a ray that touches a box. See #Experiment.pose. @param setting Where. @param[in,out]
 * random Where it comes from. @param[out] posed The case. */
static void pose_touch(const Setting *setting, Random *random, Case *posed) {
    pose_through(setting, random, box_high, posed);
}

/** Poses a ray that touches a flat box. See #Experiment.pose. @param setting Where.
 *  @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose_flat(const Setting *setting, Random *random, Case *posed) {
    pose_through(setting, random, (Quad3){box_high.x, box_low.y, box_high.z}, posed);
}

/** Judges whether a ray met what it touches. See #Experiment.judge. @param posed Not looked at.
 *  @param answers The distance. @param[in,out] score The score. */
static void judge_touch(const Case *posed, const Quadruple *answers, Score *score) {
    (void)posed;
    score_outcome(score, OUTCOME_FALSE_MISS, !(answers[0] < QUAD_NONE));
}

/** @return The scene of a box. @param low Its lowest corner. @param high Its highest.
 *  @param[out] error What is wrong. */
static Scene *box_scene(Quad3 low, Quad3 high, Error *error) {
    StageValue values[] = {{.name = "min"}, {.name = "max"}, {0}};
    to_numbers(low, values[0].numbers);
    to_numbers(high, values[1].numbers);
    return stage_with("box", values, error);
}

/** @return The box. See #Experiment.scene. @param setting Not looked at. @param[out] error What is
 *  wrong. */
static Scene *scene_touch(const Setting *setting, Error *error) {
    (void)setting;
    return box_scene(box_low, box_high, error);
}

const Experiment box_touch_experiment = {
    .name = "box-touch",
    .title = N_("Rays that just touch a box: its corners, its edges, along its faces"),
    .family = "box-slabs",
    .stress = N_("bits of each part of the direction"),
    .levels = bits,
    .level_count = COUNT_OF(bits),
    .cases = 50000,
    .parts = 1,
    .timed = 10,
    .pose = pose_touch,
    .judge = judge_touch,
    .scene = scene_touch,
};

const Experiment box_flat_experiment = {
    .name = "box-flat",
    .title = N_("Rays that meet a flat box, as trees have them around flat models"),
    .family = "box-slabs",
    .stress = N_("bits of each part of the direction"),
    .levels = bits,
    .level_count = COUNT_OF(bits),
    .cases = 50000,
    .parts = 1,
    .pose = pose_flat,
    .judge = judge_touch,
};

/* --- the edges of a cube --- */

/** Edges of the cube. */
static const double offsets[] = {1, 10, 1e2, 1e3, 1e4};

/** @return The lowest corner of a cube of edge 1: at whole coordinates, so that it is one.
 *  @param level How far from the origin. */
static Quad3 corner_of(double level) {
    Quad3 place = place_far(level);
    return (Quad3){(int)place.x, (int)place.y, (int)place.z};
}

/** Poses a ray from inside a cube to one of its edges. See #Experiment.pose. @param setting Where.
 *  @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose_edge(const Setting *setting, Random *random, Case *posed) {
    Quad3 corner = corner_of(setting->level);
    Quadruple ends[2] = {(Quadruple)(random_bits(random) % 2),
                         (Quadruple)(random_bits(random) % 2)};
    Quadruple along = random_share(random);
    uint64_t axis = random_bits(random) % 3;
    Quad3 edge = axis == 0   ? (Quad3){along, ends[0], ends[1]}
                 : axis == 1 ? (Quad3){ends[0], along, ends[1]}
                             : (Quad3){ends[0], ends[1], along};
    Quad3 inside = {random_between(random, 0.1, 0.9), random_between(random, 0.1, 0.9),
                    random_between(random, 0.1, 0.9)};
    Writer writer = {setting->type, posed->questions};
    Quad3 origin = write_vector(&writer, quad3_add(corner, inside));
    Quad3 target = quad3_add(corner, edge);
    write_vector(&writer, quad3_normalize(quad3_subtract(target, origin)));
    write_vector(&writer, corner);
    write_vector(&writer, quad3_add(corner, (Quad3){1, 1, 1}));
}

/** @return The cube. See #Experiment.scene. @param setting Where. @param[out] error What is wrong.
 */
static Scene *scene_edge(const Setting *setting, Error *error) {
    Quad3 corner = corner_of(setting->level);
    return box_scene(corner, quad3_add(corner, (Quad3){1, 1, 1}), error);
}

const Experiment cube_edges_experiment = {
    .name = "cube-edges",
    .title = N_("Rays from inside a cube, aimed at its edges"),
    .family = "box-cube",
    .stress = N_("distance from the origin / edge"),
    .levels = offsets,
    .level_count = COUNT_OF(offsets),
    .cases = 50000,
    .parts = 1,
    .timed = 1,
    .pose = pose_edge,
    .judge = judge_count,
    .scene = scene_edge,
    .ask = ask_count,
};
