/**
 * @file
 * @brief Tapes: their recording, and the field that they become.
 */
#include "dioptre/sdf_tape.h"

#include "scene/sdf_tape_range.h"

#include <limits.h>
#include <string.h>

/* --- recording -------------------------------------------------------------------------------- */

/** @return Whether a step is a constant. */
static bool is_constant(const SdfTape *tape, int step) {
    return tape->steps[step].op == SDF_TAPE_CONSTANT;
}

/** @return A hash of a step, by the last steps of splitmix64. */
static uint64_t step_hash(const SdfTapeStep *step) {
    uint64_t bits;
    memcpy(&bits, &step->constant, sizeof bits);
    bits += (uint64_t)step->op * 0x9e3779b97f4a7c15u + ((uint64_t)step->a << 32) +
            (uint64_t)step->b * 0xff51afd7ed558ccdu;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return bits ^ (bits >> 31);
}

/** @return Whether two steps are the same. Zeros of both signs differ. */
static bool steps_equal(const SdfTapeStep *a, const SdfTapeStep *b) {
    return a->op == b->op && a->a == b->a && a->b == b->b &&
           memcmp(&a->constant, &b->constant, sizeof a->constant) == 0;
}

/** Adds a step unless there is an equal one. @return Its index; -1: the tape is full. */
static int append_step(SdfTape *tape, SdfTapeStep step) {
    const size_t mask = SDF_TAPE_TABLE_SIZE - 1;
    size_t slot = (size_t)step_hash(&step) & mask;
    for (; tape->table[slot]; slot = (slot + 1) & mask) {
        if (steps_equal(&tape->steps[tape->table[slot] - 1], &step)) {
            return tape->table[slot] - 1;
        }
    }
    if (tape->count == SDF_TAPE_STEPS_MAXIMUM) {
        return -1;
    }
    tape->steps[tape->count] = step;
    tape->table[slot] = ++tape->count;
    return tape->count - 1;
}

void sdf_tape_begin(SdfTape *tape) {
    memset(tape, 0, sizeof *tape);
    tape->is_open = true;
    for (int axis = 0; axis < 3; axis++) {
        append_step(tape, (SdfTapeStep){.op = SDF_TAPE_INPUT, .a = axis, .b = axis});
    }
}

int sdf_tape_add_constant(SdfTape *tape, double value) {
    return append_step(tape, (SdfTapeStep){.op = SDF_TAPE_CONSTANT, .constant = value});
}

/** @return A step with a constant as second operand. */
static SdfTapeStep with_constant(SdfTapeOp op, int a, double constant) {
    return (SdfTapeStep){op, a, a, constant};
}

/**
 * Combines a step with a constant that follows it, where an operation does that with the same
 * bits (but for the sign of a zero).
 * @param[in,out] step  An operation with two operands, the second of them a constant.
 * @return Whether the result is its first operand.
 */
static bool combine_constant(const SdfTape *tape, SdfTapeStep *step) {
    double c = tape->steps[step->b].constant, inverse = 1 / c;
    int exponent;
    bool is_power_of_two = fabs(frexp(c, &exponent)) == 0.5 && isfinite(inverse);
    switch (step->op) {
    case SDF_TAPE_ADD:
        *step = with_constant(SDF_TAPE_ADD_CONSTANT, step->a, c);
        return c == 0;
    case SDF_TAPE_SUBTRACT:
        *step = with_constant(SDF_TAPE_ADD_CONSTANT, step->a, -c);
        return c == 0;
    case SDF_TAPE_MULTIPLY:
        *step = with_constant(SDF_TAPE_MULTIPLY_CONSTANT, step->a, c);
        return c == 1;
    case SDF_TAPE_DIVIDE:
        // Only the inverse of a power of two is exact.
        *step =
            is_power_of_two ? with_constant(SDF_TAPE_MULTIPLY_CONSTANT, step->a, inverse) : *step;
        return c == 1;
    case SDF_TAPE_MINIMUM:
        return c == HUGE_VAL;
    case SDF_TAPE_MAXIMUM:
        return c == -HUGE_VAL;
    default:
        return false;
    }
}

