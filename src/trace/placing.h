/**
 * @file
 * @brief Where a field stands: points and rays are taken to it once, not at every step.
 */
#ifndef DIOPTRE_TRACE_PLACING_H
#define DIOPTRE_TRACE_PLACING_H

#include "dioptre/field.h"
#include "trace/vector.h"

/** How a field is scaled, turned and moved. */
typedef struct Placing {
    bool is_any;       /**< Whether it is at all. */
    WidePoint rows[3]; /**< From outside: the rotation the other way, divided by the scale. */
    WidePoint move;    /**< Where its zero stands. */
    wide_scalar scale; /**< How many times as large it is. */
} Placing;

/** @return That of a field as it is. */
static inline Placing placing_none(void) {
    return (Placing){false, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}, 1};
}

/** @return A vector as the field sees it. @param p The placing. @param v Any vector. */
static inline WidePoint placing_turn_one(const Placing *p, WidePoint v) {
    return (WidePoint){wide_point_dot(p->rows[0], v), wide_point_dot(p->rows[1], v),
                       wide_point_dot(p->rows[2], v)};
}

/** @return A vector of the field as it is outside: the inverse is the transpose times the square of
 *          the scale. @param p The placing. @param v Any vector. */
static inline WidePoint placing_turn_back_one(const Placing *p, WidePoint v) {
    WidePoint sum = {0, 0, 0}, zero = {0, 0, 0};
    const wide_scalar factors[3] = {v.x, v.y, v.z};
    for (int i = 0; i < 3; i++) {
        WidePoint part = wide_point_scale(p->rows[i], factors[i] * p->scale * p->scale);
        sum = wide_point_subtract(sum, wide_point_subtract(zero, part));
    }
    return sum;
}

/** Puts what is placed into what a #FIELD_PLACE step says. @param[in,out] placing The outer one;
 *  then both. @param numbers Those of the step, which stands inside. */
static inline void placing_append(Placing *placing, const double *numbers) {
    // N2 (N1 (p - m1) - m2) = N2 N1 (p - (m1 + N1^-1 m2))
    const WidePoint zero = {0, 0, 0};
    WidePoint rows[3], move = wide_point_of((Vector3){numbers[9], numbers[10], numbers[11]});
    WidePoint back = placing_turn_back_one(placing, move);
    for (int i = 0; i < 3; i++) {
        const wide_scalar row[3] = {(wide_scalar)numbers[3 * i], (wide_scalar)numbers[3 * i + 1],
                                    (wide_scalar)numbers[3 * i + 2]};
        rows[i] = zero;
        for (int k = 0; k < 3; k++) {
            WidePoint part = wide_point_scale(placing->rows[k], -row[k]);
            rows[i] = wide_point_subtract(rows[i], part);
        }
    }
    placing->is_any = true;
    placing->move = wide_point_subtract(placing->move, wide_point_subtract(zero, back));
    placing->scale *= (wide_scalar)numbers[12];
    for (int i = 0; i < 3; i++) {
        placing->rows[i] = rows[i];
    }
}

/** @return Directions as the field sees them, over its scale. @param p The placing.
 *  @param v Directions. */
INLINE WideVector placing_turn(const Placing *p, WideVector v) {
    return (WideVector){wide_dot(wide_vector_of(p->rows[0]), v),
                        wide_dot(wide_vector_of(p->rows[1]), v),
                        wide_dot(wide_vector_of(p->rows[2]), v)};
}

/** @return Points as the field sees them. @param p The placing. @param v Points. */
INLINE WideVector placing_take(const Placing *p, WideVector v) {
    return placing_turn(p, wide_subtract(v, wide_vector_of(p->move)));
}

/** @return Directions of the field, as long, outside. @param p The placing. @param v Directions. */
INLINE WideVector placing_turn_back(const Placing *p, WideVector v) {
    const wide scale = wide_of(p->scale);
    WideVector sum = wide_scale(wide_vector_of(p->rows[0]), v.x * scale);
    sum = wide_add_scaled(sum, wide_vector_of(p->rows[1]), v.y * scale);
    return wide_add_scaled(sum, wide_vector_of(p->rows[2]), v.z * scale);
}

/** @return Points of the field, outside. @param p The placing. @param v Points. */
INLINE WideVector placing_take_back(const Placing *p, WideVector v) {
    WideVector turned = placing_turn_back(p, v);
    return wide_add_scaled(wide_vector_of(p->move), turned, wide_of(p->scale));
}

#endif
