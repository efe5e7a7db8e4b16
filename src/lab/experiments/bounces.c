/**
 * @file
 * @brief An experiment on mirrors: how far off is a ray's direction after many of them?
 */
#include "dioptre/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/pose.h"

#include <string.h>

/** Mirrorings. */
static const double counts[] = {1, 2, 3, 4, 5, 6, 8, 10, 12};

/** Corners of a tetrahedron, and the radius of the balls there. */
static const Quad3 corners[4] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
/** Radius of the balls: they nearly touch, so that rays stay between them for long. */
#define RADIUS 1.3

/** Poses a ray between the balls. See #Experiment.pose. The truth is what the methods say in quad,
 *  whose own error is that much smaller.
 *  @param setting Where. @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose(const Setting *setting, Random *random, Case *posed) {
    Writer writer = {setting->type, posed->questions};
    write_vector(&writer, quad3_scale(random_direction(random), 0.1));
    write_vector(&writer, random_direction(random));
    for (int i = 0; i < 4; i++) {
        write_vector(&writer, corners[i]);
    }
    write_number(&writer, RADIUS);
    write_number(&writer, setting->level);
    const NumberType *const *widest = number_types();
    while (widest[1]) {
        widest++;
    }
    const Method *const *method = (*widest)->methods;
    while (strcmp((*method)->family, "bounces") != 0) {
        method++;
    }
    (*widest)->ask(*method, 1, posed->questions, posed->truth);
}

/** Judges a direction. See #Experiment.judge. @param posed The case. @param answers The direction.
 *  @param[in,out] score The score. */
static void judge(const Case *posed, const Quadruple *answers, Score *score) {
    Quad3 truth = quad3_of(posed->truth), found = quad3_of(answers);
    // Rays that get out between the balls are no cases.
    if (quad_is_number(truth.x) && quad_is_number(found.x)) {
        Quad3 off = quad3_subtract(quad3_normalize(found), quad3_normalize(truth));
        score_error(score, quad3_length(off));
    }
}

const Experiment mirror_bounces_experiment = {
    .name = "mirror-bounces",
    .title = N_("A ray between four mirroring balls: its direction after many mirrorings"),
    .family = "bounces",
    .stress = N_("mirrorings"),
    .error = N_("error of the direction, radians"),
    .levels = counts,
    .level_count = COUNT_OF(counts),
    .cases = 4000,
    .parts = 1,
    .timed = 5,
    .pose = pose,
    .judge = judge,
};
