/**
 * @file
 * @brief Description of boxes along the axes.
 */
#include "scene/shapes/fields.h"

/** Fields of `box`. */
static const Parameter box_parameters[] = {
    POINT_FIELD("min", BoxParameters, low, N_("its lowest corner")),
    POINT_FIELD("max", BoxParameters, high, N_("its highest corner")),
    {0}};

/** A cube of side 1. */
static const BoxParameters box_defaults = {.high = {1, 1, 1}};

/** Rejects boxes without volume. See #Keyword.finish. @return Whether the box has a volume. */
static bool box_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const BoxParameters *p = values;
    return (p->low.x < p->high.x && p->low.y < p->high.y && p->low.z < p->high.z) ||
           error_set(error, STATUS_SCENE, "box needs min below max in x, y and z");
}

/** @return Facts of a box. See #SceneShapeClass.facts. */
static ShapeFacts box_facts(const void *parameters, const Scene *scene) {
    (void)scene;
    const BoxParameters *p = parameters;
    return (ShapeFacts){.bounds = {p->low, p->high}, .is_flat = true};
}

/** @return The distance of a point from the nearest side of a box; outside at most 0. See
 * #SceneShapeClass.distance. */
static double box_distance(const void *parameters, const Scene *scene, Vec3d point) {
    (void)scene;
    const BoxParameters *p = parameters;
    Vec3d low = vec3d_subtract(point, p->low), high = vec3d_subtract(p->high, point);
    Vec3d side = vec3d_min(low, high);
    return fmin(side.x, fmin(side.y, side.z));
}

/** Gives the six sides. See #SceneShapeClass.faces. @return 6. */
static size_t box_faces(const void *parameters, ShapeFace *faces) {
    const BoxParameters *p = parameters;
    const double low[] = {p->low.x, p->low.y, p->low.z}, high[] = {p->high.x, p->high.y, p->high.z};
    for (int side = 0; side < 6; side++) {
        int axis = side / 2, next = (axis + 1) % 3, last = (axis + 2) % 3;
        double normal[3] = {0}, at[3];
        normal[axis] = side % 2 ? 1 : -1;
        at[axis] = side % 2 ? high[axis] : low[axis];
        faces[side].normal = (Vec3d){normal[0], normal[1], normal[2]};
        faces[side].corner_count = 4;
        faces[side].is_solid = true;
        for (int i = 0; i < 4; i++) {
            at[next] = i == 1 || i == 2 ? high[next] : low[next];
            at[last] = i >= 2 ? high[last] : low[last];
            faces[side].corners[i] = (Vec3d){at[0], at[1], at[2]};
        }
    }
    return 6;
}

/** Description of `box`. */
const SceneShapeClass scene_box_class = {
    .keyword = {.name = "box",
                .help = "a box along the axes",
                .parameters = box_parameters,
                .size = sizeof(BoxParameters),
                .defaults = &box_defaults,
                .finish = box_finish},
    .facts = box_facts,
    .distance = box_distance,
    .faces = box_faces,
};
