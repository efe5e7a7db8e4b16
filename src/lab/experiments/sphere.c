/**
 * @file
 * @brief Experiments on spheres: far from the eye, far from the origin, small, large, underfoot.
 */
#include "dioptre/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/pose.h"

/** A sphere that is looked at. */
typedef struct View {
    Quad3 center;     /**< Where it is. */
    Quadruple radius; /**< How large. */
    double distance;  /**< From its centre to the eye, radii. */
} View;

/** Radii around the centre that rays aim at: a few pass beside the sphere. */
#define AIM 1.02

/** Writes a question. @param type The number type. @param ray Where it starts, and which way.
 *  @param view The sphere. @param[out] posed The case. */
static void write_question(const NumberType *type, const Quad3 ray[2], const View *view,
                           Case *posed) {
    Writer writer = {type, posed->questions};
    Quad3 origin = write_vector(&writer, ray[0]);
    Quad3 direction = write_vector(&writer, ray[1]);
    Quad3 center = write_vector(&writer, view->center);
    Quadruple radius = write_number(&writer, view->radius);
    posed->truth[0] = sphere_truth(origin, direction, center, radius);
}

/** Poses a ray from around a sphere to a disc around its centre. @param type The number type.
 *  @param view The sphere. @param[in,out] random Where it comes from. @param[out] posed The case.
 */
static void pose_view(const NumberType *type, const View *view, Random *random, Case *posed) {
    Quad3 outwards = random_direction(random);
    Quad3 origin = quad3_add(view->center, quad3_scale(outwards, view->distance * view->radius));
    origin = rounded(type, origin);
    Quad3 aim = random_across(random, outwards, AIM);
    Quad3 target = quad3_add(view->center, quad3_scale(aim, view->radius));
    Quad3 direction = quad3_normalize(quad3_subtract(target, origin));
    write_question(type, (const Quad3[]){origin, direction}, view, posed);
}

/* --- far from the eye ---------------------------------------------------------------------------
 */

/** Radii. */
static const double distances[] = {1.01, 2, 10, 1e2, 1e3, 1e4, 1e5, 1e6};

/** Poses a sphere far away. See #Experiment.pose. @param setting Where.
 *  @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose_distance(const Setting *setting, Random *random, Case *posed) {
    View view = {.radius = 1, .distance = setting->level};
    pose_view(setting->type, &view, random, posed);
}

/** @return Its scene. See #Experiment.scene. @param setting Where. @param[out] error What is
 *  wrong. */
static Scene *scene_distance(const Setting *setting, Error *error) {
    (void)setting;
    return sphere_scene((Quad3){0, 0, 0}, 1, error);
}

const Experiment sphere_distance_experiment = {
    .name = "sphere-distance",
    .title = N_("A sphere, seen from far away"),
    .family = "sphere",
    .stress = N_("distance / radius"),
    .error = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = distances,
    .level_count = COUNT_OF(distances),
    .cases = 50000,
    .parts = 1,
    .timed = 1e2,
    .pose = pose_distance,
    .judge = judge_distance,
    .scene = scene_distance,
};

/* --- far from the origin of the world ------------------------------------------------------------
 */

/** Radii. */
static const double offsets[] = {1, 10, 1e2, 1e3, 1e4, 1e5, 1e6};

/** Poses a sphere, ten radii away, far from the origin. See #Experiment.pose. @param setting Where.
 *  @param[in,out] random Where it comes from. @param[out] posed
 *  The case. */
static void pose_world(const Setting *setting, Random *random, Case *posed) {
    View view = {.center = place_far(setting->level), .radius = 1, .distance = 10};
    pose_view(setting->type, &view, random, posed);
}

/** @return Its scene. See #Experiment.scene. @param setting Where. @param[out] error What is wrong.
 */
static Scene *scene_world(const Setting *setting, Error *error) {
    return sphere_scene(place_far(setting->level), 1, error);
}

