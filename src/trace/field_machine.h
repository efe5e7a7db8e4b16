/**
 * @file
 * @brief What the steps of distance fields share.
 */
#ifndef DIOPTRE_TRACE_FIELD_MACHINE_H
#define DIOPTRE_TRACE_FIELD_MACHINE_H

#include "trace/angle.h"
#include "trace/field.h"

/** What the steps of a tape work on. */
struct FieldMachine {
    Vector point;       /**< Where. */
    FieldSample sample; /**< What the steps so far say of it. */
    mask active;        /**< The lanes that count. */
    bool derives;       /**< Whether gradients are wanted. */
};

/** @return 1 or -1, as the sign of numbers. @param x Numbers. */
INLINE real sign_of(real x) {
    return real_select(x < 0, real_of(-1), real_of(1));
}

/** @return The absolute values. @param v Vectors. */
INLINE Vector vector_abs(Vector v) {
    return (Vector){real_abs(v.x), real_abs(v.y), real_abs(v.z)};
}

/** @return a times b, component by component. @param a Vectors. @param b Others. */
INLINE Vector vector_multiply(Vector a, Vector b) {
    return (Vector){a.x * b.x, a.y * b.y, a.z * b.z};
}

/** @return The signs of the components. @param v Vectors. */
INLINE Vector vector_signs(Vector v) {
    return (Vector){sign_of(v.x), sign_of(v.y), sign_of(v.z)};
}

/** @return x / y; 0 where y is 0. @param x Numbers. @param y Others. */
INLINE real quotient(real x, real y) {
    return real_select(y > 0, x / y, real_of(0));
}

/** @return Half the edges of a box. @param numbers Three of a step. */
INLINE Vector vector_from(const scalar *numbers) {
    return (Vector){real_of(numbers[0]), real_of(numbers[1]), real_of(numbers[2])};
}

/** @return The nearer of two samples. @param a A sample. @param b Another. @param derives Whether
 *  gradients are wanted. */
INLINE FieldSample sample_nearer(FieldSample a, FieldSample b, bool derives) {
    FieldSample nearer = {.distance = real_min(b.distance, a.distance)};
    if (derives) {
        nearer.gradient = vector_select(b.distance < a.distance, b.gradient, a.gradient);
    }
    return nearer;
}

/** Measures a ball. See #FieldCode.run. @param m See there. @param code See there. */
void field_sphere_run(FieldMachine *m, const FieldCode *code);

/** Measures a box. See #FieldCode.run. @param m See there. @param code See there. */
void field_box_run(FieldMachine *m, const FieldCode *code);

/** Measures the bars of a frame. See #FieldCode.run. @param m See there. @param code See there. */
void field_box_frame_run(FieldMachine *m, const FieldCode *code);

/** Measures a ring. See #FieldCode.run. @param m See there. @param code See there. */
void field_torus_run(FieldMachine *m, const FieldCode *code);

/** Measures a sponge. See #FieldCode.run. @param m See there. @param code See there. */
void field_menger_run(FieldMachine *m, const FieldCode *code);

/** Measures a Mandelbulb. See #FieldCode.run. @param m See there. @param code See there. */
void field_mandelbulb_run(FieldMachine *m, const FieldCode *code);

#endif
