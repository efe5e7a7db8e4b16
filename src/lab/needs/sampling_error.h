/**
 * @file
 * @brief How smooth edges and soft shadows are with so many rays a pixel.
 */
#ifndef DIOPTRE_LAB_NEEDS_SAMPLING_ERROR_H
#define DIOPTRE_LAB_NEEDS_SAMPLING_ERROR_H

#include "lab/needs/image_difference.h"

/** What some samples leave. */
typedef struct SamplingError {
    int samples;     /**< Rays a pixel. */
    double rms;      /**< By how many steps pixels change with four times as many: root of the mean
                          square of those that change by half a step or more. */
    double fraction; /**< Share of the pixels that do. */
} SamplingError;

/**
 * Looks what the samples of a manner leave against four times as many; where half as many leave
 * nothing, those are enough, and so on.
 * @param variant  How; #TraceSettings.samples are wanted.
 * @return false if anything is.
 */
bool sampling_error_measure(const RenderContext *render_context, const Variant *variant,
                            SamplingError *sampling_error, Error *error);

#endif
