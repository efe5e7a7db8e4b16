/**
 * @file
 * @brief Rectangle lights: parallelograms of uniform radiance, such as panels and windows.
 *
 * A diffuse emitter of radiance L and area A sends the intensity L A cos b at the angle b from its
 * normal (pbrt's DiffuseAreaLight). With L = I / A, the light is far away that of a point light of
 * intensity I, times cos b. With inverse-square falloff a point gets
 *
 *     I / A * integral of cos(surface) cos(emitter) / d^2 over the area.
 *
 * Without falloff, 1 / d^2 is 1: the mean of point lights spread evenly over the rectangle. With
 * inverse-linear falloff it is 1 / (c + d) likewise.
 *
 * A sample is chosen in two steps: a row, then a point of the row. The rows have the density 1 /
 * (a + |s|)^2, and the point of a row 1 / (a^2 + s^2)^(3/2), which is exactly that of the solid
 * angle. So the weights stay bounded where the point is next to the light, and no sine, cosine or
 * arc tangent is needed as in Ureña, Fajardo, King, *An Area-Preserving Parametrization for
 * Spherical Rectangles*, 2013, whose solid angle cancels in float for lights that are far away.
 */
#include "scene/lights/rectangle_light.h"

#include "trace/lights/light.h"
#include "trace/lights/segment_sample.h"

/** Roundings of the coordinates, in half ulps, by which a shadow ray ends before the rectangle: a
 *  ceiling in the same plane is not in the way. */
#define RECTANGLE_END_ROUNDINGS 32

/** Least cosine at the emitter that this distance is divided by. */
#define RECTANGLE_END_MIN_COSINE ((scalar)0.0625f)

/** A rectangle light's own struct. */
typedef struct LIGHT_OWN RectangleLight {
    Vec3 corner;    /**< One corner. */
    Vec3 u_axis;    /**< Unit vector along u. */
    Vec3 v_axis;    /**< Unit vector along v. */
    Vec3 normal;    /**< Unit normal on the side of u x v. */
    Vec3 center;    /**< The middle. */
    real u_length;  /**< Length of u. */
    real v_length;  /**< Length of v. */
    real magnitude; /**< Largest coordinate, for rounding errors. */
    real two_sided; /**< 1 if it glows on both sides, else 0. */
} RectangleLight;

_Static_assert(sizeof(RectangleLight) <= LIGHT_OWN_VECTORS * sizeof(real),
               "a rectangle light must fit into a light");

/** @return Heights of points over the side that glows; of a light with two, over the nearer one. */
INLINE real rectangle_light_height(const RectangleLight *rectangle, Vec3 from_corner) {
    real height = vec3_dot(from_corner, rectangle->normal);
    return real_select(rectangle->two_sided > 0, real_abs(height), height);
}

/** @return How far before the rectangle shadow rays end. @param cosine At the emitter. */
INLINE real rectangle_light_end_margin(const RectangleLight *rectangle, const RayOffset *offset,
                                       const Hit *hit, real cosine) {
    real magnitude = rectangle->magnitude + vec3_max_abs(hit->point);
    real margin = RECTANGLE_END_ROUNDINGS * ROUNDOFF * magnitude + ray_offset_length(offset, hit);
    return margin / real_max(cosine, real_of(RECTANGLE_END_MIN_COSINE));
}

/** Samples the middle. See #LightSampler. */
static void rectangle_light_sample_center(const Light *light, size_t light_index,
                                          const RayOffset *offset, const SurfaceHit *surface,
                                          LightSample *sample) {
    (void)light_index;
    const RectangleLight *rectangle = light_own(light);
    light_sample_center(&rectangle->center, offset, surface, sample);
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        Vec3 from_corner = vec3_subtract(surface->hits[v].point, rectangle->corner);
        real distance = real_sqrt(sample->distance_squared[v]);
        real cosine = rectangle_light_height(rectangle, from_corner) / distance;
        real margin =
            rectangle_light_end_margin(rectangle, offset, &surface->hits[v], cosine) / distance;
        sample->weight[v] = cosine;
        sample->shadow_rays.active[v] &= cosine > 0;
        sample->shadow_rays.limit[v] = real_max(1 - margin, real_of(0));
    }
}

/** LANES points of a rectangle, as seen from other points. */
typedef struct RectanglePoint {
    Vec3 offset;     /**< From there to them. */
    real area_ratio; /**< The area over the inverse of their probability density. */
} RectanglePoint;

/** @return Points of a rectangle, uniform in area. @param to_corner Vector from the lit point. */
INLINE RectanglePoint rectangle_point_uniform(const RectangleLight *rectangle, Vec3 to_corner,
                                              real unit_u, real unit_v) {
    Vec3 along_u = vec3_scale(rectangle->u_axis, unit_u * rectangle->u_length);
    Vec3 along_v = vec3_scale(rectangle->v_axis, unit_v * rectangle->v_length);
    return (RectanglePoint){vec3_add(vec3_add(to_corner, along_u), along_v), real_of(1)};
}

/** @return Points of a rectangle, denser where they give more light.
 *  @param to_corner Vector from the lit point. @param height Height over the plane, at least 0. */
