/**
 * @file
 * @brief A closed cylinder as three parts: a wall between two heights and two disks (row D1).
 *
 * Each part decides by its own rounded point whether it is met: at the rim all may say no, and the
 * ray leaks, or two say yes.
 */
#include "lab/methods/cylinder.h"

/** Takes a meeting. @param is_met Whether there is one. */
static void cylinder_keep_nearest(CylinderOutput *out, int is_met, real distance) {
    if (is_met && distance > 0) {
        out->count += 1;
        out->distance = real_min(distance, out->distance);
    }
}

/** Asks one end. @param height Of the end above the base. */
static void cylinder_intersect_cap(const CylinderInput *in, real height, CylinderOutput *out) {
    real t = (in->base.y + height - in->origin.y) / in->direction.y;
    Vec3 point = vec3_add(in->origin, vec3_scale(in->direction, t));
    real x = point.x - in->base.x, z = point.z - in->base.z;
    cylinder_keep_nearest(out, x * x + z * z <= in->radius * in->radius, t);
}

/** Asks the wall. @param t How far a root is. */
static void cylinder_intersect_wall(const CylinderInput *in, real t, CylinderOutput *out) {
    real y = in->origin.y + in->direction.y * t - in->base.y;
    cylinder_keep_nearest(out, y >= 0 && y <= in->height, t);
}

/** Asks it. See #Method.run. */
static void cylinder_solid_parts_run(const void *input, void *output) {
    const CylinderInput *in = input;
    CylinderOutput *out = output;
    *out = (CylinderOutput){.distance = INFINITE};
    real x = in->origin.x - in->base.x, z = in->origin.z - in->base.z;
    real dx = in->direction.x, dz = in->direction.z;
    real a = dx * dx + dz * dz, b = x * dx + z * dz, c = x * x + z * z - in->radius * in->radius;
    real root = real_sqrt(b * b - a * c);
    cylinder_intersect_wall(in, (-b - root) / a, out);
    cylinder_intersect_wall(in, (-b + root) / a, out);
    cylinder_intersect_cap(in, 0, out);
    cylinder_intersect_cap(in, in->height, out);
}

const Method cylinder_solid_parts = {.group = "cylinder-solid",
                                     .name = "three parts",
                                     .label = "three parts",
                                     .input_count = NUMBERS_IN(CylinderInput),
                                     .output_count = NUMBERS_IN(CylinderOutput),
                                     .run = cylinder_solid_parts_run};
