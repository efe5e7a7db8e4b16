/**
 * @file
 * @brief Rays at transparent surfaces.
 */
#include "trace/glass/dielectric.h"

#include "trace/materials/fresnel.h"

/** The transparent surfaces of a packet, before the shapes behind them are known. */
typedef struct DielectricEntry {
    Packet segments;                      /**< From behind each surface back to before it. */
    integer shape_before[PACKET_VECTORS]; /**< The shape before the surface; -1: air. */
} DielectricEntry;

/** Finds the rays at transparent surfaces, and sets #DielectricHit.interior_behind from the hit
 *  alone. @return The number of these rays. */
static unsigned dielectric_hit_enter(const RayOffset *offset, const SurfaceHit *surface,
                                     DielectricEntry *entry, DielectricHit *dielectric) {
    unsigned count = 0;
    packet_init(&entry->segments, packet_vector_count(surface->packet), true);
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        MaterialPack material =
            material_pack_gather(surface->materials, &surface->material_ids[v], surface->is_hit[v]);
        mask is_transmitted = surface->is_hit[v] & (rgb_max(material.transmittance) > 0);
        dielectric->is_transmitted[v] = is_transmitted;
        dielectric->is_overridden[v] = mask_of(false);
        dielectric->reflectance[v] = real_of(0);
        entry->segments.active[v] = mask_of(false);
        entry->segments.limit[v] = real_of(0);
        if (any(is_transmitted)) {
            count += mask_count(is_transmitted);
            const Hit *hit = &surface->hits[v];
            offset_segment_set(ray_offset_length(offset, hit), hit, surface->n_front[v],
                               is_transmitted, v, &entry->segments);
            dielectric->interior_behind[v] = surface->interior[v];
            entry->shape_before[v] = interior_list_cross(
                &dielectric->interior_behind[v], &surface->packet->rays[v], hit, is_transmitted);
        }
    }
    return count;
}

/** Refracts a vector of rays. @param shape_before The shape before the surface; -1: air.
 *  @return The lanes that are totally reflected. */
INLINE mask dielectric_hit_refract(const RayOffset *offset, const SurfaceHit *surface, int v,
                                   integer shape_before, DielectricHit *dielectric) {
    const Hit *hit = &surface->hits[v];
    mask lanes = dielectric->is_transmitted[v];
    integer shape_behind = interior_list_top(&dielectric->interior_behind[v]);
    real offset_length = ray_offset_length(offset, hit);
    Refraction refraction = refraction_at(surface->packet->rays[v].direction, surface->n_front[v],
                                          dielectrics_ior(surface->dielectrics, shape_before),
                                          dielectrics_ior(surface->dielectrics, shape_behind),
                                          offset_length / hit->distance);
    Vec3 n_behind = vec3_scale(surface->n_front[v], real_of(-1));
    real behind = TRANSMIT_OFFSET_BOUNDS * offset_length;
    real t = ray_offset_along_t(behind, refraction.cos_t, real_of(1));
    dielectric->origin[v] =
        ray_offset_along_origin(hit, behind, n_behind, refraction.direction, refraction.cos_t, t);
    dielectric->direction[v] = refraction.direction;
    dielectric->is_overridden[v] = lanes & (shape_before == shape_behind);
    dielectric->reflectance[v] = real_select(lanes, refraction.reflectance, real_of(0));
    dielectric->is_transmitted[v] = lanes & mask_not(refraction.is_total);
    return lanes & refraction.is_total;
}

/** @return The points of a vector with diffuse or specular reflection: others need no light. */
INLINE mask lanes_needing_light(const SurfaceHit *surface, int v, mask overridden) {
    MaterialPack material =
        material_pack_gather(surface->materials, &surface->material_ids[v], surface->is_hit[v]);
    real max_weight = real_max(rgb_max(material.albedo), rgb_max(material.specular));
    return surface->needs_light[v] & mask_not(overridden) & (max_weight > 0);
}

unsigned dielectric_hit_find(const RayOffset *offset, SurfaceHit *surface,
                             InteriorList *interior_behind, DielectricHit *dielectric) {
    DielectricEntry entry;
    unsigned total = 0;
    surface->dielectric = dielectric;
    dielectric->interior_behind = interior_behind;
    if (dielectric_hit_enter(offset, surface, &entry, dielectric) == 0) {
        return 0;
    }
    if (packet_active_count(&entry.segments) > 0) {
        dielectrics_cross_segments(surface->dielectrics, &entry.segments, surface->hits,
                                   interior_behind);
    }
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        if (any(dielectric->is_transmitted[v])) {
            total += mask_count(
                dielectric_hit_refract(offset, surface, v, entry.shape_before[v], dielectric));
        }
        surface->needs_light[v] = lanes_needing_light(surface, v, dielectric->is_overridden[v]);
    }
    return total;
}
