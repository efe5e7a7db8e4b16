/**
 * @file
 * @brief Cone or frustum, open or capped.
 *
 * As in the cylinder, one interval of the ray lies between the planes of the ends, another one
 * inside the infinite wall. Here `c` and `s` are the cosine and the sine of the angle between wall
 * and axis. With the origin of the frame at the narrow end, of radius r, a point is inside if
 *
 *     c^2 (x^2 + y^2) <= (c r + s z)^2
 *
 * Neither side cancels between the ends. It holds for a cylinder (s = 0) as for a disk (c near 0),
 * and as well beyond the tip, in the mirrored cone, which the planes of the ends cut off.
 *
 * Along a ray this is quadratic in t. Its discriminant, a difference of products as in the
 * textbook, would cancel. By the identity of Lagrange it equals a difference of squares of cross
 * products, whose lengths are distances of the ray, as in the cylinder. All of it is relative to
 * the origin of the ray and in the wide precision.
 */
#include "trace/shapes/support.h"

/**
 * Bound on the error of a point, in half ulps of its coordinates and of #Cone.magnitude, which
 * contains length L and larger radius R. The terms: projection onto the wall, 5 (R + L); direction
 * and length of the axes, 5 (R + L); rotation to the axes of the scene, 3 sqrt(3) (R + L); addition
 * of the origin, sqrt(3) times the coordinates.
 */
#define CONE_ERROR 16

/**
 * Distance in radii of the cone from which on a ray is represented by its point nearest to the
 * middle. Nearer, by its origin: the sign of its height above the wall is then exact enough for
 * rays that leave the wall.
 */
#define CONE_FAR_RADII 4

/** A cone or frustum. @extends Shape */
typedef struct Cone {
    Shape base;               /**< Base. */
    AxialFrame frame;         /**< Local axes; the origin is the centre of the narrow end. */
    Vec3sw middle;            /**< Middle of the axis. */
    wide_scalar far_squared;  /**< Square of the distance from which on a ray is far away. */
    wide_scalar low;          /**< Height of the base in the frame: 0, or minus the length. */
    wide_scalar high;         /**< Height of the top: the length, or 0. */
    wide_scalar base_radius;  /**< Radius of the base. */
    wide_scalar top_radius;   /**< Radius of the top. */
    wide_scalar cosine;       /**< Of the angle between wall and axis. */
    wide_scalar sine;         /**< Of it: above 0 if the cone becomes wider to the top. */
    wide_scalar scaled_waist; /**< The smaller radius times #cosine. */
    scalar magnitude;         /**< Largest coordinate of the origin, plus length and larger radius:
                                   rounding errors scale with it. */
    bool is_capped;           /**< Whether the ends are closed. */
} Cone;

/** What #cone_intersect finds. */
typedef struct ConeRoots {
    AxialRay ray; /**< The rays in local coordinates. */
    AxialHit hit; /**< The hits. */
} ConeRoots;

/** See #ShapeClass.init. */
static void cone_init(Shape *self, const void *parameters) {
    Cone *cone = (Cone *)self;
    const ConeParameters *p = parameters;
    bool is_wide_at_top = p->top_radius > p->radius;
    Vec3d narrow_end = is_wide_at_top ? p->base : p->top;
    wide_scalar wide_radius = (wide_scalar)(is_wide_at_top ? p->top_radius : p->radius);
    cone->frame = axial_frame_of(p->base, p->top, narrow_end);
    wide_scalar length = cone->frame.length;
    cone->low = is_wide_at_top ? 0 : -length;
    cone->high = is_wide_at_top ? length : 0;
    cone->base_radius = (wide_scalar)p->radius;
    cone->top_radius = (wide_scalar)p->top_radius;
    wide_scalar widening = cone->top_radius - cone->base_radius;
    wide_scalar slant = WIDE_SQRT(length * length + widening * widening);
    cone->cosine = length / slant;
    cone->sine = widening / slant;
    cone->scaled_waist = cone->cosine * (is_wide_at_top ? cone->base_radius : cone->top_radius);
    cone->magnitude = (scalar)vec3d_max_abs(narrow_end) + (scalar)(wide_radius + length);
    cone->is_capped = p->capped;
    cone->middle = vec3sw_of(vec3d_scale(vec3d_add(p->base, p->top), 0.5));
    cone->far_squared =
        CONE_FAR_RADII * CONE_FAR_RADII * (length * length + wide_radius * wide_radius);
}

