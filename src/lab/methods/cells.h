/**
 * @file
 * @brief A ball in each cell of space, of a radius of its own: what is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_CELLS_H
#define DIOPTRE_LAB_METHODS_CELLS_H

#include "lab/methods/ball_sizes.h"
#include "lab/methods/method.h"
#include "trace/vector.h"

/** A ray among the balls. Cells are cubes of edge 1 around the points of whole coordinates. */
typedef struct CellsQuestion {
    Vector origin;    /**< Where the ray starts. */
    Vector direction; /**< Which way, of length 1 but for rounding. */
    real spread;      /**< Radii are #BALL_MIDDLE, more or less so much. */
} CellsQuestion;

/** Where it stops. */
typedef struct CellsAnswer {
    real distance; /**< How far; #INFINITE: nowhere within #BALLS_REACH. */
} CellsAnswer;

/** Steps after which a ray is given up. */
enum { CELLS_STEPS = 400 };
/** How near is on a surface. */
#define CELLS_TOLERANCE 1e-4

/** @return The place of the cell that a coordinate is in. @param x The coordinate, below 1000. */
static inline int cell_of(real x) {
    return (int)(x + (scalar)1000.5f) - 1000;
}

/** @return How far a point is from the ball of a cell. @param q The question. @param p The point.
 *  @param x The cell. @param y Its second place. @param z Its third. */
static inline real cell_distance(const CellsQuestion *q, Vector p, int x, int y, int z) {
    Vector arm = {p.x - (real)x, p.y - (real)y, p.z - (real)z};
    real radius = (scalar)BALL_MIDDLE + q->spread * (scalar)ball_larger(x, y, z);
    return real_sqrt(vector_dot(arm, arm)) - radius;
}

/** @return Where a ray stops that is marched. @param q The question. @param field The field. */
static inline real cells_march(const CellsQuestion *q,
                               real (*field)(const CellsQuestion *q, Vector p)) {
    real t = 0;
    for (int i = 0; i < CELLS_STEPS && t < BALLS_REACH; i++) {
        real far = field(q, vector_add(q->origin, vector_scale(q->direction, t)));
        if (far < (scalar)CELLS_TOLERANCE) {
            return t;
        }
        t += far;
    }
    return INFINITE;
}

#endif
