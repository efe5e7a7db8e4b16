/**
 * @file
 * @brief The shapes of the contract tests, each with a reference in quad precision.
 *
 * The references share no code with the tracer. They use textbook formulas, which are accurate
 * enough in quad precision.
 */
#ifndef TESTS_CONTRACT_SHAPES_H
#define TESTS_CONTRACT_SHAPES_H

#include "testing.h"

/** A point or direction in quad precision. */
typedef struct Vec3qa {
    Quadruple component[3]; /**< Coordinates. */
} Vec3qa;

/** The expected result for a ray. */
typedef struct ExpectedHit {
    bool is_hit;   /**< Whether the ray hits the shape. */
    Quadruple t;   /**< Distance of the hit. */
    Vec3qa normal; /**< Outward unit normal. */
    Quadruple
        edge_margin; /**< Distance of the ray from the silhouette, relative to the shape's size. */
} ExpectedHit;

/** The tangent plane of a shape near a point. */
typedef struct TangentPlane {
    Quadruple distance; /**< Distance of the point from it. */
    Vec3qa normal;      /**< Its unit normal. */
} TangentPlane;

/** A shape under test. */
typedef struct ContractShape {
    const char *name;       /**< Its name in the table of errors. */
    const char *keyword;    /**< The shape's keyword. */
    const void *parameters; /**< Its parameters. */
    bool is_solid;          /**< Whether it encloses a volume. */
    double size;            /**< Its approximate radius. */
    double center[3];       /**< Its centre. */
    /** @return The expected result in quad precision. */
    ExpectedHit (*expected_hit)(const void *parameters, const RayQueryQuad *ray);
    /** @return The tangent plane of the shape near a point. */
    TangentPlane (*tangent)(const void *parameters, const Vec3qa *point);
    const Transform *transform; /**< Its transform; NULL: none. */
} ContractShape;

/* --- quad precision -------------------------------------------------------------------------- */

/** @return a - b. */
static Vec3qa vec3qa_subtract(Vec3qa a, Vec3qa b) {
    return (Vec3qa){{a.component[0] - b.component[0], a.component[1] - b.component[1],
                     a.component[2] - b.component[2]}};
}

/** @return a . b */
static Quadruple vec3qa_dot(Vec3qa a, Vec3qa b) {
    return a.component[0] * b.component[0] + a.component[1] * b.component[1] +
           a.component[2] * b.component[2];
}

/** @return a x b */
static Vec3qa vec3qa_cross(Vec3qa a, Vec3qa b) {
    return (Vec3qa){{a.component[1] * b.component[2] - a.component[2] * b.component[1],
                     a.component[2] * b.component[0] - a.component[0] * b.component[2],
                     a.component[0] * b.component[1] - a.component[1] * b.component[0]}};
}

/** @return v scaled to length 1. */
static Vec3qa vec3qa_normalize(Vec3qa v) {
    Quadruple length = quad_sqrt(vec3qa_dot(v, v));
    return (Vec3qa){{v.component[0] / length, v.component[1] / length, v.component[2] / length}};
}

/** @return A vector of doubles, exactly. */
static Vec3qa vec3qa_from_doubles(const double v[3]) {
    return (Vec3qa){{v[0], v[1], v[2]}};
}

/** @return A vector of quads. */
static Vec3qa vec3qa_from_quads(const Quadruple v[3]) {
    return (Vec3qa){{v[0], v[1], v[2]}};
}

/** @return origin + t direction */
static Vec3qa ray_point(const RayQueryQuad *ray, Quadruple t) {
    Vec3qa o = vec3qa_from_quads(ray->origin), d = vec3qa_from_quads(ray->direction);
    return (Vec3qa){{o.component[0] + t * d.component[0], o.component[1] + t * d.component[1],
                     o.component[2] + t * d.component[2]}};
}

/* --- sphere ---------------------------------------------------------------------------------- */

/** The layout of the scene language. */
typedef struct SphereSpec {
    double center[3]; /**< Centre. */
    double radius;    /**< Radius. */
} SphereSpec;

/** @return See #ContractShape.expected_hit. */
static ExpectedHit sphere_expected_hit(const void *parameters, const RayQueryQuad *ray) {
    const SphereSpec *s = parameters;
    Vec3qa f = vec3qa_subtract(vec3qa_from_quads(ray->origin), vec3qa_from_doubles(s->center)),
           d = vec3qa_from_quads(ray->direction);
    Quadruple r = s->radius, a = vec3qa_dot(d, d), b = vec3qa_dot(f, d),
              c = vec3qa_dot(f, f) - r * r;
    Quadruple discriminant = b * b - a * c;
    ExpectedHit expected = {.edge_margin = quad_abs(discriminant) / (a * r * r)};
    if (discriminant < 0) {
        return expected;
    }
    Quadruple root = quad_sqrt(discriminant), near = (-b - root) / a, far = (-b + root) / a;
    expected.t = near > 0 ? near : far;
    expected.is_hit = expected.t > 0;
    expected.normal = vec3qa_normalize(
        vec3qa_subtract(ray_point(ray, expected.t), vec3qa_from_doubles(s->center)));
    return expected;
}

