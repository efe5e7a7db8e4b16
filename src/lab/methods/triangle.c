/**
 * @file
 * @brief Where does a ray hit a triangle?
 *
 * In the formulas P0 is the ray's origin, d its direction, t the distance along the ray; a, b and c
 * are the vertices, u and v the barycentric coordinates of b and c.
 */
#include "lab/methods/family.h"

/** A ray and a triangle. */
typedef struct TriangleInput {
    Vec3 origin;    /**< Origin of the ray: P0. */
    Vec3 direction; /**< Direction: d. */
    Vec3 a;         /**< First vertex. */
    Vec3 b;         /**< Second vertex. */
    Vec3 c;         /**< Third vertex. */
    real rows[9];   /**< For Baldwin and Weber: of the transformation, three rows without the column
                         that is 0, 0, 1 or 1; computed in quad and rounded once. */
    real axis;      /**< That column: 0, 1 or 2. */
} TriangleInput;

/** The hit. */
typedef struct TriangleOutput {
    real distance; /**< In lengths of the direction; #INFINITE: the ray misses. */
} TriangleOutput;

/** @return The distance of a hit. */
static TriangleOutput triangle_output(int is_inside, real distance) {
    return (TriangleOutput){is_inside && distance > 0 ? distance : INFINITE};
}

