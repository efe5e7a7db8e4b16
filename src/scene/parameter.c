/**
 * @file
 * @brief Parameter tables.
 */
#include "dioptre/parameter.h"
#include "base/language.h"

bool parameter_check_range(const Parameter *parameter, double value, Error *error) {
    if (!isfinite(value)) {
        return error_set(error, STATUS_SCENE, "%s must be a finite number", parameter->name);
    }
    bool is_below =
        parameter->excludes_minimum ? value <= parameter->minimum : value < parameter->minimum;
    if (is_below || value > parameter->maximum) {
        return error_set(error, STATUS_SCENE,
                         parameter->excludes_minimum
                             ? N_("%s must be above %g and at most %g, not %g")
                             : N_("%s must be at least %g and at most %g, not %g"),
                         parameter->name, parameter->minimum, parameter->maximum, value);
    }
    return true;
}

bool keyword_has_field(const Keyword *keyword) {
    return keyword->parameters->type == PARAMETER_SDF;
}

void keyword_translate(const Keyword *keyword, void *values, Vec3d offset) {
    for (const Parameter *row = keyword->parameters; row->name; row++) {
        if (row->type == PARAMETER_POINT) {
            Vec3d *point = (Vec3d *)((char *)values + row->offset);
            *point = vec3d_add(*point, offset);
        }
    }
}
