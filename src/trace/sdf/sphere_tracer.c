/**
 * @file
 * @brief Sphere tracing.
 */
#include "trace/sdf/sphere_tracer.h"

#include "trace/bvh/slab.h"
#include "trace/sdf/march_queue.h"
#include "trace/sdf/sdf_vm.h"

#include <string.h>

/** A ray that reaches the step limit has a hit if it was within so many tolerances before its last
 *  step. */
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
 * @param cell_length    Distances to the end of the cells, in lengths of the direction.
 * @return The lanes that meet the box before their limit.
 */
INLINE mask sphere_trace_enter_box(const SphereTracer *tracer, SphereTrace *trace, mask lanes,
                                   Vec3w start, real cell_length) {
    const real zero = real_of(0), none = real_of(INFINITE);
    const real *planes = tracer->box.planes;
    Vec3 origin = vec3_narrow(start);
    real near = zero, far = cell_length;
    // Rounded up: at worst, a ray makes a step in vain.
    real limit = trace->limit * (1 + SLAB_SLACK) - trace->cell_entry;
    // Only beside a copy in a grid: what is known of a whole field, by which rays are culled, is
    // its box alone.
    real footprint =
        tracer->grid.is_repeated
            ? sphere_trace_footprint(trace, trace->camera_distance -
                                                trace->cell_entry * trace->direction_length)
            : zero;
    slab_clip(&near, &far, planes[0] - footprint, planes[3] + footprint, origin.x,
              trace->inverse_direction.x);
    slab_clip(&near, &far, planes[1] - footprint, planes[4] + footprint, origin.y,
              trace->inverse_direction.y);
    slab_clip(&near, &far, planes[2] - footprint, planes[5] + footprint, origin.z,
              trace->inverse_direction.z);
    mask is_in_reach = (near <= limit) & (near < none);
    mask enters = lanes & (near <= far * (1 + SLAB_SLACK)) & is_in_reach;
    origin = vec3_narrow(vec3w_add_scaled(start, trace->local_direction, widen(near)));
    real traveled = (trace->cell_entry + near) * trace->direction_length;
    // A ray that starts on the surface starts in the box or just beside it.
    real margin =
        SDF_ERROR_TOLERANCES * tracer->bound_slack *
        real_max(real_of(tracer->local_tolerance), trace->spread * trace->camera_distance);
    trace->camera_ahead =
        real_select(enters, trace->camera_distance - traveled, trace->camera_ahead);
    trace->box_entry = real_select(enters, near, trace->box_entry);
    trace->origin = vec3_select(enters, origin, trace->origin);
    trace->t_end = real_select(enters, (far - near) * trace->direction_length, trace->t_end);
    trace->t_limit = real_select(enters, (limit - near) * trace->direction_length, trace->t_limit);
    trace->leaving = trace->leaving & mask_not(enters & (traveled > margin));
    trace->t = real_select(enters, zero, trace->t);
    trace->step = real_select(enters, zero, trace->step);
    trace->radius = real_select(enters, zero, trace->radius);
    trace->slope = real_select(enters, real_of(-1), trace->slope);
    return enters;
}

/** @return Points of entry into the cells, in the coordinates of the program. */
INLINE Vec3w sphere_trace_cell_start(const SphereTracer *tracer, const SphereTrace *trace) {
    Vec3w start =
        vec3w_add_scaled(trace->grid_origin, trace->grid_direction, widen(trace->cell_entry));
    start = vec3w_subtract(start, repeat_grid_cell_origin(&tracer->grid, trace->cell));
    return tracer->inner.is_present ? similarity_point_to_local(&tracer->inner, start) : start;
}

