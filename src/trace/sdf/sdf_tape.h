/**
 * @file
 * @brief Tapes as engines evaluate them: steps on LANES numbers, see dioptre/sdf_tape.h.
 */
#ifndef DIOPTRE_TRACE_SDF_SDF_TAPE_H
#define DIOPTRE_TRACE_SDF_SDF_TAPE_H

#include "dioptre/sdf_tape.h"
#include "trace/sdf/sdf_vm.h"

/** A step as a tape uses it. A shorter tape uses some steps of the whole one, with other registers.
 */
typedef struct TapeUse {
    uint16_t step; /**< Index in #Tape.steps. */
    uint16_t to;   /**< Register of the result. */
    uint16_t a;    /**< Register of the first operand. */
    uint16_t b;    /**< Register of the second operand; #a if there is one operand. */
} TapeUse;

/** A step of a tape. */
typedef struct TapeStep {
    /** Executes it. @param use Its registers. */
    void (*run)(real *registers, const TapeUse *use, const struct TapeStep *step);
    TapeUse use;     /**< Its registers in the whole tape. */
    scalar constant; /**< Constant. */
    SdfTapeOp op;    /**< Operation. */
} TapeStep;

_Static_assert(sizeof(TapeStep) <= sizeof(SdfInstruction),
               "the steps of a tape lie in the instructions of its body");

/** A tape. */
typedef struct Tape {
    const TapeStep *steps; /**< The steps of the whole tape; not owned. */
    const TapeUse *uses;   /**< The steps that are executed, in their order; not owned. NULL: all
                                  of them. */
    uint16_t count;        /**< Number of these. */
    uint16_t result;       /**< Register of the result. */
} Tape;

/** @return The whole tape of an instruction. */
INLINE Tape tape_of(const SdfInstruction *instruction) {
    return (Tape){.steps = (const TapeStep *)(instruction + 1),
                  .count = (uint16_t)instruction->body_count,
                  .result = (uint16_t)instruction->operands[SDF_TAPE_RESULT]};
}

/** @return The registers of a step that is executed. @param i Its index among these. */
INLINE const TapeUse *tape_use(const Tape *tape, int i) {
    return tape->uses ? &tape->uses[i] : &tape->steps[i].use;
}

/** @return The step that is executed there. @param i See #tape_use. */
INLINE const TapeStep *tape_step(const Tape *tape, int i) {
    return &tape->steps[tape->uses ? tape->uses[i].step : i];
}

#endif
