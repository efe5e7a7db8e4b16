/**
 * @file
 * @brief Spheres as the reports intersect them, with the errors of their formulas: all in the
 *        number type of the engine, and in coordinates of the world.
 */
#include "trace/shapes/report_sphere.h"

#include "trace/bvh/slab.h"
#include "trace/mesh/mesh_bvh.h"

/** Bound on the error of a point, in half ulps of its coordinates, as if the formulas had no error
 *  of their own: so offsets are as short as those of other shapes. */
#define REPORT_SPHERE_ERROR 8

/** Bound on the error of a squared distance to the centre, in half ulps of the squared sum of all
 *  coordinates: there are some ten roundings, of up to three products per axis. */
#define REPORT_SPHERE_SQUARED_ERROR 96

/** A sphere of a report. @extends Shape */
typedef struct ReportSphere {
    Shape base;    /**< Base. */
    Vec3s center;  /**< Centre. */
    scalar radius; /**< Radius. */
    Aabbs box;     /**< Where hits count: see report_sphere_bind(). */
} ReportSphere;

/** See #ShapeClass.init. */
static void report_sphere_init(Shape *self, const void *parameters) {
    ReportSphere *sphere = (ReportSphere *)self;
    const SphereParameters *p = parameters;
    sphere->center = vec3s_narrow(vec3sw_of(p->center));
    sphere->radius = (scalar)p->radius;
}

/**
 * Finds the box in which hits count. The formulas have hits as far beside the sphere as their
 * errors reach; these grow with the distance of the ray's origin. The box holds what rays within
 * the scene bring about. Hits before it are none, since trees do not test what lies there. See
 * #ShapeExtension.bind.
 * @return true
 */
static bool report_sphere_bind(Shape *self, const SceneShape *scene_shape, MeshBvhCache *cache,
                               Error *error) {
    (void)error;
    ReportSphere *sphere = (ReportSphere *)self;
    Vec3d center = {(double)sphere->center.x, (double)sphere->center.y, (double)sphere->center.z};
    // Rays to a transformed shape start near it, in its own coordinates.
    double radius = (double)sphere->radius, middle = vec3d_max_abs(center),
           reach = scene_shape->transform ? middle + 4 * radius : cache->reach,
           length = reach + middle + radius,
           error_squared = REPORT_SPHERE_SQUARED_ERROR * (double)ROUNDOFF * length * length,
           r = sqrt(radius * radius + error_squared);
    sphere->box = aabbs_from_corners(vec3d_subtract(center, (Vec3d){r, r, r}),
                                     vec3d_add(center, (Vec3d){r, r, r}));
    return true;
}

/** @return The rays that meet the box, with hits behind its near side, and by more than any test of
 *  the box rounds: no test rules out what lies behind the far side. */
INLINE mask report_sphere_holds(const ReportSphere *sphere, const Ray *ray, real distance) {
    const Aabb box = aabb_splat(sphere->box);
    SlabSpan span = slab_span(ray->origin, ray->inverse_direction, &box, &SLAB_ORDERS[0], ALL_AXES,
                              real_of(INFINITE));
    mask meets = span.near * (1 + REGION_SLACK) <= span.far * (1 - REGION_SLACK);
    return meets & (distance >= span.near * (1 + REGION_SLACK));
}

/** @return The smallest positive solution of a t^2 + b t + c = 0, as the quadratic formula has it.
 *  @param[out] crosses The lanes with a solution. */
INLINE real quadratic_root(real a, real b, real c, mask active, mask *crosses) {
    real discriminant = b * b - 4 * a * c;
    *crosses = active & (discriminant >= 0);
    real root = real_sqrt(real_max(discriminant, real_of(0)));
    real near = (-b - root) / (2 * a), far = (-b + root) / (2 * a);
    return real_select(near > 0, near, far);
}

/** Report A: b and c of products that each have coordinates of the world. See #IntersectFunction.
 */
INLINE mask quadratic_intersect(const Shape *self, const Ray *ray, mask active, real *distance,
                                void *roots) {
    (void)roots;
    const ReportSphere *sphere = (const ReportSphere *)self;
    Vec3 p = vec3_splat(sphere->center), o = ray->origin, d = ray->direction;
    real a = vec3_dot(d, d), b = 2 * (vec3_dot(d, o) - vec3_dot(d, p));
    real c = vec3_dot(p, p) - 2 * vec3_dot(o, p) + vec3_dot(o, o) - sphere->radius * sphere->radius;
    mask crosses;
    *distance = quadratic_root(a, b, c, active, &crosses);
    return crosses & report_sphere_holds(sphere, ray, *distance);
}

/** Report C: b relative to the centre, c of coordinates of the world. See #IntersectFunction. */
INLINE mask quadratic_c_intersect(const Shape *self, const Ray *ray, mask active, real *distance,
                                  void *roots) {
    (void)roots;
    const ReportSphere *sphere = (const ReportSphere *)self;
    Vec3 center = vec3_splat(sphere->center), o = ray->origin, d = ray->direction;
    real a = vec3_dot(d, d), b = 2 * vec3_dot(d, vec3_subtract(o, center));
    real c = vec3_dot(o, o) + vec3_dot(center, center) - 2 * vec3_dot(center, o) -
             sphere->radius * sphere->radius;
    mask crosses;
    *distance = quadratic_root(a, b, c, active, &crosses);
    return crosses & report_sphere_holds(sphere, ray, *distance);
}

