/**
 * @file
 * @brief Flat faces that are lit as though they were round.
 */
#include "render/facets.h"

#include <math.h>

/** Most faces that are looked at: enough for a share, and no time to speak of. */
enum { FACES_LOOKED_AT = 20000 };

/** Sine of the angle behind a face at which its turned normals no longer see a lamp, about. */
#define SINE_SEEN 0.1

/** A face. */
typedef struct Face {
    Vector3 corner; /**< One of its corners. */
    Vector3 normal; /**< Its own, one long. */
    double area;    /**< Its area. */
} Face;

/** @return A face as it stands in the scene. @param facets The model. @param place Which. */
static Face face_of(const Facets *facets, size_t place) {
    Vector3 corners[3];
    for (int i = 0; i < 3; i++) {
        Vector3 corner = facets->mesh->positions[facets->mesh->triangles[place].at[i]];
        corners[i] = facets->transform ? transform_point(facets->transform, corner) : corner;
    }
    Vector3 across = vector3_cross(vector3_subtract(corners[1], corners[0]),
                                   vector3_subtract(corners[2], corners[0]));
    return (Face){corners[0], vector3_normalize(across), vector3_length(across) / 2};
}

/** @return The share of a face that float lights and double does not. @param facets The model.
 *  @param face The face. @param light The lamp. */
static double face_doubt(const Facets *facets, const Face *face, const Light *light) {
    Vector3 to_lamp = light->kind == LIGHT_SUN ? vector3_scale(light->direction, -1)
                                               : vector3_subtract(light->position, face->corner);
    double behind = -vector3_dot(vector3_normalize(to_lamp), face->normal);
    double edge = sqrt(2 * face->area);
    bool is_doubtful = behind > 0 && behind < SINE_SEEN && edge > 0;
    return is_doubtful ? fmin(1, facets->start / (edge * behind)) : 0;
}

double facets_in_doubt(const Facets *facets) {
    size_t count = facets->mesh->triangle_count, step = count / FACES_LOOKED_AT + 1;
    double area = 0, doubtful = 0;
    for (size_t i = 0; i < count; i += step) {
        Face face = face_of(facets, i);
        area += face.area;
        for (size_t k = 0; k < facets->scene->light_count; k++) {
            doubtful += face.area * face_doubt(facets, &face, &facets->scene->lights[k]);
        }
    }
    return area > 0 ? doubtful / area : 0;
}
