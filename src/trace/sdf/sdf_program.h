/**
 * @file
 * @brief Programs of distance fields: instructions that are executed for LANES points at once.
 */
#ifndef DIOPTRE_TRACE_SDF_SDF_PROGRAM_H
#define DIOPTRE_TRACE_SDF_SDF_PROGRAM_H

#include "dioptre/sdf.h"
#include "trace/math/vec3.h"

typedef struct SdfVm SdfVm;
typedef struct SdfUnionPack SdfUnionPack;
typedef struct TapeOctree TapeOctree;

/** An instruction. */
typedef struct SdfInstruction {
    /** Executes it. */
    void (*execute)(SdfVm *machine, const struct SdfInstruction *code);
    int body_count;           /**< Number of following instructions that are its body. */
    int pack_count;           /**< Number of #packs; only of a run of unions. */
    const TapeOctree *octree; /**< Where a tape is shorter; NULL: nowhere. Not owned, in the memory
                                 of the program. */
    union {
        scalar operands[SDF_OPERANDS]; /**< Operands; see #SdfOp. */
        const SdfUnionPack *packs; /**< The boxes of a run of unions; not owned, in the memory of
                                      the program. */
    };
} SdfInstruction;

/** A program. */
typedef struct SdfProgram {
    SdfInstruction *instructions; /**< Its instructions. */
    int count;                    /**< Number of them. */
} SdfProgram;

/** Value of a field at LANES points. */
typedef struct SdfSample {
    real distance; /**< Distance, or a lower bound; negative inside. */
    Vec3 gradient; /**< Gradient, if requested. */
} SdfSample;

/** @return Bytes that suffice for the program of a field. */
size_t sdf_program_size(const Sdf *sdf);

/**
 * Translates nodes of a field.
 * @param memory  #sdf_program_size bytes, aligned to #SHAPE_ALIGNMENT.
 * @param nodes   The nodes.
 * @param count   Number of nodes.
 * @return The program, in the memory.
 */
SdfProgram sdf_compile(void *memory, const SdfNode *nodes, int count);

#endif
