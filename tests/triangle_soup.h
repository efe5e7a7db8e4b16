/**
 * @file
 * @brief Triangles for tests: closed meshes, flat grids, and single triangles.
 */
#ifndef TESTS_TRIANGLE_SOUP_H
#define TESTS_TRIANGLE_SOUP_H

#include "testing.h"

#include <stdlib.h>

/** Triangles with shared vertices. */
typedef struct TriangleSoup {
    Vec3d *positions;        /**< Positions of the vertices; owned. */
    size_t position_count;   /**< Number of #positions. */
    MeshTriangle *triangles; /**< Vertex indices; owned. */
    size_t triangle_count;   /**< Number of #triangles. */
} TriangleSoup;

/** @return Triangles without shared vertices, with all positions zero; to be destroyed. */
static inline TriangleSoup triangle_soup_create(size_t count) {
    TriangleSoup t = {calloc(3 * count, sizeof *t.positions), 3 * count,
                      calloc(count, sizeof *t.triangles), count};
    assert_non_null(t.positions);
    assert_non_null(t.triangles);
    for (uint32_t i = 0; i < 3 * count; i++) {
        t.triangles[i / 3].index[i % 3] = i;
    }
    return t;
}

/** Destroys triangles. */
static inline void triangle_soup_destroy(TriangleSoup *t) {
    free(t->positions);
    free(t->triangles);
    *t = (TriangleSoup){0};
}

/** @return The position of a vertex. */
static inline Vec3d triangle_soup_vertex(const TriangleSoup *t, size_t i, size_t corner) {
    return t->positions[t->triangles[i].index[corner]];
}

/** Adds triangles as a mesh to a scene. */
static inline void add_triangle_soup(Scene *scene, const TriangleSoup *t, int normals) {
    add_mesh(scene, t->positions, t->position_count, t->triangles, t->triangle_count, normals);
}

/** Compares vertices, for qsort. @return See qsort. */
static inline int compare_vertices(const void *a, const void *b) {
    const Vec3d *p = *(const Vec3d *const *)a, *q = *(const Vec3d *const *)b;
    if (p->x != q->x) {
        return p->x < q->x ? -1 : 1;
    }
    if (p->y != q->y) {
        return p->y < q->y ? -1 : 1;
    }
    return (p->z > q->z) - (p->z < q->z);
}

/** Merges equal vertices. @param t Triangles without shared vertices. */
static inline void triangle_soup_weld(TriangleSoup *t) {
    const Vec3d **sorted = calloc(t->position_count, sizeof *sorted);
    Vec3d *shared = calloc(t->position_count, sizeof *shared);
    size_t count = 0;
    assert_true(sorted && shared);
    for (size_t i = 0; i < t->position_count; i++) {
        sorted[i] = &t->positions[i];
    }
    qsort(sorted, t->position_count, sizeof *sorted, compare_vertices);
    for (size_t i = 0; i < t->position_count; i++) {
        if (i == 0 || compare_vertices(&sorted[i - 1], &sorted[i]) != 0) {
            shared[count++] = *sorted[i];
        }
        size_t at = (size_t)(sorted[i] - t->positions);
        t->triangles[at / 3].index[at % 3] = (uint32_t)(count - 1);
    }
    free(sorted);
    free(t->positions);
    t->positions = shared;
    t->position_count = count;
}

/* --- a closed mesh --------------------------------------------------------------------------- */

/** Radius of an icosphere. */
#define ICOSPHERE_RADIUS 2

/**
 * @return The midpoint of an edge, moved to the sphere and rounded to float; the same for both
 *         faces of the edge.
 */
static inline Vec3d sphere_midpoint(Vec3d a, Vec3d b) {
    Vec3d m = vec3d_scale(vec3d_normalize(vec3d_add(a, b)), ICOSPHERE_RADIUS);
    return (Vec3d){round_to_float(m.x), round_to_float(m.y), round_to_float(m.z)};
}

/**
 * Adds a face, subdivided.
 * @param[in,out] t  Triangles with free capacity; their count increases.
 * @param times  Number of subdivisions.
 */
