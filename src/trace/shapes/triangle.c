/**
 * @file
 * @brief Triangle, seen from both sides (row D1); flat, or shaded by a normal at each corner.
 *
 * Whether it is met is decided watertight, from its edges alone. Where: on its plane, but never
 * before the nearest corner or behind the farthest, which a sliver's plane alone does not know.
 */
#include "trace/shapes/plane_equation.h"
#include "trace/shapes/registry.h"
#include "trace/shapes/shading_normal.h"
#include "trace/shapes/watertight.h"

#include <string.h>

/** Corners of a triangle. */
enum { TRIANGLE_CORNERS = 3 };

/** What a scene file says of a triangle. */
typedef struct TriangleParameters {
    Vec3d corners[TRIANGLE_CORNERS]; /**< Its corners. */
    Vec3d normals[TRIANGLE_CORNERS]; /**< The normals there, of any length. */
    Uvd uvs[TRIANGLE_CORNERS];       /**< The places in a picture there. */
    bool is_smooth;                  /**< Whether normals were given. */
} TriangleParameters;

/** A triangle. @extends Shape */
typedef struct Triangle {
    Shape base;                       /**< What all shapes have. */
    PlaneEquation plane;              /**< Its plane; its normal is (b - a) x (c - a). */
    Vertex corners[TRIANGLE_CORNERS]; /**< Its corners. */
    Vec3s normals[TRIANGLE_CORNERS];  /**< The unit normals there. */
    DualBasis dual_basis;             /**< How much of b and of c is in a point. */
    Uvd uvs[TRIANGLE_CORNERS];        /**< Where the corners lie on a picture. */
    bool is_smooth;                   /**< Whether the normals count. */
} Triangle;

/** Rows of the table, in its order. */
enum { TRIANGLE_ROW_NORMALS = 3, TRIANGLE_ROW_UVS = 6 };

/** Bits of three rows of the table. */
#define THREE_ROW_BITS 7u

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
    [TRIANGLE_ROW_NORMALS] = {.name = "na",
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
    [TRIANGLE_ROW_UVS] = {.name = "ta",
                          .type = PARAMETER_UV,
                          .offset = offsetof(TriangleParameters, uvs[0]),
                          .minimum = -LENGTH_MAXIMUM,
                          .maximum = LENGTH_MAXIMUM,
                          .unit = "pictures",
                          .help = "where a lies in a picture"},
    {.name = "tb",
     .type = PARAMETER_UV,
     .offset = offsetof(TriangleParameters, uvs[1]),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "pictures",
     .help = "where b lies"},
    {.name = "tc",
     .type = PARAMETER_UV,
     .offset = offsetof(TriangleParameters, uvs[2]),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "pictures",
     .help = "where c lies"},
    {0}};

/** Half of a square of side 1 that faces the viewer. */
static const TriangleParameters triangle_defaults = {.corners = {{0}, {1, 0, 0}, {0, 1, 0}},
                                                     .uvs = {{0}, {1, 0}, {0, 1}}};

/**
 * Says whether three fields were given: all of them or none.
 * @param given  Bits of the rows that were.
 * @param row  The first of the three.
 * @return false if only some were.
 */
static bool three_rows_given(uint64_t given, int row, bool *is_given) {
    uint64_t bits = given >> row & THREE_ROW_BITS;
    *is_given = bits == THREE_ROW_BITS;
    return *is_given || bits == 0;
}

/**
 * Refuses triangles without area, and normals or places of some corners only. See #Keyword.finish.
 * @param given  Which rows were given.
 * @return Whether the triangle is a whole one.
 */
