/**
 * @file
 * @brief The materials of what rays have met.
 */
#ifndef DIOPTRE_TRACE_MATERIALS_H
#define DIOPTRE_TRACE_MATERIALS_H

#include "trace/shape_list.h"
#include "trace/surface.h"

/** @return The materials in each lane. @param list The shapes. @param hit What was met.
 *  @param met The lanes that met anything. */
INLINE Materials materials_of(const ShapeList *list, const Hit *hit, mask met) {
    if (!any(met)) {
        return (Materials){0};
    }
    int shape = integer_lane(hit->shape, mask_first(met)), first = list->shapes[shape]->material;
    Materials materials = {integer_of(first), first, met & (hit->shape != integer_of(shape))};
    mask left = materials.others;
    while (any(left)) {
        shape = integer_lane(hit->shape, mask_first(left));
        mask same = left & (hit->shape == integer_of(shape));
        integer material = integer_of(list->shapes[shape]->material);
        materials.places = integer_select(same, material, materials.places);
        left &= mask_not(same);
    }
    return materials;
}

#endif
