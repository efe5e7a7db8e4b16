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

/** Asks it. See #Method.run. @param question A #TriangleQuestion. @param[out] answer A
 * #TriangleAnswer. */
static void run(const void *question, void *answer) {
    const TriangleQuestion *q = question;
    const real e = (scalar)1e-6f;
    Barycentric found = moeller_trumbore(q);
    int is_met = found.determinant != 0 && found.u >= -e && found.v >= -e &&
                 found.u + found.v <= 1 + e && found.distance > 0;
    ((TriangleAnswer *)answer)->distance = is_met ? found.distance : INFINITE;
}

const Method triangle_moeller_tolerant = {.family = "triangle",
                                          .name = "Moeller-Trumbore tolerant",
                                          .label = "M.-T. tolerant",
                                          .inputs = NUMBERS_OF(TriangleQuestion),
                                          .outputs = NUMBERS_OF(TriangleAnswer),
                                          .run = run};