/** @return See #ContractShape.tangent. */
static TangentPlane sphere_tangent(const void *parameters, const Vec3qa *point) {
    const SphereSpec *s = parameters;
    Vec3qa local = vec3qa_subtract(*point, vec3qa_from_doubles(s->center));
    return (TangentPlane){quad_abs(quad_sqrt(vec3qa_dot(local, local)) - s->radius),
                          vec3qa_normalize(local)};
}

/* --- plane and quad -------------------------------------------------------------------------- */

/** The layout of the scene language. */
typedef struct PlaneSpec {
    double point[3];  /**< A point. */
    double normal[3]; /**< The normal. */
} PlaneSpec;

/** @return The hit of a ray and a plane. */
static ExpectedHit flat_expected_hit(Vec3qa point, Vec3qa normal, const RayQueryQuad *ray) {
    Vec3qa n = vec3qa_normalize(normal), d = vec3qa_normalize(vec3qa_from_quads(ray->direction));
    Quadruple sine = vec3qa_dot(n, d), slope = vec3qa_dot(n, vec3qa_from_quads(ray->direction));
    ExpectedHit expected = {.edge_margin = quad_abs(sine), .normal = n};
    expected.t = slope != 0
                     ? vec3qa_dot(n, vec3qa_subtract(point, vec3qa_from_quads(ray->origin))) / slope
                     : -1;
    expected.is_hit = expected.t > 0;
    return expected;
}

/** @return See #ContractShape.expected_hit. */
static ExpectedHit plane_expected_hit(const void *parameters, const RayQueryQuad *ray) {
    const PlaneSpec *p = parameters;
    return flat_expected_hit(vec3qa_from_doubles(p->point), vec3qa_from_doubles(p->normal), ray);
}

/**
 * @return The plane itself.
 * @param point  The point near it.
 */
static TangentPlane flat_tangent(Vec3qa on, Vec3qa normal, const Vec3qa *point) {
    Vec3qa n = vec3qa_normalize(normal);
    return (TangentPlane){quad_abs(vec3qa_dot(n, vec3qa_subtract(*point, on))), n};
}

/** @return See #ContractShape.tangent. */
static TangentPlane plane_tangent(const void *parameters, const Vec3qa *point) {
    const PlaneSpec *p = parameters;
    return flat_tangent(vec3qa_from_doubles(p->point), vec3qa_from_doubles(p->normal), point);
}

/** The layout of the scene language. */
typedef struct QuadSpec {
    double corner[3]; /**< A corner. */
    double u[3];      /**< Edge to the next corner. */
    double v[3];      /**< Edge to the other adjacent corner. */
} QuadSpec;

/** @return The smaller of two numbers. */
static Quadruple quad_min(Quadruple a, Quadruple b) {
    return a < b ? a : b;
}

/** @return See #ContractShape.expected_hit. */
static ExpectedHit quad_expected_hit(const void *parameters, const RayQueryQuad *ray) {
    const QuadSpec *q = parameters;
    Vec3qa u = vec3qa_from_doubles(q->u), v = vec3qa_from_doubles(q->v), n = vec3qa_cross(u, v);
    ExpectedHit expected = flat_expected_hit(vec3qa_from_doubles(q->corner), n, ray);
    Vec3qa w = vec3qa_subtract(ray_point(ray, expected.t), vec3qa_from_doubles(q->corner));
    Quadruple a = vec3qa_dot(vec3qa_cross(w, v), n) / vec3qa_dot(n, n),
              b = vec3qa_dot(vec3qa_cross(u, w), n) / vec3qa_dot(n, n);
    Quadruple inside = quad_min(quad_min(a, 1 - a), quad_min(b, 1 - b));
    expected.is_hit = expected.is_hit && inside >= 0;
    expected.edge_margin = quad_min(expected.edge_margin, quad_abs(inside));
    return expected;
}

/** @return See #ContractShape.tangent. */
static TangentPlane quad_tangent(const void *parameters, const Vec3qa *point) {
    const QuadSpec *q = parameters;
    return flat_tangent(vec3qa_from_doubles(q->corner),
                        vec3qa_cross(vec3qa_from_doubles(q->u), vec3qa_from_doubles(q->v)), point);
}

/**
 * @return A result with its margin limited by the sine of the angle between ray and surface. At a
 *         small angle, rounding a rotated ray moves the hit point far.
 */
