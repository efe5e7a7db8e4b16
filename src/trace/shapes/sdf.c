/**
 * @file
 * @brief Sdf: the surface of a distance field, found by marching.
 *
 * Marching ends just before the surface (see march.h); then hits are brought onto it by the
 * derivative of the field, which gives the normal, too.
 */
#include "trace/shapes/sdf.h"

#include "trace/march.h"
#include "trace/model.h"
#include "trace/shapes/registry.h"

/** Tolerances that a hit is moved at most to be on the surface. */
#define REFINE_TOLERANCES 64

/** The surface of a field. @extends Shape */
typedef struct Sdf {
    Shape base;        /**< What all shapes have. */
    Marching marching; /**< The field; its tape lies behind this object. */
    Bounds box;        /**< A box that holds all points within the tolerance. */
} Sdf;

/** Fields of `sdf`. */
static const Parameter sdf_parameters[] = {
    {.name = "field",
     .type = PARAMETER_FIELD,
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
static const SdfParameters sdf_defaults = {.tolerance = 1e-4, .max_steps = 512};

/** Refuses shapes without a field. See #Keyword.finish. @param[in,out] values An #SdfParameters.
 *  @param given Not looked at. @param[out] error What is wrong. @return Whether there is one. */
static bool sdf_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    return ((SdfParameters *)values)->field ||
           error_set(error, STATUS_SCENE,
                     "sdf needs a field, such as sdf { distance.sphere { radius = 1 } }");
}

/** @return Bytes of the tape. See #ShapeClass.tail. @param parameters An #SdfParameters. */
static size_t sdf_tail(const void *parameters) {
    return (size_t)((const SdfParameters *)parameters)->field->count * sizeof(FieldCode);
}

/** Makes it. @param self The shape. @param parameters An #SdfParameters. */
static void sdf_init(Shape *self, const void *parameters) {
    Sdf *sdf = (Sdf *)self;
    const SdfParameters *p = parameters;
    sdf->marching = (Marching){
        .codes = shape_tail(self), .tolerance = (scalar)p->tolerance, .max_steps = p->max_steps};
    marching_init(&sdf->marching, p->field, &sdf->box);
}

/** Finds where to count. See #ShapeClass.bind. @param self The shape. @param said As the scene has
 *  it. @param models All models. @param[out] error Not used. @return true */
static bool sdf_bind(Shape *self, const SceneShape *said, Models *models, Error *error) {
    (void)error;
    Marching *marching = &((Sdf *)self)->marching;
    marching->stalls = &models->stalls;
    marching->relaxation = models->relaxation;
    // A transformed shape does not know where the eye is.
    marching->footprint = said->transform ? NULL : &models->footprint;
    return true;
}

/* --- hits ------------------------------------------------------------------------------------- */

/**
 * Brings rays that have arrived nearer to the surface, by the derivative along the ray (Newton): by
 * a few tolerances at most, and only where it helps.
 * @param marching  The field.
 * @param[in,out] march  The rays.
 * @param[in,out] here   What the field says where they are.
 * @param tolerance The tolerance there.
 */
INLINE void march_refine(const Marching *marching, March *march, FieldSample *here,
                         real tolerance) {
    real slope = vector_dot(here->gradient, march->direction);
    real change = -here->distance / slope;
    mask is_small = march->found & (real_abs(change) <= REFINE_TOLERANCES * tolerance);
    if (!any(is_small)) {
        return;
    }
    real way = real_select(is_small, march->way + change, march->way);
    FieldSample there =
        field_sample(marching->codes, marching->count, march_point(march, way), march->found);
    mask is_nearer = is_small & (real_abs(there.distance) < real_abs(here->distance)) & (way > 0);
    march->way = real_select(is_nearer, way, march->way);
    here->distance = real_select(is_nearer, there.distance, here->distance);
    here->gradient = vector_select(is_nearer, there.gradient, here->gradient);
}

/** @return What rays have met. @param sdf The shape. @param march The rays. @param here What the
 *  field says there. @param tolerance The tolerance there. @param distance How far it is. */
INLINE Hit sdf_hit(const Sdf *sdf, const March *march, const FieldSample *here, real tolerance,
                   real distance) {
    const Marching *marching = &sdf->marching;
    // Where the field is level in all directions, as in the middle of a ball, any normal is right.
    real square = vector_dot(here->gradient, here->gradient);
    Vector gradient =
        vector_select(square > 0, here->gradient, vector_scale(march->direction, real_of(-1)));
    Vector normal = vector_normalize(gradient), point = march_point(march, march->way);
    Hit found = hit_nothing(distance);
    point = vector_subtract(point, vector_scale(normal, here->distance));
    found.point = march_scene_point(marching, march, point);
    found.normal = march_scene_direction(marching, normal);
    found.error = ERROR_TOLERANCES * real_max(tolerance * marching->scale,
                                              FIELD_ERROR * ROUNDOFF * vector_largest(found.point));
    found.shape = integer_of(sdf->base.place);
    return found;
}

/** @return The lanes where the shape is nearer. See #ShapeClass.is_hit. @callgraph
 *  @param self The shape. @param ray The rays. @param active The lanes. @param[in,out] hit The hit.
 */
static mask sdf_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const Sdf *sdf = (const Sdf *)self;
    const Marching *marching = &sdf->marching;
    March march;
    if (!march_run(marching, ray, active, hit->distance, false, &march)) {
        return mask_of(false);
    }
    Vector point = march_point(&march, march.way);
    real tolerance = march_tolerance(marching, &march, march.way, point);
    FieldSample here = field_sample(marching->codes, marching->count, point, march.found);
    march_refine(marching, &march, &here, tolerance);
    real distance = march_distance(&march);
    mask nearer = hit_is_nearer(hit, march.found, distance, self->place);
    Hit found = sdf_hit(sdf, &march, &here, tolerance, distance);
    hit_take(hit, nearer, &found);
    return nearer;
}

/** @return The lanes where the shape is on the way. See #ShapeClass.is_blocking.
 *  @param self The shape. @param ray The rays. @param active The lanes. @param limit The way's end.
 */
static mask sdf_is_blocking(const Shape *self, const Ray *ray, mask active, real limit) {
    March march;
    if (!march_run(&((const Sdf *)self)->marching, ray, active, limit, true, &march)) {
        return mask_of(false);
    }
    real distance = march_distance(&march);
    return march.found & (distance > 0) & (distance < limit);
}

/** @return How many steps rays take to it. See #ShapeClass.steps. @param self The shape.
 *  @param ray The rays. @param active The lanes. @param limit The way's end. */
static real sdf_steps(const Shape *self, const Ray *ray, mask active, real limit) {
    return march_count(&((const Sdf *)self)->marching, ray, active, limit);
}

/** @return The box around the shape. @param self The shape. */
static Bounds sdf_bounds(const Shape *self) {
    return ((const Sdf *)self)->box;
}

const ShapeClass sdf_class = {
    .keyword = {.name = "sdf",
                .help = "the surface of a distance field, found by marching",
                .parameters = sdf_parameters,
                .size = sizeof(SdfParameters),
                .defaults = &sdf_defaults,
                .finish = sdf_finish},
    .size = sizeof(Sdf),
    .tail = sdf_tail,
    .init = sdf_init,
    .bind = sdf_bind,
    .is_hit = sdf_is_hit,
    .is_blocking = sdf_is_blocking,
    .bounds = sdf_bounds,
    .steps = sdf_steps,
};
