/**
 * @file
 * @brief The wall of a cylinder with a discriminant that does not cancel: the tracer's way.
 *
 *   D = A R^2 - (dx fz - dz fx)^2,  q = B + sign(B) sqrt(D),  t = C / -q and -q / A
 *
 * The product is how far the ray passes beside the axis: B^2 - A (fx^2 + fz^2) written so that
 * nothing large is subtracted. The near root comes as a quotient.
 */
#include "lab/methods/cylinder.h"

/** Asks it. See #Method.run. @param question A #CylinderQuestion. @param[out] answer A
 * #CylinderAnswer. */
static void run(const void *question, void *answer) {
    const CylinderQuestion *q = question;
    real x = q->origin.x - q->base.x, z = q->origin.z - q->base.z;
    real dx = q->direction.x, dz = q->direction.z;
    real a = dx * dx + dz * dz, b = -(x * dx + z * dz), cross = dx * z - dz * x;
    real c = x * x + z * z - q->radius * q->radius;
    real discriminant = a * q->radius * q->radius - cross * cross;
    real root = real_sqrt(discriminant), sum = b > 0 ? b + root : b - root;
    real near = b > 0 ? c / sum : sum / a, far = b > 0 ? sum / a : c / sum;
    real ahead = near > 0 ? near : far > 0 ? far : INFINITE;
    CylinderAnswer *found = answer;
    found->distance = discriminant >= 0 ? ahead : INFINITE;
    found->count = (real)((discriminant >= 0) * ((near > 0) + (far > 0)));
}

const Method cylinder_wall_cross = {.family = "cylinder-wall",
                                    .name = "cross product",
                                    .label = "cross product",
                                    .inputs = NUMBERS_OF(CylinderQuestion),
                                    .outputs = NUMBERS_OF(CylinderAnswer),
                                    .run = run};
