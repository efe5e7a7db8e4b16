/**
 * @file
 * @brief Where does a ray first hit a disk, a cone, an ellipsoid, a torus or a capsule?
 *
 * The formulas are those of Quilez, *Intersectors* (MIT licence; see doc/references.md), made for
 * shaders: short, for rays of length 1 that start outside. Each is also run from a point of the
 * same ray that is near the shape. In them o is the ray's origin and d its direction.
 */
#include "lab/methods/family.h"

/** A ray and a shape. */
typedef struct IntersectorInput {
    Vec3 origin;    /**< Origin of the ray, outside the shape: o. */
    Vec3 direction; /**< Direction, of length 1 but for rounding: d. */
    Vec3 a;         /**< Centre; of a cone and of a capsule the first end. */
    Vec3 b;         /**< Normal of a disk, half-axes of an ellipsoid, second end. */
    real radii[2];  /**< Radius, or both radii of a cone and of a torus. */
    real reach;     /**< No point of the shape is farther from #a. */
} IntersectorInput;

/** The hit. */
typedef struct IntersectorOutput {
    real distance; /**< In lengths of the direction; #INFINITE: the ray misses. */
} IntersectorOutput;

/** @return The distance, for another origin. */
typedef real IntersectorFunction(const IntersectorInput *in, Vec3 origin);

/** @return A distance, or #INFINITE where the ray misses. */
static real intersector_hit(int is_hit, real distance) {
    return is_hit ? distance : INFINITE;
}

/** @return The distance from a point of the ray that is just before the shape. */
static real intersector_from_near(const IntersectorInput *in, IntersectorFunction *intersect) {
    real before = vec3_dot(vec3_subtract(in->a, in->origin), in->direction) - in->reach;
    before = real_max(before, 0);
    return before + intersect(in, vec3_add(in->origin, vec3_scale(in->direction, before)));
}

/** `diskIntersect`: t = -n.(o - c) / n.d, where |o - c + t d| < r. */
static real intersector_disk(const IntersectorInput *in, Vec3 origin) {
    Vec3 o = vec3_subtract(origin, in->a);
    real t = -vec3_dot(in->b, o) / vec3_dot(in->direction, in->b);
    Vec3 q = vec3_add(o, vec3_scale(in->direction, t));
    return intersector_hit(vec3_dot(q, q) < in->radii[0] * in->radii[0], t);
}

/** `coneIntersect`: the end on the ray's side, then a quadratic for the slope, between the ends. */
static real intersector_cone(const IntersectorInput *in, Vec3 origin) {
    Vec3 d = in->direction, ba = vec3_subtract(in->b, in->a);
    Vec3 oa = vec3_subtract(origin, in->a), ob = vec3_subtract(origin, in->b);
    real ra = in->radii[0], rb = in->radii[1];
    real m0 = vec3_dot(ba, ba), m1 = vec3_dot(oa, ba), m2 = vec3_dot(d, ba), m3 = vec3_dot(d, oa);
    real m5 = vec3_dot(oa, oa), m9 = vec3_dot(ob, ba);
    if (m1 < 0) {
        Vec3 q = vec3_subtract(vec3_scale(oa, m2), vec3_scale(d, m1));
        if (vec3_dot(q, q) < ra * ra * m2 * m2) {
            return intersector_hit(m2 > 0, -m1 / m2);
        }
    } else if (m9 > 0) {
        real t = -m9 / m2;
        Vec3 q = vec3_add(ob, vec3_scale(d, t));
        if (vec3_dot(q, q) < rb * rb) {
            return intersector_hit(t > 0, t);
        }
    }
    real rr = ra - rb, hy = m0 + rr * rr;
    real k2 = m0 * m0 - m2 * m2 * hy, k1 = m0 * m0 * m3 - m1 * m2 * hy + m0 * ra * rr * m2;
    real k0 = m0 * m0 * m5 - m1 * m1 * hy + m0 * ra * (rr * m1 * 2 - m0 * ra);
    real h = k1 * k1 - k2 * k0, t = (-k1 - real_sqrt(h)) / k2, y = m1 + t * m2;
    return intersector_hit(h >= 0 && y >= 0 && y <= m0 && t > 0, t);
}

/** `eliIntersect`: a unit sphere in space that is divided by the half-axes. */
static real intersector_ellipsoid(const IntersectorInput *in, Vec3 origin) {
    Vec3 s = vec3_subtract(origin, in->a), d = in->direction, r = in->b;
    Vec3 o = {s.x / r.x, s.y / r.y, s.z / r.z}, n = {d.x / r.x, d.y / r.y, d.z / r.z};
    real a = vec3_dot(n, n), b = vec3_dot(o, n), h = b * b - a * (vec3_dot(o, o) - 1);
    real t = (-b - real_sqrt(h)) / a;
    return intersector_hit(h >= 0 && t > 0, t);
}

