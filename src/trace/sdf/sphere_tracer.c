/**
 * @file
 * @brief Marching through a field.
 */
#include "trace/sdf/sphere_tracer.h"

#include "trace/bvh/slab.h"

/** A ray that runs out of steps has met the surface if it came within so many tolerances. */
#define SPHERE_TRACE_CANDIDATE_TOLERANCES 8
/** How much the last step counts in #SphereTrace.slope. */
#define SLOPE_SMOOTHING ((scalar)0.4f)
/** Largest slope that is counted on: steps are 2.5 times as long as allowed then. */
#define SLOPE_MAXIMUM ((scalar)0.2f)
/** What a cell counts for in the steps of a ray, exactly: without an end, it is given up. */
#define CELL_STEP_COST ((scalar)0x1p-4f)

/* --- where rays are marched ------------------------------------------------------------------- */

/** @return How long a vector is; squares of any stay in range. */
INLINE real vec3_length_in_range(Vec3 v) {
    real largest = vec3_max_abs(v);
    Vec3 d = {v.x / largest, v.y / largest, v.z / largest};
    return largest * real_sqrt(vec3_dot(d, d));
}

/**
 * Finds where rays go through the box in their cells.
 * @param[in,out] trace  The rays; where they go through it they stand before it.
 * @param start  Where they come into the cells, as the tape sees it.
 * @param available  How far they go in the cells, in those lengths.
 * @return Those that go through the box.
 */
INLINE mask sphere_trace_enter_box(const SphereTracer *tracer, SphereTrace *trace, mask lanes,
                                   Vec3w start, real available) {
    const real zero = real_of(0), none = real_of(INFINITE);
    const real *planes = tracer->box.planes;
    Vec3 origin = vec3_narrow(start);
    real near = zero, far = available;
    real footprint = sphere_trace_footprint(trace, trace->camera_distance -
                                                       trace->cell_entry * trace->direction_length);
    slab_clip(&near, &far, planes[0] - footprint, planes[3] + footprint, origin.x,
              trace->inverse_direction.x);
    slab_clip(&near, &far, planes[1] - footprint, planes[4] + footprint, origin.y,
              trace->inverse_direction.y);
    slab_clip(&near, &far, planes[2] - footprint, planes[5] + footprint, origin.z,
              trace->inverse_direction.z);
    mask enters = lanes & (near <= far * (1 + SLAB_SLACK)) & (near < none);
    origin = vec3_narrow(vec3w_add_scaled(start, trace->local_direction, widen(near)));
    real traveled = (trace->cell_entry + near) * trace->direction_length;
    // Whoever starts on the surface starts in the box, or just beside it.
    real margin = SDF_ERROR_TOLERANCES * tracer->bound_slack *
                  real_max(real_of(tracer->tolerance / tracer->scale),
                           trace->spread * trace->camera_distance);
    trace->camera_ahead =
        real_select(enters, trace->camera_distance - traveled, trace->camera_ahead);
    trace->box_entry = real_select(enters, near, trace->box_entry);
    trace->origin = vec3_select(enters, origin, trace->origin);
    trace->t_end = real_select(enters, (far - near) * trace->direction_length, trace->t_end);
    trace->leaving = trace->leaving & mask_not(enters & (traveled > margin));
    trace->t = real_select(enters, zero, trace->t);
    trace->step = real_select(enters, zero, trace->step);
    trace->radius = real_select(enters, zero, trace->radius);
    trace->slope = real_select(enters, real_of(-1), trace->slope);
    trace->best_radius = real_select(enters, none, trace->best_radius);
    return enters;
}

/** @return Where rays come into their cells, as the tape sees it. */
INLINE Vec3w sphere_trace_cell_start(const SphereTracer *tracer, const SphereTrace *trace) {
    Vec3w start =
        vec3w_add_scaled(trace->grid_origin, trace->grid_direction, widen(trace->cell_entry));
    start = vec3w_subtract(start, repeat_grid_cell_origin(&tracer->grid, trace->cell));
    return tracer->inner.is_present ? similarity_point_to_local(&tracer->inner, start) : start;
}

/** Brings rays to their next cells; those that come out of the lattice have ended. @return Those
 *  that are in a cell. */
INLINE mask sphere_trace_next_cell(const SphereTracer *tracer, SphereTrace *trace, mask lanes) {
    Vec3 exits = grid_walk_exits(&trace->walk, trace->cell);
    real t_exit = grid_walk_nearest_exit(exits);
    Vec3 next = grid_walk_next_cell(&trace->walk, trace->cell, exits, t_exit);
    lanes = lanes & (t_exit < trace->limit) & repeat_grid_has_cell(&tracer->grid, next);
    trace->cell = vec3_select(lanes, next, trace->cell);
    trace->cell_entry = real_select(lanes, t_exit, trace->cell_entry);
    trace->steps = real_select(lanes, trace->steps + CELL_STEP_COST, trace->steps);
    return lanes;
}

