/**
 * @file
 * @brief Description of cones and frusta, open or capped.
 */
#include "scene/shapes/fields.h"

/** Row of a radius that may be 0, scene units. */
#define RADIUS_FIELD(field, member, text)                                                          \
    {                                                                                              \
        .name = field, .type = PARAMETER_NUMBER, .offset = offsetof(ConeParameters, member),       \
        .minimum = 0, .maximum = LENGTH_MAXIMUM, .unit = N_("scene units"), .help = text           \
    }

/** Fields of `cone`. */
static const Parameter cone_parameters[] = {
    POINT_FIELD("base", ConeParameters, base, N_("centre of one end")),
    POINT_FIELD("top", ConeParameters, top, N_("centre of the other end")),
    RADIUS_FIELD("radius", radius, N_("radius at the base")),
    RADIUS_FIELD("top_radius", top_radius, N_("radius at the top; 0: a tip")),
    {.name = "capped",
     .type = PARAMETER_BOOLEAN,
     .offset = offsetof(ConeParameters, capped),
     .unit = N_("yes or no"),
     .help = N_("whether its ends are closed; else it is a funnel")},
    {0}};

/** A capped cone of radius 1 and height 1 on the plane y = 0. */
static const ConeParameters cone_defaults = {.top = {0, 1, 0}, .radius = 1, .capped = true};

/** @return Whether a radius is too small for the engines, but not 0. */
static bool is_too_small(double radius) {
    return radius > 0 && radius < LENGTH_MINIMUM;
}

/** Rejects cones without length or width. See #Keyword.finish. @return Whether both are there. */
static bool cone_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const ConeParameters *p = values;
    if (!(vec3d_length(vec3d_subtract(p->top, p->base)) >= LENGTH_MINIMUM)) {
        return error_set(error, STATUS_SCENE, "cone has no length: base and top are the same");
    }
    if (p->radius == 0 && p->top_radius == 0) {
        return error_set(error, STATUS_SCENE, "cone has no width: radius and top_radius are 0");
    }
    return (!is_too_small(p->radius) && !is_too_small(p->top_radius)) ||
           error_set(error, STATUS_SCENE, "a radius of a cone must be 0 or at least %g",
                     LENGTH_MINIMUM);
}

/** See #ShapeFacts.ray_growth: measured on glass cones and frustums. */
#define CONE_RAY_GROWTH 1.3

/** @return Facts of a cone: the box around its end circles. See #SceneShapeClass.facts. */
static ShapeFacts cone_facts(const void *parameters, const Scene *scene) {
    (void)scene;
    const ConeParameters *p = parameters;
    Vec3d axis = vec3d_normalize(vec3d_subtract(p->top, p->base));
    return (ShapeFacts){.bounds = cone_bounds_of(p, axis),
                        .ray_growth = p->radius == p->top_radius ? 0 : CONE_RAY_GROWTH};
}

/** Gives the ends that are no tips. See #SceneShapeClass.faces. @return Their number; of a funnel,
 *  0. */
static size_t cone_faces(const void *parameters, ShapeFace *faces) {
    const ConeParameters *p = parameters;
    Vec3d up = vec3d_subtract(p->top, p->base);
    size_t count = 0;
    if (p->capped && p->radius > 0) {
        faces[count++] = face_of_disk(vec3d_scale(up, -1), p->base, p->radius);
    }
    if (p->capped && p->top_radius > 0) {
        faces[count++] = face_of_disk(up, p->top, p->top_radius);
    }
    for (size_t i = 0; i < count; i++) {
        faces[i].is_solid = true;
    }
    return count;
}

/** @return The side. See #SceneShapeClass.shell. */
static ShapeShell cone_shell(const void *parameters) {
    const ConeParameters *p = parameters;
    return (ShapeShell){p->base, p->top, p->radius, p->top_radius};
}

/** Description of `cone`. */
const SceneShapeClass scene_cone_class = {
    .keyword = {.name = "cone",
                .help = "a cone or frustum, solid or a funnel",
                .parameters = cone_parameters,
                .size = sizeof(ConeParameters),
                .defaults = &cone_defaults,
                .finish = cone_finish},
    .facts = cone_facts,
    .faces = cone_faces,
    .shell = cone_shell,
};