INLINE RectanglePoint rectangle_point_weighted(const RectangleLight *rectangle, Vec3 to_corner,
                                               real height, real unit_u, real unit_v) {
    // A row: along v.
    real u_begin = vec3_dot(to_corner, rectangle->u_axis);
    real u_gap = real_max(real_max(u_begin, -(u_begin + rectangle->u_length)), real_of(0));
    real v_begin = vec3_dot(to_corner, rectangle->v_axis);
    Segment rows = segment_of(v_begin, rectangle->v_length, height + u_gap);
    SegmentSample row = segment_sample_inverse_square(&rows, unit_v);
    Vec3 to_row = vec3_add(to_corner, vec3_scale(rectangle->v_axis, row.at - v_begin));
    // A point of it: along u.
    real begin = vec3_dot(to_row, rectangle->u_axis);
    Vec3 to_foot = vec3_subtract(to_row, vec3_scale(rectangle->u_axis, begin));
    Segment points = segment_of(begin, rectangle->u_length, real_sqrt(vec3_dot(to_foot, to_foot)));
    SegmentSample point = segment_sample_inverse_cube(&points, unit_u);
    return (RectanglePoint){vec3_add(to_foot, vec3_scale(rectangle->u_axis, point.at)),
                            row.density * rectangle->v_length *
                                (point.density * rectangle->u_length)};
}

/** Samples the area. See #LightSampler. */
static void rectangle_light_sample(const Light *light, size_t light_index, const RayOffset *offset,
                                   const SurfaceHit *surface, LightSample *sample) {
    const RectangleLight *rectangle = light_own(light);
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        const Hit *hit = &surface->hits[v];
        sample->shadow_rays.active[v] = surface->needs_light[v];
        if (!any(surface->needs_light[v])) {
            continue;
        }
        Vec3 to_corner = vec3_subtract(rectangle->corner, hit->point);
        real height = rectangle_light_height(rectangle, vec3_scale(to_corner, real_of(-1)));
        height = real_max(height, real_of(0));
        SquareSample square = light_square_sample(&surface->packet->context, light_index, v);
        const scalar half = (scalar)0.5f;
        real unit_u = half + half * square.a, unit_v = half + half * square.b;
        RectanglePoint point =
            light->is_inverse_square
                ? rectangle_point_weighted(rectangle, to_corner, height, unit_u, unit_v)
                : rectangle_point_uniform(rectangle, to_corner, unit_u, unit_v);
        real distance_squared =
            real_max(vec3_dot(point.offset, point.offset), real_of(MIN_DISTANCE_SQUARED));
        real distance = real_sqrt(distance_squared), cosine = height / distance;
        light_sample_set_point(offset, surface, v, vec3_scale(point.offset, 1 / distance),
                               distance -
                                   rectangle_light_end_margin(rectangle, offset, hit, cosine),
                               distance_squared, cosine / point.area_ratio, sample);
    }
}

/** Fills a rectangle light. See #LightClass.init. */
static void rectangle_light_init(Light *self, const SceneLight *said, int samples) {
    const RectangleLightFields *fields = scene_light_own(said);
    Vec3d corner = said->position, across = vec3d_add(fields->u, fields->v);
    Vec3d u_axis = vec3d_normalize(fields->u), v_axis = vec3d_normalize(fields->v);
    double u_length = vec3d_length(fields->u), v_length = vec3d_length(fields->v);
    Vec3d normal = vec3d_cross(u_axis, v_axis);
    double area = u_length * v_length * vec3d_length(normal);
    *(RectangleLight *)self->own = (RectangleLight){
        .corner = vec3_of(corner),
        .u_axis = vec3_of(u_axis),
        .v_axis = vec3_of(v_axis),
        .normal = vec3_of(vec3d_normalize(normal)),
        .center = vec3_of(vec3d_add(corner, vec3d_scale(across, 0.5))),
        .u_length = real_of((scalar)u_length),
        .v_length = real_of((scalar)v_length),
        .magnitude = real_of((scalar)(vec3d_max_abs(corner) + u_length + v_length)),
        .two_sided = real_of(fields->two_sided),
    };
    self->is_visible = true;
    self->is_soft = samples > 1;
    self->sample = self->is_soft ? rectangle_light_sample : rectangle_light_sample_center;
    // From its middle, no point gets more than next to the whole rectangle: pi I / A.
    light_set_min_distance_squared(self, self->is_soft ? 0 : (scalar)(area / M_PI));
}

/** Fills a quad. See #LightClass.emitter_init. */
static void rectangle_light_emitter_init(Shape *emitter, const SceneLight *said) {
    const RectangleLightFields *fields = scene_light_own(said);
    quad_class.init(emitter, &(QuadParameters){said->position, fields->u, fields->v});
}

/** @return The rays that come from a side that glows. See #LightClass.visible_from. */
static mask rectangle_light_visible_from(const Light *self, const Ray *ray) {
    const RectangleLight *rectangle = light_own(self);
    return (vec3_dot(ray->direction, rectangle->normal) < 0) | (rectangle->two_sided > 0);
}

/** The class of `rectangle_light`. */
extern const LightClass rectangle_light_class;

const LightClass rectangle_light_class = {
    .init = rectangle_light_init,
    .emitter = &quad_class,
    .emitter_init = rectangle_light_emitter_init,
    .visible_from = rectangle_light_visible_from,
};
