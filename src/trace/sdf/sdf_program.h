/**
 * @file
 * @brief Programs of distance fields: instructions that are executed for LANES points at once.
 */
#ifndef DIOPTRE_TRACE_SDF_SDF_PROGRAM_H
#define DIOPTRE_TRACE_SDF_SDF_PROGRAM_H

#include "dioptre/sdf.h"
#include "trace/math/vec3.h"

typedef struct SdfVm SdfVm;

/** An instruction. */
typedef struct SdfInstruction {
    /** Executes it. */
    void (*execute)(SdfVm *machine, const struct SdfInstruction *code);
    int body_count;                /**< Number of following instructions that are its body. */
    scalar operands[SDF_OPERANDS]; /**< Operands; see #SdfOp. */
} SdfInstruction;

/** Value of a field at LANES points. */
typedef struct SdfSample {
    real distance; /**< Distance, or a lower bound; negative inside. */
    Vec3 gradient; /**< Gradient, if requested. */
} SdfSample;

/** Translates a field. @param[out] program One instruction per node. */
void sdf_compile(SdfInstruction *program, const Sdf *sdf);

#endif
