/**
 * @file
 * @brief A closed mesh.
 */
#include "lab/experiments/icosphere.h"

#include "lab/experiments/sample_writer.h"

#include <stdlib.h>
#include <string.h>

/** Makes the icosahedron, around zero. */
static void icosphere_init_icosahedron(Icosphere *icosphere) {
    static const int faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    const Quadruple golden = (1 + quad_sqrt(5)) / 2;
    const Vec3q corners[12] = {{-1, golden, 0}, {1, golden, 0}, {-1, -golden, 0}, {1, -golden, 0},
                               {0, -1, golden}, {0, 1, golden}, {0, -1, -golden}, {0, 1, -golden},
                               {golden, 0, -1}, {golden, 0, 1}, {-golden, 0, -1}, {-golden, 0, 1}};
    memcpy(icosphere->faces, faces, sizeof faces);
    memcpy(icosphere->vertices, corners, sizeof corners);
    icosphere->face_count = 20;
    icosphere->vertex_count = 12;
    for (int i = 0; i < icosphere->vertex_count; i++) {
        icosphere->vertices[i] = vec3q_normalize(icosphere->vertices[i]);
    }
}

/** @return Whether two vertices are the same. */
static bool points_are_equal(Vec3q a, Vec3q b) {
    Vec3q between = vec3q_subtract(a, b);
    return vec3q_dot(between, between) < 1e-12;
}

/**
 * @return The place of the corner in the middle of an edge, which is made if it is not there.
 * @param a  An end of the edge.
 */
static int edge_midpoint(Icosphere *icosphere, int a, int b) {
    Vec3q middle = vec3q_normalize(vec3q_add(icosphere->vertices[a], icosphere->vertices[b]));
    for (int i = 0; i < icosphere->vertex_count; i++) {
        if (points_are_equal(icosphere->vertices[i], middle)) {
            return i;
        }
    }
    icosphere->vertices[icosphere->vertex_count] = middle;
    return icosphere->vertex_count++;
}

/** Subdivides each face into four. */
static void icosphere_subdivide(Icosphere *icosphere) {
    int count = icosphere->face_count;
    for (int i = 0; i < count; i++) {
        int *face = icosphere->faces[i], a = face[0], b = face[1], c = face[2];
        int ab = edge_midpoint(icosphere, a, b), bc = edge_midpoint(icosphere, b, c),
            ca = edge_midpoint(icosphere, c, a);
        const int pieces[4][3] = {{ab, bc, ca}, {a, ab, ca}, {ab, b, bc}, {ca, bc, c}};
        memcpy(face, pieces[0], sizeof pieces[0]);
        memcpy(icosphere->faces[icosphere->face_count], pieces[1], 3 * sizeof pieces[1]);
        icosphere->face_count += 3;
    }
}

/** Finds the faces around each vertex. */
static void icosphere_find_vertex_faces(Icosphere *icosphere) {
    for (int i = 0; i < icosphere->face_count; i++) {
        for (int k = 0; k < 3; k++) {
            int corner = icosphere->faces[i][k];
            icosphere->vertex_faces[corner][icosphere->valence[corner]++] = i;
        }
    }
}

Icosphere *icosphere_create(Vec3q center) {
    Icosphere *icosphere = calloc(1, sizeof *icosphere);
    if (!icosphere) {
        return NULL;
    }
    icosphere_init_icosahedron(icosphere);
    for (int i = 0; i < ICOSPHERE_SUBDIVISIONS; i++) {
        icosphere_subdivide(icosphere);
    }
    icosphere_find_vertex_faces(icosphere);
    for (int i = 0; i < icosphere->vertex_count; i++) {
        icosphere->vertices[i] =
            vec3q_round(number_types()[0], vec3q_add(center, icosphere->vertices[i]));
    }
    return icosphere;
}
