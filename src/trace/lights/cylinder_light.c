/**
 * @file
 * @brief Cylinder lights: tubes whose wall has uniform radiance, such as neon lights.
 *
 * The wall, of radius r and length H, has the projected area 2 r H from the side. Its radiance is
 * L = I / (2 r H). Far away, it equals a point light of intensity I, times the sine of the angle to
 * the axis. The ends are visible, but give no light.
 *
 * Seen along the axis, a point at the distance D sees the wall within the angles ±b, sin b = r / D.
 * A sample is chosen in two steps: an angle by the tangent of its half, which is uniform, then a
 * point of the line where that half-plane first meets the wall. With the distance a of that line
 * and the position s on it, counted from the foot of the point, the wall's light is
 *
 *     cos(emitter) dA / d^2 = a^2 / (a^2 + s^2)^(3/2) ds d(angle),
 *
 * and samples of the line have exactly this density. So a sample's weight depends on the angle
 * alone, and hardly.
 */
#include "scene/lights/cylinder_light.h"

#include "trace/lights/light.h"
#include "trace/lights/segment_sample.h"

/** Points nearer to the wall than this, in radii, are lit as from there. */
#define CYLINDER_LIGHT_MIN_HEIGHT ((scalar)0x1p-20f)

/** Roundings of the coordinates, in half ulps, by which a shadow ray ends before the wall. */
#define CYLINDER_LIGHT_END_ROUNDINGS 32

/** A cylinder light's own struct. */
typedef struct LIGHT_OWN CylinderLight {
    Vec3 base;      /**< Centre of one end. */
    Vec3 axis;      /**< Unit vector to the other. */
    Vec3 across;    /**< A unit vector at right angles to it. */
    Vec3 center;    /**< The middle of the axis. */
    real length;    /**< From end to end. */
    real radius;    /**< The wall's radius. */
    real magnitude; /**< Largest coordinate, for rounding errors. */
} CylinderLight;

_Static_assert(sizeof(CylinderLight) <= LIGHT_OWN_VECTORS * sizeof(real),
               "a cylinder light must fit into a light");

/** LANES points as a cylinder sees them. */
typedef struct CylinderView {
    real begin;    /**< From the point's foot on the axis to the base, along the axis. */
    real distance; /**< From the axis. */
    Vec3 to_axis;  /**< Unit vectors straight to the axis. */
} CylinderView;

/** @return How a cylinder sees a point. */
INLINE CylinderView cylinder_view_of(const CylinderLight *cylinder, Vec3 point) {
    Vec3 to_base = vec3_subtract(cylinder->base, point);
    real begin = vec3_dot(to_base, cylinder->axis);
    Vec3 to_axis = vec3_subtract(to_base, vec3_scale(cylinder->axis, begin));
    real distance = real_sqrt(vec3_dot(to_axis, to_axis));
    mask is_beside = distance > (scalar)LENGTH_MINIMUM;
    return (CylinderView){
        begin, distance,
        vec3_select(is_beside, vec3_scale(to_axis, 1 / distance), cylinder->across)};
}

/** @return How far before the wall shadow rays end. */
INLINE real cylinder_light_end_margin(const CylinderLight *cylinder, const RayOffset *offset,
                                      const Hit *hit) {
    real magnitude = cylinder->magnitude + vec3_max_abs(hit->point);
    return CYLINDER_LIGHT_END_ROUNDINGS * ROUNDOFF * magnitude + ray_offset_length(offset, hit);
}

/** Samples the middle of the axis. The rays end at the wall or at an end. See #LightSampler. */
static void cylinder_light_sample_center(const Light *light, size_t light_index,
                                         const RayOffset *offset, const SurfaceHit *surface,
                                         LightSample *sample) {
    (void)light_index;
    const CylinderLight *cylinder = light_own(light);
    const scalar half = (scalar)0.5f;
    light_sample_center(&cylinder->center, offset, surface, sample);
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        const Hit *hit = &surface->hits[v];
        CylinderView view = cylinder_view_of(cylinder, hit->point);
        real distance = real_sqrt(sample->distance_squared[v]),
             half_length = half * cylinder->length;
        real height = real_abs(view.begin + half_length);
        real wall_end = 1 - cylinder->radius / real_max(view.distance, cylinder->radius);
        real cap_end = 1 - half_length / real_max(height, half_length);
        real margin = cylinder_light_end_margin(cylinder, offset, hit) / distance;
        sample->weight[v] = view.distance / distance;
        sample->shadow_rays.limit[v] = real_max(real_max(wall_end, cap_end) - margin, real_of(0));
    }
}

/** LANES lines of the wall, parallel to the axis, as points see them. */
typedef struct CylinderLine {
    Vec3 to_line; /**< Straight to the line, scene units. */
    real near;    /**< Length of #to_line. */
    real measure; /**< Width of the visible wall per line of equal chance, in radii. */
} CylinderLine;

