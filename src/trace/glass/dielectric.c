/**
 * @file
 * @brief What becomes of rays at transparent surfaces.
 */
#include "trace/glass/dielectric.h"

#include "trace/materials/fresnel.h"

/** What is known of transparent surfaces before what is behind them is. */
typedef struct DielectricEntry {
    Packet segments;                      /**< From behind the surface back to before it. */
    integer shape_before[PACKET_VECTORS]; /**< Place of the medium before the surface. */
} DielectricEntry;

/**
 * Finds which rays met transparent surfaces, and aims their jumps.
 * @param offset  How rays leave a surface.
 * @param[out] dielectric  The lanes, and the media behind.
 * @return How many lanes.
 */
static unsigned dielectric_hit_enter(const RayOffset *offset, const SurfaceHit *surface,
                                     DielectricEntry *entry, DielectricHit *dielectric) {
    unsigned count = 0;
    entry->segments.wants_points = true;
    for (int v = 0; v < PACKET_VECTORS; v++) {
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
            real offset_length = ray_offset_length(offset, &surface->hits[v]);
            const Hit *hit = &surface->hits[v];
            offset_segment_set(offset_length, hit, surface->n_front[v], is_transmitted, v,
                               &entry->segments);
            dielectric->interior[v] = surface->interior[v];
            entry->shape_before[v] = interior_list_cross(
                &dielectric->interior[v], &surface->packet->rays[v], hit, is_transmitted);
        }
    }
    return count;
}

/**
 * Bends rays where the medium changes.
 * @param dielectrics  What the scene has of glass.
 * @param offset  How rays leave a surface.
 * @param v  Which vector of them.
 * @param shape_before  Place of the medium before the surface.
 * @param[in,out] dielectric  What becomes of them; the media behind are there.
 * @return The lanes that are reflected totally.
 */
INLINE mask dielectric_hit_refract(const Dielectrics *dielectrics, const RayOffset *offset,
                                   const SurfaceHit *surface, int v, integer shape_before,
                                   DielectricHit *dielectric) {
    const Hit *hit = &surface->hits[v];
    mask lanes = dielectric->is_transmitted[v];
    integer shape_behind = interior_list_top(&dielectric->interior[v]);
    real offset_length = ray_offset_length(offset, hit);
    Refraction refraction =
        refraction_at(surface->packet->rays[v].direction, surface->n_front[v],
                      dielectrics_ior(dielectrics, shape_before),
                      dielectrics_ior(dielectrics, shape_behind), offset_length / hit->distance);
    Vec3 n_behind = vec3_scale(surface->n_front[v], real_of(-1));
    real t = ray_offset_transmitted_t(offset_length, refraction.cos_t, real_of(1));
    dielectric->origin[v] = ray_offset_transmitted_origin(
        hit, offset_length, n_behind, refraction.direction, refraction.cos_t, t);
    dielectric->direction[v] = refraction.direction;
    dielectric->is_overridden[v] = lanes & (shape_before == shape_behind);
    dielectric->reflectance[v] = real_select(lanes, refraction.reflectance, real_of(0));
    dielectric->is_transmitted[v] = lanes & mask_not(refraction.is_total);
    return lanes & refraction.is_total;
}

/**
 * @return The points of a vector that ask for light: those with a body.
 * @param overridden  Those whose surface is not there.
 */
INLINE mask lanes_needing_light(const SurfaceHit *surface, int v, mask overridden) {
    MaterialPack material =
        material_pack_gather(surface->materials, &surface->material_ids[v], surface->is_hit[v]);
    real max_weight = real_max(rgb_max(material.albedo), rgb_max(material.specular));
    return surface->needs_light[v] & mask_not(overridden) & (max_weight > 0);
}

unsigned dielectric_hit_find(const Dielectrics *dielectrics, const RayOffset *offset,
                             SurfaceHit *surface, DielectricHit *dielectric) {
    DielectricEntry entry;
    unsigned total = 0;
    if (dielectric_hit_enter(offset, surface, &entry, dielectric) == 0) {
        return 0;
    }
    if (packet_active_count(&entry.segments) > 0) {
        dielectrics_cross_segments(dielectrics, &entry.segments, dielectric->interior);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        if (any(dielectric->is_transmitted[v])) {
            total += mask_count(dielectric_hit_refract(dielectrics, offset, surface, v,
                                                       entry.shape_before[v], dielectric));
        }
        surface->needs_light[v] = lanes_needing_light(surface, v, dielectric->is_overridden[v]);
    }
    return total;
}
