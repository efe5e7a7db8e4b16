/**
 * @file
 * @brief Sdf: the surface of a distance field, found by marching.
 *
 * A ray steps as far as the field allows until it is as near as the tolerance (Hart, *Sphere
 * Tracing*, 1996). Steps are made longer than allowed; where the ball around the new point does not
 * touch the one around the last, something may lie between them, and the step is taken back
 * (Keinert et al., *Enhanced Sphere Tracing*, 2014). Only the way through the field's box is
 * marched.
 */
#include "trace/shapes/sdf.h"

#include "trace/model.h"
#include "trace/shapes/registry.h"
#include "trace/slab.h"

/** How much longer than allowed a step is. */
#define RELAXATION ((scalar)1.6f)
/** A ray that runs out of steps has met the surface if it came within so many tolerances. */
#define CANDIDATE_TOLERANCES 8
/** Tolerances that a hit is moved at most to be on the surface. */
#define REFINE_TOLERANCES 64
/** Tolerances that a hit may be off, and that rays which leave it start away: farther than where a
 *  march ends. */
#define ERROR_TOLERANCES 2
/** Half ulps of the coordinates that a distance can be wrong by, with room for long tapes. */
#define FIELD_ERROR 16

/** The surface of a field. @extends Shape */
typedef struct Sdf {
    Shape base;         /**< What all shapes have. */
    FieldCode *codes;   /**< The field's tape; behind this object. */
    int count;          /**< How many steps it has. */
    int max_steps;      /**< Steps after which a ray is given up. */
    scalar tolerance;   /**< How near to the surface is on it. */
    Bounds box;         /**< A box that holds all points within the tolerance. */
    BoundsBlock planes; /**< The same for slabs. */
    Stalls *stalls;     /**< Counts the rays that were given up; the tracer's. */
} Sdf;

/** LANES rays on their way. */
typedef struct March {
    Vector origin;    /**< Where they enter the box, or start in it. */
    Vector direction; /**< Which way, one long. */
    real length;      /**< Of the ray's direction. */
    wide before;      /**< How far the ray was then. */
    real end;         /**< Where they leave the box or have come too far, from there. */
    mask walking;     /**< The lanes that are still on their way. */
    mask leaving;     /**< Those that have not yet left the surface that they started on. */
    mask found;       /**< Those that have arrived. */
    real side;        /**< 1: outside; -1: inside. */
    real way;         /**< How far they are. */
    real step;        /**< The last step. */
    real radius;      /**< How far they might have gone. */
    real best;        /**< The nearest to the surface that they were. */
    real best_way;    /**< Where. */
} March;

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

/** Works out the box that is marched through: so much larger than the field's that where a ray
 *  enters it is outside. @param sdf The shape. @param field Its field. */
static void sdf_measure(Sdf *sdf, const Field *field) {
    Bounds *box = &sdf->box;
    *box = bounds_around(field->low, field->high);
    scalar reach = 0;
    for (int axis = 0; axis < 3; axis++) {
        reach = box->high[axis] < INFINITE && box->high[axis] > reach ? box->high[axis] : reach;
        reach = -box->low[axis] < INFINITE && -box->low[axis] > reach ? -box->low[axis] : reach;
    }
    scalar roundings = FIELD_ERROR * ROUNDOFF * reach;
    sdf->tolerance = sdf->tolerance > roundings ? sdf->tolerance : roundings;
    for (int axis = 0; axis < 3; axis++) {
        box->low[axis] -= ERROR_TOLERANCES * (scalar)field->slack * sdf->tolerance;
        box->high[axis] += ERROR_TOLERANCES * (scalar)field->slack * sdf->tolerance;
        sdf->planes.planes[axis] = real_of(box->low[axis]);
        sdf->planes.planes[axis + 3] = real_of(box->high[axis]);
    }
}

/** Makes it. @param self The shape. @param parameters An #SdfParameters. */
static void sdf_init(Shape *self, const void *parameters) {
    Sdf *sdf = (Sdf *)self;
    const SdfParameters *p = parameters;
    sdf->codes = (FieldCode *)shape_tail(self);
    sdf->count = p->field->count;
    sdf->max_steps = p->max_steps;
    sdf->tolerance = (scalar)p->tolerance;
    field_code(sdf->codes, p->field);
    sdf_measure(sdf, p->field);
}

/** Finds where to count. See #ShapeClass.bind. @param self The shape. @param models All models.
 *  @param[out] error Not used. @return true */
static bool sdf_bind(Shape *self, Models *models, Error *error) {
    (void)error;
    ((Sdf *)self)->stalls = &models->stalls;
    return true;
}

