/**
 * @file
 * @brief Parameter tables.
 */
#include "dioptre/parameter.h"
#include "base/exact_digits.h"
#include "base/language.h"

#include <string.h>

/** Fewest digits of a number in an error: as for `%g`. */
enum { ERROR_DIGITS = 6 };

bool parameter_check_range(const Parameter *parameter, double value, Error *error) {
    if (!isfinite(value)) {
        return error_set(error, STATUS_SCENE, "%s must be a finite number", parameter->name);
    }
    bool is_below =
        parameter->excludes_minimum ? value <= parameter->minimum : value < parameter->minimum;
    if (is_below || value > parameter->maximum) {
        return error_set(error, STATUS_SCENE,
                         parameter->excludes_minimum
                             ? N_("%s must be above %g and at most %g, not %.*g")
                             : N_("%s must be at least %g and at most %g, not %.*g"),
                         parameter->name, parameter->minimum, parameter->maximum,
                         exact_digits(value, ERROR_DIGITS), value);
    }
    return true;
}

bool keyword_has_field(const Keyword *keyword) {
    return keyword->parameters->type == PARAMETER_SDF;
}

int parameter_number_count(ParameterType type) {
    static const int counts[] = {
        [PARAMETER_NUMBER] = 1,    [PARAMETER_INTEGER] = 1, [PARAMETER_BOOLEAN] = 1,
        [PARAMETER_CHOICE] = 1,    [PARAMETER_POINT] = 3,   [PARAMETER_VECTOR] = 3,
        [PARAMETER_DIRECTION] = 3, [PARAMETER_SCALE] = 3,   [PARAMETER_UV] = 2,
        [PARAMETER_COLOR] = 3,     [PARAMETER_TEXTURE] = 0};
    return counts[type];
}

/** @return Whether the C type of a value is `int`. */
static bool is_int(ParameterType type) {
    return type == PARAMETER_INTEGER || type == PARAMETER_CHOICE;
}

void parameter_get_numbers(const Parameter *row, const void *values, double *numbers) {
    const char *value = (const char *)values + row->offset;
    if (is_int(row->type)) {
        numbers[0] = *(const int *)(const void *)value;
    } else if (row->type == PARAMETER_BOOLEAN) {
        numbers[0] = *(const bool *)value;
    } else {
        memcpy(numbers, value, (size_t)parameter_number_count(row->type) * sizeof *numbers);
    }
}

void parameter_set_numbers(const Parameter *row, void *values, const double *numbers) {
    char *value = (char *)values + row->offset;
    if (is_int(row->type)) {
        *(int *)(void *)value = (int)numbers[0];
    } else if (row->type == PARAMETER_BOOLEAN) {
        *(bool *)value = numbers[0] != 0;
    } else {
        memcpy(value, numbers, (size_t)parameter_number_count(row->type) * sizeof *numbers);
    }
}

/** @return Number of words of a choice. */
static int choice_count(const Parameter *row) {
    int count = 0;
    while (row->choices[count]) {
        count++;
    }
    return count;
}

/** Checks a whole number. @return Whether it is one, from 0 to below a count where there is one. */
static bool check_whole(const Parameter *row, double number, int count, Error *error) {
    return (number == floor(number) && (count == 0 || (number >= 0 && number < count))) ||
           error_set(error, STATUS_SCENE, "%s must be a whole number, not %.14g", row->name,
                     number);
}

bool parameter_check_numbers(const Parameter *row, const double *numbers, Error *error) {
    int count = parameter_number_count(row->type);
    double sum = 0;
    if (count == 0) {
        return error_set(error, STATUS_SCENE, "%s is no number", row->name);
    }
    if (row->type == PARAMETER_BOOLEAN || row->type == PARAMETER_CHOICE) {
        int limit = row->type == PARAMETER_BOOLEAN ? 2 : choice_count(row);
        return check_whole(row, numbers[0], limit, error);
    }
    for (int i = 0; i < count; i++) {
        if (!parameter_check_range(row, numbers[i], error)) {
            return false;
        }
        sum += fabs(numbers[i]);
    }
    if (row->type == PARAMETER_DIRECTION && !(sum > 0)) {
        return error_set(error, STATUS_SCENE, "%s must not be zero: it says a direction",
                         row->name);
    }
    return row->type != PARAMETER_INTEGER || check_whole(row, numbers[0], 0, error);
}

void keyword_translate(const Keyword *keyword, void *values, Vec3d offset) {
    for (const Parameter *row = keyword->parameters; row->name; row++) {
        if (row->type == PARAMETER_POINT) {
            Vec3d *point = (Vec3d *)((char *)values + row->offset);
            *point = vec3d_add(*point, offset);
        }
    }
}
