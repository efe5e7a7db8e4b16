/**
 * @file
 * @brief Sphere tracing.
 */
#include "trace/sdf/sphere_tracer.h"

#include "trace/bvh/slab.h"

/** A ray that reaches the step limit has a hit if it came within so many tolerances. */
#define SPHERE_TRACE_CANDIDATE_TOLERANCES 8
/** Weight of the last step in #SphereTrace.slope. */
#define SLOPE_SMOOTHING ((scalar)0.4f)
/** Largest slope that is assumed: steps are then 2.5 times the distance. */
#define SLOPE_MAXIMUM ((scalar)0.2f)
/** Cost of a cell in steps, exact: rays end also in an infinite grid. */
#define CELL_STEP_COST ((scalar)0x1p-4f)

/* --- boxes and cells -------------------------------------------------------------------------- */

/** @return The lengths of vectors, without overflow of squares. */
INLINE real vec3_length_in_range(Vec3 v) {
    real largest = vec3_max_abs(v);
    Vec3 d = {v.x / largest, v.y / largest, v.z / largest};
    return largest * real_sqrt(vec3_dot(d, d));
}

/**
 * Intersects rays with the bounding box in their cells.
 * @param[in,out] trace  The rays; those that meet the box are moved to its entry.
 * @param start          Points of entry into the cells, in the coordinates of the program.
 * @param available      Distances to the end of the cells, in lengths of the direction.
 * @return The lanes that meet the box.
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
    // A ray that starts on the surface starts in the box or just beside it.
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

/** @return Points of entry into the cells, in the coordinates of the program. */
INLINE Vec3w sphere_trace_cell_start(const SphereTracer *tracer, const SphereTrace *trace) {
    Vec3w start =
        vec3w_add_scaled(trace->grid_origin, trace->grid_direction, widen(trace->cell_entry));
    start = vec3w_subtract(start, repeat_grid_cell_origin(&tracer->grid, trace->cell));
    return tracer->inner.is_present ? similarity_point_to_local(&tracer->inner, start) : start;
}

/** Moves rays to their next cells. @return The lanes that are still in the grid. */
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

/** Advances searching rays by one cell. */
INLINE void sphere_trace_seek_cell(const SphereTracer *tracer, SphereTrace *trace) {
    mask seeking = sphere_trace_next_cell(tracer, trace, trace->seeking);
    real footprint = sphere_trace_footprint(trace, trace->camera_distance -
                                                       trace->cell_entry * trace->direction_length);
    mask meets = seeking & grid_walk_may_hit_copy(&tracer->grid, &trace->walk, trace->cell,
                                                  footprint * (scalar)tracer->inner.scale);
    trace->entering = trace->entering | meets;
    trace->seeking = seeking & mask_not(meets);
}

/** Intersects rays with the box of the copy in their cells; those that miss it search on. */
INLINE void sphere_trace_enter_copy(const SphereTracer *tracer, SphereTrace *trace) {
    real t_exit = grid_walk_nearest_exit(grid_walk_exits(&trace->walk, trace->cell));
    Vec3w start = sphere_trace_cell_start(tracer, trace);
    mask enters = sphere_trace_enter_box(tracer, trace, trace->entering, start,
                                         real_min(t_exit, trace->limit) - trace->cell_entry);
    trace->stepping = trace->stepping | enters;
    trace->seeking = trace->seeking | (trace->entering & mask_not(enters));
    trace->entering = mask_of(false);
}

/** Initialises the footprint of pixels along rays. @param origin Origins in the scene. */
INLINE void sphere_trace_init_footprint(const SphereTracer *tracer, SphereTrace *trace, Vec3 origin,
                                        bool is_shadow) {
    const Footprint *footprint = tracer->footprint;
    trace->camera_distance = real_of(0);
    trace->spread = trace->spread_behind = 0;
    if (footprint) {
        Vec3 from_camera = vec3_subtract(origin, vec3_splat(footprint->camera_position));
        trace->camera_distance = real_sqrt(vec3_dot(from_camera, from_camera)) / tracer->scale;
        trace->spread = footprint->spread;
        // The detail of a shadow is visible at its receiver, however far the occluder is.
        trace->spread_behind = is_shadow ? 0 : footprint->spread;
    }
}

/** Sets the directions in the coordinates of the program. */
INLINE void sphere_trace_set_direction(SphereTrace *trace, const Ray *ray) {
    trace->inverse_direction = ray->inverse_direction;
    trace->direction_length = vec3_length_in_range(ray->direction);
    trace->unit_direction = vec3_scale(ray->direction, 1 / trace->direction_length);
}

/**
 * Moves rays to the grid.
 * @param[in,out] trace  The rays; #SphereTrace.stepping are those that count.
 * @param ray            The rays in the coordinates of the grid.
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
 * Initialises rays before the first box.
 * @param limit      Largest distances.
 * @param is_shadow  Whether they are shadow rays.
 * @return Whether any of them can meet a box.
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
 * @return The slope of the field along rays: an exponential mean over the steps; -1, the smallest
 *         possible, at first and after a step that was too long.
 * @param trace    The rays, before the update of #SphereTrace.radius.
 * @param radius   Current distances.
 * @param is_over  Lanes whose last step was too long.
 */
