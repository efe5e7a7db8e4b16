/**
 * @file
 * @brief What rounding does at a hit.
 *
 * The shape alone is traced again in quadruple precision: from high above each point, straight down
 * the normal. The length of that ray tells how high the point lies, to far below an ulp.
 */
#include "render/ray_microscope.h"

#include <math.h>

/** Height from which a point is measured, in offsets of the next rays. */
static const double START_EPSILONS = 16;
/** Least such height, in ulps. */
static const double START_ULPS = 1024;

/** A shape of a scene, traced in quadruple precision. */
typedef struct Reference {
    const Engine *engine; /**< The widest engine. */
    Tracer *tracer;       /**< The shape alone. */
    Vec3d normal;         /**< Outward unit normal at the hit. */
    double start;         /**< Height from which is measured, scene units. */
} Reference;

/** @return The ulp of the largest coordinate of a point. @param bits Of the significand. */
static double ulp_of(Vec3d point, int bits) {
    int exponent;
    frexp(vec3d_max_abs(point), &exponent);
    return ldexp(1, exponent - bits);
}

/**
 * Measures the height of a point over the shape.
 * @param point   In the tracer's coordinates, as the engine has it.
 * @param origin  Where in the scene these start.
 * @param[out] height  Scene units.
 * @return Whether the shape is below it.
 */
static bool measure_height(const Reference *reference, Vec3d point, Vec3d origin, double *height) {
    const double p[] = {point.x, point.y, point.z}, o[] = {origin.x, origin.y, origin.z};
    const double n[] = {reference->normal.x, reference->normal.y, reference->normal.z};
    RayQueryQuad ray;
    RayResult result;
    for (int axis = 0; axis < 3; axis++) {
        ray.origin[axis] = (Quadruple)p[axis] + (Quadruple)o[axis] +
                           (Quadruple)reference->start * (Quadruple)n[axis];
        ray.direction[axis] = -(Quadruple)n[axis];
    }
    reference->engine->intersect(reference->tracer, 1, &ray, &result);
    // The normal is a unit vector but for its rounding, so lengths of it are scene units.
    *height = (double)(result.distance - (Quadruple)reference->start);
    return result.shape >= 0;
}

/** Measures the origins of the rays that leave the hit. */
static void measure_next(const Reference *reference, const RayTree *tree, size_t index,
                         RayMicroscope *microscope) {
    for (size_t i = index + 1; i < tree->count && microscope->next_count < MICROSCOPE_RAYS; i++) {
        const RayTreeNode *ray = &tree->nodes[i];
        double height;
        if (ray->parent == (int)index &&
            measure_height(reference, ray->engine_origin, tree->origin, &height)) {
            microscope->next[microscope->next_count++] =
                (MicroscopeRay){i, height / microscope->ulp};
        }
    }
}

/** @return Whether a hit can be measured. @param reference The widest engine; NULL: there is none.
 */
static bool can_measure(const Engine *engine, const Engine *reference, const RayTreeNode *ray) {
    return reference && engine->mantissa_bits < reference->mantissa_bits &&
           ray->kind != RAY_SHADOW && ray->shape >= 0;
}

RayMicroscope ray_microscope_measure(const Engine *engine, const Scene *scene, const RayTree *tree,
                                     size_t index) {
    const RayTreeNode *ray = &tree->nodes[index];
    RayMicroscope microscope = {0};
    Error error = {0};
    Reference reference = {.engine = engine_find("f128x1", &error), .normal = ray->normal};
    if (!can_measure(engine, reference.engine, ray)) {
        return microscope;
    }
    Scene alone = *scene;
    SceneShape shape = scene->shapes[ray->shape];
    alone.shapes = &shape;
    alone.shape_count = 1;
    alone.light_count = 0;
    reference.tracer =
        reference.engine->create_tracer(&alone, &(TraceSettings){.samples = 1}, &error);
    if (!reference.tracer) {
        return microscope;
    }
    microscope.ulp = ulp_of(ray->engine_point, engine->mantissa_bits);
    microscope.epsilon = ray->surface.epsilon / microscope.ulp;
    reference.start = fmax(START_EPSILONS * ray->surface.epsilon, START_ULPS * microscope.ulp);
    microscope.is_valid =
        measure_height(&reference, ray->engine_point, tree->origin, &microscope.height);
    microscope.height /= microscope.ulp;
    measure_next(&reference, tree, index, &microscope);
    reference.engine->destroy(reference.tracer);
    return microscope;
}
