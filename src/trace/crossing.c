/**
 * @file
 * @brief What becomes of rays at transparent surfaces.
 */
#include "trace/crossing.h"

#include "trace/refraction.h"

/** What is known of transparent surfaces before what is behind them is. */
typedef struct Approach {
    Packet jumps;                   /**< From behind the surface back to before it. */
    integer before[PACKET_VECTORS]; /**< Place of the medium before the surface. */
} Approach;

/**
 * Finds which rays met transparent surfaces, and aims their jumps.
 * @param departure  How rays leave a surface.
 * @param met        What the rays met.
 * @param[out] approach  The jumps.
 * @param[out] crossing  The lanes, and the media behind.
 * @return How many lanes.
 */
static unsigned crossing_approach(const Departure *departure, const Encounter *met,
                                  Approach *approach, Crossing *crossing) {
    unsigned count = 0;
    approach->jumps.wants_points = true;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Surfaces surfaces = surfaces_gather(met->surfaces, &met->materials[v], met->met[v]);
        mask through = met->met[v] & (light3_largest(surfaces.through) > 0);
        crossing->through[v] = through;
        crossing->hidden[v] = mask_of(false);
        crossing->mirrored[v] = real_of(0);
        approach->jumps.active[v] = mask_of(false);
        approach->jumps.limit[v] = real_of(0);
        if (any(through)) {
            count += mask_count(through);
            real far = departure_far(departure, &met->hits[v]);
            const Hit *hit = &met->hits[v];
            jump_aim(far, hit, met->facing[v], through, v, &approach->jumps);
            crossing->media[v] = met->media[v];
            approach->before[v] =
                media_cross(&crossing->media[v], &met->packet->rays[v], hit, through);
        }
    }
    return count;
}

/**
 * Bends rays where the medium changes.
 * @param glass      What the scene has of glass.
 * @param departure  How rays leave a surface.
 * @param met        What the rays met.
 * @param v          Which vector of them.
 * @param before     Place of the medium before the surface.
 * @param[in,out] crossing  What becomes of them; the media behind are there.
 * @return The lanes that are reflected totally.
 */
INLINE mask crossing_bend(const Glass *glass, const Departure *departure, const Encounter *met,
                          int v, integer before, Crossing *crossing) {
    const Hit *hit = &met->hits[v];
    mask lanes = crossing->through[v];
    integer behind = media_place(&crossing->media[v]);
    real far = departure_far(departure, hit);
    Refraction bend =
        refraction_of(met->packet->rays[v].direction, met->facing[v], glass_index(glass, before),
                      glass_index(glass, behind), far / hit->distance);
    Vector onward = vector_scale(met->facing[v], real_of(-1));
    real way = departure_way(far, bend.cosine, real_of(1));
    crossing->origin[v] = departure_through(hit, far, onward, bend.direction, bend.cosine, way);
    crossing->direction[v] = bend.direction;
    crossing->hidden[v] = lanes & (before == behind);
    crossing->mirrored[v] = real_select(lanes, bend.mirrored, real_of(0));
    crossing->through[v] = lanes & mask_not(bend.is_total);
    return lanes & bend.is_total;
}

/** @return The points of a vector that ask for light: those with a body. @param met The points.
 *  @param v Which vector. @param hidden Those whose surface is not there. */
INLINE mask lit_lanes(const Encounter *met, int v, mask hidden) {
    Surfaces surfaces = surfaces_gather(met->surfaces, &met->materials[v], met->met[v]);
    real most = real_max(light3_largest(surfaces.body), light3_largest(surfaces.highlight));
    return met->lit[v] & mask_not(hidden) & (most > 0);
}

unsigned crossing_find(const Glass *glass, const Departure *departure, Encounter *met,
                       Crossing *crossing) {
    Approach approach;
    unsigned total = 0;
    if (crossing_approach(departure, met, &approach, crossing) == 0) {
        return 0;
    }
    if (packet_count(&approach.jumps) > 0) {
        glass_jump(glass, &approach.jumps, crossing->media);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        if (any(crossing->through[v])) {
            total +=
                mask_count(crossing_bend(glass, departure, met, v, approach.before[v], crossing));
        }
        met->lit[v] = lit_lanes(met, v, crossing->hidden[v]);
    }
    return total;
}
