/**
 * @file
 * @brief Changing the tolerances of a scene.
 */
#include "lab/needs/scaled_tolerance_scene.h"

#include <stdlib.h>
#include <string.h>

/** @return The row of a keyword that says how near to a surface is on it; NULL: it is not marched.
 */
static const Parameter *tolerance_parameter(const Keyword *keyword) {
    for (const Parameter *row = keyword->parameters; row->name; row++) {
        if (row->type == PARAMETER_NUMBER && strcmp(row->name, "tolerance") == 0) {
            return row;
        }
    }
    return NULL;
}

/** @return Bytes of a shape's parameters, so many that what follows is aligned again. */
static size_t parameters_size(const Keyword *keyword) {
    const size_t alignment = _Alignof(max_align_t);
    return (keyword->size + alignment - 1) / alignment * alignment;
}

/** @return Bytes of all parameters that would differ. */
static size_t scaled_parameters_size(const Scene *scene, const Keyword *const *keywords) {
    size_t size = 0;
    for (size_t i = 0; i < scene->shape_count; i++) {
        const Keyword *keyword = keywords[scene->shapes[i].class_index];
        size += tolerance_parameter(keyword) ? parameters_size(keyword) : 0;
    }
    return size;
}

bool scene_has_tolerances(const Scene *scene, const Keyword *const *keywords) {
    return scaled_parameters_size(scene, keywords) > 0;
}

bool scaled_tolerance_scene_init(ScaledToleranceScene *scaled, const Scene *scene,
                                 const Keyword *const *keywords, double factor, Error *error) {
    *scaled =
        (ScaledToleranceScene){.scene = *scene,
                               .shapes = calloc(scene->shape_count + 1, sizeof(SceneShape)),
                               .parameters = malloc(scaled_parameters_size(scene, keywords) + 1)};
    if (!scaled->shapes || !scaled->parameters) {
        scaled_tolerance_scene_deinit(scaled);
        return error_set(error, STATUS_FAILED, "no memory for %zu shapes", scene->shape_count);
    }
    char *next = scaled->parameters;
    for (size_t i = 0; i < scene->shape_count; i++) {
        SceneShape *shape = &scaled->shapes[i];
        *shape = scene->shapes[i];
        const Keyword *keyword = keywords[shape->class_index];
        const Parameter *row = tolerance_parameter(keyword);
        if (row) {
            shape->parameters = memcpy(next, shape->parameters, keyword->size);
            double *tolerance = (double *)(void *)(next + row->offset);
            *tolerance = fmin(fmax(*tolerance * factor, LENGTH_MINIMUM), LENGTH_MAXIMUM);
            next += parameters_size(keyword);
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