static inline void icosphere_add_face(TriangleSoup *t, Vec3d a, Vec3d b, Vec3d c, int times) {
    if (times == 0) {
        const Vec3d face[3] = {a, b, c};
        memcpy(&t->positions[3 * t->triangle_count++], face, sizeof face);
        return;
    }
    Vec3d ab = sphere_midpoint(a, b), bc = sphere_midpoint(b, c), ca = sphere_midpoint(c, a);
    icosphere_add_face(t, a, ab, ca, times - 1);
    icosphere_add_face(t, ab, b, bc, times - 1);
    icosphere_add_face(t, ca, bc, c, times - 1);
    icosphere_add_face(t, ab, bc, ca, times - 1);
}

/** @return A vertex of an icosahedron. */
static inline Vec3d icosahedron_vertex(int which) {
    double golden = (which & 1 ? -1 : 1) * (1 + sqrt(5)) / 2, one = which & 2 ? -1 : 1;
    Vec3d v = which < 4   ? (Vec3d){0, one, golden}
              : which < 8 ? (Vec3d){golden, 0, one}
                          : (Vec3d){one, golden, 0};
    return sphere_midpoint(v, v);
}

/**
 * Adds a face of an icosahedron if three vertices are neighbours, with its front outwards.
 * @param times Number of subdivisions.
 */
static inline void icosahedron_add_face(TriangleSoup *t, Vec3d a, Vec3d b, Vec3d c, int times) {
    /**
     * Upper bound of the squared edge of an icosahedron of radius 2; the next larger squared
     * distance is 10.5.
     */
    const double edge = 5;
    Vec3d ab = vec3d_subtract(b, a), bc = vec3d_subtract(c, b), ca = vec3d_subtract(a, c);
    if (vec3d_dot(ab, ab) < edge && vec3d_dot(bc, bc) < edge && vec3d_dot(ca, ca) < edge) {
        bool is_outwards = vec3d_dot(vec3d_cross(ab, bc), a) > 0;
        icosphere_add_face(t, a, is_outwards ? b : c, is_outwards ? c : b, times);
    }
}

/**
 * @return A closed mesh of 20 * 4^times faces around the origin, to be destroyed.
 * @param times  Number of subdivisions of each face of an icosahedron into four.
 */
static inline TriangleSoup icosphere_triangles(int times) {
    size_t count = (size_t)20 << 2 * times;
    TriangleSoup t = triangle_soup_create(count);
    t.triangle_count = 0;
    for (int i = 0; i < 12; i++) {
        for (int j = 0; j < i; j++) {
            for (int k = 0; k < j; k++) {
                icosahedron_add_face(&t, icosahedron_vertex(i), icosahedron_vertex(j),
                                     icosahedron_vertex(k), times);
            }
        }
    }
    assert_int_equal(t.triangle_count, count);
    triangle_soup_weld(&t);
    return t;
}

/* --- a flat mesh ----------------------------------------------------------------------------- */

/**
 * @return A square of side 4 around the origin, divided into cells of two triangles each; to be
 *         destroyed.
 * @param axis  The axis perpendicular to it.
 * @param height  Coordinate on that axis.
 * @param cells  Cells per side.
 */
static inline TriangleSoup grid_triangles(int axis, double height, size_t cells) {
    static const int corners[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    TriangleSoup t = triangle_soup_create(2 * cells * cells);
    for (size_t i = 0; i < t.position_count; i++) {
        size_t cell = i / 6;
        double at[3];
        at[axis] = height;
        at[(axis + 1) % 3] =
            4.0 * (double)(cell % cells + (size_t)corners[i % 6][0]) / (double)cells - 2;
        at[(axis + 2) % 3] =
            4.0 * (double)(cell / cells + (size_t)corners[i % 6][1]) / (double)cells - 2;
        t.positions[i] = (Vec3d){at[0], at[1], at[2]};
    }
    triangle_soup_weld(&t);
    return t;
}

#endif
