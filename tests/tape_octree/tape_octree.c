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

/** A tape that is being written: no register is written twice. */
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
        const bool has_one = step_operands(op) < 2 || is_square;
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

/** Compares a program with its whole tape at random points. */
static void compare(const SdfProgram *program, uint64_t *seed, OctreeFinding *finding) {
    const SdfInstruction *instruction = program->instructions;
    const Tape whole = tape_of(instruction);
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
        uint64_t steps = 0;
        const real distance = sdf_distance_counted(program, p, active, &steps);
        const SdfSample sample = sdf_sample(program, p, active), plain = tape_sample(whole, p);
        finding->steps += steps - 1;
        finding->whole_steps += whole.count;
        finding->point = i;
        finding->fault = !are_same(distance, tape_value(whole, p), lanes) ? "a distance"
                         : !are_same(sample.distance, plain.distance, lanes)
                             ? "a distance with gradient"
                         : !are_same(sample.gradient.x, plain.gradient.x, lanes) ||
                                 !are_same(sample.gradient.y, plain.gradient.y, lanes) ||
                                 !are_same(sample.gradient.z, plain.gradient.z, lanes)
                             ? "a gradient"
                             : NULL;
    }
}

/** See #OctreeChecks.run. */
static OctreeFinding check_tape(uint64_t seed, int balls) {
    OctreeFinding finding = {NULL, 0, 0, 0, 0};
    Sdf *sdf = calloc(1, sdf_size(STEPS_MAXIMUM + 1));
    TapeWriter writer = {.nodes = sdf->nodes, .to = INPUTS};
    if (balls > 0) {
        write_balls(&writer, &seed, balls);
    } else {
        write_operations(&writer, &seed);
    }
    SdfNode *tape = sdf->nodes;
    *tape = (SdfNode){.op = SDF_TAPE, .body_count = writer.count};
    tape->operands[SDF_TAPE_FACTOR] = 1;
    tape->operands[SDF_TAPE_RESULT] = writer.last;
    for (int axis = 0; axis < 3; axis++) {
        tape->operands[SDF_TAPE_BOX + axis] = -1;
        tape->operands[SDF_TAPE_BOX + 3 + axis] = 1;
    }
    sdf->node_count = 1 + writer.count;
    const CompiledSdf compiled = compile_sdf(sdf);
    const TapeOctree *octree = compiled.program.instructions->octree;
    finding.cells = octree ? octree->cell_count : 0;
    compare(&compiled.program, &seed, &finding);
    free(compiled.memory);
    free(sdf);
    return finding;
}

extern const OctreeChecks CHECKS;
const OctreeChecks CHECKS = {check_tape};
