/**
 * @file
 * @brief Bounding boxes of shapes.
 */
#include "trace/shapes/shape.h"

Aabbs aabbs_from_corners(Vec3d low, Vec3d high) {
    return aabbs_padded((Aabbs){{(scalar)low.x, (scalar)low.y, (scalar)low.z},
                                {(scalar)high.x, (scalar)high.y, (scalar)high.z}});
}

scalar aabbs_largest(const Aabbs *box) {
    scalar largest = 0;
    for (int axis = 0; axis < 3; axis++) {
        largest = -box->low[axis] > largest ? -box->low[axis] : largest;
        largest = box->high[axis] > largest ? box->high[axis] : largest;
    }
    return largest;
}

Aabbs aabbs_enlarged(Aabbs box, scalar length) {
    for (int axis = 0; axis < 3; axis++) {
        box.low[axis] -= length;
        box.high[axis] += length;
    }
    return box;
}

Aabbs aabbs_padded_by_largest(Aabbs box) {
    return aabbs_enlarged(box, AABB_ROUNDINGS * AABB_ROUNDOFF * aabbs_largest(&box));
}

bool aabbs_overlap(const Aabbs *a, const Aabbs *b) {
    bool overlap = true;
    for (int axis = 0; axis < 3; axis++) {
        overlap = overlap && a->low[axis] <= b->high[axis] && b->low[axis] <= a->high[axis];
    }
    return overlap;
}

bool aabbs_is_bounded(const Aabbs *box) {
    bool is_bounded = true;
    for (int axis = 0; axis < 3; axis++) {
        is_bounded = is_bounded && box->low[axis] > -INFINITE && box->high[axis] < INFINITE;
    }
    return is_bounded;
}

Aabbs aabbs_infinite(void) {
    return (Aabbs){{-INFINITE, -INFINITE, -INFINITE}, {INFINITE, INFINITE, INFINITE}};
}
