/**
 * @file
 * @brief Error of the shadow terminator: the part of a mesh that float and double light
 *        differently.
 *
 * A triangle with smooth normals can be lit by a light that lies slightly behind its plane. Only
 * the triangle itself hides that light. The shadow ray starts a rounding error in front of the
 * triangle. It meets the plane again after that length divided by the sine of the light's
 * elevation. A point nearer to the edge than that is lit in float and dark in double.
 */
#ifndef DIOPTRE_RENDER_SHADOW_TERMINATOR_H
#define DIOPTRE_RENDER_SHADOW_TERMINATOR_H

#include "dioptre/scene.h"

/** A mesh in a scene. */
typedef struct MeshInstance {
    const Scene *scene;         /**< The scene, with its lights. */
    const Mesh *mesh;           /**< The mesh. */
    const Transform *transform; /**< Transform of the mesh; NULL: identity. */
    double ray_offset;          /**< Distance from a triangle at which rays start in float, scene
                                     units. */
} MeshInstance;

/**
 * @return The fraction of the mesh's area that is lit in float and dark in double, summed over the
 *        lights. Large meshes are sampled.
 */
double shadow_terminator_fraction(const MeshInstance *instance);

#endif
