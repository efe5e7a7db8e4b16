/**
 * @file
 * @brief Repetition by the point's cell and all that touch it.
 *
 *   f(P) = least distance to the balls of 27 cells
 */
#include "lab/methods/domain_repetition.h"

/** @return The field. */
static real domain_repetition_neighbors_sdf(const DomainRepetitionInput *in, Vec3 p) {
    int x = domain_repetition_cell(p.x), y = domain_repetition_cell(p.y),
        z = domain_repetition_cell(p.z);
    real minimum = INFINITE;
    for (int i = 0; i < 27; i++) {
        real distance =
            domain_repetition_cell_distance(in, p, x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1);
        minimum = real_min(distance, minimum);
    }
    return minimum;
}

/** Asks it. See #Method.run. */
static void domain_repetition_neighbors_run(const void *input, void *output) {
    const DomainRepetitionInput *in = input;
    ((DomainRepetitionOutput *)output)->distance =
        domain_repetition_trace(in, domain_repetition_neighbors_sdf);
}

const Method domain_repetition_neighbors = {.group = "cells",
                                            .name = "27 cells",
                                            .label = "27 cells",
                                            .input_count = NUMBERS_IN(DomainRepetitionInput),
                                            .output_count = NUMBERS_IN(DomainRepetitionOutput),
                                            .run = domain_repetition_neighbors_run};
