/**
 * @file
 * @brief Triangle by Cramer's rule: report A's way (row A7).
 *
 *   (b - a  c - a  -d) (u v t)' = P0 - a, each unknown as a quotient of two 3 x 3 determinants
 *
 * The triangles on the two sides of an edge compute its u, v or u + v from different differences,
 * and round them differently: a ray at the edge may miss both.
 */
#include "lab/methods/triangle.h"

/** @return The determinant of three columns. */
static real triangle_determinant(Vec3 a, Vec3 b, Vec3 c) {
    return a.x * (b.y * c.z - b.z * c.y) - b.x * (a.y * c.z - a.z * c.y) +
           c.x * (a.y * b.z - a.z * b.y);
}

/** Asks it. See #Method.run. */
static void triangle_cramer_run(const void *input, void *output) {
    const TriangleInput *in = input;
    Vec3 e1 = vec3_subtract(in->b, in->a), e2 = vec3_subtract(in->c, in->a);
    Vec3 s = vec3_subtract(in->origin, in->a), back = vec3_scale(in->direction, -1);
    real determinant = triangle_determinant(e1, e2, back);
    real u = triangle_determinant(s, e2, back) / determinant;
    real v = triangle_determinant(e1, s, back) / determinant;
    real t = triangle_determinant(e1, e2, s) / determinant;
    int is_met = determinant != 0 && u >= 0 && v >= 0 && u + v <= 1 && t > 0;
    ((TriangleOutput *)output)->distance = is_met ? t : INFINITE;
}

const Method triangle_cramer = {.group = "triangle",
                                .name = "Cramer",
                                .label = "Cramer",
                                .input_count = NUMBERS_IN(TriangleInput),
                                .output_count = NUMBERS_IN(TriangleOutput),
                                .run = triangle_cramer_run};
