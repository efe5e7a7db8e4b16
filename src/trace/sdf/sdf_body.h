/**
 * @file
 * @brief Bodies of instructions with a bounding box: they are evaluated where they can be near.
 */
#ifndef DIOPTRE_TRACE_SDF_SDF_BODY_H
#define DIOPTRE_TRACE_SDF_SDF_BODY_H

#include "trace/sdf/sdf_vm.h"

/** @return Chebyshev distances of points from a box; negative inside. @param corners Three lowest
 *  coordinates, three highest. */
INLINE real box_chebyshev_distance(const scalar *corners, Vec3 p) {
    real x = real_max(corners[0] - p.x, p.x - corners[3]);
    real y = real_max(corners[1] - p.y, p.y - corners[4]);
    real z = real_max(corners[2] - p.z, p.z - corners[5]);
    return real_max(x, real_max(y, z));
}

/** @return The larger of two lower bounds: the distances of a field and of its box. */
INLINE real max_with_box_distance(real distance, real box_distance) {
    return real_select(box_distance > 0, real_max(distance, box_distance), distance);
}

/**
 * Executes a body only where it can change the result.
 * @param[in,out] needed  Lanes where it can; afterwards only active ones.
 * @param box_distance    Distances from its box.
 * @return Whether it was executed.
 */
INLINE bool sdf_vm_run_body(SdfVm *vm, const SdfInstruction *instruction, mask *needed,
                            real box_distance, SdfSample *body) {
    const mask all = vm->active;
    *needed = *needed & all;
    if (!any(*needed)) {
        return false;
    }
    vm->active = *needed;
    sdf_vm_run(vm, instruction + 1, instruction->body_count);
    vm->active = all;
    *body = vm->sample;
    body->distance = max_with_box_distance(body->distance, box_distance);
    return true;
}

#endif
