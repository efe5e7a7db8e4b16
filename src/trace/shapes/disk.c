/**
 * @file
 * @brief Disk: the inside of a circle, visible from both sides.
 *
 * At the point where the ray crosses the plane, the vector from the centre is compared with the
 * radius. It is computed relative to the origin of the ray, in the wide precision and before any
 * division: the outline of a far disk is as exact as that of a near one.
 */
#include "trace/shapes/plane_equation.h"
#include "trace/shapes/support.h"

/** A disk. @extends Shape */
typedef struct Disk {
    Shape base;          /**< Base. */
    PlaneEquation plane; /**< The plane of the disk; its anchor is the centre. */
    wide_scalar radius;  /**< Radius. */
} Disk;

/** See #ShapeClass.init. */
static void disk_init(Shape *self, const void *parameters) {
    Disk *disk = (Disk *)self;
    const DiskParameters *p = parameters;
    disk->plane = plane_equation_of(p->center, vec3sw_of(vec3d_scale_exponent(p->normal)));
    disk->radius = (wide_scalar)p->radius;
}

/** Finds rays whose line passes through the disk. See #IntersectFunction. */
INLINE mask disk_intersect(const Shape *self, const Ray *ray, mask active, real *distance,
                           void *roots) {
    (void)roots;
    const Disk *disk = (const Disk *)self;
    PlaneHit plane_hit = plane_equation_intersect(&disk->plane, ray);
    *distance = plane_hit_distance(&plane_hit);
    // The vector from the centre is direction * height / slope - to_anchor; here times the slope.
    Vec3w scaled_direction = vec3w_scale(vec3_widen(ray->direction), plane_hit.height);
    Vec3w from_center = vec3w_add_scaled(scaled_direction, plane_hit.to_anchor, -plane_hit.slope);
    wide scaled_radius = plane_hit.slope * wide_of(disk->radius);
    return active & narrow_mask(wide_less_equal(vec3w_dot(from_center, from_center),
                                                scaled_radius * scaled_radius));
}

/** See #SurfaceFunction. */
INLINE SurfacePoint disk_surface(const Shape *self, const Ray *ray, real distance,
                                 const void *roots) {
    (void)roots;
    return plane_equation_surface(&((const Disk *)self)->plane, ray, distance);
}

/** See #ShapeClass.is_hit. @callgraph */
static mask disk_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    return primitive_is_hit(self, ray, active, hit, disk_intersect, disk_surface, NULL);
}

/** See #ShapeClass.is_occluding. */
static mask disk_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    return primitive_is_occluding(self, ray, active, limit, disk_intersect, NULL);
}

/** See #ShapeClass.support. */
static real disk_support(const Shape *self, Vec3s from, Vec3 directions) {
    const Disk *disk = (const Disk *)self;
    const scalar radius = (scalar)disk->radius;
    Vec3s to_center = support_vector(from, disk->plane.wide_anchor);
    return support_of_point(to_center, radius, directions) +
           radius * support_of_circle(disk->plane.normal, directions);
}

/** See #ShapeClass.bounds. */
static Aabbs disk_bounds(const Shape *self) {
    const Disk *disk = (const Disk *)self;
    Vec3d center = vec3d_of(disk->plane.wide_anchor);
    Vec3d extent = circle_extent(vec3d_of(disk->plane.wide_normal), (double)disk->radius);
    return aabbs_from_corners(vec3d_subtract(center, extent), vec3d_add(center, extent));
}

/** @return Coordinates in the largest circle inside the picture. See #ShapeClass.texture_uv. */
static TextureUv disk_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Disk *disk = (const Disk *)self;
    UvFrame frame = uv_frame_of(disk->plane.wide_normal);
    Vec3w from_center =
        vec3w_subtract(vec3_widen(hit->point), vec3w_splat(disk->plane.wide_anchor));
    return circle_texture_uv(vec3w_scale(from_center, wide_of(1 / disk->radius)), &frame);
}

/** Methods of `disk`. */
const ShapeClass disk_class = {
    .size = sizeof(Disk),
    .form = FORM_FLAT,
    .init = disk_init,
    .is_hit = disk_is_hit,
    .is_occluding = disk_is_occluding,
    .support = METHOD_OF_BEAMS(disk_support),
    .bounds = disk_bounds,
    .texture_uv = disk_texture_uv,
};
