/**
 * @file
 * @brief The reports' methods within the recursion.
 */
#include "trace/tracer/report_methods.h"

#include "trace/lights/light.h"

/** Rays of a pixel in report D: the length of its list. */
#define REPORT_D_RAYS 4
/** Brightness of report D's lamps: 5 / (2 + distance). */
#define REPORT_D_INTENSITY 5
/** Constant of that falloff, scene units. */
#define REPORT_D_CONSTANT 2

__attribute__((noinline)) bool report_trace_camera_packet(const TraceContext *context,
                                                          const RayState *rays, Rgb *colors,
                                                          Losses *losses) {
    RayTally tally;
    TraceContext counted = *context;
    counted.tally = &tally;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        tally.count[v] = real_of(1);
    }
    bool may_lose = trace_packet(&counted, rays, colors, losses);
    if (context->tracer->methods & METHOD_MEAN_OF_RAYS) {
        for (int v = 0; v < PACKET_VECTORS; v++) {
            real count = real_min(tally.count[v], real_of(REPORT_D_RAYS));
            colors[v] = rgb_scale(colors[v], 1 / count);
        }
    }
    return may_lose;
}

/** @return What is left of the colours that rays bring back: 1 / d^2 of the length of secondary
 *  rays. @param v Which vector of rays. */
INLINE real fading_of(const SurfaceHit *surface, int v) {
    real distance = surface->hits[v].distance;
    return 1 / real_max(distance * distance, real_of(MIN_DISTANCE_SQUARED));
}

/** @return Whether the rays of a packet fade: they are secondary rays, in report A. */
static bool is_fading(const Tracer *tracer, const Packet *packet) {
    return (tracer->methods & METHOD_FADING_MIRRORS) && packet->context.bounce > 0;
}

__attribute__((noinline)) void report_shade_background(const TraceContext *context,
                                                       const SurfaceHit *surface, Rgb *colors) {
    const Rgb black = {real_of(0), real_of(0), real_of(0)};
    if (is_fading(context->tracer, surface->packet)) {
        for (int v = 0; v < PACKET_VECTORS; v++) {
            colors[v] = rgb_select(surface->is_hit[v], colors[v], black);
        }
    }
}

/** @return The radiance of surfaces without secondary rays. @param v Which vector of rays. @param
 *  material The materials, with textures. */
static Rgb report_local_color(const Tracer *tracer, const SurfaceHit *surface, int v,
                              const MaterialPack *material, const DirectLighting *lighting) {
    Rgb direct = rgb_scale(lighting->diffuse[v], material->diffuse), color;
    if (tracer->methods & METHOD_ADDED_LIGHT) {
        // In its mode "light alone", whose ambient light is 0, the report multiplies.
        Rgb added = rgb_add(material->albedo, lighting->diffuse[v]);
        Rgb multiplied = rgb_multiply(material->albedo, lighting->diffuse[v]);
        color = rgb_select(rgb_max(material->ambient) > 0, added, multiplied);
    } else {
        Rgb ambient = material->ambient;
        if (tracer->methods & METHOD_AMBIENT_IN_SHADOW) {
            Rgb black = {real_of(0), real_of(0), real_of(0)};
            ambient = rgb_select(rgb_max(lighting->diffuse[v]) > 0, black, ambient);
        }
        color = rgb_multiply(material->albedo, rgb_add(ambient, direct));
        color = rgb_add(color, rgb_multiply(material->specular, lighting->specular[v]));
    }
    color = rgb_add(material->emission, color);
    return is_fading(tracer, surface->packet) ? rgb_scale(color, fading_of(surface, v)) : color;
}

__attribute__((noinline)) void report_shade_surfaces(const Tracer *tracer,
                                                     const SurfaceHit *surface,
                                                     const DirectLighting *lighting,
                                                     const Rgb *textures, Rgb *colors) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask lanes = surface->is_hit[v];
        MaterialPack material =
            material_pack_gather(surface->materials, &surface->material_ids[v], lanes);
        if (textures) {
            material.albedo = rgb_multiply(material.albedo, textures[v]);
        }
        if (surface->dielectric) {
            lanes &= mask_not(surface->dielectric->is_overridden[v]);
        }
        Rgb color = report_local_color(tracer, surface, v, &material, lighting);
        colors[v] = rgb_select(lanes, color, colors[v]);
    }
}

