/**
 * @file
 * @brief An experiment on balls in all cells of space: which ball is met first?
 */
#include "lab/experiments/experiments.h"
#include "lab/experiments/pose.h"

#include "dioptre/language.h"
#include "lab/methods/ball_sizes.h"

#include <math.h>

/** How much radii differ, more or less. */
static const double spreads[] = {0.01, 0.02, 0.05, 0.1, 0.15};
/** How far off a ray may stop and still be right. */
#define NEAR 0.01

/** @return Where a ray first meets a ball of any cell, within reach of a march; #QUAD_NONE:
 * nowhere. Double is enough to tell one ball from another. @param o Where it starts. @param d Which
 * way.
 *  @param spread How much radii differ. */
static Quadruple cells_truth(Vector3 o, Vector3 d, double spread) {
    double nearest = HUGE_VAL;
    int reach = BALLS_REACH + 1;
    for (int i = 0; i < (2 * reach + 1) * (2 * reach + 1) * (2 * reach + 1); i++) {
        int edge = 2 * reach + 1, x = i % edge - reach, y = i / edge % edge - reach;
        int z = i / edge / edge - reach;
        Vector3 f = vector3_subtract(o, (Vector3){x, y, z});
        double radius = ball_radius(x, y, z, spread), b = vector3_dot(f, d);
        double discriminant = b * b - vector3_dot(f, f) + radius * radius;
        double t = discriminant >= 0 ? -b - sqrt(discriminant) : -1;
        nearest = t > 0 && t < nearest ? t : nearest;
    }
    return nearest <= BALLS_REACH ? nearest : QUAD_NONE;
}

/** Poses a ray from a corner between cells. See #Experiment.pose. @param setting Where.
 *  @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose(const Setting *setting, Random *random, Case *posed) {
    Writer writer = {setting->type, posed->questions};
    Quad3 o = write_vector(&writer, (Quad3){0.5, 0.5, 0.5});
    Quad3 d = write_vector(&writer, random_direction(random));
    write_number(&writer, setting->level);
    posed->truth[0] = cells_truth((Vector3){(double)o.x, (double)o.y, (double)o.z},
                                  (Vector3){(double)d.x, (double)d.y, (double)d.z}, setting->level);
}

/** Judges where a ray stopped. See #Experiment.judge. @param posed The case. @param answers The
 *  distance. @param[in,out] score The score. */
static void judge(const Case *posed, const Quadruple *answers, Score *score) {
    Quadruple truth = posed->truth[0];
    if (truth < QUAD_NONE) {
        score_outcome(score, OUTCOME_WRONG, !(quad_abs(answers[0] - truth) < NEAR));
    }
}

const Experiment field_cells_experiment = {
    .name = "field-cells",
    .title = N_("A ball in each cell of space, of a size of its own: is the right one met?"),
    .family = "cells",
    .stress = N_("radii differ by, more or less, of the cell's edge"),
    .levels = spreads,
    .level_count = COUNT_OF(spreads),
    .cases = 2000,
    .parts = 1,
    .timed = 0.1,
    .pose = pose,
    .judge = judge,
};
