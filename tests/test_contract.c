/**
 * @file
 * @brief The contract that every shape keeps in every engine.
 *
 * One table-driven suite: a row a shape, with a reference in quad precision that shares no code
 * with the tracer. Each case is run for every row in every engine, and the worst error of each is
 * printed as a table. All rays and parameters are exact in float, so that every engine is asked the
 * same question.
 */
#include "testing.h"

#include <stdlib.h>

/** Rays of each case. */
enum { RAYS = 20000 };
/** Rays that leave a surface. */
enum { LEAVING_RAYS = 1000 };

/** Margin below which a ray grazes: for a sphere, 0.98 radii beside the centre (doc/tour.md). */
#define GRAZING 0.04

/** A point or direction in quad precision. */
typedef struct Quad3 {
    Quadruple c[3]; /**< Coordinates. */
} Quad3;

/** What the reference says of a ray. */
typedef struct Truth {
    bool is_hit;      /**< Whether the shape is met. */
    Quadruple t;      /**< Where. */
    Quad3 normal;     /**< Outward unit normal. */
    Quadruple margin; /**< How far, as a share of the shape's size, from missing (or meeting) it. */
} Truth;

/** The plane that touches a shape next to a point. */
typedef struct Touch {
    Quadruple off; /**< How far the point is off it. */
    Quad3 normal;  /**< Its unit normal. */
} Touch;

/** A row: a shape under test. */
typedef struct Row {
    const char *name;       /**< Its name in the table of errors. */
    const char *keyword;    /**< The shape's keyword. */
    const void *parameters; /**< Its parameters. */
    bool is_solid;          /**< Whether it has an inside. */
    double size;            /**< Its radius, about. */
    double center[3];       /**< Its middle. */
    /** @return What quad precision says. @param parameters The shape. @param ray The ray. */
    Truth (*truth)(const void *parameters, const RayQuery *ray);
    /** @return The plane next to a point that touches the shape. @param parameters The shape.
     *  @param point The point. */
    Touch (*touch)(const void *parameters, const Quad3 *point);
    const Transform *transform; /**< What becomes of it; NULL: nothing. */
} Row;

/* --- quad precision -------------------------------------------------------------------------- */

/** @return a - b. @param a A point. @param b A point. */
static Quad3 minus(Quad3 a, Quad3 b) {
    return (Quad3){{a.c[0] - b.c[0], a.c[1] - b.c[1], a.c[2] - b.c[2]}};
}

/** @return a . b @param a A vector. @param b A vector. */
static Quadruple dot(Quad3 a, Quad3 b) {
    return a.c[0] * b.c[0] + a.c[1] * b.c[1] + a.c[2] * b.c[2];
}

/** @return a x b @param a A vector. @param b A vector. */
static Quad3 cross(Quad3 a, Quad3 b) {
    return (Quad3){{a.c[1] * b.c[2] - a.c[2] * b.c[1], a.c[2] * b.c[0] - a.c[0] * b.c[2],
                    a.c[0] * b.c[1] - a.c[1] * b.c[0]}};
}

/** @return v one long. @param v A vector. */
static Quad3 unit(Quad3 v) {
    Quadruple length = quad_sqrt(dot(v, v));
    return (Quad3){{v.c[0] / length, v.c[1] / length, v.c[2] / length}};
}

/** @return A vector exactly. @param v Three numbers. */
static Quad3 quad3(const double v[3]) {
    return (Quad3){{v[0], v[1], v[2]}};
}

/** @return A vector. @param v Three numbers. */
static Quad3 quad3_of(const Quadruple v[3]) {
    return (Quad3){{v[0], v[1], v[2]}};
}

/** @return origin + t direction @param ray The ray. @param t How far. */
static Quad3 along(const RayQuery *ray, Quadruple t) {
    Quad3 o = quad3_of(ray->origin), d = quad3_of(ray->direction);
    return (Quad3){{o.c[0] + t * d.c[0], o.c[1] + t * d.c[1], o.c[2] + t * d.c[2]}};
}

/* --- sphere ---------------------------------------------------------------------------------- */

/** As the scene language says it. */
typedef struct SphereRow {
    double center[3]; /**< Centre. */
    double radius;    /**< Radius. */
} SphereRow;

/** @return See #Row.truth. @param parameters The sphere. @param ray The ray. */
static Truth sphere_truth(const void *parameters, const RayQuery *ray) {
    const SphereRow *s = parameters;
    Quad3 f = minus(quad3_of(ray->origin), quad3(s->center)), d = quad3_of(ray->direction);
    Quadruple r = s->radius, a = dot(d, d), b = dot(f, d), c = dot(f, f) - r * r;
    Quadruple discriminant = b * b - a * c;
    Truth truth = {.margin = quad_abs(discriminant) / (a * r * r)};
    if (discriminant < 0) {
        return truth;
    }
    Quadruple root = quad_sqrt(discriminant), near = (-b - root) / a, far = (-b + root) / a;
    truth.t = near > 0 ? near : far;
    truth.is_hit = truth.t > 0;
    truth.normal = unit(minus(along(ray, truth.t), quad3(s->center)));
    return truth;
}

/** @return See #Row.touch. @param parameters The sphere. @param point The point. */
static Touch sphere_touch(const void *parameters, const Quad3 *point) {
    const SphereRow *s = parameters;
    Quad3 arm = minus(*point, quad3(s->center));
    return (Touch){quad_abs(quad_sqrt(dot(arm, arm)) - s->radius), unit(arm)};
}

/* --- plane and quad -------------------------------------------------------------------------- */

/** As the scene language says it. */
typedef struct PlaneRow {
    double point[3];  /**< A point. */
    double normal[3]; /**< The normal. */
} PlaneRow;

/** @return Where a ray meets a plane. @param point A point. @param normal Its normal.
 *  @param ray The ray. */
