/**
 * @file
 * @brief Disk: the inside of a circle, seen from both sides (row D1).
 *
 * Where the ray crosses the plane, the vector from the centre is compared with the radius. It is
 * taken relative to the ray's origin, in the wide precision and before anything is divided, so that
 * the outline of a far disk is as good as that of a near one.
 */
#include "trace/shapes/circle.h"
#include "trace/shapes/flat.h"
#include "trace/shapes/registry.h"
#include "trace/shapes/upright.h"

/** What a scene file says of a disk. */
typedef struct DiskParameters {
    Vector3 center; /**< Its centre. */
    Vector3 normal; /**< Its normal, of any length. */
    double radius;  /**< Its radius, scene units. */
} DiskParameters;

/** A disk. @extends Shape */
typedef struct Disk {
    Shape base;         /**< What all shapes have. */
    Flat flat;          /**< The plane that it lies in; its anchor is the centre. */
    wide_scalar radius; /**< Its radius. */
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

/** Makes a disk. @param self The disk. @param parameters A #DiskParameters. */
static void disk_init(Shape *self, const void *parameters) {
    Disk *disk = (Disk *)self;
    const DiskParameters *p = parameters;
    disk->flat = flat_of(p->center, wide_point_of(vector3_scaled(p->normal)));
    disk->radius = (wide_scalar)p->radius;
}

/**
 * @return The lanes whose ray's line passes inside the circle or through it.
 * @param disk           The disk.
 * @param ray            The rays.
 * @param active         The lanes that count.
 * @param[out] distance  Where it crosses the disk's plane.
 */
INLINE mask disk_crosses(const Disk *disk, const Ray *ray, mask active, real *distance) {
    Crossing crossing = flat_crossing(&disk->flat, ray);
    *distance = crossing_distance(&crossing);
    // From the centre to the point is direction * height / slope - to_anchor; here times the slope.
    WideVector along = wide_scale(vector_widen(ray->direction), crossing.height);
    WideVector arm = wide_add_scaled(along, crossing.to_anchor, -crossing.slope);
    wide reach = crossing.slope * wide_of(disk->radius);
    return active & narrow_mask(wide_at_most(wide_dot(arm, arm), reach * reach));
}

/** @return The lanes where the disk is nearer. See #ShapeClass.is_hit. @callgraph
 *  @param self The disk. @param ray The rays. @param active The lanes. @param[in,out] hit The hit.
 */
static mask disk_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const Disk *disk = (const Disk *)self;
    real distance;
    mask crosses = disk_crosses(disk, ray, active, &distance);
    mask nearer = hit_is_nearer(hit, crosses, distance, self->place);
    if (any(nearer)) {
        Hit found = flat_hit(&disk->flat, ray, distance, self->place);
        hit_take(hit, nearer, &found);
    }
    return nearer;
}

/** @return The lanes where the disk is on the way. See #ShapeClass.is_blocking.
 *  @param self The disk. @param ray The rays. @param active The lanes. @param limit The way's end.
 */
static mask disk_is_blocking(const Shape *self, const Ray *ray, mask active, real limit) {
    real distance;
    mask crosses = disk_crosses((const Disk *)self, ray, active, &distance);
    return crosses & (distance > 0) & (distance < limit);
}

/** @return The box around a disk. @param self The disk. */
static Bounds disk_bounds(const Shape *self) {
    const Disk *disk = (const Disk *)self;
    Vector3 center = vector3_of(disk->flat.wide_anchor);
    Vector3 reach = circle_reach(disk->flat.wide_normal, disk->radius);
    return bounds_around(vector3_subtract(center, reach), vector3_add(center, reach));
}

/** @return Where on a picture points of a disk lie: on the circle that just fits into it. See
 *  #ShapeClass.texture_place. @param self The disk. @param hit The points. @param lanes Not looked
 *  at. */
static TexturePlace disk_texture_place(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Disk *disk = (const Disk *)self;
    Upright upright = upright_of(disk->flat.wide_normal);
    WideVector arm =
        wide_subtract(vector_widen(hit->point), wide_vector_of(disk->flat.wide_anchor));
    return circle_texture_place(wide_scale(arm, wide_of(1 / disk->radius)), &upright);
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
    .is_blocking = disk_is_blocking,
    .bounds = disk_bounds,
    .texture_place = disk_texture_place,
};
