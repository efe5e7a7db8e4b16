/**
 * @file
 * @brief A closed cylinder as what two intervals of the ray have in common: between the roots of
 *        the wall, and between the planes of the ends. The tracer's way.
 *
 * A ray that starts inside is in both, and leaves where the first of them ends, once: no rounding
 * can open the rim.
 */
#include "lab/methods/cylinder.h"

/** Asks it. See #Method.run. */
static void cylinder_solid_interval_run(const void *input, void *output) {
    const CylinderInput *in = input;
    real x = in->origin.x - in->base.x, z = in->origin.z - in->base.z,
         y = in->origin.y - in->base.y;
    real dx = in->direction.x, dz = in->direction.z;
    real a = dx * dx + dz * dz, b = -(x * dx + z * dz), cross = dx * z - dz * x;
    real c = x * x + z * z - in->radius * in->radius;
    real discriminant = a * in->radius * in->radius - cross * cross;
    real root = real_sqrt(discriminant), sum = b > 0 ? b + root : b - root;
    real wall_near = b > 0 ? c / sum : sum / a, wall_far = b > 0 ? sum / a : c / sum;
    real bottom = -y / in->direction.y, top = (in->height - y) / in->direction.y;
    real near = real_max(wall_near, real_min(bottom, top));
    real far = real_min(wall_far, real_max(bottom, top));
    int is_met = discriminant >= 0 && near <= far && far > 0;
    CylinderOutput *out = output;
    out->distance = is_met ? (near > 0 ? near : far) : INFINITE;
    out->count = is_met ? (near > 0 ? 2 : 1) : 0;
}

const Method cylinder_solid_interval = {.group = "cylinder-solid",
                                        .name = "interval",
                                        .label = "interval",
                                        .input_count = NUMBERS_IN(CylinderInput),
                                        .output_count = NUMBERS_IN(CylinderOutput),
                                        .run = cylinder_solid_interval_run};
