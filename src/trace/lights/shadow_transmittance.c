/**
 * @file
 * @brief Shadow rays through transparent shapes.
 */
#include "trace/lights/shadow_transmittance.h"

/**
 * Largest number of surfaces that a shadow ray crosses; behind more it is dark. With `--offset
 * none` rays start on the surface that they leave and would meet it for ever.
 */
enum { MAX_SHADOW_SURFACES = 256 };

/** Moves the origins of rays behind a surface and shortens the rays by as much. @param lanes The
 *  rays that continue. */
INLINE void shadow_rays_advance(const RayOffset *offset, const Hit *hit, mask lanes, int v,
                                Packet *rays) {
    Vec3 direction = rays->rays[v].direction;
    real along = vec3_dot(direction, hit->normal), cosine = real_abs(along);
    real side = real_select(along < 0, real_of(-1), real_of(1));
    real offset_length = ray_offset_length(offset, hit);
    real behind = TRANSMIT_OFFSET_BOUNDS * offset_length;
    real t = ray_offset_along_t(behind, cosine, real_sqrt(vec3_dot(direction, direction)));
    Vec3 n_behind = vec3_scale(hit->normal, side);
    Vec3 origin = ray_offset_along_origin(hit, behind, n_behind, direction, cosine, t);
    rays->rays[v] = ray_of(origin, direction);
    rays->limit[v] -= hit->distance + t;
    rays->active[v] = lanes & (rays->limit[v] > 0);
}

/**
 * Finds the surfaces that do not count, because they lie inside a transparent shape that comes
 * later in the scene: as for refracted rays (see dielectric_hit_find()). It is called only if
 * #Dielectrics.may_override is set.
 * @param offset  How rays leave a surface.
 * @param dielectrics  The transparent shapes of the scene.
 * @param[in,out] interior  The shapes that the rays are inside of.
 * @param[out] overridden  The rays whose surface does not count.
 */
static void find_overridden(const RayOffset *offset, const Dielectrics *dielectrics,
                            const Packet *rays, const Hit *hits, InteriorList *interior,
                            mask *overridden) {
    Packet segments;
    mask is_transmitted[PACKET_VECTORS];
    integer shape_before[PACKET_VECTORS];
    packet_init(&segments, packet_vector_count(rays), true);
    for (int v = 0; v < packet_vector_count(rays); v++) {
        const Hit *hit = &hits[v];
        Vec3 direction = rays->rays[v].direction, normal = hit->normal;
        mask hit_lanes = rays->active[v] & (hit->shape >= integer_of(0));
        if (!any(hit_lanes)) {
            is_transmitted[v] = segments.active[v] = mask_of(false);
            segments.limit[v] = real_of(0);
            continue;
        }
        integer shape = integer_select(hit_lanes, hit->shape, integer_of(-1));
        is_transmitted[v] = hit_lanes & (dielectrics_ior(dielectrics, shape) > 0);
        shape_before[v] = interior_list_cross(&interior[v], &rays->rays[v], hit, is_transmitted[v]);
        Vec3 n_front =
            vec3_select(vec3_dot(direction, normal) > 0, vec3_scale(normal, real_of(-1)), normal);
        offset_segment_set(ray_offset_length(offset, hit), hit, n_front, is_transmitted[v], v,
                           &segments);
    }
    if (packet_active_count(&segments) > 0) {
        dielectrics_cross_segments(dielectrics, &segments, hits, interior);
    }
    for (int v = 0; v < packet_vector_count(rays); v++) {
        if (!any(is_transmitted[v])) {
            overridden[v] = mask_of(false);
            continue;
        }
        overridden[v] = is_transmitted[v] & (shape_before[v] == interior_list_top(&interior[v]));
    }
}

/**
 * Multiplies the transmittance by that of the next surface of each ray.
 * @param glass  The shapes that count.
 * @param offset  How rays leave a surface.
 * @param[in,out] rays  The rays; active where there may be more surfaces.
 * @param[in,out] interior  The shapes that they are inside of, if #Dielectrics.may_override.
 * @param[in,out] transmittance  See #shadow_transmittance_find.
 */
static void shadow_transmittance_step(const ShapeSet *shapes, const ShapeSet *glass,
                                      const RayOffset *offset, const SurfaceHit *surface,
                                      Packet *rays, InteriorList *interior, Rgb *transmittance) {
    Hit hits[PACKET_VECTORS];
    mask overridden[PACKET_VECTORS] = {0};
    shape_set_closest_hits(glass, rays, hits);
    if (surface->dielectrics->may_override) {
        find_overridden(offset, surface->dielectrics, rays, hits, interior, overridden);
    }
    for (int v = 0; v < packet_vector_count(rays); v++) {
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

const ShapeSet *shadow_transmittance_shapes(const Dielectrics *dielectrics,
                                            const RayOffset *offset) {
    // On a clear surface, only a ray that does not leave it loses its light.
    return offset->strategy == OFFSET_BOUND ? &dielectrics->tinted : &dielectrics->transparent;
}

void shadow_transmittance_find(const ShapeSet *shapes, const ShapeSet *glass,
                               const RayOffset *offset, const SurfaceHit *surface,
                               const Packet *shadow, mask *occluded, Rgb *transmittance) {
    Packet rays = *shadow;
    InteriorList interior[PACKET_VECTORS];
    rays.wants_points = true;
    for (int v = 0; v < packet_vector_count(&rays); v++) {
        rays.active[v] &= mask_not(occluded[v]);
        if (surface->dielectrics->may_override && any(rays.active[v])) {
            interior[v] = surface->interior[v];
        }
    }
    for (int i = 0; i < MAX_SHADOW_SURFACES && packet_active_count(&rays) > 0; i++) {
        shadow_transmittance_step(shapes, glass, offset, surface, &rays, interior, transmittance);
    }
    for (int v = 0; v < packet_vector_count(&rays); v++) {
        occluded[v] |= rays.active[v] | mask_not(rgb_max(transmittance[v]) > 0);
    }
}
