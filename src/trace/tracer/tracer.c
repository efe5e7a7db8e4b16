/**
 * @file
 * @brief Recursive ray tracing: direct light and shadows, reflection and refraction (Whitted,
 *        *An Improved Illumination Model for Shaded Display*, 1980).
 *
 * The recursion is at the end, in two steps. shade_and_scatter() finds the hits, adds up the light
 * of the background and of the lights, and generates the reflected and refracted rays.
 * trace_packet() traces those and adds their colours. Each function handles a packet of rays; an
 * array holds PACKET_VECTORS vectors of LANES rays each.
 */
#include "trace/tracer/tracer.h"

#include "trace/glass/contact.h"
#include "trace/glass/neighbours.h"
#include "trace/lights/direct_lighting.h"
#include "trace/tracer/aov.h"
#include "trace/tracer/path_hash.h"
#include "trace/tracer/ray_tree_recorder.h"
#include "trace/tracer/report_methods.h"
#include "trace/tracer/secondary_rays.h"

/* --- hits ------------------------------------------------------------------------------------- */

/** @return The shape that all rays meet that meet any; -1: they meet several, or none. */
INLINE int sole_shape(const SurfaceHit *surface) {
    int first = 0;
    while (first < packet_vector_count(surface->packet) && !any(surface->is_hit[first])) {
        first++;
    }
    if (first == packet_vector_count(surface->packet)) {
        return -1;
    }
    int shape = integer_at(&surface->hits[first].shape, mask_first(surface->is_hit[first]));
    mask others = mask_of(false);
    for (int v = first; v < packet_vector_count(surface->packet); v++) {
        others |= surface->is_hit[v] & (surface->hits[v].shape != integer_of(shape));
    }
    return any(others) ? -1 : shape;
}

/** Finds the materials at the hits: one for the whole packet, where its rays meet one shape. */
INLINE void find_materials(const Tracer *tracer, SurfaceHit *surface) {
    const Material *materials = surface->materials;
    int shape = sole_shape(surface);
    surface->is_uniform = shape >= 0;
    if (surface->is_uniform) {
        int material = tracer->shapes.shapes[shape]->material;
        const MaterialIds ids = {integer_of(material), material, mask_of(false)};
        surface->traits = materials[material].traits;
        for (int v = 0; v < packet_vector_count(surface->packet); v++) {
            surface->material_ids[v] = ids;
        }
        return;
    }
    surface->traits = 0;
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        MaterialIds ids = material_ids_of(&tracer->shapes, &surface->hits[v], surface->is_hit[v]);
        surface->material_ids[v] = ids;
        surface->traits |= any(surface->is_hit[v]) ? material_ids_traits(materials, &ids) : 0;
    }
}

/** Finds the nearest hit of each ray. @return Whether any ray hits a shape. */
static bool find_hits(const Tracer *tracer, const RayState *rays, SurfaceHit *surface) {
    const Packet *packet = &rays->packet;
    bool is_any_hit = false;
    surface->materials = tracer->materials;
    surface->packet = packet;
    surface->dielectrics = &tracer->dielectrics;
    surface->dielectric = NULL;
    surface->interior = rays->interior;
    if (rays->interior) {
        neighbours_closest_hits(&tracer->dielectrics, packet, rays->interior, surface->hits);
    } else {
        shape_set_closest_hits(&tracer->shapes, packet, surface->hits);
    }
    if (tracer->emitters.count > 0) {
        emitters_closest_hits(&tracer->emitters, packet, surface->hits);
    }
    for (int v = 0; v < packet_vector_count(packet); v++) {
        const Hit *hit = &surface->hits[v];
        surface->is_hit[v] = surface->needs_light[v] =
            packet->active[v] & (hit->shape >= integer_of(0));
        mask is_inside = vec3_dot(packet->rays[v].direction, hit->normal) > 0;
        surface->n_front[v] =
            vec3_select(is_inside, vec3_scale(hit->normal, real_of(-1)), hit->normal);
        is_any_hit = is_any_hit || any(surface->is_hit[v]);
    }
    return is_any_hit;
}

/** Records the hits where a recorder is set. Not inlined: images are rendered without recorders,
 *  and the code would only lengthen their path. */
