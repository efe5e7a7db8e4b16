/**
 * @file
 * @brief The boxes of the parts of a union.
 */
#ifndef DIOPTRE_TRACE_SDF_SDF_UNION_H
#define DIOPTRE_TRACE_SDF_SDF_UNION_H

#include "trace/bvh/aabb_pack.h"
#include "trace/sdf/sdf_program.h"

/** Most packs of a run: their distances are on the stack. */
enum { SDF_UNION_RUN_PACKS = 32 };
/** Most parts of a run. */
enum { SDF_UNION_RUN_PARTS = SDF_UNION_RUN_PACKS * AABB_PACK_SIZE };

/** Parts of a union whose boxes are tested at once. */
struct SdfUnionPack {
    AabbPack boxes;                              /**< Bounding boxes of the parts. */
    const SdfInstruction *parts[AABB_PACK_SIZE]; /**< The instructions of the parts. */
    unsigned bits;                               /**< Bit i: there is a part i. */
};

/** Empties a pack. */
INLINE void sdf_union_pack_clear(SdfUnionPack *pack) {
    const Aabbs nowhere = {{INFINITE, INFINITE, INFINITE}, {-INFINITE, -INFINITE, -INFINITE}};
    pack->bits = 0;
    for (size_t i = 0; i < AABB_PACK_SIZE; i++) {
        aabb_pack_set(&pack->boxes, i, nowhere);
        pack->parts[i] = NULL;
    }
}

/** Adds a part. @param i Its index in the pack. @param part Its instruction. */
INLINE void sdf_union_pack_add(SdfUnionPack *pack, int i, const SdfInstruction *part) {
    const scalar *n = part->operands;
    aabb_pack_set(&pack->boxes, (size_t)i, (Aabbs){{n[0], n[1], n[2]}, {n[3], n[4], n[5]}});
    pack->parts[i] = part;
    pack->bits |= 1u << i;
}

#endif
