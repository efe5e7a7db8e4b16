/**
 * @file
 * @brief Light and shadow.
 */
#include "trace/filter.h"
#include "trace/lamp.h"
#include "trace/probe.h"
#include "trace/survey.h"
#include "trace/trail.h"

/**
 * @return max(0, r . v)^shininess, Phong's highlight, where r is the lamp's light mirrored.
 * @param met      The points.
 * @param v        Which vector of them.
 * @param to_lamp  Unit directions to the lamp.
 * @param cosine   n . l
 * @param shininess  The exponent.
 */
INLINE real highlight(const Encounter *met, int v, Vector to_lamp, real cosine, real shininess) {
    Vector mirrored = vector_subtract(vector_scale(met->facing[v], 2 * cosine), to_lamp);
    real along = real_max(-vector_dot(mirrored, met->packet->rays[v].direction), real_of(0));
    return surface_power(real_min(along, real_of(1)), shininess);
}

/** @return The light of a lamp that reaches points, but for its distance. @param lamp The lamp.
 *  @param shine What it would give. @param v Which vector of points. @param met The points. */
INLINE Light3 shine_light(const Lamp *lamp, const Shine *shine, int v, const Encounter *met) {
    return met->media ? light3_multiply(lamp->light, shine->visible[v]) : lamp->light;
}

/**
 * Adds one lamp's highlights, where the surface has any.
 * @param lamp     The lamp.
 * @param shine    What it would give.
 * @param v        Which vector of points.
 * @param reached  The points that it reaches.
 * @param share    What is left of its light at that distance.
 * @param met      The points.
 * @param[in,out] lighting  The sums.
 */
INLINE void highlight_add(const Lamp *lamp, const Shine *shine, int v, mask reached, real share,
                          const Encounter *met, Lighting *lighting) {
    Surfaces surfaces = surfaces_gather(met->surfaces, &met->materials[v], reached);
    mask shiny = reached & (light3_largest(surfaces.highlight) > real_of(0));
    if (any(shiny)) {
        Vector to_lamp = lamp_direction(lamp, shine, v, met->hits[v].point);
        real bright = highlight(met, v, to_lamp, shine->cosine[v], surfaces.shininess);
        bright = real_select(shiny, share * bright, real_of(0));
        lighting->highlight[v] = light3_add(lighting->highlight[v],
                                            light3_scale(shine_light(lamp, shine, v, met), bright));
    }
}

/**
 * Adds what one lamp gives to the points that it reaches.
 * @param lamp     The lamp.
 * @param shine    What it would give, with the rays.
 * @param blocked  Where something is in the way.
 * @param shines   Whether highlights are wanted.
 * @param met      The points.
 * @param[in,out] lighting  The sums.
 */
INLINE void shine_add(const Lamp *lamp, const Shine *shine, const mask *blocked, bool shines,
                      const Encounter *met, Lighting *lighting) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask reached = shine->shadow.active[v] & mask_not(blocked[v]);
        if (!any(reached)) {
            continue;
        }
        real share = lamp_share(lamp, shine, v);
        real bright = real_select(reached, share * shine->cosine[v], real_of(0));
        lighting->matt[v] =
            light3_add(lighting->matt[v], light3_scale(shine_light(lamp, shine, v, met), bright));
        if (shines) {
            highlight_add(lamp, shine, v, reached, share, met, lighting);
        }
    }
}

/** Leaves points without light. @param[out] lighting What they get. */
INLINE void lighting_clear(Lighting *lighting) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Light3 dark = {real_of(0), real_of(0), real_of(0)};
        lighting->matt[v] = lighting->highlight[v] = dark;
    }
}

/**
 * Notes the shadow rays to a lamp; for a probe, with what this lamp alone gives. Never a part of
 * its caller, which is called for every picture.
 * @param list     The shapes.
 * @param lamps    The lamps.
 * @param number   Which of them.
 * @param shine    What it would give, with the rays.
 * @param blocked  Where something is in the way.
 * @param shines   Whether highlights are wanted.
 * @param met      The points.
 */
static __attribute__((noinline)) void shine_note(const ShapeList *list, const Lamp *lamps,
                                                 size_t number, const Shine *shine,
                                                 const mask *blocked, bool shines,
                                                 const Encounter *met) {
    const Notes *notes = met->packet->lineage.notes;
    if (notes->trails) {
        trail_shadows(met, &shine->shadow, blocked, met->media ? shine->visible : NULL);
    }
    if (notes->survey) {
        survey_shadows(met, number, &shine->shadow, blocked);
    }
    if (notes->probe) {
        Lighting alone;
        lighting_clear(&alone);
        shine_add(&lamps[number], shine, blocked, shines, met, &alone);
        probe_shadow(list, met, number, shine, blocked[0], &alone);
    }
}

uint64_t lighting_gather(const ShapeList *list, const Lamp *lamps, size_t lamp_count,
                         const Departure *departure, bool shines, const Encounter *met,
                         Lighting *lighting) {
    uint64_t rays = 0;
    lighting_clear(lighting);
    for (size_t i = 0; i < lamp_count; i++) {
        Shine shine;
        mask blocked[PACKET_VECTORS];
        lamp_aim(&lamps[i], i, departure, met, &shine);
        unsigned count = packet_count(&shine.shadow);
        if (count > 0) {
            shape_list_blocked(met->media ? &met->glass->opaque : list, &shine.shadow, blocked);
            if (met->media) {
                filter_shadows(list, departure, met, &shine.shadow, blocked, shine.visible);
            }
            if (met->packet->lineage.notes) {
                shine_note(list, lamps, i, &shine, blocked, shines, met);
            }
            shine_add(&lamps[i], &shine, blocked, shines, met, lighting);
            rays += count;
        }
    }
    return rays;
}
