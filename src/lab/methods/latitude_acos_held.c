/**
 * @file
 * @brief Latitude by the arc cosine of what is held between -1 and 1.
 *
 *   angle = acos(min(1, max(-1, (P.y - C.y) / R)))
 *
 * No NaN any more; the last bit still counts as much.
 */
#include "lab/methods/functions.h"
#include "lab/methods/latitude.h"

/** Asks it. See #Method.run. @param question A #LatitudeQuestion. @param[out] answer A
 * #LatitudeAnswer. */
static void run(const void *question, void *answer) {
    const LatitudeQuestion *q = question;
    real y = (q->point.y - q->center.y) / q->radius;
    y = y > 1 ? 1 : y < -1 ? -1 : y;
    ((LatitudeAnswer *)answer)->angle = real_acos(y);
}

const Method latitude_acos_held = {.family = "latitude",
                                   .name = "acos held",
                                   .label = "acos held",
                                   .inputs = NUMBERS_OF(LatitudeQuestion),
                                   .outputs = NUMBERS_OF(LatitudeAnswer),
                                   .run = run};
