/**
 * @file
 * @brief How two shots of the same pixels differ: in colour, and in what their rays met.
 *
 * A ray that passes an edge on its other side sees something else, in any number type: such a pixel
 * is another picture of the edge, not a wrong colour. So colours are compared where both rays took
 * the same way; the others are counted.
 */
#ifndef DIOPTRE_LAB_CONTRAST_H
#define DIOPTRE_LAB_CONTRAST_H

#include "dioptre/encoding.h"
#include "lab/shot.h"

/** Half an 8-bit step of the encoded picture: less than this, nobody can tell. */
#define CONTRAST_VISIBLE 0.5

/** How two shots differ. */
typedef struct Contrast {
    size_t rays;  /**< How many were compared. */
    size_t equal; /**< How many took the same way. */
    size_t flips; /**< How many took another, and show it by half a step or more. */
    size_t off;   /**< How many took the same way and are off by half a step or more. */
    double worst; /**< Largest difference on the same way, steps. */
    double mean;  /**< Root of the mean square of it, linear light. */
    double whole; /**< The same of all rays, edges too. */
} Contrast;

/**
 * Compares two shots.
 * @param a         A shot.
 * @param b         Another, of the same pixels and samples.
 * @param trails    Whose trails stand for the second's: a shot of the same pixels and samples that
 *                  takes the ways that those of \p a should; NULL: rays are taken to be the same.
 * @param encoding  How their light is shown.
 * @return How they differ.
 */
Contrast contrast_of(const Shot *a, const Shot *b, const Shot *trails, Encoding encoding);

/** @return By how many steps two colours differ, in the primary where they differ most.
 *  @param a Linear light. @param b Linear light. @param encoding How it is shown. */
double contrast_steps(const double a[3], const double b[3], Encoding encoding);

#endif
