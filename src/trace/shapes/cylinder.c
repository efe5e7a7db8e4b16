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
#include "trace/angle.h"
#include "trace/shapes/circle.h"
#include "trace/shapes/registry.h"
#include "trace/shapes/upright.h"

/** Half ulps of the coordinates that a point can be off the cylinder. */
#define CYLINDER_ERROR 8

/** What a scene file says of a cylinder. */
typedef struct CylinderParameters {
    Vector3 base;  /**< Centre of one end. */
    Vector3 top;   /**< Centre of the other. */
    double radius; /**< Its radius, scene units. */
    bool capped;   /**< Whether the ends are closed. */
} CylinderParameters;

/** A cylinder. Its own axes: two across, and z from the base to the top. @extends Shape */
typedef struct Cylinder {
    Shape base;         /**< What all shapes have. */
    WidePoint foot;     /**< Centre of its base. */
    WidePoint axes[3];  /**< Its own axes, unit vectors. */
    wide_scalar length; /**< From base to top. */
    wide_scalar radius; /**< Its radius. */
    scalar reach;       /**< Largest coordinate of the foot, length and radius: what its rounding
                             errors scale with. */
    bool is_capped;     /**< Whether the ends are closed. */
} Cylinder;

/** A part of LANES rays. */
typedef struct Interval {
    wide near; /**< Where it begins, in lengths of the direction. */
    wide far;  /**< Where it ends. */
} Interval;

/** LANES rays as a cylinder sees them. */
typedef struct Passage {
    WideVector origin;    /**< Where they start, along its own axes, from its foot. */
    WideVector direction; /**< Which way, along its own axes. */
    wide beside;          /**< How far they pass beside the axis, over the length across it. */
    wide half;            /**< Half the chord of the wall. */
    Interval wall;        /**< Where they are inside the wall. */
    Interval ends;        /**< Where they are between the planes of the ends. */
} Passage;

/** Where LANES rays meet a cylinder. */
typedef struct Meeting {
    wide distance;     /**< Where. */
    wide_mask is_wall; /**< Whether on the wall, not on an end. */
    wide_mask enters;  /**< Whether from outside, where the interval begins. */
} Meeting;

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

/**
 * Refuses cylinders without length. See #Keyword.finish.
 * @param[in,out] values  A #CylinderParameters.
 * @param given           Not looked at.
 * @param[out] error      What is wrong.
 * @return Whether the cylinder has a length.
 */
static bool cylinder_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const CylinderParameters *p = values;
    return vector3_length(vector3_subtract(p->top, p->base)) >= LENGTH_MINIMUM ||
           error_set(error, STATUS_SCENE, "cylinder has no length: base and top are the same");
}

/** @return The axis that a direction runs least along, so that a product with it is safe and, for a
 *          direction along an axis, exact. @param v The direction. */
static WidePoint least_axis(Vector3 v) {
    Vector3 a = {fabs(v.x), fabs(v.y), fabs(v.z)};
    if (a.x <= a.y && a.x <= a.z) {
        return (WidePoint){1, 0, 0};
    }
    return a.y <= a.z ? (WidePoint){0, 1, 0} : (WidePoint){0, 0, 1};
}

/** Makes a cylinder. @param self The cylinder. @param parameters A #CylinderParameters. */
static void cylinder_init(Shape *self, const void *parameters) {
    Cylinder *cylinder = (Cylinder *)self;
    const CylinderParameters *p = parameters;
    WidePoint way = wide_point_subtract(wide_point_of(p->top), wide_point_of(p->base));
    WidePoint axis = wide_point_normalize(way);
    cylinder->foot = wide_point_of(p->base);
    cylinder->axes[0] = wide_point_normalize(wide_point_cross(axis, least_axis(vector3_of(axis))));
    cylinder->axes[1] = wide_point_cross(axis, cylinder->axes[0]);
    cylinder->axes[2] = axis;
    cylinder->length = wide_point_dot(way, axis);
    cylinder->radius = (wide_scalar)p->radius;
    cylinder->reach = (scalar)(vector3_largest(p->base) + p->radius) + (scalar)cylinder->length;
    cylinder->is_capped = p->capped;
}

/** @return Vectors along a cylinder's own axes. @param cylinder The cylinder. @param v Vectors. */
INLINE WideVector cylinder_turn(const Cylinder *cylinder, WideVector v) {
    return (WideVector){wide_dot(wide_vector_of(cylinder->axes[0]), v),
                        wide_dot(wide_vector_of(cylinder->axes[1]), v),
                        wide_dot(wide_vector_of(cylinder->axes[2]), v)};
}

