/**
 * @file
 * @brief Error of the shadow terminator.
 */
#include "render/shadow_terminator.h"

#include <math.h>

/** Largest number of triangles that are examined: sufficient for a fraction, and fast. */
enum { FACES_SAMPLED = 20000 };

/**
 * Approximate sine of the angle behind a triangle at which its smooth normals no longer face a
 * light.
 */
#define TERMINATOR_SINE 0.1

/** A triangle. */
typedef struct Face {
    Vec3d corner; /**< One of its vertices. */
    Vec3d normal; /**< Unit normal of its plane. */
    double area;  /**< Its area. */
} Face;

/** @return A triangle, transformed to the scene. */
static Face face_at(const MeshInstance *instance, size_t index) {
    Vec3d corners[3];
    for (int i = 0; i < 3; i++) {
        Vec3d corner = instance->mesh->positions[instance->mesh->triangles[index].index[i]];
        corners[i] = instance->transform ? transform_point(instance->transform, corner) : corner;
    }
    Vec3d normal =
        vec3d_cross(vec3d_subtract(corners[1], corners[0]), vec3d_subtract(corners[2], corners[0]));
    return (Face){corners[0], vec3d_normalize(normal), vec3d_length(normal) / 2};
}

/** @return The fraction of a triangle that is lit in float and not in double. */
static double face_lit_wrongly(const MeshInstance *instance, const Face *face,
                               const SceneLight *light) {
    Vec3d to_light = scene_light_offset_from(light, face->corner);
    double sine_behind = -vec3d_dot(vec3d_normalize(to_light), face->normal);
    double edge = sqrt(2 * face->area);
    bool is_affected = sine_behind > 0 && sine_behind < TERMINATOR_SINE && edge > 0;
    return is_affected ? fmin(1, instance->ray_offset / (edge * sine_behind)) : 0;
}

double shadow_terminator_fraction(const MeshInstance *instance) {
    size_t count = instance->mesh->triangle_count, stride = count / FACES_SAMPLED + 1;
    double area = 0, affected = 0;
    for (size_t i = 0; i < count; i += stride) {
        Face face = face_at(instance, i);
        area += face.area;
        for (size_t k = 0; k < instance->scene->light_count; k++) {
            affected += face.area * face_lit_wrongly(instance, &face, &instance->scene->lights[k]);
        }
    }
    return area > 0 ? affected / area : 0;
}
