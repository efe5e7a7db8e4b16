/**
 * @file
 * @brief The recursive tracer: light, shadow, mirrors and glass.
 */
#include "trace/tracer.h"

/** @return What rays that meet nothing see. @param sky The sky. @param direction Unit directions.
 */
static Light3 backdrop_color(const Backdrop *sky, Vector direction) {
    if (!sky->is_gradient) {
        return sky->horizon;
    }
    real height = real_max(direction.y, real_of(0));
    return light3_add(sky->horizon, light3_scale(sky->rise, height));
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
    for (int v = 0; v < PACKET_VECTORS; v++) {
        const Hit *hit = &met->hits[v];
        met->met[v] = met->lit[v] = packet->active[v] & (hit->shape >= integer_of(0));
        mask is_inside = vector_dot(packet->rays[v].direction, hit->normal) > 0;
        met->facing[v] =
            vector_select(is_inside, vector_scale(hit->normal, real_of(-1)), hit->normal);
        met->materials[v] = materials_of(&tracer->list, hit, met->met[v]);
        is_any = is_any || any(met->met[v]);
    }
    return is_any;
}

/**
 * @return What the body of surfaces sends back: all but what is mirrored or let through.
 * @param surface   The surfaces.
 * @param matt      What the lamps give for the matt shine.
 * @param highlight What they give for highlights.
 */
INLINE Light3 body_color(const Surfaces *surface, Light3 matt, Light3 highlight) {
    Light3 light = light3_add(surface->ambient, light3_scale(matt, surface->diffuse));
    Light3 color = light3_add(surface->emission, light3_multiply(surface->body, light));
    return light3_add(color, light3_multiply(surface->highlight, highlight));
}

/** Rays that go on from surfaces, and what they are worth. */
typedef struct Onward {
    Packet packet;                /**< The rays; active where they can still change the picture. */
    real weights[PACKET_VECTORS]; /**< The largest share with which a primary of theirs counts. */
} Onward;

/**
 * Turns the rays of a packet that met mirrors, or glass, into mirrored rays (rows A9, C3).
 * @param tracer     The tracer.
 * @param met        What the rays met.
 * @param crossing   What becomes of them in glass, or NULL.
 * @param weight     What the rays weighed.
 * @param[out] mirrored  The mirrored rays.
 * @return How many are active.
 */
static unsigned mirror_rays(const Tracer *tracer, const Encounter *met, const Crossing *crossing,
                            const real *weight, Onward *mirrored) {
    mirrored->packet.wants_points = true;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Surfaces surfaces = surfaces_gather(met->surfaces, &met->materials[v], met->met[v]);
        Light3 mirror = crossing_mirrored(crossing, v, &surfaces);
        mirrored->weights[v] = weight[v] * light3_largest(mirror);
        mask active = met->met[v] & (mirrored->weights[v] >= tracer->cutoff);
        mirrored->packet.active[v] = active;
        if (!any(active)) {
            continue;
        }
        Vector in = met->packet->rays[v].direction, normal = met->facing[v];
        real along = vector_dot(in, normal);
        // Made one long again each time: else the length drifts by an ulp or two a mirror.
        Vector out = vector_normalize(vector_subtract(in, vector_scale(normal, 2 * along)));
        Vector origin = departure_origin(&tracer->departure, &met->hits[v], out);
        mirrored->packet.rays[v] = ray_of(origin, out);
        mirrored->packet.limit[v] = real_of(INFINITE);
    }
    return packet_count(&mirrored->packet);
}

/**
 * Adds what mirrors show.
 * @param tracer  The tracer.
 * @param met     What the rays met.
 * @param crossing  What becomes of them in glass, or NULL.
 * @param weight  What the rays weigh.
 * @param depth   How often they may still be mirrored, at least once.
 * @param[in,out] colors  The rays' colours.
 * @param[in,out] counts  The rays traced.
 */
static void mirrors_add(const Tracer *tracer, const Encounter *met, const Crossing *crossing,
                        const real *weight, int depth, Light3 *colors, RayCounts *counts) {
    Onward mirrored;
    unsigned count = mirror_rays(tracer, met, crossing, weight, &mirrored);
    if (count == 0) {
        return;
    }
    counts->mirror += count;
    Light3 seen[PACKET_VECTORS];
    tracer_follow(tracer, &mirrored.packet, met->media, mirrored.weights, depth - 1, seen, counts);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Surfaces surfaces = surfaces_gather(met->surfaces, &met->materials[v], met->met[v]);
        Light3 share = light3_multiply(crossing_mirrored(crossing, v, &surfaces), seen[v]);
        mask active = mirrored.packet.active[v];
        colors[v] = light3_select(active, light3_add(colors[v], share), colors[v]);
    }
}

/**
 * Turns the rays of a packet that met glass into refracted rays (row A10).
 * @param tracer    The tracer.
 * @param met       What the rays met.
 * @param crossing  What becomes of them.
 * @param weight    What the rays weighed.
 * @param[out] refracted  The refracted rays.
 * @return How many are active.
 */
