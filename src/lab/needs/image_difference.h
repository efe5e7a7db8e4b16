/**
 * @file
 * @brief Compares renders: differences of colour, and rays on other paths.
 *
 * A ray that passes an edge on its other side sees another surface, in any number type. Such a
 * pixel shows another sample of the edge, not a wrong colour. So colours are compared where both
 * rays took the same path; the other rays are counted.
 */
#ifndef DIOPTRE_LAB_NEEDS_IMAGE_DIFFERENCE_H
#define DIOPTRE_LAB_NEEDS_IMAGE_DIFFERENCE_H

#include "base/encoding.h"
#include "lab/needs/sampled_render.h"

/** The least visible difference: half an 8-bit step of the encoded picture. */
#define IMAGE_DIFFERENCE_VISIBLE 0.5

/** How two renders differ. */
typedef struct ImageDifference {
    size_t rays;          /**< Rays compared. */
    size_t same_path;     /**< Rays on the same path. */
    size_t edge_flips;    /**< Rays on another path with a visible difference. */
    size_t visible;       /**< Rays on the same path with a visible difference. */
    double max_steps;     /**< Largest difference on the same path, 8-bit steps. */
    double same_path_rms; /**< RMS difference on the same path, linear light. */
    double total_rms;     /**< RMS difference of all rays, linear light. */
} ImageDifference;

/**
 * Compares two renders.
 * @param b               A render of the same pixels and samples.
 * @param path_reference  Has the paths that the rays of a should take; NULL: all paths are equal.
 * @param encoding        How light is displayed.
 * @return How they differ.
 */
ImageDifference image_difference_of(const SampledRender *a, const SampledRender *b,
                                    const SampledRender *path_reference, Encoding encoding);

/** @return The difference of two colours in 8-bit steps, in the channel where it is largest. */
double image_difference_steps(const double a[3], const double b[3], Encoding encoding);

#endif