static ExpectedHit limit_grazing_margin(ExpectedHit expected, const RayQueryQuad *ray) {
    if (expected.is_hit) {
        Quadruple sine = quad_abs(
            vec3qa_dot(expected.normal, vec3qa_normalize(vec3qa_from_quads(ray->direction))));
        expected.edge_margin = quad_min(expected.edge_margin, sine);
    }
    return expected;
}

/* --- disk and triangle ----------------------------------------------------------------------- */

/** The layout of the scene language. */
typedef struct DiskSpec {
    double center[3]; /**< Centre. */
    double normal[3]; /**< The normal. */
    double radius;    /**< Radius. */
} DiskSpec;

/** @return See #ContractShape.expected_hit. */
static ExpectedHit disk_expected_hit(const void *parameters, const RayQueryQuad *ray) {
    const DiskSpec *d = parameters;
    ExpectedHit expected =
        flat_expected_hit(vec3qa_from_doubles(d->center), vec3qa_from_doubles(d->normal), ray);
    Vec3qa local = vec3qa_subtract(ray_point(ray, expected.t), vec3qa_from_doubles(d->center));
    Quadruple inside = 1 - quad_sqrt(vec3qa_dot(local, local)) / d->radius;
    expected.is_hit = expected.is_hit && inside >= 0;
    expected.edge_margin = quad_min(expected.edge_margin, quad_abs(inside));
    return expected;
}

/** @return See #ContractShape.tangent. */
static TangentPlane disk_tangent(const void *parameters, const Vec3qa *point) {
    const DiskSpec *d = parameters;
    return flat_tangent(vec3qa_from_doubles(d->center), vec3qa_from_doubles(d->normal), point);
}

/** The layout of the scene language. */
typedef struct TriangleSpec {
    double corners[3][3]; /**< The corners. */
    double normals[3][3]; /**< The vertex normals. */
    double uvs[3][2];     /**< The vertex (u, v) coordinates. */
    bool is_smooth;       /**< Whether #normals is used. */
    bool has_uvs;         /**< Whether #uvs is used. */
} TriangleSpec;

/** @return See #ContractShape.expected_hit. */
static ExpectedHit triangle_expected_hit(const void *parameters, const RayQueryQuad *ray) {
    const TriangleSpec *t = parameters;
    Vec3qa a = vec3qa_from_doubles(t->corners[0]),
           u = vec3qa_subtract(vec3qa_from_doubles(t->corners[1]), a);
    Vec3qa v = vec3qa_subtract(vec3qa_from_doubles(t->corners[2]), a), n = vec3qa_cross(u, v);
    ExpectedHit expected = flat_expected_hit(a, n, ray);
    Vec3qa w = vec3qa_subtract(ray_point(ray, expected.t), a);
    Quadruple b = vec3qa_dot(vec3qa_cross(w, v), n) / vec3qa_dot(n, n),
              c = vec3qa_dot(vec3qa_cross(u, w), n) / vec3qa_dot(n, n);
    Quadruple inside = quad_min(1 - b - c, quad_min(b, c));
    expected.is_hit = expected.is_hit && inside >= 0;
    expected.edge_margin = quad_min(expected.edge_margin, quad_abs(inside));
    return expected;
}

/** @return See #ContractShape.tangent. */
static TangentPlane triangle_tangent(const void *parameters, const Vec3qa *point) {
    const TriangleSpec *t = parameters;
    Vec3qa a = vec3qa_from_doubles(t->corners[0]);
    return flat_tangent(a,
                        vec3qa_cross(vec3qa_subtract(vec3qa_from_doubles(t->corners[1]), a),
                                     vec3qa_subtract(vec3qa_from_doubles(t->corners[2]), a)),
                        point);
}

/* --- cylinder -------------------------------------------------------------------------------- */

/** The layout of the scene language. */
typedef struct CylinderSpec {
    double base[3]; /**< Centre of one end. */
    double top[3];  /**< Centre of the other end. */
    double radius;  /**< Radius. */
    bool capped;    /**< Whether the ends are closed. */
} CylinderSpec;

/** A crossing of a ray with the wall or an end of a cylinder. */
typedef struct CylinderCandidate {
    Quadruple t; /**< Distance along the ray. */
    Quadruple
        edge_distance; /**< Distance inside the rim of that surface, in radii; negative: outside. */
    Vec3qa normal;     /**< The normal. */
} CylinderCandidate;

/** @return The component of v perpendicular to an axis. */
static Vec3qa reject_from_axis(Vec3qa v, Vec3qa axis) {
    Quadruple s = vec3qa_dot(v, axis);
    return vec3qa_subtract(
        v, (Vec3qa){{s * axis.component[0], s * axis.component[1], s * axis.component[2]}});
}