/** @return Whether the first operand, a constant, cannot change the result. */
static bool ignores_first(const SdfTape *tape, const SdfTapeStep *step) {
    double c = is_constant(tape, step->a) ? tape->steps[step->a].constant : 0;
    return (step->op == SDF_TAPE_MINIMUM && c == HUGE_VAL) ||
           (step->op == SDF_TAPE_MAXIMUM && c == -HUGE_VAL);
}

/** Sorts the operands of a sum or a product: a constant is last. */
static void sort_operands(const SdfTape *tape, SdfTapeStep *step) {
    bool is_symmetric = step->op == SDF_TAPE_ADD || step->op == SDF_TAPE_MULTIPLY;
    bool is_swapped = step->a > step->b;
    if (is_constant(tape, step->a) != is_constant(tape, step->b)) {
        is_swapped = is_constant(tape, step->a);
    }
    if (is_symmetric && is_swapped) {
        int a = step->a;
        step->a = step->b;
        step->b = a;
    }
}

int sdf_tape_add(SdfTape *tape, SdfTapeOp op, int a, int b) {
    SdfTapeStep step = {op, a, sdf_tape_operand_count(op) == 2 ? b : a, 0};
    if (is_constant(tape, step.a) && is_constant(tape, step.b)) {
        double x = tape->steps[step.a].constant, y = tape->steps[step.b].constant;
        return sdf_tape_add_constant(
            tape, sdf_tape_step_range(op, (SdfRange){x, x}, (SdfRange){y, y}, 0).low);
    }
    bool is_idempotent = op == SDF_TAPE_MINIMUM || op == SDF_TAPE_MAXIMUM;
    if (is_idempotent && (step.a == step.b || ignores_first(tape, &step))) {
        return step.b;
    }
    if (op == SDF_TAPE_NEGATE && tape->steps[a].op == SDF_TAPE_NEGATE) {
        return tape->steps[a].a;
    }
    sort_operands(tape, &step);
    if (is_constant(tape, step.b) && combine_constant(tape, &step)) {
        return step.a;
    }
    return append_step(tape, step);
}

/* --- the field -------------------------------------------------------------------------------- */

/** Registers while they are assigned. */
typedef struct TapeRegisters {
    int last_use[SDF_TAPE_STEPS_MAXIMUM];    /**< Last step that needs a step; -1: none. */
    int register_of[SDF_TAPE_STEPS_MAXIMUM]; /**< Register of each step. */
    int free[SDF_TAPE_REGISTERS];            /**< Free registers. */
    int free_count;                          /**< Number of #free. */
} TapeRegisters;

/** Finds the last use of each step: from the result backwards, unneeded ones have none. */
static void find_last_uses(const SdfTape *tape, int result, TapeRegisters *registers) {
    for (int i = 0; i < tape->count; i++) {
        registers->last_use[i] = i == result ? INT_MAX : -1;
    }
    for (int i = tape->count - 1; i >= 3; i--) {
        const SdfTapeStep *step = &tape->steps[i];
        if (registers->last_use[i] >= 0 && step->op != SDF_TAPE_CONSTANT) {
            int *a = &registers->last_use[step->a], *b = &registers->last_use[step->b];
            *a = *a < i ? i : *a;
            *b = *b < i ? i : *b;
        }
    }
}

/** Puts the point into the first three registers; all that nobody needs are free. */
static void init_registers(TapeRegisters *registers) {
    for (int i = SDF_TAPE_REGISTERS - 1; i >= 3; i--) {
        registers->free[registers->free_count++] = i;
    }
    for (int axis = 0; axis < 3; axis++) {
        registers->register_of[axis] = axis;
        if (registers->last_use[axis] < 0) {
            registers->free[registers->free_count++] = axis;
        }
    }
}

/** Frees the register of an operand after its last use. */
static void release_operand(TapeRegisters *registers, int operand, int step) {
    if (registers->last_use[operand] == step) {
        registers->last_use[operand] = -1; // Once, if both operands are the same step.
        registers->free[registers->free_count++] = registers->register_of[operand];
    }
}

