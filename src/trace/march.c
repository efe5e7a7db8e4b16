/**
 * @file
 * @brief Marching through a field.
 */
#include "trace/march.h"

#include "trace/slab.h"

/** A ray that runs out of steps has met the surface if it came within so many tolerances. */
#define CANDIDATE_TOLERANCES 8
/** How much the last step counts in #March.slope. */
#define SLOPE_SHARE ((scalar)0.4f)
/** Largest slope that is counted on: steps are 2.5 times as long as allowed then. */
#define SLOPE_MOST ((scalar)0.2f)
/** What a cell counts for in the steps of a ray, exactly: without an end, it is given up. */
#define CELL_STEPS ((scalar)0x1p-4f)

/* --- where rays are marched ------------------------------------------------------------------- */

/** @return How long a vector is; squares of any stay in range. @param v Vectors. */
INLINE real vector_length(Vector v) {
    real largest = vector_largest(v);
    Vector d = {v.x / largest, v.y / largest, v.z / largest};
    return largest * real_sqrt(vector_dot(d, d));
}

/**
 * Finds where rays go through the box in their cells.
 * @param marching  The field.
 * @param[in,out] march  The rays; where they go through it they stand before it.
 * @param lanes     Those that count.
 * @param start     Where they come into the cells, as the tape sees it.
 * @param room      How far they go in the cells, in those lengths.
 * @return Those that go through the box.
 */
INLINE mask march_enter(const Marching *marching, March *march, mask lanes, WideVector start,
                        real room) {
    const real zero = real_of(0), none = real_of(INFINITE);
    const real *planes = marching->box.planes;
    Vector origin = vector_narrow(start);
    real near = zero, far = room;
    real more = march_unseen(march, march->eye - march->from * march->length);
    slab_clip(&near, &far, planes[0] - more, planes[3] + more, origin.x, march->inverse.x);
    slab_clip(&near, &far, planes[1] - more, planes[4] + more, origin.y, march->inverse.y);
    slab_clip(&near, &far, planes[2] - more, planes[5] + more, origin.z, march->inverse.z);
    mask enters = lanes & (near <= far * (1 + SLAB_SLACK)) & (near < none);
    origin = vector_narrow(wide_add_scaled(start, march->heading, widen(near)));
    real walked = (march->from + near) * march->length;
    // Whoever starts on the surface starts in the box, or just beside it.
    real margin =
        ERROR_TOLERANCES * marching->slack *
        real_max(real_of(marching->tolerance / marching->scale), march->spread * march->eye);
    march->ahead = real_select(enters, march->eye - walked, march->ahead);
    march->entry = real_select(enters, near, march->entry);
    march->origin = vector_select(enters, origin, march->origin);
    march->end = real_select(enters, (far - near) * march->length, march->end);
    march->leaving = march->leaving & mask_not(enters & (walked > margin));
    march->way = real_select(enters, zero, march->way);
    march->step = real_select(enters, zero, march->step);
    march->radius = real_select(enters, zero, march->radius);
    march->slope = real_select(enters, real_of(-1), march->slope);
    march->best = real_select(enters, none, march->best);
    return enters;
}

/** @return Where rays come into their cells, as the tape sees it. @param marching The field.
 *  @param march The rays. */
INLINE WideVector march_start(const Marching *marching, const March *march) {
    WideVector start = wide_add_scaled(march->start, march->toward, widen(march->from));
    start = wide_subtract(start, lattice_zero(&marching->lattice, march->cell));
    return marching->inner.is_any ? placing_take(&marching->inner, start) : start;
}

/** Brings rays to their next cells; those that come out of the lattice have ended.
 *  @param marching The field. @param[in,out] march The rays. @param lanes Those that count.
 *  @return Those that are in a cell. */