/** Keeps a candidate that is ahead, on the surface and nearer than the previous ones. */
static void keep_nearest(ExpectedHit *expected, const CylinderCandidate *candidate) {
    expected->edge_margin = quad_min(expected->edge_margin, quad_abs(candidate->edge_distance));
    if (candidate->t > 0 && candidate->edge_distance >= 0 &&
        (!expected->is_hit || candidate->t < expected->t)) {
        *expected = (ExpectedHit){true, candidate->t, candidate->normal, expected->edge_margin};
    }
}

/** Adds the candidates of both ends of a cylinder. @param length From base to top. */
static void keep_nearest_cap(const CylinderSpec *c, Vec3qa axis, Quadruple length,
                             const RayQueryQuad *ray, ExpectedHit *expected) {
    Vec3qa from_base =
               vec3qa_subtract(vec3qa_from_quads(ray->origin), vec3qa_from_doubles(c->base)),
           d = vec3qa_from_quads(ray->direction);
    Quadruple slope = vec3qa_dot(d, axis);
    for (int end = 0; end < 2 && slope != 0; end++) {
        CylinderCandidate it = {.t = (end * length - vec3qa_dot(from_base, axis)) / slope};
        Vec3qa local = reject_from_axis(
            vec3qa_subtract(ray_point(ray, it.t), vec3qa_from_doubles(c->base)), axis);
        it.edge_distance = 1 - quad_sqrt(vec3qa_dot(local, local)) / c->radius;
        int sign = end ? 1 : -1;
        it.normal = (Vec3qa){
            {sign * axis.component[0], sign * axis.component[1], sign * axis.component[2]}};
        keep_nearest(expected, &it);
    }
}

/** @return See #ContractShape.expected_hit: the nearest hit with the wall and the two ends. */
static ExpectedHit cylinder_expected_hit(const void *parameters, const RayQueryQuad *ray) {
    const CylinderSpec *cylinder = parameters;
    Vec3qa way = vec3qa_subtract(vec3qa_from_doubles(cylinder->top),
                                 vec3qa_from_doubles(cylinder->base)),
           axis = vec3qa_normalize(way);
    Quadruple length = quad_sqrt(vec3qa_dot(way, way)), r = cylinder->radius;
    Vec3qa o = reject_from_axis(
        vec3qa_subtract(vec3qa_from_quads(ray->origin), vec3qa_from_doubles(cylinder->base)), axis);
    Vec3qa d = reject_from_axis(vec3qa_from_quads(ray->direction), axis),
           whole = vec3qa_from_quads(ray->direction);
    Quadruple a = vec3qa_dot(d, d), b = vec3qa_dot(o, d), c = vec3qa_dot(o, o) - r * r,
              discriminant = b * b - a * c;
    // A ray nearly parallel to the axis has no defined hit with the wall.
    bool is_along = a <= vec3qa_dot(whole, whole) * (Quadruple)1e-50;
    ExpectedHit expected = {.edge_margin = is_along ? quad_abs(c) / (r * r)
                                                    : quad_abs(discriminant) / (a * r * r)};
    for (int sign = -1; sign <= 1 && discriminant >= 0 && !is_along; sign += 2) {
        CylinderCandidate it = {.t = (-b + sign * quad_sqrt(discriminant)) / a};
        Vec3qa local = vec3qa_subtract(ray_point(ray, it.t), vec3qa_from_doubles(cylinder->base));
        Quadruple height = vec3qa_dot(local, axis);
        it.edge_distance = quad_min(height, length - height) / r;
        it.normal = vec3qa_normalize(reject_from_axis(local, axis));
        keep_nearest(&expected, &it);
    }
    if (cylinder->capped) {
        keep_nearest_cap(cylinder, axis, length, ray, &expected);
    }
    return limit_grazing_margin(expected, ray);
}

/** @return See #ContractShape.tangent. */
static TangentPlane cylinder_tangent(const void *parameters, const Vec3qa *point) {
    const CylinderSpec *c = parameters;
    Vec3qa way = vec3qa_subtract(vec3qa_from_doubles(c->top), vec3qa_from_doubles(c->base)),
           axis = vec3qa_normalize(way);
    Vec3qa from_base = vec3qa_subtract(*point, vec3qa_from_doubles(c->base)),
           local = reject_from_axis(from_base, axis);
    TangentPlane wall = {quad_abs(quad_sqrt(vec3qa_dot(local, local)) - c->radius),
                         vec3qa_normalize(local)};
    Quadruple height = vec3qa_dot(from_base, axis);
    TangentPlane end = {
        quad_min(quad_abs(height), quad_abs(height - quad_sqrt(vec3qa_dot(way, way)))), axis};
    return c->capped && end.distance < wall.distance ? end : wall;
}

/* --- cone ------------------------------------------------------------------------------------ */

/** The layout of the scene language. */
typedef struct ConeSpec {
    double base[3];    /**< Centre of one end. */
    double top[3];     /**< Centre of the other end. */
    double radius;     /**< Radius at the base. */
    double top_radius; /**< Radius at the top. */
    bool capped;       /**< Whether the ends are closed. */
} ConeSpec;

