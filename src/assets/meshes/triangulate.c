/**
 * @file
 * @brief Triangulation of polygons by cutting ears.
 *
 * An ear is a triangle of three successive vertices that lies inside the polygon. Every simple
 * polygon has one (Meisters, *Polygons Have Ears*, 1975). Cutting them takes a time that grows with
 * the square of the number of vertices; convex polygons are cut into a fan at once.
 *
 * A polygon that is not flat is cut as it is seen along an axis. Where its edges cross in that
 * view, it is cut as seen along its normal. A quadrilateral whose edges cross even there is folded
 * along a diagonal, so that a mesh stays closed; a larger polygon misses triangles.
 */
#include "assets/meshes/triangulate.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/** A polygon in a plane. */
typedef struct PlanarPolygon {
    const Vec3d *vertices; /**< Its vertices. */
    Vec3d right;           /**< Direction of x in the plane. */
    Vec3d up;              /**< Direction of y in the plane. */
    double sign;           /**< Below 0: the polygon is seen from behind. */
    uint32_t *chain;       /**< Indices of the vertices that are left, in order. */
    size_t count;          /**< Number of those. */
} PlanarPolygon;

/** @return The normal of a polygon, of twice its area as length (Newell's method). */
static Vec3d area_vector(const Vec3d *vertices, size_t count) {
    Vec3d sum = {0, 0, 0};
    for (size_t i = 2; i < count; i++) {
        Vec3d a = vec3d_subtract(vertices[i - 1], vertices[0]);
        sum = vec3d_add(sum, vec3d_cross(a, vec3d_subtract(vertices[i], vertices[0])));
    }
    return sum;
}

/** @return A vertex in the plane, in x and y. Exactly its coordinates where the directions are
 * axes.
 */
static Vec3d project(const PlanarPolygon *polygon, size_t index) {
    Vec3d v = polygon->vertices[index];
    return (Vec3d){vec3d_dot(v, polygon->right), vec3d_dot(v, polygon->up), 0};
}