static unsigned refract_rays(const Tracer *tracer, const Encounter *met, const Crossing *crossing,
                             const real *weight, Onward *refracted) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Surfaces surfaces = surfaces_gather(met->surfaces, &met->materials[v], met->met[v]);
        Light3 share = crossing_refracted(crossing, v, &surfaces);
        refracted->weights[v] = weight[v] * light3_largest(share);
        mask active = crossing->through[v] & (refracted->weights[v] >= tracer->cutoff);
        refracted->packet.active[v] = active;
        if (any(active)) {
            refracted->packet.rays[v] = ray_of(crossing->origin[v], crossing->direction[v]);
            refracted->packet.limit[v] = real_of(INFINITE);
        }
    }
    return packet_count(&refracted->packet);
}

/**
 * Adds what is seen through glass.
 * @param tracer    The tracer.
 * @param met       What the rays met.
 * @param crossing  What becomes of them.
 * @param weight    What the rays weigh.
 * @param depth     How often they may still be refracted, at least once.
 * @param[in,out] colors  The rays' colours.
 * @param[in,out] counts  The rays traced.
 */
static void glass_add(const Tracer *tracer, const Encounter *met, const Crossing *crossing,
                      const real *weight, int depth, Light3 *colors, RayCounts *counts) {
    Onward refracted;
    unsigned count = refract_rays(tracer, met, crossing, weight, &refracted);
    if (count == 0) {
        return;
    }
    counts->refract += count;
    Light3 seen[PACKET_VECTORS];
    tracer_follow(tracer, &refracted.packet, crossing->media, refracted.weights, depth - 1, seen,
                  counts);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Surfaces surfaces = surfaces_gather(met->surfaces, &met->materials[v], met->met[v]);
        Light3 share = light3_multiply(crossing_refracted(crossing, v, &surfaces), seen[v]);
        mask active = refracted.packet.active[v];
        colors[v] = light3_select(active, light3_add(colors[v], share), colors[v]);
    }
}

/**
 * Finds what the bodies of surfaces send back.
 * @param tracer    The tracer.
 * @param met       The surfaces.
 * @param crossing  What becomes of the rays in glass, or NULL.
 * @param[in,out] colors  The rays' colours, written where they met anything.
 * @return How many shadow rays were traced.
 */
static uint64_t bodies_shade(const Tracer *tracer, const Encounter *met, const Crossing *crossing,
                             Light3 *colors) {
    const Light3 dark = {real_of(0), real_of(0), real_of(0)};
    Lighting lighting;
    uint64_t rays = lighting_gather(&tracer->list, tracer->lamps, tracer->lamp_count,
                                    &tracer->departure, tracer->shines, met, &lighting);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Surfaces surfaces = surfaces_gather(met->surfaces, &met->materials[v], met->met[v]);
        Light3 body = body_color(&surfaces, lighting.matt[v], lighting.highlight[v]);
        if (crossing) {
            body = light3_select(crossing->hidden[v], dark, body);
        }
        colors[v] = light3_select(met->met[v], body, colors[v]);
    }
    return rays;
}

/**
 * As #tracer_follow, from where rays have met something, in a scene with glass.
 * @param tracer  The tracer.
 * @param met     What the rays met.
 * @param weight  What the rays weigh.
 * @param depth   How often they may still be mirrored or refracted.
 * @param[in,out] colors  The rays' colours, written where they met anything.
 * @param[in,out] counts  The rays traced.
 */
static void glass_follow(const Tracer *tracer, Encounter *met, const real *weight, int depth,
                         Light3 *colors, RayCounts *counts) {
    Crossing crossing;
    counts->total +=
        crossing_find(&tracer->glass, &tracer->list, &tracer->departure, met, &crossing);
    counts->shadow += bodies_shade(tracer, met, &crossing, colors);
    if (depth > 0) {
        mirrors_add(tracer, met, &crossing, weight, depth, colors, counts);
        glass_add(tracer, met, &crossing, weight, depth, colors, counts);
    }
}

void tracer_follow(const Tracer *tracer, const Packet *packet, const Media *media,
                   const real *weight, int depth, Light3 *colors, RayCounts *counts) {
    Encounter met;
    bool is_any = encounter_find(tracer, packet, &met);
    met.media = media;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        if (any(mask_not(met.met[v]))) {
            colors[v] = backdrop_color(&tracer->backdrop, packet->rays[v].direction);
        }
    }
    if (!is_any) {
        return;
    }
    if (media) {
        glass_follow(tracer, &met, weight, depth, colors, counts);
        return;
    }
    counts->shadow += bodies_shade(tracer, &met, NULL, colors);
    if (depth > 0) {
        mirrors_add(tracer, &met, NULL, weight, depth, colors, counts);
    }
}
