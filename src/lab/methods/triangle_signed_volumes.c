/**
 * @file
 * @brief Triangle by the signed volumes of the ray with its three edges (Kensler, Shirley,
 *        *Optimizing Ray-Triangle Intersection via Automated Search*, 2006).
 *
 *   w_ab = d.((a - P0) x (b - P0)) and so on; all of one sign: inside
 *
 * Two neighbours compute the same product for the edge that they share, with opposite signs, so
 * that no ray passes between them. At a corner three edges or more meet, and theirs do not agree.
 */
#include "lab/methods/triangle.h"

/** Asks it. See #Method.run. */
static void triangle_signed_volumes_run(const void *input, void *output) {
    const TriangleInput *in = input;
    Vec3 a = vec3_subtract(in->a, in->origin), b = vec3_subtract(in->b, in->origin);
    Vec3 c = vec3_subtract(in->c, in->origin), d = in->direction;
    real at_c = vec3_dot(d, triangle_cross(a, b)), at_a = vec3_dot(d, triangle_cross(b, c));
    real at_b = vec3_dot(d, triangle_cross(c, a)), sum = at_a + at_b + at_c;
    int is_inside = (at_a >= 0 && at_b >= 0 && at_c >= 0) || (at_a <= 0 && at_b <= 0 && at_c <= 0);
    Vec3 normal = triangle_cross(vec3_subtract(b, a), vec3_subtract(c, a));
    real t = vec3_dot(a, normal) / vec3_dot(d, normal);
    ((TriangleOutput *)output)->distance = is_inside && sum != 0 && t > 0 ? t : INFINITE;
}

const Method triangle_signed_volumes = {.group = "triangle",
                                        .name = "signed volumes",
                                        .label = "volumes",
                                        .input_count = NUMBERS_IN(TriangleInput),
                                        .output_count = NUMBERS_IN(TriangleOutput),
                                        .run = triangle_signed_volumes_run};
