/**
 * @file
 * @brief What all shapes share: how they are made, and boxes around them.
 */
#include "trace/shapes/transformed.h"

#include <stdlib.h>

/** @return Bytes, so many that what follows is aligned again. */
static size_t align_to_shape(size_t size) {
    return (size + SHAPE_ALIGNMENT - 1) / SHAPE_ALIGNMENT * SHAPE_ALIGNMENT;
}

/** @return Bytes from an object of a class to its tail. */
static size_t shape_class_stride(const ShapeClass *class) {
    return align_to_shape(class->size);
}

void *shape_tail(Shape *shape) {
    return (char *)shape + shape_class_stride(shape->class);
}

size_t shape_size(const SceneShape *scene_shape) {
    const ShapeClass *class = shape_class(scene_shape->class_index);
    return shape_class_stride(class) +
           (class->tail_size ? align_to_shape(class->tail_size(scene_shape->parameters)) : 0) +
           (scene_shape->transform ? shape_class_stride(&transformed_class) : 0);
}

/**
 * Makes an object.
 * @param base  What all shapes have, its class too.
 * @param parameters  What its class makes it of.
 * @return The object.
 */
static Shape *shape_init(void *memory, Shape base, const void *parameters) {
    Shape *shape = memory;
    *shape = base;
    shape->class->init(shape, parameters);
    return shape;
}

Shape *shape_init_from_scene(void *memory, const SceneShape *scene_shape, int index,
                             MeshBvhCache *meshes, Error *error) {
    const ShapeClass *class = shape_class(scene_shape->class_index);
    Shape base = {.class = class, .index = index, .material = (int)scene_shape->material_index};
    void *inner_memory =
        (char *)memory + (scene_shape->transform ? shape_class_stride(&transformed_class) : 0);
    Shape *inner = shape_init(inner_memory, base, scene_shape->parameters);
    if (class->bind_mesh && !class->bind_mesh(inner, scene_shape, meshes, error)) {
        return NULL;
    }
    if (!scene_shape->transform) {
        return inner;
    }
    base.class = class->closest_hits ? &transformed_packet_class : &transformed_class;
    return shape_init(memory, base, &(TransformedParameters){scene_shape->transform, inner});
}

/** @return A box in double. */
static ShapeMeasure measure_from_aabb(Aabbs box) {
    return (ShapeMeasure){.low = {(double)box.low[0], (double)box.low[1], (double)box.low[2]},
                          .high = {(double)box.high[0], (double)box.high[1], (double)box.high[2]}};
}

ShapeMeasure shape_measure(const SceneShape *scene_shape) {
    const ShapeClass *class = shape_class(scene_shape->class_index);
    ShapeMeasure measure = {
        {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL, HUGE_VAL}, false};
    /** Bytes that all shapes without a tail fit in: many are measured, none for long. */
    enum { BUFFER_SIZE = 1024 };
    _Alignas(SHAPE_ALIGNMENT) char buffer[BUFFER_SIZE];
    bool shows_mesh = class->closest_hits != NULL;
    size_t size =
        shape_class_stride(class) +
        (class->tail_size ? align_to_shape(class->tail_size(scene_shape->parameters)) : 0);
    void *heap = size > BUFFER_SIZE ? aligned_alloc(SHAPE_ALIGNMENT, size) : NULL;
    void *memory = shows_mesh ? NULL : size > BUFFER_SIZE ? heap : buffer;
    if (memory) {
        Shape *shape = shape_init(memory, (Shape){.class = class}, scene_shape->parameters);
        measure = measure_from_aabb(class->bounds(shape));
    }
    free(heap);
    measure.is_flat = class->is_flat;
    return measure;
}
