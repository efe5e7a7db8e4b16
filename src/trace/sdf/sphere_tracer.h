/**
 * @file
 * @brief Marching: how rays find the surface of a field.
 *
 * A ray steps as far as the field allows until it is as near as the tolerance (Hart, *Sphere
 * Tracing*, 1996). Steps are made longer than allowed; where the ball around the new point does not
 * touch the one around the last, something may lie between them, and the step is taken back
 * (Keinert and others, *Enhanced Sphere Tracing*, 2014). How much longer follows from how the field
 * has changed of late: before a plane, the two balls then just touch (Bálint and Valasek,
 * *Accelerating Sphere Tracing*, 2018; Bán and Valasek, *Automatic Step Size Relaxation*, 2023).
 * Only what may hold a surface is marched: the way through the field's box, cell by cell where it
 * is repeated.
 */
#ifndef DIOPTRE_TRACE_SDF_SPHERE_TRACER_H
#define DIOPTRE_TRACE_SDF_SPHERE_TRACER_H

#include "trace/sdf/repeat_grid.h"
#include "trace/sdf/sdf_program.h"
#include "trace/sdf/similarity.h"
#include "trace/sdf/step_limit.h"
#include "trace/tracer/footprint.h"
#include "trace/tracer/packet.h"

/** Tolerances that a hit may be off, and that rays which leave it start away: farther than where a
 *  march ends. */
#define SDF_ERROR_TOLERANCES 2
/** Half ulps of the coordinates that a distance can be wrong by, with room for long tapes. */
#define SDF_ERROR 16

/** A field as rays see it. */
typedef struct SphereTracer {
    SdfInstruction *program;    /**< Its tape; the shape's. */
    int instruction_count;      /**< How many steps it has. */
    Similarity outer;           /**< Where all of it stands. */
    RepeatGrid grid;            /**< How it is repeated there. */
    Similarity inner;           /**< Where each copy stands in its cell. */
    Aabb grid_box;              /**< All copies, in the outer placing. */
    Aabb box;                   /**< One of them, in the inner placing. */
    scalar scale;               /**< Scene units of a unit of the tape. */
    scalar tolerance;           /**< How near to the surface is on it, scene units. */
    scalar bound_slack;         /**< See #Sdf.bound_slack. */
    scalar relaxation;          /**< How much longer than allowed a step is; 0: as it pays. */
    int max_steps;              /**< Steps after which a ray is given up. */
    const Footprint *footprint; /**< How finely the camera sees; NULL: by the tolerance alone. */
    StepLimitCounter *step_limit_counter; /**< Counts the rays that were given up. */
} SphereTracer;

/** LANES rays on their way. Lengths are those of the tape unless it is said otherwise. */
typedef struct SphereTrace {
    Vec3w grid_origin;      /**< Where it starts, as the lattice sees it. */
    Vec3w grid_direction;   /**< Its direction there. */
    GridWalk walk;          /**< How it goes through the lattice. */
    real limit;             /**< How far it looks, in lengths of the direction. */
    Vec3 cell;              /**< The cell where it is. */
    Vec3w local_direction;  /**< Its direction as the tape sees it. */
    Vec3 unit_direction;    /**< The same, one long. */
    Vec3 inverse_direction; /**< 1 / #local_direction. */
    real direction_length;  /**< Of #local_direction. */
    real cell_entry;        /**< Where it comes into the cell, in lengths of the direction. */
    real box_entry;         /**< How much later into the box there, in the same lengths. */
    Vec3 origin;            /**< Where that is; or where it starts in the box. */
    real t_end;             /**< From there: where it leaves the box, or has come too far. */
    real camera_distance;   /**< How far the eye is from where it starts. */
    real camera_ahead;      /**< How much of that is left at #origin. */
    scalar spread;          /**< See #Footprint. */
    scalar spread_behind;   /**< The same behind the eye. */
    mask seeking;           /**< The lanes that look for a cell whose copy they may meet. */
    mask entering;          /**< Those that stand before one. */
    mask stepping;          /**< Those that walk through its box. */
    real slope;             /**< How fast the field grows along the ray, of late. */
    real steps;             /**< How many they have made. */
    mask leaving;           /**< Those that have not yet left the surface that they started on. */
    mask arrived;           /**< Those that have arrived. */
    real side;              /**< 1: outside; -1: inside. */
    real t;                 /**< How far they are, from #origin. */
    real step;              /**< The last step. */
    real radius;            /**< How far they might have gone. */
    real best_radius;       /**< The nearest to the surface that they were. */
    real best_t;            /**< Where. */
} SphereTrace;

