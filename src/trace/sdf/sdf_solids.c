/**
 * @file
 * @brief Distances of solids by the formulas of Inigo Quilez (*Distance functions*), and their
 *        gradients.
 */
#include "trace/sdf/sdf_vm.h"

void sdf_op_sphere(SdfVm *vm, const SdfInstruction *instruction) {
    real length = real_sqrt(vec3_dot(vm->point, vm->point));
    vm->sample.distance = length - instruction->operands[0];
    if (vm->wants_gradient) {
        vm->sample.gradient = vec3_scale(vm->point, real_divide_or_zero(real_of(1), length));
    }
}

/** @return The unit vector along the axis of the largest component, the first one if there are
 * several.
 */
INLINE Vec3 unit_axis_of_largest(Vec3 v, real largest) {
    const real zero = real_of(0), one = real_of(1);
    mask is_x = v.x >= largest, is_y = mask_not(is_x) & (v.y >= largest);
    return (Vec3){real_select(is_x, one, zero), real_select(is_y, one, zero),
                  real_select(is_x | is_y, zero, one)};
}

/** @return The sample of the octant of negative coordinates. */
INLINE SdfSample sdf_octant_sample(Vec3 v, bool wants_gradient) {
    const real zero = real_of(0);
    Vec3 out = {real_max(v.x, zero), real_max(v.y, zero), real_max(v.z, zero)};
    real length = real_sqrt(vec3_dot(out, out));
    real largest = real_max(v.x, real_max(v.y, v.z));
    SdfSample sample = {.distance = length + real_min(largest, zero)};
    if (wants_gradient) {
        sample.gradient =
            vec3_select(length > 0, vec3_scale(out, real_divide_or_zero(real_of(1), length)),
                        unit_axis_of_largest(v, largest));
    }
    return sample;
}

/** @return The sample of a box around the origin. @param half Half its edges. */
INLINE SdfSample sdf_box_sample(Vec3 p, Vec3 half, bool wants_gradient) {
    SdfSample sample = sdf_octant_sample(vec3_subtract(vec3_abs(p), half), wants_gradient);
    if (wants_gradient) {
        sample.gradient = vec3_multiply(sample.gradient, vec3_signs(p));
    }
    return sample;
}

void sdf_op_box(SdfVm *vm, const SdfInstruction *instruction) {
    vm->sample =
        sdf_box_sample(vm->point, vec3_from_scalars(instruction->operands), vm->wants_gradient);
}

void sdf_op_box_frame(SdfVm *vm, const SdfInstruction *instruction) {
    real half_thickness = real_of(instruction->operands[3]);
    Vec3 thick = {half_thickness, half_thickness, half_thickness};
    Vec3 p = vec3_subtract(vec3_abs(vm->point), vec3_from_scalars(instruction->operands));
    Vec3 middle = vec3_add(p, thick), q = vec3_subtract(vec3_abs(middle), thick);
    Vec3 signs = vec3_signs(middle);
    SdfSample bars[3] = {sdf_octant_sample((Vec3){p.x, q.y, q.z}, vm->wants_gradient),
                         sdf_octant_sample((Vec3){q.x, p.y, q.z}, vm->wants_gradient),
                         sdf_octant_sample((Vec3){q.x, q.y, p.z}, vm->wants_gradient)};
    if (vm->wants_gradient) {
        // The absolute value reflected the coordinates across the bars: undo the sign.
        const real one = real_of(1);
        Vec3 bar_signs[3] = {
            {one, signs.y, signs.z}, {signs.x, one, signs.z}, {signs.x, signs.y, one}};
        for (int i = 0; i < 3; i++) {
            bars[i].gradient = vec3_multiply(bars[i].gradient, bar_signs[i]);
        }
    }
    vm->sample = sdf_sample_nearer(sdf_sample_nearer(bars[0], bars[1], vm->wants_gradient), bars[2],
                                   vm->wants_gradient);
    if (vm->wants_gradient) {
        vm->sample.gradient = vec3_multiply(vm->sample.gradient, vec3_signs(vm->point));
    }
}