const Experiment sphere_world_experiment = {
    .name = "sphere-world",
    .title = N_("A sphere and an eye ten radii away, both far from the origin of the world"),
    .family = "sphere",
    .stress = N_("distance from the origin / radius"),
    .error = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = offsets,
    .level_count = COUNT_OF(offsets),
    .cases = 20000,
    .parts = 1,
    .pose = pose_world,
    .judge = judge_distance,
    .scene = scene_world,
};

/* --- small and large -----------------------------------------------------------------------------
 */

/** Scene units; as powers of two the figures would be the same to the bit. */
static const double scales[] = {1e-6, 1e-4, 1e-2, 1, 1e2, 1e4, 1e6};

/** Poses a sphere, ten radii away. See #Experiment.pose. @param setting Where.
 *  @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose_scale(const Setting *setting, Random *random, Case *posed) {
    View view = {.radius = number_types()[0]->round(setting->level), .distance = 10};
    pose_view(setting->type, &view, random, posed);
}

/** @return Its scene. See #Experiment.scene. @param setting Where. @param[out] error What is
 *  wrong. */
static Scene *scene_scale(const Setting *setting, Error *error) {
    return sphere_scene((Quad3){0, 0, 0}, (double)number_types()[0]->round(setting->level), error);
}

const Experiment sphere_scale_experiment = {
    .name = "sphere-scale",
    .title = N_("A sphere, small and large, ten radii away"),
    .family = "sphere",
    .stress = N_("radius, scene units"),
    .error = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = scales,
    .level_count = COUNT_OF(scales),
    .cases = 20000,
    .parts = 1,
    .pose = pose_scale,
    .judge = judge_distance,
    .scene = scene_scale,
};

/* --- underfoot
 * ------------------------------------------------------------------------------------ */

/** Radii, in heights of the eye. */
static const double grounds[] = {1e1, 1e2, 1e3, 1e4, 1e5, 1e6};

/** @return The middle of the earth: straight down along no axis. @param radius Its radius. */
static Quad3 earth_of(double radius) {
    return place_far(radius);
}

/** Poses an eye one unit above a large sphere, looking down at 5 to 90 degrees. See
 *  #Experiment.pose. @param setting Where.
 *  @param[in,out] random
 *  Where it comes from. @param[out] posed The case. */
static void pose_ground(const Setting *setting, Random *random, Case *posed) {
    View view = {.center = earth_of(setting->level), .radius = setting->level};
    // Somewhere on the ground, so that no one rounding of the eye's place decides all.
    Quad3 walk = random_across(random, (Quad3){0, 1, 0}, 10);
    Quad3 up = quad3_normalize(quad3_subtract(walk, view.center));
    Quad3 origin = quad3_add(view.center, quad3_scale(up, setting->level + 1));
    Quad3 along = quad3_normalize(random_across(random, up, 1));
    double down = random_between(random, 0.087, 1); // The sine of 5 degrees, to 1.
    Quad3 direction = quad3_subtract(quad3_scale(along, quad_sqrt(1 - (Quadruple)down * down)),
                                     quad3_scale(up, down));
    write_question(setting->type, (const Quad3[]){origin, direction}, &view, posed);
}

/** @return Its scene. See #Experiment.scene. @param setting Where. @param[out] error What is
 *  wrong. */
static Scene *scene_ground(const Setting *setting, Error *error) {
    return sphere_scene(earth_of(setting->level), setting->level, error);
}

const Experiment sphere_ground_experiment = {
    .name = "sphere-ground",
    .title = N_("A sphere as the ground, the eye one unit above it"),
    .family = "sphere",
    .stress = N_("radius / height of the eye"),
    .error = N_("error of the distance t, relative to t"),
    .is_relative = true,
    .levels = grounds,
    .level_count = COUNT_OF(grounds),
    .cases = 20000,
    .parts = 1,
    .timed = 1e5,
    .pose = pose_ground,
    .judge = judge_distance,
    .scene = scene_ground,
};
