/**
 * @file
 * @brief Plane without end.
 */
#include "trace/shapes/plane_equation.h"
#include "trace/shapes/registry.h"
#include "trace/shapes/uv_frame.h"

/** Heights of a plane over the origin beyond which a point of it is far. */
#define PLANE_FAR_HEIGHTS 64

/** What a scene file says of a plane. */
typedef struct PlaneParameters {
    Vec3d point;  /**< A point of it. */
    Vec3d normal; /**< Its normal, of any length. */
} PlaneParameters;

/** A plane. @extends Shape */
typedef struct Plane {
    Shape base;             /**< What all shapes have. */
    PlaneEquation equation; /**< The plane itself. */
    Vec3sw texture_origin;  /**< The point that was said: there pictures begin. */
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
static Vec3sw plane_nearest_to_origin(Vec3d point, Vec3d normal) {
    const Quadruple x = (Quadruple)normal.x, y = (Quadruple)normal.y, z = (Quadruple)normal.z;
    Quadruple height = x * (Quadruple)point.x + y * (Quadruple)point.y + z * (Quadruple)point.z;
    Quadruple scale = height / (x * x + y * y + z * z);
    return (Vec3sw){(wide_scalar)(scale * x), (wide_scalar)(scale * y), (wide_scalar)(scale * z)};
}

/** Makes a plane. */
static void plane_init(Shape *self, const void *parameters) {
    const PlaneParameters *p = parameters;
    Plane *plane = (Plane *)self;
    Vec3d normal = vec3d_scale_exponent(p->normal);
    Vec3sw nearest = plane_nearest_to_origin(p->point, normal);
    plane->texture_origin = vec3sw_of(p->point);
    // What is near enough stays as it was said: points on the plane are then often exactly on it.
    bool is_far = vec3d_max_abs(p->point) > PLANE_FAR_HEIGHTS * vec3d_max_abs(vec3d_of(nearest));
    plane->equation =
        plane_equation_through(is_far ? nearest : plane->texture_origin, vec3sw_of(normal));
}

/** @return The lanes where the plane is nearer. See #ShapeClass.is_hit. @callgraph */
static mask plane_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const PlaneEquation *plane = &((const Plane *)self)->equation;
    real distance = plane_equation_distance(plane, ray);
    mask nearer = hit_is_nearer(hit, active, distance, self->index);
    if (any(nearer)) {
        Hit found = plane_equation_hit(plane, ray, distance, self->index);
        hit_update(hit, nearer, &found);
    }
    return nearer;
}

/** @return The lanes where the plane is on the way. See #ShapeClass.is_occluding. */
static mask plane_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    real distance = plane_equation_distance(&((const Plane *)self)->equation, ray);
    return active & (distance > 0) & (distance < limit);
}

/** @return A box without end. */
static Aabbs plane_bounds(const Shape *self) {
    (void)self;
    return aabbs_infinite();
}

/** @return Where on a picture points of a plane lie: one picture a scene unit, again and again. See
 *  #ShapeClass.texture_uv. */
static TextureUv plane_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Plane *plane = (const Plane *)self;
    UvFrame frame = uv_frame_of(plane->equation.wide_normal);
    Vec3w from_origin = vec3w_subtract(vec3_widen(hit->point), vec3w_splat(plane->texture_origin));
    return (TextureUv){.u = component_along(from_origin, frame.right),
                       .v = component_along(from_origin, frame.up),
                       .wrap_u = mask_of(true),
                       .wrap_v = mask_of(true)};
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
    .is_occluding = plane_is_occluding,
    .bounds = plane_bounds,
    .texture_uv = plane_texture_uv,
};
