/**
 * @file
 * @brief Box along the axes.
 *
 * One convex solid, not six quads: where the ray is between the planes of all three pairs at once
 * (Kay and Kajiya's slabs), so that no ray slips through an edge and none is counted twice. A
 * direction along an axis gives infinite or NaN distances, and every comparison drops the NaN; the
 * far side is moved out by the rounding of three operations (Ize, *Robust BVH Ray Traversal*, JCGT
 * 2013).
 */
#include "trace/shapes/registry.h"

/** Half ulps of the coordinates that a point can be off the box. */
#define BOX_ERROR 8

/** Relative slack of the far side: twice gamma 3, the error bound of three roundings. */
#define BOX_SLACK (1 + 2 * (3 * ROUNDOFF / (1 - 3 * ROUNDOFF)))

/** What a scene file says of a box. */
typedef struct BoxParameters {
    Vec3d min; /**< Lowest corner. */
    Vec3d max; /**< Highest corner. */
} BoxParameters;

/** A box. @extends Shape */
typedef struct Box {
    Shape base;     /**< What all shapes have. */
    scalar low[3];  /**< Lowest coordinates. */
    scalar high[3]; /**< Highest coordinates. */
} Box;

/** Where LANES rays enter and leave a box. */
typedef struct BoxInterval {
    real near;         /**< Where they are between all pairs of planes. */
    real far;          /**< Where they no longer are. */
    integer near_axis; /**< The axis whose pair they enter last. */
    integer far_axis;  /**< The axis whose pair they leave first. */
} BoxInterval;

/** Fields of `box`. */
static const Parameter box_parameters[] = {{.name = "min",
                                            .type = PARAMETER_POINT,
                                            .offset = offsetof(BoxParameters, min),
                                            .minimum = -LENGTH_MAXIMUM,
                                            .maximum = LENGTH_MAXIMUM,
                                            .unit = "scene units",
                                            .help = "its lowest corner"},
                                           {.name = "max",
                                            .type = PARAMETER_POINT,
                                            .offset = offsetof(BoxParameters, max),
                                            .minimum = -LENGTH_MAXIMUM,
                                            .maximum = LENGTH_MAXIMUM,
                                            .unit = "scene units",
                                            .help = "its highest corner"},
                                           {0}};

/** A cube of side 1. */
static const BoxParameters box_defaults = {.max = {1, 1, 1}};

/** Refuses boxes without volume. See #Keyword.finish. @return Whether the box has a volume. */
static bool box_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const BoxParameters *p = values;
    return (p->min.x < p->max.x && p->min.y < p->max.y && p->min.z < p->max.z) ||
           error_set(error, STATUS_SCENE, "box needs min below max in x, y and z");
}

/** Makes a box. */
static void box_init(Shape *self, const void *parameters) {
    Box *box = (Box *)self;
    const BoxParameters *p = parameters;
    const double low[3] = {p->min.x, p->min.y, p->min.z}, high[3] = {p->max.x, p->max.y, p->max.z};
    for (int axis = 0; axis < 3; axis++) {
        box->low[axis] = (scalar)low[axis];
        box->high[axis] = (scalar)high[axis];
    }
}

/**
 * Narrows an interval to the part of the rays between one pair of planes.
 * @param axis  0, 1 or 2 for x, y or z.
 * @param origin  Where the rays start, along the axis.
 * @param inverse  1 / direction, along the axis.
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

/** @return The lanes whose ray has no NaN. Slabs drop NaN of their own making, on purpose, and with
 *  it one that came in. */
INLINE mask ray_has_no_nan(const Ray *ray) {
    real sum = (ray->origin.x + ray->origin.y + ray->origin.z) +
               (ray->direction.x + ray->direction.y + ray->direction.z);
    return sum == sum;
}

/** Finds where rays enter and leave a box. @return The lanes whose line meets the box. */
INLINE mask box_intersect(const Box *box, const Ray *ray, mask active, BoxInterval *interval) {
    const scalar *low = box->low, *high = box->high;
    *interval = (BoxInterval){real_of(-INFINITE), real_of(INFINITE), integer_of(0), integer_of(0)};
    box_interval_clip(interval, 0, low[0], high[0], ray->origin.x, ray->inverse_direction.x);
    box_interval_clip(interval, 1, low[1], high[1], ray->origin.y, ray->inverse_direction.y);
    box_interval_clip(interval, 2, low[2], high[2], ray->origin.z, ray->inverse_direction.z);
    return active & ray_has_no_nan(ray) & (interval->far > 0) &
           (interval->near <= interval->far * BOX_SLACK);
}

