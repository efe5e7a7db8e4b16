/**
 * @file
 * @brief Repetition by the point's own cell alone: report B's way (row B8).
 *
 *   f(P) = distance to the ball of the cell that P is in
 *
 * The ball of the next cell may be nearer. Then f is more than the distance, the step is too long,
 * and the ray jumps into or through that ball.
 */
#include "lab/methods/domain_repetition.h"

/** @return The field. */
static real domain_repetition_own_cell_sdf(const DomainRepetitionInput *in, Vec3 p) {
    return domain_repetition_cell_distance(in, p, domain_repetition_cell(p.x),
                                           domain_repetition_cell(p.y),
                                           domain_repetition_cell(p.z));
}

/** Asks it. See #Method.run. */
static void domain_repetition_own_cell_run(const void *input, void *output) {
    const DomainRepetitionInput *in = input;
    ((DomainRepetitionOutput *)output)->distance =
        domain_repetition_trace(in, domain_repetition_own_cell_sdf);
}

const Method domain_repetition_own_cell = {.group = "cells",
                                           .name = "own cell",
                                           .label = "own cell",
                                           .input_count = NUMBERS_IN(DomainRepetitionInput),
                                           .output_count = NUMBERS_IN(DomainRepetitionOutput),
                                           .run = domain_repetition_own_cell_run};
