/**
 * @file
 * @brief Triangle by shear: watertight (Woop, Benthin, Wald, *Watertight Ray/Triangle
 *        Intersection*, JCGT 2013). The tracer's way.
 *
 * The corners are moved and sheared so that the ray runs along an axis from zero; on which side of
 * an edge it passes is the sign of a product of two plane vectors, which both neighbours compute
 * alike. A product that rounds to zero is computed again in the next better precision.
 */
#include "lab/methods/triangle.h"

/** A corner as the ray sees it. */
typedef struct ShearedVertex {
    real x; /**< Beside the ray. */
    real y; /**< Beside the ray, across x. */
    real z; /**< Along the ray. */
} ShearedVertex;

/**
 * @return A vector with its axes renamed in a circle, so that one becomes z.
 * @param axis  0, 1 or 2: what becomes z.
 */
static Vec3 triangle_permute_axes(Vec3 v, int axis) {
    return axis == 0 ? (Vec3){v.y, v.z, v.x} : axis == 1 ? (Vec3){v.z, v.x, v.y} : v;
}

/** @return The axis along which a direction goes farthest. */
static int triangle_main_axis(Vec3 d) {
    real x = real_abs(d.x), y = real_abs(d.y), z = real_abs(d.z);
    return x > y && x > z ? 0 : y > z ? 1 : 2;
}

/**
 * @return A corner as the ray sees it.
 * @param origin  Where the ray starts.
 * @param axis  How it was turned.
 */
static ShearedVertex triangle_shear_vertex(Vec3 corner, Vec3 origin, Vec3 d, int axis) {
    Vec3 v = triangle_permute_axes(vec3_subtract(corner, origin), axis);
    return (ShearedVertex){v.x - d.x / d.z * v.z, v.y - d.y / d.z * v.z, v.z / d.z};
}

/** @return On which side of an edge the ray passes. */
static real triangle_edge_function(ShearedVertex a, ShearedVertex b) {
    real triangle_edge_function = a.x * b.y - a.y * b.x;
    return triangle_edge_function == 0 ? narrow(widen(a.x) * widen(b.y) - widen(a.y) * widen(b.x))
                                       : triangle_edge_function;
}

/** Asks it. See #Method.run. */
static void triangle_watertight_run(const void *input, void *output) {
    const TriangleInput *in = input;
    int axis = triangle_main_axis(in->direction);
    Vec3 d = triangle_permute_axes(in->direction, axis);
    ShearedVertex a = triangle_shear_vertex(in->a, in->origin, d, axis),
                  b = triangle_shear_vertex(in->b, in->origin, d, axis);
    ShearedVertex c = triangle_shear_vertex(in->c, in->origin, d, axis);
    real at_a = triangle_edge_function(c, b), at_b = triangle_edge_function(a, c),
         at_c = triangle_edge_function(b, a), sum = at_a + at_b + at_c;
    int is_inside = (at_a >= 0 && at_b >= 0 && at_c >= 0) || (at_a <= 0 && at_b <= 0 && at_c <= 0);
    real t = (at_a * a.z + at_b * b.z + at_c * c.z) / sum;
    ((TriangleOutput *)output)->distance = is_inside && sum != 0 && t > 0 ? t : INFINITE;
}

const Method triangle_watertight = {.group = "triangle",
                                    .name = "watertight",
                                    .label = "watertight",
                                    .input_count = NUMBERS_IN(TriangleInput),
                                    .output_count = NUMBERS_IN(TriangleOutput),
                                    .run = triangle_watertight_run};