/** Weighs secondary rays by the constants of the material, and not by Fresnel's formula. A surface
 *  that a later shape overrides is not there, and lets everything through. */
static void weigh_by_constants(const SurfaceHit *surface, SecondaryRays *reflected,
                               SecondaryRays *refracted) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        MaterialPack material =
            material_pack_gather(surface->materials, &surface->material_ids[v], surface->is_hit[v]);
        mask is_there = mask_not(surface->dielectric->is_overridden[v]);
        reflected->weights[v] = rgb_select(is_there, material.reflectance, reflected->weights[v]);
        refracted->weights[v] = rgb_select(is_there, material.transmittance, refracted->weights[v]);
        reflected->rays.packet.active[v] &= rgb_max(reflected->weights[v]) > 0;
        refracted->rays.packet.active[v] &= rgb_max(refracted->weights[v]) > 0;
    }
}

/** Ends the rays of a type. */
static void end_rays(SecondaryRays *secondary) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        secondary->rays.packet.active[v] = mask_of(false);
    }
}

/** Multiplies the weights of secondary rays by what is left of the rays that hit their surfaces. */
static void fade(const SurfaceHit *surface, SecondaryRays *secondary) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        secondary->weights[v] = rgb_scale(secondary->weights[v], fading_of(surface, v));
    }
}

/**
 * Puts secondary rays into report D's list, with weight 1: at a transparent surface the refracted
 * ray, then the reflected one; those beyond its end are not traced.
 * @param refracted  NULL: the scene has no transparent shape.
 */
static void put_into_list(RayTally *tally, const SurfaceHit *surface, SecondaryRays *reflected,
                          SecondaryRays *refracted) {
    const Rgb one = {real_of(1), real_of(1), real_of(1)};
    const real end = real_of(REPORT_D_RAYS);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        real count = tally->count[v];
        mask *mirrored = &reflected->rays.packet.active[v];
        mask is_glass = mask_of(false);
        if (refracted) {
            MaterialPack material = material_pack_gather(
                surface->materials, &surface->material_ids[v], surface->is_hit[v]);
            mask *transmitted = &refracted->rays.packet.active[v];
            // Rays whose depth is used up put nothing into the list.
            is_glass = surface->may_turn[v] & (rgb_max(material.transmittance) > 0) &
                       mask_not(surface->dielectric->is_overridden[v]);
            tally->count[v] = real_select(*transmitted | is_glass, count + 1, count);
            *transmitted &= count < end;
            count = tally->count[v];
            refracted->weights[v] = one;
            refracted->rays.throughput[v] = one;
        }
        tally->count[v] = real_select(*mirrored | is_glass, count + 1, count);
        *mirrored &= count < end;
        reflected->weights[v] = one;
        reflected->rays.throughput[v] = one;
    }
}

__attribute__((noinline)) void report_scatter(const TraceContext *context, const RayState *rays,
                                              const SurfaceHit *surface, SecondaryRays *reflected,
                                              SecondaryRays *refracted) {
    const Tracer *tracer = context->tracer;
    const SampleContext *sample = &rays->packet.context;
    if ((tracer->methods & METHOD_CONSTANT_SHARES) && refracted) {
        weigh_by_constants(surface, reflected, refracted);
    }
    if (is_fading(tracer, &rays->packet)) {
        fade(surface, reflected);
        if (refracted) {
            fade(surface, refracted);
        }
    }
    if ((tracer->methods & METHOD_SEPARATE_CHAINS) && refracted && sample->bounce > 0) {
        end_rays(sample->type == RAY_REFLECTION ? refracted : reflected);
    }
    if (tracer->methods & METHOD_MEAN_OF_RAYS) {
        put_into_list(context->tally, surface, reflected, refracted);
    }
}

__attribute__((noinline)) void report_light_set(Light *light, unsigned methods) {
    // The reports have no suns: theirs stay as they are.
    if (light->is_at_infinity) {
        return;
    }
    light->methods = methods & (METHOD_SHADOW_BEYOND | METHOD_SHADOW_BY_SHAPE);
    if (methods & METHOD_ADDED_LIGHT) {
        light->intensity =
            rgb_splat((Rgbs){REPORT_D_INTENSITY, REPORT_D_INTENSITY, REPORT_D_INTENSITY});
        light->is_inverse_square = false;
        light->is_inverse_linear = true;
        light->falloff_constant = REPORT_D_CONSTANT;
    }
}
