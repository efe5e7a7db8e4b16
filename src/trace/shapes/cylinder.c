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
#include "trace/math/angle.h"
#include "trace/shapes/uv_frame.h"

/** Bound on the error of a point, in half ulps of its coordinates and of #Cylinder.magnitude. */
#define CYLINDER_ERROR 8

/** A cylinder with local axes: two across, and z from the base to the top. @extends Shape */
typedef struct Cylinder {
    Shape base;         /**< Base. */
    Vec3sw base_center; /**< Centre of the base. */
    Vec3sw axes[3];     /**< Local axes, unit vectors. */
    wide_scalar length; /**< Distance from base to top. */
    wide_scalar radius; /**< Radius. */
    scalar magnitude;   /**< Largest coordinate of the base, plus length and radius: rounding errors
                             scale with it. */
    bool is_capped;     /**< Whether the ends are closed. */
} Cylinder;

/** A part of LANES rays, in lengths of the direction. */
typedef struct RayInterval {
    wide near; /**< Its start. */
    wide far;  /**< Its end. */
} RayInterval;

/** LANES rays in local coordinates. */
typedef struct CylinderRay {
    Vec3w origin;     /**< Origins, relative to the centre of the base. */
    Vec3w direction;  /**< Directions. */
    wide axis_offset; /**< Distance from the axis, over the length of the direction across it. */
    wide half_chord;  /**< Half the chord of the wall, in lengths of the direction. */
    RayInterval wall; /**< The part inside the infinite wall. */
    RayInterval caps; /**< The part between the planes of the ends. */
} CylinderRay;

/** Hits of LANES rays. */
typedef struct CylinderHit {
    wide distance;      /**< Distance. */
    wide_mask is_wall;  /**< Whether on the wall; else on an end. */
    wide_mask is_entry; /**< Whether at the start of the interval: from outside. */
} CylinderHit;

/** What #cylinder_intersect finds. */
typedef struct CylinderRoots {
    CylinderRay ray; /**< The rays in local coordinates. */
    CylinderHit hit; /**< The hits. */
} CylinderRoots;

/** @return The coordinate axis at the largest angle to a vector: their cross product is well
 *  conditioned, and exact for vectors along an axis. */
static Vec3sw least_aligned_axis(Vec3d v) {
    Vec3d a = {fabs(v.x), fabs(v.y), fabs(v.z)};
    if (a.x <= a.y && a.x <= a.z) {
        return (Vec3sw){1, 0, 0};
    }
    return a.y <= a.z ? (Vec3sw){0, 1, 0} : (Vec3sw){0, 0, 1};
}

/** See #ShapeClass.init. */
static void cylinder_init(Shape *self, const void *parameters) {
    Cylinder *cylinder = (Cylinder *)self;
    const CylinderParameters *p = parameters;
    Vec3sw axis_vector = vec3sw_subtract(vec3sw_of(p->top), vec3sw_of(p->base));
    Vec3sw axis = vec3sw_normalize(axis_vector);
    cylinder->base_center = vec3sw_of(p->base);
    cylinder->axes[0] = vec3sw_normalize(vec3sw_cross(axis, least_aligned_axis(vec3d_of(axis))));
    cylinder->axes[1] = vec3sw_cross(axis, cylinder->axes[0]);
    cylinder->axes[2] = axis;
    cylinder->length = vec3sw_dot(axis_vector, axis);
    cylinder->radius = (wide_scalar)p->radius;
    cylinder->magnitude = (scalar)(vec3d_max_abs(p->base) + p->radius) + (scalar)cylinder->length;
    cylinder->is_capped = p->capped;
}

/** @return Vectors in local coordinates. */
INLINE Vec3w cylinder_to_local(const Cylinder *cylinder, Vec3w v) {
    return (Vec3w){vec3w_dot(vec3w_splat(cylinder->axes[0]), v),
                   vec3w_dot(vec3w_splat(cylinder->axes[1]), v),
                   vec3w_dot(vec3w_splat(cylinder->axes[2]), v)};
}

/** @return Vectors in the coordinates of the scene. @param v Local vectors. */
INLINE Vec3w cylinder_to_world(const Cylinder *cylinder, Vec3w v) {
    Vec3w sum = vec3w_scale(vec3w_splat(cylinder->axes[0]), v.x);
    sum = vec3w_add_scaled(sum, vec3w_splat(cylinder->axes[1]), v.y);
    return vec3w_add_scaled(sum, vec3w_splat(cylinder->axes[2]), v.z);
}

/**
 * Finds the part of rays inside the infinite wall. Projected along the axis, their distance from it
 * is |direction x origin| / |direction|.
 * @param[in,out] local_ray  The rays; sets #CylinderRay.wall, #CylinderRay.axis_offset and
 *                           #CylinderRay.half_chord.
 * @param radius             Radius of the wall.
 * @return The lanes whose line meets the inside.
 */
