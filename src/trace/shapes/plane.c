/**
 * @file
 * @brief Plane without end.
 */
#include "trace/shapes/flat.h"
#include "trace/shapes/registry.h"
#include "trace/shapes/upright.h"

/** Heights of a plane over the origin beyond which a point of it is far. */
#define FAR_HEIGHTS 64

/** What a scene file says of a plane. */
typedef struct PlaneParameters {
    Vector3 point;  /**< A point of it. */
    Vector3 normal; /**< Its normal, of any length. */
} PlaneParameters;

/** A plane. @extends Shape */
typedef struct Plane {
    Shape base;      /**< What all shapes have. */
    Flat flat;       /**< The plane itself. */
    WidePoint point; /**< The point that was said: there pictures begin. */
} Plane;

/** Fields of `plane`. */
static const Parameter plane_parameters[] = {{.name = "point",
                                              .type = PARAMETER_POINT,
                                              .offset = offsetof(PlaneParameters, point),
                                              .minimum = -LENGTH_MAXIMUM,
                                              .maximum = LENGTH_MAXIMUM,
                                              .unit = "scene units",
                                              .help = "a point of it"},
                                             {.name = "normal",
                                              .type = PARAMETER_DIRECTION,
                                              .offset = offsetof(PlaneParameters, normal),
                                              .minimum = -LENGTH_MAXIMUM,
                                              .maximum = LENGTH_MAXIMUM,
                                              .unit = "any length",
                                              .help = "its normal"},
                                             {0}};

/** The floor. */
static const PlaneParameters plane_defaults = {.normal = {0, 1, 0}};

/**
 * @return The point of a plane that is nearest to the origin, in quad precision: from a point far
 *         away, the height of an eye would be wrong by roundings of that distance.
 * @param point   A point of the plane.
 * @param normal  Its normal, about one long.
 */
static WidePoint plane_foot(Vector3 point, Vector3 normal) {
    const Quadruple x = (Quadruple)normal.x, y = (Quadruple)normal.y, z = (Quadruple)normal.z;
    Quadruple height = x * (Quadruple)point.x + y * (Quadruple)point.y + z * (Quadruple)point.z;
    Quadruple share = height / (x * x + y * y + z * z);
    return (WidePoint){(wide_scalar)(share * x), (wide_scalar)(share * y),
                       (wide_scalar)(share * z)};
}

/** Makes a plane. @param self The plane. @param parameters A #PlaneParameters. */
static void plane_init(Shape *self, const void *parameters) {
    const PlaneParameters *p = parameters;
    Plane *plane = (Plane *)self;
    Vector3 normal = vector3_scaled(p->normal);
    WidePoint foot = plane_foot(p->point, normal);
    plane->point = wide_point_of(p->point);
    // What is near enough stays as it was said: points on the plane are then often exactly on it.
    bool is_far = vector3_largest(p->point) > FAR_HEIGHTS * vector3_largest(vector3_of(foot));
    plane->flat = flat_through(is_far ? foot : plane->point, wide_point_of(normal));
}

/** @return The lanes where the plane is nearer. See #ShapeClass.is_hit. @callgraph
 *  @param self The plane. @param ray The rays. @param active The lanes. @param[in,out] hit The hit.
 */
static mask plane_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const Flat *flat = &((const Plane *)self)->flat;
    real distance = flat_distance(flat, ray);
    mask nearer = hit_is_nearer(hit, active, distance, self->place);
    if (any(nearer)) {
        Hit found = flat_hit(flat, ray, distance, self->place);
        hit_take(hit, nearer, &found);
    }
    return nearer;
}

/** @return The lanes where the plane is on the way. See #ShapeClass.is_blocking.
 *  @param self The plane. @param ray The rays. @param active The lanes. @param limit The way's end.
 */
static mask plane_is_blocking(const Shape *self, const Ray *ray, mask active, real limit) {
    real distance = flat_distance(&((const Plane *)self)->flat, ray);
    return active & (distance > 0) & (distance < limit);
}

/** @return A box without end. @param self The plane. */
static Bounds plane_bounds(const Shape *self) {
    (void)self;
    return bounds_infinite();
}

/** @return Where on a picture points of a plane lie: one picture a scene unit, again and again. See
 *  #ShapeClass.texture_place. @param self The plane. @param hit The points. @param lanes Not looked
 *  at. */
static TexturePlace plane_texture_place(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Plane *plane = (const Plane *)self;
    Upright upright = upright_of(plane->flat.wide_normal);
    WideVector arm = wide_subtract(vector_widen(hit->point), wide_vector_of(plane->point));
    return (TexturePlace){.u = arm_along(arm, upright.right),
                          .v = arm_along(arm, upright.up),
                          .around_u = mask_of(true),
                          .around_v = mask_of(true)};
}

const ShapeClass plane_class = {
    .keyword = {.name = "plane",
                .help = "a plane without end",
                .parameters = plane_parameters,
                .size = sizeof(PlaneParameters),
                .defaults = &plane_defaults},
    .size = sizeof(Plane),
    .is_flat = true,
    .init = plane_init,
    .is_hit = plane_is_hit,
    .is_blocking = plane_is_blocking,
    .bounds = plane_bounds,
    .texture_place = plane_texture_place,
};