INLINE real sphere_trace_slope(const SphereTrace *trace, real radius, mask is_over) {
    real last = (radius - trace->radius) / trace->step;
    real slope = trace->slope + SLOPE_SMOOTHING * (last - trace->slope);
    mask is_known = (trace->step > 0) & mask_not(is_over | trace->leaving);
    return real_select(is_known, real_min(slope, real_of(SLOPE_MAXIMUM)), real_of(-1));
}

/**
 * Evaluates the field: finds hits and steps that were too long.
 * @param distance   Distances of the field.
 * @param tolerance  Distances that count as a hit.
 * @return Lanes whose last step was too long.
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
 * Steps forwards, or back to the end of a safe step.
 * @param is_over  Lanes that step back.
 * @return Lanes that have left the box.
 */
INLINE mask sphere_trace_advance(const SphereTracer *tracer, SphereTrace *trace, mask is_over) {
    real radius = trace->radius, left = trace->t_end - trace->t;
    // If the safe step leaves the box, there is no hit in it.
    mask stays = is_over | (radius <= left);
    // For a constant slope s, spheres of radius r and r + s x touch at x = 2 r / (1 - s).
    real relaxed =
        tracer->relaxation > 0 ? radius * tracer->relaxation : 2 * radius / (1 - trace->slope);
    relaxed = real_select(trace->leaving, radius, relaxed);
    real change = real_select(is_over, radius - trace->step, relaxed);
    trace->step = real_select(is_over, radius, relaxed);
    // A longer step ends at the exit of the box: the rest before it is not known to be empty.
    real t = real_min(trace->t + change, trace->t_end);
    trace->step = real_min(trace->step, real_max(left, radius));
    trace->t = real_select(trace->stepping & stays, t, trace->t);
    return trace->stepping & mask_not(stays);
}

/** Ends rays that have reached the step limit: those that came near enough have a hit, the others
 *  none. */
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

/** Makes one step. */
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

/** Traces rays through one box. @param[in,out] trace The rays; #SphereTrace.stepping are afterwards
 *  those that have reached the step limit. */
static void sphere_trace_in_box(const SphereTracer *tracer, SphereTrace *trace) {
    for (int i = 0; i < tracer->max_steps && any(trace->stepping); i++) {
        sphere_trace_step(tracer, trace);
    }
}

/** Does what most rays need next: step, search or entry. The path of a ray does not depend on the
 *  others. @param[in,out] trace The rays, at least one. */
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

/** Traces rays from cell to cell. @param[in,out] trace The rays; #SphereTrace.stepping are
 * afterwards those that have reached the step limit. */
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

/** Records the step that the first lane makes next: the field is evaluated where the step evaluates
 *  it. */
static void march_log_add(MarchLog *log, const SphereTracer *tracer, const SphereTrace *trace) {
    if (log && mask_lane(trace->stepping, 0) && log->count < log->capacity) {
        Vec3 point = sphere_trace_point(trace, trace->t);
        real distance =
            sdf_distance(tracer->program, tracer->instruction_count, point, trace->stepping);
        double scale = (double)tracer->scale;
        log->steps[log->count++] =
            (RayMarchStep){(double)real_lane(sphere_trace_distance(trace), 0) * log->length,
                           fabs((double)real_lane(distance, 0)) * scale};
    }
}

/** #sphere_trace_in_box with a count of steps. @param log See #sphere_trace_count_steps. */
static void sphere_trace_in_box_counted(const SphereTracer *tracer, SphereTrace *trace,
                                        MarchLog *log) {
    for (int i = 0; i < tracer->max_steps && any(trace->stepping); i++) {
        march_log_add(log, tracer, trace);
        trace->steps = real_select(trace->stepping, trace->steps + 1, trace->steps);
        sphere_trace_step(tracer, trace);
    }
}

/** #sphere_trace_in_grid, which counts its steps anyway, with a log. */
static void sphere_trace_in_grid_logged(const SphereTracer *tracer, SphereTrace *trace,
                                        MarchLog *log) {
    while (any(trace->stepping | trace->seeking | trace->entering) &&
           !any(trace->steps >= real_of((scalar)tracer->max_steps))) {
        real steps = trace->steps;
        MarchLog before = *log;
        march_log_add(log, tracer, trace);
        sphere_trace_grid_step(tracer, trace);
        // Whole steps evaluate the field; a step from cell to cell does not.
        if (!mask_lane(trace->steps >= steps + 1, 0)) {
            log->count = before.count;
        }
    }
}

real sphere_trace_count_steps(const SphereTracer *tracer, const Ray *ray, mask active, real limit,
                              MarchLog *log) {
    SphereTrace trace = {.arrived = mask_of(false)};
    if (!sphere_trace_begin(tracer, ray, active, limit, false, &trace)) {
        return real_of(0);
    }
    if (tracer->grid.is_repeated && log) {
        sphere_trace_in_grid_logged(tracer, &trace, log);
    } else if (tracer->grid.is_repeated) {
        sphere_trace_in_grid(tracer, &trace);
    } else {
        sphere_trace_in_box_counted(tracer, &trace, log);
    }
    return trace.steps;
}
