/**
 * @file
 * @brief The wall of a cylinder by the quadratic in two dimensions: report D's way (row D1).
 *
 *   A = dx^2 + dz^2,  B = dx fx + dz fz,  C = fx^2 + fz^2 - R^2,  t = (-B -+ sqrt(B^2 - A C)) / A
 *
 * B^2 and A C share their leading digits where the wall is far away, as with the sphere.
 */
#include "lab/methods/cylinder.h"

/** Asks it. See #Method.run. @param question A #CylinderQuestion. @param[out] answer A
 * #CylinderAnswer. */
static void run(const void *question, void *answer) {
    const CylinderQuestion *q = question;
    real x = q->origin.x - q->base.x, z = q->origin.z - q->base.z;
    real dx = q->direction.x, dz = q->direction.z;
    real a = dx * dx + dz * dz, b = x * dx + z * dz, c = x * x + z * z - q->radius * q->radius;
    real discriminant = b * b - a * c;
    real root = real_sqrt(discriminant);
    real near = (-b - root) / a, far = (-b + root) / a;
    real ahead = near > 0 ? near : far > 0 ? far : INFINITE;
    CylinderAnswer *found = answer;
    found->distance = discriminant >= 0 ? ahead : INFINITE;
    found->count = (real)((discriminant >= 0) * ((near > 0) + (far > 0)));
}

const Method cylinder_wall_textbook = {.family = "cylinder-wall",
                                       .name = "B^2-AC",
                                       .label = "B^2-AC",
                                       .inputs = NUMBERS_OF(CylinderQuestion),
                                       .outputs = NUMBERS_OF(CylinderAnswer),
                                       .run = run};
