/**
 * @file
 * @brief Cylinder, open or capped (row D1).
 *
 * A ray is between the two planes of its ends in one interval, and inside the endless wall in
 * another. A capped cylinder is where it is both: one convex solid, so that no ray slips through
 * the rim and none is counted twice. An open one has a hit wherever the wall is crossed between the
 * planes.
 *
 * Whether the wall is met at all is seen in the plane across the axis: by how far the ray passes
 * beside it, a cross product, and never by b^2 - ac, which cancels. All of it is relative to the
 * origin of the ray and in the wide precision.
 */
#include "trace/shapes/cylinder.h"

#include "trace/math/angle.h"
#include "trace/shapes/circle.h"
#include "trace/shapes/registry.h"
#include "trace/shapes/uv_frame.h"

/** Half ulps of the coordinates that a point can be off the cylinder. */
#define CYLINDER_ERROR 8

/** A cylinder. Its own axes: two across, and z from the base to the top. @extends Shape */
typedef struct Cylinder {
    Shape base;         /**< What all shapes have. */
    Vec3sw base_center; /**< Centre of its base. */
    Vec3sw axes[3];     /**< Its own axes, unit vectors. */
    wide_scalar length; /**< From base to top. */
    wide_scalar radius; /**< Its radius. */
    scalar magnitude;   /**< Largest coordinate of the foot, length and radius: what its rounding
                         errors scale with. */
    bool is_capped;     /**< Whether the ends are closed. */
} Cylinder;

/** A part of LANES rays. */
typedef struct RayInterval {
    wide near; /**< Where it begins, in lengths of the direction. */
    wide far;  /**< Where it ends. */
} RayInterval;

/** LANES rays as a cylinder sees them. */
typedef struct CylinderRay {
    Vec3w origin;     /**< Where they start, along its own axes, from its foot. */
    Vec3w direction;  /**< Which way, along its own axes. */
    wide axis_offset; /**< How far they pass beside the axis, over the length across it. */
    wide half_chord;  /**< Half the chord of the wall. */
    RayInterval wall; /**< Where they are inside the wall. */
    RayInterval caps; /**< Where they are between the planes of the ends. */
} CylinderRay;

/** Where LANES rays meet a cylinder. */
typedef struct CylinderHit {
    wide distance;      /**< Where. */
    wide_mask is_wall;  /**< Whether on the wall, not on an end. */
    wide_mask is_entry; /**< Whether from outside, where the interval begins. */
} CylinderHit;

/** Fields of `cylinder`. */
static const Parameter cylinder_parameters[] = {
    {.name = "base",
     .type = PARAMETER_POINT,
     .offset = offsetof(CylinderParameters, base),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "scene units",
     .help = "centre of one end"},
    {.name = "top",
     .type = PARAMETER_POINT,
     .offset = offsetof(CylinderParameters, top),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "scene units",
     .help = "centre of the other end"},
    {.name = "radius",
     .type = PARAMETER_NUMBER,
     .offset = offsetof(CylinderParameters, radius),
     .minimum = LENGTH_MINIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "scene units",
     .help = "its radius"},
    {.name = "capped",
     .type = PARAMETER_BOOLEAN,
     .offset = offsetof(CylinderParameters, capped),
     .unit = "yes or no",
     .help = "whether its ends are closed; else it is a pipe"},
    {0}};

/** A cylinder of radius 1 and height 1 that stands on the ground. */
static const CylinderParameters cylinder_defaults = {.top = {0, 1, 0}, .radius = 1, .capped = true};

/** Refuses cylinders without length. See #Keyword.finish. @return Whether the cylinder has a
 *  length. */
static bool cylinder_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const CylinderParameters *p = values;
    return vec3d_length(vec3d_subtract(p->top, p->base)) >= LENGTH_MINIMUM ||
           error_set(error, STATUS_SCENE, "cylinder has no length: base and top are the same");
}

/** @return The axis that a direction runs least along, so that a product with it is safe and, for a
 *  direction along an axis, exact. */
