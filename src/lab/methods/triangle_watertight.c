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
typedef struct Seen {
    real x; /**< Beside the ray. */
    real y; /**< Beside the ray, across x. */
    real z; /**< Along the ray. */
} Seen;

/** @return A vector with its axes renamed in a circle, so that one becomes z. @param v It.
 *  @param axis 0, 1 or 2: what becomes z. */
static Vector turn(Vector v, int axis) {
    return axis == 0 ? (Vector){v.y, v.z, v.x} : axis == 1 ? (Vector){v.z, v.x, v.y} : v;
}

/** @return The axis along which a direction goes farthest. @param d The direction. */
static int main_axis(Vector d) {
    real x = real_abs(d.x), y = real_abs(d.y), z = real_abs(d.z);
    return x > y && x > z ? 0 : y > z ? 1 : 2;
}

/** @return A corner as the ray sees it. @param corner The corner. @param origin Where the ray
 *  starts. @param d Which way, turned. @param axis How it was turned. */
static Seen see(Vector corner, Vector origin, Vector d, int axis) {
    Vector v = turn(vector_subtract(corner, origin), axis);
    return (Seen){v.x - d.x / d.z * v.z, v.y - d.y / d.z * v.z, v.z / d.z};
}

/** @return On which side of an edge the ray passes. @param a An end. @param b The other. */
static real side(Seen a, Seen b) {
    real side = a.x * b.y - a.y * b.x;
    return side == 0 ? narrow(widen(a.x) * widen(b.y) - widen(a.y) * widen(b.x)) : side;
}

/** Asks it. See #Method.run. @param question A #TriangleQuestion. @param[out] answer A
 * #TriangleAnswer. */
static void run(const void *question, void *answer) {
    const TriangleQuestion *q = question;
    int axis = main_axis(q->direction);
    Vector d = turn(q->direction, axis);
    Seen a = see(q->a, q->origin, d, axis), b = see(q->b, q->origin, d, axis);
    Seen c = see(q->c, q->origin, d, axis);
    real at_a = side(c, b), at_b = side(a, c), at_c = side(b, a), sum = at_a + at_b + at_c;
    int is_inside = (at_a >= 0 && at_b >= 0 && at_c >= 0) || (at_a <= 0 && at_b <= 0 && at_c <= 0);
    real t = (at_a * a.z + at_b * b.z + at_c * c.z) / sum;
    ((TriangleAnswer *)answer)->distance = is_inside && sum != 0 && t > 0 ? t : INFINITE;
}

const Method triangle_watertight = {.family = "triangle",
                                    .name = "watertight",
                                    .label = "watertight",
                                    .inputs = NUMBERS_OF(TriangleQuestion),
                                    .outputs = NUMBERS_OF(TriangleAnswer),
                                    .run = run};
