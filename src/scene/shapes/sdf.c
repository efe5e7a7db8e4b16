/**
 * @file
 * @brief Description of surfaces of distance fields.
 */
#include "scene/shapes/fields.h"

/** Fields of `sdf`. */
static const Parameter sdf_parameters[] = {
    {.name = "field",
     .type = PARAMETER_SDF,
     .offset = offsetof(SdfShapeParameters, field),
     .unit = "field",
     .help = "the field; it may also stand first, without a name"},
    LENGTH_FIELD("tolerance", SdfShapeParameters, tolerance, "how near to the surface is on it"),
    {.name = "max_steps",
     .type = PARAMETER_INTEGER,
     .offset = offsetof(SdfShapeParameters, max_steps),
     .minimum = 1,
     .maximum = 1000000,
     .unit = "steps",
     .help = "after so many a ray is given up"},
    {0}};

/** A tolerance too small to be visible at usual sizes. */
static const SdfShapeParameters sdf_defaults = {.tolerance = 1e-4, .max_steps = 512};

/** Rejects shapes without a field. See #Keyword.finish. @return Whether there is one. */
static bool sdf_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    return ((SdfShapeParameters *)values)->field ||
           error_set(error, STATUS_SCENE,
                     "sdf needs a field, such as sdf { distance.sphere { radius = 1 } }");
}

/** @return Facts of the surface of a field. See #SceneShapeClass.facts. */
static ShapeFacts sdf_facts(const void *parameters, const Scene *scene) {
    (void)scene;
    const SdfShapeParameters *p = parameters;
    return (ShapeFacts){
        .bounds = {p->field->low, p->field->high}, .sdf = p->field, .tolerance = p->tolerance};
}

/** Multiplies the tolerance. See #SceneShapeClass.scale_tolerance. */
static void sdf_scale_tolerance(void *parameters, double factor) {
    SdfShapeParameters *p = parameters;
    p->tolerance = fmin(fmax(p->tolerance * factor, LENGTH_MINIMUM), LENGTH_MAXIMUM);
}

const SceneShapeClass scene_sdf_class = {
    .keyword = {.name = "sdf",
                .help = "the surface of a distance field, found by marching",
                .parameters = sdf_parameters,
                .size = sizeof(SdfShapeParameters),
                .defaults = &sdf_defaults,
                .finish = sdf_finish},
    .facts = sdf_facts,
    .scale_tolerance = sdf_scale_tolerance,
};
