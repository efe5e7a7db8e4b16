/**
 * @file
 * @brief Pairs of shapes whose bounding boxes overlap.
 *
 * Shapes are divided along the longest side of their box again and again, and groups whose boxes do
 * not overlap are not compared: for n shapes, n log n boxes instead of n squared. Spheres fight
 * only if their boxes are nearly the same, so these are sorted. Where shapes stand so that this
 * does not help, #Z_FIGHTING_PAIRS_MAXIMUM ends the search.
 */
#include "render/z_fighting/search.h"

#include <math.h>
#include <stdlib.h>

/** Number of boxes that are compared without further division. */
enum { LEAF_BOXES = 16 };

/** Difference of two spheres' boxes, in bounds, from which on they fight in a thin ring only. */
#define SPHERES_APART 256

/** @return Whether the common part of two boxes is thin in two directions: shapes in them touch in
 *          an edge or a corner at most. @param bound Length that counts as thin. */
static bool boxes_touch_in_edge(const Aabbd *a, const Aabbd *b, double bound) {
    Vec3d size = vec3d_subtract(vec3d_min(a->high, b->high), vec3d_max(a->low, b->low));
    return (size.x <= bound) + (size.y <= bound) + (size.z <= bound) >= 2;
}

/** Compares two bounded shapes. */
static void compare_shapes(Search *search, const BoundedShape *a, const BoundedShape *b) {
    // Both boxes are enlarged by their bounds on each side.
    if (!search_begin_pair(search) || !aabbd_overlaps(&a->box, &b->box) ||
        boxes_touch_in_edge(&a->box, &b->box, 3 * (a->bound + b->bound)) ||
        search->shape_pairs++ >= SHAPE_PAIRS_MAXIMUM) {
        return;
    }
    double bound = a->bound > b->bound ? a->bound : b->bound;
    if (a->mesh || b->mesh) {
        const BoundedShape *mesh = a->mesh ? a : b, *other = a->mesh ? b : a;
        compare_mesh(search, mesh->shape, mesh->mesh, other->shape, bound);
        return;
    }
    compare_flat_shapes(search, a->shape, b->shape, bound);
    compare_shells(search, a->shape, b->shape, bound);
}

/** @return The box around the boxes of shapes. */
static Aabbd shapes_bounds(const BoundedShape *shapes, size_t count) {
    Aabbd bounds = aabbd_empty();
    for (size_t i = 0; i < count; i++) {
        bounds.low = vec3d_min(bounds.low, shapes[i].box.low);
        bounds.high = vec3d_max(bounds.high, shapes[i].box.high);
    }
    return bounds;
}

/** Moves the shapes that overlap a box to the front. @return Their number. */
static size_t move_to_front(BoundedShape *shapes, size_t count, const Aabbd *overlapping) {
    size_t front = 0;
    for (size_t i = 0; i < count; i++) {
        if (aabbd_overlaps(&shapes[i].box, overlapping)) {
            BoundedShape moved = shapes[i];
            shapes[i] = shapes[front];
            shapes[front++] = moved;
        }
    }
    return front;
}

/** @return A coordinate of a point. @param axis 0, 1 or 2. */
static double coordinate(Vec3d p, int axis) {
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/** Divides shapes in two groups along the longest side of their box. @return The number in the
 *  first group, which is neither 0 nor all. */
static size_t divide_shapes(BoundedShape *shapes, size_t count) {
    Aabbd bounds = shapes_bounds(shapes, count);
    Vec3d size = vec3d_subtract(bounds.high, bounds.low);
    int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    double twice_middle = coordinate(vec3d_add(bounds.low, bounds.high), axis);
    size_t front = 0;
    for (size_t i = 0; i < count; i++) {
        Vec3d twice_center = vec3d_add(shapes[i].box.low, shapes[i].box.high);
        if (coordinate(twice_center, axis) < twice_middle) {
            BoundedShape moved = shapes[i];
            shapes[i] = shapes[front];
            shapes[front++] = moved;
        }
    }
    return front > 0 && front < count ? front : count / 2;
}

/** Compares the shapes of one group with those of another. */
static void compare_groups(Search *search, BoundedShape *a, size_t count_a, BoundedShape *b,
                           size_t count_b) {
    Aabbd bounds_a = shapes_bounds(a, count_a), bounds_b = shapes_bounds(b, count_b);
    count_a = move_to_front(a, count_a, &bounds_b);
    count_b = move_to_front(b, count_b, &bounds_a);
    if (count_a == 0 || count_b == 0 || search->result.pairs >= Z_FIGHTING_PAIRS_MAXIMUM) {
        return;
    }
    if (count_a <= LEAF_BOXES && count_b <= LEAF_BOXES) {
        for (size_t i = 0; i < count_a * count_b; i++) {
            compare_shapes(search, &a[i / count_b], &b[i % count_b]);
        }
    } else if (count_a > count_b) {
        size_t front = divide_shapes(a, count_a);
        compare_groups(search, a, front, b, count_b);
        compare_groups(search, a + front, count_a - front, b, count_b);
    } else {
        size_t front = divide_shapes(b, count_b);
        compare_groups(search, a, count_a, b, front);
        compare_groups(search, a, count_a, b + front, count_b - front);
    }
}

void compare_group(Search *search, BoundedShape *shapes, size_t count) {
    if (count > LEAF_BOXES) {
        size_t front = divide_shapes(shapes, count);
        compare_group(search, shapes, front);
        compare_group(search, shapes + front, count - front);
        compare_groups(search, shapes, front, shapes + front, count - front);
        return;
    }
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < i; k++) {
            compare_shapes(search, &shapes[k], &shapes[i]);
        }
    }
}