static Vec3sw least_aligned_axis(Vec3d v) {
    Vec3d a = {fabs(v.x), fabs(v.y), fabs(v.z)};
    if (a.x <= a.y && a.x <= a.z) {
        return (Vec3sw){1, 0, 0};
    }
    return a.y <= a.z ? (Vec3sw){0, 1, 0} : (Vec3sw){0, 0, 1};
}

/** Makes a cylinder. */
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

/** @return Vectors along a cylinder's own axes. */
INLINE Vec3w cylinder_to_local(const Cylinder *cylinder, Vec3w v) {
    return (Vec3w){vec3w_dot(vec3w_splat(cylinder->axes[0]), v),
                   vec3w_dot(vec3w_splat(cylinder->axes[1]), v),
                   vec3w_dot(vec3w_splat(cylinder->axes[2]), v)};
}

/**
 * @return Vectors along x, y and z.
 * @param v  Along its own axes.
 */
INLINE Vec3w cylinder_to_world(const Cylinder *cylinder, Vec3w v) {
    Vec3w sum = vec3w_scale(vec3w_splat(cylinder->axes[0]), v.x);
    sum = vec3w_add_scaled(sum, vec3w_splat(cylinder->axes[1]), v.y);
    return vec3w_add_scaled(sum, vec3w_splat(cylinder->axes[2]), v.z);
}

/**
 * Finds where rays are inside the endless wall. Seen along the axis they run in a plane; they pass
 * beside the axis at |direction x origin| / |direction|.
 * @param[in,out] local_ray  The rays; #CylinderRay.wall, and what belongs to it, is filled.
 * @param radius           Radius of the wall.
 * @return The lanes whose line is inside anywhere.
 */
INLINE mask cylinder_ray_clip_wall(CylinderRay *local_ray, wide radius) {
    wide ox = local_ray->origin.x, oy = local_ray->origin.y;
    wide dx = local_ray->direction.x, dy = local_ray->direction.y;
    wide length_squared = dx * dx + dy * dy, cross = dx * oy - dy * ox;
    wide discriminant = radius * radius * length_squared - cross * cross;
    wide center_power = ox * ox + oy * oy - radius * radius;

    // The root farther from zero by a sum, the other by the product of the two.
    wide per_across = 1 / length_squared, middle = -(ox * dx + oy * dy) * per_across;
    wide half = wide_sqrt(discriminant) * per_across;
    const wide zero = wide_of(0), endless = wide_of((wide_scalar)INFINITE);
    wide_mask is_ahead = wide_less(zero, middle);
    wide sum = middle + wide_select(is_ahead, half, -half);
    wide quotient = center_power * per_across / sum;

    // Along the axis there are no roots: all of the ray is inside, or nothing.
    wide_mask is_along = wide_equal(length_squared, zero);
    local_ray->wall.near = wide_select(is_along, -endless, wide_select(is_ahead, quotient, sum));
    local_ray->wall.far = wide_select(is_along, endless, wide_select(is_ahead, sum, quotient));
    local_ray->axis_offset = cross * per_across;
    local_ray->half_chord = half;
    return narrow_mask((is_along & wide_less_equal(center_power, zero)) |
                       (wide_less(zero, length_squared) & wide_less_equal(zero, discriminant)));
}

/**
 * Finds where rays are between the planes of the ends: Kay and Kajiya's slab, as in the box.
 * @param[in,out] local_ray  The rays; #CylinderRay.caps is filled. Along the ends it is infinite.
 * @param length           From one to the other.
 */
INLINE void cylinder_ray_clip_caps(CylinderRay *local_ray, wide length) {
    wide inverse = 1 / local_ray->direction.z, to_base = -local_ray->origin.z;
    wide to_top = length - local_ray->origin.z, endless = wide_of((wide_scalar)INFINITE);
    wide_mask is_downwards = wide_less(inverse, wide_of(0));
    wide enter = wide_select(is_downwards, to_top, to_base) * inverse;
    wide leave = wide_select(is_downwards, to_base, to_top) * inverse;
    // 0 times infinity, in the plane of an end, is no number and drops out: that counts as between.
    local_ray->caps.near = wide_select(wide_less(-endless, enter), enter, -endless);
    local_ray->caps.far = wide_select(wide_less(leave, endless), leave, endless);
}

