/**
 * @file
 * @brief Unions of distance fields.
 *
 * A part changes nothing where its box is farther away than the distance so far. For one part, each
 * lane tests that. For a run of many parts, the bounding box of all lanes' points is tested against
 * the boxes of a pack of parts at once. The order of the parts is free, since a union is the
 * smallest distance; only the sign of a zero may depend on it, which no step reads. In a smooth
 * union each part changes what the next one is compared with, so the order counts: there is no run.
 */
#include "trace/sdf/sdf_union.h"
#include "trace/sdf/sdf_body.h"

/* --- one part --------------------------------------------------------------------------------- */

void sdf_op_union(SdfVm *vm, const SdfInstruction *instruction) {
    SdfSample first = vm->sample, second;
    real box_distance = box_chebyshev_distance(instruction->operands, vm->point);
    mask needed = mask_not((box_distance > 0) & (box_distance >= first.distance));
    if (sdf_vm_run_body(vm, instruction, &needed, box_distance, &second)) {
        second.distance = real_select(needed, second.distance, first.distance);
        second = sdf_sample_nearer(first, second, vm->wants_gradient);
    } else {
        second = first;
    }
    vm->sample = second;
}

void sdf_op_smooth_union(SdfVm *vm, const SdfInstruction *instruction) {
    SdfSample first = vm->sample, second;
    const real radius = real_of(instruction->operands[6]), zero = real_of(0);
    real box_distance = box_chebyshev_distance(instruction->operands, vm->point);
    mask needed = mask_not((box_distance > 0) & (box_distance >= first.distance + radius));
    if (!sdf_vm_run_body(vm, instruction, &needed, box_distance, &second)) {
        vm->sample = first;
        return;
    }
    real gap = real_abs(first.distance - second.distance);
    real blend = real_max(radius - gap, zero) / radius;
    SdfSample blended = sdf_sample_nearer(first, second, vm->wants_gradient);
    blended.distance = blended.distance - blend * blend * radius * (scalar)0.25f;
    if (vm->wants_gradient) {
        // The gradient of the farther field has half the weight of the blend.
        mask is_second = second.distance < first.distance;
        Vec3 far = vec3_select(is_second, first.gradient, second.gradient);
        Vec3 near = vec3_scale(blended.gradient, 1 - (scalar)0.5f * blend);
        blended.gradient = vec3_add(near, vec3_scale(far, (scalar)0.5f * blend));
    }
    vm->sample.distance = real_select(needed, blended.distance, first.distance);
    if (vm->wants_gradient) {
        vm->sample.gradient = vec3_select(needed, blended.gradient, first.gradient);
    }
}

/* --- runs of parts ---------------------------------------------------------------------------- */

/** The distances of the boxes of a run from points. */
typedef struct RunDistances {
    PackReal packs[SDF_UNION_RUN_PACKS][PACK_VECTORS]; /**< Per pack. */
} RunDistances;

/** @return The bounding box of points. @param lanes Lanes that count. */
INLINE Aabbs points_box(Vec3 p, mask lanes) {
    const real most = real_of(INFINITE), least = real_of(-INFINITE);
    return (Aabbs){{real_reduce_min(real_select(lanes, p.x, most)),
                    real_reduce_min(real_select(lanes, p.y, most)),
                    real_reduce_min(real_select(lanes, p.z, most))},
                   {real_reduce_max(real_select(lanes, p.x, least)),
                    real_reduce_max(real_select(lanes, p.y, least)),
                    real_reduce_max(real_select(lanes, p.z, least))}};
}

/** Finds lower bounds of the Chebyshev distances of points from the boxes of a run; roundings keep
 *  them so. @param points Their bounding box. */
INLINE void union_run_distances(const SdfInstruction *run, const Aabbs *points,
                                RunDistances *distances) {
    for (int k = 0; k < run->pack_count; k++) {
        const AabbPack *boxes = &run->packs[k].boxes;
        for (int v = 0; v < PACK_VECTORS; v++) {
            PackReal axes[3];
            for (int axis = 0; axis < 3; axis++) {
                axes[axis] =
                    pack_max(boxes->planes[axis][v] - pack_scalar_above(points->high[axis]),
                             pack_scalar_below(points->low[axis]) - boxes->planes[axis + 3][v]);
            }
            distances->packs[k][v] = pack_max(axes[0], pack_max(axes[1], axes[2]));
        }
    }
}

