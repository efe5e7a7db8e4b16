/**
 * @file
 * @brief An experiment on pictures on spheres: how far from the pole is a point?
 */
#include "dioptre/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/pose.h"

#include <math.h>

/** Radians from the pole. */
static const double angles[] = {1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7};

/** @return The centre of the sphere: so that points of it are rounded. */
static Quad3 center_of(void) {
    return place_far(2);
}

/** @return Where a ray meets the sphere, rounded as a tracer rounds it: P = o + t d. @param type
 * The number type. @param o Where it starts. @param d Which way. */
static Quad3 hit_of(const NumberType *type, Quad3 o, Quad3 d) {
    Quadruple t = type->round(sphere_truth(o, d, center_of(), 1));
    Quad3 way = rounded(type, quad3_scale(d, t));
    return rounded(type, quad3_add(o, way));
}

/** Poses a point near the pole, met from ten radii above. See #Experiment.pose. @param setting
 *  Where. @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose(const Setting *setting, Random *random, Case *posed) {
    const NumberType *type = setting->type;
    Writer writer = {type, posed->questions};
    double angle = setting->level * random_between(random, 0.5, 1);
    Quad3 up = {0, 1, 0}, along = quad3_normalize(random_across(random, up, 1));
    Quad3 arm = quad3_add(quad3_scale(up, cos(angle)), quad3_scale(along, sin(angle)));
    Quad3 target = quad3_add(center_of(), quad3_normalize(arm));
    Quad3 beside = random_across(random, up, 5);
    Quad3 eye = quad3_add(target, quad3_add(quad3_scale(arm, 10), beside));
    Quad3 o = rounded(type, eye);
    Quad3 d = rounded(type, quad3_normalize(quad3_subtract(target, o)));
    Quad3 point = write_vector(&writer, hit_of(type, o, d));
    Quad3 center = write_vector(&writer, center_of());
    write_number(&writer, 1);
    Quad3 n = quad3_subtract(point, center);
    posed->truth[0] = quad_atan2(quad_sqrt(n.x * n.x + n.z * n.z), n.y);
}

/** Judges an angle. See #Experiment.judge. @param posed The case. @param answers The angle.
 *  @param[in,out] score The score. */
static void judge(const Case *posed, const Quadruple *answers, Score *score) {
    bool is_number = quad_is_number(answers[0]);
    score_outcome(score, OUTCOME_NAN, !is_number);
    if (is_number) {
        score_error(score, quad_abs(answers[0] - posed->truth[0]));
    }
}

/** @return The sphere. See #Experiment.scene. @param setting Not looked at. @param[out] error What
 *  is wrong. */
static Scene *scene(const Setting *setting, Error *error) {
    (void)setting;
    return sphere_scene(center_of(), 1, error);
}

/** Asks an engine with a ray straight down onto the point. See #Experiment.ask. @param engine The
 *  engine. @param tracer Its tracer. @param posed The case. @param[out] answers The angle. */
static void ask(const Engine *engine, Tracer *tracer, const Case *posed, Quadruple *answers) {
    Quad3 point = quad3_of(posed->questions), center = quad3_of(posed->questions + 3);
    Quad3 arm = quad3_subtract(point, center);
    RayAnswer hit;
    engine_ask(engine, tracer, (const Quad3[]){quad3_add(point, arm), quad3_scale(arm, -1)}, &hit);
    answers[0] = (1 - hit.place[1]) * (Quadruple)M_PI;
}

const Experiment sphere_pole_experiment = {
    .name = "sphere-pole",
    .title = N_("Latitude on a sphere, near its pole"),
    .family = "latitude",
    .stress = N_("angle from the pole, radians"),
    .error = N_("error of the angle, radians"),
    .levels = angles,
    .level_count = COUNT_OF(angles),
    .cases = 20000,
    .parts = 1,
    .timed = 1e-3,
    .pose = pose,
    .judge = judge,
    .scene = scene,
    .ask = ask,
};
