/**
 * @file
 * @brief Distance fields for tests, built as from scene files.
 */
#ifndef TESTS_SDF_BUILDERS_H
#define TESTS_SDF_BUILDERS_H

#include "testing.h"

#include "dioptre/sdf_tape.h"

#include <stdlib.h>

/** @return Memory for a field. */
static inline Sdf *allocate_sdf(int steps) {
    return calloc(1, sdf_size(steps));
}

/**
 * @return A field of one primitive.
 * @param name  Its keyword after the dot.
 * @param values  Its parameters; NULL: the defaults.
 */
static inline Sdf *make_sdf(const char *name, const void *values) {
    Sdf *field = allocate_sdf(1);
    for (size_t i = 0; sdf_primitives[i]; i++) {
        const Keyword *keyword = &sdf_primitives[i]->keyword;
        if (strcmp(strchr(keyword->name, '.') + 1, name) == 0) {
            sdf_primitives[i]->create(field, values ? values : keyword->defaults);
        }
    }
    assert_int_equal(field->node_count, 1);
    return field;
}

/** @return A transformed field. */
static inline Sdf *transform_sdf(Sdf *field, Transform transform) {
    Error error = {0};
    Sdf *out = allocate_sdf(field->node_count + 1);
    assert_true(transform_keyword.finish(&transform, 0, &error));
    assert_true(sdf_transform(out, field, &transform, &error));
    free(field);
    return out;
}

/** @return A translated field. */
static inline Sdf *translate_sdf(Sdf *field, double x, double y, double z) {
    return transform_sdf(field, (Transform){.scale = {1, 1, 1}, .translate = {x, y, z}});
}

/**
 * @return A combination of two fields.
 * @param radius  Radius of a smooth union.
 */
static inline Sdf *join_sdfs(SdfCombination join, Sdf *a, Sdf *b, double radius) {
    Error error = {0};
    const Sdf *both[] = {a, b};
    Sdf *out = allocate_sdf(sdf_combined_capacity(both, 2));
    assert_true(sdf_combine(out, join, both, 2, radius, &error));
    free(a);
    free(b);
    return out;
}

/** Number of solids in the fields of tests. */
enum { MANY_SOLIDS = 40 };
/** Half the edge of a box, and radius of a ball. */
#define MANY_SOLIDS_HALF 0.25
/** Distance between neighbouring centres. */
#define MANY_SOLIDS_STEP 0.75

/** @return The centre of a solid: rows of seven, on floors of seven rows. */
static inline Vec3d many_solids_place(int i) {
    // Not one after the other: the first of equally near ones may come late.
    int n = i * 29 % 343;
    return (Vec3d){MANY_SOLIDS_STEP * (n % 7 - 3), MANY_SOLIDS_STEP * (n / 7 % 7 - 3),
                   MANY_SOLIDS_STEP * (n / 49 % 7 - 3)};
}

/** @return A union of boxes and balls in turn; from 343 on they stand where others do. @param first
 *  What stands before them in the union, released; NULL: nothing. */
static inline Sdf *many_solids_behind(Sdf *first, int count) {
    Error error = {0};
    const double edges[3] = {2 * MANY_SOLIDS_HALF, 2 * MANY_SOLIDS_HALF, 2 * MANY_SOLIDS_HALF};
    const double radius = MANY_SOLIDS_HALF;
    const Sdf **parts = calloc((size_t)count + 1, sizeof *parts);
    int total = 0;
    if (first) {
        parts[total++] = first;
    }
    for (int i = 0; i < count; i++) {
        Vec3d at = many_solids_place(i);
        Sdf *solid = i % 2 ? make_sdf("sphere", &radius) : make_sdf("box", edges);
        parts[total++] = translate_sdf(solid, at.x, at.y, at.z);
    }
    Sdf *out = allocate_sdf(sdf_combined_capacity(parts, total));
    assert_true(sdf_combine(out, SDF_COMBINE_UNION, parts, total, 0, &error));
    for (int i = 0; i < total; i++) {
        free((void *)parts[i]);
    }
    free(parts);
    return out;
}

/** @return The same, with nothing before them. */
static inline Sdf *many_solids(int count) {
    return many_solids_behind(NULL, count);
}

/** @return A field of one's own that is no number where x is negative: sqrt(x) - 1. */
static inline Sdf *rooted_field(void) {
    Error error = {0};
    SdfTape *tape = calloc(1, sizeof *tape);
    sdf_tape_begin(tape);
    int root = sdf_tape_add(tape, SDF_TAPE_SQUARE_ROOT, 0, 0);
    int result = sdf_tape_add(tape, SDF_TAPE_SUBTRACT, root, sdf_tape_add_constant(tape, 1));
    Sdf *out = allocate_sdf(tape->count + 1);
    assert_true(sdf_from_tape(out, tape, result, &error));
    assert_true(sdf_tape_find_bounds(out));
    free(tape);
    return out;
}

/** @return A repeated field. */
static inline Sdf *repeat_sdf(Sdf *field, SdfRepetition repeat) {
    Error error = {0};
    Sdf *out = allocate_sdf(field->node_count + 1);
    if (!sdf_repeat(out, field, &repeat, &error)) {
        fail_msg("%s", error.message);
    }
    free(field);
    return out;
}

/** @return A rounded field. */
static inline Sdf *round_sdf(Sdf *field, double radius) {
    Sdf *out = allocate_sdf(field->node_count + 1);
    sdf_round(out, field, radius);
    free(field);
    return out;
}

#endif
