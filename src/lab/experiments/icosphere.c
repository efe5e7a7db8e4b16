/**
 * @file
 * @brief A closed surface of triangles.
 */
#include "lab/experiments/icosphere.h"

#include "lab/experiments/pose.h"

#include <stdlib.h>
#include <string.h>

/** Makes the icosahedron, around zero. @param[out] ball It. */
static void make_icosahedron(Icosphere *ball) {
    static const int faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    const Quadruple golden = (1 + quad_sqrt(5)) / 2;
    const Quad3 corners[12] = {{-1, golden, 0}, {1, golden, 0}, {-1, -golden, 0}, {1, -golden, 0},
                               {0, -1, golden}, {0, 1, golden}, {0, -1, -golden}, {0, 1, -golden},
                               {golden, 0, -1}, {golden, 0, 1}, {-golden, 0, -1}, {-golden, 0, 1}};
    memcpy(ball->faces, faces, sizeof faces);
    memcpy(ball->corners, corners, sizeof corners);
    ball->face_count = 20;
    ball->corner_count = 12;
    for (int i = 0; i < ball->corner_count; i++) {
        ball->corners[i] = quad3_normalize(ball->corners[i]);
    }
}

/** @return Whether two corners are the same. @param a One. @param b The other. */
static bool is_same(Quad3 a, Quad3 b) {
    Quad3 between = quad3_subtract(a, b);
    return quad3_dot(between, between) < 1e-12;
}

/** @return The place of the corner in the middle of an edge, which is made if it is not there.
 *  @param[in,out] ball The surface. @param a An end of the edge. @param b The other. */
static int middle_of(Icosphere *ball, int a, int b) {
    Quad3 middle = quad3_normalize(quad3_add(ball->corners[a], ball->corners[b]));
    for (int i = 0; i < ball->corner_count; i++) {
        if (is_same(ball->corners[i], middle)) {
            return i;
        }
    }
    ball->corners[ball->corner_count] = middle;
    return ball->corner_count++;
}

/** Cuts each face into four. @param[in,out] ball The surface. */
static void cut(Icosphere *ball) {
    int count = ball->face_count;
    for (int i = 0; i < count; i++) {
        int *face = ball->faces[i], a = face[0], b = face[1], c = face[2];
        int ab = middle_of(ball, a, b), bc = middle_of(ball, b, c), ca = middle_of(ball, c, a);
        const int pieces[4][3] = {{ab, bc, ca}, {a, ab, ca}, {ab, b, bc}, {ca, bc, c}};
        memcpy(face, pieces[0], sizeof pieces[0]);
        memcpy(ball->faces[ball->face_count], pieces[1], 3 * sizeof pieces[1]);
        ball->face_count += 3;
    }
}

/** Finds the faces around each corner. @param[in,out] ball The surface. */
static void find_neighbours(Icosphere *ball) {
    for (int i = 0; i < ball->face_count; i++) {
        for (int k = 0; k < 3; k++) {
            int corner = ball->faces[i][k];
            ball->around[corner][ball->valence[corner]++] = i;
        }
    }
}

Icosphere *icosphere_create(Quad3 center) {
    Icosphere *ball = calloc(1, sizeof *ball);
    if (!ball) {
        return NULL;
    }
    make_icosahedron(ball);
    for (int i = 0; i < ICOSPHERE_CUTS; i++) {
        cut(ball);
    }
    find_neighbours(ball);
    for (int i = 0; i < ball->corner_count; i++) {
        ball->corners[i] = rounded(number_types()[0], quad3_add(center, ball->corners[i]));
    }
    return ball;
}
