/**
 * @file
 * @brief Operations on distance fields, but for unions.
 *
 * The result of a lane never depends on other lanes: an instruction skips work only where no lane
 * needs it.
 */
#include "trace/sdf/sdf_body.h"

/* --- operations on one field ------------------------------------------------------------------ */

void sdf_op_round(SdfVm *vm, const SdfInstruction *instruction) {
    vm->sample.distance = vm->sample.distance - instruction->operands[0];
}

/** @return A matrix, given by its rows, times a vector. */
INLINE Vec3 matrix_rows_apply(const scalar *rows, Vec3 v) {
    return (Vec3){rows[0] * v.x + rows[1] * v.y + rows[2] * v.z,
                  rows[3] * v.x + rows[4] * v.y + rows[5] * v.z,
                  rows[6] * v.x + rows[7] * v.y + rows[8] * v.z};
}

/** @return The transposed matrix times a vector. */
INLINE Vec3 matrix_columns_apply(const scalar *rows, Vec3 v) {
    return (Vec3){rows[0] * v.x + rows[3] * v.y + rows[6] * v.z,
                  rows[1] * v.x + rows[4] * v.y + rows[7] * v.z,
                  rows[2] * v.x + rows[5] * v.y + rows[8] * v.z};
}

void sdf_op_transform(SdfVm *vm, const SdfInstruction *instruction) {
    const Vec3 outer_point = vm->point;
    const scalar *n = instruction->operands;
    vm->point = matrix_rows_apply(n, vec3_subtract(outer_point, vec3_from_scalars(n + 9)));
    sdf_vm_run(vm, instruction + 1, instruction->body_count);
    vm->point = outer_point;
    vm->sample.distance = vm->sample.distance * n[12];
    if (vm->wants_gradient) {
        vm->sample.gradient =
            vec3_scale(matrix_columns_apply(n, vm->sample.gradient), real_of(n[12]));
    }
}

/** The cells of a repeated field around LANES points, along one axis. */
typedef struct RepeatCells {
    real cell;          /**< Number of the cell of each point. */
    real neighbor_step; /**< 1 or -1: offset of the nearer neighbour. */
    real period;        /**< Size of a cell; 0: there is one only. */
    real limit;         /**< Number of the last cell. */
    int count;          /**< Number of cells to evaluate. */
} RepeatCells;

/** @return The cells around points. @param operands Operands for the axis: every third. */
INLINE RepeatCells repeat_cells_of(real x, const scalar *operands) {
    real half = real_of(operands[3]), limit = real_of(operands[6]);
    if (!(operands[0] > 0)) {
        return (RepeatCells){real_of(0), real_of(1), real_of(0), real_of(0), 1};
    }
    real own = real_floor(x / real_of(operands[0]) + ((scalar)0.5f - half)) + half;
    own = real_max(-limit, real_min(own, limit));
    return (RepeatCells){own, real_sign(x - own * operands[0]), real_of(operands[0]), limit,
                         1 + (int)operands[9]};
}

/** @return Coordinates relative to a cell. @param which 0: own cell, 1: nearer neighbour, 2:
 * farther neighbour. */
INLINE real repeat_cells_local_coordinate(const RepeatCells *cells, real x, int which) {
    const scalar steps[3] = {0, 1, -1};
    real number = cells->cell + cells->neighbor_step * steps[which];
    number = real_max(-cells->limit, real_min(number, cells->limit));
    return x - number * cells->period;
}

/** Evaluates a copy of a repeated field where it can be nearer. @param vm The machine, with the
 * point in the coordinates of the copy. */
INLINE void sdf_vm_run_copy(SdfVm *vm, const SdfInstruction *instruction, SdfSample *nearest) {
    const mask all = vm->active;
    real box_distance = box_chebyshev_distance(instruction->operands + 12, vm->point);
    vm->active = all & mask_not((box_distance > 0) & (box_distance >= nearest->distance));
    if (any(vm->active)) {
        sdf_vm_run(vm, instruction + 1, instruction->body_count);
        real distance = max_with_box_distance(vm->sample.distance, box_distance);
        mask is_nearer = vm->active & (distance < nearest->distance);
        nearest->distance = real_select(is_nearer, distance, nearest->distance);
        if (vm->wants_gradient) {
            nearest->gradient = vec3_select(is_nearer, vm->sample.gradient, nearest->gradient);
        }
    }
    vm->active = all;
}

void sdf_op_repeat(SdfVm *vm, const SdfInstruction *instruction) {
    const Vec3 p = vm->point;
    const real none = real_of(0);
    RepeatCells x = repeat_cells_of(p.x, instruction->operands),
                y = repeat_cells_of(p.y, instruction->operands + 1),
                z = repeat_cells_of(p.z, instruction->operands + 2);
    SdfSample nearest = {real_of(INFINITE), {none, none, none}};
    for (int i = 0; i < x.count * y.count * z.count; i++) {
        vm->point = (Vec3){repeat_cells_local_coordinate(&x, p.x, i % x.count),
                           repeat_cells_local_coordinate(&y, p.y, i / x.count % y.count),
                           repeat_cells_local_coordinate(&z, p.z, i / x.count / y.count)};
        sdf_vm_run_copy(vm, instruction, &nearest);
    }
    vm->point = p;
    vm->sample = nearest;
}

/* --- operations on two fields ----------------------------------------------------------------- */

/** @return The sample with the larger distance. */
INLINE SdfSample sdf_sample_farther(SdfSample a, SdfSample b, bool wants_gradient) {
    SdfSample farther = {.distance = real_max(b.distance, a.distance)};
    if (wants_gradient) {
        farther.gradient = vec3_select(b.distance > a.distance, b.gradient, a.gradient);
    }
    return farther;
}

void sdf_op_intersection(SdfVm *vm, const SdfInstruction *instruction) {
    SdfSample first = vm->sample;
    sdf_vm_run(vm, instruction + 1, instruction->body_count);
    vm->sample = sdf_sample_farther(first, vm->sample, vm->wants_gradient);
}

void sdf_op_difference(SdfVm *vm, const SdfInstruction *instruction) {
    SdfSample first = vm->sample, second;
    real box_distance = box_chebyshev_distance(instruction->operands, vm->point);
    mask needed = mask_not((box_distance > 0) & (first.distance >= -box_distance));
    if (sdf_vm_run_body(vm, instruction, &needed, box_distance, &second)) {
        second.distance = real_select(needed, -second.distance, first.distance);
        second.gradient =
            vm->wants_gradient ? vec3_scale(second.gradient, real_of(-1)) : first.gradient;
        first = sdf_sample_farther(first, second, vm->wants_gradient);
    }
    vm->sample = first;
}
