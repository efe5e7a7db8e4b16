/**
 * @file
 * @brief Octrees of tapes, checked at one number type and width: the Makefile compiles this file
 * for each engine, with the engine's flags.
 */
#include "tape_octree.h"

#include "../sdf_compiled.h"

/** Most steps of a test tape. */
enum { STEPS_MAXIMUM = 1000 };
/** Vectors of points per tape. */
enum { POINT_VECTORS = 400 / LANES };

/** The next of a sequence of random numbers (Knuth's linear congruential generator). @return Below
 *  a limit. */
static unsigned random_below(uint64_t *state, unsigned limit) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (unsigned)(*state >> 33) % limit;
}

/** @return A random corner of a cell along an axis. */
static double random_corner(uint64_t *state) {
    const double half = 1 + 2 * (double)OCTREE_MARGIN;
    return half * ((int)random_below(state, 17) - 8) / 8;
}

/** @return A random constant: a corner of a cell, where two operands may be equal; 0; a large one.
 */
static double random_constant(uint64_t *state) {
    const unsigned kind = random_below(state, 16);
    return kind == 0 ? 0 : kind == 1 ? SDF_TAPE_CONSTANT_MAXIMUM : random_corner(state);
}

/** A tape that is being written: its registers are taken in turn. */
typedef struct TapeWriter {
    SdfNode *nodes; /**< Its node, and its steps. */
    int count;      /**< Number of steps. */
    int last;       /**< Register of the last result. */
    int to;         /**< Next register. */
} TapeWriter;

/** Adds a step. @return Register of its result. */
static int add_step(TapeWriter *writer, SdfTapeOp op, int a, int b, double constant) {
    SdfNode *node = &writer->nodes[++writer->count];
    *node = (SdfNode){.op = SDF_TAPE_STEP};
    node->operands[SDF_STEP_OP] = op;
    node->operands[SDF_STEP_TO] = writer->to;
    node->operands[SDF_STEP_A] = a;
    node->operands[SDF_STEP_B] = b;
    node->operands[SDF_STEP_CONSTANT] = constant;
    writer->last = writer->to;
    writer->to = writer->to + 1 < SDF_TAPE_REGISTERS ? writer->to + 1 : INPUTS;
    return writer->last;
}

/** Writes random operations on what was computed lately. */
static void write_operations(TapeWriter *writer, uint64_t *seed) {
    const int steps = 60 + (int)random_below(seed, 400);
    for (int i = 0; i < steps; i++) {
        const int known = i + INPUTS < 200 ? i + INPUTS : 200;
        int operands[2];
        for (int k = 0; k < 2; k++) {
            const int back = 1 + (int)random_below(seed, (unsigned)known);
            // Of the registers that were written, counted back from the newest one.
            operands[k] = i + INPUTS - back < INPUTS
                              ? i + INPUTS - back
                              : INPUTS + (i - back) % (SDF_TAPE_REGISTERS - INPUTS);
        }
        SdfTapeOp op =
            SDF_TAPE_CONSTANT + random_below(seed, SDF_TAPE_OP_COUNT - SDF_TAPE_CONSTANT);
        if (random_below(seed, 3) == 0) {
            op = random_below(seed, 2) ? SDF_TAPE_MINIMUM : SDF_TAPE_MAXIMUM;
        } else if (random_below(seed, 6) == 0) {
            op = SDF_TAPE_DIVIDE;
        }
        const bool is_square = op == SDF_TAPE_MULTIPLY && random_below(seed, 2);
        const bool has_one = sdf_tape_operand_count(op) < 2 || is_square;
        add_step(writer, op, operands[0], has_one ? operands[0] : operands[1],
                 random_constant(seed));
    }
}

