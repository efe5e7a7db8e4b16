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
 * Aims a jump over a surface, backwards: from where rays behind it start to where those before it
 * do.
 * @param far    See #departure_far.
 * @param met    What the rays met.
 * @param v      Which vector of them.
 * @param lanes  The lanes that jump.
 * @param[in,out] jumps  The jumps.
 */
INLINE void jump_aim(real far, const Encounter *met, int v, mask lanes, Packet *jumps) {
    Vector point = met->hits[v].point, facing = met->facing[v];
    Vector before = vector_add(point, vector_scale(facing, far));
    Vector behind = vector_add(point, vector_scale(facing, -THROUGH_BOUNDS * far));
    jumps->rays[v] = ray_of(behind, vector_subtract(before, behind));
    jumps->active[v] = lanes & (far > 0);
    jumps->limit[v] = real_of(1);
}

/**
 * Notes which side of their surface rays come from. Whoever leaves a shape was inside, whoever
 * enters it was not, whatever has been noted before.
 * @param met    What the rays met.
 * @param v      Which vector of them.
 * @param lanes  The lanes that met a transparent surface.
 * @param[out] before  Place of the medium on this side.
 * @param[out] behind  The media on the other.
 */
INLINE void media_cross(const Encounter *met, int v, mask lanes, integer *before, Media *behind) {
    const Hit *hit = &met->hits[v];
    mask leaves = vector_dot(met->packet->rays[v].direction, hit->normal) > 0;
    mask leaving = lanes & leaves, entering = lanes & mask_not(leaves);
    Media here = met->media[v];
    media_enter(&here, leaving, hit->shape);
    media_leave(&here, entering, hit->shape);
    *before = media_place(&here);
    *behind = met->media[v];
    media_leave(behind, leaving, hit->shape);
    media_enter(behind, entering, hit->shape);
}

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
            jump_aim(far, met, v, through, &approach->jumps);
            media_cross(met, v, through, &approach->before[v], &crossing->media[v]);
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

unsigned crossing_find(const Glass *glass, const ShapeList *list, const Departure *departure,
                       Encounter *met, Crossing *crossing) {
    Approach approach;
    unsigned total = 0;
    if (crossing_approach(departure, met, &approach, crossing) == 0) {
        return 0;
    }
    if (packet_count(&approach.jumps) > 0) {
        glass_jump(glass, list, &approach.jumps, crossing->media);
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
