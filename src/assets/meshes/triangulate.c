/**
 * @file
 * @brief Triangulation of polygons by cutting ears.
 *
 * An ear is a triangle of three successive vertices that lies inside the polygon. Every simple
 * polygon has one (Meisters, *Polygons Have Ears*, 1975). Cutting them takes a time that grows with
 * the square of the number of vertices; convex polygons are cut into a fan at once.
 */
#include "assets/meshes/triangulate.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/** A polygon in a plane. */
typedef struct PlanarPolygon {
    const Vec3d *vertices; /**< Its vertices. */
    int axis;              /**< The coordinate that is dropped: the largest of the normal. */
    double sign;           /**< Sign of the normal along it. */
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

/** @return A vertex without the dropped coordinate: its other two in x and y. */
static Vec3d project(const PlanarPolygon *polygon, size_t index) {
    Vec3d v = polygon->vertices[index];
    return polygon->axis == 0   ? (Vec3d){v.y, v.z, 0}
           : polygon->axis == 1 ? (Vec3d){v.z, v.x, 0}
                                : (Vec3d){v.x, v.y, 0};
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

size_t triangulate_polygon(const Vec3d *vertices, size_t count, uint32_t *triangles, uint32_t *work,
                           size_t *missing) {
    Vec3d normal = area_vector(vertices, count);
    double x = fabs(normal.x), y = fabs(normal.y), z = fabs(normal.z);
    int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    double along = axis == 0 ? normal.x : axis == 1 ? normal.y : normal.z;
    *missing = 0;
    if (!(fabs(along) > 0)) {
        return 0;
    }
    PlanarPolygon polygon = {vertices, axis, along > 0 ? 1 : -1, work, count};
    for (size_t i = 0; i < count; i++) {
        work[i] = (uint32_t)i;
    }
    if (is_convex(&polygon)) {
        return cut_fan(&polygon, triangles);
    }
    size_t made = cut_ears(&polygon, triangles);
    *missing = polygon.count >= 3 ? polygon.count - 2 : 0;
    return made;
}
