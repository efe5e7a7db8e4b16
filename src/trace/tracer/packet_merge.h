/**
 * @file
 * @brief Packet merging (stream compaction): two sparse packets become one dense packet.
 *
 * At a transparent surface a packet becomes two, one reflected and one refracted, and each of them
 * becomes two again. Their rays get fewer, but a vector costs the same for one ray as for LANES.
 * So the active rays of both packets are moved into one packet where that saves vectors. A ray's
 * result does not depend on the other lanes: merging changes the time, and not one bit of the
 * image.
 */
#ifndef DIOPTRE_TRACE_TRACER_PACKET_MERGE_H
#define DIOPTRE_TRACE_TRACER_PACKET_MERGE_H

#include "trace/glass/interior_list.h"

/** Rays of more bounces are not merged: the merged packets of all levels of the recursion are on
 *  the stack, and few rays are left at this depth. */
enum { PACKET_MERGE_MAX_BOUNCES = 48 };

/** A packet made of the active rays of two packets. */
typedef struct PacketMerge {
    RayState rays; /**< The rays: first those of one packet, then those of the other, without gaps.
                    */
    InteriorList interior[PACKET_VECTORS]; /**< The shapes that they are inside of. */
    uint32_t pixel_ids[PACKET_RAYS];       /**< See #SampleContext. */
    unsigned count;                        /**< Number of rays. */
} PacketMerge;

/** @return Whether it is faster to trace two packets as one. */
bool packet_merge_is_worthwhile(const Packet *one, const Packet *other);

/**
 * Merges two packets.
 * @param[out] merge  The merged packet; it contains pointers into itself.
 * @param one  Rays with interior lists.
 * @param other  Rays with interior lists, of the same context; #PACKET_RAYS at most in all, and at
 *         least one.
 */
void packet_merge_init(PacketMerge *merge, const RayState *one, const RayState *other);

/**
 * Copies colours and losses of a merged packet back to the lanes of one of its two packets.
 * @param merged_colors  The colours of the merged packet.
 * @param merged_losses  Its losses.
 * @param first  Index of the packet's first ray in the merged packet.
 * @param packet  The packet as it was merged.
 * @param[out] colors  The colours of its active rays.
 * @param[out] losses  Their losses.
 * @return The index behind the packet's last ray.
 */
unsigned packet_merge_scatter(const Rgb *merged_colors, const Losses *merged_losses, unsigned first,
                              const Packet *packet, Rgb *colors, Losses *losses);

#endif
