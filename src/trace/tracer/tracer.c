/**
 * @file
 * @brief The recursive tracer: light, shadow, mirrors and glass (Whitted, *An
 *        Improved Illumination Model for Shaded Display*, 1980).
 */
#include "trace/tracer/tracer.h"

#include "trace/tracer/aov.h"
#include "trace/tracer/packet_merge.h"
#include "trace/tracer/path_hash.h"
#include "trace/tracer/ray_tree_recorder.h"

/** @return What rays that meet nothing see. */
static Rgb sky_color(const Tracer *tracer, Vec3 direction, mask lanes) {
    const Sky *sky = &tracer->sky;
    if (tracer->textures.sky) {
        return textures_sample_sky(&tracer->textures, direction, lanes);
    }
    if (!sky->is_gradient) {
        return sky->horizon;
    }
    real height = real_max(direction.y, real_of(0));
    return rgb_add(sky->horizon, rgb_scale(sky->zenith_minus_horizon, height));
}

/** Finds what a packet of rays meets. @return Whether any ray met anything. */
static bool surface_hit_find(const Tracer *tracer, const Packet *packet, SurfaceHit *surface) {
    bool any_hit = false;
    surface->materials = tracer->materials;
    surface->packet = packet;
    shape_set_closest_hits(&tracer->shapes, packet, surface->hits);
    if (tracer->emitters.count > 0) {
        emitters_closest_hits(&tracer->emitters, packet, surface->hits);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        const Hit *hit = &surface->hits[v];
        surface->is_hit[v] = surface->needs_light[v] =
            packet->active[v] & (hit->shape >= integer_of(0));
        mask is_inside = vec3_dot(packet->rays[v].direction, hit->normal) > 0;
        surface->n_front[v] =
            vec3_select(is_inside, vec3_scale(hit->normal, real_of(-1)), hit->normal);
        surface->material_ids[v] = material_ids_of(&tracer->shapes, hit, surface->is_hit[v]);
        any_hit = any_hit || any(surface->is_hit[v]);
    }
    return any_hit;
}

/**
 * @return What the body of surfaces sends back: all but what is mirrored or let through.
 * @param diffuse  What the lamps give for the matt shine.
 * @param specular  What they give for highlights.
 */
INLINE Rgb direct_color(const MaterialPack *material, Rgb diffuse, Rgb specular) {
    Rgb light = rgb_add(material->ambient, rgb_scale(diffuse, material->diffuse));
    Rgb color = rgb_add(material->emission, rgb_multiply(material->albedo, light));
    return rgb_add(color, rgb_multiply(material->specular, specular));
}

/** Rays that go on from surfaces, and what they are worth. */
typedef struct SecondaryRays {
    RayType kind;                /**< What they are, for who notes them. */
    Packet packet;               /**< The rays; active where they can still change the picture. */
    Rgb weights[PACKET_VECTORS]; /**< Of what they bring back, that the surfaces send on. */
    real throughputs[PACKET_VECTORS]; /**< The largest share with which a primary of theirs counts.
                                       */
} SecondaryRays;

/**
 * Weighs rays that could go on, and drops those that cannot change the picture.
 * @param weight  Factor on the colour that each ray brings back.
 * @param throughput  Throughput of the rays before them.
 * @return Those that go on.
 */
INLINE mask secondary_rays_set_weight(const Tracer *tracer, int v, mask lanes, Rgb weight,
                                      real throughput, SecondaryRays *secondary) {
    secondary->weights[v] = weight;
    secondary->throughputs[v] = throughput * rgb_max(weight);
    return secondary->packet.active[v] = lanes & (secondary->throughputs[v] >= tracer->cutoff);
}

/** Turns the rays of a packet that met mirrors, or glass, into mirrored rays (rows A9, C3). @param
 *  dielectric What becomes of them in glass, or NULL. */