/** Samples a line of the visible wall. @param unit Numbers in [-1, 1): they choose the line. */
INLINE CylinderLine cylinder_light_sample_line(const CylinderLight *cylinder,
                                               const CylinderView *view, real unit) {
    real radius = cylinder->radius, outside = real_max(view->distance, radius);
    real sine_max = radius / outside;
    real tangent_max = sine_max / (1 + real_sqrt((1 - sine_max) * (1 + sine_max)));
    // An angle, by the tangent of its half.
    real tangent = tangent_max * unit, per_square = 1 / (1 + tangent * tangent);
    real sine = 2 * tangent * per_square;
    real cosine = (1 - tangent) * (1 + tangent) * per_square;
    // The line of the wall there: the nearer root, by the product of the two.
    real beside = outside * sine;
    real half_chord = real_sqrt(real_max((radius - beside) * (radius + beside), real_of(0)));
    real far_root = real_max(outside * cosine + half_chord, radius * CYLINDER_LIGHT_MIN_HEIGHT);
    real near = (outside - radius) * ((outside + radius) / far_root);
    near = real_max(near, radius * CYLINDER_LIGHT_MIN_HEIGHT);
    Vec3 e = view->to_axis, axis = cylinder->axis;
    Vec3 side = {axis.y * e.z - axis.z * e.y, axis.z * e.x - axis.x * e.z,
                 axis.x * e.y - axis.y * e.x};
    Vec3 direction = vec3_add(vec3_scale(e, cosine), vec3_scale(side, sine));
    return (CylinderLine){vec3_scale(direction, near), near, 2 * tangent_max * per_square};
}

/** Samples the visible part of the wall. See #LightSampler. */
static void cylinder_light_sample(const Light *light, size_t light_index, const RayOffset *offset,
                                  const SurfaceHit *surface, LightSample *sample) {
    const CylinderLight *cylinder = light_own(light);
    real radius = cylinder->radius, length = cylinder->length;
    const scalar half = (scalar)0.5f;
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        const Hit *hit = &surface->hits[v];
        sample->shadow_rays.active[v] = surface->needs_light[v];
        if (!any(surface->needs_light[v])) {
            continue;
        }
        CylinderView view = cylinder_view_of(cylinder, hit->point);
        SquareSample square = light_square_sample(&surface->packet->context, light_index, v);
        // Points inside are lit as on the wall; beyond the ends, over a cap, nothing is seen of it.
        mask is_over_cap =
            (view.distance <= radius) & ((view.begin > 0) | (view.begin + length < 0));
        CylinderLine line = cylinder_light_sample_line(cylinder, &view, square.a);
        Segment segment = segment_of(view.begin, length, line.near);
        real unit = half + half * square.b;
        SegmentSample point = light->is_inverse_square ? segment_sample_inverse_cube(&segment, unit)
                                                       : segment_sample_uniform(&segment, unit);
        Vec3 to_point = vec3_add(line.to_line, vec3_scale(cylinder->axis, point.at));
        real distance_squared = line.near * line.near + point.at * point.at;
        real distance = real_sqrt(distance_squared);
        real weight =
            line.near / distance * (line.near / radius) * line.measure / (length * point.density);
        light_sample_set_point(offset, surface, v, vec3_scale(to_point, 1 / distance),
                               distance - cylinder_light_end_margin(cylinder, offset, hit),
                               distance_squared, real_select(is_over_cap, real_of(0), weight),
                               sample);
    }
}

/** @return A unit vector at right angles to another. */
static Vec3d perpendicular_to(Vec3d axis) {
    Vec3d other = fabs(axis.x) < 0.5 ? (Vec3d){1, 0, 0} : (Vec3d){0, 1, 0};
    return vec3d_normalize(vec3d_cross(axis, other));
}

/** Fills a cylinder light. See #LightClass.init. */
static void cylinder_light_init(Light *self, const SceneLight *said, int samples) {
    const CylinderLightFields *fields = scene_light_own(said);
    Vec3d base = said->position, to_top = vec3d_subtract(fields->top, base);
    Vec3d axis = vec3d_normalize(to_top);
    double length = vec3d_length(to_top), radius = said->radius;
    *(CylinderLight *)self->own = (CylinderLight){
        .base = vec3_of(base),
        .axis = vec3_of(axis),
        .across = vec3_of(perpendicular_to(axis)),
        .center = vec3_of(vec3d_add(base, vec3d_scale(to_top, 0.5))),
        .length = real_of((scalar)length),
        .radius = real_of((scalar)radius),
        .magnitude = real_of((scalar)(vec3d_max_abs(base) + length + radius)),
    };
    self->is_visible = true;
    self->is_soft = samples > 1;
    self->sample = self->is_soft ? cylinder_light_sample : cylinder_light_sample_center;
    // From its middle, no point gets more than next to the whole wall: pi I / (2 r H).
    double area = 2 * radius * length;
    light_set_min_distance_squared(self, self->is_soft ? 0 : (scalar)(area / M_PI));
}

/** Fills a cylinder. See #LightClass.emitter_init. */
static void cylinder_light_emitter_init(Shape *emitter, const SceneLight *said) {
    const CylinderLightFields *fields = scene_light_own(said);
    cylinder_class.init(
        emitter, &(CylinderParameters){said->position, fields->top, said->radius, .capped = true});
}

/** The class of `cylinder_light`. */
extern const LightClass cylinder_light_class;

const LightClass cylinder_light_class = {.init = cylinder_light_init,
                                         .emitter = &cylinder_class,
                                         .emitter_init = cylinder_light_emitter_init};