/** A cone in quad precision. */
typedef struct ConeReference {
    Vec3qa base;        /**< Centre of the base. */
    Vec3qa axis;        /**< Unit vector to the top. */
    Quadruple length;   /**< From base to top. */
    Quadruple slope;    /**< Radius gained per length. */
    Quadruple radii[2]; /**< Radius at base and top. */
} ConeReference;

/** @return The cone of a description. */
static ConeReference cone_reference_of(const ConeSpec *cone) {
    Vec3qa base = vec3qa_from_doubles(cone->base);
    Vec3qa way = vec3qa_subtract(vec3qa_from_doubles(cone->top), base);
    Quadruple length = quad_sqrt(vec3qa_dot(way, way));
    return (ConeReference){base,
                           vec3qa_normalize(way),
                           length,
                           ((Quadruple)cone->top_radius - cone->radius) / length,
                           {cone->radius, cone->top_radius}};
}

/** @return The larger radius. */
static Quadruple cone_wide_radius(const ConeReference *cone) {
    return -quad_min(-cone->radii[0], -cone->radii[1]);
}

/** @return The normal of the wall. @param across From the axis to the point. */
static Vec3qa cone_wall_normal(const ConeReference *cone, Vec3qa across) {
    Vec3qa normal = vec3qa_normalize(across);
    for (int i = 0; i < 3; i++) {
        normal.component[i] -= cone->slope * cone->axis.component[i];
    }
    return vec3qa_normalize(normal);
}

/** Adds the candidate of a root of the wall's equation, if it is on the cone itself and not on its
 *  mirror image beyond the tip. */
static void keep_nearest_wall(const ConeReference *cone, const RayQueryQuad *ray, Quadruple t,
                              ExpectedHit *expected) {
    Vec3qa local = vec3qa_subtract(ray_point(ray, t), cone->base);
    Quadruple height = vec3qa_dot(local, cone->axis);
    Quadruple radius = cone->radii[0] + cone->slope * height;
    Quadruple inside = quad_min(quad_min(height, cone->length - height), radius);
    CylinderCandidate it = {.t = t, .edge_distance = inside / cone_wide_radius(cone)};
    it.normal = cone_wall_normal(cone, reject_from_axis(local, cone->axis));
    keep_nearest(expected, &it);
}

/** Adds the candidates of both ends of a cone. */
static void keep_nearest_cone_ends(const ConeReference *cone, const RayQueryQuad *ray,
                                   ExpectedHit *expected) {
    Vec3qa from_base = vec3qa_subtract(vec3qa_from_quads(ray->origin), cone->base);
    Quadruple slope = vec3qa_dot(vec3qa_from_quads(ray->direction), cone->axis);
    for (int end = 0; end < 2 && slope != 0; end++) {
        if (cone->radii[end] == 0) {
            continue;
        }
        CylinderCandidate it = {.t = (end * cone->length - vec3qa_dot(from_base, cone->axis)) /
                                     slope};
        Vec3qa across =
            reject_from_axis(vec3qa_subtract(ray_point(ray, it.t), cone->base), cone->axis);
        it.edge_distance =
            (cone->radii[end] - quad_sqrt(vec3qa_dot(across, across))) / cone_wide_radius(cone);
        for (int i = 0; i < 3; i++) {
            it.normal.component[i] = end ? cone->axis.component[i] : -cone->axis.component[i];
        }
        keep_nearest(expected, &it);
    }
}

/** @return See #ContractShape.expected_hit: the nearest hit with the wall and the two ends. */
static ExpectedHit cone_expected_hit(const void *parameters, const RayQueryQuad *ray) {
    ConeReference cone = cone_reference_of(parameters);
    Vec3qa from_base = vec3qa_subtract(vec3qa_from_quads(ray->origin), cone.base);
    Vec3qa direction = vec3qa_from_quads(ray->direction);
    Vec3qa o = reject_from_axis(from_base, cone.axis), d = reject_from_axis(direction, cone.axis);
    Quadruple radius = cone.radii[0] + cone.slope * vec3qa_dot(from_base, cone.axis);
    Quadruple widening = cone.slope * vec3qa_dot(direction, cone.axis);
    Quadruple a = vec3qa_dot(d, d) - widening * widening, b = vec3qa_dot(o, d) - radius * widening;
    Quadruple c = vec3qa_dot(o, o) - radius * radius, discriminant = b * b - a * c;
    Quadruple wide = cone_wide_radius(&cone), size = vec3qa_dot(d, d) + widening * widening;
    // A ray nearly parallel to the axis of a nearly cylindrical wall has no defined hit with it.
    bool is_along = size <= vec3qa_dot(direction, direction) * (Quadruple)1e-50;
    ExpectedHit expected = {.edge_margin = is_along
                                               ? quad_abs(c) / (wide * wide)
                                               : quad_abs(discriminant) / (size * wide * wide)};
    if (discriminant >= 0 && !is_along) {
        Quadruple root = quad_sqrt(discriminant), sum = b > 0 ? -b - root : -b + root;
        keep_nearest_wall(&cone, ray, sum / a, &expected);
        keep_nearest_wall(&cone, ray, c / sum, &expected);
    }
    if (((const ConeSpec *)parameters)->capped) {
        keep_nearest_cone_ends(&cone, ray, &expected);
    }
    return limit_grazing_margin(expected, ray);
}