INLINE void reflect_rays(const Tracer *tracer, const SurfaceHit *surface,
                         const DielectricHit *dielectric, const real *throughput,
                         SecondaryRays *reflected) {
    reflected->kind = RAY_REFLECTION;
    reflected->packet.wants_points = true;
    reflected->packet.context = sample_context_next_bounce(surface->packet->context);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        MaterialPack material =
            material_pack_gather(surface->materials, &surface->material_ids[v], surface->is_hit[v]);
        Rgb weight = dielectric_hit_reflectance(dielectric, v, &material);
        if (!any(secondary_rays_set_weight(tracer, v, surface->is_hit[v], weight, throughput[v],
                                           reflected))) {
            continue;
        }
        Vec3 in = surface->packet->rays[v].direction, normal = surface->n_front[v];
        real along = vec3_dot(in, normal);
        // Made one long again each time: else the length drifts by an ulp or two a mirror.
        Vec3 out = vec3_normalize(vec3_subtract(in, vec3_scale(normal, 2 * along)));
        Vec3 origin = ray_offset_origin(&tracer->ray_offset, &surface->hits[v], out);
        reflected->packet.rays[v] = ray_of(origin, out);
        reflected->packet.limit[v] = real_of(INFINITE);
    }
}

/** Turns the rays of a packet that met glass into refracted rays (row A10). */
INLINE void refract_rays(const Tracer *tracer, const SurfaceHit *surface,
                         const DielectricHit *dielectric, const real *throughput,
                         SecondaryRays *refracted) {
    refracted->kind = RAY_REFRACTION;
    refracted->packet.wants_points = true;
    refracted->packet.context = sample_context_next_bounce(surface->packet->context);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        MaterialPack material =
            material_pack_gather(surface->materials, &surface->material_ids[v], surface->is_hit[v]);
        Rgb weight = dielectric_hit_transmittance(dielectric, v, &material);
        if (any(secondary_rays_set_weight(tracer, v, dielectric->is_transmitted[v], weight,
                                          throughput[v], refracted))) {
            refracted->packet.rays[v] = ray_of(dielectric->origin[v], dielectric->direction[v]);
            refracted->packet.limit[v] = real_of(INFINITE);
        }
    }
}

/** Adds what rays that went on from surfaces have brought back. @param[in,out] colors The colours
 *  of the rays before them. */
INLINE void secondary_rays_add(const SecondaryRays *secondary, const Rgb *incoming, Rgb *colors) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Rgb sum = rgb_add(colors[v], rgb_multiply(secondary->weights[v], incoming[v]));
        colors[v] = rgb_select(secondary->packet.active[v], sum, colors[v]);
    }
}

/**
 * Follows rays that go on from surfaces, and adds what they bring back.
 * @param interior  What they are inside of; NULL: the scene has no glass.
 * @param depth  How often they may still be mirrored or refracted.
 * @param[in,out] colors  The colours of the rays before them.
 */
INLINE void secondary_rays_trace(const Tracer *tracer, const SecondaryRays *secondary,
                                 const InteriorList *interior, int depth, Rgb *colors,
                                 RayCounts *counts) {
    Rgb incoming[PACKET_VECTORS];
    RayTree *ray_tree = sample_context_ray_tree(&secondary->packet.context);
    if (ray_tree) {
        ray_tree_push(ray_tree, secondary->kind, &secondary->packet, secondary->weights[0],
                      secondary->throughputs[0]);
    }
    tracer_trace_packet(tracer, &secondary->packet, interior, secondary->throughputs, depth,
                        incoming, counts);
    if (ray_tree) {
        ray_tree_pop(ray_tree, incoming[0]);
    }
    secondary_rays_add(secondary, incoming, colors);
}

/** Adds what mirrors show, in a scene without glass. @param depth How often they may still be
 *  mirrored, at least once. */
INLINE void reflections_add(const Tracer *tracer, const SurfaceHit *surface, const real *throughput,
                            int depth, Rgb *colors, RayCounts *counts) {
    SecondaryRays reflected;
    reflect_rays(tracer, surface, NULL, throughput, &reflected);
    unsigned count = packet_active_count(&reflected.packet);
    if (count > 0) {
        counts->reflection += count;
        secondary_rays_trace(tracer, &reflected, NULL, depth - 1, colors, counts);
    }
}

/**
 * Finds what the bodies of surfaces send back.
 * @param dielectric  What becomes of the rays in glass, or NULL.
 * @param[in,out] colors  The rays' colours, written where they met anything.
 * @return How many shadow rays were traced.
 */
