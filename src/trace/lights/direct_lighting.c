/**
 * @file
 * @brief Direct light: shadow rays, Lambert's law and Phong's highlight.
 */
#include "trace/lights/light.h"
#include "trace/lights/report_shadows.h"
#include "trace/lights/shadow_transmittance.h"
#include "trace/tracer/aov.h"
#include "trace/tracer/path_hash.h"
#include "trace/tracer/ray_tree_recorder.h"

/**
 * @return max(0, r . v)^shininess, Phong's highlight; r is the mirror image of the direction to the
 * light.
 * @param v  Which vector of points.
 * @param to_light  Unit directions to the light.
 */
INLINE real phong_specular(const SurfaceHit *surface, int v, Vec3 to_light, real cosine,
                           real shininess) {
    Vec3 reflected = vec3_subtract(vec3_scale(surface->n_front[v], 2 * cosine), to_light);
    real along = real_max(-vec3_dot(reflected, surface->packet->rays[v].direction), real_of(0));
    return real_pow(real_min(along, real_of(1)), shininess);
}

/**
 * @return The intensity of a light at points, behind transparent shapes, without the falloff.
 * @param v  Which vector of points.
 */
INLINE Rgb light_sample_intensity(const Light *light, const LightSample *sample, int v,
                                  const SurfaceHit *surface) {
    return surface->interior ? rgb_multiply(light->intensity, sample->transmittance[v])
                             : light->intensity;
}

/**
 * Adds the highlights of one light, where the materials have any.
 * @param v  Which vector of points.
 * @param unoccluded  The points that it reaches.
 * @param attenuation  The factor of its intensity there.
 */
INLINE void light_sample_add_specular(const Light *light, const LightSample *sample, int v,
                                      mask unoccluded, real attenuation, const SurfaceHit *surface,
                                      DirectLighting *lighting) {
    MaterialPack material =
        material_pack_gather(surface->materials, &surface->material_ids[v], unoccluded);
    mask shiny = unoccluded & (rgb_max(material.specular) > real_of(0));
    if (any(shiny)) {
        Vec3 to_light = light_sample_direction(sample, v);
        real bright = phong_specular(surface, v, to_light, sample->cosine[v], material.shininess);
        bright = real_select(shiny, attenuation * bright, real_of(0));
        lighting->specular[v] =
            rgb_add(lighting->specular[v],
                    rgb_scale(light_sample_intensity(light, sample, v, surface), bright));
    }
}

/**
 * Adds what one light gives to the points that it reaches.
 * @param occluded  The points that it does not reach.
 * @param has_specular  Whether to add highlights.
 */
INLINE void light_sample_add(const Light *light, const LightSample *sample, const mask *occluded,
                             bool has_specular, const SurfaceHit *surface,
                             DirectLighting *lighting) {
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        mask unoccluded = sample->shadow_rays.active[v] & mask_not(occluded[v]);
        if (!any(unoccluded)) {
            continue;
        }
        real attenuation = light_attenuation(light, sample->weight[v], sample->distance_squared[v]);
        real bright = real_select(unoccluded, attenuation * sample->cosine[v], real_of(0));
        lighting->diffuse[v] =
            rgb_add(lighting->diffuse[v],
                    rgb_scale(light_sample_intensity(light, sample, v, surface), bright));
        if (has_specular) {
            light_sample_add_specular(light, sample, v, unoccluded, attenuation, surface, lighting);
        }
    }
}

/** Sets all light to 0. @param has_specular Whether highlights are added later. */
INLINE void direct_lighting_clear(DirectLighting *lighting, int vector_count, bool has_specular) {
    const Rgb black = {real_of(0), real_of(0), real_of(0)};
    for (int v = 0; v < vector_count; v++) {
        lighting->diffuse[v] = black;
    }
    for (int v = 0; has_specular && v < vector_count; v++) {
        lighting->specular[v] = black;
    }
}

/**
 * Records the shadow rays to a light; for a ray tree, with what this light alone gives. It is not
 * inlined: pictures without recorders pay for one comparison only.
 * @param occluded  The points that the light does not reach.
 * @param has_specular  Whether to compute highlights.
 */
static __attribute__((noinline)) void light_sample_record(const ShapeSet *shapes,
                                                          const Light *lights, size_t light_index,
                                                          const LightSample *sample,
                                                          const mask *occluded, bool has_specular,
                                                          const SurfaceHit *surface) {
    const Recorders *recorders = surface->packet->context.recorders;
    if (recorders->path_hashes) {
        path_hash_add_shadows(surface, &sample->shadow_rays, occluded,
                              surface->interior ? sample->transmittance : NULL);
    }
    if (recorders->aovs) {
        aov_record_shadows(surface, light_index, &sample->shadow_rays, occluded);
    }
    if (recorders->ray_tree) {
        DirectLighting light_only;
        direct_lighting_clear(&light_only, packet_vector_count(surface->packet), true);
        light_sample_add(&lights[light_index], sample, occluded, has_specular, surface,
                         &light_only);
        ray_tree_record_shadow(shapes, surface, light_index, &lights[light_index], sample,
                               occluded[0], &light_only);
    }
}

/** @return The first shape that shadow rays start at. @param shapes All of the scene. */
INLINE const Shape *light_sample_first_shape(const ShapeSet *shapes, const SurfaceHit *surface,
                                             const LightSample *sample) {
    int v = 0;
    while (!any(sample->shadow_rays.active[v])) {
        v++;
    }
    int lane = mask_first(sample->shadow_rays.active[v]);
    return shapes->shapes[integer_at(&surface->hits[v].shape, lane)];
}

/** @return The shadow rays that may meet again the shape at which they start. @param shape A convex
 *          or flat one. @param v Which vector of points. */