/** @return The parts of a pack whose boxes are not farther away than a distance, or contain points.
 *  @param farthest The largest distance so far. */
INLINE unsigned union_pack_near(const SdfUnionPack *pack, const PackReal distances[PACK_VECTORS],
                                scalar farthest) {
    const pack_scalar limit = pack_scalar_above(farthest);
    unsigned far = 0;
    for (int v = 0; v < PACK_VECTORS; v++) {
        far |= PACK_BITS((distances[v] > 0) & (distances[v] > limit)) << v * PACK_LANES;
    }
    return ~far & pack->bits;
}

/** @return A part whose box is nearest. */
INLINE const SdfInstruction *union_run_nearest(const SdfInstruction *run,
                                               const RunDistances *distances) {
    PackReal least[PACK_VECTORS];
    int best = 0, nearest = 0;
    for (int v = 0; v < PACK_VECTORS; v++) {
        least[v] = (pack_scalar)INFINITE - (PackReal){0};
        for (int k = 0; k < run->pack_count; k++) {
            least[v] = pack_min(distances->packs[k][v], least[v]);
        }
    }
    for (int i = 1; i < AABB_PACK_SIZE; i++) {
        best = pack_lane(least, i) < pack_lane(least, best) ? i : best;
    }
    for (int k = 1; k < run->pack_count; k++) {
        bool is_nearer =
            pack_lane(distances->packs[k], best) < pack_lane(distances->packs[nearest], best);
        nearest = is_nearer ? k : nearest;
    }
    return run->packs[nearest].parts[best];
}

/** @return The largest distance so far. Lanes with NaN do not count: no part changes them. */
INLINE scalar sdf_vm_farthest(const SdfVm *vm) {
    const real least = real_of(-INFINITE);
    return real_reduce_max(real_select(vm->active, real_max(vm->sample.distance, least), least));
}

/** Executes the parts of a run that are near enough, in their order; not inlined, as it is called
 *  twice. @param done A part that has been executed; NULL: none. @param farthest See
 *  #union_pack_near. @param is_final Whether it is final; else it is updated after each part. */
static __attribute__((noinline)) void union_run_execute(SdfVm *vm, const SdfInstruction *run,
                                                        const RunDistances *distances,
                                                        const SdfInstruction *done, scalar farthest,
                                                        bool is_final) {
    for (int k = 0; k < run->pack_count; k++) {
        const SdfUnionPack *pack = &run->packs[k];
        unsigned left = union_pack_near(pack, distances->packs[k], farthest);
        while (left) {
            const SdfInstruction *part = pack->parts[__builtin_ctz(left)];
            left &= left - 1;
            if (part == done) {
                continue;
            }
            vm->operations++;
            part->execute(vm, part);
            if (!is_final) {
                farthest = sdf_vm_farthest(vm);
                left &= union_pack_near(pack, distances->packs[k], farthest);
            }
        }
    }
}

void sdf_op_union_run(SdfVm *vm, const SdfInstruction *run) {
    const SdfSample before = vm->sample;
    const bool wants_gradient = vm->wants_gradient;
    const Aabbs points = points_box(vm->point, vm->active);
    RunDistances distances;
    union_run_distances(run, &points, &distances);
    // The part with the nearest box first: its distance rules out most others.
    const SdfInstruction *nearest = union_run_nearest(run, &distances);
    vm->wants_gradient = false;
    vm->operations++;
    nearest->execute(vm, nearest);
    union_run_execute(vm, run, &distances, nearest, sdf_vm_farthest(vm), false);
    if (wants_gradient) {
        // Of parts that are equally near, the first one gives the gradient: once more, in order.
        const scalar farthest = sdf_vm_farthest(vm);
        vm->sample = before;
        vm->wants_gradient = true;
        union_run_execute(vm, run, &distances, NULL, farthest, true);
    }
}