/* --- marching --------------------------------------------------------------------------------- */

/** @return The points where rays are. @param march The rays. @param way How far. */
INLINE Vector march_point(const March *march, real way) {
    return vector_add(march->origin, vector_scale(march->direction, way));
}

/** @return How near to the surface is on it: at least as near as roundings let one see.
 *  @param sdf The shape. @param point Where. */
INLINE real sdf_tolerance(const Sdf *sdf, Vector point) {
    return real_max(real_of(sdf->tolerance), FIELD_ERROR * ROUNDOFF * vector_largest(point));
}

/**
 * Sends rays on their way.
 * @param sdf     The shape.
 * @param ray     The rays.
 * @param active  The lanes that count.
 * @param limit   How far they look.
 * @param[out] march  The rays at the box.
 * @return Whether any of them goes through it.
 */
INLINE bool march_begin(const Sdf *sdf, const Ray *ray, mask active, real limit, March *march) {
    const real zero = real_of(0);
    const real *planes = sdf->planes.planes;
    real near = zero, far = limit;
    slab_clip(&near, &far, planes[0], planes[3], ray->origin.x, ray->inverse.x);
    slab_clip(&near, &far, planes[1], planes[4], ray->origin.y, ray->inverse.y);
    slab_clip(&near, &far, planes[2], planes[5], ray->origin.z, ray->inverse.z);
    mask walking = active & (near <= far * (1 + SLAB_SLACK));
    if (!any(walking)) {
        return false;
    }
    // The length by way of the largest component: squares of any direction stay in range.
    real largest = vector_largest(ray->direction);
    Vector d = {ray->direction.x / largest, ray->direction.y / largest, ray->direction.z / largest};
    real per_length = 1 / real_sqrt(vector_dot(d, d));
    real length = largest / per_length;
    WideVector start =
        wide_add_scaled(vector_widen(ray->origin), vector_widen(ray->direction), widen(near));
    *march = (March){.origin = vector_narrow(start),
                     .direction = vector_scale(d, per_length),
                     .length = length,
                     .before = widen(near),
                     .end = (far - near) * length,
                     .walking = walking & (length > 0) & (length < INFINITE) & (near < INFINITE),
                     .leaving = near <= 0,
                     .found = mask_of(false),
                     .side = real_of(1),
                     .way = zero,
                     .step = zero,
                     .radius = zero,
                     .best = real_of(INFINITE),
                     .best_way = zero};
    return true;
}

/**
 * Looks at what the field says where rays are: which have arrived, which have gone too far.
 * @param[in,out] march  The rays.
 * @param distance       What the field says.
 * @param tolerance      How near to the surface is on it.
 * @return The lanes whose last step was too long.
 */
INLINE mask march_look(March *march, real distance, real tolerance) {
    march->side = real_select(march->leaving & (distance < 0), real_of(-1), march->side);
    march->side = real_select(march->leaving & (distance >= 0), real_of(1), march->side);
    real radius = distance * march->side;
    march->leaving = march->leaving & (radius < tolerance);
    mask is_over = (radius + march->radius < march->step) & (march->step > march->radius);
    mask counts = march->walking & mask_not(march->leaving | is_over);
    mask arrives = counts & (radius <= tolerance);
    mask is_better = counts & (radius < march->best);
    march->best = real_select(is_better, radius, march->best);
    march->best_way = real_select(is_better, march->way, march->best_way);
    march->found = march->found | arrives;
    march->walking = march->walking & mask_not(arrives);
    march->radius =
        real_select(is_over, march->radius, real_select(march->leaving, tolerance, radius));
    return is_over;
}

/**
 * Steps on; or back, to where the last step would have been safe.
 * @param[in,out] march  The rays.
 * @param is_over        The lanes that step back.
 */
INLINE void march_step(March *march, mask is_over) {
    real radius = march->radius, left = march->end - march->way;
    // Where even the safe step goes out of the box, there is nothing more.
    march->walking = march->walking & (is_over | (radius <= left));
    real longer = real_select(march->leaving, radius, radius * RELAXATION);
    real change = real_select(is_over, radius - march->step, longer);
    march->step = real_select(is_over, radius, longer);
    // What is not yet known to be empty before the box ends is looked at there.
    real way = real_min(march->way + change, march->end);
    march->step = real_min(march->step, real_max(left, radius));
    march->way = real_select(march->walking, way, march->way);
}

/** Gives up rays that are still on their way: those that came near enough have met the surface, and
 *  the others nothing. @param sdf The shape. @param[in,out] march The rays. */
