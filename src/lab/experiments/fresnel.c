/**
 * @file
 * @brief Experiments on how much a surface of glass mirrors, from outside and from inside.
 */
#include "dioptre/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/pose.h"

#include <math.h>

/** Index of glass. */
#define GLASS 1.5

/** @return The share that is mirrored, in quad precision. @param c The cosine of the ray.
 *  @param n Index beyond over index before the surface. */
static Quadruple fresnel_truth(Quadruple c, Quadruple n) {
    Quadruple squared = 1 - (1 - c) * (1 + c) / (n * n);
    if (squared <= 0) {
        return 1;
    }
    Quadruple ct = quad_sqrt(squared);
    Quadruple along = (c - n * ct) / (c + n * ct), across = (n * c - ct) / (n * c + ct);
    return (along * along + across * across) / 2;
}

/** Writes a question. @param setting Where. @param cosine The ray's. @param index See
 *  #fresnel_truth. @param[out] posed The case. */
static void write_question(const Setting *setting, double cosine, double index, Case *posed) {
    Writer writer = {setting->type, posed->questions};
    Quadruple c = write_number(&writer, cosine), n = write_number(&writer, index);
    posed->truth[0] = fresnel_truth(c, n);
}

/** Judges a share. See #Experiment.judge. @param posed The case. @param answers The share.
 *  @param[in,out] score The score. */
static void judge(const Case *posed, const Quadruple *answers, Score *score) {
    bool is_number = quad_is_number(answers[0]);
    score_outcome(score, OUTCOME_NAN, !is_number);
    if (is_number) {
        score_error(score, quad_abs(answers[0] - posed->truth[0]));
    }
}

/* --- into glass --- */

/** Degrees above the surface. */
static const double heights[] = {90, 60, 45, 30, 20, 15, 12, 10, 8, 5, 3, 1, 0.3, 0.1};

/** Poses light that comes from air. See #Experiment.pose. @param setting Where. @param[in,out]
 *  random Where it comes from. @param[out] posed The case. */
static void pose_into(const Setting *setting, Random *random, Case *posed) {
    double height = setting->level * random_between(random, 0.97, 1);
    write_question(setting, sin(height * M_PI / 180), GLASS, posed);
}

const Experiment fresnel_into_experiment = {
    .name = "fresnel-into",
    .title = N_("How much glass mirrors of light that comes from air"),
    .family = "fresnel",
    .stress = N_("angle between ray and surface, degrees"),
    .error = N_("error of the share that is mirrored"),
    .levels = heights,
    .level_count = COUNT_OF(heights),
    .cases = 2000,
    .parts = 1,
    .timed = 5,
    .pose = pose_into,
    .judge = judge,
};

/* --- out of glass --- */

/** Degrees before the angle from which on all is mirrored. */
static const double before_critical[] = {40, 30, 20, 10, 5, 3, 1, 0.3, 0.1, 0.03, 0.01};

/** Poses light that comes from inside the glass. See #Experiment.pose. @param setting Where.
 *  @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose_out(const Setting *setting, Random *random, Case *posed) {
    double before = setting->level * random_between(random, 0.97, 1) * M_PI / 180;
    write_question(setting, cos(asin(1 / GLASS) - before), 1 / GLASS, posed);
}

const Experiment fresnel_out_experiment = {
    .name = "fresnel-out",
    .title = N_("How much glass mirrors of light that comes from inside it"),
    .family = "fresnel",
    .stress = N_("degrees before total reflection"),
    .error = N_("error of the share that is mirrored"),
    .levels = before_critical,
    .level_count = COUNT_OF(before_critical),
    .cases = 2000,
    .parts = 1,
    .pose = pose_out,
    .judge = judge,
};