/** @return Twice the area of a triangle: above 0 if it is oriented as the polygon. */
static double oriented_area(const PlanarPolygon *polygon, Vec3d a, Vec3d b, Vec3d c) {
    return polygon->sign * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/** A corner of what is left of a polygon. */
typedef struct PolygonCorner {
    uint32_t index[3]; /**< The previous vertex, the corner and the next vertex. */
    Vec3d at[3];       /**< The same, projected. */
} PolygonCorner;

/** @return Corner i, 0 to the number of vertices that are left. */
static PolygonCorner corner_at(const PlanarPolygon *polygon, size_t i) {
    size_t count = polygon->count;
    PolygonCorner corner = {.index = {polygon->chain[(i + count - 1) % count],
                                      polygon->chain[i % count], polygon->chain[(i + 1) % count]}};
    for (int k = 0; k < 3; k++) {
        corner.at[k] = project(polygon, corner.index[k]);
    }
    return corner;
}

/** @return Twice the area of the triangle of a corner; below 0 at a reflex one. */
static double corner_area(const PlanarPolygon *polygon, const PolygonCorner *corner) {
    return oriented_area(polygon, corner->at[0], corner->at[1], corner->at[2]);
}

/** @return Whether two points are the same. */
static bool is_same(Vec3d a, Vec3d b) {
    return a.x == b.x && a.y == b.y;
}

/** @return Whether a point lies in the triangle of a corner, or on its edges but not at a vertex.
 */
static bool corner_contains(const PlanarPolygon *polygon, const PolygonCorner *corner, Vec3d p) {
    const Vec3d *at = corner->at;
    return !is_same(p, at[0]) && !is_same(p, at[1]) && !is_same(p, at[2]) &&
           oriented_area(polygon, at[0], at[1], p) >= 0 &&
           oriented_area(polygon, at[1], at[2], p) >= 0 &&
           oriented_area(polygon, at[2], at[0], p) >= 0;
}

/** @return Whether a corner is an ear: no other vertex lies in its triangle. */
static bool is_ear(const PlanarPolygon *polygon, const PolygonCorner *corner) {
    if (!(corner_area(polygon, corner) > 0)) {
        return false;
    }
    for (size_t i = 0; i < polygon->count; i++) {
        if (corner_contains(polygon, corner, project(polygon, polygon->chain[i]))) {
            return false;
        }
    }
    return true;
}

/** Removes a vertex of the chain. */
static void remove_vertex(PlanarPolygon *polygon, size_t i) {
    polygon->count--;
    memmove(polygon->chain + i, polygon->chain + i + 1,
            (polygon->count - i) * sizeof *polygon->chain);
}

/** @return Index of the first ear from a corner on; the number of corners: there is none. */
static size_t find_ear(const PlanarPolygon *polygon, size_t from) {
    for (size_t step = 0; step < polygon->count; step++) {
        size_t i = (from + step) % polygon->count;
        PolygonCorner corner = corner_at(polygon, i);
        if (is_ear(polygon, &corner)) {
            return i;
        }
    }
    return polygon->count;
}

/** Removes the first vertex on the straight line between its neighbours, which no triangle needs.
 *  @return Whether there is one. */
static bool remove_straight_vertex(PlanarPolygon *polygon) {
    for (size_t i = 0; i < polygon->count; i++) {
        PolygonCorner corner = corner_at(polygon, i);
        if (corner_area(polygon, &corner) == 0) {
            remove_vertex(polygon, i);
            return true;
        }
    }
    return false;
}

/** @return Whether no corner is reflex or straight. */
static bool is_convex(const PlanarPolygon *polygon) {
    for (size_t i = 0; i < polygon->count; i++) {
        PolygonCorner corner = corner_at(polygon, i);
        if (!(corner_area(polygon, &corner) > 0)) {
            return false;
        }
    }
    // A star that winds around its middle twice has no reflex corner either.
    PolygonCorner first = corner_at(polygon, 0);
    for (size_t i = 2; i + 1 < polygon->count; i++) {
        Vec3d a = project(polygon, polygon->chain[i]), b = project(polygon, polygon->chain[i + 1]);
        if (!(oriented_area(polygon, first.at[1], a, b) > 0)) {
            return false;
        }
    }
    return true;
}

/** Writes the triangles of a fan around the first vertex. @return Their number. */
static size_t cut_fan(const PlanarPolygon *polygon, uint32_t *triangles) {
    for (size_t i = 1; i + 1 < polygon->count; i++) {
        *triangles++ = polygon->chain[0];
        *triangles++ = polygon->chain[i];
        *triangles++ = polygon->chain[i + 1];
    }
    return polygon->count - 2;
}

/** Cuts ears until none is left. @return Number of triangles. */
static size_t cut_ears(PlanarPolygon *polygon, uint32_t *triangles) {
    size_t made = 0, from = 0;
    while (polygon->count >= 3) {
        size_t ear = find_ear(polygon, from);
        if (ear < polygon->count) {
            PolygonCorner corner = corner_at(polygon, ear);
            memcpy(triangles + 3 * made++, corner.index, sizeof corner.index);
            remove_vertex(polygon, ear);
            // Not the same corner again: that would cut a fan of slivers.
            from = ear + 1;
        } else if (!remove_straight_vertex(polygon)) {
            break;
        }
    }
    return made;
}

/** Cuts a polygon in a plane. @return Number of triangles. */
static size_t cut_in_plane(PlanarPolygon *polygon, uint32_t *triangles, size_t *missing) {
    for (size_t i = 0; i < polygon->count; i++) {
        polygon->chain[i] = (uint32_t)i;
    }
    *missing = 0;
    if (is_convex(polygon)) {
        return cut_fan(polygon, triangles);
    }
    size_t made = cut_ears(polygon, triangles);
    *missing = polygon->count >= 3 ? polygon->count - 2 : 0;
    return made;
}

/** @return The axis along which a polygon is seen largest: 0, 1 or 2. */
static int largest_axis(Vec3d normal) {
    double x = fabs(normal.x), y = fabs(normal.y), z = fabs(normal.z);
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

/** @return A coordinate of a vector. */
static double coordinate(Vec3d v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/** The axes. */
static const Vec3d axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/** @return The cosine of the angle by which two triangles on an edge are folded; 0 if one has no
 *  area. @param a Start of the edge. @param b A vertex. @param c End of the edge. @param d The
 *  other vertex. */
static double fold_cosine(Vec3d a, Vec3d b, Vec3d c, Vec3d d) {
    Vec3d first = vec3d_cross(vec3d_subtract(b, a), vec3d_subtract(c, a));
    Vec3d second = vec3d_cross(vec3d_subtract(c, a), vec3d_subtract(d, a));
    double lengths = vec3d_length(first) * vec3d_length(second);
    return lengths > 0 ? vec3d_dot(first, second) / lengths : 0;
}

/** Folds a quadrilateral along the diagonal where it is flatter. @return Number of triangles. */
static size_t fold_quad(const Vec3d *v, uint32_t *triangles) {
    static const uint32_t folds[2][6] = {{0, 1, 2, 0, 2, 3}, {1, 2, 3, 1, 3, 0}};
    bool is_second = fold_cosine(v[1], v[2], v[3], v[0]) > fold_cosine(v[0], v[1], v[2], v[3]);
    memcpy(triangles, folds[is_second], sizeof folds[is_second]);
    return 2;
}

size_t triangulate_polygon(const Vec3d *vertices, size_t count, uint32_t *triangles, uint32_t *work,
                           size_t *missing) {
    Vec3d normal = area_vector(vertices, count);
    int axis = largest_axis(normal);
    double along = coordinate(normal, axis);
    *missing = 0;
    if (!(fabs(along) > 0)) {
        return 0;
    }
    PlanarPolygon polygon = {.vertices = vertices,
                             .right = axes[(axis + 1) % 3],
                             .up = axes[(axis + 2) % 3],
                             .sign = along > 0 ? 1 : -1,
                             .chain = work,
                             .count = count};
    size_t made = cut_in_plane(&polygon, triangles, missing);
    if (*missing > 0) {
        polygon.right = vec3d_normalize(vec3d_cross(axes[(axis + 1) % 3], normal));
        polygon.up = vec3d_normalize(vec3d_cross(normal, polygon.right));
        polygon.sign = 1;
        polygon.count = count;
        made = cut_in_plane(&polygon, triangles, missing);
    }
    if (*missing > 0 && count == 4) {
        *missing = 0;
        made = fold_quad(vertices, triangles);
    }
    return made;
}
