/**
 * @file
 * @brief Where in the scene the coordinates of a tracer begin.
 */
#include "trace/rebase.h"

/** How many times as far away as large shapes are when the origin is moved to them: what their
 *  coordinates have in common are two bits then. */
#define REBASE_MIN_SIZES 4

/** The new origin is a multiple of the power of two that is so many times, at least, in the shapes'
 *  size: it has few digits, so that differences to it are exact in double. */
#define REBASE_SIZE_GRAINS 8

void rebase_bounds(const ShapeSet *list, Vec3d *low, Vec3d *high) {
    *low = (Vec3d){HUGE_VAL, HUGE_VAL, HUGE_VAL};
    *high = vec3d_scale(*low, -1);
    for (size_t i = 0; i < list->count; i++) {
        Aabbs box = list->shapes[i]->class->bounds(list->shapes[i]);
        if (box.high[0] < INFINITE) {
            const scalar *low_corner = box.low, *high_corner = box.high;
            *low = vec3d_min(
                *low, (Vec3d){(double)low_corner[0], (double)low_corner[1], (double)low_corner[2]});
            *high = vec3d_max(*high, (Vec3d){(double)high_corner[0], (double)high_corner[1],
                                             (double)high_corner[2]});
        }
    }
}

/** @return The nearest multiple. */
static double nearest_multiple(double x, double grain) {
    return floor(x / grain + 0.5) * grain;
}

Vec3d rebase_offset(const ShapeSet *list) {
    Vec3d low, high;
    rebase_bounds(list, &low, &high);
    double size = vec3d_max_abs(vec3d_subtract(high, low));
    Vec3d center = vec3d_scale(vec3d_add(low, high), 0.5);
    // False also where there is no shape with an end, and the middle is not a number.
    if (!(vec3d_max_abs(center) > REBASE_MIN_SIZES * size)) {
        return (Vec3d){0, 0, 0};
    }
    int exponent;
    frexp(size / REBASE_SIZE_GRAINS, &exponent);
    double grain = ldexp(0.5, exponent);
    return (Vec3d){nearest_multiple(center.x, grain), nearest_multiple(center.y, grain),
                   nearest_multiple(center.z, grain)};
}