static __attribute__((noinline)) void surface_hit_record(const SurfaceHit *surface,
                                                         const Tracer *tracer) {
    const Recorders *recorders = surface->packet->context.recorders;
    if (recorders->path_hashes) {
        path_hash_add_surfaces(surface);
    }
    if (recorders->aovs) {
        aov_record_surfaces(surface);
    }
    if (recorders->ray_tree) {
        ray_tree_record_surface(surface, &tracer->ray_offset);
        ray_tree_record_march(&tracer->shapes, surface);
    }
}

/* --- local shading ---------------------------------------------------------------------------- */

/** @return The radiance of the sky. @param lanes The lanes that it is needed in. */
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

/** Sets the colours of the rays that hit no shape: of the sky, or of a visible light. */
INLINE void shade_background(const Tracer *tracer, const SurfaceHit *surface, Rgb *colors) {
    const Packet *packet = surface->packet;
    for (int v = 0; v < packet_vector_count(packet); v++) {
        mask missed = packet->active[v] & mask_not(surface->is_hit[v]);
        if (any(missed)) {
            colors[v] = sky_color(tracer, packet->rays[v].direction, missed);
        }
    }
    if (tracer->emitters.count > 0) {
        emitters_shade(tracer->lights, packet, surface->hits, colors);
    }
}

/** @return emission + albedo (ambient + diffuse D) + specular S: the radiance of a surface without
 *          reflected and refracted rays. @param lighting Its sums D and S of direct light. @param
 *          shines Whether any surface has highlights. */
INLINE Rgb local_color(const MaterialPack *material, const DirectLighting *lighting, bool shines,
                       int v) {
    Rgb color = diffuse_color(material, lighting->diffuse[v]);
    return shines ? rgb_add(color, rgb_multiply(material->specular, lighting->specular[v])) : color;
}

/** Sets the colours of the rays that hit a shape, where all meet the same opaque material. */
INLINE void shade_uniform_surfaces(const SurfaceHit *surface, const DirectLighting *lighting,
                                   Rgb *colors) {
    const MaterialPack material =
        material_pack_splat(&surface->materials[surface->material_ids[0].first]);
    const bool shines = surface->traits & MATERIAL_SHINES;
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        colors[v] =
            rgb_select(surface->is_hit[v], local_color(&material, lighting, shines, v), colors[v]);
    }
}

/** Sets the colours of the rays that hit a shape, whatever they meet. @param textures The colours
 *  of textures; NULL: there are none. */
INLINE void shade_mixed_surfaces(const SurfaceHit *surface, const DirectLighting *lighting,
                                 const Rgb *textures, Rgb *colors) {
    const Rgb black = {real_of(0), real_of(0), real_of(0)};
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        MaterialPack material =
            material_pack_gather(surface->materials, &surface->material_ids[v], surface->is_hit[v]);
        if (textures) {
            material.albedo = rgb_multiply(material.albedo, textures[v]);
        }
        Rgb color = local_color(&material, lighting, surface->traits & MATERIAL_SHINES, v);
        if (surface->dielectric) {
            color = rgb_select(surface->dielectric->is_overridden[v], black, color);
        }
        colors[v] = rgb_select(surface->is_hit[v], color, colors[v]);
    }
}

/** Sets the colours of the rays that hit a shape, without reflection and refraction. */
INLINE void shade_surfaces(const TraceContext *context, const SurfaceHit *surface, Rgb *colors) {
    const Tracer *tracer = context->tracer;
    bool has_textures = tracer->textures.material_maps != NULL;
    // The reports add highlights, of 0, in any case.
    bool shines = (surface->traits & MATERIAL_SHINES) || tracer->methods;
    DirectLighting lighting;
    Rgb texture_color[PACKET_VECTORS];
    context->counts->shadow += shade_direct(&tracer->shapes, tracer->lights, tracer->light_count,
                                            &tracer->ray_offset, shines, surface, &lighting);
    if (has_textures) {
        textures_sample(&tracer->textures, &tracer->shapes, surface, texture_color);
    }
    if (surface->is_uniform && !has_textures && !surface->dielectric) {
        shade_uniform_surfaces(surface, &lighting, colors);
    } else {
        shade_mixed_surfaces(surface, &lighting, has_textures ? texture_color : NULL, colors);
    }
    if (tracer->methods) {
        report_shade_surfaces(tracer, surface, &lighting, has_textures ? texture_color : NULL,
                              colors);
    }
    if (sample_context_ray_tree(&surface->packet->context)) {
        ray_tree_record_shading(surface, has_textures ? texture_color : NULL, colors[0]);
    }
}

/* --- the recursion ---------------------------------------------------------------------------- */

