/**
 * @file
 * @brief What the steps of distance fields share.
 */
#ifndef DIOPTRE_TRACE_SDF_SDF_VM_H
#define DIOPTRE_TRACE_SDF_SDF_VM_H

#include "trace/math/angle.h"
#include "trace/sdf/sdf_program.h"

/** What the steps of a tape work on. */
struct SdfVm {
    Vec3 point;          /**< Where. */
    SdfSample sample;    /**< What the steps so far say of it. */
    mask active;         /**< The lanes that count. */
    bool wants_gradient; /**< Whether gradients are wanted. */
};

/** @return 1 or -1, as the sign of numbers. */
INLINE real real_sign(real x) {
    return real_select(x < 0, real_of(-1), real_of(1));
}

/** @return The absolute values. */
INLINE Vec3 vec3_abs(Vec3 v) {
    return (Vec3){real_abs(v.x), real_abs(v.y), real_abs(v.z)};
}

/** @return a times b, component by component. */
INLINE Vec3 vec3_multiply(Vec3 a, Vec3 b) {
    return (Vec3){a.x * b.x, a.y * b.y, a.z * b.z};
}

/** @return The signs of the components. */
INLINE Vec3 vec3_signs(Vec3 v) {
    return (Vec3){real_sign(v.x), real_sign(v.y), real_sign(v.z)};
}

/** @return x / y; 0 where y is 0. */
INLINE real real_divide_or_zero(real x, real y) {
    return real_select(y > 0, x / y, real_of(0));
}

/** @return Half the edges of a box. @param operands Three of a step. */
INLINE Vec3 vec3_from_scalars(const scalar *operands) {
    return (Vec3){real_of(operands[0]), real_of(operands[1]), real_of(operands[2])};
}

/**
 * @return The nearer of two samples.
 * @param wants_gradient  Whether gradients are wanted.
 */
INLINE SdfSample sdf_sample_nearer(SdfSample a, SdfSample b, bool wants_gradient) {
    SdfSample nearer = {.distance = real_min(b.distance, a.distance)};
    if (wants_gradient) {
        nearer.gradient = vec3_select(b.distance < a.distance, b.gradient, a.gradient);
    }
    return nearer;
}

/** Measures a ball. See #SdfInstruction.execute. */
void sdf_op_sphere(SdfVm *vm, const SdfInstruction *instruction);

/** Measures a box. See #SdfInstruction.execute. */
void sdf_op_box(SdfVm *vm, const SdfInstruction *instruction);

/** Measures the bars of a frame. See #SdfInstruction.execute. */
void sdf_op_box_frame(SdfVm *vm, const SdfInstruction *instruction);

/** Measures a ring. See #SdfInstruction.execute. */
void sdf_op_torus(SdfVm *vm, const SdfInstruction *instruction);

/** Measures a sponge. See #SdfInstruction.execute. */
void sdf_op_menger(SdfVm *vm, const SdfInstruction *instruction);

/** Measures a Mandelbulb. See #SdfInstruction.execute. */
void sdf_op_mandelbulb(SdfVm *vm, const SdfInstruction *instruction);

#endif
