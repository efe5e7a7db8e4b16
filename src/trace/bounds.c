/**
 * @file
 * @brief Boxes around shapes.
 */
#include "trace/shape.h"

Bounds bounds_around(Vector3 low, Vector3 high) {
    return bounds_outwards((Bounds){{(scalar)low.x, (scalar)low.y, (scalar)low.z},
                                    {(scalar)high.x, (scalar)high.y, (scalar)high.z}});
}

Bounds bounds_slackened(Bounds bounds) {
    scalar largest = 0;
    for (int axis = 0; axis < 3; axis++) {
        largest = -bounds.low[axis] > largest ? -bounds.low[axis] : largest;
        largest = bounds.high[axis] > largest ? bounds.high[axis] : largest;
    }
    for (int axis = 0; axis < 3; axis++) {
        bounds.low[axis] -= BOUNDS_ROUNDINGS * BOUNDS_ROUNDOFF * largest;
        bounds.high[axis] += BOUNDS_ROUNDINGS * BOUNDS_ROUNDOFF * largest;
    }
    return bounds;
}

Bounds bounds_infinite(void) {
    return (Bounds){{-INFINITE, -INFINITE, -INFINITE}, {INFINITE, INFINITE, INFINITE}};
}
