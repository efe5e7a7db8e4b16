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
     .unit = N_("field"),
     .help = N_("the field; it may also stand first, without a name")},
    LENGTH_FIELD("tolerance", SdfShapeParameters, tolerance,
                 N_("how near to the surface is on it")),
    {.name = "max_steps",
     .type = PARAMETER_INTEGER,
     .offset = offsetof(SdfShapeParameters, max_steps),
     .minimum = 1,
     .maximum = 1000000,
     .unit = N_("steps"),
     .help = N_("after so many a ray is given up")},
    {0}};

/** A tolerance too small to be visible at usual sizes. */
static const SdfShapeParameters sdf_defaults = {.tolerance = 1e-4, .max_steps = 512};

/** Bit of the field `tolerance`. */
enum { HAS_TOLERANCE = 1 << 1 };

/**
 * Smallest number of tolerances along the longest edge of a field. A ray that was within 8 of them
 * may count as a hit, so a larger one would make a surface of all that is in the box.
 */
static const double TOLERANCES_PER_EDGE = 16;

/** Length that stands for a field that has no end and no cells, scene units. */
static const double ENDLESS_FIELD_EDGE = 16;

/** @return The longer of two edges, one of them by its ends; edges without end do not count. */
static double longer_edge(double edge, double low, double high) {
    double other = high - low;
    return isfinite(other) ? fmax(edge, other) : edge;
}

/** @return Longest edge of the box of a field, or of its cells if it is repeated; scene units. */
static double longest_edge(const Sdf *field) {
    double edge = 0;
    edge = longer_edge(edge, field->low.x, field->high.x);
    edge = longer_edge(edge, field->low.y, field->high.y);
    edge = longer_edge(edge, field->low.z, field->high.z);
    for (int i = 0; i < field->node_count; i++) {
        const SdfNode *node = &field->nodes[i];
        for (int axis = 0; node->op == SDF_REPEAT && axis < 3; axis++) {
            edge = fmax(edge, node->operands[axis]);
        }
    }
    return edge > 0 ? edge : ENDLESS_FIELD_EDGE;
}

/**
 * Rejects shapes without a field, and tolerances that are no longer small beside it. See
 * #Keyword.finish.
 * @return Whether it is valid.
 */
static bool sdf_finish(void *values, uint64_t given, Error *error) {
    const SdfShapeParameters *p = values;
    if (!p->field) {
        return error_set(error, STATUS_SCENE,
                         "sdf needs a field, such as sdf { distance.sphere { radius = 1 } }");
    }
    double maximum = longest_edge(p->field) / TOLERANCES_PER_EDGE;
    return !(given & HAS_TOLERANCE) || p->tolerance <= maximum ||
           error_set(error, STATUS_SCENE,
                     "tolerance must be at most 1/%g of the longest edge of the field, %g, not %g",
                     TOLERANCES_PER_EDGE, maximum, p->tolerance);
}

/** See #ShapeFacts.ray_growth: measured on glass boxes with round edges, smooth unions, frames,
 * thick rings and functions. */
#define FIELD_RAY_GROWTH 4

/** Smallest ratio of the radii of a ring, of its tube to that of its middle, with irregular paths:
 *  in a thin one no path comes back to the same side. */
#define THICK_RING 0.5

/** @return See #ShapeFacts.ray_growth: 0 for one ball, box or thin ring. */
static double field_ray_growth(const Sdf *field) {
    bool is_regular = true;
    int solids = 0;
    for (int i = 0; i < field->node_count; i++) {
        const SdfNode *node = &field->nodes[i];
        bool is_thin_ring =
            node->op == SDF_TORUS && node->operands[1] < THICK_RING * node->operands[0];
        bool is_solid = node->op == SDF_SPHERE || node->op == SDF_BOX || is_thin_ring;
        is_regular = is_regular && (is_solid || node->op == SDF_TRANSFORM);
        solids += is_solid;
    }
    return is_regular && solids == 1 ? 0 : FIELD_RAY_GROWTH;
}

/** @return Facts of the surface of a field. See #SceneShapeClass.facts. */
static ShapeFacts sdf_facts(const void *parameters, const Scene *scene) {
    (void)scene;
    const SdfShapeParameters *p = parameters;
    return (ShapeFacts){.bounds = {p->field->low, p->field->high},
                        .sdf = p->field,
                        .tolerance = p->tolerance,
                        .ray_growth = field_ray_growth(p->field)};
}

/** Multiplies the tolerance. See #SceneShapeClass.scale_tolerance. */
static void sdf_scale_tolerance(void *parameters, double factor) {
    SdfShapeParameters *p = parameters;
    p->tolerance = fmin(fmax(p->tolerance * factor, LENGTH_MINIMUM), LENGTH_MAXIMUM);
}

/** Description of `sdf`. */
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
