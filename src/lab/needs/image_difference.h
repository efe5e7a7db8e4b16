/**
 * @file
 * @brief How two shots of the same pixels differ: in colour, and in what their rays met.
 *
 * A ray that passes an edge on its other side sees something else, in any number type: such a pixel
 * is another picture of the edge, not a wrong colour. So colours are compared where both rays took
 * the same way; the others are counted.
 */
#ifndef DIOPTRE_LAB_NEEDS_IMAGE_DIFFERENCE_H
#define DIOPTRE_LAB_NEEDS_IMAGE_DIFFERENCE_H

#include "dioptre/encoding.h"
#include "lab/needs/sampled_render.h"

/** Half an 8-bit step of the encoded picture: less than this, nobody can tell. */
#define IMAGE_DIFFERENCE_VISIBLE 0.5

/** How two shots differ. */
typedef struct ImageDifference {
    size_t rays;          /**< How many were compared. */
    size_t same_path;     /**< How many took the same way. */
    size_t edge_flips;    /**< How many took another, and show it by half a step or more. */
    size_t visible;       /**< How many took the same way and are off by half a step or more. */
    double max_steps;     /**< Largest difference on the same way, steps. */
    double same_path_rms; /**< Root of the mean square of it, linear light. */
    double total_rms;     /**< The same of all rays, edges too. */
} ImageDifference;

/**
 * Compares two shots.
 * @param b  Another, of the same pixels and samples.
 * @param path_reference  Whose trails stand for the second's: a shot of the same pixels and samples
 *         that takes the ways that those of \p a should; NULL: rays are taken to be the same.
 * @param encoding  How their light is shown.
 * @return How they differ.
 */
ImageDifference image_difference_of(const SampledRender *a, const SampledRender *b,
                                    const SampledRender *path_reference, Encoding encoding);

/**
 * @return By how many steps two colours differ, in the primary where they differ most.
 * @param encoding  How it is shown.
 */
double image_difference_steps(const double a[3], const double b[3], Encoding encoding);

#endif
