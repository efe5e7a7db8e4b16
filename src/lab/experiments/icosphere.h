/**
 * @file
 * @brief A closed surface of triangles: an icosahedron, each of its faces cut into four, again and
 *        again, blown up to a sphere.
 */
#ifndef DIOPTRE_LAB_EXPERIMENTS_ICOSPHERE_H
#define DIOPTRE_LAB_EXPERIMENTS_ICOSPHERE_H

#include "lab/vec3q.h"

/** How often faces are cut into four, and what comes of it. */
enum { ICOSPHERE_SUBDIVISIONS = 3, ICOSPHERE_FACES = 1280, ICOSPHERE_CORNERS = 642 };
/** Most triangles around a corner. */
enum { ICOSPHERE_VALENCE = 6 };

/** A closed surface. */
typedef struct Icosphere {
    Vec3q vertices[ICOSPHERE_CORNERS];                      /**< Where its corners are. */
    int vertex_count;                                       /**< How many. */
    int faces[ICOSPHERE_FACES][3];                          /**< Three corners each. */
    int face_count;                                         /**< How many. */
    int vertex_faces[ICOSPHERE_CORNERS][ICOSPHERE_VALENCE]; /**< The faces around each corner. */
    int valence[ICOSPHERE_CORNERS];                         /**< How many. */
} Icosphere;

/**
 * Makes an icosphere of radius 1.
 * @param center  Its centre; corners are rounded to float.
 * @return It, to be given back with free; NULL without memory.
 */
Icosphere *icosphere_create(Vec3q center);

#endif
