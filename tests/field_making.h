/**
 * @file
 * @brief Fields for tests, made as scene files make them.
 */
#ifndef DIOPTRE_FIELD_MAKING_H
#define DIOPTRE_FIELD_MAKING_H

#include "testing.h"

#include <stdlib.h>

/** @return Room for a field. @param steps Its steps. */
static inline Field *new_field(int steps) {
    return calloc(1, field_size(steps));
}

/** @return A field of one step. @param name Its keyword after the dot. @param values Its numbers;
 *  NULL: the defaults. */
static inline Field *single(const char *name, const void *values) {
    Field *field = new_field(1);
    for (size_t i = 0; field_kinds[i]; i++) {
        const Keyword *keyword = &field_kinds[i]->keyword;
        if (strcmp(strchr(keyword->name, '.') + 1, name) == 0) {
            field_kinds[i]->make(field, values ? values : keyword->defaults);
        }
    }
    assert_int_equal(field->count, 1);
    return field;
}

/** @return A field, moved, turned and scaled. @param field The field; given back.
 *  @param transform How. */
static inline Field *placed(Field *field, Transform transform) {
    Error error = {0};
    Field *out = new_field(field->count + 1);
    assert_true(transform_keyword.finish(&transform, 0, &error));
    assert_true(field_place(out, field, &transform, &error));
    free(field);
    return out;
}

/** @return A field, moved. @param field The field; given back. @param x To the right. @param y Up.
 *  @param z Towards the viewer. */
static inline Field *moved(Field *field, double x, double y, double z) {
    return placed(field, (Transform){.scale = {1, 1, 1}, .translate = {x, y, z}});
}

/** @return Two fields in one. @param join How. @param a A field; given back. @param b Another;
 *  given back. @param radius Of a smooth union. */
static inline Field *joined(FieldJoin join, Field *a, Field *b, double radius) {
    Error error = {0};
    const Field *both[] = {a, b};
    Field *out = new_field(field_room(both, 2));
    assert_true(field_join(out, join, both, 2, radius, &error));
    free(a);
    free(b);
    return out;
}

/** @return A field, repeated. @param field The field; given back. @param repeat How. */
static inline Field *repeated(Field *field, FieldRepeat repeat) {
    Error error = {0};
    Field *out = new_field(field->count + 1);
    if (!field_repeat(out, field, &repeat, &error)) {
        fail_msg("%s", error.message);
    }
    free(field);
    return out;
}

/** @return A field, rounded. @param field The field; given back. @param radius By how much. */
static inline Field *round_off(Field *field, double radius) {
    Field *out = new_field(field->count + 1);
    field_round(out, field, radius);
    free(field);
    return out;
}

#endif
