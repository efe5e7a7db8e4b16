/**
 * @file
 * @brief An experiment on marching: how many steps does it take down to the ground, and how far off
 *        does it stop?
 */
#include "dioptre/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/pose.h"

#include <math.h>

/** Degrees. */
static const double angles[] = {30, 10, 3, 1, 0.3, 0.1};
/** How near is on the surface, heights of the eye. */
#define TOLERANCE 1e-4

/** Poses an eye one unit above the ground. See #Experiment.pose. @param setting Where.
 *  @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose(const Setting *setting, Random *random, Case *posed) {
    Writer writer = {setting->type, posed->questions};
    double angle = setting->level * random_between(random, 0.99, 1.01) * M_PI / 180;
    Quad3 origin = write_vector(&writer, (Quad3){0, random_between(random, 0.99, 1.01), 0});
    Quad3 direction = write_vector(&writer, (Quad3){cos(angle), -sin(angle), 0});
    write_number(&writer, TOLERANCE);
    posed->truth[0] = origin.y / -direction.y;
}

/** Judges where and after how many steps a ray stopped. See #Experiment.judge. @param posed The
 *  case. @param answers Distance and steps. @param[in,out] score The score. */
static void judge(const Case *posed, const Quadruple *answers, Score *score) {
    score_outcome(score, OUTCOME_FALSE_MISS, !(answers[0] < QUAD_NONE));
    if (answers[0] < QUAD_NONE) {
        score_error(score, quad_abs(answers[0] - posed->truth[0]));
        if (quad_is_number(answers[1])) {
            score_work(score, answers[1]);
        }
    }
}

/** @return The ground: a box that no ray comes to the end of, and not larger, for what it measures
 *          is as rounded as it is large. See #Experiment.scene. @param setting Where.
 *  @param[out] error What is wrong. */
static Scene *scene(const Setting *setting, Error *error) {
    double reach = 1.1 / tan(setting->level * M_PI / 180);
    const StageValue values[] = {{"size", {2 * reach, 2, 2}}, {0}};
    return stage_with_field("distance.box", values, (Vector3){0, -1, 0}, error);
}

/** Asks an engine for the distance; it does not say its steps. See #Experiment.ask. @param engine
 *  The engine. @param tracer Its tracer. @param posed The case. @param[out] answers Distance and
 *  steps. */
static void ask(const Engine *engine, Tracer *tracer, const Case *posed, Quadruple *answers) {
    RayAnswer answer;
    const Quad3 ray[2] = {quad3_of(posed->questions), quad3_of(posed->questions + 3)};
    engine_ask(engine, tracer, ray, &answer);
    answers[0] = answer.shape < 0 ? QUAD_NONE : answer.distance;
    answers[1] = (Quadruple)__builtin_nan("");
}

const Experiment marching_angle_experiment = {
    .name = "marching-angle",
    .title = N_("Marching down to the ground under ever smaller angles"),
    .family = "marching",
    .stress = N_("angle between ray and ground, degrees"),
    .error = N_("error of the distance t, heights of the eye"),
    .work = N_("steps of a ray"),
    .levels = angles,
    .level_count = COUNT_OF(angles),
    .cases = 400,
    .parts = 1,
    .timed = 1,
    .pose = pose,
    .judge = judge,
    .scene = scene,
    .ask = ask,
};
