/**
 * @file
 * @brief Experiments on cylinders: their wall from far away, and the rim of closed ones.
 */
#include "dioptre/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/pose.h"

/* --- the wall, from far away --- */

/** Radii. */
static const double distances[] = {2, 10, 1e2, 1e3, 1e4};

/** @return Where a ray first meets an upright wall of radius 1 around the y axis; #QUAD_NONE:
 *          nowhere. @param o Where it starts. @param d Which way. */
static Quadruple wall_truth(Quad3 o, Quad3 d) {
    Quadruple a = d.x * d.x + d.z * d.z, b = -(o.x * d.x + o.z * d.z);
    Quadruple cross = d.x * o.z - d.z * o.x, c = o.x * o.x + o.z * o.z - 1;
    Quadruple discriminant = a - cross * cross;
    if (discriminant < 0) {
        return QUAD_NONE;
    }
    Quadruple root = quad_sqrt(discriminant), sum = b > 0 ? b + root : b - root;
    Quadruple near = b > 0 ? c / sum : sum / a, far = b > 0 ? sum / a : c / sum;
    return near > 0 ? near : far > 0 ? far : QUAD_NONE;
}

/** Poses a wall far away, that rays cross at up to 45 degrees. See #Experiment.pose.
 *  @param setting Where. @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose_wall(const Setting *setting, Random *random, Case *posed) {
    Writer writer = {setting->type, posed->questions};
    Quad3 around = random_direction(random);
    around = quad3_normalize((Quad3){around.x, 0, around.z});
    Quad3 origin = rounded(setting->type, quad3_scale(around, setting->level));
    Quadruple beside = random_between(random, -1.02, 1.02);
    Quadruple up = random_between(random, -setting->level, setting->level);
    Quad3 target = {-around.z * beside, up, around.x * beside};
    write_vector(&writer, origin);
    Quad3 direction = write_vector(&writer, quad3_normalize(quad3_subtract(target, origin)));
    write_vector(&writer, (Quad3){0, 0, 0});
    write_number(&writer, 1);
    posed->truth[0] = wall_truth(origin, direction);
}

/** @return A pipe that is longer than rays go up or down. See #Experiment.scene. @param setting
 *  Where. @param[out] error What is wrong. */
static Scene *scene_wall(const Setting *setting, Error *error) {
    double reach = 4 * setting->level;
    StageValue values[] = {
        {"base", {0, -reach, 0}}, {"top", {0, reach, 0}}, {"radius", {1}}, {"capped", {0}}, {0}};
    return stage_with("cylinder", values, error);
}

const Experiment cylinder_distance_experiment = {
    .name = "cylinder-distance",
    .title = N_("The wall of a cylinder, seen from far away"),
    .family = "cylinder-wall",
    .stress = N_("distance / radius"),
    .error = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = distances,
    .level_count = COUNT_OF(distances),
    .cases = 20000,
    .parts = 1,
    .timed = 1e3,
    .pose = pose_wall,
    .judge = judge_distance,
    .scene = scene_wall,
};

/* --- the rim of a closed one --- */

/** Radii. */
static const double offsets[] = {1, 10, 1e2, 1e3, 1e4};
/** Height of the cylinder, radii: a place that float holds plus this is one that it holds, too. */
enum { HEIGHT = 2 };

/** @return The foot of the cylinder: at whole coordinates, so that its top is exact.
 *  @param level Radii from the origin. */
static Quad3 foot_of(double level) {
    Quad3 place = place_far(level);
    return (Quad3){(int)place.x, (int)place.y, (int)place.z};
}

/** Poses a ray from inside to the rim. See #Experiment.pose. @param setting Where.
 *  @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose_rim(const Setting *setting, Random *random, Case *posed) {
    Writer writer = {setting->type, posed->questions};
    Quad3 foot = foot_of(setting->level), up = {0, 1, 0};
    Quad3 inside = random_across(random, up, 0.7);
    inside.y = random_between(random, 0.3, HEIGHT - 0.3);
    Quad3 origin = write_vector(&writer, quad3_add(foot, inside));
    Quad3 rim = quad3_normalize(random_across(random, up, 1));
    rim.y = random_share(random) < 0.5 ? 0 : HEIGHT;
    Quad3 target = quad3_add(foot, rim);
    write_vector(&writer, quad3_normalize(quad3_subtract(target, origin)));
    write_vector(&writer, foot);
    write_number(&writer, 1);
    write_number(&writer, HEIGHT);
}

/** @return The closed cylinder. See #Experiment.scene. @param setting Where. @param[out] error What
 *  is wrong. */
static Scene *scene_rim(const Setting *setting, Error *error) {
    Quad3 foot = foot_of(setting->level);
    StageValue values[] = {
        {.name = "base"}, {.name = "top"}, {"radius", {1}}, {"capped", {1}}, {0}};
    to_numbers(foot, values[0].numbers);
    to_numbers(quad3_add(foot, (Quad3){0, HEIGHT, 0}), values[1].numbers);
    return stage_with("cylinder", values, error);
}

const Experiment cylinder_rim_experiment = {
    .name = "cylinder-rim",
    .title = N_("Rays from inside a closed cylinder, aimed at its rim"),
    .family = "cylinder-solid",
    .stress = N_("distance from the origin / radius"),
    .levels = offsets,
    .level_count = COUNT_OF(offsets),
    .cases = 50000,
    .parts = 1,
    .timed = 1,
    .pose = pose_rim,
    .judge = judge_count,
    .scene = scene_rim,
    .ask = ask_count,
};
