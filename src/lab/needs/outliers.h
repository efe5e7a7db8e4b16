/**
 * @file
 * @brief Rays that are lost: what they saw is not there, not even a little beside.
 */
#ifndef DIOPTRE_LAB_NEEDS_OUTLIERS_H
#define DIOPTRE_LAB_NEEDS_OUTLIERS_H

#include "lab/needs/image_difference.h"

/** Pixels that the eye may be turned aside: an edge that is moved by so little, nobody sees. */
#define OUTLIER_CAMERA_SHIFT (1.0 / 64)

/**
 * Counts the rays that took another way than they should, show it by half a step or more, and would
 * not have taken it, nor seen that colour, had the eye been turned a little to any side.
 * @param reference  How it was shot as it should be.
 * @param render  The shot whose rays are looked at.
 * @return false if anything is.
 */
bool outliers_count(const RenderContext *render_context, const Variant *reference,
                    const SampledRender *reference_render, const SampledRender *render,
                    size_t *outliers, Error *error);

#endif