static Truth flat_truth(Quad3 point, Quad3 normal, const RayQuery *ray) {
    Quad3 n = unit(normal), d = unit(quad3_of(ray->direction));
    Quadruple sine = dot(n, d), slope = dot(n, quad3_of(ray->direction));
    Truth truth = {.margin = quad_abs(sine), .normal = n};
    truth.t = slope != 0 ? dot(n, minus(point, quad3_of(ray->origin))) / slope : -1;
    truth.is_hit = truth.t > 0;
    return truth;
}

/** @return See #Row.truth. @param parameters The plane. @param ray The ray. */
static Truth plane_truth(const void *parameters, const RayQuery *ray) {
    const PlaneRow *p = parameters;
    return flat_truth(quad3(p->point), quad3(p->normal), ray);
}

/** @return The plane itself. @param on A point of it. @param normal Its normal.
 *  @param point The point next to it. */
static Touch flat_touch(Quad3 on, Quad3 normal, const Quad3 *point) {
    Quad3 n = unit(normal);
    return (Touch){quad_abs(dot(n, minus(*point, on))), n};
}

/** @return See #Row.touch. @param parameters The plane. @param point The point. */
static Touch plane_touch(const void *parameters, const Quad3 *point) {
    const PlaneRow *p = parameters;
    return flat_touch(quad3(p->point), quad3(p->normal), point);
}

/** As the scene language says it. */
typedef struct QuadRow {
    double corner[3]; /**< A corner. */
    double u[3];      /**< To the next. */
    double v[3];      /**< To the other next. */
} QuadRow;

/** @return The smaller. @param a A number. @param b Another. */
static Quadruple smaller(Quadruple a, Quadruple b) {
    return a < b ? a : b;
}

/** @return See #Row.truth. @param parameters The quad. @param ray The ray. */
static Truth quad_truth(const void *parameters, const RayQuery *ray) {
    const QuadRow *q = parameters;
    Quad3 u = quad3(q->u), v = quad3(q->v), n = cross(u, v);
    Truth truth = flat_truth(quad3(q->corner), n, ray);
    Quad3 w = minus(along(ray, truth.t), quad3(q->corner));
    Quadruple a = dot(cross(w, v), n) / dot(n, n), b = dot(cross(u, w), n) / dot(n, n);
    Quadruple inside = smaller(smaller(a, 1 - a), smaller(b, 1 - b));
    truth.is_hit = truth.is_hit && inside >= 0;
    truth.margin = smaller(truth.margin, quad_abs(inside));
    return truth;
}

/** @return See #Row.touch. @param parameters The quad. @param point The point. */
static Touch quad_touch(const void *parameters, const Quad3 *point) {
    const QuadRow *q = parameters;
    return flat_touch(quad3(q->corner), cross(quad3(q->u), quad3(q->v)), point);
}

/** @return A truth whose margin is no larger than the sine of the angle at which the ray meets the
 *          surface: where that is small, the last bit of a ray that was turned moves the point far.
 *  @param truth The truth. @param ray The ray. */
static Truth truth_grazing(Truth truth, const RayQuery *ray) {
    if (truth.is_hit) {
        Quadruple sine = quad_abs(dot(truth.normal, unit(quad3_of(ray->direction))));
        truth.margin = smaller(truth.margin, sine);
    }
    return truth;
}

/* --- disk and triangle ----------------------------------------------------------------------- */

/** As the scene language says it. */
typedef struct DiskRow {
    double center[3]; /**< Centre. */
    double normal[3]; /**< The normal. */
    double radius;    /**< Radius. */
} DiskRow;

/** @return See #Row.truth. @param parameters The disk. @param ray The ray. */
static Truth disk_truth(const void *parameters, const RayQuery *ray) {
    const DiskRow *d = parameters;
    Truth truth = flat_truth(quad3(d->center), quad3(d->normal), ray);
    Quad3 arm = minus(along(ray, truth.t), quad3(d->center));
    Quadruple inside = 1 - quad_sqrt(dot(arm, arm)) / d->radius;
    truth.is_hit = truth.is_hit && inside >= 0;
    truth.margin = smaller(truth.margin, quad_abs(inside));
    return truth;
}

/** @return See #Row.touch. @param parameters The disk. @param point The point. */
static Touch disk_touch(const void *parameters, const Quad3 *point) {
    const DiskRow *d = parameters;
    return flat_touch(quad3(d->center), quad3(d->normal), point);
}

/** As the scene language says it. */
typedef struct TriangleRow {
    double corners[3][3]; /**< The corners. */
    double normals[3][3]; /**< The normals there. */
    double places[3][2];  /**< The places there. */
    bool is_smooth;       /**< Whether the normals count. */
    bool has_places;      /**< Whether the places do. */
} TriangleRow;

/** @return See #Row.truth. @param parameters The triangle. @param ray The ray. */
static Truth triangle_truth(const void *parameters, const RayQuery *ray) {
    const TriangleRow *t = parameters;
    Quad3 a = quad3(t->corners[0]), u = minus(quad3(t->corners[1]), a);
    Quad3 v = minus(quad3(t->corners[2]), a), n = cross(u, v);
    Truth truth = flat_truth(a, n, ray);
    Quad3 w = minus(along(ray, truth.t), a);
    Quadruple b = dot(cross(w, v), n) / dot(n, n), c = dot(cross(u, w), n) / dot(n, n);
    Quadruple inside = smaller(1 - b - c, smaller(b, c));
    truth.is_hit = truth.is_hit && inside >= 0;
    truth.margin = smaller(truth.margin, quad_abs(inside));
    return truth;
}

/** @return See #Row.touch. @param parameters The triangle. @param point The point. */
static Touch triangle_touch(const void *parameters, const Quad3 *point) {
    const TriangleRow *t = parameters;
    Quad3 a = quad3(t->corners[0]);
    return flat_touch(a, cross(minus(quad3(t->corners[1]), a), minus(quad3(t->corners[2]), a)),
                      point);
}

/* --- cylinder -------------------------------------------------------------------------------- */

