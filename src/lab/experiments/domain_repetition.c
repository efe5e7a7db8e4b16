/**
 * @file
 * @brief An experiment on spheres in all cells of space: which one is hit first?
 */
#include "lab/experiments/experiments.h"
#include "lab/experiments/sample_writer.h"

#include "base/language.h"
#include "lab/methods/sphere_grid.h"

#include <math.h>

/** Differences of the radii from the mean, in cells. */
static const double spreads[] = {0.01, 0.02, 0.05, 0.1, 0.15};
/** Tolerance of a ray's distance. */
#define HIT_TOLERANCE 0.01

/**
 * @return Where a ray first meets a sphere of any cell, within #SPHERE_GRID_REACH; #QUAD_NO_HIT:
 *        nowhere. Double distinguishes the spheres.
 */
static Quadruple sphere_grid_expected(Vec3d o, Vec3d d, double spread) {
    double nearest = HUGE_VAL;
    int cell_reach = SPHERE_GRID_REACH + 1;
    for (int i = 0; i < (2 * cell_reach + 1) * (2 * cell_reach + 1) * (2 * cell_reach + 1); i++) {
        int edge = 2 * cell_reach + 1, x = i % edge - cell_reach, y = i / edge % edge - cell_reach;
        int z = i / edge / edge - cell_reach;
        Vec3d f = vec3d_subtract(o, (Vec3d){x, y, z});
        double radius = sphere_grid_radius(x, y, z, spread), b = vec3d_dot(f, d);
        double discriminant = b * b - vec3d_dot(f, f) + radius * radius;
        double t = discriminant >= 0 ? -b - sqrt(discriminant) : -1;
        nearest = t > 0 && t < nearest ? t : nearest;
    }
    return nearest <= SPHERE_GRID_REACH ? nearest : QUAD_NO_HIT;
}

/** Generates a ray from a corner between cells, see #Experiment.generate. */
static void generate_sphere_grid(const ExperimentSetup *setup, Random *random,
                                 ExperimentSample *sample) {
    SampleWriter writer = {setup->type, sample->inputs};
    Vec3q o = sample_writer_vec3(&writer, (Vec3q){0.5, 0.5, 0.5});
    Vec3q d = sample_writer_vec3(&writer, random_direction(random));
    sample_writer_number(&writer, setup->level);
    sample->expected[0] =
        sphere_grid_expected((Vec3d){(double)o.x, (double)o.y, (double)o.z},
                             (Vec3d){(double)d.x, (double)d.y, (double)d.z}, setup->level);
}

/** Scores where a ray stopped, see #Experiment.score_sample. */
static void score_sphere_grid(const ExperimentSample *sample, const Quadruple *outputs,
                              ScoreStats *score) {
    Quadruple truth = sample->expected[0];
    if (truth < QUAD_NO_HIT) {
        score_outcome(score, OUTCOME_WRONG, !(quad_abs(outputs[0] - truth) < HIT_TOLERANCE));
    }
}

const Experiment sdf_repetition_experiment = {
    .name = "field-cells",
    .title = N_("A ball in each cell of space, of a size of its own: is the right one met?"),
    .family = "cells",
    .difficulty = N_("radii differ by, more or less, of the cell's edge"),
    .levels = spreads,
    .level_count = COUNT_OF(spreads),
    .sample_count = 2000,
    .queries_per_sample = 1,
    .timed_level = 0.1,
    .generate = generate_sphere_grid,
    .score_sample = score_sphere_grid,
};
