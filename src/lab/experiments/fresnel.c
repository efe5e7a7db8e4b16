/**
 * @file
 * @brief Experiments on how much a surface of glass mirrors, from outside and from inside.
 */
#include "base/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/sample_writer.h"

#include <math.h>

/** Index of glass. */
#define GLASS_IOR 1.5

/** @return The share that is mirrored, in quad precision. @param c The cosine of the ray.
 *  @param n Index beyond over index before the surface. */
static Quadruple fresnel_expected(Quadruple c, Quadruple n) {
    Quadruple squared = 1 - (1 - c) * (1 + c) / (n * n);
    if (squared <= 0) {
        return 1;
    }
    Quadruple ct = quad_sqrt(squared);
    Quadruple along = (c - n * ct) / (c + n * ct), across = (n * c - ct) / (n * c + ct);
    return (along * along + across * across) / 2;
}

/** Writes a question. */
static void fresnel_write_input(const ExperimentSetup *setup, double cosine, double index,
                                ExperimentSample *sample) {
    SampleWriter writer = {setup->type, sample->inputs};
    Quadruple c = sample_writer_number(&writer, cosine), n = sample_writer_number(&writer, index);
    sample->expected[0] = fresnel_expected(c, n);
}

/** Judges a share. See #Experiment.score_sample. */
static void score_reflectance(const ExperimentSample *sample, const Quadruple *outputs,
                              ScoreStats *score) {
    bool is_number = quad_is_number(outputs[0]);
    score_outcome(score, OUTCOME_NAN, !is_number);
    if (is_number) {
        score_error(score, quad_abs(outputs[0] - sample->expected[0]));
    }
}

/* --- into glass --- */

/** Degrees above the surface. */
static const double grazing_angles[] = {90, 60, 45, 30, 20, 15, 12, 10, 8, 5, 3, 1, 0.3, 0.1};

/** Poses light that comes from air. See #Experiment.generate. @param[in,out] random Where it comes
 *  from. */
static void generate_into(const ExperimentSetup *setup, Random *random, ExperimentSample *sample) {
    double height = setup->level * random_range(random, 0.97, 1);
    fresnel_write_input(setup, sin(height * M_PI / 180), GLASS_IOR, sample);
}

const Experiment fresnel_into_experiment = {
    .name = "fresnel-into",
    .title = N_("How much glass mirrors of light that comes from air"),
    .family = "fresnel",
    .difficulty = N_("angle between ray and surface, degrees"),
    .error_label = N_("error of the share that is mirrored"),
    .levels = grazing_angles,
    .level_count = COUNT_OF(grazing_angles),
    .sample_count = 2000,
    .queries_per_sample = 1,
    .timed_level = 5,
    .generate = generate_into,
    .score_sample = score_reflectance,
};

/* --- out of glass --- */

/** Degrees before the angle from which on all is mirrored. */
static const double angles_before_critical[] = {40, 30, 20, 10, 5, 3, 1, 0.3, 0.1, 0.03, 0.01};

/** Poses light that comes from inside the glass. See #Experiment.generate. @param[in,out] random
 *  Where it comes from. */
static void generate_out(const ExperimentSetup *setup, Random *random, ExperimentSample *sample) {
    double before = setup->level * random_range(random, 0.97, 1) * M_PI / 180;
    fresnel_write_input(setup, cos(asin(1 / GLASS_IOR) - before), 1 / GLASS_IOR, sample);
}

const Experiment fresnel_out_experiment = {
    .name = "fresnel-out",
    .title = N_("How much glass mirrors of light that comes from inside it"),
    .family = "fresnel",
    .difficulty = N_("degrees before total reflection"),
    .error_label = N_("error of the share that is mirrored"),
    .levels = angles_before_critical,
    .level_count = COUNT_OF(angles_before_critical),
    .sample_count = 2000,
    .queries_per_sample = 1,
    .generate = generate_out,
    .score_sample = score_reflectance,
};