/** @return Vectors along x, y and z. @param cylinder The cylinder. @param v Along its own axes. */
INLINE WideVector cylinder_turn_back(const Cylinder *cylinder, WideVector v) {
    WideVector sum = wide_scale(wide_vector_of(cylinder->axes[0]), v.x);
    sum = wide_add_scaled(sum, wide_vector_of(cylinder->axes[1]), v.y);
    return wide_add_scaled(sum, wide_vector_of(cylinder->axes[2]), v.z);
}

/**
 * Finds where rays are inside the endless wall. Seen along the axis they run in a plane; they pass
 * beside the axis at |direction x origin| / |direction|.
 * @param[in,out] passage  The rays; #Passage.wall, and what belongs to it, is filled.
 * @param radius           Radius of the wall.
 * @return The lanes whose line is inside anywhere.
 */
INLINE mask passage_wall(Passage *passage, wide radius) {
    wide ox = passage->origin.x, oy = passage->origin.y;
    wide dx = passage->direction.x, dy = passage->direction.y;
    wide across = dx * dx + dy * dy, cross = dx * oy - dy * ox;
    wide left = radius * radius * across - cross * cross;
    wide power = ox * ox + oy * oy - radius * radius;

    // The root farther from zero by a sum, the other by the product of the two.
    wide per_across = 1 / across, middle = -(ox * dx + oy * dy) * per_across;
    wide half = wide_sqrt(left) * per_across;
    const wide zero = wide_of(0), endless = wide_of((wide_scalar)INFINITE);
    wide_mask is_ahead = wide_below(zero, middle);
    wide sum = middle + wide_select(is_ahead, half, -half);
    wide quotient = power * per_across / sum;

    // Along the axis there are no roots: all of the ray is inside, or nothing.
    wide_mask is_along = wide_equal(across, zero);
    passage->wall.near = wide_select(is_along, -endless, wide_select(is_ahead, quotient, sum));
    passage->wall.far = wide_select(is_along, endless, wide_select(is_ahead, sum, quotient));
    passage->beside = cross * per_across;
    passage->half = half;
    return narrow_mask((is_along & wide_at_most(power, zero)) |
                       (wide_below(zero, across) & wide_at_most(zero, left)));
}

/**
 * Finds where rays are between the planes of the ends: Kay and Kajiya's slab, as in the box.
 * @param[in,out] passage  The rays; #Passage.ends is filled. Along the ends it is infinite.
 * @param length           From one to the other.
 */
INLINE void passage_ends(Passage *passage, wide length) {
    wide inverse = 1 / passage->direction.z, to_base = -passage->origin.z;
    wide to_top = length - passage->origin.z, endless = wide_of((wide_scalar)INFINITE);
    wide_mask is_downwards = wide_below(inverse, wide_of(0));
    wide enter = wide_select(is_downwards, to_top, to_base) * inverse;
    wide leave = wide_select(is_downwards, to_base, to_top) * inverse;
    // 0 times infinity, in the plane of an end, is no number and drops out: that counts as between.
    passage->ends.near = wide_select(wide_below(-endless, enter), enter, -endless);
    passage->ends.far = wide_select(wide_below(leave, endless), leave, endless);
}

/**
 * @return The lanes where a convex solid is met.
 * @param passage       The rays.
 * @param[out] meeting  Where.
 */
INLINE mask passage_meet_solid(const Passage *passage, Meeting *meeting) {
    const Interval *wall = &passage->wall, *ends = &passage->ends;
    const wide zero = wide_of(0);
    wide_mask wall_first = wide_at_most(ends->near, wall->near);
    wide_mask wall_last = wide_at_most(wall->far, ends->far);
    wide near = wide_select(wall_first, wall->near, ends->near);
    wide far = wide_select(wall_last, wall->far, ends->far);
    meeting->enters = wide_below(zero, near);
    meeting->distance = wide_select(meeting->enters, near, far);
    meeting->is_wall =
        (meeting->enters & wall_first) | (wide_mask_not(meeting->enters) & wall_last);
    return narrow_mask(wide_at_most(near, far) & wide_below(zero, far));
}

/** @return Where a distance is ahead and within an interval. @param distance The distance.
 *  @param interval The interval. */