/** Report D: the foot H of the perpendicular, a point of the world, and half the chord from there.
 *  A ray that looks away from the centre meets nothing. See #IntersectFunction. */
INLINE mask projection_intersect(const Shape *self, const Ray *ray, mask active, real *distance,
                                 void *roots) {
    (void)roots;
    const ReportSphere *sphere = (const ReportSphere *)self;
    Vec3 center = vec3_splat(sphere->center), v = ray->direction;
    real squared = vec3_dot(v, v);
    real d = vec3_dot(vec3_subtract(center, ray->origin), v) / squared;
    Vec3 foot = vec3_add(ray->origin, vec3_scale(v, d)), u = vec3_subtract(foot, center);
    real l = sphere->radius * sphere->radius - vec3_dot(u, u);
    mask crosses = active & (d > 0) & (l >= 0);
    real half = real_sqrt(real_max(l, real_of(0)) / squared);
    *distance = real_select(d - half < 0, d + half, d - half);
    return crosses & report_sphere_holds(sphere, ray, *distance);
}

/** @return The points o + t d. See #SurfaceFunction. */
INLINE SurfacePoint report_sphere_surface(const Shape *self, const Ray *ray, real distance,
                                          const void *roots) {
    (void)roots;
    const ReportSphere *sphere = (const ReportSphere *)self;
    Vec3 point = vec3_add(ray->origin, vec3_scale(ray->direction, distance));
    Vec3 normal = vec3_normalize(vec3_subtract(point, vec3_splat(sphere->center)));
    real magnitude = vec3_max_abs(point) + sphere->radius;
    return (SurfacePoint){point, normal, REPORT_SPHERE_ERROR * ROUNDOFF * magnitude};
}

/** See #ShapeClass.bounds. */
static Aabbs report_sphere_bounds(const Shape *self) {
    return ((const ReportSphere *)self)->box;
}

/** @return Longitude and latitude, from the normal alone. See #ShapeClass.texture_uv. */
static TextureUv report_sphere_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    return sphere_class.texture_uv(self, hit, lanes);
}

/** @return Report D's rows: (1 - y) / 2 from above, equal in height. See #ShapeClass.texture_uv. */
static TextureUv projection_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    TextureUv uv = sphere_class.texture_uv(self, hit, lanes);
    uv.v = (1 + hit->normal.y) * (scalar)0.5f;
    return uv;
}

/** See #ShapeClass.is_hit. */
static mask quadratic_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    return primitive_is_hit(self, ray, active, hit, quadratic_intersect, report_sphere_surface,
                            NULL);
}

/** See #ShapeClass.is_occluding. */
static mask quadratic_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    return primitive_is_occluding(self, ray, active, limit, quadratic_intersect, NULL);
}

/** What spheres of reports are beyond a primitive. */
static const ShapeExtension report_sphere_extension = {.bind = report_sphere_bind};

/** Spheres of report A. */
static const ShapeClass quadratic_class = {
    .size = sizeof(ReportSphere),
    .init = report_sphere_init,
    .is_hit = quadratic_is_hit,
    .is_occluding = quadratic_is_occluding,
    .bounds = report_sphere_bounds,
    .extension = &report_sphere_extension,
    .texture_uv = report_sphere_texture_uv,
};

/** See #ShapeClass.is_hit. */
static mask quadratic_c_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    return primitive_is_hit(self, ray, active, hit, quadratic_c_intersect, report_sphere_surface,
                            NULL);
}

/** See #ShapeClass.is_occluding. */
static mask quadratic_c_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    return primitive_is_occluding(self, ray, active, limit, quadratic_c_intersect, NULL);
}

/** Spheres of report C. */
static const ShapeClass quadratic_c_class = {
    .size = sizeof(ReportSphere),
    .init = report_sphere_init,
    .is_hit = quadratic_c_is_hit,
    .is_occluding = quadratic_c_is_occluding,
    .bounds = report_sphere_bounds,
    .extension = &report_sphere_extension,
    .texture_uv = report_sphere_texture_uv,
};

/** See #ShapeClass.is_hit. */
static mask projection_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    return primitive_is_hit(self, ray, active, hit, projection_intersect, report_sphere_surface,
                            NULL);
}

/** See #ShapeClass.is_occluding. */
static mask projection_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    return primitive_is_occluding(self, ray, active, limit, projection_intersect, NULL);
}

/** Spheres of report D. */
static const ShapeClass projection_class = {
    .size = sizeof(ReportSphere),
    .init = report_sphere_init,
    .is_hit = projection_is_hit,
    .is_occluding = projection_is_occluding,
    .bounds = report_sphere_bounds,
    .extension = &report_sphere_extension,
    .texture_uv = projection_texture_uv,
};

const ShapeClass *report_shape_class(const ShapeClass *own, unsigned methods) {
    if (own != &sphere_class) {
        return own;
    }
    return methods & METHOD_SPHERE_QUADRATIC     ? &quadratic_class
           : methods & METHOD_SPHERE_QUADRATIC_C ? &quadratic_c_class
           : methods & METHOD_SPHERE_PROJECTION  ? &projection_class
                                                 : own;
}
