/**
 * @file
 * @brief Boxes around shapes.
 */
#include "trace/shapes/shape.h"

Aabbs aabbs_from_corners(Vec3d low, Vec3d high) {
    return aabbs_padded((Aabbs){{(scalar)low.x, (scalar)low.y, (scalar)low.z},
                                {(scalar)high.x, (scalar)high.y, (scalar)high.z}});
}

Aabbs aabbs_padded_by_largest(Aabbs bounds) {
    scalar largest = 0;
    for (int axis = 0; axis < 3; axis++) {
        largest = -bounds.low[axis] > largest ? -bounds.low[axis] : largest;
        largest = bounds.high[axis] > largest ? bounds.high[axis] : largest;
    }
    for (int axis = 0; axis < 3; axis++) {
        bounds.low[axis] -= AABB_ROUNDINGS * AABB_ROUNDOFF * largest;
        bounds.high[axis] += AABB_ROUNDINGS * AABB_ROUNDOFF * largest;
    }
    return bounds;
}

Aabbs aabbs_infinite(void) {
    return (Aabbs){{-INFINITE, -INFINITE, -INFINITE}, {INFINITE, INFINITE, INFINITE}};
}
