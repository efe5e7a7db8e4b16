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
#ifndef DIOPTRE_TRACE_TRACER_PACKET_MERGE_H
#define DIOPTRE_TRACE_TRACER_PACKET_MERGE_H

#include "trace/glass/interior_list.h"
#include "trace/materials/material.h"

/** Rays that were turned this often go on without convoys, whose memory would add up on the stack:
 *  few are left by then. */
enum { PACKET_MERGE_MAX_BOUNCES = 48 };

/** Rays that were gathered. */
typedef struct PacketMerge {
    Packet packet;                         /**< The rays, close together from the first lane on. */
    InteriorList interior[PACKET_VECTORS]; /**< What they are inside of. */
    real throughputs[PACKET_VECTORS];      /**< See #tracer_trace_packet. */
    uint32_t pixel_ids[PACKET_RAYS];       /**< See #SampleContext. */
    unsigned count;                        /**< How many. */
} PacketMerge;

/** @return Whether two packets had better go on as one. */
bool packet_merge_is_worthwhile(const Packet *one, const Packet *other);

/** Begins a convoy of mirrored and refracted rays. @param context Whose rays will join. */
void packet_merge_begin(PacketMerge *merge, SampleContext context);

/**
 * Lets the active rays of a packet join.
 * @param[in,out] merge  The convoy, with room for them.
 * @param interior  What they are inside of.
 */
void packet_merge_add(PacketMerge *merge, const Packet *packet, const InteriorList *interior,
                      const real *throughputs);

/** Closes a convoy. @param[in,out] merge The convoy, not empty; its packet is now ready. */
void packet_merge_end(PacketMerge *merge);

/**
 * Gives a packet what its rays have brought back.
 * @param incoming  What the rays of the convoy have.
 * @param first  Which of them is the packet's first.
 * @param[out] colors  What its active rays have.
 * @return Which of the convoy's rays is the first of the packet that joined next.
 */
unsigned packet_merge_scatter(const Rgb *incoming, unsigned first, const Packet *packet,
                              Rgb *colors);

#endif
