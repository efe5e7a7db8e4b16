/**
 * @file
 * @brief Bounding boxes of shapes.
 */
#include "trace/shapes/shape.h"

Aabbs aabbs_from_corners(Vec3d low, Vec3d high) {
    return aabbs_padded((Aabbs){{(scalar)low.x, (scalar)low.y, (scalar)low.z},
                                {(scalar)high.x, (scalar)high.y, (scalar)high.z}});
}

Aabbs aabbs_padded_by_largest(Aabbs box) {
    scalar largest = 0;
    for (int axis = 0; axis < 3; axis++) {
        largest = -box.low[axis] > largest ? -box.low[axis] : largest;
        largest = box.high[axis] > largest ? box.high[axis] : largest;
    }
    for (int axis = 0; axis < 3; axis++) {
        box.low[axis] -= AABB_ROUNDINGS * AABB_ROUNDOFF * largest;
        box.high[axis] += AABB_ROUNDINGS * AABB_ROUNDOFF * largest;
    }
    return box;
}

Aabbs aabbs_infinite(void) {
    return (Aabbs){{-INFINITE, -INFINITE, -INFINITE}, {INFINITE, INFINITE, INFINITE}};
}