static bool triangle_finish(void *values, uint64_t given, Error *error) {
    TriangleParameters *p = values;
    /** Sine of the angle below which two edges count as parallel: a double cannot tell less. */
    const double parallel = 1e-12;
    Vec3d b = vec3d_subtract(p->corners[1], p->corners[0]);
    Vec3d c = vec3d_subtract(p->corners[2], p->corners[0]);
    Vec3d normal = vec3d_cross(vec3d_normalize(b), vec3d_normalize(c));
    if (!(vec3d_length(normal) > parallel)) {
        return error_set(error, STATUS_SCENE, "triangle has no area: its corners are in a line");
    }
    if (!three_rows_given(given, TRIANGLE_ROW_NORMALS, &p->is_smooth)) {
        return error_set(error, STATUS_SCENE, "triangle takes na, nb and nc, or none of them");
    }
    bool has_uvs;
    if (!three_rows_given(given, TRIANGLE_ROW_UVS, &has_uvs)) {
        return error_set(error, STATUS_SCENE, "triangle takes ta, tb and tc, or none of them");
    }
    return true;
}

/**
 * Makes ready the normals at the corners. The plane's own is turned to their side.
 * @param[in,out] self  The triangle; its plane is there.
 * @param normals       The normals, of any length.
 */
static void triangle_init_normals(Triangle *self, const Vec3d *normals) {
    wide_scalar side = 0;
    for (int i = 0; i < TRIANGLE_CORNERS; i++) {
        Vec3sw normal = vec3sw_normalize(vec3sw_of(vec3d_scale_exponent(normals[i])));
        side += vec3sw_dot(normal, self->plane.wide_normal);
        self->normals[i] = vec3s_narrow(normal);
    }
    if (side < 0) {
        self->plane.wide_normal = vec3sw_scale(self->plane.wide_normal, -1);
        self->plane.normal = vec3s_narrow(self->plane.wide_normal);
    }
}

/** Makes a triangle. */
static void triangle_init(Shape *self, const void *parameters) {
    Triangle *triangle = (Triangle *)self;
    const TriangleParameters *p = parameters;
    for (int i = 0; i < TRIANGLE_CORNERS; i++) {
        triangle->corners[i] = vertex_of(p->corners[i]);
    }
    // The plane is that of the corners as they are rounded: a sliver's would be another.
    Vec3sw a = vertex_widen(triangle->corners[0]);
    Vec3sw b = vec3sw_subtract(vertex_widen(triangle->corners[1]), a);
    Vec3sw c = vec3sw_subtract(vertex_widen(triangle->corners[2]), a);
    triangle->plane = plane_equation_of(vec3d_of(a), vec3sw_cross(b, c));
    triangle->dual_basis = dual_basis_of(b, c);
    memcpy(triangle->uvs, p->uvs, sizeof p->uvs);
    triangle->is_smooth = p->is_smooth;
    if (p->is_smooth) {
        triangle_init_normals(triangle, p->normals);
    }
}

/** @return Where rays that pass inside a triangle meet it. */
INLINE real triangle_distance(const Triangle *triangle, const Ray *ray) {
    Vec3w direction = vec3_widen(ray->direction), origin = vec3_widen(ray->origin);
    wide per_length_squared = 1 / vec3w_dot(direction, direction);
    real low = real_of(INFINITE), high = real_of(-INFINITE);
    for (int i = 0; i < TRIANGLE_CORNERS; i++) {
        Vec3w to_corner = vec3w_subtract(vec3w_splat(vertex_widen(triangle->corners[i])), origin);
        real depth = narrow(vec3w_dot(to_corner, direction) * per_length_squared);
        low = real_min(depth, low);
        high = real_max(depth, high);
    }
    // In the plane itself the distance is no number; the nearest corner's is as good as any.
    return real_min(real_max(plane_equation_distance(&triangle->plane, ray), low), high);
}

/**
 * @return How much of each corner is in points.
 * @param from_a  The points, from its first corner.
 */
INLINE Vec3 triangle_barycentrics(const Triangle *triangle, Vec3w from_a) {
    const real zero = real_of(0), one = real_of(1);
    real b = narrow(vec3w_dot(from_a, vec3w_splat(triangle->dual_basis.first)));
    real c = narrow(vec3w_dot(from_a, vec3w_splat(triangle->dual_basis.second)));
    b = real_min(real_max(b, zero), one);
    c = real_min(real_max(c, zero), one);
    return (Vec3){real_max(one - b - c, zero), b, c};
}

