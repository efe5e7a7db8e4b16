/**
 * @file
 * @brief Distances of solids, by the formulas of Inigo Quilez (*Distance functions*); the
 * derivatives follow from them.
 */
#include "trace/field_machine.h"

void field_sphere_run(FieldMachine *m, const FieldCode *code) {
    real length = real_sqrt(vector_dot(m->point, m->point));
    m->sample.distance = length - code->numbers[0];
    if (m->derives) {
        m->sample.gradient = vector_scale(m->point, quotient(real_of(1), length));
    }
}

/** @return Which way the largest component lies: 1 along the first axis that has it.
 *  @param v Vectors. @param largest Their largest component. */
INLINE Vector axis_of_largest(Vector v, real largest) {
    const real zero = real_of(0), one = real_of(1);
    mask is_x = v.x >= largest, is_y = mask_not(is_x) & (v.y >= largest);
    return (Vector){real_select(is_x, one, zero), real_select(is_y, one, zero),
                    real_select(is_x | is_y, zero, one)};
}

/**
 * @return How far points are from the corner at zero of a box that fills all that is negative.
 * @param v        The points.
 * @param derives  Whether the gradient is wanted.
 */
INLINE FieldSample corner_sample(Vector v, bool derives) {
    const real zero = real_of(0);
    Vector out = {real_max(v.x, zero), real_max(v.y, zero), real_max(v.z, zero)};
    real length = real_sqrt(vector_dot(out, out));
    real largest = real_max(v.x, real_max(v.y, v.z));
    FieldSample sample = {.distance = length + real_min(largest, zero)};
    if (derives) {
        sample.gradient = vector_select(length > 0, vector_scale(out, quotient(real_of(1), length)),
                                        axis_of_largest(v, largest));
    }
    return sample;
}

/** @return The sample of a box around zero. @param p Points. @param half Half its edges.
 *  @param derives Whether the gradient is wanted. */
INLINE FieldSample box_sample(Vector p, Vector half, bool derives) {
    FieldSample sample = corner_sample(vector_subtract(vector_abs(p), half), derives);
    if (derives) {
        sample.gradient = vector_multiply(sample.gradient, vector_signs(p));
    }
    return sample;
}

void field_box_run(FieldMachine *m, const FieldCode *code) {
    m->sample = box_sample(m->point, vector_from(code->numbers), m->derives);
}

void field_box_frame_run(FieldMachine *m, const FieldCode *code) {
    real e = real_of(code->numbers[3]);
    Vector thick = {e, e, e};
    Vector p = vector_subtract(vector_abs(m->point), vector_from(code->numbers));
    Vector middle = vector_add(p, thick), q = vector_subtract(vector_abs(middle), thick);
    Vector turn = vector_signs(middle);
    FieldSample bars[3] = {corner_sample((Vector){p.x, q.y, q.z}, m->derives),
                           corner_sample((Vector){q.x, p.y, q.z}, m->derives),
                           corner_sample((Vector){q.x, q.y, p.z}, m->derives)};
    if (m->derives) {
        // Across a bar the distance was folded at its middle.
        const real one = real_of(1);
        Vector turns[3] = {{one, turn.y, turn.z}, {turn.x, one, turn.z}, {turn.x, turn.y, one}};
        for (int i = 0; i < 3; i++) {
            bars[i].gradient = vector_multiply(bars[i].gradient, turns[i]);
        }
    }
    m->sample = sample_nearer(sample_nearer(bars[0], bars[1], m->derives), bars[2], m->derives);
    if (m->derives) {
        m->sample.gradient = vector_multiply(m->sample.gradient, vector_signs(m->point));
    }
}

void field_torus_run(FieldMachine *m, const FieldCode *code) {
    Vector p = m->point;
    real axis = real_sqrt(p.x * p.x + p.z * p.z), across = axis - code->numbers[0];
    real length = real_sqrt(across * across + p.y * p.y);
    m->sample.distance = length - code->numbers[1];
    if (m->derives) {
        real outwards = quotient(quotient(across, length), axis);
        m->sample.gradient = (Vector){p.x * outwards, quotient(p.y, length), p.z * outwards};
    }
}

/**
 * @return How deep points are within the holes of one size along one axis: between the two sides of
 *         a hole positive.
 * @param x            Coordinates, in half edges of the sponge.
 * @param per_cell     How many cells are as wide as the sponge.
 * @param[out] slope   1 or -1: how that changes with the coordinate.
 */
INLINE real hole_depth(real x, scalar per_cell, real *slope) {
    real cells = x * per_cell, cell = 2 * real_floor((scalar)0.5f * cells + (scalar)0.5f);
    real in_cell = cells - cell, folded = 3 * real_abs(in_cell) - 2;
    *slope = sign_of(folded) * sign_of(in_cell);
    return (real_abs(folded) - 1) / real_of(3 * per_cell);
}

/** @return What the holes of one size cut out: square, along all three axes; positive inside them.
 *  @param p Points, in half edges of the sponge. @param per_cell Cells as wide as the sponge. */
INLINE FieldSample holes_sample(Vector p, scalar per_cell) {
    Vector slope, depth = {hole_depth(p.x, per_cell, &slope.x), hole_depth(p.y, per_cell, &slope.y),
                           hole_depth(p.z, per_cell, &slope.z)};
    // A point is in a hole along some axis if it is between the sides along the two others: the
    // middle one of three numbers decides.
    real low = real_min(depth.x, depth.y), high = real_max(depth.x, depth.y);
    real middle = real_max(low, real_min(high, depth.z));
    Vector apart = {-real_abs(depth.x - middle), -real_abs(depth.y - middle),
                    -real_abs(depth.z - middle)};
    return (FieldSample){middle, vector_multiply(axis_of_largest(apart, real_of(0)), slope)};
}

void field_menger_run(FieldMachine *m, const FieldCode *code) {
    const real one = real_of(1), half = real_of(code->numbers[0]);
    Vector p = vector_scale(m->point, one / half);
    FieldSample sponge = box_sample(p, (Vector){one, one, one}, m->derives);
    scalar per_cell = 1;
    for (int i = 0; i < (int)code->numbers[1]; i++) {
        FieldSample holes = holes_sample(p, per_cell);
        mask is_cut = holes.distance > sponge.distance;
        sponge.distance = real_select(is_cut, holes.distance, sponge.distance);
        if (m->derives) {
            sponge.gradient = vector_select(is_cut, holes.gradient, sponge.gradient);
        }
        per_cell *= 3;
    }
    m->sample = sponge;
    m->sample.distance = sponge.distance * half;
}