/** Writes a union of balls. */
static void write_balls(TapeWriter *writer, uint64_t *seed, int balls) {
    int result = -1;
    for (int i = 0; i < balls; i++) {
        int squares[3];
        for (int axis = 0; axis < 3; axis++) {
            int part = add_step(writer, SDF_TAPE_ADD_CONSTANT, axis, axis,
                                (int)random_below(seed, 2001) / 1000.0 - 1);
            squares[axis] = add_step(writer, SDF_TAPE_MULTIPLY, part, part, 0);
        }
        int sum = add_step(writer, SDF_TAPE_ADD, squares[0], squares[1], 0);
        sum = add_step(writer, SDF_TAPE_ADD, sum, squares[2], 0);
        int root = add_step(writer, SDF_TAPE_SQUARE_ROOT, sum, sum, 0);
        int ball = add_step(writer, SDF_TAPE_ADD_CONSTANT, root, root, -0.1);
        result = result < 0 ? ball : add_step(writer, SDF_TAPE_MINIMUM, result, ball, 0);
    }
}

/** @return A random coordinate: in the box, on the border of a cell, outside, or none. */
static scalar random_coordinate(uint64_t *seed) {
    const unsigned kind = random_below(seed, 64);
    return kind == 0   ? (scalar)NAN
           : kind == 1 ? (scalar)(2 * random_corner(seed))
           : kind < 16 ? (scalar)random_corner(seed)
                       : (scalar)((int)random_below(seed, 2000001) - 1000000) / 1000000;
}

/** @return Whether two numbers have the same bits, or both are NaN: which NaN is not promised. */
static bool is_same(scalar a, scalar b) {
    return memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b);
}

/** @return Whether active lanes have the same bits. */
static bool are_same(real a, real b, unsigned lanes) {
    bool is_equal = true;
    for (int lane = 0; lane < LANES; lane++) {
        is_equal =
            is_equal && (!(lanes >> lane & 1) || is_same(real_lane(a, lane), real_lane(b, lane)));
    }
    return is_equal;
}

/** Compares two programs of the same field at random points; in some, numbers round upwards, where
 *  whole tapes are evaluated. @param plain The one without octrees. */
static void compare(const SdfProgram *program, const SdfProgram *plain, uint64_t *seed,
                    OctreeFinding *finding) {
    for (int i = 0; i < POINT_VECTORS && !finding->fault; i++) {
        Vec3 p;
        const scalar spreads[] = {0, (scalar)0.02f, (scalar)0.25f};
        const scalar spread = spreads[random_below(seed, 3)];
        const scalar middle[3] = {random_coordinate(seed), random_coordinate(seed),
                                  random_coordinate(seed)};
        for (int lane = 0; lane < LANES; lane++) {
            real_set_lane(&p.x, lane, middle[0] + spread * random_coordinate(seed));
            real_set_lane(&p.y, lane, middle[1] + spread * random_coordinate(seed));
            real_set_lane(&p.z, lane, middle[2] + spread * random_coordinate(seed));
        }
        const unsigned lanes = LANES == 1 ? 1 : random_below(seed, ALL_LANES + 1);
        const mask active = mask_of_bits(lanes);
        const bool is_upward = random_below(seed, 8) == 0;
        uint64_t steps = 0, whole_steps = 0;
        fesetround(is_upward ? FE_UPWARD : FE_TONEAREST);
        const real distance = sdf_distance_counted(program, p, active, &steps),
                   whole = sdf_distance_counted(plain, p, active, &whole_steps);
        const SdfSample a = sdf_sample(program, p, active), b = sdf_sample(plain, p, active);
        fesetround(FE_TONEAREST);
        finding->steps += is_upward ? 0 : steps;
        finding->whole_steps += is_upward ? 0 : whole_steps;
        finding->point = i;
        finding->fault = !are_same(distance, whole, lanes)          ? "a distance"
                         : !are_same(a.distance, b.distance, lanes) ? "a distance with gradient"
                         : !are_same(a.gradient.x, b.gradient.x, lanes) ||
                                 !are_same(a.gradient.y, b.gradient.y, lanes) ||
                                 !are_same(a.gradient.z, b.gradient.z, lanes)
                             ? "a gradient"
                         : is_upward && lanes && steps < whole_steps ? "a shorter tape"
                                                                     : NULL;
    }
}

/** Writes the node of a tape in front of its steps. @param half Half the edge of its box. @return
 *  The node behind it. */
