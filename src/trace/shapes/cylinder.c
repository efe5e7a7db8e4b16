/**
 * @file
 * @brief Cylinder, open or capped.
 *
 * One interval of the ray lies between the planes of the ends, another one inside the infinite
 * wall. A capped cylinder is their intersection: one convex solid, so that no ray slips through the
 * rim and none is counted twice. An open one has a hit where the ray crosses the wall between the
 * planes.
 *
 * Whether the ray meets the wall follows from its distance to the axis, a cross product, in the
 * plane across the axis; b^2 - ac would cancel. All of it is relative to the origin of the ray and
 * in the wide precision.
 */
#include "trace/shapes/support.h"

/** Bound on the error of a point, in half ulps of its coordinates and of #Cylinder.magnitude. */
#define CYLINDER_ERROR 8

/** A cylinder. @extends Shape */
typedef struct Cylinder {
    Shape base;         /**< Base. */
    AxialFrame frame;   /**< Local axes; the origin is the centre of the base. */
    wide_scalar radius; /**< Radius. */
    scalar magnitude;   /**< Largest coordinate of the base, plus length and radius: rounding errors
                             scale with it. */
    bool is_capped;     /**< Whether the ends are closed. */
} Cylinder;

/** What #cylinder_intersect finds. */
typedef struct CylinderRoots {
    AxialRay ray;     /**< The rays in local coordinates. */
    wide axis_offset; /**< Distance from the axis, over the length of the direction across it. */
    wide half_chord;  /**< Half the chord of the wall, in lengths of the direction. */
    AxialHit hit;     /**< The hits. */
} CylinderRoots;

/** See #ShapeClass.init. */
static void cylinder_init(Shape *self, const void *parameters) {
    Cylinder *cylinder = (Cylinder *)self;
    const CylinderParameters *p = parameters;
    cylinder->frame = axial_frame_of(p->base, p->top, p->base);
    cylinder->radius = (wide_scalar)p->radius;
    cylinder->magnitude =
        (scalar)(vec3d_max_abs(p->base) + p->radius) + (scalar)cylinder->frame.length;
    cylinder->is_capped = p->capped;
}

/**
 * Finds the part of rays inside the infinite wall. Projected along the axis, their distance from it
 * is |direction x origin| / |direction|.
 * @param[in,out] roots  The rays; sets #AxialRay.wall, #CylinderRoots.axis_offset and
 *                       #CylinderRoots.half_chord.
 * @param radius         Radius of the wall.
 * @return The lanes whose line meets the inside.
 */
INLINE mask cylinder_clip_wall(CylinderRoots *roots, wide radius) {
    AxialRay *local_ray = &roots->ray;
    wide ox = local_ray->origin.x, oy = local_ray->origin.y;
    wide dx = local_ray->direction.x, dy = local_ray->direction.y;
    wide length_squared = dx * dx + dy * dy, cross = dx * oy - dy * ox;
    wide discriminant = radius * radius * length_squared - cross * cross;
    wide center_power = ox * ox + oy * oy - radius * radius;

    // The root farther from zero is a sum, the other one follows from the product of both.
    wide per_across = 1 / length_squared, middle = -(ox * dx + oy * dy) * per_across;
    wide half = wide_sqrt(discriminant) * per_across;
    const wide zero = wide_of(0), endless = wide_of((wide_scalar)INFINITE);
    wide_mask is_ahead = wide_less(zero, middle);
    wide sum = middle + wide_select(is_ahead, half, -half);
    wide quotient = center_power * per_across / sum;

    // A ray along the axis has no roots: it is inside everywhere or nowhere.
    wide_mask is_along = wide_equal(length_squared, zero);
    local_ray->wall.near = wide_select(is_along, -endless, wide_select(is_ahead, quotient, sum));
    local_ray->wall.far = wide_select(is_along, endless, wide_select(is_ahead, sum, quotient));
    roots->axis_offset = cross * per_across;
    roots->half_chord = half;
    return narrow_mask((is_along & wide_less_equal(center_power, zero)) |
                       (wide_less(zero, length_squared) & wide_less_equal(zero, discriminant)));
}

/** Finds hits ahead of the origin. See #IntersectFunction. */
INLINE mask cylinder_intersect(const Shape *self, const Ray *ray, mask active, real *distance,
                               void *roots) {
    const Cylinder *cylinder = (const Cylinder *)self;
    CylinderRoots *found = roots;
    axial_ray_init(&found->ray, &cylinder->frame, ray);
    mask crosses = active & cylinder_clip_wall(found, wide_of(cylinder->radius));
    if (!any(crosses)) {
        return crosses;
    }
    axial_ray_clip_ends(&found->ray, wide_of(0), wide_of(cylinder->frame.length));
    crosses &= cylinder->is_capped ? axial_ray_intersect_solid(&found->ray, &found->hit)
                                   : axial_ray_intersect_wall(&found->ray, &found->hit);
    *distance = narrow(found->hit.distance);
    return crosses;
}

