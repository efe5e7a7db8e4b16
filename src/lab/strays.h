/**
 * @file
 * @brief Rays that are lost: what they saw is not there, not even a little beside.
 */
#ifndef DIOPTRE_LAB_STRAYS_H
#define DIOPTRE_LAB_STRAYS_H

#include "lab/contrast.h"

/** Pixels that the eye may be turned aside: an edge that is moved by so little, nobody sees. */
#define STRAYS_NUDGE (1.0 / 64)

/**
 * Counts the rays that took another way than they should, show it by half a step or more, and would
 * not have taken it, nor seen that colour, had the eye been turned a little to any side.
 * @param studio      What was shot.
 * @param reference   How it was shot as it should be.
 * @param truth       That shot.
 * @param shot        The shot whose rays are looked at.
 * @param[out] strays How many.
 * @param[out] error  What is wrong.
 * @return false if anything is.
 */
bool strays_count(const Studio *studio, const Manner *reference, const Shot *truth,
                  const Shot *shot, size_t *strays, Error *error);

#endif
