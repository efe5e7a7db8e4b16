/**
 * @file
 * @brief Crossings: what becomes of a packet of rays at the transparent surfaces that it has met.
 */
#ifndef DIOPTRE_TRACE_CROSSING_H
#define DIOPTRE_TRACE_CROSSING_H

#include "trace/lighting.h"

/** What becomes of rays at transparent surfaces. */
typedef struct Crossing {
    mask through[PACKET_VECTORS];     /**< The rays that go on behind the surface. */
    mask hidden[PACKET_VECTORS];      /**< Those whose surface is not there: a later shape is. */
    real mirrored[PACKET_VECTORS];    /**< Fresnel's share of what is not the body's; else 0. */
    Vector origin[PACKET_VECTORS];    /**< Where the rays behind the surface start. */
    Vector direction[PACKET_VECTORS]; /**< Which way they go, one long. */
    Media media[PACKET_VECTORS];      /**< What they are inside of. */
} Crossing;

/**
 * Finds what becomes of rays at transparent surfaces.
 * @param glass      What the scene has of glass.
 * @param departure  How rays leave a surface.
 * @param[in,out] met  What the rays met; points that ask for no light are taken out of `lit`.
 * @param[out] crossing  What becomes of them.
 * @return How many are reflected totally.
 */
unsigned crossing_find(const Glass *glass, const Departure *departure, Encounter *met,
                       Crossing *crossing);

/**
 * @return The share of what rays bring back that is mirrored: R + T F; nothing where the surface is
 *         not there.
 * @param crossing  What becomes of the rays; NULL: there is no glass.
 * @param v         Which vector of them.
 * @param surfaces  What they met.
 */
INLINE Light3 crossing_mirrored(const Crossing *crossing, int v, const Surfaces *surfaces) {
    if (!crossing) {
        return surfaces->mirror;
    }
    Light3 fresnel = light3_scale(surfaces->through, crossing->mirrored[v]);
    Light3 nothing = {real_of(0), real_of(0), real_of(0)};
    return light3_select(crossing->hidden[v], nothing, light3_add(surfaces->mirror, fresnel));
}

/**
 * @return The share that comes from behind the surface: T (1 - F); all where the surface is not
 *         there.
 * @param crossing  What becomes of the rays.
 * @param v         Which vector of them.
 * @param surfaces  What they met.
 */
INLINE Light3 crossing_refracted(const Crossing *crossing, int v, const Surfaces *surfaces) {
    Light3 all = {real_of(1), real_of(1), real_of(1)};
    Light3 share = light3_scale(surfaces->through, 1 - crossing->mirrored[v]);
    return light3_select(crossing->hidden[v], all, share);
}

#endif