/**
 * @return For rays that start far away, the distance of their point nearest to the middle; else 0.
 *         From their origin, the rounding of the wall's factors would count times the distance, and
 *         again over the sine of the angle to the wall.
 */
INLINE wide cone_shift(const Cone *cone, const Ray *ray) {
    const wide zero = wide_of(0);
    Vec3w direction = vec3_widen(ray->direction);
    Vec3w to_middle = vec3w_subtract(vec3w_splat(cone->middle), vec3_widen(ray->origin));
    wide along = vec3w_dot(to_middle, direction), square = vec3w_dot(direction, direction);
    wide_mask is_far =
        wide_less(zero, along) & wide_less(wide_of(cone->far_squared) * square, along * along);
    return wide_select(is_far, along / square, zero);
}

/** The quadratic inequality `square t^2 + 2 linear t + constant <= 0` of LANES rays. */
typedef struct ConeQuadratic {
    wide square;       /**< Factor of t^2: below 0 for rays steeper than the wall. */
    wide linear;       /**< Half the factor of t. */
    wide constant;     /**< At the origin: below 0 inside. */
    wide discriminant; /**< A quarter of the discriminant. */
    wide widening;     /**< Scaled radius gained per length of the direction. */
} ConeQuadratic;

/** @return The inequality of rays and a wall. */
INLINE ConeQuadratic cone_quadratic_of(const Cone *cone, const AxialRay *local_ray) {
    wide c = wide_of(cone->cosine), s = wide_of(cone->sine);
    wide ox = c * local_ray->origin.x, oy = c * local_ray->origin.y;
    wide dx = c * local_ray->direction.x, dy = c * local_ray->direction.y;
    wide radius = wide_of(cone->scaled_waist) + s * local_ray->origin.z;
    wide widening = s * local_ray->direction.z;
    wide cross = dx * oy - dy * ox;
    wide slip_x = widening * ox - radius * dx, slip_y = widening * oy - radius * dy;
    return (ConeQuadratic){.square = dx * dx + dy * dy - widening * widening,
                           .linear = ox * dx + oy * dy - radius * widening,
                           .constant = ox * ox + oy * oy - radius * radius,
                           .discriminant = slip_x * slip_x + slip_y * slip_y - cross * cross,
                           .widening = widening};
}

/**
 * Finds the part of rays inside the infinite wall.
 * @param[in,out] local_ray  The rays; sets #AxialRay.wall.
 * @return The lanes whose line meets the inside.
 */
INLINE mask cone_clip_wall(const Cone *cone, AxialRay *local_ray) {
    ConeQuadratic q = cone_quadratic_of(cone, local_ray);
    const wide zero = wide_of(0), endless = wide_of((wide_scalar)INFINITE);
    // A ray steeper than the wall meets both cones once. Only rounding makes its discriminant
    // negative, at the tip.
    wide_mask is_steep = wide_less(q.square, zero), is_negative = wide_less(q.discriminant, zero);
    wide root = wide_sqrt(wide_select(is_steep & is_negative, zero, q.discriminant));

    // The root farther from zero is a quotient of a sum, the other one follows from the product of
    // both: neither cancels, nor does a ray along the wall divide by zero.
    wide_mask is_ahead = wide_less(q.linear, zero);
    wide sum = wide_select(is_ahead, root - q.linear, -root - q.linear);
    wide far_root = sum / q.square, near_root = q.constant / sum;
    wide_mask is_tip = wide_equal(sum, zero);
    near_root = wide_select(is_tip, far_root, near_root);
    wide_mask is_rising = wide_less(near_root, far_root);
    wide low = wide_select(is_rising, near_root, far_root);
    wide high = wide_select(is_rising, far_root, near_root);

    // Between the roots a ray is inside, but a steep one is outside. Of its two endless parts, that
    // towards the wide end counts. Where nothing depends on t, it is inside everywhere or nowhere.
    wide_mask widens = wide_less(zero, q.widening);
    wide_mask is_constant = is_tip & wide_equal(q.square, zero);
    wide near = wide_select(is_steep, wide_select(widens, high, -endless), low);
    wide far = wide_select(is_steep, wide_select(widens, endless, low), high);
    local_ray->wall.near = wide_select(is_constant, -endless, near);
    local_ray->wall.far = wide_select(is_constant, endless, far);
    wide_mask has_roots = (is_steep & is_negative) | wide_less_equal(zero, q.discriminant);
    return narrow_mask((is_constant & wide_less_equal(q.constant, zero)) |
                       (wide_mask_not(is_constant) & has_roots));
}

