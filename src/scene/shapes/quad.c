/**
 * @file
 * @brief Description of quads: parallelograms.
 */
#include "scene/shapes/fields.h"

/** Fields of `quad`. */
static const Parameter quad_parameters[] = {
    POINT_FIELD("corner", QuadParameters, corner, N_("one corner")),
    EDGE_FIELD("u", QuadParameters, u, N_("from it to the next corner")),
    EDGE_FIELD("v", QuadParameters, v, N_("from it to the corner on the other side")),
    {0}};

/** A square of side 1 that faces the viewer. */
static const QuadParameters quad_defaults = {.u = {1, 0, 0}, .v = {0, 1, 0}};

/** Rejects quads without area. See #Keyword.finish. @return Whether the quad has an area. */
static bool quad_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const QuadParameters *p = values;
    return !edges_are_parallel(p->u, p->v) ||
           error_set(error, STATUS_SCENE, "quad has no area: u and v are parallel");
}

/** @return Facts of a quad. See #SceneShapeClass.facts. */
static ShapeFacts quad_facts(const void *parameters, const Scene *scene) {
    (void)scene;
    const QuadParameters *p = parameters;
    Vec3d next = vec3d_add(p->corner, p->u), previous = vec3d_add(p->corner, p->v);
    Aabbd bounds = aabbd_add_point(aabbd_add_point(aabbd_empty(), p->corner), next);
    bounds = aabbd_add_point(aabbd_add_point(bounds, previous), vec3d_add(next, p->v));
    return (ShapeFacts){.bounds = bounds, .is_flat = true};
}

/** @return The distance of a point from the plane of a quad. See #SceneShapeClass.distance. */
static double quad_distance(const void *parameters, const Scene *scene, Vec3d point) {
    (void)scene;
    const QuadParameters *p = parameters;
    return distance_from_plane(vec3d_cross(p->u, p->v), p->corner, point);
}

/** Gives the quad. See #SceneShapeClass.faces. @return 1. */
static size_t quad_faces(const void *parameters, ShapeFace *faces) {
    const QuadParameters *p = parameters;
    Vec3d next = vec3d_add(p->corner, p->u), last = vec3d_add(p->corner, p->v);
    const Vec3d corners[] = {p->corner, next, vec3d_add(next, p->v), last};
    faces[0] = face_of_corners(vec3d_cross(p->u, p->v), corners, 4);
    return 1;
}

/** Description of `quad`. */
const SceneShapeClass scene_quad_class = {
    .keyword = {.name = "quad",
                .help = "a parallelogram",
                .parameters = quad_parameters,
                .size = sizeof(QuadParameters),
                .defaults = &quad_defaults,
                .finish = quad_finish},
    .facts = quad_facts,
    .distance = quad_distance,
    .faces = quad_faces,
};
