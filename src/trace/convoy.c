/**
 * @file
 * @brief Convoys of rays.
 */
#include "trace/convoy.h"

/** One ray of many: a lane of a vector. */
typedef struct Seat {
    unsigned vector; /**< Which vector. */
    int lane;        /**< Which lane of it. */
} Seat;

/** @return A ray's seat. @param place Its place, counted from the first lane of the first vector.
 */
static Seat seat_of(unsigned place) {
    return (Seat){place / LANES, (int)(place % LANES)};
}

/** @return How many vectors of a packet have active rays. @param packet The packet. */
static unsigned vectors_used(const Packet *packet) {
    unsigned used = 0;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        used += any(packet->active[v]);
    }
    return used;
}

bool convoy_pays(const Packet *one, const Packet *other) {
    unsigned rays = packet_count(one) + packet_count(other);
    unsigned before = vectors_used(one) + vectors_used(other), after = (rays + LANES - 1) / LANES;
    // Rays that go all ways take longer a vector: a quarter of the vectors pays for it (measured).
    // What is noted is of one pixel, and first of what is mirrored: its rays stay in their places.
    return LANES > 1 && !one->lineage.notes && one->lineage.bounce <= CONVOY_BOUNCES && rays > 0 &&
           rays <= PACKET_RAYS && 4 * after <= 3 * before;
}

/** Copies a lane. @param[in,out] to Where to. @param seat Its lane. @param from Where from.
 *  @param lane Which lane. */
INLINE void real_copy(real *to, int seat, const real *from, int lane) {
    real_set_lane(to, seat, real_at(from, lane));
}

/** Copies a lane. @param[in,out] to Where to. @param seat Its lane. @param from Where from.
 *  @param lane Which lane. */
INLINE void vector_copy(Vector *to, int seat, const Vector *from, int lane) {
    real_copy(&to->x, seat, &from->x, lane);
    real_copy(&to->y, seat, &from->y, lane);
    real_copy(&to->z, seat, &from->z, lane);
}

/** Copies a ray. @param[in,out] to Where to. @param seat Its lane. @param from Where from.
 *  @param lane Which lane. */
INLINE void ray_copy(Ray *to, int seat, const Ray *from, int lane) {
    vector_copy(&to->origin, seat, &from->origin, lane);
    vector_copy(&to->direction, seat, &from->direction, lane);
    vector_copy(&to->inverse, seat, &from->inverse, lane);
}

/** Copies what a ray is inside of. @param[in,out] to Where to. @param seat Its lane.
 *  @param from Where from. @param lane Which lane. */
INLINE void media_copy(Media *to, int seat, const Media *from, int lane) {
    for (int i = 0; i < MEDIA_MAXIMUM; i++) {
        integer_set_lane(&to->places[i], seat, integer_at(&from->places[i], lane));
    }
}

void convoy_begin(Convoy *convoy, Lineage lineage) {
    convoy->count = 0;
    convoy->packet.wants_points = true;
    convoy->packet.lineage = lineage;
    if (lineage.pixels) {
        convoy->packet.lineage.pixels = convoy->pixels;
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        convoy->packet.active[v] = mask_of(false);
        convoy->packet.limit[v] = real_of(INFINITE);
    }
}

void convoy_join(Convoy *convoy, const Packet *packet, const Media *media, const real *weights) {
    const uint32_t *pixels = packet->lineage.pixels;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        for (unsigned left = mask_bits(packet->active[v]); left; left &= left - 1) {
            int lane = __builtin_ctz(left);
            Seat seat = seat_of(convoy->count);
            ray_copy(&convoy->packet.rays[seat.vector], seat.lane, &packet->rays[v], lane);
            media_copy(&convoy->media[seat.vector], seat.lane, &media[v], lane);
            real_copy(&convoy->weights[seat.vector], seat.lane, &weights[v], lane);
            convoy->pixels[convoy->count++] = pixels ? pixels[v * LANES + lane] : 0;
        }
    }
}

/** Fills the lanes that are left of the last vector with its first ray, which is harmless to
 *  compute with. @param[in,out] convoy The convoy. */
static void convoy_fill(Convoy *convoy) {
    for (unsigned place = convoy->count; place % LANES; place++) {
        Seat seat = seat_of(place);
        Ray *rays = &convoy->packet.rays[seat.vector];
        Media *media = &convoy->media[seat.vector];
        ray_copy(rays, seat.lane, rays, 0);
        media_copy(media, seat.lane, media, 0);
        real_set_lane(&convoy->weights[seat.vector], seat.lane, 0);
        convoy->pixels[place] = 0;
    }
}

void convoy_close(Convoy *convoy) {
    unsigned whole = convoy->count / LANES, rest = convoy->count % LANES;
    for (unsigned v = 0; v < whole; v++) {
        convoy->packet.active[v] = mask_of(true);
    }
    if (rest) {
        convoy->packet.active[whole] = mask_of_bits((1u << rest) - 1);
        convoy_fill(convoy);
    }
}

unsigned convoy_part(const Light3 *seen, unsigned first, const Packet *packet, Light3 *colors) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        for (unsigned left = mask_bits(packet->active[v]); left; left &= left - 1) {
            int lane = __builtin_ctz(left);
            Seat seat = seat_of(first++);
            real_copy(&colors[v].red, lane, &seen[seat.vector].red, seat.lane);
            real_copy(&colors[v].green, lane, &seen[seat.vector].green, seat.lane);
            real_copy(&colors[v].blue, lane, &seen[seat.vector].blue, seat.lane);
        }
    }
    return first;
}
