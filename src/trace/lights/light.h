/**
 * @file
 * @brief Lights in the engine's number type: the abstract class and its vtable.
 *
 * doc/design.md describes how to add a kind of light.
 */
#ifndef DIOPTRE_TRACE_LIGHTS_LIGHT_H
#define DIOPTRE_TRACE_LIGHTS_LIGHT_H

#include "trace/lights/direct_lighting.h"
#include "trace/tracer/ray_offset.h"

/** Squared distances below this, the square of the scene's smallest length, count as this. */
#define MIN_DISTANCE_SQUARED ((scalar)(LENGTH_MINIMUM * LENGTH_MINIMUM))

/** Least cosine between a normal and a ray that surely leaves: more than its roundings, which
 *  decide on which side of a surface a light in its plane is. */
#define LEAVING_SLACK (64 * ROUNDOFF)

/**
 * What one light would give to the points of a packet, if nothing were in the way. For each active
 * ray it gives intensity * weight * cosine, divided by #distance_squared or by a constant plus its
 * root if it falls off.
 */
typedef struct LightSample {
    Packet shadow_rays; /**< Rays to the light; active where it may shine. */
    const Vec3 *target; /**< The point of the light at which all rays end; not owned. Only their
                             origins are set then, until light_sample_aim(): most rays are never
                             traced. NULL: there is none. */
    real cosine[PACKET_VECTORS];           /**< n . l, above 0 where active. */
    real distance_squared[PACKET_VECTORS]; /**< Scene units squared, for the falloff. */
    real weight[PACKET_VECTORS];           /**< See above; 1 for a point. */
    Vec3 to_light[PACKET_VECTORS];         /**< To the light, of any length. */
    real to_light_squared[PACKET_VECTORS]; /**< The square of that length. */
    Rgb transmittance[PACKET_VECTORS];     /**< What transparent shapes leave, if there are any. */
} LightSample;

/**
 * Samples a light: aims one shadow ray per point. Surfaces that face away get no ray.
 * @param light_index  Index of the light in the scene; it selects the sequence of samples.
 * @param offset  How rays leave surfaces.
 * @param surface  The points.
 * @param[out] sample  What the light would give; the transmittance is not set.
 */
typedef void LightSampler(const Light *light, size_t light_index, const RayOffset *offset,
                          const SurfaceHit *surface, LightSample *sample);

/** A class of lights, as the tracer sees it: the vtable. */
typedef struct LightClass {
    /** Fills a light. Colour, falloff and #Light.min_distance_squared are already set.
     *  @param samples Rays per pixel: with one, a light with an area shines from its middle. */
    void (*init)(Light *self, const SceneLight *said, int samples);

    const ShapeClass *emitter; /**< The shape as which rays see the light. NULL: never seen. */

    /** Fills a shape of the class #emitter, whose base is already filled. */
    void (*emitter_init)(Shape *emitter, const SceneLight *said);

    /** @return The lanes whose rays could see the light. NULL: all. */
    mask (*visible_from)(const Light *self, const Ray *ray);
} LightClass;

/** Vectors that a class may store in a light. */
enum { LIGHT_OWN_VECTORS = 24 };

/** A light in the engine's number type. */
struct Light {
    const LightClass *class;     /**< Its class. */
    LightSampler *sample;        /**< How it is sampled; set by #LightClass.init. */
    Rgb intensity;               /**< Colour times intensity. */
    scalar min_distance_squared; /**< Falloff ends here, scene units squared. */
    bool is_inverse_square;      /**< Whether its light decreases with the distance's square. */
    bool is_inverse_linear;      /**< Whether with the distance plus #falloff_constant. */
    scalar falloff_constant;     /**< Scene units. */
    bool is_visible;             /**< Whether rays see it. */
    bool is_soft;                /**< Whether each shadow ray goes to another point of it. */
    bool is_at_infinity;         /**< Whether its light is parallel. */
    bool is_point;               /**< Whether it shines from #position to all sides alike. */
    Vec3 position;               /**< Of a point. */
    unsigned methods; /**< Methods of the reports for its shadows: a set of #ReportMethod. */
    Rgb radiance;     /**< As bright as rays see it: #intensity, unless a report's. */
    real own[LIGHT_OWN_VECTORS]; /**< The class's own struct; see #light_own. */
};

/** Marks the struct of a class that lies in #Light.own. */
#define LIGHT_OWN __attribute__((may_alias))

/** @return A class's own struct in a light of that class. */
static inline const void *light_own(const Light *light) {
    return light->own;
}

/**
 * @return A light in the engine's number type.
 * @param light    The light, in the tracer's coordinates.
 * @param samples  Rays per pixel.
 */
Light light_of(const SceneLight *light, int samples);

/** @return The class of a light of the scene. */
const LightClass *light_class_of(const SceneLight *light);

