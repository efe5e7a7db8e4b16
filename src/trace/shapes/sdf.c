/**
 * @file
 * @brief Sdf: the surface of a signed distance field, found by sphere tracing.
 *
 * Sphere tracing ends just before the surface (sphere_tracer.h). The derivative of the field then
 * moves the hit onto it, and gives the normal.
 */
#include "trace/mesh/mesh_bvh.h"
#include "trace/sdf/sdf_vm.h"
#include "trace/sdf/sphere_tracer.h"

/** Largest correction of a hit, in tolerances. */
#define SPHERE_TRACE_REFINE_TOLERANCES 64

/** The surface of a field. @extends Shape */
typedef struct SdfShape {
    Shape base;          /**< Base. */
    SphereTracer tracer; /**< The field; its program lies behind this object. */
    Aabbs box;           /**< Box of all points within the tolerance. */
} SdfShape;

/** @return Bytes of the program. See #ShapeExtension.tail_size. */
static size_t sdf_shape_tail(const void *parameters) {
    return sdf_program_size(((const SdfShapeParameters *)parameters)->field);
}

/** See #ShapeClass.init. */
static void sdf_shape_init(Shape *self, const void *parameters) {
    SdfShape *shape = (SdfShape *)self;
    const SdfShapeParameters *p = parameters;
    shape->tracer = (SphereTracer){.tolerance = (scalar)p->tolerance, .max_steps = p->max_steps};
    sphere_tracer_init(&shape->tracer, p->field, shape_tail(self), &shape->box);
}

/** Connects the sphere tracer with step counter, relaxation and footprint. See
 * #ShapeExtension.bind.
 *  @return true */
static bool sdf_shape_bind(Shape *self, const SceneShape *scene_shape, MeshBvhCache *cache,
                           Error *error) {
    (void)error;
    SphereTracer *tracer = &((SdfShape *)self)->tracer;
    tracer->step_limit_counter = &cache->step_limit_counter;
    tracer->relaxation = cache->relaxation;
    // Inside a transformed shape, the camera is not known in local coordinates.
    tracer->footprint = scene_shape->transform ? NULL : &cache->footprint;
    return true;
}

/* --- hits ------------------------------------------------------------------------------------- */

/** Moves hits along their rays to the surface by one Newton step, of a few tolerances at most, and
 *  only where it decreases the distance. It goes forwards: a ray whose limit lies just before the
 *  hit has ended there, and must not miss what a ray without limit hits. @param[in,out] sample The
 *  field at the hits. */
INLINE void sphere_trace_refine(const SphereTracer *tracer, SphereTrace *trace, SdfSample *sample,
                                real tolerance) {
    real slope = vec3_dot(sample->gradient, trace->unit_direction);
    real change = -sample->distance / slope;
    mask is_small =
        trace->arrived & (change > 0) & (change <= SPHERE_TRACE_REFINE_TOLERANCES * tolerance);
    if (!any(is_small)) {
        return;
    }
    real t = real_select(is_small, trace->t + change, trace->t);
    SdfSample refined = sdf_sample(&tracer->program, sphere_trace_point(trace, t), trace->arrived);
    mask is_nearer = is_small & (real_abs(refined.distance) < real_abs(sample->distance));
    trace->t = real_select(is_nearer, t, trace->t);
    sample->distance = real_select(is_nearer, refined.distance, sample->distance);
    sample->gradient = vec3_select(is_nearer, refined.gradient, sample->gradient);
}

/** @return The points on the surface. @param sample The field at the hits. */
INLINE SurfacePoint sdf_shape_surface(const SphereTracer *tracer, const SphereTrace *trace,
                                      const SdfSample *sample, real tolerance) {
    // Where the gradient is zero, as at the centre of a sphere, any normal is valid.
    real square = vec3_dot(sample->gradient, sample->gradient);
    Vec3 gradient =
        vec3_select(square > 0, sample->gradient, vec3_scale(trace->unit_direction, real_of(-1)));
    Vec3 normal = vec3_normalize(gradient), point = sphere_trace_point(trace, trace->t);
    point = vec3_subtract(point, vec3_scale(normal, sample->distance));
    point = sphere_trace_world_point(tracer, trace, point);
    real roundings = SDF_ERROR * ROUNDOFF * vec3_max_abs(point);
    return (SurfacePoint){point, sphere_trace_world_direction(tracer, normal),
                          SDF_ERROR_TOLERANCES * real_max(tolerance * tracer->scale, roundings)};
}