/** @return The lanes where a convex solid is met. */
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

/** @return Where a distance is ahead and within an interval. */
INLINE wide_mask ray_interval_contains_ahead(wide distance, const RayInterval *interval) {
    return wide_less(wide_of(0), distance) & wide_less_equal(interval->near, distance) &
           wide_less_equal(distance, interval->far);
}

/** @return The lanes where the wall alone is met: where it is entered, else where it is left. */
INLINE mask cylinder_ray_intersect_wall(const CylinderRay *local_ray, CylinderHit *local_hit) {
    const RayInterval *wall = &local_ray->wall, *ends = &local_ray->caps;
    wide_mask near_is_there = ray_interval_contains_ahead(wall->near, ends),
              far_is_there = ray_interval_contains_ahead(wall->far, ends);
    local_hit->is_entry = near_is_there;
    local_hit->distance = wide_select(near_is_there, wall->near, wall->far);
    local_hit->is_wall = wide_equal(local_hit->distance, local_hit->distance);
    return narrow_mask(near_is_there | far_is_there);
}

/**
 * @return The lanes where a cylinder is met ahead.
 * @param[out] local_ray  The rays as the cylinder sees them.
 * @param[out] local_hit  Where; filled if any lane meets it.
 */
INLINE mask cylinder_intersect(const Cylinder *cylinder, const Ray *ray, mask active,
                               CylinderRay *local_ray, CylinderHit *local_hit) {
    Vec3w from_base = vec3w_subtract(vec3_widen(ray->origin), vec3w_splat(cylinder->base_center));
    local_ray->origin = cylinder_to_local(cylinder, from_base);
    local_ray->direction = cylinder_to_local(cylinder, vec3_widen(ray->direction));
    mask crosses = active & cylinder_ray_clip_wall(local_ray, wide_of(cylinder->radius));
    if (!any(crosses)) {
        return crosses;
    }
    cylinder_ray_clip_caps(local_ray, wide_of(cylinder->length));
    return crosses & (cylinder->is_capped ? cylinder_ray_intersect_solid(local_ray, local_hit)
                                          : cylinder_ray_intersect_wall(local_ray, local_hit));
}

/**
 * Finds point and normal where rays meet the wall: on the chord, from its middle, which is the
 * point next to the axis. Never a difference of large numbers.
 * @param[out] normal  The normal, along the cylinder's own axes.
 * @return The point, along them.
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
 * Finds point and normal where rays meet an end.
 * @param[out] normal  The normal, along the cylinder's own axes.
 * @return The point, along them.
 */
INLINE Vec3w cylinder_ray_cap_point(const Cylinder *cylinder, const CylinderRay *local_ray,
                                    const CylinderHit *local_hit, Vec3w *normal) {
    Vec3w point = vec3w_add_scaled(local_ray->origin, local_ray->direction, local_hit->distance);
    // Entering upwards or leaving downwards, a ray is on the base.
    wide zero = wide_of(0), one = wide_of(1);
    wide_mask goes_up = wide_less(zero, local_ray->direction.z), enters = local_hit->is_entry;
    wide_mask is_base = (enters & goes_up) | wide_mask_not(enters | goes_up);
    *normal = (Vec3w){zero, zero, wide_select(is_base, -one, one)};
    point.z = wide_select(is_base, zero, wide_of(cylinder->length));
    return point;
}

