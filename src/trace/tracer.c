/**
 * @file
 * @brief The recursive tracer: light, shadow, mirrors and glass (Whitted, *An
 *        Improved Illumination Model for Shaded Display*, 1980).
 */
#include "trace/tracer.h"

#include "trace/convoy.h"
#include "trace/probe.h"
#include "trace/survey.h"
#include "trace/trail.h"

/** @return What rays that meet nothing see. @param tracer The tracer. @param direction Unit
 *  directions. @param lanes The rays that count. */
static Light3 backdrop_color(const Tracer *tracer, Vector direction, mask lanes) {
    const Backdrop *sky = &tracer->backdrop;
    if (tracer->textures.sky) {
        return textures_panorama(&tracer->textures, direction, lanes);
    }
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
    if (tracer->glow.count > 0) {
        glow_nearest(&tracer->glow, packet, met->hits);
    }
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
    ProbeKind kind;                /**< What they are, for who notes them. */
    Packet packet;                 /**< The rays; active where they can still change the picture. */
    Light3 shares[PACKET_VECTORS]; /**< Of what they bring back, that the surfaces send on. */
    real weights[PACKET_VECTORS];  /**< The largest share with which a primary of theirs counts. */
} Onward;

/** Weighs rays that could go on, and drops those that cannot change the picture. @param tracer The
 *  tracer. @param v Which vector. @param lanes Those that could. @param share Of what they bring
 *  back. @param weight What the rays before them weighed. @param[out] onward The rays.
 *  @return Those that go on. */
INLINE mask onward_weigh(const Tracer *tracer, int v, mask lanes, Light3 share, real weight,
                         Onward *onward) {
    onward->shares[v] = share;
    onward->weights[v] = weight * light3_largest(share);
    return onward->packet.active[v] = lanes & (onward->weights[v] >= tracer->cutoff);
}

/**
 * Turns the rays of a packet that met mirrors, or glass, into mirrored rays (rows A9, C3).
 * @param tracer     The tracer.
 * @param met        What the rays met.
 * @param crossing   What becomes of them in glass, or NULL.
 * @param weight     What the rays weighed.
 * @param[out] mirrored  The mirrored rays.
 */
INLINE void mirror_rays(const Tracer *tracer, const Encounter *met, const Crossing *crossing,
                        const real *weight, Onward *mirrored) {
    mirrored->kind = PROBE_MIRROR;
    mirrored->packet.wants_points = true;
    mirrored->packet.lineage = lineage_next(met->packet->lineage);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Surfaces surfaces = surfaces_gather(met->surfaces, &met->materials[v], met->met[v]);
        Light3 share = crossing_mirrored(crossing, v, &surfaces);
        if (!any(onward_weigh(tracer, v, met->met[v], share, weight[v], mirrored))) {
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
}

/**
 * Turns the rays of a packet that met glass into refracted rays (row A10).
 * @param tracer    The tracer.
 * @param met       What the rays met.
 * @param crossing  What becomes of them.
 * @param weight    What the rays weighed.
 * @param[out] refracted  The refracted rays.
 */
INLINE void refract_rays(const Tracer *tracer, const Encounter *met, const Crossing *crossing,
                         const real *weight, Onward *refracted) {
    refracted->kind = PROBE_REFRACT;
    refracted->packet.wants_points = true;
    refracted->packet.lineage = lineage_next(met->packet->lineage);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Surfaces surfaces = surfaces_gather(met->surfaces, &met->materials[v], met->met[v]);
        Light3 share = crossing_refracted(crossing, v, &surfaces);
        if (any(onward_weigh(tracer, v, crossing->through[v], share, weight[v], refracted))) {
            refracted->packet.rays[v] = ray_of(crossing->origin[v], crossing->direction[v]);
            refracted->packet.limit[v] = real_of(INFINITE);
        }
    }
}

/** Adds what rays that went on from surfaces have brought back. @param onward The rays.
 *  @param seen What they saw. @param[in,out] colors The colours of the rays before them. */
INLINE void onward_add(const Onward *onward, const Light3 *seen, Light3 *colors) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Light3 sum = light3_add(colors[v], light3_multiply(onward->shares[v], seen[v]));
        colors[v] = light3_select(onward->packet.active[v], sum, colors[v]);
    }
}

/**
 * Follows rays that go on from surfaces, and adds what they bring back.
 * @param tracer  The tracer.
 * @param onward  The rays.
 * @param media   What they are inside of; NULL: the scene has no glass.
 * @param depth   How often they may still be mirrored or refracted.
 * @param[in,out] colors  The colours of the rays before them.
 * @param[in,out] counts  The rays traced.
 */