/** @return a x b. */
static Vec3 triangle_cross(Vec3 a, Vec3 b) {
    return (Vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** @return The determinant of three columns. */
static real triangle_determinant(Vec3 a, Vec3 b, Vec3 c) {
    return a.x * (b.y * c.z - b.z * c.y) - b.x * (a.y * c.z - a.z * c.y) +
           c.x * (a.y * b.z - a.z * b.y);
}

/**
 * Cramer's rule, as in report A (doc/reports.md).
 *
 *   (b - a  c - a  -d) (u v t)' = P0 - a, each unknown as a quotient of two 3 x 3 determinants
 *
 * The two triangles of an edge compute its u, v or u + v from different differences and round them
 * differently: a ray at the edge may miss both.
 */
METHOD(triangle_cramer, TriangleInput, TriangleOutput) {
    Vec3 e1 = vec3_subtract(in->b, in->a), e2 = vec3_subtract(in->c, in->a);
    Vec3 s = vec3_subtract(in->origin, in->a), back = vec3_scale(in->direction, -1);
    real determinant = triangle_determinant(e1, e2, back);
    real u = triangle_determinant(s, e2, back) / determinant;
    real v = triangle_determinant(e1, s, back) / determinant;
    real t = triangle_determinant(e1, e2, s) / determinant;
    return triangle_output(determinant != 0 && u >= 0 && v >= 0 && u + v <= 1, t);
}

/** The unknowns of P0 + t d = a + u (b - a) + v (c - a). */
typedef struct TriangleSolution {
    real determinant; /**< Of the three equations; 0: the ray is parallel to the triangle. */
    real u;           /**< Barycentric coordinate of b. */
    real v;           /**< Barycentric coordinate of c. */
    real distance;    /**< t. */
} TriangleSolution;

/** @return The solution by four triple products (Möller, Trumbore, *Fast, Minimum Storage
 *  Ray/Triangle Intersection*, Journal of Graphics Tools 1997). */
static TriangleSolution triangle_moller_trumbore_solve(const TriangleInput *in) {
    Vec3 e1 = vec3_subtract(in->b, in->a), e2 = vec3_subtract(in->c, in->a);
    Vec3 p = triangle_cross(in->direction, e2), s = vec3_subtract(in->origin, in->a),
         r = triangle_cross(s, e1);
    real determinant = vec3_dot(e1, p), inverse = 1 / determinant;
    return (TriangleSolution){determinant, vec3_dot(s, p) * inverse,
                              vec3_dot(in->direction, r) * inverse, vec3_dot(e2, r) * inverse};
}

/**
 * Möller and Trumbore, edges and vertices included.
 *
 *   u >= 0,  v >= 0,  u + v <= 1
 *
 * Both triangles of an edge may still round the ray to their outside.
 */
METHOD(triangle_moller_trumbore, TriangleInput, TriangleOutput) {
    TriangleSolution s = triangle_moller_trumbore_solve(in);
    return triangle_output(s.determinant != 0 && s.u >= 0 && s.v >= 0 && s.u + s.v <= 1,
                           s.distance);
}

/**
 * Möller and Trumbore, edges and vertices excluded.
 *
 *   u > 0,  v > 0,  u + v < 1
 *
 * A ray exactly at an edge misses both triangles even without rounding.
 */
METHOD(triangle_moller_trumbore_strict, TriangleInput, TriangleOutput) {
    TriangleSolution s = triangle_moller_trumbore_solve(in);
    return triangle_output(s.determinant != 0 && s.u > 0 && s.v > 0 && s.u + s.v < 1, s.distance);
}

/**
 * Möller and Trumbore, the triangle slightly enlarged.
 *
 *   u >= -e,  v >= -e,  u + v <= 1 + e,  e = 1e-6
 *
 * The cure of many tutorials. Nothing leaks, but rays at edges hit both triangles, and e is one
 * constant for every size and distance.
 */
METHOD(triangle_moller_trumbore_tolerant, TriangleInput, TriangleOutput) {
    const real e = (scalar)1e-6f;
    TriangleSolution s = triangle_moller_trumbore_solve(in);
    return triangle_output(s.determinant != 0 && s.u >= -e && s.v >= -e && s.u + s.v <= 1 + e,
                           s.distance);
}

/**
 * Möller and Trumbore, small determinants rejected.
 *
 *   |det| > 1e-6,  u >= 0,  v >= 0,  u + v <= 1
 *
 * The determinant is twice the triangle's area, projected along the ray: small triangles are never
 * hit.
 */
METHOD(triangle_moller_trumbore_cutoff, TriangleInput, TriangleOutput) {
    TriangleSolution s = triangle_moller_trumbore_solve(in);
    return triangle_output(real_abs(s.determinant) > (scalar)1e-6f && s.u >= 0 && s.v >= 0 &&
                               s.u + s.v <= 1,
                           s.distance);
}

/** @return Whether three edge functions, one per edge, have the same sign. */
static int triangle_signs_agree(real at_a, real at_b, real at_c) {
    return (at_a >= 0 && at_b >= 0 && at_c >= 0) || (at_a <= 0 && at_b <= 0 && at_c <= 0);
}

/**
 * Signed volumes of the ray with the three edges (Kensler, Shirley, *Optimizing Ray-Triangle
 * Intersection via Automated Search*, 2006).
 *
 *   w_ab = d.((a - P0) x (b - P0)) and so on; the ray is inside where all have the same sign
 *
 * Two triangles compute the same product for a shared edge, with opposite signs, so that no ray
 * passes between them. At a vertex three or more edges meet, and their products do not agree.
 */
METHOD(triangle_signed_volumes, TriangleInput, TriangleOutput) {
    Vec3 a = vec3_subtract(in->a, in->origin), b = vec3_subtract(in->b, in->origin);
    Vec3 c = vec3_subtract(in->c, in->origin), d = in->direction;
    real at_c = vec3_dot(d, triangle_cross(a, b)), at_a = vec3_dot(d, triangle_cross(b, c));
    real at_b = vec3_dot(d, triangle_cross(c, a)), sum = at_a + at_b + at_c;
    Vec3 normal = triangle_cross(vec3_subtract(b, a), vec3_subtract(c, a));
    real t = vec3_dot(a, normal) / vec3_dot(d, normal);
    return triangle_output(triangle_signs_agree(at_a, at_b, at_c) && sum != 0, t);
}

/** A vertex in the ray's frame, where the ray starts at zero and runs along z. */
typedef struct ShearedVertex {
    real x; /**< Across the ray. */
    real y; /**< Across the ray and x. */
    real z; /**< Along the ray. */
} ShearedVertex;

/** @return A vector with its axes rotated cyclically. @param axis 0, 1 or 2: becomes z. */
static Vec3 triangle_permute_axes(Vec3 v, int axis) {
    return axis == 0 ? (Vec3){v.y, v.z, v.x} : axis == 1 ? (Vec3){v.z, v.x, v.y} : v;
}

/** @return The axis of a direction's largest component. */
static int triangle_main_axis(Vec3 d) {
    real x = real_abs(d.x), y = real_abs(d.y), z = real_abs(d.z);
    return x > y && x > z ? 0 : y > z ? 1 : 2;
}

/**
 * @return A vertex in the ray's frame.
 * @param origin  Origin of the ray.
 * @param d       Direction, permuted.
 * @param axis    The axis of d's largest component.
 */
static ShearedVertex triangle_shear_vertex(Vec3 vertex, Vec3 origin, Vec3 d, int axis) {
    Vec3 v = triangle_permute_axes(vec3_subtract(vertex, origin), axis);
    return (ShearedVertex){v.x - d.x / d.z * v.z, v.y - d.y / d.z * v.z, v.z / d.z};
}

/** @return The edge function at the ray: its sign is the side of the edge. */
static real triangle_edge_function(ShearedVertex a, ShearedVertex b) {
    real value = a.x * b.y - a.y * b.x;
    return value == 0 ? narrow(widen(a.x) * widen(b.y) - widen(a.y) * widen(b.x)) : value;
}

/**
 * Shear, watertight (Woop, Benthin, Wald, *Watertight Ray/Triangle Intersection*, JCGT 2013). The
 * tracer computes it so.
 *
 * The vertices are translated and sheared so that the ray runs along an axis from zero. The side of
 * an edge is the sign of a product of two plane vectors, equal in both triangles. A product that
 * rounds to zero is computed again in the next wider type.
 */
METHOD(triangle_watertight, TriangleInput, TriangleOutput) {
    int axis = triangle_main_axis(in->direction);
    Vec3 d = triangle_permute_axes(in->direction, axis);
    ShearedVertex a = triangle_shear_vertex(in->a, in->origin, d, axis),
                  b = triangle_shear_vertex(in->b, in->origin, d, axis);
    ShearedVertex c = triangle_shear_vertex(in->c, in->origin, d, axis);
    real at_a = triangle_edge_function(c, b), at_b = triangle_edge_function(a, c),
         at_c = triangle_edge_function(b, a), sum = at_a + at_b + at_c;
    real t = (at_a * a.z + at_b * b.z + at_c * c.z) / sum;
    return triangle_output(triangle_signs_agree(at_a, at_b, at_c) && sum != 0, t);
}

/** @return The product of a row of the transformation and a vector, but for the fourth column.
 *  @param v Permuted so that the fixed column is z. @param fixed Element of the fixed column. */
static real triangle_row_times(const real *row, Vec3 v, real fixed) {
    return row[0] * v.x + row[1] * v.y + fixed * v.z;
}

/**
 * By a transformation that was computed before (Baldwin, Weber, *Fast Ray-Triangle Intersections by
 * Coordinate Transformation*, JCGT 2016).
 *
 *   M takes a to (0, 0, 0), b to (1, 0, 0), c to (0, 1, 0) and the plane to z = 0; one of its
 * columns is 0, 0 and 1, whichever suits the largest component of the normal t = -z(P0) / z(d),  u
 * = x(P0) + t x(d),  v = y(P0) + t y(d)
 *
 * The fastest test, with 36 bytes more a triangle. Each triangle has a transformation of its own,
 * so its neighbour rounds the common edge differently: rays pass between them.
 */
METHOD(triangle_baldwin_weber, TriangleInput, TriangleOutput) {
    const int axis = (int)in->axis;
    Vec3 o = triangle_permute_axes(in->origin, axis),
         d = triangle_permute_axes(in->direction, axis);
    const real *x = in->rows, *y = x + 3, *z = y + 3;
    real t = -(triangle_row_times(z, o, 1) + z[2]) / triangle_row_times(z, d, 1);
    real u = triangle_row_times(x, o, 0) + x[2] + t * triangle_row_times(x, d, 0);
    real v = triangle_row_times(y, o, 0) + y[2] + t * triangle_row_times(y, d, 0);
    return triangle_output(u >= 0 && v >= 0 && u + v <= 1, t);
}

/**
 * Möller and Trumbore with two cross products (Quilez, `triIntersect` of his *Intersectors*, MIT
 * licence; see doc/references.md).
 *
 *   n = (b - a) x (c - a),  q = (P0 - a) x d,  D = 1 / d.n,  u = -D q.(c - a),  v = D q.(b - a),
 *   t = -D n.(P0 - a)
 */
METHOD(triangle_quilez, TriangleInput, TriangleOutput) {
    Vec3 e1 = vec3_subtract(in->b, in->a), e2 = vec3_subtract(in->c, in->a);
    Vec3 s = vec3_subtract(in->origin, in->a);
    Vec3 n = triangle_cross(e1, e2), q = triangle_cross(s, in->direction);
    real inverse = 1 / vec3_dot(in->direction, n);
    real u = inverse * -vec3_dot(q, e2), v = inverse * vec3_dot(q, e1);
    real t = inverse * -vec3_dot(n, s);
    return triangle_output(!(u < 0 || v < 0 || u + v > 1), t);
}

const MethodFamily triangle_family = {
    FAMILY("triangle", TriangleInput, TriangleOutput),
    (const Method[]){
        {"Cramer", "Cramer", triangle_cramer_run},
        {"Moeller-Trumbore", "Moeller-T.", triangle_moller_trumbore_run},
        {"Moeller-Trumbore strict", "M.-T. strict", triangle_moller_trumbore_strict_run},
        {"Moeller-Trumbore tolerant", "M.-T. tolerant", triangle_moller_trumbore_tolerant_run},
        {"Moeller-Trumbore with cut", "M.-T. with cut", triangle_moller_trumbore_cutoff_run},
        {"signed volumes", "volumes", triangle_signed_volumes_run},
        {"watertight", "watertight", triangle_watertight_run},
        {"Baldwin-Weber", "Baldwin-Weber", triangle_baldwin_weber_run},
        {"Quilez", "Quilez", triangle_quilez_run},
        {0}}};