/** Finds the rays that may be reflected or refracted: the depth that the user asks for is not used
 *  up. @return Whether any ray may go on; at an overridden surface all may. */
INLINE bool find_turns(const Tracer *tracer, const RayState *rays, SurfaceHit *surface) {
    mask goes_on = mask_of(false);
    for (int v = 0; v < packet_vector_count(&rays->packet); v++) {
        surface->may_turn[v] = surface->is_hit[v] & (rays->turns[v] < integer_of(tracer->depth));
        goes_on |= surface->may_turn[v];
        if (surface->dielectric) {
            goes_on |= surface->dielectric->is_overridden[v];
        }
    }
    return any(goes_on);
}

// Not inlined: its locals, several kilobytes, must be off the stack before trace_packet() calls
// itself, since that happens up to DEPTH_MAXIMUM times.
__attribute__((noinline)) bool shade_and_scatter(const TraceContext *context, const RayState *rays,
                                                 ScatteredRays *scattered, Rgb *colors,
                                                 Losses *losses) {
    const Tracer *tracer = context->tracer;
    SurfaceHit surface;
    DielectricHit dielectric;
    bool is_any_hit = find_hits(tracer, rays, &surface);
    if (rays->interior && is_any_hit) {
        contacts_resolve(&tracer->ray_offset, &surface);
    }
    find_materials(tracer, &surface);
    if (rays->packet.context.recorders) {
        surface_hit_record(&surface, tracer);
    }
    shade_background(tracer, &surface, colors);
    if (tracer->methods) {
        report_shade_background(context, &surface, colors);
    }
    if (!is_any_hit) {
        return false;
    }
    if (rays->interior) {
        context->counts->total_reflection += dielectric_hit_find(
            &tracer->ray_offset, &surface, scattered->interior_behind, &dielectric);
        if (sample_context_ray_tree(&rays->packet.context)) {
            ray_tree_record_dielectric(&surface);
        }
    }
    shade_surfaces(context, &surface, colors);
    // The reports' surfaces may turn rays that their materials do not.
    bool is_matt = !(surface.traits & MATERIAL_TURNS) && !rays->interior && !tracer->methods;
    if (is_matt || !find_turns(tracer, rays, &surface)) {
        return false;
    }
    losses_clear(losses, packet_vector_count(&rays->packet));
    reflect_rays(context, rays, &surface, &scattered->reflected, losses);
    if (rays->interior) {
        refract_rays(context, rays, &surface, &scattered->refracted, losses);
    }
    if (tracer->methods) {
        report_scatter(context, rays, &surface, &scattered->reflected,
                       rays->interior ? &scattered->refracted : NULL);
    }
    return true;
}

/** Traces secondary rays, if any are active, and adds their colours and losses. */
INLINE void trace_secondary(const TraceContext *context, const SecondaryRays *secondary,
                            Rgb *colors, Losses *losses) {
    const RayState *rays = &secondary->rays;
    RayTree *ray_tree = sample_context_ray_tree(&rays->packet.context);
    Rgb incoming[PACKET_VECTORS];
    Losses incoming_losses;
    unsigned count = packet_active_count(&rays->packet);
    if (count == 0) {
        return;
    }
    *(secondary->type == RAY_REFRACTION ? &context->counts->refraction
                                        : &context->counts->reflection) += count;
    if (ray_tree) {
        ray_tree_push(ray_tree, secondary->type, rays, secondary->weights[0]);
    }
    if (!trace_packet(context, rays, incoming, &incoming_losses)) {
        losses_clear(&incoming_losses, packet_vector_count(&rays->packet));
    }
    if (ray_tree) {
        ray_tree_pop(ray_tree, incoming[0]);
    }
    secondary_rays_add(secondary, incoming, colors);
    losses_add(&rays->packet, &incoming_losses, losses);
}

bool trace_packet(const TraceContext *context, const RayState *rays, Rgb *colors, Losses *losses) {
    ScatteredRays scattered;
    if (!shade_and_scatter(context, rays, &scattered, colors, losses)) {
        return false;
    }
    // Report D lists the refracted ray first.
    bool is_refracted_first = rays->interior && context->tally;
    if (is_refracted_first) {
        trace_secondary(context, &scattered.refracted, colors, losses);
    }
    trace_secondary(context, &scattered.reflected, colors, losses);
    if (rays->interior && !is_refracted_first) {
        trace_secondary(context, &scattered.refracted, colors, losses);
    }
    return true;
}
