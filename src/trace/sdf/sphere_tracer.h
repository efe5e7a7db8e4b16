/**
 * @file
 * @brief Sphere tracing: intersection of rays with the surface of a distance field.
 *
 * A ray steps by the distance of the field until it is nearer than the tolerance (Hart, *Sphere
 * Tracing*, 1996). Steps are longer than that (over-relaxation); where the empty spheres around the
 * old and the new point do not overlap, a surface may lie between them, and the step is taken back
 * (Keinert and others, *Enhanced Sphere Tracing*, 2014). The factor follows from the recent slope
 * of the field: in front of a plane the two spheres just touch (Bálint and Valasek, *Accelerating
 * Sphere Tracing*, 2018; Bán and Valasek, *Automatic Step Size Relaxation*, 2023). Rays only step
 * inside the bounding box of the field, cell by cell if it is repeated.
 */
#ifndef DIOPTRE_TRACE_SDF_SPHERE_TRACER_H
#define DIOPTRE_TRACE_SDF_SPHERE_TRACER_H

#include "trace/sdf/repeat_grid.h"
#include "trace/sdf/sdf_program.h"
#include "trace/sdf/similarity.h"
#include "trace/sdf/step_limit.h"
#include "trace/tracer/footprint.h"
#include "trace/tracer/packet.h"

/** Bound on the error of a hit, and ray offset, in tolerances: farther than where tracing ends. */
#define SDF_ERROR_TOLERANCES 2
/** Bound on the error of a distance, in half ulps of the coordinates, with room for long programs.
 */
#define SDF_ERROR 16

/** A field, prepared for sphere tracing. */
typedef struct SphereTracer {
    SdfProgram program;         /**< Program of the field; its memory is the shape's. */
    Similarity outer;           /**< Transform of the whole field. */
    RepeatGrid grid;            /**< Repetition in the coordinates of #outer. */
    Similarity inner;           /**< Transform of each copy in its cell. */
    Aabb grid_box;              /**< Bounding box of all copies, in the coordinates of #outer. */
    Aabb box;                   /**< Bounding box of one copy, in the coordinates of #inner. */
    scalar scale;               /**< Scene units per unit of the program. */
    scalar tolerance;           /**< Distance that counts as a hit, scene units. */
    scalar local_tolerance;     /**< The same in units of the program. */
    scalar bound_slack;         /**< See #Sdf.bound_slack. */
    scalar relaxation;          /**< Over-relaxation factor of steps; 0: automatic. */
    int max_steps;              /**< Largest number of steps per ray. */
    const Footprint *footprint; /**< Size of a pixel; NULL: only #tolerance counts. */
    StepLimitCounter *step_limit_counter; /**< Counts rays that reach #max_steps. */
} SphereTracer;

/** State of LANES rays. Lengths are in units of the program unless noted otherwise. */
typedef struct SphereTrace {
    integer ray;            /**< Indices of the rays in their packet, if they come from one. */
    Vec3w grid_origin;      /**< Origin in the coordinates of the grid. */
    Vec3w grid_direction;   /**< Direction in the coordinates of the grid. */
    GridWalk walk;          /**< Traversal of the grid. */
    real limit;             /**< Largest distance, in lengths of the direction. */
    Vec3 cell;              /**< Current cell. */
    Vec3w local_direction;  /**< Direction in the coordinates of the program. */
    Vec3 unit_direction;    /**< The same, of length 1. */
    Vec3 inverse_direction; /**< 1 / #local_direction. */
    real direction_length;  /**< Length of #local_direction. */
    real cell_entry;        /**< Distance to the cell, in lengths of the direction. */
    real box_entry;         /**< Distance from there to the box, in lengths of the direction. */
    Vec3 origin;            /**< Point of entry into the box, or origin inside it. */
    real t_end;             /**< Distance from #origin to the exit. */
    real t_limit;           /**< Distance from #origin to the limit. */
    real camera_distance;   /**< Distance of the camera from the origin of the ray. */
    real camera_ahead;      /**< What is left of it at #origin. */
    scalar spread;          /**< See #Footprint. */
    scalar spread_behind;   /**< The same behind the camera. */
    mask seeking;           /**< Lanes in search of a cell whose copy they may meet. */
    mask entering;          /**< Lanes before the box of such a copy. */
    mask stepping;          /**< Lanes inside the box. */
    real slope;             /**< Recent slope of the field along the ray. */
    real steps;             /**< Number of steps so far. */
    mask leaving;           /**< Lanes that have not left the surface of their origin yet. */
    mask arrived;           /**< Lanes with a hit. */
    real side;              /**< 1: outside; -1: inside. */
    real t;                 /**< Distance from #origin. */
    real step;              /**< Last step. */
    real radius;            /**< Distance of the field before the last step. */
} SphereTrace;