INLINE mask cylinder_ray_clip_wall(CylinderRay *local_ray, wide radius) {
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
    local_ray->axis_offset = cross * per_across;
    local_ray->half_chord = half;
    return narrow_mask((is_along & wide_less_equal(center_power, zero)) |
                       (wide_less(zero, length_squared) & wide_less_equal(zero, discriminant)));
}

/**
 * Finds the part of rays between the planes of the ends: a slab, as in the box.
 * @param[in,out] local_ray  The rays; sets #CylinderRay.caps, infinite for rays along the ends.
 * @param length             Length of the cylinder.
 */
INLINE void cylinder_ray_clip_caps(CylinderRay *local_ray, wide length) {
    wide inverse = 1 / local_ray->direction.z, to_base = -local_ray->origin.z;
    wide to_top = length - local_ray->origin.z, endless = wide_of((wide_scalar)INFINITE);
    wide_mask is_downwards = wide_less(inverse, wide_of(0));
    wide enter = wide_select(is_downwards, to_top, to_base) * inverse;
    wide leave = wide_select(is_downwards, to_base, to_top) * inverse;
    // In the plane of an end, 0 times infinity is NaN: the comparison fails, which counts as
    // inside.
    local_ray->caps.near = wide_select(wide_less(-endless, enter), enter, -endless);
    local_ray->caps.far = wide_select(wide_less(leave, endless), leave, endless);
}

/** Intersects both intervals: the capped cylinder. @return The lanes with a hit. */
INLINE mask cylinder_ray_intersect_solid(const CylinderRay *local_ray, CylinderHit *local_hit) {
    const RayInterval *wall = &local_ray->wall, *ends = &local_ray->caps;
    const wide zero = wide_of(0);
    wide_mask wall_is_first = wide_less_equal(ends->near, wall->near);
    wide_mask wall_is_last = wide_less_equal(wall->far, ends->far);
    wide near = wide_select(wall_is_first, wall->near, ends->near);
    wide far = wide_select(wall_is_last, wall->far, ends->far);
    local_hit->is_entry = wide_less(zero, near);
    local_hit->distance = wide_select(local_hit->is_entry, near, far);
    local_hit->is_wall =
        (local_hit->is_entry & wall_is_first) | (wide_mask_not(local_hit->is_entry) & wall_is_last);
    return narrow_mask(wide_less_equal(near, far) & wide_less(zero, far));
}

/** @return Whether distances are above 0 and within an interval. */
INLINE wide_mask ray_interval_contains_ahead(wide distance, const RayInterval *interval) {
    return wide_less(wide_of(0), distance) & wide_less_equal(interval->near, distance) &
           wide_less_equal(distance, interval->far);
}

/** Finds the first crossing of the wall between the ends: the open cylinder. @return The lanes with
 *  a hit. */
INLINE mask cylinder_ray_intersect_wall(const CylinderRay *local_ray, CylinderHit *local_hit) {
    const RayInterval *wall = &local_ray->wall, *ends = &local_ray->caps;
    wide_mask near_is_there = ray_interval_contains_ahead(wall->near, ends),
              far_is_there = ray_interval_contains_ahead(wall->far, ends);
    local_hit->is_entry = near_is_there;
    local_hit->distance = wide_select(near_is_there, wall->near, wall->far);
    local_hit->is_wall = wide_equal(local_hit->distance, local_hit->distance);
    return narrow_mask(near_is_there | far_is_there);
}

/** Finds hits ahead of the origin. See #IntersectFunction. */
INLINE mask cylinder_intersect(const Shape *self, const Ray *ray, mask active, real *distance,
                               void *roots) {
    const Cylinder *cylinder = (const Cylinder *)self;
    CylinderRay *local_ray = &((CylinderRoots *)roots)->ray;
    CylinderHit *local_hit = &((CylinderRoots *)roots)->hit;
    Vec3w from_base = vec3w_subtract(vec3_widen(ray->origin), vec3w_splat(cylinder->base_center));
    local_ray->origin = cylinder_to_local(cylinder, from_base);
    local_ray->direction = cylinder_to_local(cylinder, vec3_widen(ray->direction));
    mask crosses = active & cylinder_ray_clip_wall(local_ray, wide_of(cylinder->radius));
    if (!any(crosses)) {
        return crosses;
    }
    cylinder_ray_clip_caps(local_ray, wide_of(cylinder->length));
    crosses &= cylinder->is_capped ? cylinder_ray_intersect_solid(local_ray, local_hit)
                                   : cylinder_ray_intersect_wall(local_ray, local_hit);
    *distance = narrow(local_hit->distance);
    return crosses;
}

/**
 * Finds points on the wall, from the middle of the chord, which is the point nearest to the axis:
 * never a difference of large numbers.
 * @param[out] normal  The normals, in local coordinates.
 * @return The points, in local coordinates.
 */