/** `capIntersect`: the wall's quadratic, then the sphere at the end beyond which the root lies. */
static real intersector_capsule(const IntersectorInput *in, Vec3 origin) {
    Vec3 d = in->direction, ba = vec3_subtract(in->b, in->a), oa = vec3_subtract(origin, in->a);
    real r = in->radii[0], baba = vec3_dot(ba, ba), bard = vec3_dot(ba, d);
    real baoa = vec3_dot(ba, oa), a = baba - bard * bard;
    real b = baba * vec3_dot(d, oa) - baoa * bard;
    real c = baba * vec3_dot(oa, oa) - baoa * baoa - r * r * baba, h = b * b - a * c;
    real t = (-b - real_sqrt(h)) / a, y = baoa + t * bard;
    if (!(h >= 0)) {
        return INFINITE;
    }
    if (y > 0 && y < baba) {
        return intersector_hit(t > 0, t);
    }
    Vec3 oc = y <= 0 ? oa : vec3_subtract(origin, in->b);
    b = vec3_dot(d, oc);
    h = b * b - (vec3_dot(oc, oc) - r * r);
    t = -b - real_sqrt(h);
    return intersector_hit(h > 0 && t > 0, t);
}

/** The quartic of a torus, t^4 + 4 k3 t^3 + 4 k2 t^2 + 8 k1 t + 4 k0. */
typedef struct TorusQuartic {
    real k3;     /**< Of t^3. */
    real k2;     /**< Of t^2. */
    real k1;     /**< Of t. */
    real k0;     /**< The constant. */
    int inverse; /**< Whether its roots are 2 / t. */
} TorusQuartic;

/** Keeps a root that lies ahead and is nearer. */
static void torus_keep(const TorusQuartic *quartic, real root, real *nearest) {
    real t = root - quartic->k3;
    t = quartic->inverse ? 2 / t : t;
    *nearest = t > 0 && t < *nearest ? t : *nearest;
}

/** @return The quartic of a torus around the z axis. */
static TorusQuartic torus_quartic(const IntersectorInput *in, Vec3 origin) {
    Vec3 o = vec3_subtract(origin, in->a), d = in->direction;
    real major = in->radii[0] * in->radii[0], minor = in->radii[1] * in->radii[1];
    real n = vec3_dot(o, d), k = (vec3_dot(o, o) - minor + major) / 2;
    return (TorusQuartic){.k3 = n,
                          .k2 = n * n + k - major * (d.x * d.x + d.y * d.y),
                          .k1 = n * k - major * (d.x * o.x + d.y * o.y),
                          .k0 = k * k - major * (o.x * o.x + o.y * o.y)};
}

/** `torIntersect`: Ferrari's solution of the quartic, or of that of 1 / t where it would divide by
 *  about zero. */
static real intersector_torus(const IntersectorInput *in, Vec3 origin) {
    TorusQuartic q = torus_quartic(in, origin);
    real nearest = INFINITE;
    if (real_abs(q.k3 * (q.k3 * q.k3 - q.k2) + q.k1) < (scalar)0.01f) {
        real per_k0 = 1 / q.k0;
        q = (TorusQuartic){q.k1 * per_k0, q.k2 * per_k0, q.k3 * per_k0, per_k0, 1};
    }
    real c2 = (q.k2 * 2 - 3 * q.k3 * q.k3) / 3, c1 = 2 * (q.k3 * (q.k3 * q.k3 - q.k2) + q.k1);
    real c0 = (q.k3 * (q.k3 * (3 * c2 + 2 * q.k2) - 8 * q.k1) + 4 * q.k0) / 3;
    real big = c2 * c2 + c0, half = c2 * c2 * c2 - 3 * c2 * c0 + c1 * c1;
    real h = half * half - big * big * big;
    if (h >= 0) {
        real root = real_sqrt(h), v = real_cbrt(half + root), u = real_cbrt(half - root);
        real s = v + u + 4 * c2, w = (v - u) * real_sqrt(3);
        real y = real_sqrt((real_sqrt(s * s + w * w) + s) / 2), x = w / (2 * y);
        real r = 2 * c1 / (x * x + y * y);
        torus_keep(&q, x - r, &nearest);
        torus_keep(&q, -x - r, &nearest);
        return nearest;
    }
    real root = real_sqrt(big), w = root * real_cos(real_acos(-half / (root * big)) / 3);
    real d2 = -(w + c2), d1 = real_sqrt(d2);
    real h1 = real_sqrt(w - 2 * c2 + c1 / d1), h2 = real_sqrt(w - 2 * c2 - c1 / d1);
    torus_keep(&q, -d1 - h1, &nearest); // NaN is not kept.
    torus_keep(&q, -d1 + h1, &nearest);
    torus_keep(&q, d1 - h2, &nearest);
    torus_keep(&q, d1 + h2, &nearest);
    return nearest;
}

/** Defines a family of a shape: its formula as it stands, and from near. */
#define INTERSECTOR_FAMILY(shape)                                                                  \
    METHOD(intersector_##shape##_plain, IntersectorInput, IntersectorOutput) {                     \
        return (IntersectorOutput){intersector_##shape(in, in->origin)};                           \
    }                                                                                              \
    METHOD(intersector_##shape##_near, IntersectorInput, IntersectorOutput) {                      \
        return (IntersectorOutput){intersector_from_near(in, intersector_##shape)};                \
    }                                                                                              \
    const MethodFamily intersector_##shape##_family = {                                            \
        FAMILY(#shape, IntersectorInput, IntersectorOutput),                                       \
        (const Method[]){{"Quilez", "Quilez", intersector_##shape##_plain_run},                    \
                         {"Quilez from near", "from near", intersector_##shape##_near_run},        \
                         {0}}};

INTERSECTOR_FAMILY(disk)
INTERSECTOR_FAMILY(cone)
INTERSECTOR_FAMILY(ellipsoid)
INTERSECTOR_FAMILY(torus)
INTERSECTOR_FAMILY(capsule)
