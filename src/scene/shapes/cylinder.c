/**
 * @file
 * @brief Description of cylinders, open or capped.
 */
#include "scene/shapes/fields.h"

/** Fields of `cylinder`. */
static const Parameter cylinder_parameters[] = {
    POINT_FIELD("base", CylinderParameters, base, N_("centre of one end")),
    POINT_FIELD("top", CylinderParameters, top, N_("centre of the other end")),
    LENGTH_FIELD("radius", CylinderParameters, radius, N_("its radius")),
    {.name = "capped",
     .type = PARAMETER_BOOLEAN,
     .offset = offsetof(CylinderParameters, capped),
     .unit = N_("yes or no"),
     .help = N_("whether its ends are closed; else it is a pipe")},
    {0}};

/** A capped cylinder of radius 1 and height 1 on the plane y = 0. */
static const CylinderParameters cylinder_defaults = {.top = {0, 1, 0}, .radius = 1, .capped = true};

/** Rejects cylinders without length. See #Keyword.finish. @return Whether there is a length. */
static bool cylinder_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const CylinderParameters *p = values;
    return vec3d_length(vec3d_subtract(p->top, p->base)) >= LENGTH_MINIMUM ||
           error_set(error, STATUS_SCENE, "cylinder has no length: base and top are the same");
}

/** @return Facts of a cylinder: the box around its end circles. See #SceneShapeClass.facts. */
static ShapeFacts cylinder_facts(const void *parameters, const Scene *scene) {
    (void)scene;
    const CylinderParameters *p = parameters;
    Vec3d axis = vec3d_normalize(vec3d_subtract(p->top, p->base));
    Vec3d extent = circle_extent(axis, p->radius);
    return (ShapeFacts){.bounds = {vec3d_subtract(vec3d_min(p->base, p->top), extent),
                                   vec3d_add(vec3d_max(p->base, p->top), extent)}};
}

/** @return A lower bound of the distance of a point from a cylinder. See #SceneShapeClass.distance.
 */
static double cylinder_distance(const void *parameters, const Scene *scene, Vec3d point) {
    (void)scene;
    const CylinderParameters *p = parameters;
    Vec3d to_top = vec3d_subtract(p->top, p->base), from_base = vec3d_subtract(point, p->base);
    double length = vec3d_length(to_top);
    Vec3d axis = vec3d_normalize(to_top);
    double along = vec3d_dot(from_base, axis);
    double beside = vec3d_length(vec3d_subtract(from_base, vec3d_scale(axis, along)));
    double beyond = fmax(-along, along - length); // Negative between the ends.
    if (!p->capped || beside >= p->radius) {
        return fmax(fabs(beside - p->radius), beyond);
    }
    return beyond > 0 ? beyond : fmin(p->radius - beside, -beyond);
}

/** Gives the two ends. See #SceneShapeClass.faces. @return 2; of a pipe, 0. */
static size_t cylinder_faces(const void *parameters, ShapeFace *faces) {
    const CylinderParameters *p = parameters;
    Vec3d up = vec3d_subtract(p->top, p->base);
    faces[0] = face_of_disk(vec3d_scale(up, -1), p->base, p->radius);
    faces[1] = face_of_disk(up, p->top, p->radius);
    faces[0].is_solid = faces[1].is_solid = true;
    return p->capped ? 2 : 0;
}

/** @return The side. See #SceneShapeClass.shell. */
static ShapeShell cylinder_shell(const void *parameters) {
    const CylinderParameters *p = parameters;
    return (ShapeShell){p->base, p->top, p->radius, p->radius};
}

/** Description of `cylinder`. */
const SceneShapeClass scene_cylinder_class = {
    .keyword = {.name = "cylinder",
                .help = "a cylinder, solid or a pipe",
                .parameters = cylinder_parameters,
                .size = sizeof(CylinderParameters),
                .defaults = &cylinder_defaults,
                .finish = cylinder_finish},
    .facts = cylinder_facts,
    .distance = cylinder_distance,
    .faces = cylinder_faces,
    .shell = cylinder_shell,
};