/**
 * Puts a point on the face that it was found on: that coordinate is the face's, exactly, and the
 * normal is the one of the face.
 * @param[in,out] found  The hit; its distance and point are filled.
 * @param face  The axis of the face.
 * @param is_high  Whether it is the face with the highest coordinate.
 */
INLINE void box_snap_to_face(Hit *found, const Box *box, integer face, mask is_high) {
    real *point[3] = {&found->point.x, &found->point.y, &found->point.z};
    real *normal[3] = {&found->normal.x, &found->normal.y, &found->normal.z};
    real sign = real_select(is_high, real_of(1), real_of(-1));
    for (int axis = 0; axis < 3; axis++) {
        mask is_face_axis = face == integer_of(axis);
        real low = real_of(box->low[axis]), high = real_of(box->high[axis]);
        real inside = real_min(real_max(*point[axis], low), high);
        *point[axis] = real_select(is_face_axis, real_select(is_high, high, low), inside);
        *normal[axis] = real_select(is_face_axis, sign, real_of(0));
    }
}

/** @return Whether rays go up along an axis. */
INLINE mask ray_goes_up_along(const Ray *ray, integer axis) {
    mask x = axis == integer_of(0), y = axis == integer_of(1);
    return (x & (ray->inverse_direction.x > 0)) | (y & (ray->inverse_direction.y > 0)) |
           (mask_not(x | y) & (ray->inverse_direction.z > 0));
}

/** @return The lanes where the box is nearer. See #ShapeClass.is_hit. @callgraph */
static mask box_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const Box *box = (const Box *)self;
    BoxInterval interval;
    mask crosses = box_intersect(box, ray, active, &interval);
    mask is_outside = interval.near > 0;
    real distance = real_select(is_outside, interval.near, interval.far);
    mask nearer = hit_is_nearer(hit, crosses, distance, self->index);
    if (!any(nearer)) {
        return nearer;
    }
    // Entering upwards or leaving downwards, a ray is on the low face of the axis.
    integer face = integer_select(is_outside, interval.near_axis, interval.far_axis);
    mask goes_up = ray_goes_up_along(ray, face);
    mask is_high = (is_outside & mask_not(goes_up)) | (mask_not(is_outside) & goes_up);
    Hit found = hit_none(distance);
    found.point = vec3_add(ray->origin, vec3_scale(ray->direction, distance));
    box_snap_to_face(&found, box, face, is_high);
    found.error = BOX_ERROR * ROUNDOFF * vec3_max_abs(found.point);
    found.shape = integer_of(self->index);
    hit_update(hit, nearer, &found);
    return nearer;
}

/** @return The lanes where the box is on the way. See #ShapeClass.is_occluding. */
static mask box_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    BoxInterval interval;
    mask crosses = box_intersect((const Box *)self, ray, active, &interval);
    return crosses & (real_select(interval.near > 0, interval.near, interval.far) < limit);
}

/** @return The box around a box. */
static Aabbs box_bounds(const Shape *self) {
    const scalar *low = ((const Box *)self)->low, *high = ((const Box *)self)->high;
    return aabbs_from_corners((Vec3d){(double)low[0], (double)low[1], (double)low[2]},
                              (Vec3d){(double)high[0], (double)high[1], (double)high[2]});
}

/** @return Where on a picture points of a box lie. Each face shows all of the picture, as
 *  uv_frame_of says. See #ShapeClass.texture_uv. */
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

const ShapeClass box_class = {
    .keyword = {.name = "box",
                .help = "a box along the axes",
                .parameters = box_parameters,
                .size = sizeof(BoxParameters),
                .defaults = &box_defaults,
                .finish = box_finish},
    .size = sizeof(Box),
    .is_flat = true,
    .init = box_init,
    .is_hit = box_is_hit,
    .is_occluding = box_is_occluding,
    .bounds = box_bounds,
    .texture_uv = box_texture_uv,
};
