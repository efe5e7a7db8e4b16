/**
 * @file
 * @brief An experiment on the normals of distance fields: how far apart should the field be asked?
 */
#include "dioptre/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/pose.h"

/** Radii of the ball. */
static const double steps[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10};

/** Poses a point of a ball. See #Experiment.pose. @param setting Where. @param[in,out] random Where
 *  it comes from. @param[out] posed The case. */
static void pose(const Setting *setting, Random *random, Case *posed) {
    Writer writer = {setting->type, posed->questions};
    Quad3 point = write_vector(&writer, random_direction(random));
    write_vector(&writer, (Quad3){0, 0, 0});
    write_number(&writer, 1);
    write_number(&writer, setting->level);
    Quad3 normal = quad3_normalize(point);
    posed->truth[0] = normal.x;
    posed->truth[1] = normal.y;
    posed->truth[2] = normal.z;
}

/** Judges a direction: the sine of the angle to the true one, or 2 minus it beyond a right angle.
 *  See #Experiment.judge. @param posed The case. @param answers The direction. @param[in,out] score
 *  The score. */
static void judge(const Case *posed, const Quadruple *answers, Score *score) {
    Quad3 truth = quad3_of(posed->truth), found = quad3_of(answers);
    bool is_number = quad_is_number(found.x);
    score_outcome(score, OUTCOME_NAN, !is_number);
    if (is_number) {
        Quad3 across = quad3_cross(truth, quad3_normalize(found));
        Quadruple sine = quad3_length(across);
        score_error(score, quad3_dot(truth, found) > 0 ? sine : 2 - sine);
    }
}

/** @return The ball as a field. See #Experiment.scene. @param setting Not looked at. @param[out]
 *  error What is wrong. */
static Scene *scene(const Setting *setting, Error *error) {
    const StageValue values[] = {{"radius", {1}}, {0}};
    (void)setting;
    return stage_with_field("distance.sphere", values, (Vector3){0, 0, 0}, error);
}

/** Asks an engine for the normal where a ray meets the ball that comes straight down to the point.
 *  See #Experiment.ask. @param engine The engine. @param tracer Its tracer. @param posed The case.
 *  @param[out] answers The direction. */
static void ask(const Engine *engine, Tracer *tracer, const Case *posed, Quadruple *answers) {
    RayAnswer answer;
    Quad3 point = quad3_of(posed->questions);
    // Four times as far is exact.
    const Quad3 ray[2] = {quad3_scale(point, 4), quad3_scale(point, -1)};
    engine_ask(engine, tracer, ray, &answer);
    for (int i = 0; i < 3; i++) {
        answers[i] = answer.shape < 0 ? (Quadruple)__builtin_nan("") : answer.normal[i];
    }
}

const Experiment field_normal_experiment = {
    .name = "field-normal",
    .title = N_("Normals of a ball's distance field, by differences over a length"),
    .family = "gradient",
    .stress = N_("length of the difference / radius"),
    .error = N_("error of the angle, radians"),
    .levels = steps,
    .level_count = COUNT_OF(steps),
    .cases = 5000,
    .parts = 1,
    .timed = TIMED_BEST,
    .pose = pose,
    .judge = judge,
    .scene = scene,
    .ask = ask,
};
