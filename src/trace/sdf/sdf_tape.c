/**
 * @file
 * @brief Tapes: operations on numbers, see dioptre/sdf_tape.h.
 *
 * Each step has two forms: on numbers alone, and on numbers with their derivatives by x, y and z
 * (forward differentiation).
 */
#include "trace/math/sine.h"
#include "trace/sdf/tape_octree.h"

#include <fenv.h>

/** LANES numbers with their derivatives. */
typedef SdfSample TapeDual;

/* --- derivatives ------------------------------------------------------------------------------ */

/** @return A number with its derivatives. */
INLINE TapeDual dual_of(real value, Vec3 gradient) {
    return (TapeDual){value, gradient};
}

/** @return A number that does not depend on the point. */
INLINE TapeDual dual_constant(real value) {
    const real zero = real_of(0);
    return dual_of(value, (Vec3){zero, zero, zero});
}

/** @return A number whose derivatives are a multiple of those of another. */
INLINE TapeDual dual_chain(real value, real slope, TapeDual inner) {
    return dual_of(value, vec3_scale(inner.gradient, slope));
}

/** @return A number whose derivatives are the weighted sum of those of two others. */
INLINE TapeDual dual_chain2(real value, real slope_a, TapeDual a, real slope_b, TapeDual b) {
    return dual_of(value,
                   vec3_add(vec3_scale(a.gradient, slope_a), vec3_scale(b.gradient, slope_b)));
}

/* --- operations ------------------------------------------------------------------------------- */

/**
 * Defines both forms of a step.
 * @param NAME   Its name.
 * @param VALUE  Its result from the numbers `a`, `b` and the constant `c`.
 * @param DUAL   Its result with derivatives from that `value` and from `p` and `q`, which are a
 *               and b with their derivatives.
 */
#define TAPE_STEP(NAME, VALUE, DUAL)                                                               \
    static void tape_##NAME(real *registers, const TapeUse *use, const TapeStep *step) {           \
        const real a = registers[use->a], b = registers[use->b], c = real_of(step->constant);      \
        (void)a, (void)b, (void)c;                                                                 \
        registers[use->to] = (VALUE);                                                              \
    }                                                                                              \
    static void tape_##NAME##_dual(TapeDual *registers, const TapeUse *use,                        \
                                   const TapeStep *step) {                                         \
        const TapeDual p = registers[use->a], q = registers[use->b];                               \
        const real a = p.distance, b = q.distance, c = real_of(step->constant);                    \
        (void)a, (void)b, (void)c, (void)p, (void)q;                                               \
        const real value = (VALUE);                                                                \
        registers[use->to] = (DUAL);                                                               \
    }

/** The constant. */
TAPE_STEP(constant, c, dual_constant(value))
/** a + b */
TAPE_STEP(add, a + b, dual_of(value, vec3_add(p.gradient, q.gradient)))
/** a - b */
TAPE_STEP(subtract, a - b, dual_of(value, vec3_subtract(p.gradient, q.gradient)))
/** a * b */
TAPE_STEP(multiply, (a * b), dual_chain2(value, b, p, a, q))
/** a / b */
TAPE_STEP(divide, a / b, dual_chain2(value, 1 / b, p, -value / b, q))
/** The remainder by the floor. */
TAPE_STEP(modulo, a - real_floor(a / b) * b,
          dual_chain2(value, real_of(1), p, -real_floor(a / b), q))
/** The smaller one. */
TAPE_STEP(minimum, real_min(b, a), dual_of(value, vec3_select(b < a, q.gradient, p.gradient)))
/** The larger one. */
TAPE_STEP(maximum, real_max(b, a), dual_of(value, vec3_select(b > a, q.gradient, p.gradient)))
/** -a */
TAPE_STEP(negate, -a, dual_chain(value, real_of(-1), p))
/** The square root. */
TAPE_STEP(square_root, real_sqrt(a),
          dual_chain(value, real_divide_or_zero(real_of((scalar)0.5f), value), p))
/** The absolute value. */
TAPE_STEP(absolute, real_abs(a), dual_chain(value, real_sign(a), p))
/** The largest integer that is not larger. */
TAPE_STEP(floor, real_floor(a), dual_constant(value))
/** The sine. */
TAPE_STEP(sine, real_sine_cosine(a).sine, dual_chain(value, real_sine_cosine(a).cosine, p))
/** The cosine. */
TAPE_STEP(cosine, real_sine_cosine(a).cosine, dual_chain(value, -real_sine_cosine(a).sine, p))
/** a + c */
TAPE_STEP(add_constant, a + c, dual_of(value, p.gradient))
/** a * c */
TAPE_STEP(multiply_constant, (a * c), dual_chain(value, c, p))

/** Both forms of a step. */
typedef struct TapeOperation {
    /** On numbers alone. */
    void (*run)(real *registers, const TapeUse *use, const TapeStep *step);
    /** With derivatives. */
    void (*differentiate)(TapeDual *registers, const TapeUse *use, const TapeStep *step);
} TapeOperation;

