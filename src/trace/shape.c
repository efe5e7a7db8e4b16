/**
 * @file
 * @brief What all shapes share: how they are made, and boxes around them.
 */
#include "trace/shapes/transformed.h"

#include <stdlib.h>

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
    if (class->bind && !class->bind(inner, said, models, error)) {
        return NULL;
    }
    if (!said->transform) {
        return inner;
    }
    base.class = class->nearest ? &transformed_packets_class : &transformed_class;
    return object_make(memory, base, &(TransformedParameters){said->transform, inner});
}

/** @return A box in double. @param box The box. */
static ShapeMeasure measure_of(Bounds box) {
    return (ShapeMeasure){.low = {(double)box.low[0], (double)box.low[1], (double)box.low[2]},
                          .high = {(double)box.high[0], (double)box.high[1], (double)box.high[2]}};
}

ShapeMeasure shape_measure(const SceneShape *said) {
    const ShapeClass *class = shape_class(said->kind);
    ShapeMeasure measure = {
        {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL, HUGE_VAL}, false};
    /** Bytes that all shapes without a tail fit in: many are measured, none for long. */
    enum { ROOM = 1024 };
    _Alignas(SHAPE_ALIGNMENT) char room[ROOM];
    bool shows_model = class->nearest != NULL;
    size_t size = class_stride(class) + (class->tail ? aligned(class->tail(said->parameters)) : 0);
    void *far = size > ROOM ? aligned_alloc(SHAPE_ALIGNMENT, size) : NULL;
    void *memory = shows_model ? NULL : size > ROOM ? far : room;
    if (memory) {
        Shape *shape = object_make(memory, (Shape){.class = class}, said->parameters);
        measure = measure_of(class->bounds(shape));
    }
    free(far);
    measure.is_flat = class->is_flat;
    return measure;
}