/** As the scene language says it. */
typedef struct CylinderRow {
    double base[3]; /**< Centre of one end. */
    double top[3];  /**< Of the other. */
    double radius;  /**< Radius. */
    bool capped;    /**< Whether the ends are closed. */
} CylinderRow;

/** A crossing of a ray with the wall or an end of a cylinder. */
typedef struct Candidate {
    Quadruple t;      /**< Where. */
    Quadruple inside; /**< How far inside the rim of that surface, in radii; negative: beside. */
    Quad3 normal;     /**< The normal. */
} Candidate;

/** @return v without what of it runs along an axis. @param v A vector. @param axis A unit vector.
 */
static Quad3 across(Quad3 v, Quad3 axis) {
    Quadruple s = dot(v, axis);
    return minus(v, (Quad3){{s * axis.c[0], s * axis.c[1], s * axis.c[2]}});
}

/** Takes a candidate if it is ahead, on the surface and the nearest so far.
 *  @param[in,out] truth The nearest. @param candidate It. */
static void consider(Truth *truth, const Candidate *candidate) {
    truth->margin = smaller(truth->margin, quad_abs(candidate->inside));
    if (candidate->t > 0 && candidate->inside >= 0 && (!truth->is_hit || candidate->t < truth->t)) {
        *truth = (Truth){true, candidate->t, candidate->normal, truth->margin};
    }
}

/** Considers both ends of a cylinder. @param c The cylinder. @param axis Its axis.
 *  @param length From base to top. @param ray The ray. @param[in,out] truth The nearest. */
static void consider_ends(const CylinderRow *c, Quad3 axis, Quadruple length, const RayQuery *ray,
                          Truth *truth) {
    Quad3 from_base = minus(quad3_of(ray->origin), quad3(c->base)), d = quad3_of(ray->direction);
    Quadruple slope = dot(d, axis);
    for (int end = 0; end < 2 && slope != 0; end++) {
        Candidate it = {.t = (end * length - dot(from_base, axis)) / slope};
        Quad3 arm = across(minus(along(ray, it.t), quad3(c->base)), axis);
        it.inside = 1 - quad_sqrt(dot(arm, arm)) / c->radius;
        int sign = end ? 1 : -1;
        it.normal = (Quad3){{sign * axis.c[0], sign * axis.c[1], sign * axis.c[2]}};
        consider(truth, &it);
    }
}

/** @return See #Row.truth: the textbook's four surfaces, one after the other.
 *  @param parameters The cylinder. @param ray The ray. */
static Truth cylinder_truth(const void *parameters, const RayQuery *ray) {
    const CylinderRow *cylinder = parameters;
    Quad3 way = minus(quad3(cylinder->top), quad3(cylinder->base)), axis = unit(way);
    Quadruple length = quad_sqrt(dot(way, way)), r = cylinder->radius;
    Quad3 o = across(minus(quad3_of(ray->origin), quad3(cylinder->base)), axis);
    Quad3 d = across(quad3_of(ray->direction), axis), whole = quad3_of(ray->direction);
    Quadruple a = dot(d, d), b = dot(o, d), c = dot(o, o) - r * r, discriminant = b * b - a * c;
    // A ray along the axis, or nearly, crosses the wall nowhere in particular.
    bool is_along = a <= dot(whole, whole) * (Quadruple)1e-50;
    Truth truth = {.margin =
                       is_along ? quad_abs(c) / (r * r) : quad_abs(discriminant) / (a * r * r)};
    for (int sign = -1; sign <= 1 && discriminant >= 0 && !is_along; sign += 2) {
        Candidate it = {.t = (-b + sign * quad_sqrt(discriminant)) / a};
        Quad3 arm = minus(along(ray, it.t), quad3(cylinder->base));
        Quadruple height = dot(arm, axis);
        it.inside = smaller(height, length - height) / r;
        it.normal = unit(across(arm, axis));
        consider(&truth, &it);
    }
    if (cylinder->capped) {
        consider_ends(cylinder, axis, length, ray, &truth);
    }
    return truth_grazing(truth, ray);
}

/** @return See #Row.touch. @param parameters The cylinder. @param point The point. */
static Touch cylinder_touch(const void *parameters, const Quad3 *point) {
    const CylinderRow *c = parameters;
    Quad3 way = minus(quad3(c->top), quad3(c->base)), axis = unit(way);
    Quad3 from_base = minus(*point, quad3(c->base)), arm = across(from_base, axis);
    Touch wall = {quad_abs(quad_sqrt(dot(arm, arm)) - c->radius), unit(arm)};
    Quadruple height = dot(from_base, axis);
    Touch end = {smaller(quad_abs(height), quad_abs(height - quad_sqrt(dot(way, way)))), axis};
    return c->capped && end.off < wall.off ? end : wall;
}

/* --- box ------------------------------------------------------------------------------------- */

/** As the scene language says it. */
typedef struct BoxRow {
    double low[3];  /**< Lowest corner. */
    double high[3]; /**< Highest corner. */
} BoxRow;

/** @return See #Row.truth. @param parameters The box. @param ray The ray. */
static Truth box_truth(const void *parameters, const RayQuery *ray) {
    const BoxRow *b = parameters;
    Quadruple near = -HUGE_VAL, far = HUGE_VAL, size = 0;
    int near_axis = 0, far_axis = 0;
    bool is_beside = false;
    for (int i = 0; i < 3; i++) {
        Quadruple o = ray->origin[i], d = ray->direction[i];
        size = quad_abs((Quadruple)b->high[i] - b->low[i]) + size;
        if (d == 0) {
            is_beside = is_beside || o < b->low[i] || o > b->high[i];
            continue;
        }
        Quadruple enter = ((d > 0 ? b->low[i] : b->high[i]) - o) / d;
        Quadruple leave = ((d > 0 ? b->high[i] : b->low[i]) - o) / d;
        near_axis = enter > near ? i : near_axis;
        near = enter > near ? enter : near;
        far_axis = leave < far ? i : far_axis;
        far = leave < far ? leave : far;
    }
    Quad3 d = quad3_of(ray->direction);
    Quadruple length = quad_sqrt(dot(d, d));
    Truth truth = {.is_hit = !is_beside && far > 0 && near <= far,
                   .margin = smaller(quad_abs(far - near) * length / size,
                                     quad_abs(near > 0 ? near : far) * length / size)};
    int axis = near > 0 ? near_axis : far_axis;
    truth.t = near > 0 ? near : far;
    truth.normal.c[axis] = (ray->direction[axis] > 0) == (near > 0) ? -1 : 1;
    return truth;
}

