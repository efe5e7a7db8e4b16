/**
 * @file
 * @brief Programs of distance fields, for tests that contain the machine that executes them.
 */
#ifndef TESTS_SDF_COMPILED_H
#define TESTS_SDF_COMPILED_H

#include "../src/trace/sdf/sdf_mandelbulb.c"
#include "../src/trace/sdf/sdf_program.c"
#include "../src/trace/sdf/sdf_solids.c"
#include "../src/trace/sdf/sdf_tape.c"
#include "../src/trace/sdf/sdf_union.c"
#include "../src/trace/sdf/sdf_vm.c"
#include "../src/trace/sdf/tape_octree.c"

#include <stdlib.h>

/** A program with its memory. */
typedef struct CompiledSdf {
    void *memory;       /**< Memory of the program; owned. */
    SdfProgram program; /**< The program. */
} CompiledSdf;

/** @return Memory for the program of a field; the caller frees it. */
static inline void *allocate_program(const Sdf *field) {
    size_t blocks = sdf_program_size(field) / SHAPE_ALIGNMENT + 1;
    return aligned_alloc(SHAPE_ALIGNMENT, blocks * SHAPE_ALIGNMENT);
}

/** @return The program of a field; the caller frees its memory. */
static inline CompiledSdf compile_sdf(const Sdf *field) {
    void *memory = allocate_program(field);
    return (CompiledSdf){memory, sdf_compile(memory, field->nodes, field->node_count)};
}

#endif
