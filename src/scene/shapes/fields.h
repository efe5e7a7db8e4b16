/**
 * @file
 * @brief Rows of the parameter tables of shapes, by the meaning of the field.
 *
 * Each macro takes the name of the field in scene files, the parameter struct, its member and a
 * description in a few words.
 */
#ifndef DIOPTRE_SCENE_SHAPES_FIELDS_H
#define DIOPTRE_SCENE_SHAPES_FIELDS_H

#include "base/language.h"
#include "dioptre/scene.h"

/** Row of three numbers between -#LENGTH_MAXIMUM and #LENGTH_MAXIMUM. */
#define VECTOR_FIELD(field, kind, measure, Struct, member, text)                                   \
    {                                                                                              \
        .name = field, .type = kind, .offset = offsetof(Struct, member),                           \
        .minimum = -LENGTH_MAXIMUM, .maximum = LENGTH_MAXIMUM, .unit = measure, .help = text       \
    }

/** Row of a point, scene units. */
#define POINT_FIELD(field, Struct, member, text)                                                   \
    VECTOR_FIELD(field, PARAMETER_POINT, N_("scene units"), Struct, member, text)

/** Row of a normal of any length, not zero. */
#define NORMAL_FIELD(field, Struct, member, text)                                                  \
    VECTOR_FIELD(field, PARAMETER_DIRECTION, N_("any length"), Struct, member, text)

/** Row of an edge, scene units, not zero. */
#define EDGE_FIELD(field, Struct, member, text)                                                    \
    VECTOR_FIELD(field, PARAMETER_DIRECTION, N_("scene units"), Struct, member, text)

/** Row of texture coordinates. */
#define UV_FIELD(field, Struct, member, text)                                                      \
    VECTOR_FIELD(field, PARAMETER_UV, N_("pictures"), Struct, member, text)

/** Row of a length above zero, scene units. */
#define LENGTH_FIELD(field, Struct, member, text)                                                  \
    {                                                                                              \
        .name = field, .type = PARAMETER_NUMBER, .offset = offsetof(Struct, member),               \
        .minimum = LENGTH_MINIMUM, .maximum = LENGTH_MAXIMUM, .unit = N_("scene units"),           \
        .help = text                                                                               \
    }

/** Sine of the angle below which two edges count as parallel: double cannot resolve less. */
#define PARALLEL_SINE 1e-12

/** @return Whether two edges are parallel, or so nearly that they span no area. */
static inline bool edges_are_parallel(Vec3d a, Vec3d b) {
    Vec3d normal = vec3d_cross(vec3d_normalize(a), vec3d_normalize(b));
    return !(vec3d_length(normal) > PARALLEL_SINE);
}

/** @return The distance of a point from a plane. @param normal Its normal, of any length. @param at
 *  A point of the plane. */
static inline double distance_from_plane(Vec3d normal, Vec3d at, Vec3d point) {
    return fabs(vec3d_dot(vec3d_normalize(normal), vec3d_subtract(point, at)));
}

/** @return A plane as a face. @param normal Its normal, of any length. @param at A point of it. */
static inline ShapeFace face_of_plane(Vec3d normal, Vec3d at) {
    return (ShapeFace){.corners = {at}, .corner_count = 1, .normal = vec3d_normalize(normal)};
}

/** @return A polygon as a face. @param normal Its normal, of any length. */
static inline ShapeFace face_of_corners(Vec3d normal, const Vec3d *corners, int count) {
    ShapeFace face = {.corner_count = count, .normal = vec3d_normalize(normal)};
    for (int i = 0; i < count; i++) {
        face.corners[i] = corners[i];
    }
    return face;
}

/** @return A disk as a face: an octagon of the same area. @param normal Its normal, of any length.
 */
ShapeFace face_of_disk(Vec3d normal, Vec3d center, double radius);

#endif