INLINE void onward_follow(const Tracer *tracer, const Onward *onward, const Media *media, int depth,
                          Light3 *colors, RayCounts *counts) {
    Light3 seen[PACKET_VECTORS];
    Probe *probe = lineage_probe(&onward->packet.lineage);
    if (probe) {
        probe_send(probe, onward->kind, &onward->packet, onward->shares[0], onward->weights[0]);
    }
    tracer_follow(tracer, &onward->packet, media, onward->weights, depth, seen, counts);
    if (probe) {
        probe_return(probe, seen[0]);
    }
    onward_add(onward, seen, colors);
}

/**
 * Adds what mirrors show, in a scene without glass.
 * @param tracer    The tracer.
 * @param met       What the rays met.
 * @param weight    What the rays weigh.
 * @param depth     How often they may still be mirrored, at least once.
 * @param[in,out] colors  The rays' colours.
 * @param[in,out] counts  The rays traced.
 */
INLINE void mirrors_add(const Tracer *tracer, const Encounter *met, const real *weight, int depth,
                        Light3 *colors, RayCounts *counts) {
    Onward mirrored;
    mirror_rays(tracer, met, NULL, weight, &mirrored);
    unsigned count = packet_count(&mirrored.packet);
    if (count > 0) {
        counts->mirror += count;
        onward_follow(tracer, &mirrored, NULL, depth - 1, colors, counts);
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
INLINE uint64_t bodies_shade(const Tracer *tracer, const Encounter *met, const Crossing *crossing,
                             Light3 *colors) {
    const Light3 dark = {real_of(0), real_of(0), real_of(0)};
    Lighting lighting;
    uint64_t rays = lighting_gather(&tracer->list, tracer->lamps, tracer->lamp_count,
                                    &tracer->departure, tracer->shines, met, &lighting);
    Light3 paint[PACKET_VECTORS];
    if (tracer->textures.worn) {
        textures_paint(&tracer->textures, &tracer->list, met, paint);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Surfaces surfaces = surfaces_gather(met->surfaces, &met->materials[v], met->met[v]);
        if (tracer->textures.worn) {
            surfaces.body = light3_multiply(surfaces.body, paint[v]);
        }
        Light3 body = body_color(&surfaces, lighting.matt[v], lighting.highlight[v]);
        if (crossing) {
            body = light3_select(crossing->hidden[v], dark, body);
        }
        colors[v] = light3_select(met->met[v], body, colors[v]);
    }
    if (lineage_probe(&met->packet->lineage)) {
        probe_body(met, crossing, tracer->textures.worn ? paint : NULL, colors[0]);
    }
    return rays;
}

/** Notes what rays have met. Never a part of its caller, which is called for every picture.
 *  @param met The surfaces; something is noted of their packet. @param departure How rays leave
 *  them. */
static __attribute__((noinline)) void surfaces_note(const Encounter *met,
                                                    const Departure *departure) {
    const Notes *notes = met->packet->lineage.notes;
    if (notes->trails) {
        trail_surfaces(met);
    }
    if (notes->survey) {
        survey_surfaces(met);
    }
    if (notes->probe) {
        probe_surface(met, departure);
    }
}

/**
 * Finds what rays meet, and the colours of those that meet nothing.
 * @param tracer  The tracer.
 * @param packet  The rays.
 * @param media   What they are inside of, or NULL.
 * @param[out] met     What they met.
 * @param[out] colors  Their colours, where they met nothing.
 * @return Whether any ray met anything.
 */
INLINE bool follow_to_surfaces(const Tracer *tracer, const Packet *packet, const Media *media,
                               Encounter *met, Light3 *colors) {
    bool is_any = encounter_find(tracer, packet, met);
    met->glass = &tracer->glass;
    met->media = media;
    if (packet->lineage.notes) {
        surfaces_note(met, &tracer->departure);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask missed = packet->active[v] & mask_not(met->met[v]);
        if (any(missed)) {
            colors[v] = backdrop_color(tracer, packet->rays[v].direction, missed);
        }
    }
    if (tracer->glow.count > 0) {
        glow_show(&tracer->glow, met->hits, colors);
    }
    return is_any;
}

/** As #tracer_follow, in a scene without glass. @param tracer The tracer. @param packet The rays.
 *  @param weight What they weigh. @param depth How often they may still be mirrored.
 *  @param[out] colors Their colours. @param[in,out] counts The rays traced. */
static void follow_in_air(const Tracer *tracer, const Packet *packet, const real *weight, int depth,
                          Light3 *colors, RayCounts *counts) {
    Encounter met;
    if (!follow_to_surfaces(tracer, packet, NULL, &met, colors)) {
        return;
    }
    counts->shadow += bodies_shade(tracer, &met, NULL, colors);
    if (depth > 0) {
        mirrors_add(tracer, &met, weight, depth, colors, counts);
    }
}

/** Rays that glass parts. */
typedef struct Parting {
    Onward mirrored;              /**< Those that stay on this side. */
    Onward refracted;             /**< Those that go on behind the surface. */
    Media behind[PACKET_VECTORS]; /**< What those are inside of. */
} Parting;

/**
 * Finds the colours of what rays meet in a scene with glass, and the rays that go on. Never a part
 * of its caller: what it needs is off the stack before those rays are followed.
 * @param tracer  The tracer.
 * @param packet  The rays.
 * @param media   What they are inside of.
 * @param weight  What they weigh.
 * @param depth   How often they may still be mirrored or refracted.
 * @param[out] colors      Their colours, without what the rays that go on bring back.
 * @param[in,out] counts   The rays traced.
 * @param[out] parting     The rays that go on.
 * @return Whether any may.
 */
static __attribute__((noinline)) bool glass_part(const Tracer *tracer, const Packet *packet,
                                                 const Media *media, const real *weight, int depth,
                                                 Light3 *colors, RayCounts *counts,
                                                 Parting *parting) {
    Encounter met;
    Crossing crossing;
    if (!follow_to_surfaces(tracer, packet, media, &met, colors)) {
        return false;
    }
    counts->total += crossing_find(&tracer->glass, &tracer->departure, &met, &crossing);
    if (lineage_probe(&packet->lineage)) {
        probe_crossing(&met, &crossing);
    }
    counts->shadow += bodies_shade(tracer, &met, &crossing, colors);
    if (depth == 0) {
        return false;
    }
    mirror_rays(tracer, &met, &crossing, weight, &parting->mirrored);
    refract_rays(tracer, &met, &crossing, weight, &parting->refracted);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        parting->behind[v] = crossing.media[v];
    }
    return true;
}

/**
 * Follows mirrored and refracted rays side by side in one packet, and adds what they bring back.
 * Never a part of its caller: see #CONVOY_BOUNCES.
 * @param tracer   The tracer.
 * @param parting  The rays.
 * @param media    What the mirrored ones are inside of.
 * @param depth    How often they may still be mirrored or refracted.
 * @param[in,out] colors  The colours of the rays before them.
 * @param[in,out] counts  The rays traced.
 */
static __attribute__((noinline)) void convoy_follow(const Tracer *tracer, const Parting *parting,
                                                    const Media *media, int depth, Light3 *colors,
                                                    RayCounts *counts) {
    const Onward *mirrored = &parting->mirrored, *refracted = &parting->refracted;
    Convoy convoy;
    Light3 seen[PACKET_VECTORS], own[PACKET_VECTORS];
    convoy_begin(&convoy, mirrored->packet.lineage);
    convoy_join(&convoy, &mirrored->packet, media, mirrored->weights);
    convoy_join(&convoy, &refracted->packet, parting->behind, refracted->weights);
    convoy_close(&convoy);
    tracer_follow(tracer, &convoy.packet, convoy.media, convoy.weights, depth, seen, counts);
    unsigned next = convoy_part(seen, 0, &mirrored->packet, own);
    onward_add(mirrored, own, colors);
    convoy_part(seen, next, &refracted->packet, own);
    onward_add(refracted, own, colors);
}

/** As #tracer_follow, in a scene with glass. @param tracer The tracer. @param packet The rays.
 *  @param media What they are inside of. @param weight What they weigh. @param depth How often they
 *  may still be mirrored or refracted. @param[out] colors Their colours.
 *  @param[in,out] counts The rays traced. */
static void follow_in_glass(const Tracer *tracer, const Packet *packet, const Media *media,
                            const real *weight, int depth, Light3 *colors, RayCounts *counts) {
    Parting parting;
    if (!glass_part(tracer, packet, media, weight, depth, colors, counts, &parting)) {
        return;
    }
    const Onward *mirrored = &parting.mirrored, *refracted = &parting.refracted;
    unsigned back = packet_count(&mirrored->packet), through = packet_count(&refracted->packet);
    counts->mirror += back;
    counts->refract += through;
    if (convoy_pays(&mirrored->packet, &refracted->packet)) {
        convoy_follow(tracer, &parting, media, depth - 1, colors, counts);
        return;
    }
    if (back > 0) {
        onward_follow(tracer, mirrored, media, depth - 1, colors, counts);
    }
    if (through > 0) {
        onward_follow(tracer, refracted, parting.behind, depth - 1, colors, counts);
    }
}

void tracer_follow(const Tracer *tracer, const Packet *packet, const Media *media,
                   const real *weight, int depth, Light3 *colors, RayCounts *counts) {
    if (media) {
        follow_in_glass(tracer, packet, media, weight, depth, colors, counts);
    } else {
        follow_in_air(tracer, packet, weight, depth, colors, counts);
    }
}
