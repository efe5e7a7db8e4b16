/**
 * @file
 * @brief Where in the scene the coordinates of a tracer begin.
 */
#include "trace/origin.h"

/** How many times as far away as large shapes are when the origin is moved to them: what their
 *  coordinates have in common are two bits then. */
#define FAR_SIZES 4

/** The new origin is a multiple of the power of two that is so many times, at least, in the shapes'
 *  size: it has few digits, so that differences to it are exact in double. */
#define SIZE_GRAINS 8

void origin_bounds(const ShapeList *list, Vector3 *low, Vector3 *high) {
    *low = (Vector3){HUGE_VAL, HUGE_VAL, HUGE_VAL};
    *high = vector3_scale(*low, -1);
    for (size_t i = 0; i < list->count; i++) {
        Bounds box = list->shapes[i]->class->bounds(list->shapes[i]);
        if (box.high[0] < INFINITE) {
            const scalar *l = box.low, *h = box.high;
            *low = vector3_lowest(*low, (Vector3){(double)l[0], (double)l[1], (double)l[2]});
            *high = vector3_highest(*high, (Vector3){(double)h[0], (double)h[1], (double)h[2]});
        }
    }
}

/** @return The nearest multiple. @param x A number. @param grain Of what. */
static double multiple_near(double x, double grain) {
    return floor(x / grain + 0.5) * grain;
}

Vector3 origin_offset(const ShapeList *list) {
    Vector3 low, high;
    origin_bounds(list, &low, &high);
    double size = vector3_largest(vector3_subtract(high, low));
    Vector3 middle = vector3_scale(vector3_add(low, high), 0.5);
    // False also where there is no shape with an end, and the middle is not a number.
    if (!(vector3_largest(middle) > FAR_SIZES * size)) {
        return (Vector3){0, 0, 0};
    }
    int exponent;
    frexp(size / SIZE_GRAINS, &exponent);
    double grain = ldexp(0.5, exponent);
    return (Vector3){multiple_near(middle.x, grain), multiple_near(middle.y, grain),
                     multiple_near(middle.z, grain)};
}
