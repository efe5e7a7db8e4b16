/**
 * @file
 * @brief Triangle by Möller and Trumbore's products, edges and corners left out.
 *
 *   u > 0,  v > 0,  u + v < 1
 *
 * A ray exactly at an edge misses both neighbours even where nothing is rounded.
 */
#include "lab/methods/triangle.h"

/** Asks it. See #Method.run. */
static void triangle_moller_trumbore_strict_run(const void *input, void *output) {
    const TriangleInput *in = input;
    TriangleSolution found = triangle_moller_trumbore_solve(in);
    int is_met = found.determinant != 0 && found.u > 0 && found.v > 0 && found.u + found.v < 1 &&
                 found.distance > 0;
    ((TriangleOutput *)output)->distance = is_met ? found.distance : INFINITE;
}

const Method triangle_moller_trumbore_strict = {.group = "triangle",
                                                .name = "Moeller-Trumbore strict",
                                                .label = "M.-T. strict",
                                                .input_count = NUMBERS_IN(TriangleInput),
                                                .output_count = NUMBERS_IN(TriangleOutput),
                                                .run = triangle_moller_trumbore_strict_run};
