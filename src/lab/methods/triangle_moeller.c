/**
 * @file
 * @brief Triangle by Möller and Trumbore's products, edges and corners counted in.
 *
 *   u >= 0,  v >= 0,  u + v <= 1
 *
 * Both neighbours of an edge may still round themselves away from it.
 */
#include "lab/methods/triangle.h"

/** Asks it. See #Method.run. @param question A #TriangleQuestion. @param[out] answer A
 * #TriangleAnswer. */
static void run(const void *question, void *answer) {
    const TriangleQuestion *q = question;
    Barycentric found = moeller_trumbore(q);
    int is_met = found.determinant != 0 && found.u >= 0 && found.v >= 0 && found.u + found.v <= 1 &&
                 found.distance > 0;
    ((TriangleAnswer *)answer)->distance = is_met ? found.distance : INFINITE;
}

const Method triangle_moeller = {.family = "triangle",
                                 .name = "Moeller-Trumbore",
                                 .label = "Moeller-T.",
                                 .inputs = NUMBERS_OF(TriangleQuestion),
                                 .outputs = NUMBERS_OF(TriangleAnswer),
                                 .run = run};
