/**
 * @file
 * @brief Triangle, seen from both sides (row D1); flat, or shaded by a normal at each corner.
 *
 * Whether it is met is decided watertight, from its edges alone. Where: on its plane, but never
 * before the nearest corner or behind the farthest, which a sliver's plane alone does not know.
 */
#include "trace/shapes/flat.h"
#include "trace/shapes/registry.h"
#include "trace/shapes/shear.h"
#include "trace/shapes/smooth.h"

#include <string.h>

/** Corners of a triangle. */
enum { TRIANGLE_CORNERS = 3 };

/** What a scene file says of a triangle. */
typedef struct TriangleParameters {
    Vector3 corners[TRIANGLE_CORNERS]; /**< Its corners. */
    Vector3 normals[TRIANGLE_CORNERS]; /**< The normals there, of any length. */
    Pair places[TRIANGLE_CORNERS];     /**< The places in a picture there. */
    bool is_smooth;                    /**< Whether normals were given. */
} TriangleParameters;

/** A triangle. @extends Shape */
typedef struct Triangle {
    Shape base;                       /**< What all shapes have. */
    Flat flat;                        /**< Its plane; its normal is (b - a) x (c - a). */
    Corner corners[TRIANGLE_CORNERS]; /**< Its corners. */
    Point normals[TRIANGLE_CORNERS];  /**< The unit normals there. */
    Shares shares;                    /**< How much of b and of c is in a point. */
    Pair places[TRIANGLE_CORNERS];    /**< Where the corners lie on a picture. */
    bool is_smooth;                   /**< Whether the normals count. */
} Triangle;

/** Rows of the table, in its order. */
enum { ROW_NORMALS = 3, ROW_PLACES = 6 };

/** Bits of three rows of the table. */
#define ROWS_OF_THREE 7u

/** Fields of `triangle`. */
static const Parameter triangle_parameters[] = {
    {.name = "a",
     .type = PARAMETER_POINT,
     .offset = offsetof(TriangleParameters, corners[0]),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "scene units",
     .help = "one corner"},
    {.name = "b",
     .type = PARAMETER_POINT,
     .offset = offsetof(TriangleParameters, corners[1]),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "scene units",
     .help = "the next"},
    {.name = "c",
     .type = PARAMETER_POINT,
     .offset = offsetof(TriangleParameters, corners[2]),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "scene units",
     .help = "the last"},
    [ROW_NORMALS] = {.name = "na",
                     .type = PARAMETER_DIRECTION,
                     .offset = offsetof(TriangleParameters, normals[0]),
                     .minimum = -LENGTH_MAXIMUM,
                     .maximum = LENGTH_MAXIMUM,
                     .unit = "any length",
                     .help = "the normal at a, to shade it as if it were round"},
    {.name = "nb",
     .type = PARAMETER_DIRECTION,
     .offset = offsetof(TriangleParameters, normals[1]),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "any length",
     .help = "the normal at b"},
    {.name = "nc",
     .type = PARAMETER_DIRECTION,
     .offset = offsetof(TriangleParameters, normals[2]),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "any length",
     .help = "the normal at c"},
    [ROW_PLACES] = {.name = "ta",
                    .type = PARAMETER_PAIR,
                    .offset = offsetof(TriangleParameters, places[0]),
                    .minimum = -LENGTH_MAXIMUM,
                    .maximum = LENGTH_MAXIMUM,
                    .unit = "pictures",
                    .help = "where a lies in a picture"},
    {.name = "tb",
     .type = PARAMETER_PAIR,
     .offset = offsetof(TriangleParameters, places[1]),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "pictures",
     .help = "where b lies"},
    {.name = "tc",
     .type = PARAMETER_PAIR,
     .offset = offsetof(TriangleParameters, places[2]),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "pictures",
     .help = "where c lies"},
    {0}};

/** Half of a square of side 1 that faces the viewer. */
static const TriangleParameters triangle_defaults = {.corners = {{0}, {1, 0, 0}, {0, 1, 0}},
                                                     .places = {{0}, {1, 0}, {0, 1}}};

/**
 * Says whether three fields were given: all of them or none.
 * @param given       Bits of the rows that were.
 * @param row         The first of the three.
 * @param[out] is_given  Whether all were.
 * @return false if only some were.
 */
static bool three_given(uint64_t given, int row, bool *is_given) {
    uint64_t bits = given >> row & ROWS_OF_THREE;
    *is_given = bits == ROWS_OF_THREE;
    return *is_given || bits == 0;
}