/** Looks for cells whose copy rays may meet, one cell on. */
INLINE void sphere_trace_seek_cell(const SphereTracer *tracer, SphereTrace *trace) {
    mask seeking = sphere_trace_next_cell(tracer, trace, trace->seeking);
    real footprint = sphere_trace_footprint(trace, trace->camera_distance -
                                                       trace->cell_entry * trace->direction_length);
    mask meets = seeking & grid_walk_may_hit_copy(&tracer->grid, &trace->walk, trace->cell,
                                                  footprint * (scalar)tracer->inner.scale);
    trace->entering = trace->entering | meets;
    trace->seeking = seeking & mask_not(meets);
}

/** Brings rays before the box of the copy in their cells; those that go by seek on. */
INLINE void sphere_trace_enter_copy(const SphereTracer *tracer, SphereTrace *trace) {
    real t_exit = grid_walk_nearest_exit(grid_walk_exits(&trace->walk, trace->cell));
    Vec3w start = sphere_trace_cell_start(tracer, trace);
    mask enters = sphere_trace_enter_box(tracer, trace, trace->entering, start,
                                         real_min(t_exit, trace->limit) - trace->cell_entry);
    trace->stepping = trace->stepping | enters;
    trace->seeking = trace->seeking | (trace->entering & mask_not(enters));
    trace->entering = mask_of(false);
}

/**
 * Says how finely the camera sees along rays.
 * @param origin  Where they start in the scene.
 * @param is_shadow  Whether they are on their way to a lamp.
 */
INLINE void sphere_trace_init_footprint(const SphereTracer *tracer, SphereTrace *trace, Vec3 origin,
                                        bool is_shadow) {
    const Footprint *footprint = tracer->footprint;
    trace->camera_distance = real_of(0);
    trace->spread = trace->spread_behind = 0;
    if (footprint) {
        Vec3 from_camera = vec3_subtract(origin, vec3_splat(footprint->camera_position));
        trace->camera_distance = real_sqrt(vec3_dot(from_camera, from_camera)) / tracer->scale;
        trace->spread = footprint->spread;
        // A shadow is as fine as what it falls on is seen, however far away its thrower is.
        trace->spread_behind = is_shadow ? 0 : footprint->spread;
    }
}

/** Says which way rays go as the tape sees it. */
INLINE void sphere_trace_set_direction(SphereTrace *trace, const Ray *ray) {
    trace->inverse_direction = ray->inverse_direction;
    trace->direction_length = vec3_length_in_range(ray->direction);
    trace->unit_direction = vec3_scale(ray->direction, 1 / trace->direction_length);
}

/**
 * Brings rays into the lattice.
 * @param[in,out] trace  The rays; walking are those that count.
 * @param ray  The same, as the lattice sees them.
 */
INLINE void sphere_trace_enter_grid(const SphereTracer *tracer, SphereTrace *trace,
                                    const Ray *ray) {
    real near;
    mask meets = slab_intersects(ray, &tracer->grid_box, trace->limit, &near);
    trace->walk = grid_walk_of(&tracer->grid, ray, trace->unit_direction);
    trace->cell_entry = real_max(near, real_of(0));
    trace->cell = repeat_grid_cell(
        &tracer->grid, vec3_add(ray->origin, vec3_scale(ray->direction, trace->cell_entry)));
    trace->entering = trace->stepping & meets & (trace->cell_entry < INFINITE);
    trace->stepping = mask_of(false);
    if (tracer->inner.is_present) {
        trace->local_direction =
            similarity_direction_to_local(&tracer->inner, trace->grid_direction);
        Vec3 local_direction = vec3_narrow(trace->local_direction);
        Ray local = ray_of(local_direction, local_direction);
        sphere_trace_set_direction(trace, &local);
    }
}

/**
 * Sends rays on their way.
 * @param limit  How far they look.
 * @param is_shadow  Whether they are on their way to a lamp.
 * @param[out] trace  The rays before the first box.
 * @return Whether any of them goes through one.
 */