/** Updates hits by the rays that have arrived. @param trace Those. @return The replaced lanes. */
INLINE mask sdf_shape_update_hit(const Shape *self, SphereTrace *trace, Hit *hit) {
    const SphereTracer *tracer = &((const SdfShape *)self)->tracer;
    Vec3 point = sphere_trace_point(trace, trace->t);
    real tolerance = sphere_trace_tolerance(tracer, trace, trace->t, point);
    SdfSample sample = sdf_sample(&tracer->program, point, trace->arrived);
    sphere_trace_refine(tracer, trace, &sample, tolerance);
    real distance = sphere_trace_distance(trace);
    mask nearer = hit_is_nearer(hit, trace->arrived, distance, self->index);
    SurfacePoint surface = sdf_shape_surface(tracer, trace, &sample, tolerance);
    shape_update_hit(self, hit, nearer, distance, &surface);
    return nearer;
}

/** See #ShapeClass.is_hit. @callgraph */
static mask sdf_shape_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    SphereTrace trace;
    return sphere_trace_run(&((const SdfShape *)self)->tracer, ray, active, hit->distance, false,
                            &trace)
               ? sdf_shape_update_hit(self, &trace, hit)
               : mask_of(false);
}

/** @return The rays that a field occludes. @param trace The rays. */
INLINE mask sdf_shape_occluded_lanes(const SphereTrace *trace, real limit) {
    real distance = sphere_trace_distance(trace);
    return trace->arrived & (distance > 0) & (distance < limit);
}

/** See #ShapeClass.is_occluding. */
static mask sdf_shape_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    SphereTrace trace;
    return sphere_trace_run(&((const SdfShape *)self)->tracer, ray, active, limit, true, &trace)
               ? sdf_shape_occluded_lanes(&trace, limit)
               : mask_of(false);
}

#if LANES > 1

/** See #ShapeExtension.closest_hits. @callgraph */
static void sdf_shape_closest_hits(const Shape *self, const Packet *packet, Hit *hits) {
    SphereTrace traces[PACKET_VECTORS];
    real limits[PACKET_VECTORS];
    for (int v = 0; v < packet_vector_count(packet); v++) {
        limits[v] = hits[v].distance;
    }
    sphere_trace_run_packet(&((const SdfShape *)self)->tracer, packet, packet->active, limits,
                            false, traces);
    for (int v = 0; v < packet_vector_count(packet); v++) {
        if (any(traces[v].arrived)) {
            sdf_shape_update_hit(self, &traces[v], &hits[v]);
        }
    }
}

/** See #ShapeExtension.occluded. */
static void sdf_shape_occluded(const Shape *self, const Packet *packet, mask *occluded) {
    SphereTrace traces[PACKET_VECTORS];
    mask pending[PACKET_VECTORS];
    for (int v = 0; v < packet_vector_count(packet); v++) {
        pending[v] = packet->active[v] & mask_not(occluded[v]);
    }
    sphere_trace_run_packet(&((const SdfShape *)self)->tracer, packet, pending, packet->limit, true,
                            traces);
    for (int v = 0; v < packet_vector_count(packet); v++) {
        if (any(traces[v].arrived)) {
            occluded[v] |= sdf_shape_occluded_lanes(&traces[v], packet->limit[v]);
        }
    }
}

#endif

/** See #ShapeExtension.count_steps. */
static real sdf_shape_count_steps(const Shape *self, const Ray *ray, mask active, real limit,
                                  MarchLog *log) {
    return sphere_trace_count_steps(&((const SdfShape *)self)->tracer, ray, active, limit, log);
}

/** See #ShapeClass.bounds. */
static Aabbs sdf_shape_bounds(const Shape *self) {
    return ((const SdfShape *)self)->box;
}

/** A distance field has a program of any length, and counts its steps. It takes packets, so that
 *  rays of one vector take the lanes of another's finished ones. */
static const ShapeExtension sdf_shape_extension = {
    .tail_size = sdf_shape_tail,
    .bind = sdf_shape_bind,
#if LANES > 1
    .closest_hits = sdf_shape_closest_hits,
    .occluded = sdf_shape_occluded,
#endif
    .count_steps = sdf_shape_count_steps,
};

/** Methods of `sdf`. */
const ShapeClass sdf_class = {
    .size = sizeof(SdfShape),
    .init = sdf_shape_init,
    .is_hit = sdf_shape_is_hit,
    .is_occluding = sdf_shape_is_occluding,
    .bounds = sdf_shape_bounds,
    .extension = &sdf_shape_extension,
};
