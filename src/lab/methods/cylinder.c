/**
 * @file
 * @brief Where does a ray first hit an upright cylinder: its wall alone, or closed by two disks?
 *
 * In the formulas (fx, fz) is the ray's origin relative to the axis, (dx, dz) its direction, and
 *
 *   A = dx^2 + dz^2,  B = dx fx + dz fz,  C = fx^2 + fz^2 - R^2
 */
#include "lab/methods/family.h"

/** A ray and a cylinder. */
typedef struct CylinderInput {
    Vec3 origin;    /**< Origin of the ray. */
    Vec3 direction; /**< Direction. */
    Vec3 base;      /**< Centre of the cylinder's base; the axis points up from there. */
    real radius;    /**< Radius. */
    real height;    /**< Height; not used by the wall alone. */
} CylinderInput;

/** The hits. */
typedef struct CylinderOutput {
    real distance; /**< The nearest hit ahead; #INFINITE: none. */
    real count;    /**< Hits ahead; from inside a closed cylinder it must be 1. */
} CylinderOutput;

/** @return Both hits with the wall. @param discriminant Below 0 or NaN: the ray misses. */
static CylinderOutput cylinder_wall_output(real discriminant, real near, real far) {
    return (CylinderOutput){discriminant >= 0 ? nearest_positive_root(near, far) : INFINITE,
                            (real)((discriminant >= 0) * ((near > 0) + (far > 0)))};
}

/**
 * Quadratic in two dimensions, as in report D (doc/reports.md).
 *
 *   t = (-B -+ sqrt(B^2 - A C)) / A
 *
 * B^2 and A C share their leading digits where the wall is far away, as with the sphere.
 */
METHOD(cylinder_wall_textbook, CylinderInput, CylinderOutput) {
    real x = in->origin.x - in->base.x, z = in->origin.z - in->base.z;
    real dx = in->direction.x, dz = in->direction.z;
    real a = dx * dx + dz * dz, b = x * dx + z * dz, c = x * x + z * z - in->radius * in->radius;
    real discriminant = b * b - a * c;
    real root = real_sqrt(discriminant);
    return cylinder_wall_output(discriminant, (-b - root) / a, (-b + root) / a);
}

/** The wall's two roots. */
typedef struct CylinderRoots {
    real discriminant; /**< Below 0 or NaN: the ray misses. */
    real near;         /**< The smaller root. */
    real far;          /**< The larger root. */
} CylinderRoots;

/**
 * @return The roots by a discriminant without cancellation.
 *
 *   D = A R^2 - (dx fz - dz fx)^2,  q = -B - sign(B) sqrt(D),  t = C / q and q / A
 *
 * The cross product is the distance between ray and axis: B^2 - A (fx^2 + fz^2) without a
 * difference of large numbers. The near root is a quotient.
 */
static CylinderRoots cylinder_stable_roots(const CylinderInput *in) {
    real x = in->origin.x - in->base.x, z = in->origin.z - in->base.z;
    real dx = in->direction.x, dz = in->direction.z;
    real a = dx * dx + dz * dz, b = -(x * dx + z * dz), cross = dx * z - dz * x;
    real c = x * x + z * z - in->radius * in->radius;
    real discriminant = a * in->radius * in->radius - cross * cross;
    real root = real_sqrt(discriminant), sum = b > 0 ? b + root : b - root;
    return (CylinderRoots){discriminant, b > 0 ? c / sum : sum / a, b > 0 ? sum / a : c / sum};
}

/** The wall by #cylinder_stable_roots, as the tracer computes it. */
METHOD(cylinder_wall_cross, CylinderInput, CylinderOutput) {
    CylinderRoots roots = cylinder_stable_roots(in);
    return cylinder_wall_output(roots.discriminant, roots.near, roots.far);
}

/** Adds a hit, if it is one and lies ahead. */
static void cylinder_keep_nearest(CylinderOutput *out, int is_hit, real distance) {
    if (is_hit && distance > 0) {
        out->count += 1;
        out->distance = real_min(distance, out->distance);
    }
}

/** Intersects a disk. @param height Of the disk above the base. */
static void cylinder_intersect_cap(const CylinderInput *in, real height, CylinderOutput *out) {
    real t = (in->base.y + height - in->origin.y) / in->direction.y;
    Vec3 point = vec3_add(in->origin, vec3_scale(in->direction, t));
    real x = point.x - in->base.x, z = point.z - in->base.z;
    cylinder_keep_nearest(out, x * x + z * z <= in->radius * in->radius, t);
}

/** Tests a root of the wall against the two ends. @param t The root. */
static void cylinder_intersect_wall(const CylinderInput *in, real t, CylinderOutput *out) {
    real y = in->origin.y + in->direction.y * t - in->base.y;
    cylinder_keep_nearest(out, y >= 0 && y <= in->height, t);
}

