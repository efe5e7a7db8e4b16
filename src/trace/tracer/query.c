/**
 * @file
 * @brief Ray queries: rays into packets, hits out of packets.
 */
#include "trace/tracer/query.h"

/** Begins a packet without active rays. */
static void packet_clear(Packet *packet) {
    packet_init(packet, PACKET_VECTORS, true);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Vec3 zero = {real_of(0), real_of(0), real_of(0)};
        packet->rays[v] = (Ray){zero, zero, zero};
        packet->active[v] = mask_of(false);
        packet->limit[v] = real_of(INFINITE);
    }
}

/** Adds a ray to a packet, without its inverse direction. @param i Its index, 0 to #PACKET_RAYS
 * - 1. */
INLINE void packet_set_ray(Packet *packet, size_t i, const scalar origin[3],
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

/** Completes the rays of a packet. */
static void packet_finish(Packet *packet) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        packet->rays[v] = ray_of(packet->rays[v].origin, packet->rays[v].direction);
    }
}

/**
 * Makes a packet of double-precision queries.
 * @param count  Number of rays, at most #PACKET_RAYS.
 * @param scene_origin  The origin of the tracer's coordinates.
 */
static void ray_queries_pack(const RayQuery *rays, size_t count, Vec3d scene_origin,
                             Packet *packet) {
    packet_clear(packet);
    for (size_t i = 0; i < count; i++) {
        const double *o = rays[i].origin, *d = rays[i].direction;
        const scalar origin[3] = {(scalar)(o[0] - scene_origin.x), (scalar)(o[1] - scene_origin.y),
                                  (scalar)(o[2] - scene_origin.z)};
        const scalar direction[3] = {(scalar)d[0], (scalar)d[1], (scalar)d[2]};
        packet_set_ray(packet, i, origin, direction);
    }
    packet_finish(packet);
    packet->wants_points = false;
}

/**
 * Makes a packet of quadruple-precision queries.
 * @param count  Number of rays, at most #PACKET_RAYS.
 * @param scene_origin  The origin of the tracer's coordinates.
 */
static void quad_queries_pack(const RayQueryQuad *queries, size_t count, Vec3d scene_origin,
                              Packet *packet) {
    packet_clear(packet);
    for (size_t i = 0; i < count; i++) {
        const Quadruple *o = queries[i].origin, *d = queries[i].direction;
        const scalar origin[3] = {(scalar)(o[0] - (Quadruple)scene_origin.x),
                                  (scalar)(o[1] - (Quadruple)scene_origin.y),
                                  (scalar)(o[2] - (Quadruple)scene_origin.z)};
        const scalar direction[3] = {(scalar)d[0], (scalar)d[1], (scalar)d[2]};
        packet_set_ray(packet, i, origin, direction);
    }
    packet_finish(packet);
}

/** @return The number of rays in the next packet. @param done Rays in earlier packets. */
static size_t packet_fill_count(size_t count, size_t done) {
    return count - done < PACKET_RAYS ? count - done : PACKET_RAYS;
}

void query_closest_hits(const Tracer *tracer, size_t count, const RayQuery *rays, int *shapes,
                        double *distances) {
    for (size_t done = 0; done < count; done += PACKET_RAYS) {
        Packet packet;
        Hit hits[PACKET_VECTORS];
        size_t fill = packet_fill_count(count, done);
        ray_queries_pack(rays + done, fill, tracer->origin, &packet);
        shape_set_closest_hits(&tracer->shapes, &packet, hits);
        for (size_t i = 0; i < fill; i++) {
            shapes[done + i] = integer_lane(hits[i / LANES].shape, (int)(i % LANES));
            distances[done + i] = (double)real_lane(hits[i / LANES].distance, (int)(i % LANES));
        }
    }
}

void query_occluded(const Tracer *tracer, size_t count, const RayQuery *rays, bool *occluded) {
    for (size_t done = 0; done < count; done += PACKET_RAYS) {
        Packet packet;
        mask occluded_lanes[PACKET_VECTORS];
        size_t fill = packet_fill_count(count, done);
        ray_queries_pack(rays + done, fill, tracer->origin, &packet);
        shape_set_occluded(&tracer->shapes, &packet, NULL, NULL, occluded_lanes);
        for (size_t i = 0; i < fill; i++) {
            occluded[done + i] = mask_lane(occluded_lanes[i / LANES], (int)(i % LANES));
        }
    }
}

/** @return Lane i, exactly, in the widest type. */
INLINE Quadruple quad_lane(real x, int i) {
    return (Quadruple)real_lane(x, i);
}

/** @return The result of lane i. @param scene_origin The origin of the tracer's coordinates. */
static RayResult ray_result_of(Vec3d scene_origin, const Hit *hit, mask occluded, int i) {
    const Vec3 *p = &hit->point, *n = &hit->normal;
    return (RayResult){.shape = integer_lane(hit->shape, i),
                       .occluded = mask_lane(occluded, i),
                       .distance = quad_lane(hit->distance, i),
                       .point = {quad_lane(p->x, i) + (Quadruple)scene_origin.x,
                                 quad_lane(p->y, i) + (Quadruple)scene_origin.y,
                                 quad_lane(p->z, i) + (Quadruple)scene_origin.z},
                       .normal = {quad_lane(n->x, i), quad_lane(n->y, i), quad_lane(n->z, i)},
                       .error = quad_lane(hit->error, i)};
}

/** Adds the texture coordinates to a result. */
static void ray_result_set_uv(const Tracer *tracer, const Hit *hit, int i, RayResult *result) {
    if (result->shape >= 0) {
        mask lane = mask_of(false);
        mask_set_lane(&lane, i, true);
        TextureUv uv = shape_texture_uv(tracer->shapes.shapes[result->shape], hit, lane);
        result->uv[0] = quad_lane(uv.u, i);
        result->uv[1] = quad_lane(uv.v, i);
    }
}

void query_intersect(const Tracer *tracer, size_t count, const RayQueryQuad *queries,
                     RayResult *results) {
    for (size_t done = 0; done < count; done += PACKET_RAYS) {
        Packet packet;
        Hit hits[PACKET_VECTORS];
        mask occluded[PACKET_VECTORS];
        size_t fill = packet_fill_count(count, done);
        quad_queries_pack(queries + done, fill, tracer->origin, &packet);
        shape_set_closest_hits(&tracer->shapes, &packet, hits);
        shape_set_occluded(&tracer->shapes, &packet, NULL, NULL, occluded);
        for (size_t i = 0; i < fill; i++) {
            results[done + i] = ray_result_of(tracer->origin, &hits[i / LANES], occluded[i / LANES],
                                              (int)(i % LANES));
            ray_result_set_uv(tracer, &hits[i / LANES], (int)(i % LANES), &results[done + i]);
        }
    }
}