INLINE uint64_t surfaces_shade(const Tracer *tracer, const SurfaceHit *surface,
                               const DielectricHit *dielectric, Rgb *colors) {
    const Rgb black = {real_of(0), real_of(0), real_of(0)};
    DirectLighting lighting;
    uint64_t rays = shade_direct(&tracer->shapes, tracer->lights, tracer->light_count,
                                 &tracer->ray_offset, tracer->has_specular, surface, &lighting);
    Rgb texture_color[PACKET_VECTORS];
    if (tracer->textures.material_maps) {
        textures_sample(&tracer->textures, &tracer->shapes, surface, texture_color);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        MaterialPack material =
            material_pack_gather(surface->materials, &surface->material_ids[v], surface->is_hit[v]);
        if (tracer->textures.material_maps) {
            material.albedo = rgb_multiply(material.albedo, texture_color[v]);
        }
        Rgb direct = direct_color(&material, lighting.diffuse[v], lighting.specular[v]);
        if (dielectric) {
            direct = rgb_select(dielectric->is_overridden[v], black, direct);
        }
        colors[v] = rgb_select(surface->is_hit[v], direct, colors[v]);
    }
    if (sample_context_ray_tree(&surface->packet->context)) {
        ray_tree_record_shading(surface, dielectric,
                                tracer->textures.material_maps ? texture_color : NULL, colors[0]);
    }
    return rays;
}

/** Notes what rays have met. Never a part of its caller, which is called for every picture.
 *  @param surface The surfaces; something is noted of their packet. @param offset How rays leave
 *  them. */
static __attribute__((noinline)) void surface_hit_record(const SurfaceHit *surface,
                                                         const RayOffset *offset) {
    const Recorders *recorders = surface->packet->context.recorders;
    if (recorders->path_hashes) {
        path_hash_add_surfaces(surface);
    }
    if (recorders->aovs) {
        aov_record_surfaces(surface);
    }
    if (recorders->ray_tree) {
        ray_tree_record_surface(surface, offset);
    }
}

/**
 * Finds what rays meet, and the colours of those that meet nothing.
 * @param interior  What they are inside of, or NULL.
 * @param[out] colors  Their colours, where they met nothing.
 * @return Whether any ray met anything.
 */
INLINE bool intersect_packet(const Tracer *tracer, const Packet *packet,
                             const InteriorList *interior, SurfaceHit *surface, Rgb *colors) {
    bool any_hit = surface_hit_find(tracer, packet, surface);
    surface->dielectrics = &tracer->dielectrics;
    surface->interior = interior;
    if (packet->context.recorders) {
        surface_hit_record(surface, &tracer->ray_offset);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask missed = packet->active[v] & mask_not(surface->is_hit[v]);
        if (any(missed)) {
            colors[v] = sky_color(tracer, packet->rays[v].direction, missed);
        }
    }
    if (tracer->emitters.count > 0) {
        emitters_shade(tracer->lights, surface->hits, colors);
    }
    return any_hit;
}

/** As #tracer_trace_packet, in a scene without glass. @param depth How often they may still be
 *  mirrored. */
static void trace_without_dielectrics(const Tracer *tracer, const Packet *packet,
                                      const real *throughput, int depth, Rgb *colors,
                                      RayCounts *counts) {
    SurfaceHit surface;
    if (!intersect_packet(tracer, packet, NULL, &surface, colors)) {
        return;
    }
    counts->shadow += surfaces_shade(tracer, &surface, NULL, colors);
    if (depth > 0) {
        reflections_add(tracer, &surface, throughput, depth, colors, counts);
    }
}

/** Rays that glass parts. */
typedef struct SplitRays {
    SecondaryRays reflected;                      /**< Those that stay on this side. */
    SecondaryRays refracted;                      /**< Those that go on behind the surface. */
    InteriorList interior_behind[PACKET_VECTORS]; /**< What those are inside of. */
} SplitRays;

/**
 * Finds the colours of what rays meet in a scene with glass, and the rays that go on. Never a part
 * of its caller: what it needs is off the stack before those rays are followed.
 * @param interior  What they are inside of.
 * @param depth  How often they may still be mirrored or refracted.
 * @param[out] colors  Their colours, without what the rays that go on bring back.
 * @param[out] split  The rays that go on.
 * @return Whether any may.
 */
