/**
 * @file
 * @brief The rows of the contract: each shape with what quad precision says of it.
 *
 * The references share no code with the tracer: they are the textbook's formulas, which are good
 * enough in quad precision.
 */
#ifndef DIOPTRE_CONTRACT_ROWS_H
#define DIOPTRE_CONTRACT_ROWS_H

#include "testing.h"

/** A point or direction in quad precision. */
typedef struct Triple {
    Quadruple c[3]; /**< Coordinates. */
} Triple;

/** What the reference says of a ray. */
typedef struct Truth {
    bool is_hit;      /**< Whether the shape is met. */
    Quadruple t;      /**< Where. */
    Triple normal;    /**< Outward unit normal. */
    Quadruple margin; /**< How far, as a share of the shape's size, from missing (or meeting) it. */
} Truth;

/** The plane that touches a shape next to a point. */
typedef struct Touch {
    Quadruple off; /**< How far the point is off it. */
    Triple normal; /**< Its unit normal. */
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
    Touch (*touch)(const void *parameters, const Triple *point);
    const Transform *transform; /**< What becomes of it; NULL: nothing. */
} Row;

/* --- quad precision -------------------------------------------------------------------------- */

/** @return a - b. @param a A point. @param b A point. */
static Triple minus(Triple a, Triple b) {
    return (Triple){{a.c[0] - b.c[0], a.c[1] - b.c[1], a.c[2] - b.c[2]}};
}

/** @return a . b @param a A vector. @param b A vector. */
static Quadruple dot(Triple a, Triple b) {
    return a.c[0] * b.c[0] + a.c[1] * b.c[1] + a.c[2] * b.c[2];
}

/** @return a x b @param a A vector. @param b A vector. */
static Triple cross(Triple a, Triple b) {
    return (Triple){{a.c[1] * b.c[2] - a.c[2] * b.c[1], a.c[2] * b.c[0] - a.c[0] * b.c[2],
                     a.c[0] * b.c[1] - a.c[1] * b.c[0]}};
}

/** @return v one long. @param v A vector. */
static Triple unit(Triple v) {
    Quadruple length = quad_sqrt(dot(v, v));
    return (Triple){{v.c[0] / length, v.c[1] / length, v.c[2] / length}};
}

/** @return A vector exactly. @param v Three numbers. */
static Triple triple(const double v[3]) {
    return (Triple){{v[0], v[1], v[2]}};
}

/** @return A vector. @param v Three numbers. */
static Triple triple_of(const Quadruple v[3]) {
    return (Triple){{v[0], v[1], v[2]}};
}

/** @return origin + t direction @param ray The ray. @param t How far. */
static Triple along(const RayQuery *ray, Quadruple t) {
    Triple o = triple_of(ray->origin), d = triple_of(ray->direction);
    return (Triple){{o.c[0] + t * d.c[0], o.c[1] + t * d.c[1], o.c[2] + t * d.c[2]}};
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
    Triple f = minus(triple_of(ray->origin), triple(s->center)), d = triple_of(ray->direction);
    Quadruple r = s->radius, a = dot(d, d), b = dot(f, d), c = dot(f, f) - r * r;
    Quadruple discriminant = b * b - a * c;
    Truth truth = {.margin = quad_abs(discriminant) / (a * r * r)};
    if (discriminant < 0) {
        return truth;
    }
    Quadruple root = quad_sqrt(discriminant), near = (-b - root) / a, far = (-b + root) / a;
    truth.t = near > 0 ? near : far;
    truth.is_hit = truth.t > 0;
    truth.normal = unit(minus(along(ray, truth.t), triple(s->center)));
    return truth;
}