INLINE mask march_next(const Marching *marching, March *march, mask lanes) {
    Vector walls = lattice_walls(&march->through, march->cell);
    real exit = lattice_exit(walls);
    Vector next = lattice_next(&march->through, march->cell, walls, exit);
    lanes = lanes & (exit < march->far) & lattice_has(&marching->lattice, next);
    march->cell = vector_select(lanes, next, march->cell);
    march->from = real_select(lanes, exit, march->from);
    march->steps = real_select(lanes, march->steps + CELL_STEPS, march->steps);
    return lanes;
}

/** Looks for cells whose copy rays may meet, one cell on. @param marching The field.
 *  @param[in,out] march The rays. */
INLINE void march_seek(const Marching *marching, March *march) {
    mask seeking = march_next(marching, march, march->seeking);
    real more = march_unseen(march, march->eye - march->from * march->length);
    mask meets = seeking & lattice_may_meet(&marching->lattice, &march->through, march->cell,
                                            more * (scalar)marching->inner.scale);
    march->entering = march->entering | meets;
    march->seeking = seeking & mask_not(meets);
}

/** Brings rays before the box of the copy in their cells; those that go by seek on.
 *  @param marching The field. @param[in,out] march The rays. */
INLINE void march_enter_copy(const Marching *marching, March *march) {
    real exit = lattice_exit(lattice_walls(&march->through, march->cell));
    WideVector start = march_start(marching, march);
    mask enters = march_enter(marching, march, march->entering, start,
                              real_min(exit, march->far) - march->from);
    march->walking = march->walking | enters;
    march->seeking = march->seeking | (march->entering & mask_not(enters));
    march->entering = mask_of(false);
}

/** Says how finely the camera sees along rays. @param marching The field. @param[in,out] march The
 *  rays. @param origin Where they start in the scene. @param is_shadow Whether they are on their
 *  way to a lamp. */
INLINE void march_aim(const Marching *marching, March *march, Vector origin, bool is_shadow) {
    const Footprint *footprint = marching->footprint;
    march->eye = real_of(0);
    march->spread = march->beyond = 0;
    if (footprint) {
        Vector from_eye = vector_subtract(origin, vector_of_point(footprint->eye));
        march->eye = real_sqrt(vector_dot(from_eye, from_eye)) / marching->scale;
        march->spread = footprint->spread;
        // A shadow is as fine as what it falls on is seen, however far away its thrower is.
        march->beyond = is_shadow ? 0 : footprint->spread;
    }
}

/** Says which way rays go as the tape sees it. @param[in,out] march The rays. @param ray The same.
 */
INLINE void march_head(March *march, const Ray *ray) {
    march->inverse = ray->inverse;
    march->length = vector_length(ray->direction);
    march->direction = vector_scale(ray->direction, 1 / march->length);
}

/** Brings rays into the lattice. @param marching The field. @param[in,out] march The rays; walking
 *  are those that count. @param ray The same, as the lattice sees them. */
INLINE void lattice_begin(const Marching *marching, March *march, const Ray *ray) {
    real near;
    mask meets = slab_meets(ray, &marching->around, march->far, &near);
    march->through = lattice_ray(&marching->lattice, ray, march->direction);
    march->from = real_max(near, real_of(0));
    march->cell = lattice_cell(&marching->lattice,
                               vector_add(ray->origin, vector_scale(ray->direction, march->from)));
    march->entering = march->walking & meets & (march->from < INFINITE);
    march->walking = mask_of(false);
    if (marching->inner.is_any) {
        march->heading = placing_turn(&marching->inner, march->toward);
        Vector turned = vector_narrow(march->heading);
        Ray local = ray_of(turned, turned);
        march_head(march, &local);
    }
}

/**
 * Sends rays on their way.
 * @param marching  The field.
 * @param ray       The rays.
 * @param active    The lanes that count.
 * @param limit     How far they look.
 * @param is_shadow Whether they are on their way to a lamp.
 * @param[out] march  The rays before the first box.
 * @return Whether any of them goes through one.
 */
