/**
 * @file
 * @brief Sdf: the surface of a distance field, found by marching.
 *
 * Marching ends just before the surface (see march.h); then hits are brought onto it by the
 * derivative of the field, which gives the normal, too.
 */
#include "trace/shapes/sdf.h"

#include "trace/mesh/mesh_bvh.h"
#include "trace/sdf/sphere_tracer.h"
#include "trace/shapes/registry.h"

/** Tolerances that a hit is moved at most to be on the surface. */
#define SPHERE_TRACE_REFINE_TOLERANCES 64

/** The surface of a field. @extends Shape */
typedef struct SdfShape {
    Shape base;          /**< What all shapes have. */
    SphereTracer tracer; /**< The field; its tape lies behind this object. */
    Aabbs box;           /**< A box that holds all points within the tolerance. */
} SdfShape;

/** Fields of `sdf`. */
static const Parameter sdf_shape_parameters[] = {
    {.name = "field",
     .type = PARAMETER_SDF,
     .offset = offsetof(SdfParameters, field),
     .unit = "field",
     .help = "the field; it may also stand first, without a name"},
    {.name = "tolerance",
     .type = PARAMETER_NUMBER,
     .offset = offsetof(SdfParameters, tolerance),
     .minimum = LENGTH_MINIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "scene units",
     .help = "how near to the surface is on it"},
    {.name = "max_steps",
     .type = PARAMETER_INTEGER,
     .offset = offsetof(SdfParameters, max_steps),
     .minimum = 1,
     .maximum = 1000000,
     .unit = "steps",
     .help = "after so many a ray is given up"},
    {0}};

/** A tolerance that no pixel shows. */
static const SdfParameters sdf_shape_defaults = {.tolerance = 1e-4, .max_steps = 512};

/** Refuses shapes without a field. See #Keyword.finish. @return Whether there is one. */
static bool sdf_shape_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    return ((SdfParameters *)values)->field ||
           error_set(error, STATUS_SCENE,
                     "sdf needs a field, such as sdf { distance.sphere { radius = 1 } }");
}

/** @return Bytes of the tape. See #ShapeClass.tail_size. */
static size_t sdf_shape_tail(const void *parameters) {
    return (size_t)((const SdfParameters *)parameters)->field->node_count * sizeof(SdfInstruction);
}

/** Makes it. */
static void sdf_shape_init(Shape *self, const void *parameters) {
    SdfShape *shape = (SdfShape *)self;
    const SdfParameters *p = parameters;
    shape->tracer = (SphereTracer){
        .program = shape_tail(self), .tolerance = (scalar)p->tolerance, .max_steps = p->max_steps};
    sphere_tracer_init(&shape->tracer, p->field, &shape->box);
}

/**
 * Finds where to count. See #ShapeClass.bind_mesh.
 * @param scene_shape  As the scene has it.
 * @return true
 */
static bool sdf_shape_bind(Shape *self, const SceneShape *scene_shape, MeshBvhCache *cache,
                           Error *error) {
    (void)error;
    SphereTracer *tracer = &((SdfShape *)self)->tracer;
    tracer->step_limit_counter = &cache->step_limit_counter;
    tracer->relaxation = cache->relaxation;
    // A transformed shape does not know where the eye is.
    tracer->footprint = scene_shape->transform ? NULL : &cache->footprint;
    return true;
}

/* --- hits ------------------------------------------------------------------------------------- */

/** Brings rays that have arrived nearer to the surface, by the derivative along the ray (Newton):
 *  by a few tolerances at most, and only where it helps. @param[in,out] sample What the field says
 *  where they are. */
INLINE void sphere_trace_refine(const SphereTracer *tracer, SphereTrace *trace, SdfSample *sample,
                                real tolerance) {
    real slope = vec3_dot(sample->gradient, trace->unit_direction);
    real change = -sample->distance / slope;
    mask is_small =
        trace->arrived & (real_abs(change) <= SPHERE_TRACE_REFINE_TOLERANCES * tolerance);
    if (!any(is_small)) {
        return;
    }
    real t = real_select(is_small, trace->t + change, trace->t);
    SdfSample refined = sdf_sample(tracer->program, tracer->instruction_count,
                                   sphere_trace_point(trace, t), trace->arrived);
    mask is_nearer = is_small & (real_abs(refined.distance) < real_abs(sample->distance)) & (t > 0);
    trace->t = real_select(is_nearer, t, trace->t);
    sample->distance = real_select(is_nearer, refined.distance, sample->distance);
    sample->gradient = vec3_select(is_nearer, refined.gradient, sample->gradient);
}