/** Appends a step to a field. @return false if the registers do not suffice. */
static bool append_node(Sdf *out, const SdfTape *tape, int i, TapeRegisters *registers) {
    const SdfTapeStep *step = &tape->steps[i];
    SdfNode *node = &out->nodes[out->node_count++];
    *node = (SdfNode){.op = SDF_TAPE_STEP};
    node->operands[SDF_STEP_OP] = step->op;
    node->operands[SDF_STEP_CONSTANT] = step->constant;
    if (step->op != SDF_TAPE_CONSTANT) {
        node->operands[SDF_STEP_A] = registers->register_of[step->a];
        node->operands[SDF_STEP_B] = registers->register_of[step->b];
        release_operand(registers, step->a, i);
        release_operand(registers, step->b, i);
    }
    if (registers->free_count == 0) {
        return false;
    }
    registers->register_of[i] = registers->free[--registers->free_count];
    node->operands[SDF_STEP_TO] = registers->register_of[i];
    return true;
}

bool sdf_from_tape(Sdf *out, SdfTape *tape, int result, Error *error) {
    TapeRegisters registers = {.free_count = 0};
    tape->is_open = false;
    find_last_uses(tape, result, &registers);
    init_registers(&registers);
    *out = (Sdf){.bound_slack = 1,
                 .low = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL},
                 .high = {HUGE_VAL, HUGE_VAL, HUGE_VAL},
                 .node_count = 1};
    for (int i = 3; i < tape->count; i++) {
        if (registers.last_use[i] < 0) {
            continue;
        }
        if (!(fabs(tape->steps[i].constant) <= SDF_TAPE_CONSTANT_MAXIMUM)) {
            return error_set(error, STATUS_SCENE,
                             "the function needs the number %g; numbers must be finite and at most "
                             "%g",
                             tape->steps[i].constant, SDF_TAPE_CONSTANT_MAXIMUM);
        }
        if (!append_node(out, tape, i, &registers)) {
            return error_set(error, STATUS_SCENE,
                             "the function needs more than %d numbers at the same time",
                             SDF_TAPE_REGISTERS);
        }
    }
    out->nodes[0] = (SdfNode){.op = SDF_TAPE, .body_count = out->node_count - 1};
    out->nodes[0].operands[SDF_TAPE_FACTOR] = 1;
    out->nodes[0].operands[SDF_TAPE_RESULT] = registers.register_of[result];
    return true;
}

/* --- tapes of another process ----------------------------------------------------------------- */

/** @return Whether a number is an index below a count. */
static bool is_index(double x, int count) {
    return x >= 0 && x < count && x == floor(x);
}

/** @return Whether an operand is a register that is filled. @param is_filled Of each register. */
static bool is_filled_register(double x, const bool *is_filled) {
    return is_index(x, SDF_TAPE_REGISTERS) && is_filled[(int)x];
}

/** @return Whether a node is a valid step. @param[in,out] is_filled Of each register. */
static bool check_step(const SdfNode *node, bool *is_filled) {
    const double *operands = node->operands;
    bool is_valid = node->op == SDF_TAPE_STEP && node->body_count == 0 &&
                    is_index(operands[SDF_STEP_OP], SDF_TAPE_OP_COUNT) &&
                    operands[SDF_STEP_OP] != SDF_TAPE_INPUT &&
                    is_index(operands[SDF_STEP_TO], SDF_TAPE_REGISTERS) &&
                    fabs(operands[SDF_STEP_CONSTANT]) <= SDF_TAPE_CONSTANT_MAXIMUM;
    is_valid = is_valid && is_filled_register(operands[SDF_STEP_A], is_filled) &&
               is_filled_register(operands[SDF_STEP_B], is_filled);
    if (is_valid) {
        is_filled[(int)operands[SDF_STEP_TO]] = true;
    }
    return is_valid;
}