INLINE bool sphere_trace_begin(const SphereTracer *tracer, const Ray *ray, mask active, real limit,
                               bool is_shadow, SphereTrace *trace) {
    const real zero = real_of(0);
    Vec3w start = vec3_widen(ray->origin), direction = vec3_widen(ray->direction);
    Ray local = *ray;
    if (tracer->outer.is_present) {
        start = similarity_point_to_local(&tracer->outer, start);
        direction = similarity_direction_to_local(&tracer->outer, direction);
        local = ray_of(vec3_narrow(start), vec3_narrow(direction));
    }
    trace->grid_origin = start;
    trace->grid_direction = trace->local_direction = direction;
    sphere_trace_init_footprint(tracer, trace, ray->origin, is_shadow);
    trace->limit = limit;
    trace->seeking = trace->entering = trace->arrived = mask_of(false);
    trace->leaving = mask_of(true);
    trace->side = real_of(1);
    trace->cell_entry = trace->box_entry = trace->t = trace->best_t = trace->steps = zero;
    trace->cell = (Vec3){zero, zero, zero};
    sphere_trace_set_direction(trace, &local);
    trace->stepping = active & (trace->direction_length > 0) & (trace->direction_length < INFINITE);
    if (tracer->grid.is_repeated) {
        sphere_trace_enter_grid(tracer, trace, &local);
    } else {
        trace->stepping = sphere_trace_enter_box(tracer, trace, trace->stepping, start, limit);
    }
    return any(trace->stepping | trace->entering);
}

/* --- steps ------------------------------------------------------------------------------------ */

/**
 * @return How fast the field grows along rays: the mean over the steps, of which the last count
 *         most; -1, the worst that can be, at first and after a step that was too long.
 * @param trace    The rays, before #SphereTrace.radius is new.
 * @param radius   What the field says now.
 * @param is_over  The lanes whose last step was too long.
 */
INLINE real sphere_trace_slope(const SphereTrace *trace, real radius, mask is_over) {
    real last = (radius - trace->radius) / trace->step;
    real slope = trace->slope + SLOPE_SMOOTHING * (last - trace->slope);
    mask is_known = (trace->step > 0) & mask_not(is_over | trace->leaving);
    return real_select(is_known, real_min(slope, real_of(SLOPE_MAXIMUM)), real_of(-1));
}

/**
 * Looks at what the field says where rays are: which have arrived, which have gone too far.
 * @param tolerance  How near to the surface is on it.
 * @return The lanes whose last step was too long.
 */
INLINE mask sphere_trace_evaluate(SphereTrace *trace, real distance, real tolerance) {
    mask starts = trace->stepping & trace->leaving;
    trace->side = real_select(starts & (distance < 0), real_of(-1), trace->side);
    trace->side = real_select(starts & (distance >= 0), real_of(1), trace->side);
    real radius = distance * trace->side;
    trace->leaving = trace->leaving & mask_not(starts & (radius >= tolerance));
    mask is_over = (radius + trace->radius < trace->step) & (trace->step > trace->radius);
    mask counts = trace->stepping & mask_not(trace->leaving | is_over);
    mask arrives = counts & (radius <= tolerance);
    mask is_better = counts & (radius < trace->best_radius);
    trace->best_radius = real_select(is_better, radius, trace->best_radius);
    trace->best_t = real_select(is_better, trace->t, trace->best_t);
    trace->arrived = trace->arrived | arrives;
    trace->stepping = trace->stepping & mask_not(arrives);
    trace->slope = sphere_trace_slope(trace, radius, is_over);
    trace->radius =
        real_select(is_over, trace->radius, real_select(trace->leaving, tolerance, radius));
    return is_over;
}

/**
 * Steps on; or back, to where the last step would have been safe.
 * @param is_over  The lanes that step back.
 * @return The lanes that have come through the box.
 */
INLINE mask sphere_trace_advance(const SphereTracer *tracer, SphereTrace *trace, mask is_over) {
    real radius = trace->radius, left = trace->t_end - trace->t;
    // Where even the safe step goes out of the box, there is nothing more.
    mask stays = is_over | (radius <= left);
    // On a straight line of slope s, balls of r and r + s x touch at x = 2 r / (1 - s).
    real relaxed =
        tracer->relaxation > 0 ? radius * tracer->relaxation : 2 * radius / (1 - trace->slope);
    relaxed = real_select(trace->leaving, radius, relaxed);
    real change = real_select(is_over, radius - trace->step, relaxed);
    trace->step = real_select(is_over, radius, relaxed);
    // What is not yet known to be empty before the box ends is looked at there.
    real t = real_min(trace->t + change, trace->t_end);
    trace->step = real_min(trace->step, real_max(left, radius));
    trace->t = real_select(trace->stepping & stays, t, trace->t);
    return trace->stepping & mask_not(stays);
}

/** Gives up rays that are still on their way: those that came near enough have met the surface, and
 *  the others nothing. */
