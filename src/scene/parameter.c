/**
 * @file
 * @brief Parameter tables.
 */
#include "dioptre/parameter.h"
#include "dioptre/language.h"

bool parameter_check(const Parameter *parameter, double value, Error *error) {
    if (!isfinite(value)) {
        return error_set(error, STATUS_SCENE, "%s must be a finite number", parameter->name);
    }
    bool is_low =
        parameter->above_minimum ? value <= parameter->minimum : value < parameter->minimum;
    if (is_low || value > parameter->maximum) {
        return error_set(error, STATUS_SCENE,
                         parameter->above_minimum
                             ? N_("%s must be above %g and at most %g, not %g")
                             : N_("%s must be at least %g and at most %g, not %g"),
                         parameter->name, parameter->minimum, parameter->maximum, value);
    }
    return true;
}

void keyword_move(const Keyword *keyword, void *values, Vector3 way) {
    for (const Parameter *row = keyword->parameters; row->name; row++) {
        if (row->type == PARAMETER_POINT) {
            Vector3 *place = (Vector3 *)((char *)values + row->offset);
            *place = vector3_add(*place, way);
        }
    }
}

size_t parameter_count(const Parameter *table) {
    size_t count = 0;
    while (table[count].name) {
        count++;
    }
    return count;
}
