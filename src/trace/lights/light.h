/**
 * @file
 * @brief Lamps and suns in the engine's number type: how they are aimed at, and what reaches a
 * point.
 */
#ifndef DIOPTRE_TRACE_LIGHTS_LIGHT_H
#define DIOPTRE_TRACE_LIGHTS_LIGHT_H

#include "trace/lights/direct_lighting.h"

/**
 * A light in the engine's number type. Only this class knows a sun from a lamp: it is one
 * infinitely far away.
 */
struct Light {
    Vec3 position; /**< Where it is; of a sun: the unit direction towards it. */
    Rgb intensity; /**< Its colour times its intensity. */
    bool is_sun;   /**< Whether it is infinitely far away. */
    scalar radius; /**< Of its ball; 0: a point. */
    scalar
        min_distance_squared; /**< It shines no more strongly than from this distance, squared. */
    bool is_inverse_square;   /**< Whether it weakens with the distance. */
    bool is_soft;             /**< Whether each ray goes to another point of its ball. */
};

/** What one lamp would give to the points of a packet, were nothing in the way. */
typedef struct LightSample {
    Packet shadow_rays;                    /**< The rays to the lamp; active where it may shine. */
    real cosine[PACKET_VECTORS];           /**< n . l, above 0 where active. */
    real distance_squared[PACKET_VECTORS]; /**< To it, squared. */
    real weight[PACKET_VECTORS];           /**< Of the ray among all to a soft lamp's ball. */
    Rgb transmittance[PACKET_VECTORS];     /**< The share that glass leaves, if there is any. */
} LightSample;

/**
 * @return A light in the engine's number type.
 * @param samples  Rays a pixel: with one, a ball shines from its centre.
 */
Light light_of(const SceneLight *light, int samples);

/** @return A light's colour times its intensity. */
Rgbs scene_light_rgb(const SceneLight *light);

/**
 * Aims shadow rays at a lamp, from the points that it could light: a surface turned away from the
 * lamp stands in its own light. This is the one place that knows how any kind of light is aimed at.
 * @param light_index  Which of the scene's lamps it is.
 * @param offset  Where the rays start.
 * @param[out] sample  What the lamp would give.
 */
void light_sample_packet(const Light *light, size_t light_index, const RayOffset *offset,
                         const SurfaceHit *surface, LightSample *sample);

/** @return The way from points to a lamp; a unit vector to a sun. */
INLINE Vec3 light_offset(const Light *light, Vec3 point) {
    return light->is_sun ? light->position : vec3_subtract(light->position, point);
}

/**
 * @return Unit directions to a lamp, those of its shadow rays.
 * @param v  Which vector of points.
 */
INLINE Vec3 light_direction(const Light *light, const LightSample *sample, int v, Vec3 point) {
    if (light->is_soft) {
        return sample->shadow_rays.rays[v].direction;
    }
    return vec3_scale(light_offset(light, point), 1 / real_sqrt(sample->distance_squared[v]));
}

/**
 * @return What is left of a lamp's light at points.
 * @param v  Which vector of points.
 */
INLINE real light_attenuation(const Light *light, const LightSample *sample, int v) {
    real attenuation = light->is_soft ? sample->weight[v] : real_of(1);
    if (light->is_inverse_square) {
        attenuation = attenuation /
                      real_max(sample->distance_squared[v], real_of(light->min_distance_squared));
    }
    return attenuation;
}

#endif