INLINE bool march_begin(const Marching *marching, const Ray *ray, mask active, real limit,
                        bool is_shadow, March *march) {
    const real zero = real_of(0);
    WideVector start = vector_widen(ray->origin), heading = vector_widen(ray->direction);
    Ray local = *ray;
    if (marching->outer.is_any) {
        start = placing_take(&marching->outer, start);
        heading = placing_turn(&marching->outer, heading);
        local = ray_of(vector_narrow(start), vector_narrow(heading));
    }
    march->start = start;
    march->toward = march->heading = heading;
    march_aim(marching, march, ray->origin, is_shadow);
    march->far = limit;
    march->seeking = march->entering = march->found = mask_of(false);
    march->leaving = mask_of(true);
    march->side = real_of(1);
    march->from = march->entry = march->way = march->best_way = march->steps = zero;
    march->cell = (Vector){zero, zero, zero};
    march_head(march, &local);
    march->walking = active & (march->length > 0) & (march->length < INFINITE);
    if (marching->lattice.is_any) {
        lattice_begin(marching, march, &local);
    } else {
        march->walking = march_enter(marching, march, march->walking, start, limit);
    }
    return any(march->walking | march->entering);
}

/* --- steps ------------------------------------------------------------------------------------ */

/**
 * @return How fast the field grows along rays: the mean over the steps, of which the last count
 *         most; -1, the worst that can be, at first and after a step that was too long.
 * @param march    The rays, before #March.radius is new.
 * @param radius   What the field says now.
 * @param is_over  The lanes whose last step was too long.
 */
INLINE real march_slope(const March *march, real radius, mask is_over) {
    real last = (radius - march->radius) / march->step;
    real slope = march->slope + SLOPE_SHARE * (last - march->slope);
    mask is_known = (march->step > 0) & mask_not(is_over | march->leaving);
    return real_select(is_known, real_min(slope, real_of(SLOPE_MOST)), real_of(-1));
}

/**
 * Looks at what the field says where rays are: which have arrived, which have gone too far.
 * @param[in,out] march  The rays.
 * @param distance       What the field says.
 * @param tolerance      How near to the surface is on it.
 * @return The lanes whose last step was too long.
 */
INLINE mask march_look(March *march, real distance, real tolerance) {
    mask starts = march->walking & march->leaving;
    march->side = real_select(starts & (distance < 0), real_of(-1), march->side);
    march->side = real_select(starts & (distance >= 0), real_of(1), march->side);
    real radius = distance * march->side;
    march->leaving = march->leaving & mask_not(starts & (radius >= tolerance));
    mask is_over = (radius + march->radius < march->step) & (march->step > march->radius);
    mask counts = march->walking & mask_not(march->leaving | is_over);
    mask arrives = counts & (radius <= tolerance);
    mask is_better = counts & (radius < march->best);
    march->best = real_select(is_better, radius, march->best);
    march->best_way = real_select(is_better, march->way, march->best_way);
    march->found = march->found | arrives;
    march->walking = march->walking & mask_not(arrives);
    march->slope = march_slope(march, radius, is_over);
    march->radius =
        real_select(is_over, march->radius, real_select(march->leaving, tolerance, radius));
    return is_over;
}

/**
 * Steps on; or back, to where the last step would have been safe.
 * @param marching       The field.
 * @param[in,out] march  The rays.
 * @param is_over        The lanes that step back.
 * @return The lanes that have come through the box.
 */
INLINE mask march_step(const Marching *marching, March *march, mask is_over) {
    real radius = march->radius, left = march->end - march->way;
    // Where even the safe step goes out of the box, there is nothing more.
    mask stays = is_over | (radius <= left);
    // On a straight line of slope s, balls of r and r + s x touch at x = 2 r / (1 - s).
    real longer =
        marching->relaxation > 0 ? radius * marching->relaxation : 2 * radius / (1 - march->slope);
    longer = real_select(march->leaving, radius, longer);
    real change = real_select(is_over, radius - march->step, longer);
    march->step = real_select(is_over, radius, longer);
    // What is not yet known to be empty before the box ends is looked at there.
    real way = real_min(march->way + change, march->end);
    march->step = real_min(march->step, real_max(left, radius));
    march->way = real_select(march->walking & stays, way, march->way);
    return march->walking & mask_not(stays);
}

