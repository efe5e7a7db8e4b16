/**
 * @file
 * @brief Rays from outside: packed, asked, and answered.
 */
#include "trace/ask.h"

/**
 * Begins a packet of rays from outside: none is active yet.
 * @param[out] packet  The packet.
 */
static void packet_clear(Packet *packet) {
    packet->wants_points = true;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Vector zero = {real_of(0), real_of(0), real_of(0)};
        packet->rays[v] = (Ray){zero, zero, zero};
        packet->active[v] = mask_of(false);
        packet->limit[v] = real_of(INFINITE);
    }
}

/**
 * Puts a ray into a packet; #packet_close makes it whole.
 * @param[in,out] packet  The packet.
 * @param i          Its place, 0 to #PACKET_RAYS - 1.
 * @param origin     Where it starts, in the engine's numbers.
 * @param direction  Which way, in the engine's numbers.
 */
INLINE void packet_put(Packet *packet, size_t i, const scalar origin[3],
                       const scalar direction[3]) {
    Ray *ray = &packet->rays[i / LANES];
    int lane = (int)(i % LANES);
    real_set_lane(&ray->origin.x, lane, origin[0]);
    real_set_lane(&ray->origin.y, lane, origin[1]);
    real_set_lane(&ray->origin.z, lane, origin[2]);
    real_set_lane(&ray->direction.x, lane, direction[0]);
    real_set_lane(&ray->direction.y, lane, direction[1]);
    real_set_lane(&ray->direction.z, lane, direction[2]);
    mask_set_lane(&packet->active[i / LANES], lane, true);
}

/** Works out what follows from the rays that were put in. @param[in,out] packet The packet. */
static void packet_close(Packet *packet) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        packet->rays[v] = ray_of(packet->rays[v].origin, packet->rays[v].direction);
    }
}

/** Makes a packet of plain rays. @param rays The rays. @param count How many, at most
 *  #PACKET_RAYS. @param zero Where the tracer's coordinates begin. @param[out] packet The packet.
 */
static void plain_pack(const PlainRay *rays, size_t count, Vector3 zero, Packet *packet) {
    packet_clear(packet);
    for (size_t i = 0; i < count; i++) {
        const double *o = rays[i].origin, *d = rays[i].direction;
        const scalar origin[3] = {(scalar)(o[0] - zero.x), (scalar)(o[1] - zero.y),
                                  (scalar)(o[2] - zero.z)};
        const scalar direction[3] = {(scalar)d[0], (scalar)d[1], (scalar)d[2]};
        packet_put(packet, i, origin, direction);
    }
    packet_close(packet);
    packet->wants_points = false;
}

/** Makes a packet of rays asked in full. @param queries The rays. @param count How many, at most
 *  #PACKET_RAYS. @param zero Where the tracer's coordinates begin. @param[out] packet The packet.
 */
static void queries_pack(const RayQuery *queries, size_t count, Vector3 zero, Packet *packet) {
    packet_clear(packet);
    for (size_t i = 0; i < count; i++) {
        const Quadruple *o = queries[i].origin, *d = queries[i].direction;
        const scalar origin[3] = {(scalar)(o[0] - (Quadruple)zero.x),
                                  (scalar)(o[1] - (Quadruple)zero.y),
                                  (scalar)(o[2] - (Quadruple)zero.z)};
        const scalar direction[3] = {(scalar)d[0], (scalar)d[1], (scalar)d[2]};
        packet_put(packet, i, origin, direction);
    }
    packet_close(packet);
}

/** @return How many of the rays from `done` on fill the next packet. @param count All rays.
 *  @param done Those already traced. */
static size_t packet_fill(size_t count, size_t done) {
    return count - done < PACKET_RAYS ? count - done : PACKET_RAYS;
}