/**
 * @return The normal between those at the corners, by how much of each is in a point.
 * @param distance  Where they meet it.
 */
INLINE Vec3 triangle_interpolate_normal(const Triangle *triangle, const Ray *ray, real distance) {
    Vec3w from_a =
        vec3w_subtract(vec3_widen(ray->origin), vec3w_splat(triangle->plane.wide_anchor));
    from_a = vec3w_add_scaled(from_a, vec3_widen(ray->direction), widen(distance));
    Vec3 barycentrics = triangle_barycentrics(triangle, from_a);
    Vec3 sum = vec3_scale(vec3_splat(triangle->normals[0]), barycentrics.x);
    sum = vec3_add(sum, vec3_scale(vec3_splat(triangle->normals[1]), barycentrics.y));
    return vec3_add(sum, vec3_scale(vec3_splat(triangle->normals[2]), barycentrics.z));
}

/** @return Where rays meet a triangle, in full. */
INLINE Hit triangle_make_hit(const Triangle *triangle, const Ray *ray, real distance) {
    Hit found = plane_equation_hit(&triangle->plane, ray, distance, triangle->base.index);
    if (triangle->is_smooth) {
        Vec3 flat_normal = found.normal;
        Vec3 normal = triangle_interpolate_normal(triangle, ray, distance);
        found.normal = shading_normal_keep_side(normal, flat_normal, ray->direction);
        // Along a normal that leans, it is farther out of the plane's error.
        found.error = found.error / vec3_dot(found.normal, flat_normal);
    }
    return found;
}

/** @return The lanes where the triangle is nearer. See #ShapeClass.is_hit. @callgraph */
static mask triangle_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const Triangle *triangle = (const Triangle *)self;
    mask inside = polygon_contains_ray(triangle->corners, TRIANGLE_CORNERS, ray, active);
    if (!any(inside)) {
        return inside;
    }
    real distance = triangle_distance(triangle, ray);
    mask nearer = hit_is_nearer(hit, inside, distance, self->index);
    if (any(nearer)) {
        Hit found = triangle_make_hit(triangle, ray, distance);
        hit_update(hit, nearer, &found);
    }
    return nearer;
}

/** @return The lanes where the triangle is on the way. See #ShapeClass.is_occluding. */
static mask triangle_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    const Triangle *triangle = (const Triangle *)self;
    mask inside = polygon_contains_ray(triangle->corners, TRIANGLE_CORNERS, ray, active);
    if (!any(inside)) {
        return inside;
    }
    real distance = triangle_distance(triangle, ray);
    return inside & (distance > 0) & (distance < limit);
}

/** @return The box around a triangle. */
static Aabbs triangle_bounds(const Shape *self) {
    return vertices_bounds(((const Triangle *)self)->corners, TRIANGLE_CORNERS);
}

/** @return Where on a picture points of a triangle lie: between the places of its corners. See
 *  #ShapeClass.texture_uv. */
static TextureUv triangle_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Triangle *triangle = (const Triangle *)self;
    const Uvd *uvs = triangle->uvs;
    Vec3w from_a = vec3w_subtract(vec3_widen(hit->point), vec3w_splat(triangle->plane.wide_anchor));
    Vec3 barycentrics = triangle_barycentrics(triangle, from_a);
    return (TextureUv){.u = barycentrics.x * (scalar)uvs[0].u + barycentrics.y * (scalar)uvs[1].u +
                            barycentrics.z * (scalar)uvs[2].u,
                       .v = barycentrics.x * (scalar)uvs[0].v + barycentrics.y * (scalar)uvs[1].v +
                            barycentrics.z * (scalar)uvs[2].v,
                       .wrap_u = mask_of(true),
                       .wrap_v = mask_of(true)};
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
    .is_occluding = triangle_is_occluding,
    .bounds = triangle_bounds,
    .texture_uv = triangle_texture_uv,
};
