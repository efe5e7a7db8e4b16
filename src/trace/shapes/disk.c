/**
 * @file
 * @brief Disk: the inside of a circle, seen from both sides (row D1).
 *
 * Where the ray crosses the plane, the vector from the centre is compared with the radius. It is
 * taken relative to the ray's origin, in the wide precision and before anything is divided, so that
 * the outline of a far disk is as good as that of a near one.
 */
#include "trace/shapes/circle.h"
#include "trace/shapes/plane_equation.h"
#include "trace/shapes/registry.h"
#include "trace/shapes/uv_frame.h"

/** What a scene file says of a disk. */
typedef struct DiskParameters {
    Vec3d center;  /**< Its centre. */
    Vec3d normal;  /**< Its normal, of any length. */
    double radius; /**< Its radius, scene units. */
} DiskParameters;

/** A disk. @extends Shape */
typedef struct Disk {
    Shape base;          /**< What all shapes have. */
    PlaneEquation plane; /**< The plane that it lies in; its anchor is the centre. */
    wide_scalar radius;  /**< Its radius. */
} Disk;

/** Fields of `disk`. */
static const Parameter disk_parameters[] = {{.name = "center",
                                             .type = PARAMETER_POINT,
                                             .offset = offsetof(DiskParameters, center),
                                             .minimum = -LENGTH_MAXIMUM,
                                             .maximum = LENGTH_MAXIMUM,
                                             .unit = "scene units",
                                             .help = "its centre"},
                                            {.name = "normal",
                                             .type = PARAMETER_DIRECTION,
                                             .offset = offsetof(DiskParameters, normal),
                                             .minimum = -LENGTH_MAXIMUM,
                                             .maximum = LENGTH_MAXIMUM,
                                             .unit = "any length",
                                             .help = "its normal"},
                                            {.name = "radius",
                                             .type = PARAMETER_NUMBER,
                                             .offset = offsetof(DiskParameters, radius),
                                             .minimum = LENGTH_MINIMUM,
                                             .maximum = LENGTH_MAXIMUM,
                                             .unit = "scene units",
                                             .help = "its radius"},
                                            {0}};

/** A disk of radius 1 that lies on the ground. */
static const DiskParameters disk_defaults = {.normal = {0, 1, 0}, .radius = 1};

/** Makes a disk. */
static void disk_init(Shape *self, const void *parameters) {
    Disk *disk = (Disk *)self;
    const DiskParameters *p = parameters;
    disk->plane = plane_equation_of(p->center, vec3sw_of(vec3d_scale_exponent(p->normal)));
    disk->radius = (wide_scalar)p->radius;
}

/**
 * @return The lanes whose ray's line passes inside the circle or through it.
 * @param[out] distance  Where it crosses the disk's plane.
 */
INLINE mask disk_intersect(const Disk *disk, const Ray *ray, mask active, real *distance) {
    PlaneHit plane_hit = plane_equation_intersect(&disk->plane, ray);
    *distance = plane_hit_distance(&plane_hit);
    // From the centre to the point is direction * height / slope - to_anchor; here times the slope.
    Vec3w scaled_direction = vec3w_scale(vec3_widen(ray->direction), plane_hit.height);
    Vec3w from_center = vec3w_add_scaled(scaled_direction, plane_hit.to_anchor, -plane_hit.slope);
    wide scaled_radius = plane_hit.slope * wide_of(disk->radius);
    return active & narrow_mask(wide_less_equal(vec3w_dot(from_center, from_center),
                                                scaled_radius * scaled_radius));
}

/** @return The lanes where the disk is nearer. See #ShapeClass.is_hit. @callgraph */
static mask disk_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const Disk *disk = (const Disk *)self;
    real distance;
    mask crosses = disk_intersect(disk, ray, active, &distance);
    mask nearer = hit_is_nearer(hit, crosses, distance, self->index);
    if (any(nearer)) {
        Hit found = plane_equation_hit(&disk->plane, ray, distance, self->index);
        hit_update(hit, nearer, &found);
    }
    return nearer;
}

/** @return The lanes where the disk is on the way. See #ShapeClass.is_occluding. */
static mask disk_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    real distance;
    mask crosses = disk_intersect((const Disk *)self, ray, active, &distance);
    return crosses & (distance > 0) & (distance < limit);
}

/** @return The box around a disk. */
static Aabbs disk_bounds(const Shape *self) {
    const Disk *disk = (const Disk *)self;
    Vec3d center = vec3d_of(disk->plane.wide_anchor);
    Vec3d extent = circle_extent(disk->plane.wide_normal, disk->radius);
    return aabbs_from_corners(vec3d_subtract(center, extent), vec3d_add(center, extent));
}

/** @return Where on a picture points of a disk lie: on the circle that just fits into it. See
 *  #ShapeClass.texture_uv. */
static TextureUv disk_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Disk *disk = (const Disk *)self;
    UvFrame frame = uv_frame_of(disk->plane.wide_normal);
    Vec3w from_center =
        vec3w_subtract(vec3_widen(hit->point), vec3w_splat(disk->plane.wide_anchor));
    return circle_texture_uv(vec3w_scale(from_center, wide_of(1 / disk->radius)), &frame);
}

const ShapeClass disk_class = {
    .keyword = {.name = "disk",
                .help = "the inside of a circle",
                .parameters = disk_parameters,
                .size = sizeof(DiskParameters),
                .defaults = &disk_defaults},
    .size = sizeof(Disk),
    .is_flat = true,
    .init = disk_init,
    .is_hit = disk_is_hit,
    .is_occluding = disk_is_occluding,
    .bounds = disk_bounds,
    .texture_uv = disk_texture_uv,
};