/** @return Where rays meet a cylinder, in full. */
INLINE Hit cylinder_make_hit(const Cylinder *cylinder, const CylinderRay *local_ray,
                             const CylinderHit *local_hit) {
    Vec3w wall_normal, end_normal;
    Vec3w on_wall = cylinder_ray_wall_point(cylinder, local_ray, local_hit, &wall_normal);
    Vec3w on_end = cylinder_ray_cap_point(cylinder, local_ray, local_hit, &end_normal);
    Vec3w local_point = vec3w_select(local_hit->is_wall, on_wall, on_end);
    Vec3w normal = vec3w_select(local_hit->is_wall, wall_normal, end_normal);
    Vec3w point = vec3w_add_scaled(vec3w_splat(cylinder->base_center),
                                   cylinder_to_world(cylinder, local_point), wide_of(1));
    Hit found = hit_none(narrow(local_hit->distance));
    found.point = vec3_narrow(point);
    found.normal = vec3_narrow(cylinder_to_world(cylinder, normal));
    found.error = CYLINDER_ERROR * ROUNDOFF * (vec3_max_abs(found.point) + cylinder->magnitude);
    found.shape = integer_of(cylinder->base.index);
    return found;
}

/** @return The lanes where the cylinder is nearer. See #ShapeClass.is_hit. @callgraph */
static mask cylinder_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const Cylinder *cylinder = (const Cylinder *)self;
    CylinderRay local_ray;
    CylinderHit local_hit;
    mask met = cylinder_intersect(cylinder, ray, active, &local_ray, &local_hit);
    if (!any(met)) {
        return met;
    }
    mask nearer = hit_is_nearer(hit, met, narrow(local_hit.distance), self->index);
    if (any(nearer)) {
        Hit found = cylinder_make_hit(cylinder, &local_ray, &local_hit);
        hit_update(hit, nearer, &found);
    }
    return nearer;
}

/** @return The lanes where the cylinder is on the way. See #ShapeClass.is_occluding. */
static mask cylinder_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    CylinderRay local_ray;
    CylinderHit local_hit;
    mask met = cylinder_intersect((const Cylinder *)self, ray, active, &local_ray, &local_hit);
    if (!any(met)) {
        return met;
    }
    real distance = narrow(local_hit.distance);
    return met & (distance > 0) & (distance < limit);
}

/** @return The box around a cylinder: around the circles of its ends. */
static Aabbs cylinder_bounds(const Shape *self) {
    const Cylinder *cylinder = (const Cylinder *)self;
    Vec3sw axis_vector = vec3sw_scale(cylinder->axes[2], cylinder->length);
    Vec3d base = vec3d_of(cylinder->base_center), top = vec3d_add(base, vec3d_of(axis_vector));
    Vec3d extent = circle_extent(cylinder->axes[2], cylinder->radius);
    return aabbs_from_corners(vec3d_subtract(vec3d_min(base, top), extent),
                              vec3d_add(vec3d_max(base, top), extent));
}

/** @return Where on a picture points of a cylinder lie: around it and from base to top; on an end,
 *  as on a disk. See #ShapeClass.texture_uv. */
static TextureUv cylinder_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Cylinder *cylinder = (const Cylinder *)self;
    const Vec3sw *axes = cylinder->axes;
    const real half = real_of((scalar)0.5f);
    Vec3w from_base = vec3w_subtract(vec3_widen(hit->point), vec3w_splat(cylinder->base_center));
    Vec3w in_radii = vec3w_scale(from_base, wide_of(1 / cylinder->radius));
    real along_axis = component_along(vec3_widen(hit->normal), axes[2]);
    mask on_base = along_axis < -half, on_end = on_base | (along_axis > half);
    // The front, opposite the first axis, is the middle of the picture.
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
    .keyword = {.name = "cylinder",
                .help = "a cylinder, solid or a pipe",
                .parameters = cylinder_parameters,
                .size = sizeof(CylinderParameters),
                .defaults = &cylinder_defaults,
                .finish = cylinder_finish},
    .size = sizeof(Cylinder),
    .init = cylinder_init,
    .is_hit = cylinder_is_hit,
    .is_occluding = cylinder_is_occluding,
    .bounds = cylinder_bounds,
    .texture_uv = cylinder_texture_uv,
};
