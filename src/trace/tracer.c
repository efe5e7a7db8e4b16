/**
 * @file
 * @brief The recursive tracer: light, shadow and mirrors.
 */
#include "trace/tracer.h"

/**
 * Weight below which a ray cannot change the picture: half a step of 8 bits, 1 / 510, at the dark
 * end of the sRGB curve, where the slope is 12.92.
 */
#define WEIGHT_CUTOFF ((scalar)1.5e-4)

/** @return What rays that meet nothing see. @param tracer The tracer. @param direction Unit
 *  directions. */
static Light3 backdrop_color(const Tracer *tracer, Vector direction) {
    const Backdrop *sky = &tracer->backdrop;
    if (tracer->textures.sky) {
        return textures_panorama(&tracer->textures, direction);
    }
    if (!sky->is_gradient) {
        return sky->horizon;
    }
    real height = real_max(direction.y, real_of(0));
    return light3_add(sky->horizon, light3_scale(sky->rise, height));
}

/** @return The materials in each lane. @param list The shapes. @param hit What was met.
 *  @param met The lanes that met anything. */
INLINE Materials materials_of(const ShapeList *list, const Hit *hit, mask met) {
    if (!any(met)) {
        return (Materials){0};
    }
    int shape = integer_lane(hit->shape, mask_first(met)), first = list->shapes[shape]->material;
    Materials materials = {integer_of(first), first, met & (hit->shape != integer_of(shape))};
    mask left = materials.others;
    while (any(left)) {
        shape = integer_lane(hit->shape, mask_first(left));
        mask same = left & (hit->shape == integer_of(shape));
        integer material = integer_of(list->shapes[shape]->material);
        materials.places = integer_select(same, material, materials.places);
        left &= mask_not(same);
    }
    return materials;
}

/**
 * Finds what a packet of rays meets.
 * @param tracer  The tracer.
 * @param packet  The rays.
 * @param[out] met  What they met.
 * @return Whether any ray met anything.
 */
static bool encounter_find(const Tracer *tracer, const Packet *packet, Encounter *met) {
    bool is_any = false;
    met->surfaces = tracer->surfaces;
    met->packet = packet;
    shape_list_nearest(&tracer->list, packet, met->hits);
    if (tracer->glow.count > 0) {
        glow_nearest(&tracer->glow, packet, met->hits);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        const Hit *hit = &met->hits[v];
        met->met[v] = packet->active[v] & (hit->shape >= integer_of(0));
        mask is_inside = vector_dot(packet->rays[v].direction, hit->normal) > 0;
        met->facing[v] =
            vector_select(is_inside, vector_scale(hit->normal, real_of(-1)), hit->normal);
        met->materials[v] = materials_of(&tracer->list, hit, met->met[v]);
        is_any = is_any || any(met->met[v]);
    }
    return is_any;
}

/**
 * @return What the body of surfaces sends back: all but what is mirrored.
 * @param surface   The surfaces.
 * @param matt      What the lamps give for the matt shine.
 * @param highlight What they give for highlights.
 */
INLINE Light3 body_color(const Surfaces *surface, Light3 matt, Light3 highlight) {
    Light3 light = light3_add(surface->ambient, light3_scale(matt, surface->diffuse));
    Light3 color = light3_add(surface->emission, light3_multiply(surface->body, light));
    return light3_add(color, light3_multiply(surface->highlight, highlight));
}

/**
 * Turns the rays of a packet that met mirrors into mirrored rays (rows A9, C3).
 * @param tracer     The tracer.
 * @param met        What the rays met.
 * @param weight     What the rays weighed.
 * @param[out] mirrored  The mirrored rays; active where they can still change the picture.
 * @param[out] weights   What they weigh.
 * @return How many are active.
 */
static unsigned mirror_rays(const Tracer *tracer, const Encounter *met, const real *weight,
                            Packet *mirrored, real *weights) {
    mirrored->wants_points = true;
    mirrored->lineage = lineage_next(met->packet->lineage);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Light3 mirror = surfaces_gather(met->surfaces, &met->materials[v], met->met[v]).mirror;
        weights[v] = weight[v] * light3_largest(mirror);
        mirrored->active[v] = met->met[v] & (weights[v] >= WEIGHT_CUTOFF);
        if (!any(mirrored->active[v])) {
            continue;
        }
        Vector in = met->packet->rays[v].direction, normal = met->facing[v];
        real along = vector_dot(in, normal);
        // Made one long again each time: else the length drifts by an ulp or two a mirror.
        Vector out = vector_normalize(vector_subtract(in, vector_scale(normal, 2 * along)));
        Vector origin = departure_origin(&tracer->departure, &met->hits[v], out);
        mirrored->rays[v] = ray_of(origin, out);
        mirrored->limit[v] = real_of(INFINITE);
    }
    return packet_count(mirrored);
}

/**
 * Adds what mirrors show.
 * @param tracer  The tracer.
 * @param met     What the rays met.
 * @param weight  What the rays weigh.
 * @param depth   How often they may still be mirrored, at least once.
 * @param[in,out] colors  The rays' colours.
 * @param[in,out] counts  The rays traced.
 */
static void mirrors_add(const Tracer *tracer, const Encounter *met, const real *weight, int depth,
                        Light3 *colors, RayCounts *counts) {
    Packet mirrored;
    real weights[PACKET_VECTORS];
    unsigned count = mirror_rays(tracer, met, weight, &mirrored, weights);
    if (count == 0) {
        return;
    }
    counts->mirror += count;
    Light3 seen[PACKET_VECTORS];
    tracer_follow(tracer, &mirrored, weights, depth - 1, seen, counts);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Light3 mirror = surfaces_gather(met->surfaces, &met->materials[v], met->met[v]).mirror;
        Light3 share = light3_multiply(mirror, seen[v]);
        colors[v] = light3_select(mirrored.active[v], light3_add(colors[v], share), colors[v]);
    }
}

void tracer_follow(const Tracer *tracer, const Packet *packet, const real *weight, int depth,
                   Light3 *colors, RayCounts *counts) {
    Encounter met;
    bool is_any = encounter_find(tracer, packet, &met);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        if (any(mask_not(met.met[v]))) {
            colors[v] = backdrop_color(tracer, packet->rays[v].direction);
        }
    }
    if (tracer->glow.count > 0) {
        glow_show(&tracer->glow, met.hits, colors);
    }
    if (!is_any) {
        return;
    }
    Lighting lighting;
    counts->shadow += lighting_gather(&tracer->list, tracer->lamps, tracer->lamp_count,
                                      &tracer->departure, tracer->shines, &met, &lighting);
    Light3 paint[PACKET_VECTORS];
    if (tracer->textures.worn) {
        textures_paint(&tracer->textures, &tracer->list, &met, paint);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Surfaces surfaces = surfaces_gather(met.surfaces, &met.materials[v], met.met[v]);
        if (tracer->textures.worn) {
            surfaces.body = light3_multiply(surfaces.body, paint[v]);
        }
        Light3 body = body_color(&surfaces, lighting.matt[v], lighting.highlight[v]);
        colors[v] = light3_select(met.met[v], body, colors[v]);
    }
    if (depth > 0) {
        mirrors_add(tracer, &met, weight, depth, colors, counts);
    }
}
