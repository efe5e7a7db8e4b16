/**
 * @file
 * @brief Description of spheres.
 */
#include "scene/shapes/fields.h"

/** Fields of `sphere`. */
static const Parameter sphere_parameters[] = {
    POINT_FIELD("center", SphereParameters, center, N_("its centre")),
    LENGTH_FIELD("radius", SphereParameters, radius, N_("its radius")),
    {0}};

/** A sphere of radius 1 at the origin. */
static const SphereParameters sphere_defaults = {.radius = 1};

/** @return Facts of a sphere. See #SceneShapeClass.facts. */
static ShapeFacts sphere_facts(const void *parameters, const Scene *scene) {
    (void)scene;
    const SphereParameters *p = parameters;
    Vec3d extent = {p->radius, p->radius, p->radius};
    return (ShapeFacts){
        .bounds = {vec3d_subtract(p->center, extent), vec3d_add(p->center, extent)}};
}

/** @return The distance of a point from a sphere. See #SceneShapeClass.distance. */
static double sphere_distance(const void *parameters, const Scene *scene, Vec3d point) {
    (void)scene;
    const SphereParameters *p = parameters;
    return fabs(vec3d_length(vec3d_subtract(point, p->center)) - p->radius);
}

/** @return The sphere. See #SceneShapeClass.shell. */
static ShapeShell sphere_shell(const void *parameters) {
    const SphereParameters *p = parameters;
    return (ShapeShell){p->center, p->center, p->radius, p->radius};
}

/** Description of `sphere`. */
const SceneShapeClass scene_sphere_class = {
    .keyword = {.name = "sphere",
                .help = "a ball",
                .parameters = sphere_parameters,
                .size = sizeof(SphereParameters),
                .defaults = &sphere_defaults},
    .facts = sphere_facts,
    .distance = sphere_distance,
    .shell = sphere_shell,
};