/**
 * @return What rays have met.
 * @param sample  What the field says there.
 * @param distance  How far it is.
 */
INLINE Hit sdf_shape_make_hit(const SdfShape *shape, const SphereTrace *trace,
                              const SdfSample *sample, real tolerance, real distance) {
    const SphereTracer *tracer = &shape->tracer;
    // Where the field is level in all directions, as in the middle of a ball, any normal is right.
    real square = vec3_dot(sample->gradient, sample->gradient);
    Vec3 gradient =
        vec3_select(square > 0, sample->gradient, vec3_scale(trace->unit_direction, real_of(-1)));
    Vec3 normal = vec3_normalize(gradient), point = sphere_trace_point(trace, trace->t);
    Hit found = hit_none(distance);
    point = vec3_subtract(point, vec3_scale(normal, sample->distance));
    found.point = sphere_trace_world_point(tracer, trace, point);
    found.normal = sphere_trace_world_direction(tracer, normal);
    found.error = SDF_ERROR_TOLERANCES * real_max(tolerance * tracer->scale,
                                                  SDF_ERROR * ROUNDOFF * vec3_max_abs(found.point));
    found.shape = integer_of(shape->base.index);
    return found;
}

/** @return The lanes where the shape is nearer. See #ShapeClass.is_hit. @callgraph */
static mask sdf_shape_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const SdfShape *shape = (const SdfShape *)self;
    const SphereTracer *tracer = &shape->tracer;
    SphereTrace trace;
    if (!sphere_trace_run(tracer, ray, active, hit->distance, false, &trace)) {
        return mask_of(false);
    }
    Vec3 point = sphere_trace_point(&trace, trace.t);
    real tolerance = sphere_trace_tolerance(tracer, &trace, trace.t, point);
    SdfSample sample = sdf_sample(tracer->program, tracer->instruction_count, point, trace.arrived);
    sphere_trace_refine(tracer, &trace, &sample, tolerance);
    real distance = sphere_trace_distance(&trace);
    mask nearer = hit_is_nearer(hit, trace.arrived, distance, self->index);
    Hit found = sdf_shape_make_hit(shape, &trace, &sample, tolerance, distance);
    hit_update(hit, nearer, &found);
    return nearer;
}

/** @return The lanes where the shape is on the way. See #ShapeClass.is_occluding. */
static mask sdf_shape_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    SphereTrace trace;
    if (!sphere_trace_run(&((const SdfShape *)self)->tracer, ray, active, limit, true, &trace)) {
        return mask_of(false);
    }
    real distance = sphere_trace_distance(&trace);
    return trace.arrived & (distance > 0) & (distance < limit);
}

/** @return How many steps rays take to it. See #ShapeClass.count_steps. */
static real sdf_shape_steps(const Shape *self, const Ray *ray, mask active, real limit) {
    return sphere_trace_count_steps(&((const SdfShape *)self)->tracer, ray, active, limit);
}

/** @return The box around the shape. */
static Aabbs sdf_shape_bounds(const Shape *self) {
    return ((const SdfShape *)self)->box;
}

const ShapeClass sdf_class = {
    .keyword = {.name = "sdf",
                .help = "the surface of a distance field, found by marching",
                .parameters = sdf_shape_parameters,
                .size = sizeof(SdfParameters),
                .defaults = &sdf_shape_defaults,
                .finish = sdf_shape_finish},
    .size = sizeof(SdfShape),
    .tail_size = sdf_shape_tail,
    .init = sdf_shape_init,
    .bind_mesh = sdf_shape_bind,
    .is_hit = sdf_shape_is_hit,
    .is_occluding = sdf_shape_is_occluding,
    .bounds = sdf_shape_bounds,
    .count_steps = sdf_shape_steps,
};