/**
 * Makes a field ready for rays, but for #SphereTracer.footprint and
 * #SphereTracer.step_limit_counter.
 * @param[in,out] tracer  Its tape has room; tolerance, relaxation and steps are filled.
 * @param[out] bounds  A box that holds all points within the tolerance.
 */
void sphere_tracer_init(SphereTracer *tracer, const Sdf *sdf, Aabbs *bounds);

/**
 * Finds where rays meet the surface.
 * @param limit  How far they look.
 * @param is_shadow  Whether they are on their way to a lamp.
 * @param[out] trace  Where they are, and which have arrived.
 * @return Whether any has.
 */
bool sphere_trace_run(const SphereTracer *tracer, const Ray *ray, mask active, real limit,
                      bool is_shadow, SphereTrace *trace);

/**
 * @return How many steps rays make to where they meet the surface, or to where they find none.
 * @param active  The lanes that count; the others make none.
 * @param limit  How far they look.
 */
real sphere_trace_count_steps(const SphereTracer *tracer, const Ray *ray, mask active, real limit);

/** @return The points where rays are, as the tape sees them. */
INLINE Vec3 sphere_trace_point(const SphereTrace *trace, real t) {
    return vec3_add(trace->origin, vec3_scale(trace->unit_direction, t));
}

/**
 * @return How large a thing the camera does not see.
 * @param camera_ahead  How much nearer they are than the eye.
 */
INLINE real sphere_trace_footprint(const SphereTrace *trace, real camera_ahead) {
    return real_max(trace->spread * camera_ahead, -trace->spread_behind * camera_ahead);
}

/** @return How near to the surface is on it: as near as roundings let one see, and as finely as the
 *  camera does. */
INLINE real sphere_trace_tolerance(const SphereTracer *tracer, const SphereTrace *trace, real t,
                                   Vec3 point) {
    real least = real_max(real_of(tracer->tolerance / tracer->scale),
                          SDF_ERROR * ROUNDOFF * vec3_max_abs(point));
    return real_max(least, sphere_trace_footprint(trace, trace->camera_ahead - t));
}

/** @return How far rays are, in lengths of their direction. */
INLINE real sphere_trace_distance(const SphereTrace *trace) {
    wide t = widen(trace->box_entry) + widen(trace->t / trace->direction_length);
    return narrow(widen(trace->cell_entry) + t);
}

/**
 * @return Points as the scene sees them.
 * @param point  Points of the tape.
 */
INLINE Vec3 sphere_trace_world_point(const SphereTracer *tracer, const SphereTrace *trace,
                                     Vec3 point) {
    Vec3w p = vec3_widen(point);
    if (tracer->inner.is_present) {
        p = similarity_point_to_world(&tracer->inner, p);
    }
    if (tracer->grid.is_repeated) {
        p = vec3w_add_scaled(p, repeat_grid_cell_origin(&tracer->grid, trace->cell), wide_of(1));
    }
    return vec3_narrow(tracer->outer.is_present ? similarity_point_to_world(&tracer->outer, p) : p);
}

/**
 * @return Directions as the scene sees them.
 * @param direction  Those of the tape.
 */
INLINE Vec3 sphere_trace_world_direction(const SphereTracer *tracer, Vec3 direction) {
    Vec3w d = vec3_widen(direction);
    if (tracer->inner.is_present) {
        d = similarity_direction_to_world(&tracer->inner, d);
    }
    return vec3_narrow(tracer->outer.is_present ? similarity_direction_to_world(&tracer->outer, d)
                                                : d);
}

#endif
