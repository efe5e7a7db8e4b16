/**
 * @file
 * @brief Light through transparent shapes.
 */
#include "trace/lights/shadow_transmittance.h"

/** Most surfaces that a lamp's light crosses; behind more it is dark. A guard: rays that start at
 *  the very surface that they leave (`--offset none`) would meet it for ever. */
enum { MAX_SHADOW_SURFACES = 256 };

/** Moves rays on behind a surface. The way that is left gets shorter by as much. @param lanes The
 *  rays that go on. */
INLINE void shadow_rays_advance(const RayOffset *offset, const Hit *hit, mask lanes, int v,
                                Packet *rays) {
    Vec3 direction = rays->rays[v].direction;
    real along = vec3_dot(direction, hit->normal), cosine = real_abs(along);
    real side = real_select(along < 0, real_of(-1), real_of(1));
    real offset_length = ray_offset_length(offset, hit);
    real t =
        ray_offset_transmitted_t(offset_length, cosine, real_sqrt(vec3_dot(direction, direction)));
    Vec3 n_behind = vec3_scale(hit->normal, side);
    Vec3 origin = ray_offset_transmitted_origin(hit, offset_length, n_behind, direction, cosine, t);
    rays->rays[v] = ray_of(origin, direction);
    rays->limit[v] -= hit->distance + t;
    rays->active[v] = lanes & (rays->limit[v] > 0);
}

/**
 * Finds which of the surfaces that light meets are not there, because a later shape is. It is asked
 * as for rays that look (see dielectric_hit_find()), and only where #Dielectrics.may_override says
 * so.
 * @param offset  How rays leave a surface.
 * @param dielectrics  What the scene has of glass.
 * @param[in,out] interior  What the rays are inside of.
 * @param[out] overridden  Where the surface is not there.
 */
static void find_overridden(const RayOffset *offset, const Dielectrics *dielectrics,
                            const Packet *rays, const Hit *hits, InteriorList *interior,
                            mask *overridden) {
    Packet segments;
    mask is_transmitted[PACKET_VECTORS];
    integer shape_before[PACKET_VECTORS];
    segments.wants_points = true;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        const Hit *hit = &hits[v];
        Vec3 direction = rays->rays[v].direction, normal = hit->normal;
        mask hit_lanes = rays->active[v] & (hit->shape >= integer_of(0));
        integer shape = integer_select(hit_lanes, hit->shape, integer_of(-1));
        is_transmitted[v] = hit_lanes & (dielectrics_ior(dielectrics, shape) > 0);
        shape_before[v] = interior_list_cross(&interior[v], &rays->rays[v], hit, is_transmitted[v]);
        Vec3 n_front =
            vec3_select(vec3_dot(direction, normal) > 0, vec3_scale(normal, real_of(-1)), normal);
        offset_segment_set(ray_offset_length(offset, hit), hit, n_front, is_transmitted[v], v,
                           &segments);
    }
    if (packet_active_count(&segments) > 0) {
        dielectrics_cross_segments(dielectrics, &segments, interior);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        overridden[v] = is_transmitted[v] & (shape_before[v] == interior_list_top(&interior[v]));
    }
}

/**
 * Filters a packet through the next surface of each ray.
 * @param offset  How rays leave a surface.
 * @param surface  The points that the rays come from.
 * @param[in,out] rays  The rays; active where there may be more surfaces.
 * @param[in,out] interior  What they are inside of; only where #Dielectrics.may_override.
 * @param[in,out] transmittance  What is left of the light.
 */
static void shadow_transmittance_step(const ShapeSet *shapes, const RayOffset *offset,
                                      const SurfaceHit *surface, Packet *rays,
                                      InteriorList *interior, Rgb *transmittance) {
    Hit hits[PACKET_VECTORS];
    mask overridden[PACKET_VECTORS] = {0};
    shape_set_closest_hits(&surface->dielectrics->transparent, rays, hits);
    if (surface->dielectrics->may_override) {
        find_overridden(offset, surface->dielectrics, rays, hits, interior, overridden);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask hit_lanes = rays->active[v] & (hits[v].shape >= integer_of(0));
        rays->active[v] = hit_lanes;
        if (any(hit_lanes)) {
            MaterialIds ids = material_ids_of(shapes, &hits[v], hit_lanes);
            MaterialPack material = material_pack_gather(surface->materials, &ids, hit_lanes);
            Rgb attenuated = rgb_multiply(transmittance[v], material.transmittance);
            transmittance[v] =
                rgb_select(hit_lanes & mask_not(overridden[v]), attenuated, transmittance[v]);
            mask goes_on = hit_lanes & (rgb_max(transmittance[v]) > 0);
            shadow_rays_advance(offset, &hits[v], goes_on, v, rays);
        }
    }
}

void shadow_transmittance_find(const ShapeSet *shapes, const RayOffset *offset,
                               const SurfaceHit *surface, const Packet *shadow, mask *occluded,
                               Rgb *transmittance) {
    Packet rays = *shadow;
    InteriorList interior[PACKET_VECTORS];
    rays.wants_points = true;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        rays.active[v] &= mask_not(occluded[v]);
        transmittance[v] = (Rgb){real_of(1), real_of(1), real_of(1)};
        if (surface->dielectrics->may_override) {
            interior[v] = surface->interior[v];
        }
    }
    for (int i = 0; i < MAX_SHADOW_SURFACES && packet_active_count(&rays) > 0; i++) {
        shadow_transmittance_step(shapes, offset, surface, &rays, interior, transmittance);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        occluded[v] |= rays.active[v] | mask_not(rgb_max(transmittance[v]) > 0);
    }
}