/**
 * Finds points on the wall, from the middle of the chord, which is the point nearest to the axis:
 * never a difference of large numbers.
 * @param[out] normal  The normals, in local coordinates.
 * @return The points, in local coordinates.
 */
INLINE Vec3w cylinder_wall_point(const Cylinder *cylinder, const CylinderRoots *roots,
                                 Vec3w *normal) {
    Vec3w d = roots->ray.direction;
    wide half = wide_select(roots->hit.is_entry, -roots->half_chord, roots->half_chord);
    wide x = d.x * half - d.y * roots->axis_offset, y = d.y * half + d.x * roots->axis_offset;
    wide z = roots->ray.origin.z + d.z * roots->hit.distance, zero = wide_of(0);
    wide length = wide_of(cylinder->frame.length), per_radius = wide_of(1 / cylinder->radius);
    z = wide_select(wide_less(zero, z), z, zero);
    *normal = (Vec3w){x * per_radius, y * per_radius, zero};
    return (Vec3w){x, y, wide_select(wide_less(z, length), z, length)};
}

/** See #SurfaceFunction. */
INLINE SurfacePoint cylinder_surface(const Shape *self, const Ray *ray, real distance,
                                     const void *roots) {
    (void)ray;
    (void)distance;
    const Cylinder *cylinder = (const Cylinder *)self;
    const CylinderRoots *found = roots;
    Vec3w wall_normal, end_normal;
    Vec3w on_wall = cylinder_wall_point(cylinder, found, &wall_normal);
    Vec3w on_end = axial_ray_end_point(&found->ray, &found->hit, wide_of(0),
                                       wide_of(cylinder->frame.length), &end_normal);
    Vec3w local_normal = vec3w_select(found->hit.is_wall, wall_normal, end_normal);
    Vec3 point = axial_frame_to_world_point(&cylinder->frame,
                                            vec3w_select(found->hit.is_wall, on_wall, on_end));
    return (SurfacePoint){point, vec3_narrow(axial_frame_to_world(&cylinder->frame, local_normal)),
                          CYLINDER_ERROR * ROUNDOFF * (vec3_max_abs(point) + cylinder->magnitude)};
}

/** See #ShapeClass.is_hit. @callgraph */
static mask cylinder_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    CylinderRoots roots;
    return primitive_is_hit(self, ray, active, hit, cylinder_intersect, cylinder_surface, &roots);
}

/** See #ShapeClass.is_occluding. */
static mask cylinder_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    CylinderRoots roots;
    return primitive_is_occluding(self, ray, active, limit, cylinder_intersect, &roots);
}

/** See #ShapeClass.support. */
static real cylinder_support(const Shape *self, Vec3s from, Vec3 directions) {
    const Cylinder *cylinder = (const Cylinder *)self;
    return support_of_wall(&cylinder->frame, 0, cylinder->radius, cylinder->frame.length,
                           cylinder->radius, from, directions);
}

/** @return The box around the circles of the ends. See #ShapeClass.bounds. */
static Aabbs cylinder_bounds(const Shape *self) {
    const Cylinder *cylinder = (const Cylinder *)self;
    const AxialFrame *frame = &cylinder->frame;
    Vec3sw axis_vector = vec3sw_scale(frame->axes[2], frame->length);
    Vec3d base = vec3d_of(frame->origin), top = vec3d_add(base, vec3d_of(axis_vector));
    Vec3d extent = circle_extent(vec3d_of(frame->axes[2]), (double)cylinder->radius);
    return aabbs_from_corners(vec3d_subtract(vec3d_min(base, top), extent),
                              vec3d_add(vec3d_max(base, top), extent));
}

/** @return Angle and height on the wall; on an end, coordinates as on a disk. See
 *  #ShapeClass.texture_uv. */
static TextureUv cylinder_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Cylinder *cylinder = (const Cylinder *)self;
    const AxialFrame *frame = &cylinder->frame;
    const real half = real_of((scalar)0.5f);
    Vec3w from_base = vec3w_subtract(vec3_widen(hit->point), vec3w_splat(frame->origin));
    Vec3w in_radii = vec3w_scale(from_base, wide_of(1 / cylinder->radius));
    real along_axis = component_along(vec3_widen(hit->normal), frame->axes[2]);
    real height =
        narrow(vec3w_dot(from_base, vec3w_splat(frame->axes[2])) * wide_of(1 / frame->length));
    mask on_base = along_axis < -half, on_end = on_base | (along_axis > half);
    return axial_texture_uv(component_along(in_radii, frame->axes[0]),
                            component_along(in_radii, frame->axes[1]), height, on_base, on_end);
}

/** Methods of `cylinder`. */
const ShapeClass cylinder_class = {
    .size = sizeof(Cylinder),
    .init = cylinder_init,
    .is_hit = cylinder_is_hit,
    .is_occluding = cylinder_is_occluding,
    .support = METHOD_OF_BEAMS(cylinder_support),
    .bounds = cylinder_bounds,
    .texture_uv = cylinder_texture_uv,
};