/** @return See #ContractShape.tangent. */
static TangentPlane cone_tangent(const void *parameters, const Vec3qa *point) {
    ConeReference cone = cone_reference_of(parameters);
    Vec3qa from_base = vec3qa_subtract(*point, cone.base);
    Quadruple height = vec3qa_dot(from_base, cone.axis);
    Vec3qa across = reject_from_axis(from_base, cone.axis);
    Quadruple above = quad_sqrt(vec3qa_dot(across, across)) - (cone.radii[0] + cone.slope * height);
    TangentPlane wall = {quad_abs(above) / quad_sqrt(1 + cone.slope * cone.slope),
                         cone_wall_normal(&cone, across)};
    TangentPlane end = {quad_min(quad_abs(height), quad_abs(height - cone.length)), cone.axis};
    return ((const ConeSpec *)parameters)->capped && end.distance < wall.distance ? end : wall;
}

/* --- box ------------------------------------------------------------------------------------- */

/** The layout of the scene language. */
typedef struct BoxSpec {
    double low[3];  /**< Lowest corner. */
    double high[3]; /**< Highest corner. */
} BoxSpec;

/** @return See #ContractShape.expected_hit. */
static ExpectedHit box_expected_hit(const void *parameters, const RayQueryQuad *ray) {
    const BoxSpec *b = parameters;
    Quadruple near = -HUGE_VAL, far = HUGE_VAL, size = 0;
    int near_axis = 0, far_axis = 0;
    bool is_outside = false;
    for (int i = 0; i < 3; i++) {
        Quadruple o = ray->origin[i], d = ray->direction[i];
        size = quad_abs((Quadruple)b->high[i] - b->low[i]) + size;
        if (d == 0) {
            is_outside = is_outside || o < b->low[i] || o > b->high[i];
            continue;
        }
        Quadruple enter = ((d > 0 ? b->low[i] : b->high[i]) - o) / d;
        Quadruple leave = ((d > 0 ? b->high[i] : b->low[i]) - o) / d;
        near_axis = enter > near ? i : near_axis;
        near = enter > near ? enter : near;
        far_axis = leave < far ? i : far_axis;
        far = leave < far ? leave : far;
    }
    Vec3qa d = vec3qa_from_quads(ray->direction);
    Quadruple length = quad_sqrt(vec3qa_dot(d, d));
    ExpectedHit expected = {.is_hit = !is_outside && far > 0 && near <= far,
                            .edge_margin =
                                quad_min(quad_abs(far - near) * length / size,
                                         quad_abs(near > 0 ? near : far) * length / size)};
    int axis = near > 0 ? near_axis : far_axis;
    expected.t = near > 0 ? near : far;
    expected.normal.component[axis] = (ray->direction[axis] > 0) == (near > 0) ? -1 : 1;
    return expected;
}

/** @return See #ContractShape.tangent. */
static TangentPlane box_tangent(const void *parameters, const Vec3qa *point) {
    const BoxSpec *b = parameters;
    TangentPlane tangent = {.distance = HUGE_VAL};
    for (int i = 0; i < 3; i++) {
        Quadruple difference = quad_min(quad_abs(point->component[i] - b->low[i]),
                                        quad_abs(point->component[i] - b->high[i]));
        if (difference < tangent.distance) {
            tangent = (TangentPlane){.distance = difference};
            tangent.normal.component[i] = 1;
        }
    }
    return tangent;
}

/* --- transformed shapes ---------------------------------------------------------------------- */

/** A matrix in quad precision, and a translation applied after it. */
typedef struct AffineMap {
    Vec3qa row[3];      /**< Rows of the matrix. */
    Vec3qa translation; /**< The translation. */
} AffineMap;

/** @return The affine map of a shape; the identity without a transform. */
static AffineMap affine_of_shape(const ContractShape *shape) {
    AffineMap affine = {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}, {{0, 0, 0}}};
    const Transform *t = shape->transform;
    if (t) {
        for (int i = 0; i < 3; i++) {
            affine.row[i] = vec3qa_from_doubles(t->matrix[i]);
        }
        affine.translation = (Vec3qa){{t->translate.x, t->translate.y, t->translate.z}};
    }
    return affine;
}

