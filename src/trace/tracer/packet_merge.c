/**
 * @file
 * @brief Convoys of rays.
 */
#include "trace/tracer/packet_merge.h"

/** One ray of many: a lane of a vector. */
typedef struct LaneSlot {
    unsigned vector; /**< Which vector. */
    int lane;        /**< Which lane of it. */
} LaneSlot;

/** @return A ray's seat. @param index Its place, counted from the first lane of the first vector.
 */
static LaneSlot lane_slot_of(unsigned index) {
    return (LaneSlot){index / LANES, (int)(index % LANES)};
}

/** @return How many vectors of a packet have active rays. */
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
    // Rays that go all ways take longer a vector: a quarter of the vectors pays for it (measured).
    // What is noted is of one pixel, and first of what is mirrored: its rays stay in their places.
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

/** Copies a ray. */
INLINE void ray_copy_lane(Ray *to, int slot, const Ray *from, int lane) {
    vec3_copy_lane(&to->origin, slot, &from->origin, lane);
    vec3_copy_lane(&to->direction, slot, &from->direction, lane);
    vec3_copy_lane(&to->inverse_direction, slot, &from->inverse_direction, lane);
}

/** Copies what a ray is inside of. */
INLINE void interior_list_copy_lane(InteriorList *to, int slot, const InteriorList *from,
                                    int lane) {
    for (int i = 0; i < INTERIOR_LIST_CAPACITY; i++) {
        integer_set_lane(&to->shapes[i], slot, integer_at(&from->shapes[i], lane));
    }
}

void packet_merge_begin(PacketMerge *merge, SampleContext context) {
    merge->count = 0;
    merge->packet.wants_points = true;
    merge->packet.context = context;
    if (context.pixel_ids) {
        merge->packet.context.pixel_ids = merge->pixel_ids;
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        merge->packet.active[v] = mask_of(false);
        merge->packet.limit[v] = real_of(INFINITE);
    }
}

void packet_merge_add(PacketMerge *merge, const Packet *packet, const InteriorList *interior,
                      const real *throughputs) {
    const uint32_t *pixel_ids = packet->context.pixel_ids;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        for (unsigned remaining = mask_bits(packet->active[v]); remaining;
             remaining &= remaining - 1) {
            int lane = __builtin_ctz(remaining);
            LaneSlot slot = lane_slot_of(merge->count);
            ray_copy_lane(&merge->packet.rays[slot.vector], slot.lane, &packet->rays[v], lane);
            interior_list_copy_lane(&merge->interior[slot.vector], slot.lane, &interior[v], lane);
            real_copy_lane(&merge->throughputs[slot.vector], slot.lane, &throughputs[v], lane);
            merge->pixel_ids[merge->count++] = pixel_ids ? pixel_ids[v * LANES + lane] : 0;
        }
    }
}

/** Fills the lanes that are left of the last vector with its first ray, which is harmless to
 *  compute with. */
static void packet_merge_pad(PacketMerge *merge) {
    for (unsigned index = merge->count; index % LANES; index++) {
        LaneSlot slot = lane_slot_of(index);
        Ray *rays = &merge->packet.rays[slot.vector];
        InteriorList *interior = &merge->interior[slot.vector];
        ray_copy_lane(rays, slot.lane, rays, 0);
        interior_list_copy_lane(interior, slot.lane, interior, 0);
        real_set_lane(&merge->throughputs[slot.vector], slot.lane, 0);
        merge->pixel_ids[index] = 0;
    }
}

void packet_merge_end(PacketMerge *merge) {
    unsigned whole = merge->count / LANES, rest = merge->count % LANES;
    for (unsigned v = 0; v < whole; v++) {
        merge->packet.active[v] = mask_of(true);
    }
    if (rest) {
        merge->packet.active[whole] = mask_of_bits((1u << rest) - 1);
        packet_merge_pad(merge);
    }
}

unsigned packet_merge_scatter(const Rgb *incoming, unsigned first, const Packet *packet,
                              Rgb *colors) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        for (unsigned remaining = mask_bits(packet->active[v]); remaining;
             remaining &= remaining - 1) {
            int lane = __builtin_ctz(remaining);
            LaneSlot slot = lane_slot_of(first++);
            real_copy_lane(&colors[v].red, lane, &incoming[slot.vector].red, slot.lane);
            real_copy_lane(&colors[v].green, lane, &incoming[slot.vector].green, slot.lane);
            real_copy_lane(&colors[v].blue, lane, &incoming[slot.vector].blue, slot.lane);
        }
    }
    return first;
}
