/**
 * @file
 * @brief Triangle, visible from both sides; flat, or shaded with a normal at each vertex.
 *
 * The edges alone decide whether a ray meets it (watertight.h). The distance is that of its plane,
 * but never before the nearest vertex or behind the farthest: the plane of a sliver is not exact.
 */
#include "trace/shapes/plane_equation.h"
#include "trace/shapes/shading_normal.h"
#include "trace/shapes/watertight.h"

#include <string.h>

/** Number of vertices. */
enum { TRIANGLE_CORNERS = 3 };

/** A triangle. @extends Shape */
typedef struct Triangle {
    Shape base;                       /**< Base. */
    PlaneEquation plane;              /**< Its plane; its normal is (b - a) x (c - a). */
    Vertex corners[TRIANGLE_CORNERS]; /**< Vertices. */
    Vec3s normals[TRIANGLE_CORNERS];  /**< Unit normals at the vertices; used if #is_smooth. */
    DualBasis dual_basis;             /**< For the barycentric coordinates of b and c. */
    Uvd uvs[TRIANGLE_CORNERS];        /**< Texture coordinates of the vertices. */
    Aabbs bounds;                     /**< Bounding box. */
    bool is_smooth;                   /**< Whether normals are interpolated. */
} Triangle;

/**
 * Initialises the normals at the vertices, and turns the normal of the plane to their side.
 * @param[in,out] self  The triangle; its plane is initialised.
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

/** See #ShapeClass.init. */
static void triangle_init(Shape *self, const void *parameters) {
    Triangle *triangle = (Triangle *)self;
    const TriangleParameters *p = parameters;
    for (int i = 0; i < TRIANGLE_CORNERS; i++) {
        triangle->corners[i] = vertex_of(p->corners[i]);
    }
    // The plane of the rounded vertices: that of a sliver differs from the exact one.
    Vec3sw a = vertex_widen(triangle->corners[0]);
    Vec3sw b = vec3sw_subtract(vertex_widen(triangle->corners[1]), a);
    Vec3sw c = vec3sw_subtract(vertex_widen(triangle->corners[2]), a);
    triangle->plane = plane_equation_of(vec3d_of(a), vec3sw_cross(b, c));
    triangle->dual_basis = dual_basis_of(b, c);
    memcpy(triangle->uvs, p->uvs, sizeof p->uvs);
    triangle->bounds = vertices_bounds(triangle->corners, TRIANGLE_CORNERS);
    triangle->is_smooth = p->is_smooth;
    if (p->is_smooth) {
        triangle_init_normals(triangle, p->normals);
    }
}

/** @return The distance of rays that pass inside the edges. */
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
    // For rays in the plane itself the distance is NaN; real_min and real_max then give a vertex's.
    return real_min(real_max(plane_equation_distance(&triangle->plane, ray), low), high);
}

/** @return Barycentric coordinates of points. @param from_a The points, relative to a. */
INLINE Vec3 triangle_barycentrics(const Triangle *triangle, Vec3w from_a) {
    const real zero = real_of(0), one = real_of(1);
    real b = narrow(vec3w_dot(from_a, vec3w_splat(triangle->dual_basis.first)));
    real c = narrow(vec3w_dot(from_a, vec3w_splat(triangle->dual_basis.second)));
    b = real_min(real_max(b, zero), one);
    c = real_min(real_max(c, zero), one);
    return (Vec3){real_max(one - b - c, zero), b, c};
}

/** @return The normals interpolated at the hits, of any length. */
INLINE Vec3 triangle_interpolate_normal(const Triangle *triangle, const Ray *ray, real distance) {
    Vec3w from_a =
        vec3w_subtract(vec3_widen(ray->origin), vec3w_splat(triangle->plane.wide_anchor));
    from_a = vec3w_add_scaled(from_a, vec3_widen(ray->direction), widen(distance));
    Vec3 barycentrics = triangle_barycentrics(triangle, from_a);
    Vec3 sum = vec3_scale(vec3_splat(triangle->normals[0]), barycentrics.x);
    sum = vec3_add(sum, vec3_scale(vec3_splat(triangle->normals[1]), barycentrics.y));
    return vec3_add(sum, vec3_scale(vec3_splat(triangle->normals[2]), barycentrics.z));
}

/** Finds rays whose line passes inside the edges. See #IntersectFunction. */
INLINE mask triangle_intersect(const Shape *self, const Ray *ray, mask active, real *distance,
                               void *roots) {
    (void)roots;
    const Triangle *triangle = (const Triangle *)self;
    mask inside = polygon_contains_ray(triangle->corners, TRIANGLE_CORNERS, ray, active);
    if (any(inside)) {
        inside = polygon_rays_in_box(&triangle->bounds, ray, inside);
        *distance = triangle_distance(triangle, ray);
    }
    return inside;
}

/** See #SurfaceFunction. */
INLINE SurfacePoint triangle_surface(const Shape *self, const Ray *ray, real distance,
                                     const void *roots) {
    (void)roots;
    const Triangle *triangle = (const Triangle *)self;
    SurfacePoint surface = plane_equation_surface(&triangle->plane, ray, distance);
    if (triangle->is_smooth) {
        Vec3 flat_normal = surface.normal;
        Vec3 normal = triangle_interpolate_normal(triangle, ray, distance);
        surface.normal = shading_normal_keep_side(normal, flat_normal, ray->direction);
        // Along an oblique normal, the same distance from the plane is longer.
        surface.error = surface.error / vec3_dot(surface.normal, flat_normal);
    }
    return surface;
}

/** See #ShapeClass.is_hit. @callgraph */
static mask triangle_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    return primitive_is_hit(self, ray, active, hit, triangle_intersect, triangle_surface, NULL);
}

/** See #ShapeClass.is_occluding. */
static mask triangle_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    return primitive_is_occluding(self, ray, active, limit, triangle_intersect, NULL);
}

/** See #ShapeClass.support. */
static real triangle_support(const Shape *self, Vec3s from, Vec3 directions) {
    return vertices_support(((const Triangle *)self)->corners, TRIANGLE_CORNERS, from, directions);
}

/** See #ShapeClass.bounds. */
static Aabbs triangle_bounds(const Shape *self) {
    return ((const Triangle *)self)->bounds;
}

/** @return Interpolated texture coordinates. See #ShapeClass.texture_uv. */
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

/** Methods of `triangle`. */
const ShapeClass triangle_class = {
    .size = sizeof(Triangle),
    .init = triangle_init,
    .is_hit = triangle_is_hit,
    .is_occluding = triangle_is_occluding,
    .support = METHOD_OF_BEAMS(triangle_support),
    .bounds = triangle_bounds,
    .texture_uv = triangle_texture_uv,
};
