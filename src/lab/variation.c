/**
 * @file
 * @brief Changing the tolerances of a scene.
 */
#include "lab/variation.h"

#include <stdlib.h>
#include <string.h>

/** @return The row of a keyword that says how near to a surface is on it; NULL: it is not marched.
 *  @param keyword The keyword. */
static const Parameter *tolerance_row(const Keyword *keyword) {
    for (const Parameter *row = keyword->parameters; row->name; row++) {
        if (row->type == PARAMETER_NUMBER && strcmp(row->name, "tolerance") == 0) {
            return row;
        }
    }
    return NULL;
}

/** @return Bytes of a shape's parameters, so many that what follows is aligned again.
 *  @param keyword The shape's. */
static size_t parameters_size(const Keyword *keyword) {
    const size_t alignment = _Alignof(max_align_t);
    return (keyword->size + alignment - 1) / alignment * alignment;
}

/** @return Bytes of all parameters that would differ. @param scene The scene. @param keywords The
 *  shapes' keywords. */
static size_t varied_size(const Scene *scene, const Keyword *const *keywords) {
    size_t size = 0;
    for (size_t i = 0; i < scene->shape_count; i++) {
        const Keyword *keyword = keywords[scene->shapes[i].kind];
        size += tolerance_row(keyword) ? parameters_size(keyword) : 0;
    }
    return size;
}

bool variation_is_possible(const Scene *scene, const Keyword *const *keywords) {
    return varied_size(scene, keywords) > 0;
}

bool variation_make(Variation *variation, const Scene *scene, const Keyword *const *keywords,
                    double factor, Error *error) {
    *variation = (Variation){.scene = *scene,
                             .shapes = calloc(scene->shape_count + 1, sizeof(SceneShape)),
                             .parameters = malloc(varied_size(scene, keywords) + 1)};
    if (!variation->shapes || !variation->parameters) {
        variation_release(variation);
        return error_set(error, STATUS_FAILED, "no memory for %zu shapes", scene->shape_count);
    }
    char *next = variation->parameters;
    for (size_t i = 0; i < scene->shape_count; i++) {
        SceneShape *shape = &variation->shapes[i];
        *shape = scene->shapes[i];
        const Keyword *keyword = keywords[shape->kind];
        const Parameter *row = tolerance_row(keyword);
        if (row) {
            shape->parameters = memcpy(next, shape->parameters, keyword->size);
            double *tolerance = (double *)(void *)(next + row->offset);
            *tolerance = fmin(fmax(*tolerance * factor, LENGTH_MINIMUM), LENGTH_MAXIMUM);
            next += parameters_size(keyword);
        }
    }
    variation->scene.shapes = variation->shapes;
    return true;
}

void variation_release(Variation *variation) {
    free(variation->shapes);
    free(variation->parameters);
    *variation = (Variation){0};
}
