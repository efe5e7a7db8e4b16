/**
 * @file
 * @brief Plane by a point of it, as in reports C and D (rows C1, D1).
 *
 *   t = (Q - P0).N / d.N
 *
 * Q - P0 is long where the point lies far away, and its product with N cancels.
 */
#include "lab/methods/plane.h"

/** Asks it. See #Method.run. @param question A #PlaneQuestion. @param[out] answer A #PlaneAnswer.
 */
static void run(const void *question, void *answer) {
    const PlaneQuestion *q = question;
    real height = vector_dot(vector_subtract(q->point, q->origin), q->normal);
    ((PlaneAnswer *)answer)->distance = height / vector_dot(q->direction, q->normal);
}

const Method plane_point = {.family = "plane",
                            .name = "by a point",
                            .label = "by a point",
                            .inputs = NUMBERS_OF(PlaneQuestion),
                            .outputs = NUMBERS_OF(PlaneAnswer),
                            .run = run};