/**
 * A closed cylinder as three parts, a wall between two heights and two disks, as in report D.
 *
 * Each part tests its own rounded point. At the rim all may report a miss, and the ray leaks, or
 * two report a hit.
 */
METHOD(cylinder_solid_parts, CylinderInput, CylinderOutput) {
    CylinderOutput out = {.distance = INFINITE};
    real x = in->origin.x - in->base.x, z = in->origin.z - in->base.z;
    real dx = in->direction.x, dz = in->direction.z;
    real a = dx * dx + dz * dz, b = x * dx + z * dz, c = x * x + z * z - in->radius * in->radius;
    real root = real_sqrt(b * b - a * c);
    cylinder_intersect_wall(in, (-b - root) / a, &out);
    cylinder_intersect_wall(in, (-b + root) / a, &out);
    cylinder_intersect_cap(in, 0, &out);
    cylinder_intersect_cap(in, in->height, &out);
    return out;
}

/**
 * A closed cylinder as the intersection of two intervals of the ray: between the roots of the wall,
 * and between the planes of the ends. The tracer computes it so.
 *
 * A ray that starts inside is in both intervals and leaves where the first of them ends, once. No
 * rounding can open the rim.
 */
METHOD(cylinder_solid_interval, CylinderInput, CylinderOutput) {
    CylinderRoots wall = cylinder_stable_roots(in);
    real y = in->origin.y - in->base.y;
    real bottom = -y / in->direction.y, top = (in->height - y) / in->direction.y;
    real near = real_max(wall.near, real_min(bottom, top));
    real far = real_min(wall.far, real_max(bottom, top));
    int is_hit = wall.discriminant >= 0 && near <= far && far > 0;
    return (CylinderOutput){is_hit ? (near > 0 ? near : far) : INFINITE,
                            is_hit ? (near > 0 ? 2 : 1) : 0};
}

/**
 * A closed cylinder by one quadratic for any axis, and its ends where a root lies beyond them
 * (Quilez, `cylIntersect` of his *Intersectors*, MIT licence; see doc/references.md).
 *
 *   e = b - a,  f = P0 - a,  k2 = e.e - (e.d)^2,  k1 = e.e f.d - e.f e.d,
 *   k0 = e.e f.f - (e.f)^2 - R^2 e.e,  t = (-k1 -+ sqrt(k1^2 - k2 k0)) / k2
 *   an end: t = ((y < 0 ? 0 : e.e) - e.f) / e.d, where |k1 + k2 t| < sqrt(k1^2 - k2 k0)
 *
 * As he has it, only the first hit from outside; here each root and each end is tried. Squares of
 * squares are subtracted. At the rim each part rounds on its own, and equality is a miss for both.
 */
METHOD(cylinder_quilez, CylinderInput, CylinderOutput) {
    CylinderOutput out = {.distance = INFINITE};
    Vec3 e = {0, in->height, 0}, f = vec3_subtract(in->origin, in->base), d = in->direction;
    real ee = vec3_dot(e, e), ed = vec3_dot(e, d), ef = vec3_dot(e, f);
    real k2 = ee - ed * ed, k1 = ee * vec3_dot(f, d) - ef * ed;
    real k0 = ee * vec3_dot(f, f) - ef * ef - in->radius * in->radius * ee;
    real h = k1 * k1 - k2 * k0;
    if (h < 0) {
        return out;
    }
    real root = real_sqrt(h), near = (-k1 - root) / k2, far = (-k1 + root) / k2;
    real near_height = ef + near * ed, far_height = ef + far * ed; // In lengths of e, times e.
    cylinder_keep_nearest(&out, near_height > 0 && near_height < ee, near);
    cylinder_keep_nearest(&out, far_height > 0 && far_height < ee, far);
    real bottom = -ef / ed, top = (ee - ef) / ed;
    cylinder_keep_nearest(&out, real_abs(k1 + k2 * bottom) < root, bottom);
    cylinder_keep_nearest(&out, real_abs(k1 + k2 * top) < root, top);
    return out;
}

const MethodFamily cylinder_wall_family = {
    FAMILY("cylinder-wall", CylinderInput, CylinderOutput),
    (const Method[]){{"B^2-AC", "B^2-AC", cylinder_wall_textbook_run},
                     {"cross product", "cross product", cylinder_wall_cross_run},
                     {0}}};

const MethodFamily cylinder_solid_family = {
    FAMILY("cylinder-solid", CylinderInput, CylinderOutput),
    (const Method[]){{"three parts", "three parts", cylinder_solid_parts_run},
                     {"interval", "interval", cylinder_solid_interval_run},
                     {"Quilez", "Quilez", cylinder_quilez_run},
                     {0}}};