INLINE Vec3w cylinder_ray_wall_point(const Cylinder *cylinder, const CylinderRay *local_ray,
                                     const CylinderHit *local_hit, Vec3w *normal) {
    Vec3w d = local_ray->direction;
    wide half = wide_select(local_hit->is_entry, -local_ray->half_chord, local_ray->half_chord);
    wide x = d.x * half - d.y * local_ray->axis_offset,
         y = d.y * half + d.x * local_ray->axis_offset;
    wide z = local_ray->origin.z + d.z * local_hit->distance, zero = wide_of(0);
    wide length = wide_of(cylinder->length), per_radius = wide_of(1 / cylinder->radius);
    z = wide_select(wide_less(zero, z), z, zero);
    *normal = (Vec3w){x * per_radius, y * per_radius, zero};
    return (Vec3w){x, y, wide_select(wide_less(z, length), z, length)};
}

/**
 * Finds points on an end.
 * @param[out] normal  The normals, in local coordinates.
 * @return The points, in local coordinates.
 */
INLINE Vec3w cylinder_ray_cap_point(const Cylinder *cylinder, const CylinderRay *local_ray,
                                    const CylinderHit *local_hit, Vec3w *normal) {
    Vec3w point = vec3w_add_scaled(local_ray->origin, local_ray->direction, local_hit->distance);
    // A ray that enters upwards or leaves downwards is on the base.
    wide zero = wide_of(0), one = wide_of(1);
    wide_mask goes_up = wide_less(zero, local_ray->direction.z), enters = local_hit->is_entry;
    wide_mask is_base = (enters & goes_up) | wide_mask_not(enters | goes_up);
    *normal = (Vec3w){zero, zero, wide_select(is_base, -one, one)};
    point.z = wide_select(is_base, zero, wide_of(cylinder->length));
    return point;
}

/** See #SurfaceFunction. */
INLINE SurfacePoint cylinder_surface(const Shape *self, const Ray *ray, real distance,
                                     const void *roots) {
    (void)ray;
    (void)distance;
    const Cylinder *cylinder = (const Cylinder *)self;
    const CylinderRay *local_ray = &((const CylinderRoots *)roots)->ray;
    const CylinderHit *local_hit = &((const CylinderRoots *)roots)->hit;
    Vec3w wall_normal, end_normal;
    Vec3w on_wall = cylinder_ray_wall_point(cylinder, local_ray, local_hit, &wall_normal);
    Vec3w on_end = cylinder_ray_cap_point(cylinder, local_ray, local_hit, &end_normal);
    Vec3w local_point = vec3w_select(local_hit->is_wall, on_wall, on_end);
    Vec3w local_normal = vec3w_select(local_hit->is_wall, wall_normal, end_normal);
    Vec3 point = vec3_narrow(vec3w_add_scaled(
        vec3w_splat(cylinder->base_center), cylinder_to_world(cylinder, local_point), wide_of(1)));
    return (SurfacePoint){point, vec3_narrow(cylinder_to_world(cylinder, local_normal)),
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

/** @return The box around the circles of the ends. See #ShapeClass.bounds. */
static Aabbs cylinder_bounds(const Shape *self) {
    const Cylinder *cylinder = (const Cylinder *)self;
    Vec3sw axis_vector = vec3sw_scale(cylinder->axes[2], cylinder->length);
    Vec3d base = vec3d_of(cylinder->base_center), top = vec3d_add(base, vec3d_of(axis_vector));
    Vec3d extent = circle_extent(vec3d_of(cylinder->axes[2]), (double)cylinder->radius);
    return aabbs_from_corners(vec3d_subtract(vec3d_min(base, top), extent),
                              vec3d_add(vec3d_max(base, top), extent));
}

/** @return Angle and height on the wall; on an end, coordinates as on a disk. See
 *  #ShapeClass.texture_uv. */
static TextureUv cylinder_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Cylinder *cylinder = (const Cylinder *)self;
    const Vec3sw *axes = cylinder->axes;
    const real half = real_of((scalar)0.5f);
    Vec3w from_base = vec3w_subtract(vec3_widen(hit->point), vec3w_splat(cylinder->base_center));
    Vec3w in_radii = vec3w_scale(from_base, wide_of(1 / cylinder->radius));
    real along_axis = component_along(vec3_widen(hit->normal), axes[2]);
    mask on_base = along_axis < -half, on_end = on_base | (along_axis > half);
    // The middle of the picture is at the front, opposite the first axis.
    real front = -component_along(in_radii, axes[0]), right = -component_along(in_radii, axes[1]);
    real height =
        narrow(vec3w_dot(from_base, vec3w_splat(axes[2])) * wide_of(1 / cylinder->length));
    real angle = real_atan2_turns(right, front) + half;
    real up = real_select(on_base, front, -front);
    return (TextureUv){.u = real_select(on_end, half + half * right, angle),
                       .v = real_select(on_end, half + half * up, height),
                       .wrap_u = mask_not(on_end),
                       .wrap_v = mask_of(false)};
}

const ShapeClass cylinder_class = {
    .size = sizeof(Cylinder),
    .init = cylinder_init,
    .is_hit = cylinder_is_hit,
    .is_occluding = cylinder_is_occluding,
    .bounds = cylinder_bounds,
    .texture_uv = cylinder_texture_uv,
};