INLINE wide_mask ahead_within(wide distance, const Interval *interval) {
    return wide_below(wide_of(0), distance) & wide_at_most(interval->near, distance) &
           wide_at_most(distance, interval->far);
}

/**
 * @return The lanes where the wall alone is met: where it is entered, else where it is left.
 * @param passage       The rays.
 * @param[out] meeting  Where.
 */
INLINE mask passage_meet_wall(const Passage *passage, Meeting *meeting) {
    const Interval *wall = &passage->wall, *ends = &passage->ends;
    wide_mask near_is_there = ahead_within(wall->near, ends),
              far_is_there = ahead_within(wall->far, ends);
    meeting->enters = near_is_there;
    meeting->distance = wide_select(near_is_there, wall->near, wall->far);
    meeting->is_wall = wide_equal(meeting->distance, meeting->distance);
    return narrow_mask(near_is_there | far_is_there);
}

/**
 * @return The lanes where a cylinder is met ahead.
 * @param cylinder      The cylinder.
 * @param ray           The rays.
 * @param active        The lanes that count.
 * @param[out] passage  The rays as the cylinder sees them.
 * @param[out] meeting  Where; filled if any lane meets it.
 */
INLINE mask cylinder_meet(const Cylinder *cylinder, const Ray *ray, mask active, Passage *passage,
                          Meeting *meeting) {
    WideVector from_foot = wide_subtract(vector_widen(ray->origin), wide_vector_of(cylinder->foot));
    passage->origin = cylinder_turn(cylinder, from_foot);
    passage->direction = cylinder_turn(cylinder, vector_widen(ray->direction));
    mask crosses = active & passage_wall(passage, wide_of(cylinder->radius));
    if (!any(crosses)) {
        return crosses;
    }
    passage_ends(passage, wide_of(cylinder->length));
    return crosses & (cylinder->is_capped ? passage_meet_solid(passage, meeting)
                                          : passage_meet_wall(passage, meeting));
}

/**
 * Finds point and normal where rays meet the wall: on the chord, from its middle, which is the
 * point next to the axis. Never a difference of large numbers.
 * @param cylinder     The cylinder.
 * @param passage      The rays.
 * @param meeting      Where.
 * @param[out] normal  The normal, along the cylinder's own axes.
 * @return The point, along them.
 */
INLINE WideVector passage_on_wall(const Cylinder *cylinder, const Passage *passage,
                                  const Meeting *meeting, WideVector *normal) {
    WideVector d = passage->direction;
    wide half = wide_select(meeting->enters, -passage->half, passage->half);
    wide x = d.x * half - d.y * passage->beside, y = d.y * half + d.x * passage->beside;
    wide z = passage->origin.z + d.z * meeting->distance, zero = wide_of(0);
    wide length = wide_of(cylinder->length), per_radius = wide_of(1 / cylinder->radius);
    z = wide_select(wide_below(zero, z), z, zero);
    *normal = (WideVector){x * per_radius, y * per_radius, zero};
    return (WideVector){x, y, wide_select(wide_below(z, length), z, length)};
}

/**
 * Finds point and normal where rays meet an end.
 * @param cylinder     The cylinder.
 * @param passage      The rays.
 * @param meeting      Where.
 * @param[out] normal  The normal, along the cylinder's own axes.
 * @return The point, along them.
 */
INLINE WideVector passage_on_end(const Cylinder *cylinder, const Passage *passage,
                                 const Meeting *meeting, WideVector *normal) {
    WideVector point = wide_add_scaled(passage->origin, passage->direction, meeting->distance);
    // Entering upwards or leaving downwards, a ray is on the base.
    wide zero = wide_of(0), one = wide_of(1);
    wide_mask goes_up = wide_below(zero, passage->direction.z), enters = meeting->enters;
    wide_mask is_base = (enters & goes_up) | wide_mask_not(enters | goes_up);
    *normal = (WideVector){zero, zero, wide_select(is_base, -one, one)};
    point.z = wide_select(is_base, zero, wide_of(cylinder->length));
    return point;
}

/**
 * @return Where rays meet a cylinder, in full.
 * @param cylinder  The cylinder.
 * @param passage   The rays.
 * @param meeting   Where.
 */
