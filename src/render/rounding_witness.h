/**
 * @file
 * @brief Rounding as a witness: the same rays, while the processor rounds in another direction.
 *
 * A number that hangs on its last bits changes when all roundings are turned (Kahan, *How Futile
 * are Mindless Assessments of Roundoff in Floating-Point Computation?*, 2006). No reference is
 * needed. Errors that are the same in all directions stay hidden: doc/laboratory.md has an example.
 *
 * The direction belongs to a thread. It is set around a call of the engine's vtable, which is in
 * another translation unit: the compiler cannot move arithmetic of the engine across it. Constants
 * are folded with rounding to nearest, which is wanted: the scene stays the same. No
 * -frounding-math is needed, therefore. Quad, which is computed in software, rounds in the same
 * direction (libgcc and the C library ask the processor for it).
 */
#ifndef DIOPTRE_RENDER_ROUNDING_WITNESS_H
#define DIOPTRE_RENDER_ROUNDING_WITNESS_H

#include "dioptre/engine.h"

/** The directions in which a processor can round. */
typedef enum RoundingDirection {
    ROUNDING_NEAREST,         /**< To the nearest number, as everywhere else. */
    ROUNDING_UPWARD,          /**< Towards plus infinity. */
    ROUNDING_DOWNWARD,        /**< Towards minus infinity. */
    ROUNDING_TOWARD_ZERO,     /**< Towards zero. */
    ROUNDING_DIRECTION_COUNT, /**< Number of directions. */
} RoundingDirection;

/** @return Whether the processor can round in all directions. */
bool rounding_is_supported(void);

/**
 * Traces pixels while the processor rounds in one direction. The calling thread gets its own
 * direction back.
 * @param direction  The direction.
 * @param tracer     See #Engine.trace, as for the others.
 * @return false if the processor cannot round so; nothing is traced then.
 */
bool trace_rounded(const Engine *engine, RoundingDirection direction, const Tracer *tracer,
                   const PixelGrid *grid, double *rgb, RayCounts *counts);

#endif