/** @return See #Row.touch. @param parameters The sphere. @param point The point. */
static Touch sphere_touch(const void *parameters, const Triple *point) {
    const SphereRow *s = parameters;
    Triple arm = minus(*point, triple(s->center));
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
static Truth flat_truth(Triple point, Triple normal, const RayQuery *ray) {
    Triple n = unit(normal), d = unit(triple_of(ray->direction));
    Quadruple sine = dot(n, d), slope = dot(n, triple_of(ray->direction));
    Truth truth = {.margin = quad_abs(sine), .normal = n};
    truth.t = slope != 0 ? dot(n, minus(point, triple_of(ray->origin))) / slope : -1;
    truth.is_hit = truth.t > 0;
    return truth;
}

/** @return See #Row.truth. @param parameters The plane. @param ray The ray. */
static Truth plane_truth(const void *parameters, const RayQuery *ray) {
    const PlaneRow *p = parameters;
    return flat_truth(triple(p->point), triple(p->normal), ray);
}

/** @return The plane itself. @param on A point of it. @param normal Its normal.
 *  @param point The point next to it. */
static Touch flat_touch(Triple on, Triple normal, const Triple *point) {
    Triple n = unit(normal);
    return (Touch){quad_abs(dot(n, minus(*point, on))), n};
}

/** @return See #Row.touch. @param parameters The plane. @param point The point. */
static Touch plane_touch(const void *parameters, const Triple *point) {
    const PlaneRow *p = parameters;
    return flat_touch(triple(p->point), triple(p->normal), point);
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
    Triple u = triple(q->u), v = triple(q->v), n = cross(u, v);
    Truth truth = flat_truth(triple(q->corner), n, ray);
    Triple w = minus(along(ray, truth.t), triple(q->corner));
    Quadruple a = dot(cross(w, v), n) / dot(n, n), b = dot(cross(u, w), n) / dot(n, n);
    Quadruple inside = smaller(smaller(a, 1 - a), smaller(b, 1 - b));
    truth.is_hit = truth.is_hit && inside >= 0;
    truth.margin = smaller(truth.margin, quad_abs(inside));
    return truth;
}

/** @return See #Row.touch. @param parameters The quad. @param point The point. */
static Touch quad_touch(const void *parameters, const Triple *point) {
    const QuadRow *q = parameters;
    return flat_touch(triple(q->corner), cross(triple(q->u), triple(q->v)), point);
}

/** @return A truth whose margin is no larger than the sine of the angle at which the ray meets the
 *          surface: where that is small, the last bit of a ray that was turned moves the point far.
 *  @param truth The truth. @param ray The ray. */
static Truth truth_grazing(Truth truth, const RayQuery *ray) {
    if (truth.is_hit) {
        Quadruple sine = quad_abs(dot(truth.normal, unit(triple_of(ray->direction))));
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
    Truth truth = flat_truth(triple(d->center), triple(d->normal), ray);
    Triple arm = minus(along(ray, truth.t), triple(d->center));
    Quadruple inside = 1 - quad_sqrt(dot(arm, arm)) / d->radius;
    truth.is_hit = truth.is_hit && inside >= 0;
    truth.margin = smaller(truth.margin, quad_abs(inside));
    return truth;
}

/** @return See #Row.touch. @param parameters The disk. @param point The point. */
static Touch disk_touch(const void *parameters, const Triple *point) {
    const DiskRow *d = parameters;
    return flat_touch(triple(d->center), triple(d->normal), point);
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
    Triple a = triple(t->corners[0]), u = minus(triple(t->corners[1]), a);
    Triple v = minus(triple(t->corners[2]), a), n = cross(u, v);
    Truth truth = flat_truth(a, n, ray);
    Triple w = minus(along(ray, truth.t), a);
    Quadruple b = dot(cross(w, v), n) / dot(n, n), c = dot(cross(u, w), n) / dot(n, n);
    Quadruple inside = smaller(1 - b - c, smaller(b, c));
    truth.is_hit = truth.is_hit && inside >= 0;
    truth.margin = smaller(truth.margin, quad_abs(inside));
    return truth;
}

/** @return See #Row.touch. @param parameters The triangle. @param point The point. */
static Touch triangle_touch(const void *parameters, const Triple *point) {
    const TriangleRow *t = parameters;
    Triple a = triple(t->corners[0]);
    return flat_touch(a, cross(minus(triple(t->corners[1]), a), minus(triple(t->corners[2]), a)),
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
    Triple normal;    /**< The normal. */
} Candidate;

/** @return v without what of it runs along an axis. @param v A vector. @param axis A unit vector.
 */
static Triple across(Triple v, Triple axis) {
    Quadruple s = dot(v, axis);
    return minus(v, (Triple){{s * axis.c[0], s * axis.c[1], s * axis.c[2]}});
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
static void consider_ends(const CylinderRow *c, Triple axis, Quadruple length, const RayQuery *ray,
                          Truth *truth) {
    Triple from_base = minus(triple_of(ray->origin), triple(c->base)),
           d = triple_of(ray->direction);
    Quadruple slope = dot(d, axis);
    for (int end = 0; end < 2 && slope != 0; end++) {
        Candidate it = {.t = (end * length - dot(from_base, axis)) / slope};
        Triple arm = across(minus(along(ray, it.t), triple(c->base)), axis);
        it.inside = 1 - quad_sqrt(dot(arm, arm)) / c->radius;
        int sign = end ? 1 : -1;
        it.normal = (Triple){{sign * axis.c[0], sign * axis.c[1], sign * axis.c[2]}};
        consider(truth, &it);
    }
}

/** @return See #Row.truth: the textbook's four surfaces, one after the other.
 *  @param parameters The cylinder. @param ray The ray. */
static Truth cylinder_truth(const void *parameters, const RayQuery *ray) {
    const CylinderRow *cylinder = parameters;
    Triple way = minus(triple(cylinder->top), triple(cylinder->base)), axis = unit(way);
    Quadruple length = quad_sqrt(dot(way, way)), r = cylinder->radius;
    Triple o = across(minus(triple_of(ray->origin), triple(cylinder->base)), axis);
    Triple d = across(triple_of(ray->direction), axis), whole = triple_of(ray->direction);
    Quadruple a = dot(d, d), b = dot(o, d), c = dot(o, o) - r * r, discriminant = b * b - a * c;
    // A ray along the axis, or nearly, crosses the wall nowhere in particular.
    bool is_along = a <= dot(whole, whole) * (Quadruple)1e-50;
    Truth truth = {.margin =
                       is_along ? quad_abs(c) / (r * r) : quad_abs(discriminant) / (a * r * r)};
    for (int sign = -1; sign <= 1 && discriminant >= 0 && !is_along; sign += 2) {
        Candidate it = {.t = (-b + sign * quad_sqrt(discriminant)) / a};
        Triple arm = minus(along(ray, it.t), triple(cylinder->base));
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
static Touch cylinder_touch(const void *parameters, const Triple *point) {
    const CylinderRow *c = parameters;
    Triple way = minus(triple(c->top), triple(c->base)), axis = unit(way);
    Triple from_base = minus(*point, triple(c->base)), arm = across(from_base, axis);
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
    Triple d = triple_of(ray->direction);
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
static Touch box_touch(const void *parameters, const Triple *point) {
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
    Triple row[3]; /**< Rows of the matrix. */
    Triple move;   /**< The move. */
} Affine;

/** @return What a row is transformed by; nothing changes without. @param row The row. */
static Affine affine_of(const Row *row) {
    Affine affine = {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}, {{0, 0, 0}}};
    const Transform *t = row->transform;
    if (t) {
        for (int i = 0; i < 3; i++) {
            affine.row[i] = triple(t->linear[i]);
        }
        affine.move = (Triple){{t->translate.x, t->translate.y, t->translate.z}};
    }
    return affine;
}

/** @return The vector that the matrix makes into another, by Cramer's rule. @param affine The
 *          matrix. @param v The other. */
static Triple before(const Affine *affine, Triple v) {
    const Triple *m = affine->row;
    Triple x = cross(m[1], m[2]), y = cross(m[2], m[0]), z = cross(m[0], m[1]);
    Quadruple determinant = dot(m[0], x);
    Triple inverse;
    for (int i = 0; i < 3; i++) {
        inverse.c[i] = (x.c[i] * v.c[0] + y.c[i] * v.c[1] + z.c[i] * v.c[2]) / determinant;
    }
    return inverse;
}

/** @return A normal of the shape before it is transformed as one after it, and how far a plane one
 *          away is then: its length is the inverse of that. @param affine The matrix.
 *  @param n The normal. */
static Triple normal_after(const Affine *affine, Triple n) {
    Triple normal;
    for (int i = 0; i < 3; i++) {
        Triple unit_vector = {{i == 0, i == 1, i == 2}};
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
    Triple origin = before(&affine, minus(triple_of(ray->origin), affine.move));
    Triple direction = before(&affine, triple_of(ray->direction));
    RayQuery inner;
    memcpy(inner.origin, origin.c, sizeof origin.c);
    memcpy(inner.direction, direction.c, sizeof direction.c);
    Truth truth = row->truth(row->parameters, &inner);
    truth.normal = unit(normal_after(&affine, truth.normal));
    return truth_grazing(truth, ray);
}

/** @return How far a point is off a row's surface. @param row The row. @param point The point. */
static Quadruple row_off(const Row *row, const Triple *point) {
    Affine affine = affine_of(row);
    Triple inner = before(&affine, minus(*point, affine.move));
    Touch touch = row->touch(row->parameters, &inner);
    Triple normal = normal_after(&affine, touch.normal);
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

/** How near the marched row comes. */
#define CONTRACT_TOLERANCE 0x1p-17

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
    // A box of twelve triangles, and the same leaning.
    {"mesh", "mesh", &box_row, true, 1, {-0.125, 0.875, -1.25}, box_truth, box_touch, NULL},
    {"leaning mesh", "mesh", &box_row, true, 1, {4, 3, -1}, box_truth, box_touch, &lean},
    // A ball as a field, which is marched to.
    {"sdf", "sdf", &sphere_row, true, 1.5, {0.5, -1.25, 2}, sphere_truth, sphere_touch, NULL},
    {"tilted plane", "plane", &plane_row, false, 1, {0, 1, 3}, plane_truth, plane_touch, &tilt},
};

/** @return How far off a row's hits may be where they are found step by step; 0: they are solved.
 *  @param row The row. */
static double tolerance_of(const Row *row) {
    return strcmp(row->keyword, "sdf") == 0 ? CONTRACT_TOLERANCE : 0;
}

/** How many. */
enum { ROW_COUNT = sizeof rows / sizeof *rows };

#endif
