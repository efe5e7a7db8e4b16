/**
 * @file
 * @brief Material indices of hits.
 */
#ifndef DIOPTRE_TRACE_MATERIALS_MATERIAL_IDS_H
#define DIOPTRE_TRACE_MATERIALS_MATERIAL_IDS_H

#include "trace/bvh/shape_set.h"
#include "trace/materials/material.h"

/** @return The indices of the materials at hits. @param hit_lanes The lanes with a hit. */
INLINE MaterialIds material_ids_of(const ShapeSet *shapes, const Hit *hit, mask hit_lanes) {
    if (!any(hit_lanes)) {
        return (MaterialIds){0};
    }
    int shape = integer_lane(hit->shape, mask_first(hit_lanes)),
        first = shapes->shapes[shape]->material;
    MaterialIds ids = {integer_of(first), first, hit_lanes & (hit->shape != integer_of(shape))};
    mask remaining = ids.others;
    while (any(remaining)) {
        shape = integer_lane(hit->shape, mask_first(remaining));
        mask same = remaining & (hit->shape == integer_of(shape));
        integer material = integer_of(shapes->shapes[shape]->material);
        ids.ids = integer_select(same, material, ids.ids);
        remaining &= mask_not(same);
    }
    return ids;
}

/** @return What materials do, all together. */
INLINE unsigned material_ids_traits(const Material *materials, const MaterialIds *ids) {
    unsigned traits = materials[ids->first].traits;
    for (unsigned remaining = mask_bits(ids->others); remaining; remaining &= remaining - 1) {
        traits |= materials[integer_at(&ids->ids, __builtin_ctz(remaining))].traits;
    }
    return traits;
}

#endif
