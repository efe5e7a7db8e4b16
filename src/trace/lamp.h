/**
 * @file
 * @brief Lamps and suns in the engine's number type: how they are aimed at, and what reaches a
 * point.
 */
#ifndef DIOPTRE_TRACE_LAMP_H
#define DIOPTRE_TRACE_LAMP_H

#include "trace/lighting.h"

/**
 * A light in the engine's number type. Only this class knows a sun from a lamp: it is one
 * infinitely far away.
 */
struct Lamp {
    Vector place;           /**< Where it is; of a sun: the unit direction towards it. */
    Light3 light;           /**< Its colour times its intensity. */
    bool is_sun;            /**< Whether it is infinitely far away. */
    scalar radius;          /**< Of its ball; 0: a point. */
    scalar nearest_squared; /**< It shines no more strongly than from this distance, squared. */
    bool is_inverse_square; /**< Whether it weakens with the distance. */
    bool is_soft;           /**< Whether each ray goes to another point of its ball. */
};

/** What one lamp would give to the points of a packet, were nothing in the way. */
typedef struct Shine {
    Packet shadow;                         /**< The rays to the lamp; active where it may shine. */
    real cosine[PACKET_VECTORS];           /**< n . l, above 0 where active. */
    real distance_squared[PACKET_VECTORS]; /**< To it, squared. */
    real weight[PACKET_VECTORS];           /**< Of the ray among all to a soft lamp's ball. */
    Light3 visible[PACKET_VECTORS];        /**< The share that glass leaves, if there is any. */
} Shine;

/**
 * @return A light in the engine's number type.
 * @param light    The light.
 * @param samples  Rays a pixel: with one, a ball shines from its centre.
 */
Lamp lamp_of(const Light *light, int samples);

/** @return A light's colour times its intensity. @param light The light. */
Scalar3 light_strength(const Light *light);

/**
 * Aims shadow rays at a lamp, from the points that it could light: a surface turned away from the
 * lamp stands in its own light. This is the one place that knows how any kind of light is aimed at.
 * @param lamp       The lamp.
 * @param number     Which of the scene's lamps it is.
 * @param departure  Where the rays start.
 * @param met        The points.
 * @param[out] shine  What the lamp would give.
 */
void lamp_aim(const Lamp *lamp, size_t number, const Departure *departure, const Encounter *met,
              Shine *shine);

/** @return The way from points to a lamp; a unit vector to a sun. @param lamp The lamp.
 *  @param point The points. */
INLINE Vector lamp_way(const Lamp *lamp, Vector point) {
    return lamp->is_sun ? lamp->place : vector_subtract(lamp->place, point);
}

/** @return Unit directions to a lamp, those of its shadow rays. @param lamp The lamp.
 *  @param shine What it would give. @param v Which vector of points. @param point The points. */
INLINE Vector lamp_direction(const Lamp *lamp, const Shine *shine, int v, Vector point) {
    if (lamp->is_soft) {
        return shine->shadow.rays[v].direction;
    }
    return vector_scale(lamp_way(lamp, point), 1 / real_sqrt(shine->distance_squared[v]));
}

/** @return What is left of a lamp's light at points. @param lamp The lamp.
 *  @param shine What it would give. @param v Which vector of points. */
INLINE real lamp_share(const Lamp *lamp, const Shine *shine, int v) {
    real share = lamp->is_soft ? shine->weight[v] : real_of(1);
    if (lamp->is_inverse_square) {
        share = share / real_max(shine->distance_squared[v], real_of(lamp->nearest_squared));
    }
    return share;
}

#endif
