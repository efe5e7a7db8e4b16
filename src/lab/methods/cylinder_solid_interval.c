/**
 * @file
 * @brief A closed cylinder as what two intervals of the ray have in common: between the roots of
 *        the wall, and between the planes of the ends. The tracer's way.
 *
 * A ray that starts inside is in both, and leaves where the first of them ends, once: no rounding
 * can open the rim.
 */
#include "lab/methods/cylinder.h"

/** Asks it. See #Method.run. @param question A #CylinderQuestion. @param[out] answer A
 * #CylinderAnswer. */
static void run(const void *question, void *answer) {
    const CylinderQuestion *q = question;
    real x = q->origin.x - q->base.x, z = q->origin.z - q->base.z, y = q->origin.y - q->base.y;
    real dx = q->direction.x, dz = q->direction.z;
    real a = dx * dx + dz * dz, b = -(x * dx + z * dz), cross = dx * z - dz * x;
    real c = x * x + z * z - q->radius * q->radius;
    real discriminant = a * q->radius * q->radius - cross * cross;
    real root = real_sqrt(discriminant), sum = b > 0 ? b + root : b - root;
    real wall_near = b > 0 ? c / sum : sum / a, wall_far = b > 0 ? sum / a : c / sum;
    real bottom = -y / q->direction.y, top = (q->height - y) / q->direction.y;
    real near = real_max(wall_near, real_min(bottom, top));
    real far = real_min(wall_far, real_max(bottom, top));
    int is_met = discriminant >= 0 && near <= far && far > 0;
    CylinderAnswer *found = answer;
    found->distance = is_met ? (near > 0 ? near : far) : INFINITE;
    found->count = is_met ? (near > 0 ? 2 : 1) : 0;
}

const Method cylinder_solid_interval = {.family = "cylinder-solid",
                                        .name = "interval",
                                        .label = "interval",
                                        .inputs = NUMBERS_OF(CylinderQuestion),
                                        .outputs = NUMBERS_OF(CylinderAnswer),
                                        .run = run};