/** Gives up rays that are still on their way: those that came near enough have met the surface, and
 *  the others nothing. @param marching The field. @param[in,out] march The rays. */
static void march_give_up(const Marching *marching, March *march) {
    Vector point = march_point(march, march->best_way);
    real near = CANDIDATE_TOLERANCES * march_tolerance(marching, march, march->best_way, point);
    mask is_near = march->walking & (march->best <= near);
    march->way = real_select(is_near, march->best_way, march->way);
    march->found = march->found | is_near;
    stalls_add(marching->stalls, mask_count(march->walking & mask_not(is_near)));
}

/** Takes a step. @param marching The field. @param[in,out] march The rays. */
INLINE void march_walk(const Marching *marching, March *march) {
    Vector point = march_point(march, march->way);
    real distance = field_distance(marching->codes, marching->count, point, march->walking);
    real tolerance = march_tolerance(marching, march, march->way, point);
    mask passed = march_step(marching, march, march_look(march, distance, tolerance));
    march->walking = march->walking & mask_not(passed);
    march->seeking = march->seeking | passed;
}

/** Goes through one box. @param marching The field. @param[in,out] march The rays; walking are
 *  afterwards those that ran out of steps. */
static void march_box(const Marching *marching, March *march) {
    for (int i = 0; i < marching->max_steps && any(march->walking); i++) {
        march_walk(marching, march);
    }
}

/** Does what most rays want next, so that few wait in vain; what a ray does is the same in any
 *  company. @param marching The field. @param[in,out] march The rays, at least one. */
INLINE void lattice_go_on(const Marching *marching, March *march) {
    unsigned walking = mask_count(march->walking), seeking = mask_count(march->seeking),
             entering = mask_count(march->entering);
    if (walking > seeking && walking > entering) {
        march->steps = real_select(march->walking, march->steps + 1, march->steps);
        march_walk(marching, march);
    } else if (seeking >= entering) {
        march_seek(marching, march);
    } else {
        march_enter_copy(marching, march);
    }
}

/** Goes from cell to cell. @param marching The field. @param[in,out] march The rays; walking are
 *  afterwards those that ran out of steps. */
static void march_lattice(const Marching *marching, March *march) {
    mask tired = mask_of(false);
    while (any(march->walking | march->seeking | march->entering)) {
        lattice_go_on(marching, march);
        mask spent = march->steps >= real_of((scalar)marching->max_steps);
        march->best = real_select(spent & march->seeking, real_of(INFINITE), march->best);
        tired = tired | (spent & (march->walking | march->seeking));
        march->walking = march->walking & mask_not(spent);
        march->seeking = march->seeking & mask_not(spent);
    }
    march->walking = tired;
}

bool march_run(const Marching *marching, const Ray *ray, mask active, real limit, bool is_shadow,
               March *march) {
    if (!march_begin(marching, ray, active, limit, is_shadow, march)) {
        return false;
    }
    if (marching->lattice.is_any) {
        march_lattice(marching, march);
    } else {
        march_box(marching, march);
    }
    if (any(march->walking)) {
        march_give_up(marching, march);
    }
    return any(march->found);
}

/** As #march_box, and counts. @param marching The field. @param[in,out] march The rays. */
static void march_box_counted(const Marching *marching, March *march) {
    for (int i = 0; i < marching->max_steps && any(march->walking); i++) {
        march->steps = real_select(march->walking, march->steps + 1, march->steps);
        march_walk(marching, march);
    }
}

real march_count(const Marching *marching, const Ray *ray, mask active, real limit) {
    March march = {.found = mask_of(false)};
    if (!march_begin(marching, ray, active, limit, false, &march)) {
        return real_of(0);
    }
    if (marching->lattice.is_any) {
        march_lattice(marching, &march);
    } else {
        march_box_counted(marching, &march);
    }
    return march.steps;
}
