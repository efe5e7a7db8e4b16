/**
 * @file
 * @brief Filters: what transparent shapes let through of a lamp's light.
 */
#ifndef DIOPTRE_TRACE_FILTER_H
#define DIOPTRE_TRACE_FILTER_H

#include "trace/lighting.h"

/**
 * Finds what is left of a lamp's light behind the transparent shapes in its way: the product of the
 * shares that the surfaces let through which it crosses, without being bent. Surfaces that a later
 * transparent shape hides are not there.
 * @param list       All shapes.
 * @param departure  How rays leave a surface.
 * @param met        The points that the rays come from.
 * @param shadow     The rays to the lamp.
 * @param[in,out] blocked  The rays that an opaque shape is in the way of; then all that get
 * nothing.
 * @param[out] visible     The share that is left, for each vector of rays.
 */
void filter_shadows(const ShapeList *list, const Departure *departure, const Encounter *met,
                    const Packet *shadow, mask *blocked, Light3 *visible);

#endif