/** @return Whether rays have reached the step limit. */
INLINE mask sphere_trace_at_limit(const SphereTracer *tracer, const SphereTrace *trace) {
    return trace->steps >= real_of((scalar)tracer->max_steps);
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

/** @return Whether the search of a cell is what most rays need next. */
INLINE bool sphere_trace_seeks(const SphereTrace *trace) {
    unsigned seeking = mask_count(trace->seeking);
    return seeking >= mask_count(trace->stepping) && seeking >= mask_count(trace->entering);
}

/** Advances searching rays by one cell, and by further ones while most rays search. */
INLINE void sphere_trace_seek_cell(const SphereTracer *tracer, SphereTrace *trace) {
    do {
        mask lanes = sphere_trace_next_cell(tracer, trace, trace->seeking);
        real footprint = sphere_trace_footprint(
            trace, trace->camera_distance - trace->cell_entry * trace->direction_length);
        mask meets = lanes & grid_walk_may_hit_copy(&tracer->grid, &trace->walk, trace->cell,
                                                    footprint * (scalar)tracer->inner.scale);
        trace->entering = trace->entering | meets;
        trace->seeking = lanes & mask_not(meets);
    } while (any(trace->seeking) && sphere_trace_seeks(trace) &&
             !any(trace->seeking & sphere_trace_at_limit(tracer, trace)));
}

/** Intersects rays with the box of the copy in their cells; those that miss it search on. */
INLINE void sphere_trace_enter_copy(const SphereTracer *tracer, SphereTrace *trace) {
    real t_exit = grid_walk_nearest_exit(grid_walk_exits(&trace->walk, trace->cell));
    Vec3w start = sphere_trace_cell_start(tracer, trace);
    mask enters =
        sphere_trace_enter_box(tracer, trace, trace->entering, start, t_exit - trace->cell_entry);
    trace->stepping = trace->stepping | enters;
    trace->seeking = trace->seeking | (trace->entering & mask_not(enters));
    trace->entering = mask_of(false);
}

/** Sets the widths of pixels, which all rays share. */
INLINE void sphere_trace_set_spread(const SphereTracer *tracer, SphereTrace *trace,
                                    bool is_shadow) {
    trace->spread = tracer->footprint ? tracer->footprint->spread : 0;
    // The detail of a shadow is visible at its receiver, however far the occluder is.
    trace->spread_behind = is_shadow ? 0 : trace->spread;
}

/** Initialises the footprint of pixels along rays. @param origin Origins in the scene. */
INLINE void sphere_trace_init_footprint(const SphereTracer *tracer, SphereTrace *trace, Vec3 origin,
                                        bool is_shadow) {
    const Footprint *footprint = tracer->footprint;
    sphere_trace_set_spread(tracer, trace, is_shadow);
    trace->camera_distance = real_of(0);
    if (footprint) {
        Vec3 from_camera = vec3_subtract(origin, vec3_splat(footprint->camera_position));
        trace->camera_distance = real_sqrt(vec3_dot(from_camera, from_camera)) / tracer->scale;
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
    trace->cell_entry = trace->box_entry = trace->t = trace->steps = zero;
    trace->cell = (Vec3){zero, zero, zero};
    sphere_trace_set_direction(trace, &local);
    trace->stepping = active & (trace->direction_length > 0) & (trace->direction_length < INFINITE);
    if (tracer->grid.is_repeated) {
        sphere_trace_enter_grid(tracer, trace, &local);
    } else {
        trace->stepping =
            sphere_trace_enter_box(tracer, trace, trace->stepping, start, real_of(INFINITE));
    }
    return any(trace->stepping | trace->entering);
}

/** #sphere_trace_begin for rays without a packet; not inlined, as it is long and called twice. */
static __attribute__((noinline)) bool sphere_trace_begin_alone(const SphereTracer *tracer,
                                                               const Ray *ray, mask active,
                                                               real limit, bool is_shadow,
                                                               SphereTrace *trace) {
    return sphere_trace_begin(tracer, ray, active, limit, is_shadow, trace);
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

/** Finds out on which side of the surface rays start, and which of them have left it. */
INLINE void sphere_trace_leave(SphereTrace *trace, real distance, real tolerance) {
    mask starts = trace->stepping & trace->leaving;
    trace->side = real_select(starts & (distance < 0), real_of(-1), trace->side);
    trace->side = real_select(starts & (distance >= 0), real_of(1), trace->side);
    trace->leaving = trace->leaving & mask_not(starts & (distance * trace->side >= tolerance));
}

/**
 * Evaluates the field: finds hits and steps that were too long.
 * @param distance   Distances of the field.
 * @param tolerance  Distances that count as a hit.
 * @return Lanes whose last step was too long.
 */
INLINE mask sphere_trace_evaluate(SphereTrace *trace, real distance, real tolerance) {
    if (any(trace->stepping & trace->leaving)) {
        sphere_trace_leave(trace, distance, tolerance);
    }
    real radius = distance * trace->side;
    mask is_over = (radius + trace->radius < trace->step) & (trace->step > trace->radius);
    mask counts = trace->stepping & mask_not(trace->leaving | is_over);
    mask arrives = counts & (radius <= tolerance);
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
 * @return Lanes that have left the box or passed their limit.
 */
INLINE mask sphere_trace_advance(const SphereTracer *tracer, SphereTrace *trace, mask is_over) {
    real radius = trace->radius, left = trace->t_end - trace->t;
    // If the safe step leaves the box, there is no hit in it; if it passes the limit, none before
    // that. The limit changes no step: the path does not depend on what the ray has hit before.
    mask stays = is_over | (radius <= real_min(left, trace->t_limit - trace->t));
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

/** Ends rays: those that are near enough have a hit at the end of their safe step, the others none.
 *  @param exhausted Those that have reached the step limit, in a box or in search of one. @return
 *  Number of those without hit. */
INLINE unsigned sphere_trace_give_up(const SphereTracer *tracer, SphereTrace *trace,
                                     mask exhausted) {
    real t = trace->t - trace->step + trace->radius;
    Vec3 point = sphere_trace_point(trace, t);
    real near = SPHERE_TRACE_CANDIDATE_TOLERANCES * sphere_trace_tolerance(tracer, trace, t, point);
    mask has_left = mask_not(trace->leaving) & (trace->step > 0);
    mask is_near = exhausted & trace->stepping & has_left & (trace->radius <= near);
    trace->t = real_select(is_near, t, trace->t);
    trace->arrived = trace->arrived | is_near;
    trace->stepping = trace->stepping & mask_not(exhausted);
    trace->seeking = trace->seeking & mask_not(exhausted);
    return mask_count(exhausted & mask_not(is_near));
}

/** Begins a step. @return The points at which it needs the distance. */
INLINE Vec3 sphere_trace_step_points(SphereTrace *trace) {
    trace->steps = real_select(trace->stepping, trace->steps + 1, trace->steps);
    return sphere_trace_point(trace, trace->t);
}

/** Makes the rest of a step. @param distance Distances of the field at the points. */
INLINE void sphere_trace_step_on(const SphereTracer *tracer, SphereTrace *trace, Vec3 point,
                                 real distance) {
    real tolerance = sphere_trace_tolerance(tracer, trace, trace->t, point);
    mask left_box =
        sphere_trace_advance(tracer, trace, sphere_trace_evaluate(trace, distance, tolerance));
    trace->stepping = trace->stepping & mask_not(left_box);
    if (tracer->grid.is_repeated) {
        trace->seeking = trace->seeking | left_box;
    }
}

/** Makes one step. */
INLINE void sphere_trace_step(const SphereTracer *tracer, SphereTrace *trace) {
    Vec3 point = sphere_trace_step_points(trace);
    real distance = sdf_distance(&tracer->program, point, trace->stepping);
    sphere_trace_step_on(tracer, trace, point, distance);
}

/** Does what most rays need next: a step, the search of a cell or the entry into a box. The path of
 * a ray does not depend on the others. */
INLINE void sphere_trace_grid_step(const SphereTracer *tracer, SphereTrace *trace) {
    if (sphere_trace_seeks(trace)) {
        sphere_trace_seek_cell(tracer, trace);
    } else if (mask_count(trace->stepping) > mask_count(trace->entering)) {
        sphere_trace_step(tracer, trace);
    } else {
        sphere_trace_enter_copy(tracer, trace);
    }
}

/** @return The rays that neither have a hit nor have left the field. */
INLINE mask sphere_trace_unfinished(const SphereTrace *trace) {
    return trace->stepping | trace->seeking | trace->entering;
}

/** Ends the rays that have reached the step limit. @return Number of those without hit. */
INLINE unsigned sphere_trace_end_exhausted(const SphereTracer *tracer, SphereTrace *trace) {
    mask exhausted = sphere_trace_at_limit(tracer, trace) & (trace->stepping | trace->seeking);
    return any(exhausted) ? sphere_trace_give_up(tracer, trace, exhausted) : 0;
}

/** Makes the next step of rays, and ends those that have reached the step limit. @param[in,out]
 *  trace The rays, at least one unfinished. @return Number of rays that ended there without hit. */
static unsigned sphere_trace_continue(const SphereTracer *tracer, SphereTrace *trace) {
    if (tracer->grid.is_repeated) {
        sphere_trace_grid_step(tracer, trace);
    } else {
        sphere_trace_step(tracer, trace);
    }
    return sphere_trace_end_exhausted(tracer, trace);
}

bool sphere_trace_run(const SphereTracer *tracer, const Ray *ray, mask active, real limit,
                      bool is_shadow, SphereTrace *trace) {
    if (!sphere_trace_begin_alone(tracer, ray, active, limit, is_shadow, trace)) {
        return false;
    }
    while (any(sphere_trace_unfinished(trace))) {
        step_limit_counter_add(tracer->step_limit_counter, sphere_trace_continue(tracer, trace));
    }
    return any(trace->arrived);
}

/* --- packets ---------------------------------------------------------------------------------- */

#if LANES > 1

/** Finished rays of a vector from which on others take their places: a quarter or three quarters
 *  were slower (measured). */
enum { MARCH_FREE_LANES = LANES / 2 };

/** The rays of a packet while they are traced. */
typedef struct MarchPacket {
    const SphereTracer *tracer; /**< The field. */
    const Packet *packet;       /**< The rays. */
    const mask *active;         /**< Lanes that count, per vector. */
    const real *limits;         /**< Largest distances, per vector. */
    bool is_shadow;             /**< Whether they are shadow rays. */
    SphereTrace *traces;        /**< Their first states, per vector, and the hits. */
    int begun;                  /**< Number of vectors that have begun. */
    MarchQueue queue;           /**< Rays of these that wait. */
} MarchPacket;

/** Begins vectors of rays until there are enough for a whole one; not inlined, as it is long and
 *  rarely called. @param is_repeated Whether the field has a grid. */
static __attribute__((noinline)) void march_packet_begin_vectors(MarchPacket *march,
                                                                 bool is_repeated) {
    while (march->queue.count < LANES && march->begun < packet_vector_count(march->packet)) {
        int v = march->begun++;
        SphereTrace *trace = &march->traces[v];
        trace->arrived = mask_of(false);
        if (any(march->active[v]) &&
            sphere_trace_begin(march->tracer, &march->packet->rays[v], march->active[v],
                               march->limits[v], march->is_shadow, trace)) {
            trace->ray = integer_of(v * LANES) + lane_numbers();
            march_queue_push(&march->queue, trace, mask_bits(sphere_trace_unfinished(trace)),
                             is_repeated);
        }
    }
}

/** Fills the lanes of finished rays, if enough of them are. @return Whether there is an unfinished
 *  ray. */
INLINE bool march_packet_fill(MarchPacket *march, SphereTrace *trace, bool is_repeated) {
    unsigned bits = mask_bits(sphere_trace_unfinished(trace));
    if (__builtin_popcount(bits) > LANES - MARCH_FREE_LANES) {
        return true;
    }
    march_packet_begin_vectors(march, is_repeated);
    if (march->queue.count == 0) {
        return bits != 0;
    }
    if (bits) {
        march_queue_push(&march->queue, trace, bits, is_repeated);
    }
    march_queue_pop(&march->queue, trace, is_repeated);
    return true;
}

/** Writes the hits of a vector to the vectors that its rays come from. */
INLINE void march_packet_finish(MarchPacket *march, SphereTrace *trace, bool is_repeated) {
    if (any(trace->arrived)) {
        march_results_write(trace, march->traces, is_repeated);
        trace->arrived = mask_of(false);
    }
}

/** Makes all steps of two vectors, each in turn. */
INLINE void march_packet_run_in_turn(MarchPacket *march, SphereTrace *vectors) {
    const SphereTracer *tracer = march->tracer;
    const bool is_repeated = tracer->grid.is_repeated;
    bool is_unfinished = true;
    while (is_unfinished) {
        is_unfinished = false;
        for (SphereTrace *trace = vectors; trace < vectors + MARCH_VECTORS; trace++) {
            if (march_packet_fill(march, trace, is_repeated)) {
                is_unfinished = true;
                step_limit_counter_add(tracer->step_limit_counter,
                                       sphere_trace_continue(tracer, trace));
                march_packet_finish(march, trace, is_repeated);
            }
        }
    }
}

/** Begins the next step of a vector, in a field without grid; not inlined, as it is called twice.
 *  @param[out] points Where it needs the distance. @return Whether there is an unfinished ray. */
static __attribute__((noinline)) bool march_packet_begin_step(MarchPacket *march,
                                                              SphereTrace *trace, Vec3 *points) {
    bool is_unfinished = march_packet_fill(march, trace, false);
    *points = sphere_trace_step_points(trace);
    return is_unfinished;
}

/** Makes the rest of the step. @param distances Distances of the field at the points. */
static __attribute__((noinline)) void march_packet_end_step(MarchPacket *march, SphereTrace *trace,
                                                            const Vec3 *points,
                                                            const real *distances) {
    const SphereTracer *tracer = march->tracer;
    sphere_trace_step_on(tracer, trace, *points, *distances);
    step_limit_counter_add(tracer->step_limit_counter, sphere_trace_end_exhausted(tracer, trace));
    march_packet_finish(march, trace, false);
}

/** Makes all steps of two vectors together, in a field without grid that prefers it. */
static void march_packet_run_together(MarchPacket *march, SphereTrace *vectors) {
    for (;;) {
        Vec3 points[MARCH_VECTORS];
        mask active[MARCH_VECTORS];
        real distances[MARCH_VECTORS];
        bool is_unfinished = false;
        for (int v = 0; v < MARCH_VECTORS; v++) {
            is_unfinished |= march_packet_begin_step(march, &vectors[v], &points[v]);
            active[v] = vectors[v].stepping;
        }
        if (!is_unfinished) {
            return;
        }
        sdf_distances(&march->tracer->program, points, active, MARCH_VECTORS, distances);
        for (int v = 0; v < MARCH_VECTORS; v++) {
            march_packet_end_step(march, &vectors[v], &points[v], &distances[v]);
        }
    }
}

void sphere_trace_run_packet(const SphereTracer *tracer, const Packet *packet, const mask *active,
                             const real *limits, bool is_shadow, SphereTrace *traces) {
    MarchPacket march; // An initializer would clear 20 KB of columns.
    march.tracer = tracer;
    march.packet = packet;
    march.active = active;
    march.limits = limits;
    march.is_shadow = is_shadow;
    march.traces = traces;
    march.begun = 0;
    march.queue.count = 0;
    SphereTrace vectors[MARCH_VECTORS];
    const bool is_together = !tracer->grid.is_repeated && sdf_prefers_vectors(&tracer->program);
    if (is_together) {
        memset(vectors, 0, sizeof vectors); // One that gets no ray takes part in the steps.
    }
    for (int v = 0; v < MARCH_VECTORS; v++) {
        sphere_trace_set_spread(tracer, &vectors[v], is_shadow);
        vectors[v].stepping = vectors[v].seeking = vectors[v].entering = vectors[v].arrived =
            mask_of(false);
    }
    if (is_together) {
        march_packet_run_together(&march, vectors);
    } else {
        march_packet_run_in_turn(&march, vectors);
    }
}

#endif

/* --- records ---------------------------------------------------------------------------------- */

/** Records the step that the first lane makes next: the field is evaluated where the step evaluates
 *  it, for that lane alone. */
static void march_log_add(MarchLog *log, const SphereTracer *tracer, const SphereTrace *trace) {
    if (!mask_lane(trace->stepping, 0)) {
        return;
    }
    Vec3 point = sphere_trace_point(trace, trace->t);
    real distance =
        sdf_distance_counted(&tracer->program, point, mask_of_bits(1), &log->operations);
    if (log->count < log->capacity) {
        double scale = (double)tracer->scale;
        log->steps[log->count++] =
            (RayMarchStep){(double)real_lane(sphere_trace_distance(trace), 0) * log->length,
                           fabs((double)real_lane(distance, 0)) * scale};
    }
}

real sphere_trace_count_steps(const SphereTracer *tracer, const Ray *ray, mask active, real limit,
                              MarchLog *log) {
    SphereTrace trace = {.arrived = mask_of(false)};
    if (!sphere_trace_begin_alone(tracer, ray, active, limit, false, &trace)) {
        return real_of(0);
    }
    while (any(sphere_trace_unfinished(&trace))) {
        real steps = trace.steps;
        const MarchLog before = log ? *log : (MarchLog){0};
        if (log) {
            march_log_add(log, tracer, &trace);
        }
        sphere_trace_continue(tracer, &trace);
        // Whole steps evaluate the field; a step from cell to cell does not.
        if (log && !mask_lane(trace.steps >= steps + 1, 0)) {
            *log = before;
        }
    }
    return trace.steps;
}
