/**
 * @file
 * @brief A closed mesh: an icosahedron, subdivided several times and projected onto a sphere.
 */
#ifndef DIOPTRE_LAB_EXPERIMENTS_ICOSPHERE_H
#define DIOPTRE_LAB_EXPERIMENTS_ICOSPHERE_H

#include "lab/vec3q.h"

/** Subdivisions of a face into four, and the resulting counts. */
enum { ICOSPHERE_SUBDIVISIONS = 3, ICOSPHERE_FACES = 1280, ICOSPHERE_CORNERS = 642 };
/** Most triangles around a vertex. */
enum { ICOSPHERE_VALENCE = 6 };

/** A closed mesh. */
typedef struct Icosphere {
    Vec3q vertices[ICOSPHERE_CORNERS];                      /**< Positions of the vertices. */
    int vertex_count;                                       /**< Number of #vertices. */
    int faces[ICOSPHERE_FACES][3];                          /**< Three vertices each. */
    int face_count;                                         /**< Number of #faces. */
    int vertex_faces[ICOSPHERE_CORNERS][ICOSPHERE_VALENCE]; /**< The faces around each vertex. */
    int valence[ICOSPHERE_CORNERS];                         /**< Number of faces around each
                                                                 vertex. */
} Icosphere;

/**
 * Makes an icosphere of radius 1.
 * @param center  Its centre; vertices are rounded to float.
 * @return It, to be released with free; NULL without memory.
 */
Icosphere *icosphere_create(Vec3q center);

#endif
