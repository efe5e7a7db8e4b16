/**
 * @file
 * @brief Description of triangles, flat or with a normal at each vertex.
 */
#include "scene/shapes/fields.h"

/** Rows of the table that start a group of three. */
enum { TRIANGLE_ROW_NORMALS = 3, TRIANGLE_ROW_UVS = 6 };

/** Bits of three rows of the table. */
#define THREE_ROW_BITS 7u

/** Fields of `triangle`. */
static const Parameter triangle_parameters[] = {
    POINT_FIELD("a", TriangleParameters, corners[0], N_("one corner")),
    POINT_FIELD("b", TriangleParameters, corners[1], N_("the next")),
    POINT_FIELD("c", TriangleParameters, corners[2], N_("the last")),
    [TRIANGLE_ROW_NORMALS] = NORMAL_FIELD("na", TriangleParameters, normals[0],
                                          N_("the normal at a, to shade it as if it were round")),
    NORMAL_FIELD("nb", TriangleParameters, normals[1], N_("the normal at b")),
    NORMAL_FIELD("nc", TriangleParameters, normals[2], N_("the normal at c")),
    [TRIANGLE_ROW_UVS] =
        UV_FIELD("ta", TriangleParameters, uvs[0], N_("where a lies in a picture")),
    UV_FIELD("tb", TriangleParameters, uvs[1], N_("where b lies")),
    UV_FIELD("tc", TriangleParameters, uvs[2], N_("where c lies")),
    {0}};

/** Half of a square of side 1 that faces the viewer. */
static const TriangleParameters triangle_defaults = {.corners = {{0}, {1, 0, 0}, {0, 1, 0}},
                                                     .uvs = {{0}, {1, 0}, {0, 1}}};

/**
 * Checks that a scene gives all fields of a group of three, or none.
 * @param given          Bits of the given rows.
 * @param row            First row of the group.
 * @param[out] is_given  Not 0: it gives them.
 * @return false if it gives only some.
 */
static bool three_rows_given(uint64_t given, int row, int *is_given) {
    uint64_t bits = given >> row & THREE_ROW_BITS;
    *is_given = bits == THREE_ROW_BITS;
    return *is_given || bits == 0;
}

/**
 * Rejects triangles without area, and normals or texture coordinates of only some vertices. See
 * #Keyword.finish.
 * @param given  Bits of the given rows.
 * @return Whether the triangle is complete.
 */
static bool triangle_finish(void *values, uint64_t given, Error *error) {
    TriangleParameters *p = values;
    if (edges_are_parallel(vec3d_subtract(p->corners[1], p->corners[0]),
                           vec3d_subtract(p->corners[2], p->corners[0]))) {
        return error_set(error, STATUS_SCENE, "triangle has no area: its corners are in a line");
    }
    if (!three_rows_given(given, TRIANGLE_ROW_NORMALS, &p->is_smooth)) {
        return error_set(error, STATUS_SCENE, "triangle takes na, nb and nc, or none of them");
    }
    int has_uvs;
    if (!three_rows_given(given, TRIANGLE_ROW_UVS, &has_uvs)) {
        return error_set(error, STATUS_SCENE, "triangle takes ta, tb and tc, or none of them");
    }
    return true;
}

/** @return Facts of a triangle. See #SceneShapeClass.facts. */
static ShapeFacts triangle_facts(const void *parameters, const Scene *scene) {
    (void)scene;
    const TriangleParameters *p = parameters;
    Aabbd bounds = aabbd_empty();
    for (int i = 0; i < 3; i++) {
        bounds = aabbd_add_point(bounds, p->corners[i]);
    }
    return (ShapeFacts){.bounds = bounds, .is_flat = true};
}

/** @return The distance of a point from the plane of a triangle. See #SceneShapeClass.distance. */
static double triangle_distance(const void *parameters, const Scene *scene, Vec3d point) {
    (void)scene;
    const TriangleParameters *p = parameters;
    Vec3d normal = vec3d_cross(vec3d_subtract(p->corners[1], p->corners[0]),
                               vec3d_subtract(p->corners[2], p->corners[0]));
    return distance_from_plane(normal, p->corners[0], point);
}

/** Gives the triangle. See #SceneShapeClass.faces. @return 1. */
static size_t triangle_faces(const void *parameters, ShapeFace *faces) {
    const TriangleParameters *p = parameters;
    Vec3d normal = vec3d_cross(vec3d_subtract(p->corners[1], p->corners[0]),
                               vec3d_subtract(p->corners[2], p->corners[0]));
    faces[0] = face_of_corners(normal, p->corners, 3);
    return 1;
}

/** Description of `triangle`. */
const SceneShapeClass scene_triangle_class = {
    .keyword = {.name = "triangle",
                .help = "a triangle, flat or smooth",
                .parameters = triangle_parameters,
                .size = sizeof(TriangleParameters),
                .defaults = &triangle_defaults,
                .finish = triangle_finish},
    .facts = triangle_facts,
    .distance = triangle_distance,
    .faces = triangle_faces,
};