/** The forms of an operation. */
#define TAPE_ROW(NAME)                                                                             \
    { .run = tape_##NAME, .differentiate = tape_##NAME##_dual }

/** The operations. */
static const TapeOperation tape_operations[SDF_TAPE_OP_COUNT] = {
    [SDF_TAPE_CONSTANT] = TAPE_ROW(constant),
    [SDF_TAPE_ADD] = TAPE_ROW(add),
    [SDF_TAPE_SUBTRACT] = TAPE_ROW(subtract),
    [SDF_TAPE_MULTIPLY] = TAPE_ROW(multiply),
    [SDF_TAPE_DIVIDE] = TAPE_ROW(divide),
    [SDF_TAPE_MODULO] = TAPE_ROW(modulo),
    [SDF_TAPE_MINIMUM] = TAPE_ROW(minimum),
    [SDF_TAPE_MAXIMUM] = TAPE_ROW(maximum),
    [SDF_TAPE_NEGATE] = TAPE_ROW(negate),
    [SDF_TAPE_SQUARE_ROOT] = TAPE_ROW(square_root),
    [SDF_TAPE_ABSOLUTE] = TAPE_ROW(absolute),
    [SDF_TAPE_FLOOR] = TAPE_ROW(floor),
    [SDF_TAPE_SINE] = TAPE_ROW(sine),
    [SDF_TAPE_COSINE] = TAPE_ROW(cosine),
    [SDF_TAPE_ADD_CONSTANT] = TAPE_ROW(add_constant),
    [SDF_TAPE_MULTIPLY_CONSTANT] = TAPE_ROW(multiply_constant)};

/* --- tapes ------------------------------------------------------------------------------------ */

void sdf_tape_compile(SdfInstruction *body, const SdfNode *tape) {
    TapeStep *steps = (TapeStep *)body;
    for (int i = 0; i < tape->body_count; i++) {
        const double *operands = tape[1 + i].operands;
        const SdfTapeOp op = (SdfTapeOp)operands[SDF_STEP_OP];
        steps[i] = (TapeStep){.run = tape_operations[op].run,
                              .use = {.step = (uint16_t)i,
                                      .to = (uint16_t)operands[SDF_STEP_TO],
                                      .a = (uint16_t)operands[SDF_STEP_A],
                                      .b = (uint16_t)operands[SDF_STEP_B]},
                              .constant = (scalar)operands[SDF_STEP_CONSTANT],
                              .op = op};
    }
}

/** @return The result of a tape at points. */
static real tape_value(Tape tape, Vec3 p) {
    real registers[SDF_TAPE_REGISTERS];
    registers[0] = p.x;
    registers[1] = p.y;
    registers[2] = p.z;
    for (int i = 0; i < tape.count; i++) {
        const TapeStep *step = tape_step(&tape, i);
        step->run(registers, tape_use(&tape, i), step);
    }
    return registers[tape.result];
}

/** @return The result of a tape at points, with its derivatives. */
static SdfSample tape_sample(Tape tape, Vec3 p) {
    const real one = real_of(1), zero = real_of(0);
    TapeDual registers[SDF_TAPE_REGISTERS];
    registers[0] = dual_of(p.x, (Vec3){one, zero, zero});
    registers[1] = dual_of(p.y, (Vec3){zero, one, zero});
    registers[2] = dual_of(p.z, (Vec3){zero, zero, one});
    for (int i = 0; i < tape.count; i++) {
        const TapeStep *step = tape_step(&tape, i);
        tape_operations[step->op].differentiate(registers, tape_use(&tape, i), step);
    }
    return registers[tape.result];
}

/** @return The result of a tape at points, with its gradient if that is wanted. */
INLINE SdfSample tape_evaluate(SdfVm *vm, Tape tape, Vec3 p) {
    vm->operations += tape.count;
    return vm->wants_gradient ? tape_sample(tape, p) : (SdfSample){.distance = tape_value(tape, p)};
}

/** #tape_evaluate for each point in its cell of the octree. */
static SdfSample tape_evaluate_cells(SdfVm *vm, const SdfInstruction *instruction, Vec3 p) {
    const real zero = real_of(0);
    const Tape whole = tape_of(instruction);
    SdfSample all = {zero, {zero, zero, zero}};
    unsigned left = mask_bits(vm->active);
    while (left) {
        const TapeLanes part = tape_octree_find(instruction->octree, whole, p, left);
        const SdfSample sample = tape_evaluate(vm, part.tape, p);
        if (part.lanes == ALL_LANES) {
            return sample;
        }
        const mask lanes = mask_of_bits(part.lanes);
        all.distance = real_select(lanes, sample.distance, all.distance);
        if (vm->wants_gradient) {
            all.gradient = vec3_select(lanes, sample.gradient, all.gradient);
        }
        left &= ~part.lanes;
    }
    return all;
}

/** @return The nearest points of a box. @param corners Three lowest coordinates, three highest. */
INLINE Vec3 box_nearest_point(const scalar *corners, Vec3 p) {
    Vec3 low = vec3_from_scalars(corners), high = vec3_from_scalars(corners + 3);
    return (Vec3){real_max(low.x, real_min(p.x, high.x)), real_max(low.y, real_min(p.y, high.y)),
                  real_max(low.z, real_min(p.z, high.z))};
}

void sdf_op_tape(SdfVm *vm, const SdfInstruction *instruction) {
    const scalar *operands = instruction->operands;
    const bool clamps = operands[SDF_TAPE_CLAMPS] != 0;
    Vec3 point = clamps ? box_nearest_point(operands + SDF_TAPE_BOX, vm->point) : vm->point;
    const bool has_octree = HAS_TAPE_OCTREES && instruction->octree && fegetround() == FE_TONEAREST;
    SdfSample sample = has_octree ? tape_evaluate_cells(vm, instruction, point)
                                  : tape_evaluate(vm, tape_of(instruction), point);
    if (vm->wants_gradient) {
        sample.gradient = vec3_scale(sample.gradient, real_of(operands[SDF_TAPE_FACTOR]));
    }
    sample.distance = sample.distance * operands[SDF_TAPE_FACTOR];
    if (clamps) {
        // At a distance d from the box, the surface is at least d away, and at least d less away
        // than from the nearest point of the box.
        Vec3 off = vec3_subtract(vm->point, point);
        real outside = real_sqrt(vec3_dot(off, off));
        sample.distance =
            real_max(sample.distance - outside, real_select(outside > 0, outside, sample.distance));
    }
    vm->sample = sample;
}