/** @return See #Row.touch. @param parameters The box. @param point The point. */
static Touch box_touch(const void *parameters, const Quad3 *point) {
    const BoxRow *b = parameters;
    Touch touch = {.off = HUGE_VAL};
    for (int i = 0; i < 3; i++) {
        Quadruple off =
            smaller(quad_abs(point->c[i] - b->low[i]), quad_abs(point->c[i] - b->high[i]));
        if (off < touch.off) {
            touch = (Touch){.off = off};
            touch.normal.c[i] = 1;
        }
    }
    return touch;
}

/* --- transformed shapes ---------------------------------------------------------------------- */

/** A matrix in quad precision, and where it moves things then. */
typedef struct Affine {
    Quad3 row[3]; /**< Rows of the matrix. */
    Quad3 move;   /**< The move. */
} Affine;

/** @return What a row is transformed by; nothing changes without. @param row The row. */
static Affine affine_of(const Row *row) {
    Affine affine = {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}, {{0, 0, 0}}};
    const Transform *t = row->transform;
    if (t) {
        for (int i = 0; i < 3; i++) {
            affine.row[i] = quad3(t->linear[i]);
        }
        affine.move = (Quad3){{t->translate.x, t->translate.y, t->translate.z}};
    }
    return affine;
}

/** @return The vector that the matrix makes into another, by Cramer's rule. @param affine The
 *          matrix. @param v The other. */
static Quad3 before(const Affine *affine, Quad3 v) {
    const Quad3 *m = affine->row;
    Quad3 x = cross(m[1], m[2]), y = cross(m[2], m[0]), z = cross(m[0], m[1]);
    Quadruple determinant = dot(m[0], x);
    Quad3 inverse;
    for (int i = 0; i < 3; i++) {
        inverse.c[i] = (x.c[i] * v.c[0] + y.c[i] * v.c[1] + z.c[i] * v.c[2]) / determinant;
    }
    return inverse;
}

/** @return A normal of the shape before it is transformed as one after it, and how far a plane one
 *          away is then: its length is the inverse of that. @param affine The matrix.
 *  @param n The normal. */
static Quad3 normal_after(const Affine *affine, Quad3 n) {
    Quad3 normal;
    for (int i = 0; i < 3; i++) {
        Quad3 unit_vector = {{i == 0, i == 1, i == 2}};
        normal.c[i] = dot(n, before(affine, unit_vector));
    }
    return normal;
}

/** @return What quad precision says of a ray and a row. @param row The row. @param ray The ray. */
static Truth row_truth(const Row *row, const RayQuery *ray) {
    if (!row->transform) {
        return row->truth(row->parameters, ray);
    }
    Affine affine = affine_of(row);
    Quad3 origin = before(&affine, minus(quad3_of(ray->origin), affine.move));
    Quad3 direction = before(&affine, quad3_of(ray->direction));
    RayQuery inner;
    memcpy(inner.origin, origin.c, sizeof origin.c);
    memcpy(inner.direction, direction.c, sizeof direction.c);
    Truth truth = row->truth(row->parameters, &inner);
    truth.normal = unit(normal_after(&affine, truth.normal));
    return truth_grazing(truth, ray);
}

/** @return How far a point is off a row's surface. @param row The row. @param point The point. */
static Quadruple row_off(const Row *row, const Quad3 *point) {
    Affine affine = affine_of(row);
    Quad3 inner = before(&affine, minus(*point, affine.move));
    Touch touch = row->touch(row->parameters, &inner);
    Quad3 normal = normal_after(&affine, touch.normal);
    return touch.off / quad_sqrt(dot(normal, normal));
}

/* --- the rows -------------------------------------------------------------------------------- */

static const SphereRow sphere_row = {{0.5, -1.25, 2}, 1.5};
static const PlaneRow plane_row = {{0.25, -1, 3}, {0.5, 2, -0.25}};
static const QuadRow quad_row = {{-1, -0.5, 0.25}, {2, 0.5, 0.125}, {-0.25, 1.5, 0.5}};
static const BoxRow box_row = {{-1, 0.5, -2}, {0.75, 1.25, -0.5}};
static const DiskRow disk_row = {{0.5, -1.25, 2}, {0.25, 1, -0.5}, 1.5};
static const CylinderRow cylinder_row = {{0.5, -1.25, 2}, {1, 0.5, 1.25}, 0.75, true};
static const CylinderRow pipe_row = {{0.5, -1.25, 2}, {0.5, 0.5, 2}, 0.75, false};
static const TriangleRow triangle_row = {
    .corners = {{-1, -0.5, 0.25}, {1, 0, 0.5}, {-0.25, 1.5, 1}}};
static const SphereRow small_sphere_row = {{0.25, 0, 0}, 0.5};
static const CylinderRow upright_row = {{0, -1, 0}, {0, 1, 0}, 1, true};

// Numbers of a scene; #start fills in what follows from them.
static Transform egg = {.scale = {3, 1.5, 2}, .rotate = {20, -35, 50}, .translate = {0.5, -1, 2}};
static Transform lean = {.scale = {1, 1, 1}, .rotate = {30, 45, 60}, .translate = {4, 3, -2}};
static Transform squeeze = {
    .scale = {1, -0.75, 0.5}, .rotate = {0, 90, 15}, .translate = {1.0625, 0.96875, 1.03125}};