/** A direction aslant to the rows and walls in which spheres may stand: along it, spheres of
 *  different places have different positions. */
static const Vec3d aslant = {1, 0.7548776662466927, 0.5698402909980532};

/** @return The position of a shape: that of its box's lowest corner along #aslant. */
static double aslant_position(const BoundedShape *shape) {
    return vec3d_dot(shape->box.low, aslant);
}

/** Orders shapes by their positions, for qsort(). */
static int compare_positions(const void *a, const void *b) {
    double x = aslant_position(a), y = aslant_position(b);
    return (x > y) - (x < y);
}

/** Compares two spheres if their boxes are nearly the same. @param reach Largest difference. */
static void compare_sphere_pair(Search *search, const BoundedShape *a, const BoundedShape *b,
                                double reach) {
    Vec3d low = vec3d_subtract(a->box.low, b->box.low),
          high = vec3d_subtract(a->box.high, b->box.high);
    if (vec3d_max_abs(low) <= reach && vec3d_max_abs(high) <= reach &&
        search->shape_pairs++ < SHAPE_PAIRS_MAXIMUM) {
        compare_shells(search, a->shape, b->shape, a->bound);
    }
}

void compare_spheres(Search *search, BoundedShape *spheres, size_t count) {
    qsort(spheres, count, sizeof *spheres, compare_positions);
    for (size_t i = 0; i < count; i++) {
        const BoundedShape *a = &spheres[i], *end = spheres + count;
        double reach = SPHERES_APART * a->bound;
        double last = aslant_position(a) + reach * (aslant.x + aslant.y + aslant.z);
        for (const BoundedShape *b = a + 1;
             b < end && aslant_position(b) <= last && search_begin_pair(search); b++) {
            compare_sphere_pair(search, a, b, reach);
        }
    }
}

/** @return Whether a box reaches the plane of a face. */
static bool aabbd_touches_plane(const Aabbd *box, const ShapeFace *face) {
    Vec3d n = face->normal, half = vec3d_scale(vec3d_subtract(box->high, box->low), 0.5);
    double reach = fabs(n.x) * half.x + fabs(n.y) * half.y + fabs(n.z) * half.z;
    return fabs(height_above(face, vec3d_subtract(box->high, half))) <= reach;
}

void compare_plane_with_shapes(Search *search, const SceneShape *shape, const BoundedShape *shapes,
                               size_t count) {
    ShapeFace plane;
    scene_shape_faces(shape, &plane);
    for (size_t i = 0; i < count && search_begin_pair(search); i++) {
        const BoundedShape *other = &shapes[i];
        if (!aabbd_touches_plane(&other->box, &plane) ||
            search->shape_pairs++ >= SHAPE_PAIRS_MAXIMUM) {
            continue;
        }
        if (other->mesh) {
            compare_mesh(search, other->shape, other->mesh, shape, other->bound);
        } else {
            compare_flat_shapes(search, shape, other->shape, other->bound);
        }
    }
}

void compare_planes(Search *search, const SceneShape *const *planes, size_t count) {
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < i && search->shape_pairs++ < SHAPE_PAIRS_MAXIMUM; k++) {
            compare_flat_shapes(search, planes[k], planes[i], HUGE_VAL);
        }
    }
}