static void march_give_up(const Sdf *sdf, March *march) {
    real near = CANDIDATE_TOLERANCES * sdf_tolerance(sdf, march_point(march, march->best_way));
    mask is_near = march->walking & (march->best <= near);
    march->way = real_select(is_near, march->best_way, march->way);
    march->found = march->found | is_near;
    stalls_add(sdf->stalls, mask_count(march->walking & mask_not(is_near)));
}

/**
 * Finds where rays meet the surface.
 * @param sdf     The shape.
 * @param ray     The rays.
 * @param active  The lanes that count.
 * @param limit   How far they look.
 * @param[out] march  Where they are, and which have arrived.
 * @return Whether any has.
 */
INLINE bool sdf_march(const Sdf *sdf, const Ray *ray, mask active, real limit, March *march) {
    if (!march_begin(sdf, ray, active, limit, march)) {
        return false;
    }
    for (int i = 0; i < sdf->max_steps && any(march->walking); i++) {
        Vector point = march_point(march, march->way);
        real distance = field_distance(sdf->codes, sdf->count, point, march->walking);
        march_step(march, march_look(march, distance, sdf_tolerance(sdf, point)));
    }
    if (any(march->walking)) {
        march_give_up(sdf, march);
    }
    return any(march->found);
}

/** @return How far rays are, in lengths of their direction. @param march The rays. */
INLINE real march_distance(const March *march) {
    return narrow(march->before + widen(march->way / march->length));
}

/**
 * Brings rays that have arrived nearer to the surface, by the derivative along the ray (Newton): by
 * a few tolerances at most, and only where it helps.
 * @param sdf     The shape.
 * @param[in,out] march  The rays.
 * @param[in,out] here   What the field says where they are.
 */
INLINE void march_refine(const Sdf *sdf, March *march, FieldSample *here) {
    real slope = vector_dot(here->gradient, march->direction);
    real change = -here->distance / slope;
    real most = REFINE_TOLERANCES * sdf_tolerance(sdf, march_point(march, march->way));
    mask is_small = march->found & (real_abs(change) <= most);
    if (!any(is_small)) {
        return;
    }
    real way = real_select(is_small, march->way + change, march->way);
    FieldSample there = field_sample(sdf->codes, sdf->count, march_point(march, way), march->found);
    mask is_nearer = is_small & (real_abs(there.distance) < real_abs(here->distance)) & (way > 0);
    march->way = real_select(is_nearer, way, march->way);
    here->distance = real_select(is_nearer, there.distance, here->distance);
    here->gradient = vector_select(is_nearer, there.gradient, here->gradient);
}

/** @return What rays have met. @param sdf The shape. @param march The rays. @param here What the
 *  field says there. @param distance How far it is. */
INLINE Hit sdf_hit(const Sdf *sdf, const March *march, const FieldSample *here, real distance) {
    // Where the field is level in all directions, as in the middle of a ball, any normal is right.
    real square = vector_dot(here->gradient, here->gradient);
    Vector gradient =
        vector_select(square > 0, here->gradient, vector_scale(march->direction, real_of(-1)));
    Vector normal = vector_normalize(gradient), point = march_point(march, march->way);
    Hit found = hit_nothing(distance);
    found.point = vector_subtract(point, vector_scale(normal, here->distance));
    found.normal = normal;
    found.error = ERROR_TOLERANCES * sdf_tolerance(sdf, point);
    found.shape = integer_of(sdf->base.place);
    return found;
}

/** @return The lanes where the shape is nearer. See #ShapeClass.is_hit. @callgraph
 *  @param self The shape. @param ray The rays. @param active The lanes. @param[in,out] hit The hit.
 */
static mask sdf_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const Sdf *sdf = (const Sdf *)self;
    March march;
    if (!sdf_march(sdf, ray, active, hit->distance, &march)) {
        return mask_of(false);
    }
    Vector point = march_point(&march, march.way);
    FieldSample here = field_sample(sdf->codes, sdf->count, point, march.found);
    march_refine(sdf, &march, &here);
    real distance = march_distance(&march);
    mask nearer = hit_is_nearer(hit, march.found, distance, self->place);
    Hit found = sdf_hit(sdf, &march, &here, distance);
    hit_take(hit, nearer, &found);
    return nearer;
}

/** @return The lanes where the shape is on the way. See #ShapeClass.is_blocking.
 *  @param self The shape. @param ray The rays. @param active The lanes. @param limit The way's end.
 */
static mask sdf_is_blocking(const Shape *self, const Ray *ray, mask active, real limit) {
    March march;
    if (!sdf_march((const Sdf *)self, ray, active, limit, &march)) {
        return mask_of(false);
    }
    real distance = march_distance(&march);
    return march.found & (distance > 0) & (distance < limit);
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
};
