/**
 * @file
 * @brief Filters: what transparent shapes let through of a lamp's light.
 */
#ifndef DIOPTRE_TRACE_FILTER_H
#define DIOPTRE_TRACE_FILTER_H

#include "trace/departure.h"
#include "trace/materials.h"

/**
 * Finds what is left of a lamp's light behind what stands in its way: the product of the shares
 * that the surfaces let through which it crosses, without being bent; nothing behind opaque ones.
 * @param surfaces   All materials.
 * @param list       The shapes.
 * @param departure  How rays leave a surface.
 * @param shadow     The rays to the lamp.
 * @param[in,out] blocked  The rays that anything is in the way of; then those that get nothing.
 * @param[out] visible     The share that is left, for each vector of rays.
 */
void filter_shadows(const Surface *surfaces, const ShapeList *list, const Departure *departure,
                    const Packet *shadow, mask *blocked, Light3 *visible);

#endif