INLINE Hit cylinder_hit(const Cylinder *cylinder, const Passage *passage, const Meeting *meeting) {
    WideVector wall_normal, end_normal;
    WideVector on_wall = passage_on_wall(cylinder, passage, meeting, &wall_normal);
    WideVector on_end = passage_on_end(cylinder, passage, meeting, &end_normal);
    WideVector own = wide_vector_select(meeting->is_wall, on_wall, on_end);
    WideVector normal = wide_vector_select(meeting->is_wall, wall_normal, end_normal);
    WideVector point = wide_add_scaled(wide_vector_of(cylinder->foot),
                                       cylinder_turn_back(cylinder, own), wide_of(1));
    Hit found = hit_nothing(narrow(meeting->distance));
    found.point = vector_narrow(point);
    found.normal = vector_narrow(cylinder_turn_back(cylinder, normal));
    found.error = CYLINDER_ERROR * ROUNDOFF * (vector_largest(found.point) + cylinder->reach);
    found.shape = integer_of(cylinder->base.place);
    return found;
}

/** @return The lanes where the cylinder is nearer. See #ShapeClass.is_hit. @callgraph
 *  @param self The cylinder. @param ray The rays. @param active The lanes.
 *  @param[in,out] hit The hit. */
static mask cylinder_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const Cylinder *cylinder = (const Cylinder *)self;
    Passage passage;
    Meeting meeting;
    mask met = cylinder_meet(cylinder, ray, active, &passage, &meeting);
    if (!any(met)) {
        return met;
    }
    mask nearer = hit_is_nearer(hit, met, narrow(meeting.distance), self->place);
    if (any(nearer)) {
        Hit found = cylinder_hit(cylinder, &passage, &meeting);
        hit_take(hit, nearer, &found);
    }
    return nearer;
}

/** @return The lanes where the cylinder is on the way. See #ShapeClass.is_blocking.
 *  @param self The cylinder. @param ray The rays. @param active The lanes.
 *  @param limit The way's end. */
static mask cylinder_is_blocking(const Shape *self, const Ray *ray, mask active, real limit) {
    Passage passage;
    Meeting meeting;
    mask met = cylinder_meet((const Cylinder *)self, ray, active, &passage, &meeting);
    if (!any(met)) {
        return met;
    }
    real distance = narrow(meeting.distance);
    return met & (distance > 0) & (distance < limit);
}

/** @return The box around a cylinder: around the circles of its ends. @param self The cylinder. */
static Bounds cylinder_bounds(const Shape *self) {
    const Cylinder *cylinder = (const Cylinder *)self;
    WidePoint way = wide_point_scale(cylinder->axes[2], cylinder->length);
    Vector3 base = vector3_of(cylinder->foot), top = vector3_add(base, vector3_of(way));
    Vector3 reach = circle_reach(cylinder->axes[2], cylinder->radius);
    return bounds_around(vector3_subtract(vector3_lowest(base, top), reach),
                         vector3_add(vector3_highest(base, top), reach));
}

/**
 * @return Where on a picture points of a cylinder lie: around it and from base to top; on an end,
 *         as on a disk. See #ShapeClass.texture_place.
 * @param self   The cylinder.
 * @param hit    The points.
 * @param lanes  Not looked at.
 */
static TexturePlace cylinder_texture_place(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Cylinder *cylinder = (const Cylinder *)self;
    const WidePoint *axes = cylinder->axes;
    const real half = real_of((scalar)0.5f);
    WideVector arm = wide_subtract(vector_widen(hit->point), wide_vector_of(cylinder->foot));
    WideVector in_radii = wide_scale(arm, wide_of(1 / cylinder->radius));
    real facing = arm_along(vector_widen(hit->normal), axes[2]);
    mask on_base = facing < -half, on_end = on_base | (facing > half);
    // The front, opposite the first axis, is the middle of the picture.
    real front = -arm_along(in_radii, axes[0]), right = -arm_along(in_radii, axes[1]);
    real height = narrow(wide_dot(arm, wide_vector_of(axes[2])) * wide_of(1 / cylinder->length));
    real around = angle_in_turns(right, front) + half;
    real up = real_select(on_base, front, -front);
    return (TexturePlace){.u = real_select(on_end, half + half * right, around),
                          .v = real_select(on_end, half + half * up, height),
                          .around_u = mask_not(on_end),
                          .around_v = mask_of(false)};
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
    .is_blocking = cylinder_is_blocking,
    .bounds = cylinder_bounds,
    .texture_place = cylinder_texture_place,
};
