/**
 * @file
 * @brief Box along the axes.
 *
 * A box is one convex solid, not six quads: the part of the ray that lies between the planes of all
 * three pairs (the slabs of Kay and Kajiya). No ray slips through an edge, and none is counted
 * twice. A direction along an axis gives infinite or NaN distances, and every comparison rejects
 * NaN. The far side has the slack of three roundings (Ize, *Robust BVH Ray Traversal*, JCGT 2013).
 */
#include "trace/shapes/support.h"

/** Bound on the error of a point, in half ulps of its coordinates. */
#define BOX_ERROR 8

/** Relative slack of the far side: twice gamma 3, the error bound of three roundings. */
#define BOX_SLACK (1 + 2 * (3 * ROUNDOFF / (1 - 3 * ROUNDOFF)))

/** A box. @extends Shape */
typedef struct Box {
    Shape base;     /**< Base. */
    scalar low[3];  /**< Lowest coordinates. */
    scalar high[3]; /**< Highest coordinates. */
} Box;

/** The parts of LANES rays inside a box. */
typedef struct BoxInterval {
    real near;         /**< Distance of entry. */
    real far;          /**< Distance of exit. */
    integer near_axis; /**< Axis of the pair of planes that is entered last. */
    integer far_axis;  /**< Axis of the pair that is left first. */
} BoxInterval;

/** See #ShapeClass.init. */
static void box_init(Shape *self, const void *parameters) {
    Box *box = (Box *)self;
    const BoxParameters *p = parameters;
    const double low[3] = {p->low.x, p->low.y, p->low.z};
    const double high[3] = {p->high.x, p->high.y, p->high.z};
    for (int axis = 0; axis < 3; axis++) {
        box->low[axis] = (scalar)low[axis];
        box->high[axis] = (scalar)high[axis];
    }
}

/**
 * Clips an interval to the part of the rays between one pair of planes.
 * @param axis     0, 1 or 2 for x, y or z.
 * @param origin   Coordinate of the origins along the axis.
 * @param inverse  1 / direction along the axis.
 */
INLINE void box_interval_clip(BoxInterval *interval, int axis, scalar low, scalar high, real origin,
                              real inverse) {
    mask is_downwards = inverse < 0;
    real enter = (real_select(is_downwards, real_of(high), real_of(low)) - origin) * inverse;
    real leave = (real_select(is_downwards, real_of(low), real_of(high)) - origin) * inverse;
    mask is_later = enter > interval->near, is_earlier = leave < interval->far;
    interval->near = real_select(is_later, enter, interval->near);
    interval->near_axis = integer_select(is_later, integer_of(axis), interval->near_axis);
    interval->far = real_select(is_earlier, leave, interval->far);
    interval->far_axis = integer_select(is_earlier, integer_of(axis), interval->far_axis);
}

/** @return The lanes whose ray has no NaN: the slab test would not notice it, because it ignores
 * NaN that arises in its own products. */
INLINE mask ray_has_no_nan(const Ray *ray) {
    real sum = (ray->origin.x + ray->origin.y + ray->origin.z) +
               (ray->direction.x + ray->direction.y + ray->direction.z);
    return sum == sum;
}

/** Finds the interval inside a box; its end is the distance for rays that start inside. See
 *  #IntersectFunction. */
INLINE mask box_intersect(const Shape *self, const Ray *ray, mask active, real *distance,
                          void *roots) {
    BoxInterval *interval = roots;
    const scalar *low = ((const Box *)self)->low, *high = ((const Box *)self)->high;
    *interval = (BoxInterval){real_of(-INFINITE), real_of(INFINITE), integer_of(0), integer_of(0)};
    box_interval_clip(interval, 0, low[0], high[0], ray->origin.x, ray->inverse_direction.x);
    box_interval_clip(interval, 1, low[1], high[1], ray->origin.y, ray->inverse_direction.y);
    box_interval_clip(interval, 2, low[2], high[2], ray->origin.z, ray->inverse_direction.z);
    *distance = real_select(interval->near > 0, interval->near, interval->far);
    return active & ray_has_no_nan(ray) & (interval->far > 0) &
           (interval->near <= interval->far * BOX_SLACK);
}

/**
 * Moves points onto the face that the rays meet: their coordinate there is exactly that of the
 * face.
 * @param[in,out] surface  The points; the normals become those of the faces.
 * @param face             Axis of the face.
 * @param is_high          Whether it is the face with the highest coordinate.
 */
