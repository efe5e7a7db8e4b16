/**
 * @file
 * @brief Experiments on planes: grazing rays, and a point of the plane that lies far away.
 */
#include "dioptre/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/pose.h"

#include <math.h>

/** A plane under an eye. */
typedef struct Ground {
    Quad3 point;   /**< A point of it, exact in float. */
    Quad3 normal;  /**< Its normal, exact in float, of about length 1. */
    double degree; /**< Under what angle rays meet it, degrees. */
} Ground;

/** @return A plane through about the origin of the world. @param far How far its point lies.
 *  @param degree See #Ground. */
static Ground ground_of(double far, double degree) {
    const NumberType *narrowest = number_types()[0];
    Quad3 normal = quad3_normalize((Quad3){0.31, 0.88, -0.36});
    Quad3 along = quad3_normalize(quad3_cross(normal, (Quad3){0.2, 0.5, 0.84}));
    return (Ground){rounded(narrowest, quad3_scale(along, far)), rounded(narrowest, normal),
                    degree};
}

/** Poses an eye one unit above the plane. @param setting Where. @param ground The plane.
 *  @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose(const Setting *setting, const Ground *ground, Random *random, Case *posed) {
    Writer writer = {setting->type, posed->questions};
    Quad3 n = ground->normal, unit = quad3_normalize(n);
    Quadruple offset = quad3_dot(n, ground->point);
    Quad3 foot = quad3_scale(n, offset / quad3_dot(n, n));
    Quad3 beside = random_across(random, unit, 1);
    Quad3 along = quad3_normalize(random_across(random, unit, 1));
    double angle = ground->degree * random_between(random, 0.95, 1.05) * M_PI / 180;
    Quad3 origin = write_vector(&writer, quad3_add(quad3_add(foot, unit), beside));
    Quad3 direction = write_vector(
        &writer, quad3_subtract(quad3_scale(along, cos(angle)), quad3_scale(unit, sin(angle))));
    write_vector(&writer, ground->point);
    write_vector(&writer, n);
    write_number(&writer, offset);
    posed->truth[0] = (offset - quad3_dot(n, origin)) / quad3_dot(n, direction);
}

/** @return The scene of a plane. @param ground The plane. @param[out] error What is wrong. */
static Scene *plane_scene(const Ground *ground, Error *error) {
    StageValue values[] = {{.name = "point"}, {.name = "normal"}, {0}};
    to_numbers(ground->point, values[0].numbers);
    to_numbers(ground->normal, values[1].numbers);
    return stage_with("plane", values, error);
}

/* --- grazing rays --- */

/** Degrees. */
static const double angles[] = {30, 10, 3, 1, 0.3, 0.1, 0.03, 0.01};

/** Poses grazing rays. See #Experiment.pose. @param setting Where. @param[in,out] random Where it
 *  comes from. @param[out] posed The case. */
static void pose_angle(const Setting *setting, Random *random, Case *posed) {
    Ground ground = ground_of(1, setting->level);
    pose(setting, &ground, random, posed);
}

/** @return Its scene. See #Experiment.scene. @param setting Where. @param[out] error What is wrong.
 */
static Scene *scene_angle(const Setting *setting, Error *error) {
    Ground ground = ground_of(1, setting->level);
    return plane_scene(&ground, error);
}

const Experiment plane_angle_experiment = {
    .name = "plane-angle",
    .title = N_("A plane one unit below the eye, met under ever smaller angles"),
    .family = "plane",
    .stress = N_("angle between ray and plane, degrees"),
    .error = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = angles,
    .level_count = COUNT_OF(angles),
    .cases = 20000,
    .parts = 1,
    .pose = pose_angle,
    .judge = judge_distance,
    .scene = scene_angle,
};

/* --- a point far away --- */

/** Heights of the eye. */
static const double distances[] = {1, 10, 1e2, 1e3, 1e4, 1e5, 1e6};
/** Under what angle rays meet the plane, degrees. */
#define STEEP 30

/** Poses a plane whose point lies far away. See #Experiment.pose. @param setting Where.
 *  @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose_point(const Setting *setting, Random *random, Case *posed) {
    Ground ground = ground_of(setting->level, STEEP);
    pose(setting, &ground, random, posed);
}

/** @return Its scene. See #Experiment.scene. @param setting Where. @param[out] error What is wrong.
 */
static Scene *scene_point(const Setting *setting, Error *error) {
    Ground ground = ground_of(setting->level, STEEP);
    return plane_scene(&ground, error);
}

const Experiment plane_point_experiment = {
    .name = "plane-point",
    .title = N_("A plane one unit below the eye, given by a point far away"),
    .family = "plane",
    .stress = N_("distance of the point / height of the eye"),
    .error = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = distances,
    .level_count = COUNT_OF(distances),
    .cases = 20000,
    .parts = 1,
    .timed = 1e3,
    .pose = pose_point,
    .judge = judge_distance,
    .scene = scene_point,
};
