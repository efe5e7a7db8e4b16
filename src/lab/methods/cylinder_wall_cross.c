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

/** Asks it. See #Method.run. */
static void cylinder_wall_cross_run(const void *input, void *output) {
    const CylinderInput *in = input;
    real x = in->origin.x - in->base.x, z = in->origin.z - in->base.z;
    real dx = in->direction.x, dz = in->direction.z;
    real a = dx * dx + dz * dz, b = -(x * dx + z * dz), cross = dx * z - dz * x;
    real c = x * x + z * z - in->radius * in->radius;
    real discriminant = a * in->radius * in->radius - cross * cross;
    real root = real_sqrt(discriminant), sum = b > 0 ? b + root : b - root;
    real near = b > 0 ? c / sum : sum / a, far = b > 0 ? sum / a : c / sum;
    real ahead = near > 0 ? near : far > 0 ? far : INFINITE;
    CylinderOutput *out = output;
    out->distance = discriminant >= 0 ? ahead : INFINITE;
    out->count = (real)((discriminant >= 0) * ((near > 0) + (far > 0)));
}

const Method cylinder_wall_cross = {.group = "cylinder-wall",
                                    .name = "cross product",
                                    .label = "cross product",
                                    .input_count = NUMBERS_IN(CylinderInput),
                                    .output_count = NUMBERS_IN(CylinderOutput),
                                    .run = cylinder_wall_cross_run};
