/**
 * @file
 * @brief The virtual machine that evaluates distance fields.
 */
#ifndef DIOPTRE_TRACE_SDF_SDF_VM_H
#define DIOPTRE_TRACE_SDF_SDF_VM_H

#include "trace/math/angle.h"
#include "trace/sdf/sdf_program.h"

/** State of the machine. */
struct SdfVm {
    Vec3 point;          /**< The points. */
    SdfSample sample;    /**< Result of the instructions so far. */
    mask active;         /**< Lanes that count. */
    bool wants_gradient; /**< Whether to compute gradients. */
    uint32_t operations; /**< Operations so far: instructions, and of those that repeat something,
                              such as the levels of a sponge, each time. */
};

/** Executes instructions one after the other. */
INLINE void sdf_vm_run(SdfVm *vm, const SdfInstruction *program, int count) {
    for (const SdfInstruction *instruction = program; instruction < program + count;
         instruction += 1 + instruction->body_count) {
        vm->operations++;
        instruction->execute(vm, instruction);
    }
}

/** @return Distances of points. @param active Lanes that count; other results are undefined. */
INLINE real sdf_distance(const SdfProgram *program, Vec3 point, mask active) {
    SdfVm vm; // Without a gradient: this is the hot loop of sphere tracing.
    vm.point = point;
    vm.sample.distance = real_of(0);
    vm.active = active;
    vm.wants_gradient = false;
    vm.operations = 0;
    sdf_vm_run(&vm, program->instructions, program->count);
    return vm.sample.distance;
}

/** #sdf_distance that counts. @param[in,out] operations The operations are added to this: all that
 *  the active lanes need together. */
INLINE real sdf_distance_counted(const SdfProgram *program, Vec3 point, mask active,
                                 uint64_t *operations) {
    SdfVm vm = {.point = point, .active = active};
    sdf_vm_run(&vm, program->instructions, program->count);
    *operations += vm.operations;
    return vm.sample.distance;
}

/** @return Distances of points with gradients, by forward differentiation. @param active Lanes that
 *  count; other results are undefined. */
INLINE SdfSample sdf_sample(const SdfProgram *program, Vec3 point, mask active) {
    const real zero = real_of(0);
    SdfVm vm = {.point = point,
                .sample = {zero, {zero, zero, zero}},
                .active = active,
                .wants_gradient = true};
    sdf_vm_run(&vm, program->instructions, program->count);
    return vm.sample;
}

/** @return The signs of numbers: 1 or -1. */
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

/** @return The same vector in all lanes. @param operands Its three components. */
INLINE Vec3 vec3_from_scalars(const scalar *operands) {
    return (Vec3){real_of(operands[0]), real_of(operands[1]), real_of(operands[2])};
}

/** @return The sample with the smaller distance. */
INLINE SdfSample sdf_sample_nearer(SdfSample a, SdfSample b, bool wants_gradient) {
    SdfSample nearer = {.distance = real_min(b.distance, a.distance)};
    if (wants_gradient) {
        nearer.gradient = vec3_select(b.distance < a.distance, b.gradient, a.gradient);
    }
    return nearer;
}

/** Moves the surface outwards. See #SdfInstruction.execute. */
void sdf_op_round(SdfVm *vm, const SdfInstruction *instruction);

/** Transforms a field: the inverse transforms the points. See #SdfInstruction.execute. */
void sdf_op_transform(SdfVm *vm, const SdfInstruction *instruction);

/** Repeats a field: the nearest of the copies in the cells around. See #SdfInstruction.execute. */
void sdf_op_repeat(SdfVm *vm, const SdfInstruction *instruction);

/** Union: the smaller distance. See #SdfInstruction.execute. */
void sdf_op_union(SdfVm *vm, const SdfInstruction *instruction);

/** Smooth union: the seam is filled. See #SdfInstruction.execute. */
void sdf_op_smooth_union(SdfVm *vm, const SdfInstruction *instruction);

/** Unions that follow one another: executes those of its body that can change the result. See
 *  #SdfInstruction.execute. */
void sdf_op_union_run(SdfVm *vm, const SdfInstruction *instruction);

/** Intersection: the larger distance. See #SdfInstruction.execute. */
void sdf_op_intersection(SdfVm *vm, const SdfInstruction *instruction);

/** Difference: intersection with the complement of the body. See #SdfInstruction.execute. */
void sdf_op_difference(SdfVm *vm, const SdfInstruction *instruction);

/** Distance to a sphere. See #SdfInstruction.execute. */
void sdf_op_sphere(SdfVm *vm, const SdfInstruction *instruction);

/** Distance to a box. See #SdfInstruction.execute. */
void sdf_op_box(SdfVm *vm, const SdfInstruction *instruction);

/** Distance to the edges of a box. See #SdfInstruction.execute. */
void sdf_op_box_frame(SdfVm *vm, const SdfInstruction *instruction);

/** Distance to a torus. See #SdfInstruction.execute. */
void sdf_op_torus(SdfVm *vm, const SdfInstruction *instruction);

/** Distance to a Menger sponge. See #SdfInstruction.execute. */
void sdf_op_menger(SdfVm *vm, const SdfInstruction *instruction);

/** Bound of the distance to a Mandelbulb. See #SdfInstruction.execute. */
void sdf_op_mandelbulb(SdfVm *vm, const SdfInstruction *instruction);

/** Result of a tape. See #SdfInstruction.execute. */
void sdf_op_tape(SdfVm *vm, const SdfInstruction *instruction);

enum {
    SDF_VECTORS_MAXIMUM = 6, /**< Most vectors of points that are evaluated together: a gradient by
                                  central differences needs so many. */
    MARCH_VECTORS = 2 /**< Vectors of rays that step in turn or together: the processor begins
                           the step of one before that of the other ends. Three were slower
                           (measured). */
};

/** @return Whether a field is evaluated faster at several vectors of points together, by
 *          #sdf_distances. */
INLINE bool sdf_prefers_vectors(const SdfProgram *program) {
    return program->count == 1 && program->instructions->execute == sdf_op_mandelbulb;
}

/**
 * Finds bounds of the distances of some vectors of points to a Mandelbulb. Each iteration waits for
 * two roots and a quotient: those of other vectors are computed meanwhile.
 * @param operands        Those of its instruction.
 * @param points          The points, per vector.
 * @param active          Lanes that count, per vector.
 * @param count           Number of vectors, up to #SDF_VECTORS_MAXIMUM.
 * @param[out] distances  The bounds, per vector.
 * @return Number of iterations, at least 1.
 */
int sdf_mandelbulb_distances(const scalar *operands, const Vec3 *points, const mask *active,
                             int count, real *distances);

/** #sdf_distance for several vectors of points, in a field for which #sdf_prefers_vectors. @param
 *  count Number of vectors, up to #SDF_VECTORS_MAXIMUM. @param[out] distances Per vector. */
INLINE void sdf_distances(const SdfProgram *program, const Vec3 *points, const mask *active,
                          int count, real *distances) {
    sdf_mandelbulb_distances(program->instructions->operands, points, active, count, distances);
}

/**
 * Translates the steps of a tape.
 * @param[out] body  The instructions behind that of the tape: memory for its steps.
 * @param tape       Its #SDF_TAPE node, followed by its steps.
 */
void sdf_tape_compile(SdfInstruction *body, const SdfNode *tape);

#endif