void sdf_op_torus(SdfVm *vm, const SdfInstruction *instruction) {
    Vec3 p = vm->point;
    real axis = real_sqrt(p.x * p.x + p.z * p.z), across = axis - instruction->operands[0];
    real length = real_sqrt(across * across + p.y * p.y);
    vm->sample.distance = length - instruction->operands[1];
    if (vm->wants_gradient) {
        real radial = real_divide_or_zero(real_divide_or_zero(across, length), axis);
        vm->sample.gradient = (Vec3){p.x * radial, real_divide_or_zero(p.y, length), p.z * radial};
    }
}

/**
 * @return Three times the depth of points in holes of one size along one axis, in half cells:
 *         positive between the two sides of a hole, negative in the solid, down to the middle
 *         between two holes.
 * @param x           Coordinates, in half edges of the sponge.
 * @param per_cell    Number of cells along the sponge.
 * @param[out] slope  1 or -1: derivative by the coordinate.
 */
INLINE real menger_hole_depth(real x, scalar per_cell, real *slope) {
    real cells = x * per_cell, cell = 2 * real_floor((scalar)0.5f * cells + (scalar)0.5f);
    real in_cell = cells - cell;
    *slope = -real_sign(in_cell);
    return 2 - 3 * real_abs(in_cell) - 1;
}

/** The depths of points in holes of one size. */
typedef struct MengerHoles {
    Vec3 depth;   /**< Along the axes, times #divisor, in half edges of the sponge. */
    Vec3 slope;   /**< Signs of their derivatives. */
    real divisor; /**< See #depth. */
    real middle;  /**< The middle one of the three, in half edges of the sponge. */
} MengerHoles;

/** @return The depths. A point is in a hole along an axis if it is between the sides along the two
 *          others: the middle one decides. Division keeps the order, so one is enough. @param p
 *          Points, in half edges of the sponge. @param per_cell Number of cells along the sponge.
 */
INLINE MengerHoles menger_holes(Vec3 p, scalar per_cell) {
    MengerHoles holes = {.divisor = real_of(3 * per_cell)};
    holes.depth = (Vec3){menger_hole_depth(p.x, per_cell, &holes.slope.x),
                         menger_hole_depth(p.y, per_cell, &holes.slope.y),
                         menger_hole_depth(p.z, per_cell, &holes.slope.z)};
    real low = real_min(holes.depth.x, holes.depth.y),
         high = real_max(holes.depth.x, holes.depth.y);
    holes.middle = real_max(low, real_min(high, holes.depth.z)) / holes.divisor;
    return holes;
}

/** @return The gradient of the middle depth. */
INLINE Vec3 menger_holes_gradient(const MengerHoles *holes) {
    const real middle = holes->middle, divisor = holes->divisor;
    Vec3 to_middle = {-real_abs(holes->depth.x / divisor - middle),
                      -real_abs(holes->depth.y / divisor - middle),
                      -real_abs(holes->depth.z / divisor - middle)};
    return vec3_multiply(unit_axis_of_largest(to_middle, real_of(0)), holes->slope);
}

void sdf_op_menger(SdfVm *vm, const SdfInstruction *instruction) {
    const real one = real_of(1), half = real_of(instruction->operands[0]);
    Vec3 p = vec3_scale(vm->point, one / half);
    SdfSample sponge = sdf_box_sample(p, (Vec3){one, one, one}, vm->wants_gradient);
    scalar per_cell = 1;
    for (int i = 0; i < (int)instruction->operands[1]; i++) {
        // No point is deeper in a hole than a third of half a cell: smaller holes change nothing
        // far from the sponge and inside larger ones.
        if (!any(vm->active & (sponge.distance < real_of(1 / (3 * per_cell))))) {
            break;
        }
        vm->operations++;
        MengerHoles holes = menger_holes(p, per_cell);
        mask is_cut = holes.middle > sponge.distance;
        sponge.distance = real_select(is_cut, holes.middle, sponge.distance);
        if (vm->wants_gradient) {
            sponge.gradient = vec3_select(is_cut, menger_holes_gradient(&holes), sponge.gradient);
        }
        per_cell *= 3;
    }
    vm->sample = sponge;
    vm->sample.distance = sponge.distance * half;
}