/**
 * Prepares a field, except for #SphereTracer.footprint, #SphereTracer.relaxation and
 * #SphereTracer.step_limit_counter.
 * @param[in,out] tracer  Tolerance and number of steps are set.
 * @param memory          Memory for the program: see #sdf_program_size.
 * @param[out] bounds     Bounding box of all points within the tolerance.
 */
void sphere_tracer_init(SphereTracer *tracer, const Sdf *sdf, void *memory, Aabbs *bounds);

/**
 * Intersects rays with the surface.
 * @param limit       Largest distances.
 * @param is_shadow   Whether they are shadow rays.
 * @param[out] trace  The final state: #SphereTrace.arrived, #sphere_trace_distance.
 * @return Whether any ray has a hit.
 */
bool sphere_trace_run(const SphereTracer *tracer, const Ray *ray, mask active, real limit,
                      bool is_shadow, SphereTrace *trace);

/**
 * #sphere_trace_run for the rays of a packet, in engines of several lanes.
 * @param packet       The rays.
 * @param active       Lanes that count, per vector.
 * @param limits       Largest distances, per vector.
 * @param is_shadow    Whether they are shadow rays.
 * @param[out] traces  What #sphere_trace_distance and hits need, per vector. Where nothing arrived,
 *                     only that is set.
 */
void sphere_trace_run_packet(const SphereTracer *tracer, const Packet *packet, const mask *active,
                             const real *limits, bool is_shadow, SphereTrace *traces);

/** @return Number of steps of rays until they hit or miss the surface. @param active Lanes that
 *  count; others make no step. @param limit Largest distances. @param log Gets the steps and
 *  operations of the first lane; NULL: steps are only counted. */
real sphere_trace_count_steps(const SphereTracer *tracer, const Ray *ray, mask active, real limit,
                              MarchLog *log);

/** @return Points of rays in the coordinates of the program. */
INLINE Vec3 sphere_trace_point(const SphereTrace *trace, real t) {
    return vec3_add(trace->origin, vec3_scale(trace->unit_direction, t));
}

/** @return The size of details that the camera does not resolve. @param camera_ahead Distance from
 * the camera, along the ray. */
INLINE real sphere_trace_footprint(const SphereTrace *trace, real camera_ahead) {
    return real_max(trace->spread * camera_ahead, -trace->spread_behind * camera_ahead);
}

/** @return The distance that counts as a hit: the tolerance, the rounding errors and the footprint
 * of the pixel limit it from below. */
INLINE real sphere_trace_tolerance(const SphereTracer *tracer, const SphereTrace *trace, real t,
                                   Vec3 point) {
    real least =
        real_max(real_of(tracer->local_tolerance), SDF_ERROR * ROUNDOFF * vec3_max_abs(point));
    return real_max(least, sphere_trace_footprint(trace, trace->camera_ahead - t));
}

/** @return The distances of rays, in lengths of their direction. */
INLINE real sphere_trace_distance(const SphereTrace *trace) {
    wide t = widen(trace->box_entry) + widen(trace->t / trace->direction_length);
    return narrow(widen(trace->cell_entry) + t);
}

/** @return Points in the coordinates of the scene. @param point Points of the program. */
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

/** @return Directions in the coordinates of the scene. @param direction Directions of the program.
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
