/**
 * @file
 * @brief What all shapes share: how they are made, and boxes around them.
 */
#include "trace/shapes/transformed.h"

/** @return Bytes, so many that what follows is aligned again. @param size Bytes. */
static size_t aligned(size_t size) {
    return (size + SHAPE_ALIGNMENT - 1) / SHAPE_ALIGNMENT * SHAPE_ALIGNMENT;
}

/** @return Bytes from an object of a class to its tail. @param class The class. */
static size_t class_stride(const ShapeClass *class) {
    return aligned(class->size);
}

void *shape_tail(Shape *shape) {
    return (char *)shape + class_stride(shape->class);
}

size_t shape_size(const SceneShape *said) {
    const ShapeClass *class = shape_class(said->kind);
    return class_stride(class) + (class->tail ? aligned(class->tail(said->parameters)) : 0) +
           (said->transform ? class_stride(&transformed_class) : 0);
}

/** Makes an object. @param memory Bytes for it. @param base What all shapes have, its class too.
 *  @param parameters What its class makes it of. @return The object. */
static Shape *object_make(void *memory, Shape base, const void *parameters) {
    Shape *shape = memory;
    *shape = base;
    shape->class->init(shape, parameters);
    return shape;
}

Shape *shape_make(void *memory, const SceneShape *said, int place, Models *models, Error *error) {
    const ShapeClass *class = shape_class(said->kind);
    Shape base = {.class = class, .place = place, .material = (int)said->material};
    void *behind = (char *)memory + (said->transform ? class_stride(&transformed_class) : 0);
    Shape *inner = object_make(behind, base, said->parameters);
    if (class->bind && !class->bind(inner, models, error)) {
        return NULL;
    }
    if (!said->transform) {
        return inner;
    }
    base.class = class->nearest ? &transformed_packets_class : &transformed_class;
    return object_make(memory, base, &(TransformedParameters){said->transform, inner});
}

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
