/**
 * @file
 * @brief Shadows as the reports find them.
 */
#include "trace/lights/report_shadows.h"

__attribute__((noinline)) void report_shadow_extend(LightSample *sample) {
    for (int v = 0; v < packet_vector_count(&sample->shadow_rays); v++) {
        sample->shadow_rays.limit[v] = real_of(INFINITE);
    }
}

__attribute__((noinline)) void report_shadow_by_shape(const ShapeSet *shapes,
                                                      const SurfaceHit *surface,
                                                      LightSample *sample, mask *occluded) {
    Packet rays = sample->shadow_rays;
    Hit hits[PACKET_VECTORS];
    for (int v = 0; v < packet_vector_count(&rays); v++) {
        Vec3 point = surface->hits[v].point, to_light = light_sample_direction(sample, v);
        real distance = real_sqrt(sample->distance_squared[v]);
        Vec3 origin = vec3_add(point, vec3_scale(to_light, distance));
        rays.rays[v] = ray_of(origin, vec3_scale(to_light, real_of(-1)));
        rays.limit[v] = real_of(INFINITE);
        sample->transmittance[v] = (Rgb){real_of(1), real_of(1), real_of(1)};
    }
    shape_set_closest_hits(shapes, &rays, hits);
    for (int v = 0; v < packet_vector_count(&rays); v++) {
        occluded[v] = mask_not(hits[v].shape == surface->hits[v].shape);
    }
}