static void sphere_trace_give_up(const SphereTracer *tracer, SphereTrace *trace) {
    Vec3 point = sphere_trace_point(trace, trace->best_t);
    real near = SPHERE_TRACE_CANDIDATE_TOLERANCES *
                sphere_trace_tolerance(tracer, trace, trace->best_t, point);
    mask is_near = trace->stepping & (trace->best_radius <= near);
    trace->t = real_select(is_near, trace->best_t, trace->t);
    trace->arrived = trace->arrived | is_near;
    step_limit_counter_add(tracer->step_limit_counter,
                           mask_count(trace->stepping & mask_not(is_near)));
}

/** Takes a step. */
INLINE void sphere_trace_step(const SphereTracer *tracer, SphereTrace *trace) {
    Vec3 point = sphere_trace_point(trace, trace->t);
    real distance =
        sdf_distance(tracer->program, tracer->instruction_count, point, trace->stepping);
    real tolerance = sphere_trace_tolerance(tracer, trace, trace->t, point);
    mask left_box =
        sphere_trace_advance(tracer, trace, sphere_trace_evaluate(trace, distance, tolerance));
    trace->stepping = trace->stepping & mask_not(left_box);
    trace->seeking = trace->seeking | left_box;
}

/** Goes through one box. @param[in,out] trace The rays; walking are afterwards those that ran out
 *  of steps. */
static void sphere_trace_in_box(const SphereTracer *tracer, SphereTrace *trace) {
    for (int i = 0; i < tracer->max_steps && any(trace->stepping); i++) {
        sphere_trace_step(tracer, trace);
    }
}

/** Does what most rays want next, so that few wait in vain; what a ray does is the same in any
 *  company. @param[in,out] trace The rays, at least one. */
INLINE void sphere_trace_grid_step(const SphereTracer *tracer, SphereTrace *trace) {
    unsigned walking = mask_count(trace->stepping), seeking = mask_count(trace->seeking),
             entering = mask_count(trace->entering);
    if (walking > seeking && walking > entering) {
        trace->steps = real_select(trace->stepping, trace->steps + 1, trace->steps);
        sphere_trace_step(tracer, trace);
    } else if (seeking >= entering) {
        sphere_trace_seek_cell(tracer, trace);
    } else {
        sphere_trace_enter_copy(tracer, trace);
    }
}

/** Goes from cell to cell. @param[in,out] trace The rays; walking are afterwards those that ran out
 *  of steps. */
static void sphere_trace_in_grid(const SphereTracer *tracer, SphereTrace *trace) {
    mask exhausted = mask_of(false);
    while (any(trace->stepping | trace->seeking | trace->entering)) {
        sphere_trace_grid_step(tracer, trace);
        mask at_step_limit = trace->steps >= real_of((scalar)tracer->max_steps);
        trace->best_radius =
            real_select(at_step_limit & trace->seeking, real_of(INFINITE), trace->best_radius);
        exhausted = exhausted | (at_step_limit & (trace->stepping | trace->seeking));
        trace->stepping = trace->stepping & mask_not(at_step_limit);
        trace->seeking = trace->seeking & mask_not(at_step_limit);
    }
    trace->stepping = exhausted;
}

bool sphere_trace_run(const SphereTracer *tracer, const Ray *ray, mask active, real limit,
                      bool is_shadow, SphereTrace *trace) {
    if (!sphere_trace_begin(tracer, ray, active, limit, is_shadow, trace)) {
        return false;
    }
    if (tracer->grid.is_repeated) {
        sphere_trace_in_grid(tracer, trace);
    } else {
        sphere_trace_in_box(tracer, trace);
    }
    if (any(trace->stepping)) {
        sphere_trace_give_up(tracer, trace);
    }
    return any(trace->arrived);
}

/** As #sphere_trace_in_box, and counts. */
static void sphere_trace_in_box_counted(const SphereTracer *tracer, SphereTrace *trace) {
    for (int i = 0; i < tracer->max_steps && any(trace->stepping); i++) {
        trace->steps = real_select(trace->stepping, trace->steps + 1, trace->steps);
        sphere_trace_step(tracer, trace);
    }
}

real sphere_trace_count_steps(const SphereTracer *tracer, const Ray *ray, mask active, real limit) {
    SphereTrace trace = {.arrived = mask_of(false)};
    if (!sphere_trace_begin(tracer, ray, active, limit, false, &trace)) {
        return real_of(0);
    }
    if (tracer->grid.is_repeated) {
        sphere_trace_in_grid(tracer, &trace);
    } else {
        sphere_trace_in_box_counted(tracer, &trace);
    }
    return trace.steps;
}
