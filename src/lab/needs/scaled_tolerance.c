/**
 * @file
 * @brief Scales the tolerances of distance fields.
 */
#include "lab/needs/scaled_tolerance.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/** @return The description of a shape's kind. */
static const SceneShapeClass *class_of(const SceneShape *shape) {
    return scene_shape_classes[shape->class_index];
}

/** @return Bytes of a shape's parameters, rounded up to the alignment of what follows; 0 if it has
 *          no tolerance. */
static size_t scaled_size(const SceneShape *shape) {
    const size_t alignment = _Alignof(max_align_t);
    const SceneShapeClass *class = class_of(shape);
    size_t size = class->scale_tolerance ? class->keyword.size : 0;
    return (size + alignment - 1) / alignment * alignment;
}

/** @return Bytes of the parameters of all shapes with a tolerance. */
static size_t scaled_parameters_size(const Scene *scene) {
    size_t size = 0;
    for (size_t i = 0; i < scene->shape_count; i++) {
        size += scaled_size(&scene->shapes[i]);
    }
    return size;
}

bool scene_has_tolerances(const Scene *scene) {
    return scaled_parameters_size(scene) > 0;
}

bool scaled_tolerance_scene_init(ScaledToleranceScene *scaled, const Scene *scene, double factor,
                                 Error *error) {
    *scaled = (ScaledToleranceScene){.scene = *scene,
                                     .shapes = calloc(scene->shape_count + 1, sizeof(SceneShape)),
                                     .parameters = malloc(scaled_parameters_size(scene) + 1)};
    if (!scaled->shapes || !scaled->parameters) {
        scaled_tolerance_scene_deinit(scaled);
        return error_set(error, STATUS_FAILED, "no memory for %zu shapes", scene->shape_count);
    }
    char *next = scaled->parameters;
    for (size_t i = 0; i < scene->shape_count; i++) {
        SceneShape *shape = &scaled->shapes[i];
        *shape = scene->shapes[i];
        const SceneShapeClass *class = class_of(shape);
        if (class->scale_tolerance) {
            memcpy(next, shape->parameters, class->keyword.size);
            class->scale_tolerance(next, factor);
            shape->parameters = next;
            next += scaled_size(shape);
        }
    }
    scaled->scene.shapes = scaled->shapes;
    return true;
}

void scaled_tolerance_scene_deinit(ScaledToleranceScene *scaled) {
    free(scaled->shapes);
    free(scaled->parameters);
    *scaled = (ScaledToleranceScene){0};
}
