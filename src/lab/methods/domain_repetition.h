/**
 * @file
 * @brief A ball in each cell of space, of a radius of its own: what is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_DOMAIN_REPETITION_H
#define DIOPTRE_LAB_METHODS_DOMAIN_REPETITION_H

#include "lab/methods/method.h"
#include "lab/methods/sphere_grid.h"
#include "trace/math/vec3.h"

/** A ray among the balls. Cells are cubes of edge 1 around the points of whole coordinates. */
typedef struct DomainRepetitionInput {
    Vec3 origin;        /**< Where the ray starts. */
    Vec3 direction;     /**< Which way, of length 1 but for rounding. */
    real radius_spread; /**< Radii are #SPHERE_GRID_MEAN_RADIUS, more or less so much. */
} DomainRepetitionInput;

/** Where it stops. */
typedef struct DomainRepetitionOutput {
    real distance; /**< How far; #INFINITE: nowhere within #SPHERE_GRID_REACH. */
} DomainRepetitionOutput;

/** Steps after which a ray is given up. */
enum { DOMAIN_REPETITION_STEPS = 400 };
/** How near is on a surface. */
#define DOMAIN_REPETITION_TOLERANCE 1e-4

/** @return The place of the cell that a coordinate is in. @param x The coordinate, below 1000. */
static inline int domain_repetition_cell(real x) {
    return (int)(x + (scalar)1000.5f) - 1000;
}

/** @return How far a point is from the ball of a cell. */
static inline real domain_repetition_cell_distance(const DomainRepetitionInput *in, Vec3 p, int x,
                                                   int y, int z) {
    Vec3 local = {p.x - (real)x, p.y - (real)y, p.z - (real)z};
    real radius =
        (scalar)SPHERE_GRID_MEAN_RADIUS + in->radius_spread * (scalar)sphere_grid_hash(x, y, z);
    return real_sqrt(vec3_dot(local, local)) - radius;
}

/** @return Where a ray stops that is marched. */
static inline real domain_repetition_trace(const DomainRepetitionInput *in,
                                           real (*field)(const DomainRepetitionInput *in, Vec3 p)) {
    real t = 0;
    for (int i = 0; i < DOMAIN_REPETITION_STEPS && t < SPHERE_GRID_REACH; i++) {
        real distance = field(in, vec3_add(in->origin, vec3_scale(in->direction, t)));
        if (distance < (scalar)DOMAIN_REPETITION_TOLERANCE) {
            return t;
        }
        t += distance;
    }
    return INFINITE;
}

#endif
