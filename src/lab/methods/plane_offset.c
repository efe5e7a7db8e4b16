/**
 * @file
 * @brief Plane by its offset D, worked out once.
 *
 *   D = N.Q,  t = (D - N.P0) / d.N
 */
#include "lab/methods/plane.h"

/** Asks it. See #Method.run. @param question A #PlaneQuestion. @param[out] answer A #PlaneAnswer.
 */
static void run(const void *question, void *answer) {
    const PlaneQuestion *q = question;
    real height = q->offset - vector_dot(q->normal, q->origin);
    ((PlaneAnswer *)answer)->distance = height / vector_dot(q->direction, q->normal);
}

const Method plane_offset = {.family = "plane",
                             .name = "by its offset",
                             .label = "by its offset",
                             .inputs = NUMBERS_OF(PlaneQuestion),
                             .outputs = NUMBERS_OF(PlaneAnswer),
                             .run = run};