static __attribute__((noinline)) bool
split_rays_generate(const Tracer *tracer, const Packet *packet, const InteriorList *interior,
                    const real *throughput, int depth, Rgb *colors, RayCounts *counts,
                    SplitRays *split) {
    SurfaceHit surface;
    DielectricHit dielectric;
    if (!intersect_packet(tracer, packet, interior, &surface, colors)) {
        return false;
    }
    counts->total_reflection +=
        dielectric_hit_find(&tracer->dielectrics, &tracer->ray_offset, &surface, &dielectric);
    if (sample_context_ray_tree(&packet->context)) {
        ray_tree_record_dielectric(&surface, &dielectric);
    }
    counts->shadow += surfaces_shade(tracer, &surface, &dielectric, colors);
    if (depth == 0) {
        return false;
    }
    reflect_rays(tracer, &surface, &dielectric, throughput, &split->reflected);
    refract_rays(tracer, &surface, &dielectric, throughput, &split->refracted);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        split->interior_behind[v] = dielectric.interior[v];
    }
    return true;
}

/**
 * Follows mirrored and refracted rays side by side in one packet, and adds what they bring back.
 * Never a part of its caller: see #PACKET_MERGE_MAX_BOUNCES.
 * @param interior  What the mirrored ones are inside of.
 * @param depth  How often they may still be mirrored or refracted.
 * @param[in,out] colors  The colours of the rays before them.
 */
static __attribute__((noinline)) void
split_rays_trace_merged(const Tracer *tracer, const SplitRays *split, const InteriorList *interior,
                        int depth, Rgb *colors, RayCounts *counts) {
    const SecondaryRays *reflected = &split->reflected, *refracted = &split->refracted;
    PacketMerge merge;
    Rgb incoming[PACKET_VECTORS], own_colors[PACKET_VECTORS];
    packet_merge_begin(&merge, reflected->packet.context);
    packet_merge_add(&merge, &reflected->packet, interior, reflected->throughputs);
    packet_merge_add(&merge, &refracted->packet, split->interior_behind, refracted->throughputs);
    packet_merge_end(&merge);
    tracer_trace_packet(tracer, &merge.packet, merge.interior, merge.throughputs, depth, incoming,
                        counts);
    unsigned next = packet_merge_scatter(incoming, 0, &reflected->packet, own_colors);
    secondary_rays_add(reflected, own_colors, colors);
    packet_merge_scatter(incoming, next, &refracted->packet, own_colors);
    secondary_rays_add(refracted, own_colors, colors);
}

/**
 * As #tracer_trace_packet, in a scene with glass.
 * @param interior  What they are inside of.
 * @param depth  How often they may still be mirrored or refracted.
 */
static void trace_with_dielectrics(const Tracer *tracer, const Packet *packet,
                                   const InteriorList *interior, const real *throughput, int depth,
                                   Rgb *colors, RayCounts *counts) {
    SplitRays split;
    if (!split_rays_generate(tracer, packet, interior, throughput, depth, colors, counts, &split)) {
        return;
    }
    const SecondaryRays *reflected = &split.reflected, *refracted = &split.refracted;
    unsigned reflected_count = packet_active_count(&reflected->packet),
             refracted_count = packet_active_count(&refracted->packet);
    counts->reflection += reflected_count;
    counts->refraction += refracted_count;
    if (packet_merge_is_worthwhile(&reflected->packet, &refracted->packet)) {
        split_rays_trace_merged(tracer, &split, interior, depth - 1, colors, counts);
        return;
    }
    if (reflected_count > 0) {
        secondary_rays_trace(tracer, reflected, interior, depth - 1, colors, counts);
    }
    if (refracted_count > 0) {
        secondary_rays_trace(tracer, refracted, split.interior_behind, depth - 1, colors, counts);
    }
}

void tracer_trace_packet(const Tracer *tracer, const Packet *packet, const InteriorList *interior,
                         const real *throughput, int depth, Rgb *colors, RayCounts *counts) {
    if (interior) {
        trace_with_dielectrics(tracer, packet, interior, throughput, depth, colors, counts);
    } else {
        trace_without_dielectrics(tracer, packet, throughput, depth, colors, counts);
    }
}
