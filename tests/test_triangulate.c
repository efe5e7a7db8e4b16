/**
 * @file
 * @brief Triangulation of polygons: the triangles cover convex, concave, straight and degenerate
 * polygons, without overlap, in every plane.
 *
 * Triangles that are all oriented as the polygon and whose areas sum up to that of the polygon
 * cover it exactly once. Coordinates are small integers times a power of two, so that areas are
 * exact.
 */
#include "testing.h"

#include "assets/meshes/triangulate.h"

#include <math.h>
#include <stdlib.h>

/** Largest number of vertices. */
enum { VERTICES = 400 };

/** A plane into which a polygon is laid: two of the axes, and slopes of the third. */
typedef struct PlaneOfTest {
    int axis;         /**< The axis across it. */
    double slopes[2]; /**< Slopes along the other two, exact. */
    bool is_mirrored; /**< Whether the order of the vertices is turned round. */
} PlaneOfTest;

/** Planes of all orientations. */
static const PlaneOfTest planes[] = {{0, {0, 0}, false},       {1, {0, 0}, true},
                                     {2, {0, 0}, false},       {0, {0.5, -0.25}, true},
                                     {1, {-0.75, 0.5}, false}, {2, {0.25, 0.75}, true}};

/** Number of planes. */
enum { PLANES = sizeof planes / sizeof *planes };

/** A polygon of the plane. */
typedef struct FlatPolygon {
    size_t count;       /**< Number of vertices. */
    double x[VERTICES]; /**< Coordinates to the right. */
    double y[VERTICES]; /**< Coordinates up. */
} FlatPolygon;

/** Adds a vertex. */
static void add(FlatPolygon *polygon, double x, double y) {
    polygon->x[polygon->count] = x;
    polygon->y[polygon->count++] = y;
}

/** @return Twice the area of a triangle of a polygon, with sign. */
static double area_of(const FlatPolygon *p, size_t a, size_t b, size_t c) {
    return (p->x[b] - p->x[a]) * (p->y[c] - p->y[a]) - (p->y[b] - p->y[a]) * (p->x[c] - p->x[a]);
}

/** Lays a polygon into a plane. @param[out] vertices The vertices. @param[out] order Their indices
 *  in the polygon. */
static void lay(const FlatPolygon *polygon, const PlaneOfTest *plane, Vec3d *vertices,
                size_t *order) {
    for (size_t i = 0; i < polygon->count; i++) {
        order[i] = plane->is_mirrored ? polygon->count - 1 - i : i;
        double u = polygon->x[order[i]], v = polygon->y[order[i]];
        double w = plane->slopes[0] * u + plane->slopes[1] * v;
        vertices[i] = plane->axis == 0   ? (Vec3d){w, u, v}
                      : plane->axis == 1 ? (Vec3d){v, w, u}
                                         : (Vec3d){u, v, w};
    }
}

/** Checks that a polygon is covered exactly once, in every plane. */
static void check_covered(const FlatPolygon *polygon, const char *name) {
    double whole = 0;
    for (size_t i = 2; i < polygon->count; i++) {
        whole += area_of(polygon, 0, i - 1, i);
    }
    for (size_t n = 0; n < PLANES; n++) {
        Vec3d vertices[VERTICES];
        size_t order[VERTICES], missing;
        uint32_t triangles[3 * VERTICES], work[VERTICES];
        lay(polygon, &planes[n], vertices, order);
        size_t count = triangulate_polygon(vertices, polygon->count, triangles, work, &missing);
        double sum = 0, smallest = INFINITY;
        for (size_t i = 0; i < count; i++) {
            const uint32_t *t = triangles + 3 * i;
            double area = area_of(polygon, order[t[0]], order[t[1]], order[t[2]]);
            area = planes[n].is_mirrored ? -area : area;
            smallest = fmin(smallest, whole < 0 ? -area : area);
            sum += area;
        }
        if (missing != 0 || !(smallest > 0) || sum != whole) {
            fail_msg("%s in plane %zu: %zu triangles, %zu missing, smallest area %g, sum %g of %g",
                     name, n, count, missing, smallest, sum, whole);
        }
    }
}