/** Lets the falloff of a light end at a distance. @param squared Scene units squared. */
void light_set_min_distance_squared(Light *light, scalar squared);

/** A point of a square, -1 to 1 (exclusive) in both coordinates. */
typedef struct SquareSample {
    real a; /**< Across. */
    real b; /**< Up. */
} SquareSample;

/**
 * @return Points of the square for one vector of a packet's rays: for all pixels the same point of
 *         the Sobol sequence, moved per pixel by an exclusive or, which keeps its stratification.
 * @param light_index  Index of the light in the scene.
 * @param v  Which vector of rays.
 */
SquareSample light_square_sample(const SampleContext *context, size_t light_index, int v);

/** @return The square of the distance to a light, as its falloff counts it. */
INLINE real light_distance_squared(Vec3 to_light) {
    return real_max(vec3_dot(to_light, to_light), real_of(MIN_DISTANCE_SQUARED));
}

/**
 * Sets what points could get from a light along one ray each.
 * @param v  Which vector of points.
 * @param to_light  From them to the light.
 */
INLINE void light_sample_set(const SurfaceHit *surface, int v, Vec3 to_light, LightSample *sample) {
    real distance_squared = light_distance_squared(to_light);
    real cosine = vec3_dot(surface->n_front[v], to_light) / real_sqrt(distance_squared);
    sample->shadow_rays.active[v] = surface->needs_light[v] & (cosine > 0);
    sample->cosine[v] = cosine;
    sample->weight[v] = real_of(1);
    sample->to_light[v] = to_light;
    sample->distance_squared[v] = sample->to_light_squared[v] = distance_squared;
}

/** Samples the middle of a light. See #LightSampler. @param center The middle; it outlives the
 *  sample. */
INLINE void light_sample_center(const Vec3 *center, const RayOffset *offset,
                                const SurfaceHit *surface, LightSample *sample) {
    sample->target = center;
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        const Hit *hit = &surface->hits[v];
        if (!any(surface->needs_light[v])) {
            sample->shadow_rays.active[v] = mask_of(false);
            sample->shadow_rays.limit[v] = sample->distance_squared[v] = real_of(1);
            continue;
        }
        Vec3 to_light = vec3_subtract(*center, hit->point);
        light_sample_set(surface, v, to_light, sample);
        sample->shadow_rays.rays[v].origin = ray_offset_origin(offset, hit, to_light);
        // The ray ends at the light itself: its parameter runs from 0 to 1.
        sample->shadow_rays.limit[v] = real_of(1);
    }
}

/** Directs rays to #LightSample.target. */
INLINE void light_sample_aim(LightSample *sample) {
    for (int v = 0; v < packet_vector_count(&sample->shadow_rays); v++) {
        Ray *ray = &sample->shadow_rays.rays[v];
        if (any(sample->shadow_rays.active[v])) {
            *ray = ray_of(ray->origin, vec3_subtract(*sample->target, ray->origin));
        }
    }
}

/**
 * Sets one shadow ray per point of a vector, to one point of a light each.
 * @param v  Which vector of points.
 * @param direction  Unit directions to the light.
 * @param end  Distances at which the rays end.
 * @param distance_squared  For the falloff.
 * @param weight  See #LightSample; rays of weight 0 are not traced.
 */
INLINE void light_sample_set_point(const RayOffset *offset, const SurfaceHit *surface, int v,
                                   Vec3 direction, real end, real distance_squared, real weight,
                                   LightSample *sample) {
    const Hit *hit = &surface->hits[v];
    sample->shadow_rays.rays[v] = ray_of(ray_offset_origin(offset, hit, direction), direction);
    sample->shadow_rays.limit[v] = real_max(end, real_of(0));
    sample->cosine[v] = vec3_dot(surface->n_front[v], direction);
    sample->shadow_rays.active[v] =
        surface->needs_light[v] & (sample->cosine[v] > 0) & (weight > 0);
    sample->distance_squared[v] = distance_squared;
    sample->weight[v] = weight;
    sample->to_light[v] = direction;
    sample->to_light_squared[v] = real_of(1);
}

/**
 * @return Unit directions to a light, those of its shadow rays.
 * @param v  Which vector of points.
 */
INLINE Vec3 light_sample_direction(const LightSample *sample, int v) {
    return vec3_scale(sample->to_light[v], 1 / real_sqrt(sample->to_light_squared[v]));
}

/** @return The factor of a light's intensity at points, without the cosine. @param weight,
 *  distance_squared See #LightSample. */
INLINE real light_attenuation(const Light *light, real weight, real distance_squared) {
    real squared = real_max(distance_squared, real_of(light->min_distance_squared));
    return light->is_inverse_square   ? weight / squared
           : light->is_inverse_linear ? weight / (light->falloff_constant + real_sqrt(squared))
                                      : weight;
}

#endif
