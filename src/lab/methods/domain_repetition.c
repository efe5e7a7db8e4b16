/**
 * @file
 * @brief Methods for the distance to the nearest of many spheres, one per unit cell, with different
 *        radii.
 */
#include "lab/methods/family.h"
#include "lab/methods/sphere_grid.h"

/** A ray among the spheres. Cells are unit cubes around the points of whole coordinates. */
typedef struct DomainRepetitionInput {
    Vec3 origin;        /**< Origin of the ray. */
    Vec3 direction;     /**< Direction, of length 1 but for rounding. */
    real radius_spread; /**< Radii are #SPHERE_GRID_MEAN_RADIUS plus or minus this. */
} DomainRepetitionInput;

/** Where it stops. */
typedef struct DomainRepetitionOutput {
    real distance; /**< Along the ray; #INFINITE: nothing within #SPHERE_GRID_REACH. */
} DomainRepetitionOutput;

/** Step limit of a ray. */
enum { DOMAIN_REPETITION_STEPS = 400 };
/** Distance below which a point is on a surface. */
#define DOMAIN_REPETITION_TOLERANCE 1e-4

/** A distance field: the distance from a point to the spheres. */
typedef real DomainRepetitionSdf(const DomainRepetitionInput *in, Vec3 p);

/** @return The index of a coordinate's cell. @param x The coordinate, below 1000. */
static int domain_repetition_cell(real x) {
    return (int)(x + (scalar)1000.5f) - 1000;
}

/** @return The distance from a point to the sphere of cell (x, y, z). */
static real domain_repetition_cell_distance(const DomainRepetitionInput *in, Vec3 p, int x, int y,
                                            int z) {
    Vec3 local = {p.x - (real)x, p.y - (real)y, p.z - (real)z};
    real radius =
        (scalar)SPHERE_GRID_MEAN_RADIUS + in->radius_spread * (scalar)sphere_grid_hash(x, y, z);
    return real_sqrt(vec3_dot(local, local)) - radius;
}

/** @return Where a ray stops that is sphere traced. */
static DomainRepetitionOutput domain_repetition_trace(const DomainRepetitionInput *in,
                                                      DomainRepetitionSdf *sdf) {
    real t = 0;
    for (int i = 0; i < DOMAIN_REPETITION_STEPS && t < SPHERE_GRID_REACH; i++) {
        real distance = sdf(in, vec3_add(in->origin, vec3_scale(in->direction, t)));
        if (distance < (scalar)DOMAIN_REPETITION_TOLERANCE) {
            return (DomainRepetitionOutput){t};
        }
        t += distance;
    }
    return (DomainRepetitionOutput){INFINITE};
}

/** Is a #DomainRepetitionSdf: the sphere of the point's own cell. */
static real domain_repetition_own_cell_sdf(const DomainRepetitionInput *in, Vec3 p) {
    return domain_repetition_cell_distance(in, p, domain_repetition_cell(p.x),
                                           domain_repetition_cell(p.y),
                                           domain_repetition_cell(p.z));
}

/**
 * The point's own cell only, as in report B (doc/reports.md).
 *
 * The sphere of a neighbouring cell may be nearer. Then the field exceeds the distance, the step is
 * too long, and the ray jumps into or through that sphere.
 */
METHOD(domain_repetition_own_cell, DomainRepetitionInput, DomainRepetitionOutput) {
    return domain_repetition_trace(in, domain_repetition_own_cell_sdf);
}

/** Is a #DomainRepetitionSdf: the nearest sphere of 27 cells. */
static real domain_repetition_neighbors_sdf(const DomainRepetitionInput *in, Vec3 p) {
    int x = domain_repetition_cell(p.x), y = domain_repetition_cell(p.y),
        z = domain_repetition_cell(p.z);
    real minimum = INFINITE;
    for (int i = 0; i < 27; i++) {
        real distance =
            domain_repetition_cell_distance(in, p, x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1);
        minimum = real_min(distance, minimum);
    }
    return minimum;
}

/** The point's own cell and its 26 neighbours. */
METHOD(domain_repetition_neighbors, DomainRepetitionInput, DomainRepetitionOutput) {
    return domain_repetition_trace(in, domain_repetition_neighbors_sdf);
}

const MethodFamily domain_repetition_family = {
    FAMILY("cells", DomainRepetitionInput, DomainRepetitionOutput),
    (const Method[]){{"own cell", "own cell", domain_repetition_own_cell_run},
                     {"27 cells", "27 cells", domain_repetition_neighbors_run},
                     {0}}};