/** Finds hits ahead of the origin. See #IntersectFunction. */
INLINE mask cone_intersect(const Shape *self, const Ray *ray, mask active, real *distance,
                           void *roots) {
    const Cone *cone = (const Cone *)self;
    ConeRoots *found = roots;
    // Float is solved in double, which has the bits to spare.
    if (REAL_BITS == 32) {
        axial_ray_init(&found->ray, &cone->frame, ray);
    } else {
        axial_ray_init_ahead(&found->ray, &cone->frame, ray, cone_shift(cone, ray));
    }
    mask crosses = active & cone_clip_wall(cone, &found->ray);
    if (!any(crosses)) {
        return crosses;
    }
    axial_ray_clip_ends(&found->ray, wide_of(cone->low), wide_of(cone->high));
    crosses &= cone->is_capped ? axial_ray_intersect_solid(&found->ray, &found->hit)
                               : axial_ray_intersect_wall(&found->ray, &found->hit);
    *distance = narrow(found->hit.distance - found->ray.start);
    return crosses;
}

/**
 * Finds points on the wall: those of the rays, projected onto the wall.
 * @param[out] normal  The normals, in local coordinates.
 * @return The points, in local coordinates.
 */
INLINE Vec3w cone_wall_point(const Cone *cone, const ConeRoots *roots, Vec3w *normal) {
    wide c = wide_of(cone->cosine), s = wide_of(cone->sine), zero = wide_of(0);
    Vec3w point = vec3w_add_scaled(roots->ray.origin, roots->ray.direction, roots->hit.distance);
    wide across = wide_sqrt(point.x * point.x + point.y * point.y);
    // At the very tip any normal of the wall is right.
    wide_mask is_tip = wide_equal(across, zero);
    wide x = wide_select(is_tip, wide_of(1), point.x / across);
    wide y = wide_select(is_tip, zero, point.y / across);
    *normal = (Vec3w){c * x, c * y, -s};

    wide height = c * across - (wide_of(cone->scaled_waist) + s * point.z);
    wide z = point.z + s * height, radius = across - c * height;
    wide_mask is_below = wide_less(z, wide_of(cone->low));
    wide_mask is_above = wide_less(wide_of(cone->high), z);
    z = wide_select(is_below, wide_of(cone->low), z);
    z = wide_select(is_above, wide_of(cone->high), z);
    radius = wide_select(is_below, wide_of(cone->base_radius), radius);
    radius = wide_select(is_above, wide_of(cone->top_radius), radius);
    return (Vec3w){x * radius, y * radius, z};
}

/** See #SurfaceFunction. */
INLINE SurfacePoint cone_surface(const Shape *self, const Ray *ray, real distance,
                                 const void *roots) {
    (void)ray;
    (void)distance;
    const Cone *cone = (const Cone *)self;
    const ConeRoots *found = roots;
    Vec3w wall_normal, end_normal;
    Vec3w on_wall = cone_wall_point(cone, found, &wall_normal);
    Vec3w on_end = axial_ray_end_point(&found->ray, &found->hit, wide_of(cone->low),
                                       wide_of(cone->high), &end_normal);
    Vec3w local_normal = vec3w_select(found->hit.is_wall, wall_normal, end_normal);
    Vec3 point =
        axial_frame_to_world_point(&cone->frame, vec3w_select(found->hit.is_wall, on_wall, on_end));
    return (SurfacePoint){point, vec3_narrow(axial_frame_to_world(&cone->frame, local_normal)),
                          CONE_ERROR * ROUNDOFF * (vec3_max_abs(point) + cone->magnitude)};
}

