/**
 * @file
 * @brief Triangle by Möller and Trumbore's products, made a little larger.
 *
 *   u >= -e,  v >= -e,  u + v <= 1 + e,  e = 1e-6
 *
 * The cure of many tutorials: no leaks, but rays at edges meet both neighbours, and e is one
 * constant for every size and distance.
 */
#include "lab/methods/triangle.h"

/** Asks it. See #Method.run. */
static void triangle_moller_trumbore_tolerant_run(const void *input, void *output) {
    const TriangleInput *in = input;
    const real e = (scalar)1e-6f;
    TriangleSolution found = triangle_moller_trumbore_solve(in);
    int is_met = found.determinant != 0 && found.u >= -e && found.v >= -e &&
                 found.u + found.v <= 1 + e && found.distance > 0;
    ((TriangleOutput *)output)->distance = is_met ? found.distance : INFINITE;
}

const Method triangle_moller_trumbore_tolerant = {.group = "triangle",
                                                  .name = "Moeller-Trumbore tolerant",
                                                  .label = "M.-T. tolerant",
                                                  .input_count = NUMBERS_IN(TriangleInput),
                                                  .output_count = NUMBERS_IN(TriangleOutput),
                                                  .run = triangle_moller_trumbore_tolerant_run};
