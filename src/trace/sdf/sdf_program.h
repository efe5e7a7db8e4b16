/**
 * @file
 * @brief Distance fields in the engine's numbers: a tape of steps, each done for LANES points at
 *        once.
 */
#ifndef DIOPTRE_TRACE_SDF_SDF_PROGRAM_H
#define DIOPTRE_TRACE_SDF_SDF_PROGRAM_H

#include "dioptre/sdf.h"
#include "trace/math/vec3.h"

typedef struct SdfVm SdfVm;

/** A step of a tape. */
typedef struct SdfInstruction {
    /** Does it. */
    void (*execute)(SdfVm *machine, const struct SdfInstruction *code);
    int body_count;                /**< How many of the next steps are its body. */
    scalar operands[SDF_OPERANDS]; /**< With what; see #SdfOp. */
} SdfInstruction;

/** What a field says of LANES points. */
typedef struct SdfSample {
    real distance; /**< The distance, or a bound; negative inside. */
    Vec3 gradient; /**< Which way it grows, and how fast; only if asked for. */
} SdfSample;

/** Makes a tape. @param[out] program As many steps as the field has. */
void sdf_compile(SdfInstruction *program, const Sdf *sdf);

/**
 * @return The distances of points.
 * @param active  The lanes that count; of others anything may be said.
 */
real sdf_distance(const SdfInstruction *program, int count, Vec3 point, mask active);

/**
 * @return The distances of points with their derivatives, which are carried along the tape.
 * @param active  The lanes that count; of others anything may be said.
 */
SdfSample sdf_sample(const SdfInstruction *program, int count, Vec3 point, mask active);

#endif
