/**
 * @file
 * @brief Triangle by Möller and Trumbore's products, small determinants taken for zero.
 *
 *   |det| > 1e-6,  u >= 0,  v >= 0,  u + v <= 1
 *
 * The determinant is twice the area of the triangle as the ray sees it: what is small is never hit.
 */
#include "lab/methods/triangle.h"

/** Asks it. See #Method.run. */
static void triangle_moller_trumbore_cutoff_run(const void *input, void *output) {
    const TriangleInput *in = input;
    TriangleSolution found = triangle_moller_trumbore_solve(in);
    int is_met = real_abs(found.determinant) > (scalar)1e-6f && found.u >= 0 && found.v >= 0 &&
                 found.u + found.v <= 1 && found.distance > 0;
    ((TriangleOutput *)output)->distance = is_met ? found.distance : INFINITE;
}

const Method triangle_moller_trumbore_cutoff = {.group = "triangle",
                                                .name = "Moeller-Trumbore with cut",
                                                .label = "M.-T. with cut",
                                                .input_count = NUMBERS_IN(TriangleInput),
                                                .output_count = NUMBERS_IN(TriangleOutput),
                                                .run = triangle_moller_trumbore_cutoff_run};
