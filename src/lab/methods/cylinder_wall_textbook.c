/**
 * @file
 * @brief The wall of a cylinder by the quadratic in two dimensions: report D's way (row D1).
 *
 *   A = dx^2 + dz^2,  B = dx fx + dz fz,  C = fx^2 + fz^2 - R^2,  t = (-B -+ sqrt(B^2 - A C)) / A
 *
 * B^2 and A C share their leading digits where the wall is far away, as with the sphere.
 */
#include "lab/methods/cylinder.h"

/** Asks it. See #Method.run. */
static void cylinder_wall_textbook_run(const void *input, void *output) {
    const CylinderInput *in = input;
    real x = in->origin.x - in->base.x, z = in->origin.z - in->base.z;
    real dx = in->direction.x, dz = in->direction.z;
    real a = dx * dx + dz * dz, b = x * dx + z * dz, c = x * x + z * z - in->radius * in->radius;
    real discriminant = b * b - a * c;
    real root = real_sqrt(discriminant);
    real near = (-b - root) / a, far = (-b + root) / a;
    real ahead = near > 0 ? near : far > 0 ? far : INFINITE;
    CylinderOutput *out = output;
    out->distance = discriminant >= 0 ? ahead : INFINITE;
    out->count = (real)((discriminant >= 0) * ((near > 0) + (far > 0)));
}

const Method cylinder_wall_textbook = {.group = "cylinder-wall",
                                       .name = "B^2-AC",
                                       .label = "B^2-AC",
                                       .input_count = NUMBERS_IN(CylinderInput),
                                       .output_count = NUMBERS_IN(CylinderOutput),
                                       .run = cylinder_wall_textbook_run};