static Transform tilt = {.scale = {2, 2, 2}, .rotate = {40, 0, 10}, .translate = {0, 1, 0}};

/** Every shape class has a row; a test counts them. */
static const Row rows[] = {
    {"sphere", "sphere", &sphere_row, true, 1.5, {0.5, -1.25, 2}, sphere_truth, sphere_touch, NULL},
    {"plane", "plane", &plane_row, false, 1, {0.25, -1, 3}, plane_truth, plane_touch, NULL},
    {"quad", "quad", &quad_row, false, 1, {-0.125, 0.5, 0.5}, quad_truth, quad_touch, NULL},
    {"box", "box", &box_row, true, 1, {-0.125, 0.875, -1.25}, box_truth, box_touch, NULL},
    {"disk", "disk", &disk_row, false, 1.5, {0.5, -1.25, 2}, disk_truth, disk_touch, NULL},
    {"cylinder",
     "cylinder",
     &cylinder_row,
     true,
     1,
     {0.75, -0.375, 1.625},
     cylinder_truth,
     cylinder_touch,
     NULL},
    {"pipe",
     "cylinder",
     &pipe_row,
     false,
     1,
     {0.5, -0.375, 2},
     cylinder_truth,
     cylinder_touch,
     NULL},
    {"triangle",
     "triangle",
     &triangle_row,
     false,
     1,
     {-0.125, 0.25, 0.5},
     triangle_truth,
     triangle_touch,
     NULL},
    {"egg",
     "sphere",
     &small_sphere_row,
     true,
     1,
     {1, -0.5, 1.75},
     sphere_truth,
     sphere_touch,
     &egg},
    {"leaning box", "box", &box_row, true, 1, {4, 3, -1}, box_truth, box_touch, &lean},
    {"squeezed cylinder",
     "cylinder",
     &upright_row,
     true,
     1,
     {1.0625, 0.96875, 1.09375},
     cylinder_truth,
     cylinder_touch,
     &squeeze},
    {"tilted plane", "plane", &plane_row, false, 1, {0, 1, 3}, plane_truth, plane_touch, &tilt},
};

/** How many. */
enum { ROW_COUNT = sizeof rows / sizeof *rows };

/* --- one shape in one engine ----------------------------------------------------------------- */

/** A row in an engine. */
typedef struct Subject {
    const Row *row;       /**< The row. */
    const Engine *engine; /**< The engine. */
    Tracer *tracer;       /**< A scene with this shape alone. */
} Subject;

/** Worst errors of a row in an engine. */
typedef struct Worst {
    Quadruple t;      /**< Distance, in half ulps of itself and the shape's size. */
    Quadruple point;  /**< Off the surface, in half ulps of the largest coordinate and the size. */
    Quadruple normal; /**< Normal, half ulps of 1. */
    Quadruple bound;  /**< Off the surface, as a share of the hit's own error bound. */
} Worst;

/** What was found, for the table at the end. */
static Worst worsts[ROW_COUNT][8];

/** @return A tracer with one shape. @param engine The engine. @param row The shape. */
static Tracer *tracer_with(const Engine *engine, const Row *row) {
    Error error = {0};
    Scene *scene = empty_scene();
    add_shape(scene, row->keyword, row->parameters);
    assert_true(!row->transform || scene_transform_shape(scene, row->transform, &error));
    Tracer *tracer = prepare(engine, scene);
    scene_destroy(scene);
    return tracer;
}

/** A case of the contract. @param subject A row in an engine. @param[in,out] worst Its errors. */
typedef void (*Case)(const Subject *subject, Worst *worst);

/** Runs a case for every row in every engine. @param run The case. */
static void for_all(Case run) {
    for (size_t r = 0; r < ROW_COUNT; r++) {
        for (size_t e = 0; engine_list()[e]; e++) {
            const Engine *engine = engine_list()[e];
            if (engine_is_supported(engine)) {
                Subject subject = {&rows[r], engine, tracer_with(engine, &rows[r])};
                run(&subject, &worsts[r][e]);
                engine->release(subject.tracer);
            }
        }
    }
}

/** @return Rays for an engine: the slow reference gets fewer. @param subject Row and engine. */
static size_t ray_count(const Subject *subject) {
    return subject->engine->mantissa_bits > 64 ? RAYS / 10 : RAYS;
}

/** @return The larger. @param a A number. @param b Another. */
static Quadruple larger(Quadruple a, Quadruple b) {
    return a > b ? a : b;
}

/** @return The largest absolute coordinate. @param v Three numbers. */
static Quadruple reach(const Quadruple v[3]) {
    return larger(quad_abs(v[0]), larger(quad_abs(v[1]), quad_abs(v[2])));
}

/**
 * Holds an answer against the truth.
 * @param subject  Row and engine.
 * @param ray      The ray.
 * @param answer   The engine's answer.
 * @param[in,out] worst  The errors.
 */
