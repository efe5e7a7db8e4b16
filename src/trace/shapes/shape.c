/**
 * @file
 * @brief The list of all classes of shapes, and the objects of the shapes of a scene.
 */
#include "trace/mesh/mesh_bvh.h"
#include "trace/shapes/report_sphere.h"
#include "trace/shapes/transformed.h"

/** An entry of #shape_classes. */
#define LIST_SHAPE_CLASS(name) &name##_class,

/** All classes, by #SceneShape.class_index. */
static const ShapeClass *const shape_classes[] = {SHAPES(LIST_SHAPE_CLASS)};

/** @return Bytes from an object of a class to its tail. */
static size_t shape_class_stride(const ShapeClass *class) {
    return shape_aligned_size(class->size);
}

/** @return Bytes of the tail of an object. @param parameters Its parameter struct. */
static size_t shape_tail_size(const ShapeClass *class, const void *parameters) {
    bool has_tail = class->extension && class->extension->tail_size;
    return has_tail ? shape_aligned_size(class->extension->tail_size(parameters)) : 0;
}

void *shape_tail(Shape *shape) {
    return (char *)shape + shape_class_stride(shape->class);
}

/** @return The class of a shape. @param methods A set of #ReportMethod. */
static const ShapeClass *class_of(const SceneShape *scene_shape, unsigned methods) {
    return report_shape_class(shape_classes[scene_shape->class_index], methods);
}

size_t shape_size(const SceneShape *scene_shape, unsigned methods) {
    const ShapeClass *class = class_of(scene_shape, methods);
    return shape_class_stride(class) + shape_tail_size(class, scene_shape->parameters) +
           (scene_shape->transform ? shape_class_stride(&transformed_class) : 0);
}

/** Creates an object. @param base Its base, with the class. @return The object. */
static Shape *shape_init(void *memory, Shape base, const void *parameters) {
    Shape *shape = memory;
    *shape = base;
    shape->class->init(shape, parameters);
    return shape;
}

Shape *shape_init_from_scene(void *memory, const SceneShape *scene_shape, int index,
                             MeshBvhCache *meshes, Error *error) {
    const ShapeClass *class = class_of(scene_shape, meshes->methods);
    Shape base = {.class = class, .index = index, .material = (int)scene_shape->material_index};
    void *inner_memory =
        (char *)memory + (scene_shape->transform ? shape_class_stride(&transformed_class) : 0);
    Shape *inner = shape_init(inner_memory, base, scene_shape->parameters);
    const ShapeExtension *extension = class->extension;
    if (extension && extension->bind && !extension->bind(inner, scene_shape, meshes, error)) {
        return NULL;
    }
    if (!scene_shape->transform) {
        return inner;
    }
    base.class = shape_has_bvh(inner)     ? &transformed_bvh_class
                 : shape_has_steps(inner) ? &transformed_field_class
                                          : &transformed_class;
    return shape_init(memory, base, &(TransformedParameters){scene_shape->transform, inner});
}