INLINE void box_snap_to_face(SurfacePoint *surface, const Box *box, integer face, mask is_high) {
    real *point[3] = {&surface->point.x, &surface->point.y, &surface->point.z};
    real *normal[3] = {&surface->normal.x, &surface->normal.y, &surface->normal.z};
    real sign = real_select(is_high, real_of(1), real_of(-1));
    for (int axis = 0; axis < 3; axis++) {
        mask is_face_axis = face == integer_of(axis);
        real low = real_of(box->low[axis]), high = real_of(box->high[axis]);
        real inside = real_min(real_max(*point[axis], low), high);
        *point[axis] = real_select(is_face_axis, real_select(is_high, high, low), inside);
        *normal[axis] = real_select(is_face_axis, sign, real_of(0));
    }
}

/** @return Whether the direction is positive along an axis. */
INLINE mask ray_goes_up_along(const Ray *ray, integer axis) {
    mask x = axis == integer_of(0), y = axis == integer_of(1);
    return (x & (ray->inverse_direction.x > 0)) | (y & (ray->inverse_direction.y > 0)) |
           (mask_not(x | y) & (ray->inverse_direction.z > 0));
}

/** See #SurfaceFunction. */
INLINE SurfacePoint box_surface(const Shape *self, const Ray *ray, real distance,
                                const void *roots) {
    const BoxInterval *interval = roots;
    mask is_outside = interval->near > 0;
    // A ray that enters upwards or leaves downwards is on the low face of the axis.
    integer face = integer_select(is_outside, interval->near_axis, interval->far_axis);
    mask goes_up = ray_goes_up_along(ray, face);
    mask is_high = (is_outside & mask_not(goes_up)) | (mask_not(is_outside) & goes_up);
    SurfacePoint surface = {.point = vec3_add(ray->origin, vec3_scale(ray->direction, distance))};
    box_snap_to_face(&surface, (const Box *)self, face, is_high);
    surface.error = BOX_ERROR * ROUNDOFF * vec3_max_abs(surface.point);
    return surface;
}

/** See #ShapeClass.is_hit. @callgraph */
static mask box_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    BoxInterval interval;
    return primitive_is_hit(self, ray, active, hit, box_intersect, box_surface, &interval);
}

/** See #ShapeClass.is_occluding. */
static mask box_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    BoxInterval interval;
    return primitive_is_occluding(self, ray, active, limit, box_intersect, &interval);
}

/** See #ShapeClass.support. */
static real box_support(const Shape *self, Vec3s from, Vec3 directions) {
    const Box *box = (const Box *)self;
    return support_of_box(box->low, box->high, from, directions);
}

/** See #ShapeClass.bounds. */
static Aabbs box_bounds(const Shape *self) {
    const scalar *low = ((const Box *)self)->low, *high = ((const Box *)self)->high;
    return aabbs_from_corners((Vec3d){(double)low[0], (double)low[1], (double)low[2]},
                              (Vec3d){(double)high[0], (double)high[1], (double)high[2]});
}

/** @return Coordinates on the face: each face shows the whole picture, upright as in #uv_frame_of.
 *  See #ShapeClass.texture_uv. */
static TextureUv box_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Box *box = (const Box *)self;
    const real zero = real_of(0), one = real_of(1), half = real_of((scalar)0.5f);
    Vec3 n = hit->normal;
    real x = (hit->point.x - box->low[0]) / real_of(box->high[0] - box->low[0]);
    real y = (hit->point.y - box->low[1]) / real_of(box->high[1] - box->low[1]);
    real z = (hit->point.z - box->low[2]) / real_of(box->high[2] - box->low[2]);
    mask on_x = real_abs(n.x) > half, on_y = real_abs(n.y) > half;
    real along_z = real_select(n.x > zero, one - z, z),
         along_x = real_select(n.z < zero, one - x, x);
    return (TextureUv){.u = real_select(on_x, along_z, real_select(on_y, x, along_x)),
                       .v = real_select(on_y, real_select(n.y > zero, one - z, z), y),
                       .wrap_u = mask_of(false),
                       .wrap_v = mask_of(false)};
}

/** Methods of `box`. */
const ShapeClass box_class = {
    .size = sizeof(Box),
    .form = FORM_CONVEX,
    .init = box_init,
    .is_hit = box_is_hit,
    .is_occluding = box_is_occluding,
    .support = METHOD_OF_BEAMS(box_support),
    .bounds = box_bounds,
    .texture_uv = box_texture_uv,
};