void ask_nearest(const Tracer *tracer, size_t count, const PlainRay *rays, int *shapes,
                 double *distances) {
    for (size_t done = 0; done < count; done += PACKET_RAYS) {
        Packet packet;
        Hit hits[PACKET_VECTORS];
        size_t fill = packet_fill(count, done);
        plain_pack(rays + done, fill, tracer->origin, &packet);
        shape_list_nearest(&tracer->list, &packet, hits);
        for (size_t i = 0; i < fill; i++) {
            shapes[done + i] = integer_lane(hits[i / LANES].shape, (int)(i % LANES));
            distances[done + i] = (double)real_lane(hits[i / LANES].distance, (int)(i % LANES));
        }
    }
}

void ask_shadowed(const Tracer *tracer, size_t count, const PlainRay *rays, bool *shadowed) {
    for (size_t done = 0; done < count; done += PACKET_RAYS) {
        Packet packet;
        mask blocked[PACKET_VECTORS];
        size_t fill = packet_fill(count, done);
        plain_pack(rays + done, fill, tracer->origin, &packet);
        shape_list_blocked(&tracer->list, &packet, blocked);
        for (size_t i = 0; i < fill; i++) {
            shadowed[done + i] = mask_lane(blocked[i / LANES], (int)(i % LANES));
        }
    }
}

/** @return One lane, exactly, in the widest type. @param x Numbers. @param i The lane. */
INLINE Quadruple widest_lane(real x, int i) {
    return (Quadruple)real_lane(x, i);
}

/**
 * @return One lane of a hit, as an answer.
 * @param zero     Where the tracer's coordinates begin.
 * @param hit      The hit.
 * @param blocked  Which lanes `is_blocking` called blocked.
 * @param i        The lane.
 */
static RayAnswer answer_of(Vector3 zero, const Hit *hit, mask blocked, int i) {
    const Vector *p = &hit->point, *n = &hit->normal;
    return (RayAnswer){.shape = integer_lane(hit->shape, i),
                       .blocked = mask_lane(blocked, i),
                       .distance = widest_lane(hit->distance, i),
                       .point = {widest_lane(p->x, i) + (Quadruple)zero.x,
                                 widest_lane(p->y, i) + (Quadruple)zero.y,
                                 widest_lane(p->z, i) + (Quadruple)zero.z},
                       .normal = {widest_lane(n->x, i), widest_lane(n->y, i), widest_lane(n->z, i)},
                       .error = widest_lane(hit->error, i)};
}

/**
 * Adds to an answer where on a picture its point lies.
 * @param tracer  The tracer.
 * @param hit     The hit.
 * @param i       The lane.
 * @param[in,out] answer  The answer.
 */
static void answer_place(const Tracer *tracer, const Hit *hit, int i, RayAnswer *answer) {
    if (answer->shape >= 0) {
        mask lane = mask_of(false);
        mask_set_lane(&lane, i, true);
        TexturePlace place = shape_texture_place(tracer->list.shapes[answer->shape], hit, lane);
        answer->place[0] = widest_lane(place.u, i);
        answer->place[1] = widest_lane(place.v, i);
    }
}

void ask_intersect(const Tracer *tracer, size_t count, const RayQuery *queries,
                   RayAnswer *answers) {
    for (size_t done = 0; done < count; done += PACKET_RAYS) {
        Packet packet;
        Hit hits[PACKET_VECTORS];
        mask blocked[PACKET_VECTORS];
        size_t fill = packet_fill(count, done);
        queries_pack(queries + done, fill, tracer->origin, &packet);
        shape_list_nearest(&tracer->list, &packet, hits);
        shape_list_blocked(&tracer->list, &packet, blocked);
        for (size_t i = 0; i < fill; i++) {
            answers[done + i] =
                answer_of(tracer->origin, &hits[i / LANES], blocked[i / LANES], (int)(i % LANES));
            answer_place(tracer, &hits[i / LANES], (int)(i % LANES), &answers[done + i]);
        }
    }
}