static void check(const Subject *subject, const RayQuery *ray, const RayAnswer *answer,
                  Worst *worst) {
    const Row *row = subject->row;
    Truth truth = row_truth(row, ray);
    Quadruple u = roundoff(subject->engine);
    bool is_hit = answer->shape == 0;
    assert_int_equal(is_hit, answer->blocked);
    // So near to the rim that rounding the ray itself decides: either answer is right.
    Quad3 d = quad3_of(ray->direction);
    Quadruple sizes = quad_abs(truth.t) * quad_sqrt(dot(d, d)) / row->size;
    if (truth.margin < 64 * u * (1 + sizes)) {
        return;
    }
    if (is_hit != truth.is_hit) {
        fail_msg("%s in %s: hit %d, truth %d, margin %g, from %g %g %g along %g %g %g", row->name,
                 subject->engine->name, is_hit, truth.is_hit, (double)truth.margin,
                 (double)ray->origin[0], (double)ray->origin[1], (double)ray->origin[2],
                 (double)ray->direction[0], (double)ray->direction[1], (double)ray->direction[2]);
    }
    if (!is_hit) {
        assert_true(answer->distance > 1e300);
        return;
    }
    Quad3 point = {{answer->point[0], answer->point[1], answer->point[2]}};
    Quadruple off = row_off(row, &point);
    worst->point = larger(worst->point, off / (u * (reach(answer->point) + row->size)));
    worst->bound = larger(worst->bound, off / answer->error);
    // Where a ray grazes, its own last bit moves the point: distance and normal say nothing there.
    if (truth.margin < GRAZING) {
        return;
    }
    // In sizes: a ray that starts close to a surface cannot know its distance better than its
    // place.
    Quadruple off_t = quad_abs(answer->distance - truth.t) / quad_abs(truth.t) * sizes;
    worst->t = larger(worst->t, off_t / (u * (sizes + 1)));
    Quad3 normal = {{answer->normal[0], answer->normal[1], answer->normal[2]}};
    Quad3 difference = minus(normal, truth.normal);
    Quadruple length = quad_sqrt(dot(normal, normal));
    worst->normal = larger(worst->normal, larger(quad_abs(length - 1), reach(difference.c)) / u);
}

/** Asks an engine and checks every answer. @param subject Row and engine. @param rays The rays.
 *  @param count How many. @param[in,out] worst The errors. */
static void ask(const Subject *subject, const RayQuery *rays, size_t count, Worst *worst) {
    RayAnswer *answers = calloc(count, sizeof *answers);
    subject->engine->intersect(subject->tracer, count, rays, answers);
    for (size_t i = 0; i < count; i++) {
        check(subject, &rays[i], &answers[i], worst);
    }
    free(answers);
}

/** @return A ray from around a shape to around its middle. @param row The row.
 *  @param[in,out] state A generator. @param distance How far away it starts, in sizes.
 *  @param spread How far beside the middle it aims, in sizes. */
static RayQuery random_aim(const Row *row, uint64_t *state, double distance, double spread) {
    RayQuery ray = {0};
    for (int i = 0; i < 3; i++) {
        double far = distance * row->size, beside = spread * row->size;
        ray.origin[i] = (double)(float)(row->center[i] + random_float(state, -far, far));
        double target = row->center[i] + random_float(state, -beside, beside);
        ray.direction[i] = (double)(float)(target - (double)ray.origin[i]);
    }
    return ray;
}

/** Asks about random rays. @param subject Row and engine. @param distance See #random_aim.
 *  @param spread See #random_aim. @param[in,out] worst The errors. */
static void ask_random(const Subject *subject, double distance, double spread, Worst *worst) {
    size_t count = ray_count(subject);
    RayQuery *rays = calloc(count, sizeof *rays);
    uint64_t state = 1;
    for (size_t i = 0; i < count; i++) {
        rays[i] = random_aim(subject->row, &state, distance, spread);
    }
    ask(subject, rays, count, worst);
    free(rays);
}

/* --- the cases ------------------------------------------------------------------------------- */

/** Around it and in it, meeting and missing; the errors go into the table.
 *  @param subject Row and engine. @param[in,out] worst The errors. */
static void case_near(const Subject *subject, Worst *worst) {
    ask_random(subject, 4, 1.5, worst);
    ask_random(subject, 0.5, 2, worst);
    bool is_float = subject->engine->mantissa_bits == 24;
    const char *name = subject->engine->name, *shape = subject->row->name;
    // Float takes its differences in double and rounds a few times after; the others have nothing
    // better, and their error grows with the distance to the shape.
    // A transformed ray was rounded once more.
    double t_bound = subject->row->transform && is_float ? 12
                     : strcmp(shape, "box") == 0         ? 8
                     : is_float                          ? 4
                                                         : 64;
    assert_at_most(worst->t, t_bound, "%s in %s, distance, half ulps", shape, name);
    assert_at_most(worst->point, 8, "%s in %s, point, half ulps", shape, name);
    // Uneven scales turn normals, and their last bits. In quad, what is measured is as much the
    // reference's own error.
    double float_bound = subject->row->transform ? 16 : 6;
    double normal_bound = is_float ? float_bound : subject->engine->mantissa_bits > 64 ? 1024 : 64;
    assert_at_most(worst->normal, normal_bound, "%s in %s, normal, half ulps", shape, name);
    assert_at_most(worst->bound, 1, "%s in %s, point against its own bound", shape, name);
}

/** A thousand and ten thousand sizes away. @param subject Row and engine.
 *  @param[in,out] unused Not used. */
static void case_far(const Subject *subject, Worst *unused) {
    (void)unused;
    if (subject->engine->mantissa_bits > 64) {
        return; // The reference here is no better than the engine: it would be measuring itself.
    }
    for (double distance = 1e3; distance < 1e5; distance *= 10) {
        Worst worst = {0};
        ask_random(subject, distance, 0.5, &worst);
        assert_at_most(worst.t, 64, "%s in %s at %g sizes, distance, half ulps", subject->row->name,
                       subject->engine->name, distance);
        assert_at_most(worst.bound, 1, "%s in %s at %g sizes, point against its own bound",
                       subject->row->name, subject->engine->name, distance);
    }
}

/** Away from it: nothing is met. @param subject Row and engine. @param[in,out] unused Not used. */
static void case_behind(const Subject *subject, Worst *unused) {
    (void)unused;
    uint64_t state = 2;
    for (int n = 0; n < LEAVING_RAYS; n++) {
        RayQuery ray = random_aim(subject->row, &state, 6, 0.5);
        Truth ahead = row_truth(subject->row, &ray);
        for (int i = 0; i < 3; i++) {
            ray.direction[i] = -ray.direction[i];
        }
        Truth behind = row_truth(subject->row, &ray);
        if (ahead.is_hit && !behind.is_hit) {
            RayAnswer answer;
            subject->engine->intersect(subject->tracer, 1, &ray, &answer);
            assert_int_equal(answer.shape, -1);
            assert_false(answer.blocked);
        }
    }
}