INLINE mask light_sample_may_return(const Shape *shape, const SurfaceHit *surface,
                                    const LightSample *sample, int v) {
    mask leaves = sample->cosine[v] > LEAVING_SLACK;
    mask is_outside = vec3_dot(surface->n_front[v], surface->hits[v].normal) > 0;
    leaves &= shape->class->form == FORM_CONVEX ? is_outside : mask_of(true);
    return sample->shadow_rays.active[v] & mask_not(leaves);
}

/**
 * @return The shape that all shadow rays leave and none meets again; NULL: nobody knows of one.
 *         Engines of one lane test each ray. Only origins beyond the error bound of the hit are
 *         surely beside the surface; and a ray that a report's method extends beyond the light may
 *         return, if the light is nearer to the surface than that bound.
 * @param shapes  All shapes of the scene.
 * @param sample  The rays, at least one active; they start on the side of #SurfaceHit.n_front.
 */
static const Shape *light_sample_left_shape(const ShapeSet *shapes, const Light *light,
                                            const RayOffset *offset, const SurfaceHit *surface,
                                            const LightSample *sample) {
    if (LANES == 1 || offset->strategy != OFFSET_BOUND || light->methods) {
        return NULL;
    }
    const Shape *shape = light_sample_first_shape(shapes, surface, sample);
    bool all_leave = shape->class->form != FORM_ANY;
    for (int v = 0; v < packet_vector_count(&sample->shadow_rays) && all_leave; v++) {
        const mask active = sample->shadow_rays.active[v];
        mask is_elsewhere = mask_not(surface->hits[v].shape == integer_of(shape->index));
        all_leave = !any(active) || (!any(active & is_elsewhere) &&
                                     !any(light_sample_may_return(shape, surface, sample, v)));
    }
    return all_leave ? shape : NULL;
}

/** @return Whether surely no shape is in the way of rays to a point of a light. @param excluded See
 *  shape_set_may_meet(). @param[out] intervals Those of the rays; not in engines of one lane. */
INLINE bool light_sample_is_clear(const ShapeSet *shapes, const Shape *excluded,
                                  const LightSample *sample, PacketIntervals *intervals) {
    if (LANES == 1) {
        return false;
    }
    *intervals = packet_intervals_to_point(&sample->shadow_rays, sample->target);
    return !shape_set_may_meet(shapes, intervals, excluded);
}

/** Sets the transmittance of all shadow rays to 1. */
INLINE void light_sample_set_clear(LightSample *sample) {
    for (int v = 0; v < packet_vector_count(&sample->shadow_rays); v++) {
        sample->transmittance[v] = (Rgb){real_of(1), real_of(1), real_of(1)};
    }
}

/**
 * Finds the points that a light does not reach.
 * @param[in,out] sample  What it would give; the transmittance of transparent shapes is added.
 * @param[out] occluded  Those points.
 */
static void light_sample_trace(const ShapeSet *shapes, const Light *light, const RayOffset *offset,
                               const SurfaceHit *surface, LightSample *sample, mask *occluded) {
    const ShapeSet *opaque = surface->interior ? &surface->dielectrics->opaque : shapes;
    const ShapeSet *glass =
        surface->interior ? shadow_transmittance_shapes(surface->dielectrics, offset) : NULL;
    const Shape *excluded = light_sample_left_shape(shapes, light, offset, surface, sample);
    PacketIntervals intervals;
    bool has_intervals = sample->target && LANES > 1;
    bool is_clear = sample->target && light_sample_is_clear(opaque, excluded, sample, &intervals);
    bool may_meet_glass = glass && glass->count > 0 &&
                          !(has_intervals && !shape_set_may_meet(glass, &intervals, excluded));
    if (sample->target &&
        (!is_clear || may_meet_glass || light->methods || surface->packet->context.recorders)) {
        light_sample_aim(sample);
    }
    if (light->methods & METHOD_SHADOW_BY_SHAPE) {
        report_shadow_by_shape(shapes, surface, sample, occluded);
        return;
    }
    if (is_clear) {
        for (int v = 0; v < packet_vector_count(&sample->shadow_rays); v++) {
            occluded[v] = mask_of(false);
        }
    } else {
        shape_set_occluded(opaque, &sample->shadow_rays, has_intervals ? &intervals : NULL,
                           excluded, occluded);
    }
    if (surface->interior) {
        light_sample_set_clear(sample);
    }
    if (may_meet_glass) {
        shadow_transmittance_find(shapes, glass, offset, surface, &sample->shadow_rays, occluded,
                                  sample->transmittance);
    }
}

uint64_t shade_direct(const ShapeSet *shapes, const Light *lights, size_t light_count,
                      const RayOffset *offset, bool has_specular, const SurfaceHit *surface,
                      DirectLighting *lighting) {
    uint64_t rays = 0;
    const int vector_count = packet_vector_count(surface->packet);
    direct_lighting_clear(lighting, vector_count, has_specular);
    for (size_t i = 0; i < light_count; i++) {
        LightSample sample;
        mask occluded[PACKET_VECTORS];
        packet_init(&sample.shadow_rays, vector_count, false);
        sample.target = NULL;
        lights[i].sample(&lights[i], i, offset, surface, &sample);
        if (lights[i].methods & METHOD_SHADOW_BEYOND) {
            report_shadow_extend(&sample);
        }
        unsigned count = packet_active_count(&sample.shadow_rays);
        if (count > 0) {
            light_sample_trace(shapes, &lights[i], offset, surface, &sample, occluded);
            if (surface->packet->context.recorders) {
                light_sample_record(shapes, lights, i, &sample, occluded, has_specular, surface);
            }
            light_sample_add(&lights[i], &sample, occluded, has_specular, surface, lighting);
            rays += count;
        }
    }
    return rays;
}
