/**
 * @file
 * @brief What all shapes share: boxes around them.
 */
#include "trace/shape.h"

/**
 * Roundings that may move a found point off the box of its shape, each half an ulp of the largest
 * coordinate: eight cover the corner itself, the point and the ray's own rounding with room.
 */
#define BOUNDS_ROUNDINGS 8

Bounds bounds_around(Vector3 low, Vector3 high) {
    const double l[3] = {low.x, low.y, low.z}, h[3] = {high.x, high.y, high.z};
    Bounds bounds;
    for (int axis = 0; axis < 3; axis++) {
        scalar reach = (scalar)fmax(fabs(l[axis]), fabs(h[axis]));
        scalar slack = BOUNDS_ROUNDINGS * ROUNDOFF * reach;
        bounds.low[axis] = (scalar)l[axis] - slack;
        bounds.high[axis] = (scalar)h[axis] + slack;
    }
    return bounds;
}

Bounds bounds_infinite(void) {
    return (Bounds){{-INFINITE, -INFINITE, -INFINITE}, {INFINITE, INFINITE, INFINITE}};
}
