/**
 * @file
 * @brief Generation of reflected and refracted rays.
 */
#include "trace/tracer/secondary_rays.h"

#include "trace/tracer/tracer.h"

/** Sets what all secondary rays of a packet have in common. @param interior The shapes that they
 *  are inside of. */
INLINE void secondary_rays_init(SecondaryRays *secondary, RayType type, const Packet *parent,
                                const InteriorList *interior) {
    secondary->type = type;
    secondary->rays.interior = interior;
    secondary->rays.packet.wants_points = true;
    secondary->rays.packet.context = parent->context;
    secondary->rays.packet.context.bounce++;
}

/**
 * Sets the weights of a vector of rays, and ends the rays that cannot change the image.
 * @param weight  Their weights at the surface.
 * @param throughput  The throughput of the rays that hit the surface.
 * @return Whether any ray is left.
 */
INLINE bool secondary_rays_set_weight(const Tracer *tracer, int v, mask lanes, Rgb weight,
                                      real throughput, SecondaryRays *secondary) {
    RayState *rays = &secondary->rays;
    secondary->weights[v] = weight;
    rays->throughput[v] = throughput * rgb_max(weight);
    rays->packet.active[v] = lanes & (rays->throughput[v] >= tracer->cutoff);
    return any(rays->packet.active[v]);
}

/** Sets a vector of rays. */
INLINE void secondary_rays_set(SecondaryRays *secondary, int v, Vec3 origin, Vec3 direction) {
    secondary->rays.packet.rays[v] = ray_of(origin, direction);
    secondary->rays.packet.limit[v] = real_of(INFINITE);
}

void reflect_rays(const Tracer *tracer, const RayState *rays, const SurfaceHit *surface,
                  SecondaryRays *reflected) {
    secondary_rays_init(reflected, RAY_REFLECTION, &rays->packet, rays->interior);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask lanes = surface->is_hit[v];
        MaterialPack material =
            material_pack_gather(surface->materials, &surface->material_ids[v], lanes);
        Rgb weight = surface_reflectance(surface, v, &material);
        if (!secondary_rays_set_weight(tracer, v, lanes, weight, rays->throughput[v], reflected)) {
            continue;
        }
        Vec3 d = rays->packet.rays[v].direction, n = surface->n_front[v];
        // Normalized at each bounce: otherwise the length drifts by an ulp or two per reflection.
        Vec3 r = vec3_normalize(vec3_subtract(d, vec3_scale(n, 2 * vec3_dot(d, n))));
        secondary_rays_set(reflected, v,
                           surface_reflection_origin(&tracer->ray_offset, surface, v, r), r);
    }
}

void refract_rays(const Tracer *tracer, const RayState *rays, const SurfaceHit *surface,
                  SecondaryRays *refracted) {
    const DielectricHit *dielectric = surface->dielectric;
    secondary_rays_init(refracted, RAY_REFRACTION, &rays->packet, dielectric->interior_behind);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        MaterialPack material =
            material_pack_gather(surface->materials, &surface->material_ids[v], surface->is_hit[v]);
        Rgb weight = surface_transmittance(surface, v, &material);
        if (secondary_rays_set_weight(tracer, v, dielectric->is_transmitted[v], weight,
                                      rays->throughput[v], refracted)) {
            secondary_rays_set(refracted, v, dielectric->origin[v], dielectric->direction[v]);
        }
    }
}

void secondary_rays_add(const SecondaryRays *secondary, const Rgb *incoming, Rgb *colors) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Rgb sum = rgb_add(colors[v], rgb_multiply(secondary->weights[v], incoming[v]));
        colors[v] = rgb_select(secondary->rays.packet.active[v], sum, colors[v]);
    }
}