/**
 * Refuses triangles without area, and normals or places of some corners only. See #Keyword.finish.
 * @param[in,out] values  A #TriangleParameters.
 * @param given           Which rows were given.
 * @param[out] error      What is wrong.
 * @return Whether the triangle is a whole one.
 */
static bool triangle_finish(void *values, uint64_t given, Error *error) {
    TriangleParameters *p = values;
    /** Sine of the angle below which two edges count as parallel: a double cannot tell less. */
    const double parallel = 1e-12;
    Vector3 b = vector3_subtract(p->corners[1], p->corners[0]);
    Vector3 c = vector3_subtract(p->corners[2], p->corners[0]);
    Vector3 normal = vector3_cross(vector3_normalize(b), vector3_normalize(c));
    if (!(vector3_length(normal) > parallel)) {
        return error_set(error, STATUS_SCENE, "triangle has no area: its corners are in a line");
    }
    if (!three_given(given, ROW_NORMALS, &p->is_smooth)) {
        return error_set(error, STATUS_SCENE, "triangle takes na, nb and nc, or none of them");
    }
    bool has_places;
    if (!three_given(given, ROW_PLACES, &has_places)) {
        return error_set(error, STATUS_SCENE, "triangle takes ta, tb and tc, or none of them");
    }
    return true;
}

/**
 * Makes ready the normals at the corners. The plane's own is turned to their side.
 * @param[in,out] self  The triangle; its plane is there.
 * @param normals       The normals, of any length.
 */
static void triangle_smooth(Triangle *self, const Vector3 *normals) {
    wide_scalar side = 0;
    for (int i = 0; i < TRIANGLE_CORNERS; i++) {
        WidePoint normal = wide_point_normalize(wide_point_of(vector3_scaled(normals[i])));
        side += wide_point_dot(normal, self->flat.wide_normal);
        self->normals[i] = point_narrow(normal);
    }
    if (side < 0) {
        self->flat.wide_normal = wide_point_scale(self->flat.wide_normal, -1);
        self->flat.normal = point_narrow(self->flat.wide_normal);
    }
}

/** Makes a triangle. @param self The triangle. @param parameters A #TriangleParameters. */
static void triangle_init(Shape *self, const void *parameters) {
    Triangle *triangle = (Triangle *)self;
    const TriangleParameters *p = parameters;
    for (int i = 0; i < TRIANGLE_CORNERS; i++) {
        triangle->corners[i] = corner_of(p->corners[i]);
    }
    // The plane is that of the corners as they are rounded: a sliver's would be another.
    WidePoint a = corner_widen(triangle->corners[0]);
    WidePoint b = wide_point_subtract(corner_widen(triangle->corners[1]), a);
    WidePoint c = wide_point_subtract(corner_widen(triangle->corners[2]), a);
    triangle->flat = flat_of(vector3_of(a), wide_point_cross(b, c));
    triangle->shares = shares_of(b, c);
    memcpy(triangle->places, p->places, sizeof p->places);
    triangle->is_smooth = p->is_smooth;
    if (p->is_smooth) {
        triangle_smooth(triangle, p->normals);
    }
}

/**
 * @return Where rays that pass inside a triangle meet it.
 * @param triangle  The triangle.
 * @param ray       The rays.
 */
INLINE real triangle_distance(const Triangle *triangle, const Ray *ray) {
    WideVector direction = vector_widen(ray->direction), origin = vector_widen(ray->origin);
    wide per_length_squared = 1 / wide_dot(direction, direction);
    real low = real_of(INFINITE), high = real_of(-INFINITE);
    for (int i = 0; i < TRIANGLE_CORNERS; i++) {
        WideVector to_corner =
            wide_subtract(wide_vector_of(corner_widen(triangle->corners[i])), origin);
        real depth = narrow(wide_dot(to_corner, direction) * per_length_squared);
        low = real_min(depth, low);
        high = real_max(depth, high);
    }
    // In the plane itself the distance is no number; the nearest corner's is as good as any.
    return real_min(real_max(flat_distance(&triangle->flat, ray), low), high);
}

/**
 * @return How much of each corner is in points.
 * @param triangle  The triangle.
 * @param from_a    The points, from its first corner.
 */
INLINE Vector triangle_shares(const Triangle *triangle, WideVector from_a) {
    const real zero = real_of(0), one = real_of(1);
    real b = narrow(wide_dot(from_a, wide_vector_of(triangle->shares.of_first)));
    real c = narrow(wide_dot(from_a, wide_vector_of(triangle->shares.of_second)));
    b = real_min(real_max(b, zero), one);
    c = real_min(real_max(c, zero), one);
    return (Vector){real_max(one - b - c, zero), b, c};
}

