/**
 * @file
 * @brief Description of infinite planes.
 */
#include "scene/shapes/fields.h"

/** Fields of `plane`. */
static const Parameter plane_parameters[] = {
    POINT_FIELD("point", PlaneParameters, point, N_("a point of it")),
    NORMAL_FIELD("normal", PlaneParameters, normal, N_("its normal")),
    {0}};

/** The plane y = 0. */
static const PlaneParameters plane_defaults = {.normal = {0, 1, 0}};

/** @return Facts of a plane: it is unbounded. See #SceneShapeClass.facts. */
static ShapeFacts plane_facts(const void *parameters, const Scene *scene) {
    (void)parameters;
    (void)scene;
    return (ShapeFacts){.bounds = aabbd_infinite(), .is_flat = true};
}

/** @return The distance of a point from a plane. See #SceneShapeClass.distance. */
static double plane_distance(const void *parameters, const Scene *scene, Vec3d point) {
    (void)scene;
    const PlaneParameters *p = parameters;
    return distance_from_plane(p->normal, p->point, point);
}

/** Gives the plane. See #SceneShapeClass.faces. @return 1. */
static size_t plane_faces(const void *parameters, ShapeFace *faces) {
    const PlaneParameters *p = parameters;
    faces[0] = face_of_plane(p->normal, p->point);
    return 1;
}

/** Description of `plane`. */
const SceneShapeClass scene_plane_class = {
    .keyword = {.name = "plane",
                .help = "a plane without end",
                .parameters = plane_parameters,
                .size = sizeof(PlaneParameters),
                .defaults = &plane_defaults},
    .facts = plane_facts,
    .distance = plane_distance,
    .faces = plane_faces,
};
