/**
 * @file
 * @brief Triangle by Möller and Trumbore's products, small determinants taken for zero.
 *
 *   |det| > 1e-6,  u >= 0,  v >= 0,  u + v <= 1
 *
 * The determinant is twice the area of the triangle as the ray sees it: what is small is never hit.
 */
#include "lab/methods/triangle.h"

/** Asks it. See #Method.run. @param question A #TriangleQuestion. @param[out] answer A
 * #TriangleAnswer. */
static void run(const void *question, void *answer) {
    const TriangleQuestion *q = question;
    Barycentric found = moeller_trumbore(q);
    int is_met = real_abs(found.determinant) > (scalar)1e-6f && found.u >= 0 && found.v >= 0 &&
                 found.u + found.v <= 1 && found.distance > 0;
    ((TriangleAnswer *)answer)->distance = is_met ? found.distance : INFINITE;
}

const Method triangle_moeller_cut = {.family = "triangle",
                                     .name = "Moeller-Trumbore with cut",
                                     .label = "M.-T. with cut",
                                     .inputs = NUMBERS_OF(TriangleQuestion),
                                     .outputs = NUMBERS_OF(TriangleAnswer),
                                     .run = run};
