/**
 * @file
 * @brief Programs of distance fields: their instructions, made of the nodes of a field.
 */
#include "trace/sdf/sdf_union.h"
#include "trace/sdf/sdf_vm.h"
#include "trace/sdf/tape_octree.h"
#include "trace/shapes/shape.h"

/** Smallest number of parts of a run: with fewer it saves no time (measured). */
enum { UNION_RUN_MINIMUM = 8 };

/** A program that is being made. */
typedef struct ProgramWriter {
    SdfUnionPack *packs;          /**< The next pack. */
    SdfInstruction *instructions; /**< The next instruction. */
    char *octrees;                /**< The next octree of a tape. */
} ProgramWriter;

/** @return The node behind a node and its body. */
static const SdfNode *node_next(const SdfNode *node) {
    return node + 1 + node->body_count;
}

/** @return Number of unions that follow one another, up to the longest run. @param end End of the
 *  nodes. */
static int union_run_length(const SdfNode *first, const SdfNode *end) {
    int length = 0;
    for (const SdfNode *node = first;
         node < end && node->op == SDF_UNION && length < SDF_UNION_RUN_PARTS;
         node = node_next(node)) {
        length++;
    }
    return length;
}

/** The size of a program, at most. */
typedef struct ProgramSize {
    size_t packs;        /**< Number of packs. */
    size_t instructions; /**< Number of instructions. */
    size_t octrees;      /**< Bytes of the octrees of tapes. */
} ProgramSize;

/** @return The size of the program of some nodes. */
static ProgramSize program_size_of(const SdfNode *nodes, int count) {
    size_t unions = 0, octrees = 0;
    for (int i = 0; i < count; i++) {
        unions += nodes[i].op == SDF_UNION;
        octrees += nodes[i].op == SDF_TAPE ? tape_octree_size(&nodes[i]) : 0;
    }
    // The last pack of each run may have one part only.
    size_t runs = unions / UNION_RUN_MINIMUM;
    return (ProgramSize){runs + aabb_pack_count(unions), runs + (size_t)count, octrees};
}

/** @return Where the octrees begin in the memory of a program: behind packs and instructions. */
static size_t program_octrees_offset(const ProgramSize *size) {
    size_t end = size->packs * sizeof(SdfUnionPack) + size->instructions * sizeof(SdfInstruction);
    return shape_aligned_size(end);
}

size_t sdf_program_size(const Sdf *sdf) {
    ProgramSize size = program_size_of(sdf->nodes, sdf->node_count);
    return program_octrees_offset(&size) + size.octrees;
}

static void program_write_nodes(ProgramWriter *writer, const SdfNode *first, const SdfNode *end);

/** Writes the instruction of a node, and its body. */
static void program_write_node(ProgramWriter *writer, const SdfNode *node) {
    static void (*const handlers[])(SdfVm *, const SdfInstruction *) = {
        [SDF_SPHERE] = sdf_op_sphere,
        [SDF_BOX] = sdf_op_box,
        [SDF_BOX_FRAME] = sdf_op_box_frame,
        [SDF_TORUS] = sdf_op_torus,
        [SDF_MENGER] = sdf_op_menger,
        [SDF_MANDELBULB] = sdf_op_mandelbulb,
        [SDF_ROUND] = sdf_op_round,
        [SDF_TRANSFORM] = sdf_op_transform,
        [SDF_REPEAT] = sdf_op_repeat,
        [SDF_UNION] = sdf_op_union,
        [SDF_SMOOTH_UNION] = sdf_op_smooth_union,
        [SDF_INTERSECTION] = sdf_op_intersection,
        [SDF_DIFFERENCE] = sdf_op_difference,
        [SDF_TAPE] = sdf_op_tape};
    SdfInstruction *instruction = writer->instructions++;
    instruction->execute = handlers[node->op];
    instruction->octree = NULL;
    for (int n = 0; n < SDF_OPERANDS; n++) {
        instruction->operands[n] = (scalar)node->operands[n];
    }
    if (node->op == SDF_TAPE) {
        sdf_tape_compile(writer->instructions, node);
        writer->instructions += node->body_count;
    } else {
        program_write_nodes(writer, node + 1, node_next(node));
    }
    instruction->body_count = (int)(writer->instructions - instruction) - 1;
    const size_t octree_size = node->op == SDF_TAPE ? tape_octree_size(node) : 0;
    if (octree_size > 0) {
        instruction->octree = tape_octree_build(writer->octrees, instruction);
        writer->octrees += octree_size;
    }
}

/** Writes a run of unions: an instruction whose body they are. @param length Number of parts.
 * @return The node behind them. */
static const SdfNode *program_write_union_run(ProgramWriter *writer, const SdfNode *node,
                                              int length) {
    SdfInstruction *run = writer->instructions++;
    SdfUnionPack *packs = writer->packs;
    run->execute = sdf_op_union_run;
    run->packs = packs;
    run->pack_count = (int)aabb_pack_count((size_t)length);
    writer->packs += run->pack_count;
    for (int k = 0; k < run->pack_count; k++) {
        sdf_union_pack_clear(&packs[k]);
    }
    for (int i = 0; i < length; i++) {
        const SdfInstruction *part = writer->instructions;
        program_write_node(writer, node);
        sdf_union_pack_add(&packs[i / AABB_PACK_SIZE], i % AABB_PACK_SIZE, part);
        node = node_next(node);
    }
    run->body_count = (int)(writer->instructions - run) - 1;
    return node;
}

/** Writes nodes that follow one another. */
static void program_write_nodes(ProgramWriter *writer, const SdfNode *first, const SdfNode *end) {
    const SdfNode *node = first;
    while (node < end) {
        int length = union_run_length(node, end);
        if (length >= UNION_RUN_MINIMUM) {
            node = program_write_union_run(writer, node, length);
        } else {
            program_write_node(writer, node);
            node = node_next(node);
        }
    }
}

SdfProgram sdf_compile(void *memory, const SdfNode *nodes, int count) {
    const ProgramSize size = program_size_of(nodes, count);
    SdfUnionPack *packs = memory;
    SdfInstruction *instructions = (SdfInstruction *)(packs + size.packs);
    ProgramWriter writer = {packs, instructions, (char *)memory + program_octrees_offset(&size)};
    program_write_nodes(&writer, nodes, nodes + count);
    return (SdfProgram){instructions, (int)(writer.instructions - instructions)};
}