/** A square, a comb of 60 teeth, a spiral, and a gear. */
static void test_shapes(void **state) {
    (void)state;
    FlatPolygon square = {0}, comb = {0}, spiral = {0}, gear = {0};
    for (int i = 0; i < 4; i++) {
        add(&square, i == 1 || i == 2, i >= 2);
    }
    check_covered(&square, "square");
    add(&comb, 0, -1);
    add(&comb, 120, -1);
    for (int i = 60; i-- > 0;) {
        add(&comb, 2 * i + 2, 10);
        add(&comb, 2 * i + 1, 0);
    }
    add(&comb, 0, 10);
    check_covered(&comb, "comb");
    // Out along one wall of a square spiral, back along the other.
    static const int steps[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    int outer[2] = {0, 0}, corners[40][2];
    for (int i = 0; i < 40; i++) {
        corners[i][0] = outer[0];
        corners[i][1] = outer[1];
        for (int k = 0; k < 2; k++) {
            outer[k] += steps[i % 4][k] * 4 * (i / 2 + 1);
        }
    }
    for (int i = 0; i < 40; i++) {
        add(&spiral, corners[i][0], corners[i][1]);
    }
    // The inner wall: a unit inside each corner, which is the diagonal between both directions.
    for (int i = 39; i-- > 1;) {
        const int *in = steps[(i + 3) % 4], *out = steps[i % 4];
        add(&spiral, corners[i][0] - in[0] + out[0], corners[i][1] - in[1] + out[1]);
    }
    check_covered(&spiral, "spiral");
    for (int i = 0; i < 144; i++) {
        double angle = 2 * M_PI * i / 144, radius = i / 2 % 2 ? 1000 : 800;
        add(&gear, floor(radius * cos(angle)), floor(radius * sin(angle)));
    }
    check_covered(&gear, "gear");
}

/** Random stars around a point, with vertices on straight edges. */
static void test_random_stars(void **state) {
    (void)state;
    uint64_t seed = 21;
    for (int n = 0; n < 1000; n++) {
        FlatPolygon star = {0};
        int corners = 3 + n % 40;
        for (int i = 0; i < corners; i++) {
            double angle = 2 * M_PI * i / corners,
                   radius = 2000 + 30000 * random_unit_double(&seed);
            // Even, so that the middle of an edge is a whole number.
            add(&star, 2 * floor(radius * cos(angle)), 2 * floor(radius * sin(angle)));
            if (i > 0 && n % 3 == 0) {
                size_t last = star.count - 1;
                double x = star.x[last], y = star.y[last];
                star.x[last] = (x + star.x[last - 1]) / 2;
                star.y[last] = (y + star.y[last - 1]) / 2;
                add(&star, x, y);
            }
        }
        check_covered(&star, "star");
    }
}

/** Polygons without area have no triangles; crossed ones are said to miss some. */
static void test_degenerate(void **state) {
    (void)state;
    static const Vec3d line[] = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
    static const Vec3d point[] = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    uint32_t triangles[36], work[12];
    size_t missing;
    assert_int_equal(triangulate_polygon(line, 4, triangles, work, &missing), 0);
    assert_int_equal(missing, 0);
    assert_int_equal(triangulate_polygon(point, 3, triangles, work, &missing), 0);
    assert_int_equal(missing, 0);
    // Repeated vertices do no harm.
    static const Vec3d twice[] = {{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {2, 2, 0}, {0, 2, 0}};
    assert_int_equal(triangulate_polygon(twice, 6, triangles, work, &missing), 2);
    assert_int_equal(missing, 0);
    // A star of five points in one stroke ends somehow, and within its memory.
    Vec3d star[5];
    for (int i = 0; i < 5; i++) {
        star[i] = (Vec3d){cos(4 * M_PI * i / 5), sin(4 * M_PI * i / 5), 0};
    }
    assert_at_most(triangulate_polygon(star, 5, triangles, work, &missing) + missing, 3, "star");
}

/** Runs the tests. @return 0 if all pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shapes),
        cmocka_unit_test(test_random_stars),
        cmocka_unit_test(test_degenerate),
    };
    return cmocka_run_group_tests_name("triangulate", tests, NULL, NULL);
}
