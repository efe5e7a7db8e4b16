/**
 * @file
 * @brief Latitude by the arc cosine: report A's way (row A11).
 *
 *   angle = acos((P.y - C.y) / R)
 *
 * At the pole the quotient may be rounded to more than 1, whose arc cosine is no number; and near 1
 * the arc cosine turns the last bit into a large angle.
 */
#include "lab/methods/functions.h"
#include "lab/methods/latitude.h"

/** Asks it. See #Method.run. @param question A #LatitudeQuestion. @param[out] answer A
 * #LatitudeAnswer. */
static void run(const void *question, void *answer) {
    const LatitudeQuestion *q = question;
    ((LatitudeAnswer *)answer)->angle = real_acos((q->point.y - q->center.y) / q->radius);
}

const Method latitude_acos = {.family = "latitude",
                              .name = "acos",
                              .label = "acos",
                              .inputs = NUMBERS_OF(LatitudeQuestion),
                              .outputs = NUMBERS_OF(LatitudeAnswer),
                              .run = run};