/** @return Whether a tape and its steps are valid. */
static bool check_tape(const SdfNode *tape) {
    double factor = tape->operands[SDF_TAPE_FACTOR];
    bool is_filled[SDF_TAPE_REGISTERS] = {true, true, true};
    bool is_valid = factor > 0 && factor <= SDF_TAPE_CONSTANT_MAXIMUM; // Not for NaN.
    for (int i = 1; is_valid && i <= tape->body_count; i++) {
        is_valid = check_step(&tape[i], is_filled);
    }
    return is_valid && is_filled_register(tape->operands[SDF_TAPE_RESULT], is_filled);
}

/** Operands of the nodes whose counts the engines loop over, see sdf_primitives.c. */
enum { OPERAND_MENGER_ITERATIONS = 1, OPERAND_BULB_POWER = 0, OPERAND_BULB_ITERATIONS = 1 };
/** First of the three operands of a repetition with the neighbours to evaluate, 0 to 2. */
enum { OPERAND_NEIGHBORS = 9, NEIGHBOR_COUNTS = 3 };

/** @return Whether the counts of a node are whole and small. */
static bool check_counts(const SdfNode *node) {
    const double *operands = node->operands;
    bool is_valid = true;
    if (node->op == SDF_MENGER) {
        is_valid = is_index(operands[OPERAND_MENGER_ITERATIONS], SDF_MENGER_ITERATIONS_MAXIMUM + 1);
    } else if (node->op == SDF_MANDELBULB) {
        is_valid = is_index(operands[OPERAND_BULB_POWER], SDF_BULB_POWER_MAXIMUM + 1) &&
                   is_index(operands[OPERAND_BULB_ITERATIONS], SDF_BULB_ITERATIONS_MAXIMUM + 1);
    } else if (node->op == SDF_REPEAT) {
        for (int axis = 0; axis < 3 && is_valid; axis++) {
            is_valid = is_index(operands[OPERAND_NEIGHBORS + axis], NEIGHBOR_COUNTS);
        }
    }
    for (int i = 0; i < SDF_OPERANDS && is_valid; i++) {
        is_valid = !isnan(operands[i]);
    }
    return is_valid;
}

/** @return Whether a node has a body: see #SdfOp. */
static bool has_body(SdfOp op) {
    return op == SDF_TRANSFORM || op == SDF_REPEAT || (op >= SDF_UNION && op <= SDF_DIFFERENCE);
}

/** @return Whether a node changes the result of the nodes before it. */
static bool has_predecessor(SdfOp op) {
    return op == SDF_ROUND || (op >= SDF_UNION && op <= SDF_DIFFERENCE);
}

/** @return Whether nodes and the nodes of their bodies are valid. @param depth Of the bodies. */
static bool check_nodes(const SdfNode *nodes, int count, int depth) {
    bool is_valid = count >= 1 && depth <= SDF_DEPTH_MAXIMUM && !has_predecessor(nodes[0].op);
    for (int i = 0; is_valid && i < count; i += 1 + nodes[i].body_count) {
        const SdfNode *node = &nodes[i];
        is_valid = node->op <= SDF_TAPE && node->body_count >= 0 && node->body_count < count - i &&
                   check_counts(node);
        if (is_valid && node->op == SDF_TAPE) {
            is_valid = check_tape(node);
        } else if (is_valid) {
            is_valid = has_body(node->op) ? check_nodes(node + 1, node->body_count, depth + 1)
                                          : node->body_count == 0;
        }
        if (!is_valid) {
            break;
        }
    }
    return is_valid;
}

bool sdf_check(const Sdf *field) {
    unsigned char is_exact;
    memcpy(&is_exact, &field->is_exact, sizeof is_exact);
    const double box[] = {field->low.x,  field->low.y,  field->low.z,
                          field->high.x, field->high.y, field->high.z};
    bool is_valid = is_exact <= 1 && field->bound_slack >= 1 && isfinite(field->bound_slack) &&
                    field->depth >= 0 && field->depth <= SDF_DEPTH_MAXIMUM &&
                    field->node_count >= 1 && field->node_count <= SDF_NODES_MAXIMUM;
    for (size_t i = 0; i < sizeof box / sizeof *box && is_valid; i++) {
        is_valid = !isnan(box[i]);
    }
    return is_valid && check_nodes(field->nodes, field->node_count, 0);
}
