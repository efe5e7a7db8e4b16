/**
 * @file
 * @brief Packet merging.
 */
#include "trace/tracer/packet_merge.h"

/** Where a ray is in a packet: a lane of a vector. */
typedef struct LaneSlot {
    unsigned vector; /**< Index of the vector. */
    int lane;        /**< Index of the lane. */
} LaneSlot;

/** @return The slot of the ray with an index, counted from the first lane of the first vector. */
static LaneSlot lane_slot_of(unsigned index) {
    return (LaneSlot){index / LANES, (int)(index % LANES)};
}

/** @return The number of vectors with active rays. */
static unsigned packet_vectors_used(const Packet *packet) {
    unsigned used = 0;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        used += any(packet->active[v]);
    }
    return used;
}

bool packet_merge_is_worthwhile(const Packet *one, const Packet *other) {
    unsigned rays = packet_active_count(one) + packet_active_count(other);
    unsigned before = packet_vectors_used(one) + packet_vectors_used(other),
             after = (rays + LANES - 1) / LANES;
    // Incoherent rays take longer per vector: to save a quarter of the vectors pays (measured).
    // Recorders identify rays by their lanes, so recorded rays stay in their lanes.
    return LANES > 1 && !one->context.recorders &&
           one->context.bounce <= PACKET_MERGE_MAX_BOUNCES && rays > 0 && rays <= PACKET_RAYS &&
           4 * after <= 3 * before;
}

/** Copies a lane. */
INLINE void real_copy_lane(real *to, int slot, const real *from, int lane) {
    real_set_lane(to, slot, real_at(from, lane));
}

/** Copies a lane. */
INLINE void vec3_copy_lane(Vec3 *to, int slot, const Vec3 *from, int lane) {
    real_copy_lane(&to->x, slot, &from->x, lane);
    real_copy_lane(&to->y, slot, &from->y, lane);
    real_copy_lane(&to->z, slot, &from->z, lane);
}

/** Copies a lane. */
INLINE void rgb_copy_lane(Rgb *to, int slot, const Rgb *from, int lane) {
    real_copy_lane(&to->red, slot, &from->red, lane);
    real_copy_lane(&to->green, slot, &from->green, lane);
    real_copy_lane(&to->blue, slot, &from->blue, lane);
}

/** Copies what a ray lacks. */
INLINE void losses_copy_lane(Losses *to, int v, int lane, const Losses *from, LaneSlot slot) {
    real_copy_lane(&to->dropped[v], lane, &from->dropped[slot.vector], slot.lane);
    real_copy_lane(&to->guarded[v], lane, &from->guarded[slot.vector], slot.lane);
    real_copy_lane(&to->rays[v], lane, &from->rays[slot.vector], slot.lane);
}

/** Copies a ray. */
INLINE void ray_copy_lane(Ray *to, int slot, const Ray *from, int lane) {
    vec3_copy_lane(&to->origin, slot, &from->origin, lane);
    vec3_copy_lane(&to->direction, slot, &from->direction, lane);
    vec3_copy_lane(&to->inverse_direction, slot, &from->inverse_direction, lane);
}

/** Copies the list of one ray. */
INLINE void interior_list_copy_lane(InteriorList *to, int slot, const InteriorList *from,
                                    int lane) {
    for (int i = 0; i < INTERIOR_LIST_CAPACITY; i++) {
        integer_set_lane(&to->shapes[i], slot, integer_at(&from->shapes[i], lane));
    }
}

/** Appends the active rays of a packet. */
static void packet_merge_append(PacketMerge *merge, const RayState *rays) {
    const Packet *packet = &rays->packet;
    const uint32_t *pixel_ids = packet->context.pixel_ids;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        for (unsigned remaining = mask_bits(packet->active[v]); remaining;
             remaining &= remaining - 1) {
            int lane = __builtin_ctz(remaining);
            LaneSlot slot = lane_slot_of(merge->count);
            ray_copy_lane(&merge->rays.packet.rays[slot.vector], slot.lane, &packet->rays[v], lane);
            interior_list_copy_lane(&merge->interior[slot.vector], slot.lane, &rays->interior[v],
                                    lane);
            real_copy_lane(&merge->rays.throughput[slot.vector], slot.lane, &rays->throughput[v],
                           lane);
            integer_set_lane(&merge->rays.turns[slot.vector], slot.lane,
                             integer_at(&rays->turns[v], lane));
            merge->pixel_ids[merge->count++] = pixel_ids ? pixel_ids[v * LANES + lane] : 0;
        }
    }
}

/** Fills the unused lanes of the last vector with its first ray, which is safe to compute with. */
static void packet_merge_pad(PacketMerge *merge) {
    for (unsigned index = merge->count; index % LANES; index++) {
        LaneSlot slot = lane_slot_of(index);
        Ray *rays = &merge->rays.packet.rays[slot.vector];
        InteriorList *interior = &merge->interior[slot.vector];
        ray_copy_lane(rays, slot.lane, rays, 0);
        interior_list_copy_lane(interior, slot.lane, interior, 0);
        real_set_lane(&merge->rays.throughput[slot.vector], slot.lane, 0);
        integer_set_lane(&merge->rays.turns[slot.vector], slot.lane, 0);
        merge->pixel_ids[index] = 0;
    }
}

void packet_merge_init(PacketMerge *merge, const RayState *one, const RayState *other) {
    Packet *packet = &merge->rays.packet;
    merge->count = 0;
    merge->rays.interior = merge->interior;
    packet->wants_points = true;
    packet->context = one->packet.context;
    if (packet->context.pixel_ids) {
        packet->context.pixel_ids = merge->pixel_ids;
    }
    packet_merge_append(merge, one);
    packet_merge_append(merge, other);
    packet_merge_pad(merge);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        int left = (int)merge->count - v * LANES;
        packet->active[v] = left >= LANES ? mask_of(true)
                            : left > 0    ? mask_of_bits((1u << left) - 1)
                                          : mask_of(false);
        packet->limit[v] = real_of(INFINITE);
    }
}

unsigned packet_merge_scatter(const Rgb *merged_colors, const Losses *merged_losses, unsigned first,
                              const Packet *packet, Rgb *colors, Losses *losses) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        for (unsigned remaining = mask_bits(packet->active[v]); remaining;
             remaining &= remaining - 1) {
            int lane = __builtin_ctz(remaining);
            LaneSlot slot = lane_slot_of(first++);
            rgb_copy_lane(&colors[v], lane, &merged_colors[slot.vector], slot.lane);
            losses_copy_lane(losses, v, lane, merged_losses, slot);
        }
    }
    return first;
}
