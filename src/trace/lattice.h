/**
 * @file
 * @brief Lattices: the cells of a repeated field, one after the other along a ray.
 *
 * Where each copy stays within its own cell, a ray needs no distance to the copies in the cells
 * around: it asks the copy in the cell where it is, and goes on to the next cell at its wall. Cells
 * whose copy lies beside the ray are left out at once (Amanatides and Woo, *A Fast Voxel Traversal
 * Algorithm*, 1987).
 */
#ifndef DIOPTRE_TRACE_LATTICE_H
#define DIOPTRE_TRACE_LATTICE_H

#include "trace/angle.h"
#include "trace/ray.h"

/** The cells of a repeated field. */
typedef struct Lattice {
    bool is_any;      /**< Whether the field is repeated at all; else there is one cell. */
    scalar period[3]; /**< From one cell to the next, along x, y and z; 0: there is one only. */
    scalar half[3];   /**< 0.5 where there is a wall, and no cell, in the middle. */
    scalar limit[3];  /**< Number of the last cell. */
    Point middle;     /**< Middle of a ball around the copy in cell 0. */
    scalar radius;    /**< Its radius. */
} Lattice;

/** @return The number of the cell that coordinates are in. @param lattice The lattice.
 *  @param axis Which axis. @param x Coordinates. */
INLINE real lattice_number(const Lattice *lattice, int axis, real x) {
    const scalar half = lattice->half[axis], limit = lattice->limit[axis];
    if (!(lattice->period[axis] > 0)) {
        return real_of(0);
    }
    real number = real_floor(x / lattice->period[axis] + real_of((scalar)0.5f - half)) + half;
    return real_max(real_of(-limit), real_min(number, real_of(limit)));
}

/** @return The cells that points are in. @param lattice The lattice. @param p Points. */
INLINE Vector lattice_cell(const Lattice *lattice, Vector p) {
    return (Vector){lattice_number(lattice, 0, p.x), lattice_number(lattice, 1, p.y),
                    lattice_number(lattice, 2, p.z)};
}

/** How rays go through a lattice. Along an axis where it is not repeated, there is no wall. */
typedef struct LatticeRay {
    Vector wall;      /**< Where they would leave cell 0, in lengths of the direction. */
    Vector interval;  /**< How much later they leave the next cell. */
    Vector step;      /**< 1 or -1: which cell comes next. */
    Vector middle;    /**< From their start to the middle of the copy in cell 0. */
    Vector direction; /**< Unit directions. */
} LatticeRay;

/** Finds how rays go through a lattice along an axis. @param lattice The lattice. @param axis Which
 *  axis. @param origin Where they start. @param inverse 1 / direction. @param[out] wall See
 *  #LatticeRay. @param[out] interval See there. @param[out] step See there. */
INLINE void lattice_axis(const Lattice *lattice, int axis, real origin, real inverse, real *wall,
                         real *interval, real *step) {
    const scalar period = lattice->period[axis];
    *step = real_select(inverse < 0, real_of(-1), real_of(1));
    *wall = real_of(INFINITE);
    *interval = real_of(0);
    if (period > 0) {
        *wall = (*step * ((scalar)0.5f * period) - origin) * inverse;
        *interval = period * inverse;
    }
}

/** @return How rays go through a lattice. @param lattice The lattice. @param ray The rays.
 *  @param unit Their unit directions. */
INLINE LatticeRay lattice_ray(const Lattice *lattice, const Ray *ray, Vector unit) {
    LatticeRay way = {.direction = unit,
                      .middle = vector_subtract(vector_of_point(lattice->middle), ray->origin)};
    lattice_axis(lattice, 0, ray->origin.x, ray->inverse.x, &way.wall.x, &way.interval.x,
                 &way.step.x);
    lattice_axis(lattice, 1, ray->origin.y, ray->inverse.y, &way.wall.y, &way.interval.y,
                 &way.step.y);
    lattice_axis(lattice, 2, ray->origin.z, ray->inverse.z, &way.wall.z, &way.interval.z,
                 &way.step.z);
    return way;
}

/** @return How far away rays leave their cells, along each axis; NaN: never. @param way How they
 *  go. @param cell The cells. */
INLINE Vector lattice_walls(const LatticeRay *way, Vector cell) {
    return (Vector){cell.x * way->interval.x + way->wall.x, cell.y * way->interval.y + way->wall.y,
                    cell.z * way->interval.z + way->wall.z};
}

/** @return How far away rays leave their cells. @param walls What lattice_walls() says. */
INLINE real lattice_exit(Vector walls) {
    return real_min(walls.x, real_min(walls.y, real_min(walls.z, real_of(INFINITE))));
}

/** @return The next cells of rays. @param way How they go. @param cell The cells. @param walls What
 *  lattice_walls() says. @param exit The nearest of them. */
INLINE Vector lattice_next(const LatticeRay *way, Vector cell, Vector walls, real exit) {
    const real zero = real_of(0);
    return (Vector){cell.x + real_select(walls.x <= exit, way->step.x, zero),
                    cell.y + real_select(walls.y <= exit, way->step.y, zero),
                    cell.z + real_select(walls.z <= exit, way->step.z, zero)};
}

/** @return The cells that there are. @param lattice The lattice. @param cell Cells. */
INLINE mask lattice_has(const Lattice *lattice, Vector cell) {
    mask x = real_abs(cell.x) <= lattice->limit[0], y = real_abs(cell.y) <= lattice->limit[1];
    mask z = real_abs(cell.z) <= lattice->limit[2];
    return x & y & z;
}

/** @return Where the zero of cells lies. @param lattice The lattice. @param cell The cells. */
INLINE WideVector lattice_zero(const Lattice *lattice, Vector cell) {
    return (WideVector){widen(cell.x) * (wide_scalar)lattice->period[0],
                        widen(cell.y) * (wide_scalar)lattice->period[1],
                        widen(cell.z) * (wide_scalar)lattice->period[2]};
}

/**
 * @return Where rays may meet the copy in their cells: where the ball around it does not lie
 *         beside them. Its distance from the ray comes by a product of vectors, which stays exact
 *         far away.
 * @param lattice  The lattice.
 * @param way      How they go.
 * @param cell     The cells.
 * @param more     By how much the ball is larger.
 */
INLINE mask lattice_may_meet(const Lattice *lattice, const LatticeRay *way, Vector cell,
                             real more) {
    Vector d = way->direction, to = {cell.x * lattice->period[0] + way->middle.x,
                                     cell.y * lattice->period[1] + way->middle.y,
                                     cell.z * lattice->period[2] + way->middle.z};
    Vector product = {to.y * d.z - to.z * d.y, to.z * d.x - to.x * d.z, to.x * d.y - to.y * d.x};
    real radius = lattice->radius + more + 16 * ROUNDOFF * vector_largest(to);
    return vector_dot(product, product) <= radius * radius;
}

#endif
