/**
 * @file
 * @brief Triangles for tests: closed, flat, or one by one.
 */
#ifndef DIOPTRE_TRIANGLES_H
#define DIOPTRE_TRIANGLES_H

#include "testing.h"

#include <stdlib.h>

/** Triangles that share their corners. */
typedef struct Triangles {
    Vector3 *positions;      /**< The corners; owned. */
    size_t position_count;   /**< How many. */
    MeshTriangle *triangles; /**< Places of corners; owned. */
    size_t triangle_count;   /**< How many. */
} Triangles;

/** @return Triangles that share nothing, their corners still zero; to be given back.
 *  @param count How many. */
static inline Triangles triangles_create(size_t count) {
    Triangles t = {calloc(3 * count, sizeof *t.positions), 3 * count,
                   calloc(count, sizeof *t.triangles), count};
    assert_non_null(t.positions);
    assert_non_null(t.triangles);
    for (uint32_t i = 0; i < 3 * count; i++) {
        t.triangles[i / 3].at[i % 3] = i;
    }
    return t;
}

/** Gives triangles back. @param t The triangles. */
static inline void triangles_release(Triangles *t) {
    free(t->positions);
    free(t->triangles);
    *t = (Triangles){0};
}

/** @return A corner. @param t Triangles. @param i Which triangle. @param corner 0 to 2. */
static inline Vector3 triangles_corner(const Triangles *t, size_t i, size_t corner) {
    return t->positions[t->triangles[i].at[corner]];
}

/** Adds triangles as a mesh to a scene. @param scene The scene. @param t The triangles.
 *  @param normals See #MeshRow. */
static inline void add_triangles(Scene *scene, const Triangles *t, int normals) {
    add_mesh(scene, t->positions, t->position_count, t->triangles, t->triangle_count, normals);
}

/** Orders corners, for qsort. @param a One. @param b The other. @return See qsort. */
static inline int corners_compare(const void *a, const void *b) {
    const Vector3 *p = *(const Vector3 *const *)a, *q = *(const Vector3 *const *)b;
    if (p->x != q->x) {
        return p->x < q->x ? -1 : 1;
    }
    if (p->y != q->y) {
        return p->y < q->y ? -1 : 1;
    }
    return (p->z > q->z) - (p->z < q->z);
}

/** Makes triangles share the corners that are the same. @param t Triangles that share nothing. */
static inline void triangles_weld(Triangles *t) {
    const Vector3 **sorted = calloc(t->position_count, sizeof *sorted);
    Vector3 *shared = calloc(t->position_count, sizeof *shared);
    size_t count = 0;
    assert_true(sorted && shared);
    for (size_t i = 0; i < t->position_count; i++) {
        sorted[i] = &t->positions[i];
    }
    qsort(sorted, t->position_count, sizeof *sorted, corners_compare);
    for (size_t i = 0; i < t->position_count; i++) {
        if (i == 0 || corners_compare(&sorted[i - 1], &sorted[i]) != 0) {
            shared[count++] = *sorted[i];
        }
        size_t at = (size_t)(sorted[i] - t->positions);
        t->triangles[at / 3].at[at % 3] = (uint32_t)(count - 1);
    }
    free(sorted);
    free(t->positions);
    t->positions = shared;
    t->position_count = count;
}

/* --- a closed mesh --------------------------------------------------------------------------- */

/** Radius of an icosphere. */
#define ICOSPHERE_RADIUS 2

/** @return A point as far from the zero as the mesh is, exact in float, the same for both faces of
 *          an edge. @param a One end. @param b The other. */
static inline Vector3 middle_of(Vector3 a, Vector3 b) {
    Vector3 m = vector3_scale(vector3_normalize(vector3_add(a, b)), ICOSPHERE_RADIUS);
    return (Vector3){as_float(m.x), as_float(m.y), as_float(m.z)};
}

/** Adds a face, divided. @param[in,out] t Triangles with room; their number is raised.
 *  @param a A corner. @param b A corner. @param c A corner. @param times How often it is divided.
 */
static inline void icosphere_add(Triangles *t, Vector3 a, Vector3 b, Vector3 c, int times) {
    if (times == 0) {
        const Vector3 face[3] = {a, b, c};
        memcpy(&t->positions[3 * t->triangle_count++], face, sizeof face);
        return;
    }
    Vector3 ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
    icosphere_add(t, a, ab, ca, times - 1);
    icosphere_add(t, ab, b, bc, times - 1);
    icosphere_add(t, ca, bc, c, times - 1);
    icosphere_add(t, ab, bc, ca, times - 1);
}

/** @return A corner of an icosahedron. @param which 0 to 11. */
static inline Vector3 icosahedron_corner(int which) {
    double golden = (which & 1 ? -1 : 1) * (1 + sqrt(5)) / 2, one = which & 2 ? -1 : 1;
    Vector3 v = which < 4   ? (Vector3){0, one, golden}
                : which < 8 ? (Vector3){golden, 0, one}
                            : (Vector3){one, golden, 0};
    return middle_of(v, v);
}

/** Adds a face of an icosahedron where three corners are neighbours, its front outwards.
 *  @param[in,out] t See #icosphere_add. @param a A corner. @param b A corner. @param c A corner.
 *  @param times How often it is divided. */
static inline void icosahedron_add(Triangles *t, Vector3 a, Vector3 b, Vector3 c, int times) {
    /** Squared edge of an icosahedron of radius 2, with room: the next distance is 10.5. */
    const double edge = 5;
    Vector3 ab = vector3_subtract(b, a), bc = vector3_subtract(c, b), ca = vector3_subtract(a, c);
    if (vector3_dot(ab, ab) < edge && vector3_dot(bc, bc) < edge && vector3_dot(ca, ca) < edge) {
        bool is_outwards = vector3_dot(vector3_cross(ab, bc), a) > 0;
        icosphere_add(t, a, is_outwards ? b : c, is_outwards ? c : b, times);
    }
}

/** @return A closed mesh of 20 * 4^times faces around the zero, to be given back.
 *  @param times How often each face of an icosahedron is divided into four. */
static inline Triangles icosphere(int times) {
    size_t count = (size_t)20 << 2 * times;
    Triangles t = triangles_create(count);
    t.triangle_count = 0;
    for (int i = 0; i < 12; i++) {
        for (int j = 0; j < i; j++) {
            for (int k = 0; k < j; k++) {
                icosahedron_add(&t, icosahedron_corner(i), icosahedron_corner(j),
                                icosahedron_corner(k), times);
            }
        }
    }
    assert_int_equal(t.triangle_count, count);
    triangles_weld(&t);
    return t;
}

/* --- a flat mesh ----------------------------------------------------------------------------- */

/** @return A square of side 4 around the zero, cut into cells of two triangles each; to be given
 *          back. @param axis The axis that it stands across. @param height Where on that axis.
 *  @param cells How many cells a side. */
static inline Triangles grid_of(int axis, double height, size_t cells) {
    static const int corners[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    Triangles t = triangles_create(2 * cells * cells);
    for (size_t i = 0; i < t.position_count; i++) {
        size_t cell = i / 6;
        double at[3];
        at[axis] = height;
        at[(axis + 1) % 3] =
            4.0 * (double)(cell % cells + (size_t)corners[i % 6][0]) / (double)cells - 2;
        at[(axis + 2) % 3] =
            4.0 * (double)(cell / cells + (size_t)corners[i % 6][1]) / (double)cells - 2;
        t.positions[i] = (Vector3){at[0], at[1], at[2]};
    }
    triangles_weld(&t);
    return t;
}

#endif