/**
 * @return The normal between those at the corners, by how much of each is in a point.
 * @param triangle  The triangle.
 * @param ray       The rays.
 * @param distance  Where they meet it.
 */
INLINE Vector triangle_interpolate(const Triangle *triangle, const Ray *ray, real distance) {
    WideVector from_a =
        wide_subtract(vector_widen(ray->origin), wide_vector_of(triangle->flat.wide_anchor));
    from_a = wide_add_scaled(from_a, vector_widen(ray->direction), widen(distance));
    Vector shares = triangle_shares(triangle, from_a);
    Vector sum = vector_scale(vector_of_point(triangle->normals[0]), shares.x);
    sum = vector_add(sum, vector_scale(vector_of_point(triangle->normals[1]), shares.y));
    return vector_add(sum, vector_scale(vector_of_point(triangle->normals[2]), shares.z));
}

/**
 * @return Where rays meet a triangle, in full.
 * @param triangle  The triangle.
 * @param ray       The rays.
 * @param distance  Where.
 */
INLINE Hit triangle_hit(const Triangle *triangle, const Ray *ray, real distance) {
    Hit found = flat_hit(&triangle->flat, ray, distance, triangle->base.place);
    if (triangle->is_smooth) {
        Vector flat = found.normal;
        Vector normal = triangle_interpolate(triangle, ray, distance);
        found.normal = normal_keep_side(normal, flat, ray->direction);
        // Along a normal that leans, it is farther out of the plane's error.
        found.error = found.error / vector_dot(found.normal, flat);
    }
    return found;
}

/** @return The lanes where the triangle is nearer. See #ShapeClass.is_hit. @callgraph
 *  @param self The triangle. @param ray The rays. @param active The lanes.
 *  @param[in,out] hit The hit. */
static mask triangle_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const Triangle *triangle = (const Triangle *)self;
    mask inside = shear_is_inside(triangle->corners, TRIANGLE_CORNERS, ray, active);
    if (!any(inside)) {
        return inside;
    }
    real distance = triangle_distance(triangle, ray);
    mask nearer = hit_is_nearer(hit, inside, distance, self->place);
    if (any(nearer)) {
        Hit found = triangle_hit(triangle, ray, distance);
        hit_take(hit, nearer, &found);
    }
    return nearer;
}

/** @return The lanes where the triangle is on the way. See #ShapeClass.is_blocking.
 *  @param self The triangle. @param ray The rays. @param active The lanes.
 *  @param limit The way's end. */
static mask triangle_is_blocking(const Shape *self, const Ray *ray, mask active, real limit) {
    const Triangle *triangle = (const Triangle *)self;
    mask inside = shear_is_inside(triangle->corners, TRIANGLE_CORNERS, ray, active);
    if (!any(inside)) {
        return inside;
    }
    real distance = triangle_distance(triangle, ray);
    return inside & (distance > 0) & (distance < limit);
}

/** @return The box around a triangle. @param self The triangle. */
static Bounds triangle_bounds(const Shape *self) {
    return corners_bounds(((const Triangle *)self)->corners, TRIANGLE_CORNERS);
}

/** @return Where on a picture points of a triangle lie: between the places of its corners. See
 *  #ShapeClass.texture_place. @param self The triangle. @param hit The points. @param lanes Not
 *  looked at. */
static TexturePlace triangle_texture_place(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Triangle *triangle = (const Triangle *)self;
    const Pair *at = triangle->places;
    WideVector from_a =
        wide_subtract(vector_widen(hit->point), wide_vector_of(triangle->flat.wide_anchor));
    Vector shares = triangle_shares(triangle, from_a);
    return (TexturePlace){
        .u = shares.x * (scalar)at[0].u + shares.y * (scalar)at[1].u + shares.z * (scalar)at[2].u,
        .v = shares.x * (scalar)at[0].v + shares.y * (scalar)at[1].v + shares.z * (scalar)at[2].v,
        .around_u = mask_of(true),
        .around_v = mask_of(true)};
}

const ShapeClass triangle_class = {
    .keyword = {.name = "triangle",
                .help = "a triangle, flat or smooth",
                .parameters = triangle_parameters,
                .size = sizeof(TriangleParameters),
                .defaults = &triangle_defaults,
                .finish = triangle_finish},
    .size = sizeof(Triangle),
    .is_flat = true,
    .init = triangle_init,
    .is_hit = triangle_is_hit,
    .is_blocking = triangle_is_blocking,
    .bounds = triangle_bounds,
    .texture_place = triangle_texture_place,
};