static SdfNode *end_tape(const TapeWriter *writer, double factor, bool clamps, double half) {
    SdfNode *tape = writer->nodes;
    *tape = (SdfNode){.op = SDF_TAPE, .body_count = writer->count};
    tape->operands[SDF_TAPE_FACTOR] = factor;
    tape->operands[SDF_TAPE_RESULT] = writer->last;
    tape->operands[SDF_TAPE_CLAMPS] = clamps;
    for (int axis = 0; axis < 3; axis++) {
        tape->operands[SDF_TAPE_BOX + axis] = -half;
        tape->operands[SDF_TAPE_BOX + 3 + axis] = half;
    }
    return tape + 1 + writer->count;
}

/** Writes a tape. @return The node behind it. See #OctreeChecks.run. */
static SdfNode *write_tape(SdfNode *nodes, uint64_t *seed, int balls, double factor, bool clamps) {
    TapeWriter writer = {.nodes = nodes, .to = INPUTS};
    if (balls > 0) {
        write_balls(&writer, seed, balls);
    } else {
        write_operations(&writer, seed);
    }
    return end_tape(&writer, factor, clamps, 1);
}

/** Takes the octrees of both tapes away. */
static void remove_octrees(const SdfProgram *program) {
    SdfInstruction *first = program->instructions, *intersection = first + 1 + first->body_count;
    first->octree = intersection[1].octree = NULL;
}

/** See #OctreeChecks.run. */
static OctreeFinding check_tapes(uint64_t seed, int balls) {
    OctreeFinding finding = {NULL, 0, 0, 0, 0};
    Sdf *sdf = calloc(1, sdf_size(2 * STEPS_MAXIMUM + 3));
    SdfNode *intersection = write_tape(sdf->nodes, &seed, balls, 1, false);
    SdfNode *end = write_tape(intersection + 1, &seed, balls, 0.25, true);
    *intersection = (SdfNode){.op = SDF_INTERSECTION, .body_count = (int)(end - intersection) - 1};
    sdf->node_count = (int)(end - sdf->nodes);
    const CompiledSdf compiled = compile_sdf(sdf), plain = compile_sdf(sdf);
    const TapeOctree *octree = compiled.program.instructions->octree;
    finding.cells = octree ? octree->cell_count : 0;
    remove_octrees(&plain.program);
    compare(&compiled.program, &plain.program, &seed, &finding);
    free(compiled.memory);
    free(plain.memory);
    free(sdf);
    return finding;
}

/** Writes minima of square roots of -1. */
static void write_unknown(TapeWriter *writer) {
    int result = 0;
    for (int i = 0; i < 70; i++) {
        int negative = add_step(writer, SDF_TAPE_CONSTANT, 0, 0, -1);
        int root = add_step(writer, SDF_TAPE_SQUARE_ROOT, negative, negative, 0);
        result = add_step(writer, SDF_TAPE_MINIMUM, result, root, 0);
    }
}

/** See #OctreeChecks.cells. */
static unsigned count_cells(OctreeRefusal refusal) {
    uint64_t seed = 1;
    Sdf *sdf = calloc(1, sdf_size(STEPS_MAXIMUM + 1));
    TapeWriter writer = {.nodes = sdf->nodes, .to = INPUTS};
    if (refusal == OCTREE_UNKNOWN) {
        write_unknown(&writer);
    } else {
        write_balls(&writer, &seed, 70);
    }
    // 1e39 is finite in double alone.
    const SdfNode *end = end_tape(&writer, 1, false, refusal == OCTREE_HUGE_BOX ? 1e39 : 1);
    sdf->node_count = (int)(end - sdf->nodes);
    const CompiledSdf compiled = compile_sdf(sdf);
    const TapeOctree *octree = compiled.program.instructions->octree;
    const unsigned cells = octree ? octree->cell_count : 0;
    free(compiled.memory);
    free(sdf);
    return cells;
}

extern const OctreeChecks CHECKS;
const OctreeChecks CHECKS = {check_tapes, count_cells};
