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
    packet_init(&secondary->rays.packet, packet_vector_count(parent), true);
    secondary->rays.packet.context = parent->context;
    secondary->rays.packet.context.bounce++;
    secondary->rays.packet.context.type = type;
}

/** Adds a loss. @param lanes The lanes that lose it. */
INLINE void losses_add_lanes(mask lanes, Rgb lost, Rgb *sum) {
    const Rgb nothing = {real_of(0), real_of(0), real_of(0)};
    *sum = rgb_add(*sum, rgb_select(lanes, lost, nothing));
}

/**
 * Sets the weights of a vector of rays, and ends those that weigh too little or are too deep.
 * @param weight  Their weights at the surface.
 * @param throughput  The throughput of the rays that hit the surface.
 * @param[in,out] losses  The throughputs of the rays that end are added to this.
 * @return Whether any ray is left.
 */
INLINE bool secondary_rays_set_weight(const TraceContext *context, int v, mask lanes, Rgb weight,
                                      Rgb throughput, SecondaryRays *secondary, Losses *losses) {
    RayState *rays = &secondary->rays;
    bool is_too_deep = rays->packet.context.bounce > (uint32_t)DEPTH_MAXIMUM;
    secondary->weights[v] = weight;
    rays->throughput[v] = rgb_multiply(throughput, weight);
    mask is_heavy = rgb_max(rays->throughput[v]) >= (is_too_deep ? INFINITE : context->cutoff);
    Rgb *lost = is_too_deep ? losses->guarded : losses->dropped;
    rays->packet.active[v] = lanes & is_heavy;
    losses_add_lanes(lanes & mask_not(is_heavy), rays->throughput[v], &lost[v]);
    return any(rays->packet.active[v]);
}

/** Sets a vector of rays. */
INLINE void secondary_rays_set(SecondaryRays *secondary, int v, Vec3 origin, Vec3 direction) {
    secondary->rays.packet.rays[v] = ray_of(origin, direction);
    secondary->rays.packet.limit[v] = real_of(INFINITE);
}

void reflect_rays(const TraceContext *context, const RayState *rays, const SurfaceHit *surface,
                  SecondaryRays *reflected, Losses *losses) {
    secondary_rays_init(reflected, RAY_REFLECTION, &rays->packet, rays->interior);
    for (int v = 0; v < packet_vector_count(&rays->packet); v++) {
        mask lanes = surface->may_turn[v];
        MaterialPack material =
            material_pack_gather(surface->materials, &surface->material_ids[v], lanes);
        Rgb weight = surface_reflectance(surface, v, &material);
        reflected->rays.turns[v] = rays->turns[v] + 1;
        if (!secondary_rays_set_weight(context, v, lanes, weight, rays->throughput[v], reflected,
                                       losses)) {
            continue;
        }
        Vec3 d = rays->packet.rays[v].direction, n = surface->n_front[v];
        // Normalized at each bounce: otherwise the length drifts by an ulp or two per reflection.
        Vec3 r = vec3_normalize(vec3_subtract(d, vec3_scale(n, 2 * vec3_dot(d, n))));
        Vec3 origin = surface_reflection_origin(&context->tracer->ray_offset, surface, v, r);
        secondary_rays_set(reflected, v, origin, r);
    }
}

void refract_rays(const TraceContext *context, const RayState *rays, const SurfaceHit *surface,
                  SecondaryRays *refracted, Losses *losses) {
    const DielectricHit *dielectric = surface->dielectric;
    secondary_rays_init(refracted, RAY_REFRACTION, &rays->packet, dielectric->interior_behind);
    for (int v = 0; v < packet_vector_count(&rays->packet); v++) {
        MaterialPack material =
            material_pack_gather(surface->materials, &surface->material_ids[v], surface->is_hit[v]);
        Rgb weight = surface_transmittance(surface, v, &material);
        mask is_overridden = dielectric->is_overridden[v];
        mask lanes = dielectric->is_transmitted[v] & (surface->may_turn[v] | is_overridden);
        refracted->rays.turns[v] =
            integer_select(is_overridden, rays->turns[v], rays->turns[v] + 1);
        if (secondary_rays_set_weight(context, v, lanes, weight, rays->throughput[v], refracted,
                                      losses)) {
            secondary_rays_set(refracted, v, dielectric->origin[v], dielectric->direction[v]);
        }
    }
}

void losses_add(const Packet *packet, const Losses *incoming, Losses *losses) {
    for (int v = 0; v < packet_vector_count(packet); v++) {
        mask lanes = packet->active[v];
        losses_add_lanes(lanes, incoming->dropped[v], &losses->dropped[v]);
        losses_add_lanes(lanes, incoming->guarded[v], &losses->guarded[v]);
        losses->rays[v] += real_select(lanes, incoming->rays[v] + 1, real_of(0));
    }
}

void secondary_rays_add(const SecondaryRays *secondary, const Rgb *incoming, Rgb *colors) {
    for (int v = 0; v < packet_vector_count(&secondary->rays.packet); v++) {
        Rgb sum = rgb_add(colors[v], rgb_multiply(secondary->weights[v], incoming[v]));
        colors[v] = rgb_select(secondary->rays.packet.active[v], sum, colors[v]);
    }
}
