/**
 * @file
 * @brief Infinite plane.
 */
#include "trace/shapes/plane_equation.h"
#include "trace/shapes/uv_frame.h"

/** A point of a plane is far away if its distance from the origin exceeds so many times the
 *  distance of the plane. */
#define PLANE_FAR_HEIGHTS 64

/** A plane. @extends Shape */
typedef struct Plane {
    Shape base;             /**< Base. */
    PlaneEquation equation; /**< The plane. */
    Vec3sw texture_origin;  /**< The point of the scene file: (0, 0) of textures. */
} Plane;

/**
 * @return The point of a plane nearest to the origin, computed in quad precision: relative to a
 *         far point, the height of a camera would carry the roundings of that distance.
 * @param point   A point of the plane.
 * @param normal  Its normal, of length about 1.
 */
static Vec3sw plane_nearest_to_origin(Vec3d point, Vec3d normal) {
    const Quadruple x = (Quadruple)normal.x, y = (Quadruple)normal.y, z = (Quadruple)normal.z;
    Quadruple height = x * (Quadruple)point.x + y * (Quadruple)point.y + z * (Quadruple)point.z;
    Quadruple scale = height / (x * x + y * y + z * z);
    return (Vec3sw){(wide_scalar)(scale * x), (wide_scalar)(scale * y), (wide_scalar)(scale * z)};
}

/** See #ShapeClass.init. */
static void plane_init(Shape *self, const void *parameters) {
    const PlaneParameters *p = parameters;
    Plane *plane = (Plane *)self;
    Vec3d normal = vec3d_scale_exponent(p->normal);
    Vec3sw nearest = plane_nearest_to_origin(p->point, normal);
    plane->texture_origin = vec3sw_of(p->point);
    // A near point stays as the scene gives it: points of the plane are then often exactly on it.
    bool is_far = vec3d_max_abs(p->point) > PLANE_FAR_HEIGHTS * vec3d_max_abs(vec3d_of(nearest));
    plane->equation =
        plane_equation_through(is_far ? nearest : plane->texture_origin, vec3sw_of(normal));
}

/** See #IntersectFunction. */
INLINE mask plane_intersect(const Shape *self, const Ray *ray, mask active, real *distance,
                            void *roots) {
    (void)roots;
    *distance = plane_equation_distance(&((const Plane *)self)->equation, ray);
    return active;
}

/** See #SurfaceFunction. */
INLINE SurfacePoint plane_surface(const Shape *self, const Ray *ray, real distance,
                                  const void *roots) {
    (void)roots;
    return plane_equation_surface(&((const Plane *)self)->equation, ray, distance);
}

/** See #ShapeClass.is_hit. @callgraph */
static mask plane_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    return primitive_is_hit(self, ray, active, hit, plane_intersect, plane_surface, NULL);
}

/** See #ShapeClass.plane. */
static const PlaneEquation *plane_plane(const Shape *self) {
    return &((const Plane *)self)->equation;
}

/** See #ShapeClass.beam_hits. A ray that does not meet the plane has a negative or infinite
 *  distance, which is no hit. */
static bool plane_beam_hits(const Shape *self, const Packet *packet, Hit *hits) {
    plane_equation_beam_hits(plane_plane(self), self, packet, hits);
    return true;
}

/** See #ShapeClass.is_occluding. */
static mask plane_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    return primitive_is_occluding(self, ray, active, limit, plane_intersect, NULL);
}

/** See #ShapeClass.bounds. */
static Aabbs plane_bounds(const Shape *self) {
    (void)self;
    return aabbs_infinite();
}

/** @return Coordinates in the plane, one repetition of the picture per scene unit. See
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

/** Methods of `plane`. */
const ShapeClass plane_class = {
    .size = sizeof(Plane),
    .form = FORM_FLAT,
    .init = plane_init,
    .is_hit = plane_is_hit,
    .is_occluding = plane_is_occluding,
    .plane = METHOD_OF_BEAMS(plane_plane),
    .beam_hits = METHOD_OF_BEAMS(plane_beam_hits),
    .bounds = plane_bounds,
    .texture_uv = plane_texture_uv,
};
