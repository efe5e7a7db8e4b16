/**
 * @file
 * @brief Convoys: the last rays of two packets that go on as one.
 *
 * At glass a packet becomes two, one mirrored and one refracted, and at the next glass four. Few
 * rays are left in each of them, for each has lost those that met something else; but a vector
 * takes as long for one ray as for all its lanes. So the rays of the two are put side by side into
 * one packet where that saves vectors. What a ray meets does not depend on its neighbours: this
 * changes the time, not one bit of the picture.
 */
#ifndef DIOPTRE_TRACE_CONVOY_H
#define DIOPTRE_TRACE_CONVOY_H

#include "trace/media.h"
#include "trace/surface.h"

/** Rays that were turned this often go on without convoys, whose memory would add up on the stack:
 *  few are left by then. */
enum { CONVOY_BOUNCES = 48 };

/** Rays that were gathered. */
typedef struct Convoy {
    Packet packet;                /**< The rays, close together from the first lane on. */
    Media media[PACKET_VECTORS];  /**< What they are inside of. */
    real weights[PACKET_VECTORS]; /**< See #tracer_follow. */
    uint32_t pixels[PACKET_RAYS]; /**< See #Lineage. */
    unsigned count;               /**< How many. */
} Convoy;

/** @return Whether two packets had better go on as one. @param one A packet. @param other Another.
 */
bool convoy_pays(const Packet *one, const Packet *other);

/** Begins a convoy of mirrored and refracted rays. @param[out] convoy The convoy, empty.
 *  @param lineage Whose rays will join. */
void convoy_begin(Convoy *convoy, Lineage lineage);

/**
 * Lets the active rays of a packet join.
 * @param[in,out] convoy  The convoy, with room for them.
 * @param packet   The rays.
 * @param media    What they are inside of.
 * @param weights  What they weigh.
 */
void convoy_join(Convoy *convoy, const Packet *packet, const Media *media, const real *weights);

/** Closes a convoy. @param[in,out] convoy The convoy, not empty; its packet is now ready. */
void convoy_close(Convoy *convoy);

/**
 * Gives a packet what its rays have brought back.
 * @param seen    What the rays of the convoy have.
 * @param first   Which of them is the packet's first.
 * @param packet  The packet.
 * @param[out] colors  What its active rays have.
 * @return Which of the convoy's rays is the first of the packet that joined next.
 */
unsigned convoy_part(const Light3 *seen, unsigned first, const Packet *packet, Light3 *colors);

#endif