/** @return The inverse matrix times a vector, by Cramer's rule. */
static Vec3qa apply_inverse(const AffineMap *affine, Vec3qa v) {
    const Vec3qa *m = affine->row;
    Vec3qa x = vec3qa_cross(m[1], m[2]), y = vec3qa_cross(m[2], m[0]), z = vec3qa_cross(m[0], m[1]);
    Quadruple determinant = vec3qa_dot(m[0], x);
    Vec3qa inverse;
    for (int i = 0; i < 3; i++) {
        inverse.component[i] = (x.component[i] * v.component[0] + y.component[i] * v.component[1] +
                                z.component[i] * v.component[2]) /
                               determinant;
    }
    return inverse;
}

/**
 * @return A normal transformed by the inverse transpose. Its length is the inverse of the factor by
 *         which distances from the plane are scaled.
 */
static Vec3qa transform_normal(const AffineMap *affine, Vec3qa n) {
    Vec3qa normal;
    for (int i = 0; i < 3; i++) {
        Vec3qa unit_vector = {{i == 0, i == 1, i == 2}};
        normal.component[i] = vec3qa_dot(n, apply_inverse(affine, unit_vector));
    }
    return normal;
}

/** @return The expected result for a ray and a shape with its transform. */
static ExpectedHit contract_expected_hit(const ContractShape *shape, const RayQueryQuad *ray) {
    if (!shape->transform) {
        return shape->expected_hit(shape->parameters, ray);
    }
    AffineMap affine = affine_of_shape(shape);
    Vec3qa origin =
        apply_inverse(&affine, vec3qa_subtract(vec3qa_from_quads(ray->origin), affine.translation));
    Vec3qa direction = apply_inverse(&affine, vec3qa_from_quads(ray->direction));
    RayQueryQuad inner;
    memcpy(inner.origin, origin.component, sizeof origin.component);
    memcpy(inner.direction, direction.component, sizeof direction.component);
    ExpectedHit expected = shape->expected_hit(shape->parameters, &inner);
    expected.normal = vec3qa_normalize(transform_normal(&affine, expected.normal));
    return limit_grazing_margin(expected, ray);
}

/** @return Distance of a point from a shape's surface. */
static Quadruple surface_distance(const ContractShape *shape, const Vec3qa *point) {
    AffineMap affine = affine_of_shape(shape);
    Vec3qa inner = apply_inverse(&affine, vec3qa_subtract(*point, affine.translation));
    TangentPlane tangent = shape->tangent(shape->parameters, &inner);
    Vec3qa normal = transform_normal(&affine, tangent.normal);
    return tangent.distance / quad_sqrt(vec3qa_dot(normal, normal));
}

/* --- the shapes ------------------------------------------------------------------------------- */

static const SphereSpec sphere_spec = {{0.5, -1.25, 2}, 1.5};
static const PlaneSpec plane_spec = {{0.25, -1, 3}, {0.5, 2, -0.25}};
static const QuadSpec quad_spec = {{-1, -0.5, 0.25}, {2, 0.5, 0.125}, {-0.25, 1.5, 0.5}};
static const BoxSpec box_spec = {{-1, 0.5, -2}, {0.75, 1.25, -0.5}};
static const DiskSpec disk_spec = {{0.5, -1.25, 2}, {0.25, 1, -0.5}, 1.5};
static const CylinderSpec cylinder_spec = {{0.5, -1.25, 2}, {1, 0.5, 1.25}, 0.75, true};
static const CylinderSpec pipe_spec = {{0.5, -1.25, 2}, {0.5, 0.5, 2}, 0.75, false};
static const ConeSpec cone_spec = {{0.5, -1.25, 2}, {1, 0.5, 1.25}, 1, 0, true};
static const ConeSpec frustum_spec = {{0.5, -1.25, 2}, {1, 0.5, 1.25}, 0.25, 1, true};
static const ConeSpec funnel_spec = {{0.5, -1.25, 2}, {0.5, 0.5, 2}, 0.875, 0.375, false};
static const TriangleSpec triangle_spec = {
    .corners = {{-1, -0.5, 0.25}, {1, 0, 0.5}, {-0.25, 1.5, 1}}};
static const SphereSpec small_sphere_spec = {{0.25, 0, 0}, 0.5};
static const CylinderSpec upright_cylinder_spec = {{0, -1, 0}, {0, 1, 0}, 1, true};
static const ConeSpec upright_cone_spec = {{0, -1, 0}, {0, 1, 0}, 1, 0.5, true};

/** Tolerance of the sphere traced shape. */
#define CONTRACT_TOLERANCE 0x1p-17

// Parameters of a scene; init_transforms() fills in the derived numbers.
static Transform ellipsoid_transform = {
    .scale = {3, 1.5, 2}, .rotate = {20, -35, 50}, .translate = {0.5, -1, 2}};
