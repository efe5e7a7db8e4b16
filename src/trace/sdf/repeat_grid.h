/**
 * @file
 * @brief Domain repetition: traversal of the cells of a repeated field along a ray.
 *
 * If each copy stays within its own cell, a ray only needs the copy of its current cell, and enters
 * the next cell at the wall (Amanatides and Woo, *A Fast Voxel Traversal Algorithm*, 1987). Cells
 * whose copy the ray misses are skipped.
 */
#ifndef DIOPTRE_TRACE_SDF_REPEAT_GRID_H
#define DIOPTRE_TRACE_SDF_REPEAT_GRID_H

#include "trace/math/angle.h"
#include "trace/tracer/ray.h"

/** The grid of a repeated field. */
typedef struct RepeatGrid {
    bool is_repeated; /**< Whether the field is repeated; else there is one cell. */
    scalar period[3]; /**< Size of a cell along x, y and z; 0: one cell. */
    scalar half[3];   /**< 0.5 if a wall, not a cell, is in the middle. */
    scalar limit[3];  /**< Number of the last cell. */
    Vec3s center;     /**< Centre of a bounding sphere of the copy in cell 0. */
    scalar radius;    /**< Radius of that sphere. */
} RepeatGrid;

/** @return The cell numbers of coordinates. */
INLINE real repeat_grid_cell_number(const RepeatGrid *grid, int axis, real x) {
    const scalar half_cell = grid->half[axis], limit = grid->limit[axis];
    if (!(grid->period[axis] > 0)) {
        return real_of(0);
    }
    real number =
        real_floor(x / grid->period[axis] + real_of((scalar)0.5f - half_cell)) + half_cell;
    return real_max(real_of(-limit), real_min(number, real_of(limit)));
}

/** @return The cells of points. */
INLINE Vec3 repeat_grid_cell(const RepeatGrid *grid, Vec3 p) {
    return (Vec3){repeat_grid_cell_number(grid, 0, p.x), repeat_grid_cell_number(grid, 1, p.y),
                  repeat_grid_cell_number(grid, 2, p.z)};
}

/** The traversal of a grid. Along an axis without repetition there is no wall. */
typedef struct GridWalk {
    Vec3 t_first_wall; /**< Distance at which the ray leaves cell 0, in lengths of the direction. */
    Vec3 t_delta;      /**< Distance between walls. */
    Vec3 step;         /**< 1 or -1: offset of the next cell. */
    Vec3 to_center;    /**< Vector from the origin to #RepeatGrid.center. */
    Vec3 direction;    /**< Unit directions. */
} GridWalk;

/** Initialises the traversal along an axis. */
INLINE void grid_walk_init_axis(const RepeatGrid *grid, int axis, real origin, real inverse,
                                real *t_first_wall, real *t_delta, real *step) {
    const scalar period = grid->period[axis];
    *step = real_select(inverse < 0, real_of(-1), real_of(1));
    *t_first_wall = real_of(INFINITE);
    *t_delta = real_of(0);
    if (period > 0) {
        *t_first_wall = (*step * ((scalar)0.5f * period) - origin) * inverse;
        *t_delta = period * inverse;
    }
}

/** @return The traversal of a grid by rays. @param unit Unit directions. */
INLINE GridWalk grid_walk_of(const RepeatGrid *grid, const Ray *ray, Vec3 unit) {
    GridWalk walk = {.direction = unit,
                     .to_center = vec3_subtract(vec3_splat(grid->center), ray->origin)};
    grid_walk_init_axis(grid, 0, ray->origin.x, ray->inverse_direction.x, &walk.t_first_wall.x,
                        &walk.t_delta.x, &walk.step.x);
    grid_walk_init_axis(grid, 1, ray->origin.y, ray->inverse_direction.y, &walk.t_first_wall.y,
                        &walk.t_delta.y, &walk.step.y);
    grid_walk_init_axis(grid, 2, ray->origin.z, ray->inverse_direction.z, &walk.t_first_wall.z,
                        &walk.t_delta.z, &walk.step.z);
    return walk;
}

/** @return The distances at which rays leave their cells along each axis; NaN: never. */
INLINE Vec3 grid_walk_exits(const GridWalk *walk, Vec3 cell) {
    return (Vec3){cell.x * walk->t_delta.x + walk->t_first_wall.x,
                  cell.y * walk->t_delta.y + walk->t_first_wall.y,
                  cell.z * walk->t_delta.z + walk->t_first_wall.z};
}

/** @return The distances at which rays leave their cells. */
INLINE real grid_walk_nearest_exit(Vec3 exits) {
    return real_min(exits.x, real_min(exits.y, real_min(exits.z, real_of(INFINITE))));
}

/** @return The next cells of rays. */
INLINE Vec3 grid_walk_next_cell(const GridWalk *walk, Vec3 cell, Vec3 exits, real t_exit) {
    const real zero = real_of(0);
    return (Vec3){cell.x + real_select(exits.x <= t_exit, walk->step.x, zero),
                  cell.y + real_select(exits.y <= t_exit, walk->step.y, zero),
                  cell.z + real_select(exits.z <= t_exit, walk->step.z, zero)};
}

/** @return The lanes whose cell exists. */
INLINE mask repeat_grid_has_cell(const RepeatGrid *grid, Vec3 cell) {
    mask x = real_abs(cell.x) <= grid->limit[0], y = real_abs(cell.y) <= grid->limit[1];
    mask z = real_abs(cell.z) <= grid->limit[2];
    return x & y & z;
}

/** @return The origins of cells. */
INLINE Vec3w repeat_grid_cell_origin(const RepeatGrid *grid, Vec3 cell) {
    return (Vec3w){widen(cell.x) * (wide_scalar)grid->period[0],
                   widen(cell.y) * (wide_scalar)grid->period[1],
                   widen(cell.z) * (wide_scalar)grid->period[2]};
}

/**
 * @return The lanes whose ray meets the bounding sphere of the copy in its cell. The distance from
 *         the ray is the length of a cross product, which stays exact far away.
 * @param margin  Addition to the radius.
 */
INLINE mask grid_walk_may_hit_copy(const RepeatGrid *grid, const GridWalk *walk, Vec3 cell,
                                   real margin) {
    Vec3 d = walk->direction, to = {cell.x * grid->period[0] + walk->to_center.x,
                                    cell.y * grid->period[1] + walk->to_center.y,
                                    cell.z * grid->period[2] + walk->to_center.z};
    Vec3 product = {to.y * d.z - to.z * d.y, to.z * d.x - to.x * d.z, to.x * d.y - to.y * d.x};
    real radius = grid->radius + margin + 16 * ROUNDOFF * vec3_max_abs(to);
    return vec3_dot(product, product) <= radius * radius;
}

#endif