/** A direction of any length: by powers of two the same bits, else the same answer.
 *  @param subject Row and engine. @param[in,out] unused Not used. */
static void case_length(const Subject *subject, Worst *unused) {
    (void)unused;
    uint64_t state = 3;
    for (int n = 0; n < LEAVING_RAYS; n++) {
        RayQuery ray = random_aim(subject->row, &state, 5, 1), longer = ray;
        double factor = ldexp(1, n % 41 - 20);
        for (int i = 0; i < 3; i++) {
            longer.direction[i] *= factor;
        }
        RayAnswer a, b;
        subject->engine->intersect(subject->tracer, 1, &ray, &a);
        subject->engine->intersect(subject->tracer, 1, &longer, &b);
        assert_int_equal(a.shape, b.shape);
        assert_memory_equal(a.point, b.point, sizeof a.point);
        assert_memory_equal(a.normal, b.normal, sizeof a.normal);
        assert_true(a.shape < 0 || a.distance == b.distance * factor);
    }
}

/** @return A number rounded to an engine's type. @param engine The engine. @param x The number. */
static Quadruple rounded(const Engine *engine, Quadruple x) {
    return engine->mantissa_bits == 24   ? (Quadruple)(float)x
           : engine->mantissa_bits == 53 ? (Quadruple)(double)x
                                         : x;
}

/**
 * @return A ray that leaves a hit on one side, from a point moved by the hit's own error bound.
 * @param engine  The engine, to whose numbers it is rounded.
 * @param hit     The hit.
 * @param side    1: outwards; -1: inwards.
 * @param[in,out] state  A generator.
 */
static RayQuery leaving(const Engine *engine, const RayAnswer *hit, int side, uint64_t *state) {
    RayQuery ray;
    Quadruple cosine = 0;
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = rounded(engine, hit->point[i] + side * hit->error * hit->normal[i]);
        ray.direction[i] = random_float(state, -1, 1);
        cosine += ray.direction[i] * hit->normal[i];
    }
    for (int i = 0; i < 3; i++) {
        ray.direction[i] = cosine * side > 0 ? ray.direction[i] : -ray.direction[i];
    }
    return ray;
}

/** On the surface and leaving it: of 1000 rays outwards none meets it again, and of 1000 inwards
 *  each meets only the far side. @param subject Row and engine. @param[in,out] unused Not used. */
static void case_leaving(const Subject *subject, Worst *unused) {
    (void)unused;
    uint64_t state = 4;
    int hits_again[2] = {0, 0}, left = 0;
    while (left < LEAVING_RAYS) {
        RayQuery ray = random_aim(subject->row, &state, 20, 0.9);
        RayAnswer hit, again;
        subject->engine->intersect(subject->tracer, 1, &ray, &hit);
        if (hit.shape < 0) {
            continue;
        }
        left++;
        RayQuery out = leaving(subject->engine, &hit, 1, &state);
        subject->engine->intersect(subject->tracer, 1, &out, &again);
        hits_again[0] += again.shape >= 0 || again.blocked;
        RayQuery in = leaving(subject->engine, &hit, -1, &state);
        subject->engine->intersect(subject->tracer, 1, &in, &again);
        Truth truth = row_truth(subject->row, &in);
        bool is_right = again.shape < 0
                            ? !subject->row->is_solid && !truth.is_hit
                            : truth.is_hit && quad_abs(again.distance - truth.t) <= truth.t / 100;
        hits_again[1] += !is_right;
    }
    assert_at_most(hits_again[0], 0, "%s in %s, met again outwards", subject->row->name,
                   subject->engine->name);
    assert_at_most(hits_again[1], 0, "%s in %s, wrong inwards", subject->row->name,
                   subject->engine->name);
}

/** NaN, infinity, zero and axis-parallel directions, with every sign of zero: an answer without
 * NaN, and where the numbers are good, the right one. @param subject Row and engine.
 *  @param[in,out] unused Not used. */
static void case_degenerate(const Subject *subject, Worst *unused) {
    (void)unused;
    static const double odd[] = {0.0, -0.0, 1, -1, NAN, INFINITY, -INFINITY, 1e30, 1e-40};
    enum { ODD = sizeof odd / sizeof *odd };
    for (int n = 0; n < ODD * ODD * ODD * ODD; n++) {
        const double *center = subject->row->center;
        RayQuery ray = {.direction = {odd[n % ODD], odd[n / ODD % ODD], odd[n / ODD / ODD % ODD]},
                        .origin = {center[0], center[1], center[2] + odd[n / ODD / ODD / ODD]}};
        RayAnswer answer;
        subject->engine->intersect(subject->tracer, 1, &ray, &answer);
        bool is_finite = true, is_bad = false;
        for (int i = 0; i < 3; i++) {
            is_finite = is_finite && isfinite((double)answer.point[i] + (double)answer.normal[i]);
            is_bad = is_bad || isnan((double)ray.direction[i]) || isnan((double)ray.origin[i]);
        }
        if (!(answer.shape < 0 || (is_finite && answer.distance > 0 && !is_bad))) {
            fail_msg("%s in %s: from %g %g %g along %g %g %g: t %g, point %g %g %g",
                     subject->row->name, subject->engine->name, (double)ray.origin[0],
                     (double)ray.origin[1], (double)ray.origin[2], (double)ray.direction[0],
                     (double)ray.direction[1], (double)ray.direction[2], (double)answer.distance,
                     (double)answer.point[0], (double)answer.point[1], (double)answer.point[2]);
        }
    }
}

/** Along the axes, through the middle and beside it. @param subject Row and engine.
 *  @param[in,out] worst The errors. */
