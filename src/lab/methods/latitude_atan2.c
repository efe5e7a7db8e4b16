/**
 * @file
 * @brief Latitude by the arc tangent of its two legs: the tracer's way.
 *
 *   angle = atan2(sqrt(x^2 + z^2), y), of P - C
 */
#include "lab/methods/functions.h"
#include "lab/methods/latitude.h"

/** Asks it. See #Method.run. @param question A #LatitudeQuestion. @param[out] answer A
 * #LatitudeAnswer. */
static void run(const void *question, void *answer) {
    const LatitudeQuestion *q = question;
    Vector n = vector_subtract(q->point, q->center);
    ((LatitudeAnswer *)answer)->angle = real_atan2(real_sqrt(n.x * n.x + n.z * n.z), n.y);
}

const Method latitude_atan2 = {.family = "latitude",
                               .name = "atan2",
                               .label = "atan2",
                               .inputs = NUMBERS_OF(LatitudeQuestion),
                               .outputs = NUMBERS_OF(LatitudeAnswer),
                               .run = run};