/** See #ShapeClass.is_hit. @callgraph */
static mask cone_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    ConeRoots roots;
    return primitive_is_hit(self, ray, active, hit, cone_intersect, cone_surface, &roots);
}

/** See #ShapeClass.is_occluding. */
static mask cone_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    ConeRoots roots;
    return primitive_is_occluding(self, ray, active, limit, cone_intersect, &roots);
}

/** See #ShapeClass.support. */
static real cone_support(const Shape *self, Vec3s from, Vec3 directions) {
    const Cone *cone = (const Cone *)self;
    return support_of_wall(&cone->frame, cone->low, cone->base_radius, cone->high, cone->top_radius,
                           from, directions);
}

/** @return The box around the circles of the ends. See #ShapeClass.bounds. */
static Aabbs cone_bounds(const Shape *self) {
    const Cone *cone = (const Cone *)self;
    const AxialFrame *frame = &cone->frame;
    Vec3d origin = vec3d_of(frame->origin), axis = vec3d_of(frame->axes[2]);
    const ConeParameters cone_in_double = {
        .base = vec3d_add(origin, vec3d_scale(axis, (double)cone->low)),
        .top = vec3d_add(origin, vec3d_scale(axis, (double)cone->high)),
        .radius = (double)cone->base_radius,
        .top_radius = (double)cone->top_radius};
    Aabbd box = cone_bounds_of(&cone_in_double, axis);
    return aabbs_padded_by_largest(aabbs_from_corners(box.low, box.high));
}

/** @return Angle and height on the wall; on an end, coordinates as on a disk. See
 *  #ShapeClass.texture_uv. */
static TextureUv cone_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Cone *cone = (const Cone *)self;
    const AxialFrame *frame = &cone->frame;
    const real half = real_of((scalar)0.5f);
    Vec3w local = axial_frame_to_local(
        frame, vec3w_subtract(vec3_widen(hit->point), vec3w_splat(frame->origin)));
    real height = narrow((local.z - wide_of(cone->low)) * wide_of(1 / frame->length));
    // On the wide end the normal points away from the wall's. On the narrow end it points to the
    // same side as that of a flat wall, which lies around it.
    bool is_wide_at_top = cone->sine > 0;
    wide_scalar narrow_radius = is_wide_at_top ? cone->base_radius : cone->top_radius;
    wide_scalar wide_radius = is_wide_at_top ? cone->top_radius : cone->base_radius;
    wide across_squared = local.x * local.x + local.y * local.y;
    mask in_narrow =
        narrow_mask(wide_less_equal(across_squared, wide_of(narrow_radius * narrow_radius)));
    real along_axis = component_along(vec3_widen(hit->normal), frame->axes[2]);
    mask looks_down = along_axis<-half, looks_up = along_axis> half;
    mask on_narrow = in_narrow & (is_wide_at_top ? looks_down : looks_up);
    mask on_wide = is_wide_at_top ? looks_up : looks_down;
    mask on_base = is_wide_at_top ? on_narrow : on_wide;
    // A tip has no width.
    real per_narrow = real_of((scalar)(narrow_radius > 0 ? 1 / narrow_radius : 0));
    real per_radius = real_select(on_narrow, per_narrow, real_of((scalar)(1 / wide_radius)));
    return axial_texture_uv(narrow(local.x) * per_radius, narrow(local.y) * per_radius, height,
                            on_base, on_narrow | on_wide);
}

/** Methods of `cone`. */
const ShapeClass cone_class = {
    .size = sizeof(Cone),
    .init = cone_init,
    .is_hit = cone_is_hit,
    .is_occluding = cone_is_occluding,
    .support = METHOD_OF_BEAMS(cone_support),
    .bounds = cone_bounds,
    .texture_uv = cone_texture_uv,
};