static void case_axes(const Subject *subject, Worst *worst) {
    for (int n = 0; n < 3 * 2 * 2 * 81; n++) {
        int axis = n % 3, up = n / 3 % 2 ? 1 : -1;
        double zero = n / 6 % 2 ? 0.0 : -0.0;
        RayQuery ray = {.direction = {zero, zero, zero}};
        for (int i = 0; i < 3; i++) {
            ray.origin[i] = subject->row->center[i];
        }
        ray.direction[axis] = up;
        ray.origin[axis] -= 8 * up;
        ray.origin[(axis + 1) % 3] += 0.25 * (n / 12 % 9 - 4);
        ray.origin[(axis + 2) % 3] += 0.25 * (n / 108 % 9 - 4);
        ask(subject, &ray, 1, worst);
    }
}

/** Wider engines give the bits of the narrow one. @param subject Row and engine.
 *  @param[in,out] unused Not used. */
static void case_lanes(const Subject *subject, Worst *unused) {
    (void)unused;
    Error error;
    const Engine *one = engine_find(subject->engine->mantissa_bits == 24   ? "f32x1"
                                    : subject->engine->mantissa_bits == 53 ? "f64x1"
                                                                           : "f128x1",
                                    &error);
    Tracer *tracer = tracer_with(one, subject->row);
    uint64_t state = 5;
    RayQuery rays[101];
    RayAnswer a[101], b[101];
    for (int n = 0; n < LEAVING_RAYS / 10; n++) {
        size_t count = 1 + (size_t)n % 101;
        for (size_t i = 0; i < count; i++) {
            rays[i] = random_aim(subject->row, &state, 3 + n, 1.2);
        }
        subject->engine->intersect(subject->tracer, count, rays, a);
        one->intersect(tracer, count, rays, b);
        for (size_t i = 0; i < count; i++) {
            assert_int_equal(a[i].shape, b[i].shape);
            assert_int_equal(a[i].blocked, b[i].blocked);
            assert_memory_equal(&a[i].distance, &b[i].distance, sizeof a[i].distance);
            assert_memory_equal(a[i].point, b[i].point, sizeof a[i].point);
            assert_memory_equal(a[i].normal, b[i].normal, sizeof a[i].normal);
            assert_memory_equal(&a[i].error, &b[i].error, sizeof a[i].error);
        }
    }
    one->release(tracer);
}

/* --- cmocka ---------------------------------------------------------------------------------- */

/** Every class has a row. @param state Not used. */
static void test_every_shape_has_a_row(void **state) {
    (void)state;
    for (const Keyword *const *keyword = engine_list()[0]->shape_keywords; *keyword; keyword++) {
        size_t r = 0;
        while (r < ROW_COUNT && strcmp(rows[r].keyword, (*keyword)->name) != 0) {
            r++;
        }
        assert_at_most(r, ROW_COUNT - 1, "the row of %s", (*keyword)->name);
    }
}

/** @param state Not used. */
static void test_near(void **state) {
    (void)state;
    for_all(case_near);
}

/** @param state Not used. */
static void test_far(void **state) {
    (void)state;
    for_all(case_far);
}

/** @param state Not used. */
static void test_behind(void **state) {
    (void)state;
    for_all(case_behind);
}

/** @param state Not used. */
static void test_length(void **state) {
    (void)state;
    for_all(case_length);
}

/** @param state Not used. */
static void test_leaving(void **state) {
    (void)state;
    for_all(case_leaving);
}

/** @param state Not used. */
static void test_degenerate(void **state) {
    (void)state;
    for_all(case_degenerate);
}

/** @param state Not used. */
static void test_axes(void **state) {
    (void)state;
    for_all(case_axes);
}

/** @param state Not used. */
static void test_lanes(void **state) {
    (void)state;
    for_all(case_lanes);
}

/** Better numbers give better answers: the double engine is not float in disguise.
 *  @param state Not used. */
static void test_precision(void **state) {
    (void)state;
    for (size_t r = 0; r < ROW_COUNT; r++) {
        Quadruple absolute[3] = {0, 0, 0};
        for (size_t e = 0; engine_list()[e]; e++) {
            int bits = engine_list()[e]->mantissa_bits;
            int which = bits == 24 ? 0 : bits == 53 ? 1 : 2;
            absolute[which] = larger(absolute[which], worsts[r][e].t * roundoff(engine_list()[e]));
        }
        assert_true(absolute[1] < absolute[0] / 1e4);
        assert_true(absolute[2] < absolute[1] / 1e4);
    }
}

/** Works out the matrices of the rows. @param state Not used. @return 0 */
static int start(void **state) {
    (void)state;
    Transform *const transforms[] = {&egg, &lean, &squeeze, &tilt};
    for (size_t i = 0; i < sizeof transforms / sizeof *transforms; i++) {
        Error error = {0};
        assert_true(transform_keyword.finish(transforms[i], 0, &error));
    }
    return 0;
}

/** Prints the table of worst errors. @param state Not used. @return 0 */
static int print_table(void **state) {
    (void)state;
    printf("worst errors, half ulps     distance     point    normal   point/bound\n");
    for (size_t r = 0; r < ROW_COUNT; r++) {
        for (size_t e = 0; engine_list()[e]; e++) {
            const Worst *w = &worsts[r][e];
            printf("  %-17s %-8s %8.2f %9.2f %9.2f %13.3f\n", rows[r].name, engine_list()[e]->name,
                   (double)w->t, (double)w->point, (double)w->normal, (double)w->bound);
        }
    }
    return 0;
}

/** Runs the contract. @return 0 if it is kept. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_shape_has_a_row),
        cmocka_unit_test(test_near),
        cmocka_unit_test(test_axes),
        cmocka_unit_test(test_precision),
        cmocka_unit_test(test_far),
        cmocka_unit_test(test_behind),
        cmocka_unit_test(test_length),
        cmocka_unit_test(test_leaving),
        cmocka_unit_test(test_degenerate),
        cmocka_unit_test(test_lanes),
    };
    return cmocka_run_group_tests_name("contract", tests, start, print_table);
}