static Transform tilted_transform = {
    .scale = {1, 1, 1}, .rotate = {30, 45, 60}, .translate = {4, 3, -2}};
static Transform squeezed_transform = {
    .scale = {1, -0.75, 0.5}, .rotate = {0, 90, 15}, .translate = {1.0625, 0.96875, 1.03125}};
static Transform scaled_transform = {
    .scale = {2, 2, 2}, .rotate = {40, 0, 10}, .translate = {0, 1, 0}};

/** Every shape class is in this table; a test checks that. */
static const ContractShape contract_shapes[] = {
    {"sphere",
     "sphere",
     &sphere_spec,
     true,
     1.5,
     {0.5, -1.25, 2},
     sphere_expected_hit,
     sphere_tangent,
     NULL},
    {"plane",
     "plane",
     &plane_spec,
     false,
     1,
     {0.25, -1, 3},
     plane_expected_hit,
     plane_tangent,
     NULL},
    {"quad",
     "quad",
     &quad_spec,
     false,
     1,
     {-0.125, 0.5, 0.5},
     quad_expected_hit,
     quad_tangent,
     NULL},
    {"box", "box", &box_spec, true, 1, {-0.125, 0.875, -1.25}, box_expected_hit, box_tangent, NULL},
    {"disk",
     "disk",
     &disk_spec,
     false,
     1.5,
     {0.5, -1.25, 2},
     disk_expected_hit,
     disk_tangent,
     NULL},
    {"cylinder",
     "cylinder",
     &cylinder_spec,
     true,
     1,
     {0.75, -0.375, 1.625},
     cylinder_expected_hit,
     cylinder_tangent,
     NULL},
    {"pipe",
     "cylinder",
     &pipe_spec,
     false,
     1,
     {0.5, -0.375, 2},
     cylinder_expected_hit,
     cylinder_tangent,
     NULL},
    {"cone",
     "cone",
     &cone_spec,
     true,
     1,
     {0.625, -0.8125, 1.8125},
     cone_expected_hit,
     cone_tangent,
     NULL},
    {"frustum",
     "cone",
     &frustum_spec,
     true,
     1,
     {0.75, -0.375, 1.625},
     cone_expected_hit,
     cone_tangent,
     NULL},
    {"funnel",
     "cone",
     &funnel_spec,
     false,
     1,
     {0.5, -0.375, 2},
     cone_expected_hit,
     cone_tangent,
     NULL},
    {"squeezed cone",
     "cone",
     &upright_cone_spec,
     true,
     1,
     {1.0625, 0.96875, 1.09375},
     cone_expected_hit,
     cone_tangent,
     &squeezed_transform},
    {"triangle",
     "triangle",
     &triangle_spec,
     false,
     1,
     {-0.125, 0.25, 0.5},
     triangle_expected_hit,
     triangle_tangent,
     NULL},
    {"egg",
     "sphere",
     &small_sphere_spec,
     true,
     1,
     {1, -0.5, 1.75},
     sphere_expected_hit,
     sphere_tangent,
     &ellipsoid_transform},
    {"leaning box",
     "box",
     &box_spec,
     true,
     1,
     {4, 3, -1},
     box_expected_hit,
     box_tangent,
     &tilted_transform},
    {"squeezed cylinder",
     "cylinder",
     &upright_cylinder_spec,
     true,
     1,
     {1.0625, 0.96875, 1.09375},
     cylinder_expected_hit,
     cylinder_tangent,
     &squeezed_transform},
    // A box of twelve triangles, without and with a rotation.
    {"mesh",
     "mesh",
     &box_spec,
     true,
     1,
     {-0.125, 0.875, -1.25},
     box_expected_hit,
     box_tangent,
     NULL},
    {"leaning mesh",
     "mesh",
     &box_spec,
     true,
     1,
     {4, 3, -1},
     box_expected_hit,
     box_tangent,
     &tilted_transform},
    // A sphere as a distance field.
    {"sdf",
     "sdf",
     &sphere_spec,
     true,
     1.5,
     {0.5, -1.25, 2},
     sphere_expected_hit,
     sphere_tangent,
     NULL},
    {"tilted plane",
     "plane",
     &plane_spec,
     false,
     1,
     {0, 1, 3},
     plane_expected_hit,
     plane_tangent,
     &scaled_transform},
};

/** @return The tolerance of a sphere traced shape; 0: hits are analytic. */
static double tolerance_of(const ContractShape *shape) {
    return strcmp(shape->keyword, "sdf") == 0 ? CONTRACT_TOLERANCE : 0;
}

/** Number of shapes. */
enum { CONTRACT_SHAPE_COUNT = sizeof contract_shapes / sizeof *contract_shapes };

#endif
