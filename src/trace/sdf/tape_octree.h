/**
 * @file
 * @brief Octree of tapes: in a part of space a tape needs fewer steps.
 *
 * Where one operand of a minimum is the smaller one at all points of a cell, the other one is not
 * needed there, nor what only leads to it. Cells near the surface are divided into eight while
 * their tapes are long (Keeter, *Massively Parallel Rendering of Complex Closed-Form Implicit
 * Surfaces*, 2020).
 *
 * A shorter tape gives the same bits. The ranges of its numbers are computed in the engine's own
 * arithmetic: rounding is monotonic, so that the ends of a range, rounded like all numbers, bound
 * what the engine finds at any point of the cell. That holds while numbers round as when the octree
 * was built: to nearest. The layer of rounding, which rounds otherwise, evaluates whole tapes.
 */
#ifndef DIOPTRE_TRACE_SDF_TAPE_OCTREE_H
#define DIOPTRE_TRACE_SDF_TAPE_OCTREE_H

#include "trace/sdf/sdf_tape.h"

/** Whether tapes have octrees: not in quad, which is the reference, and whose ranges would take
 *  longer than a picture. */
enum { HAS_TAPE_OCTREES = REAL_BITS <= 64 };

/** A cell of an octree. */
typedef struct TapeCell {
    uint32_t children;  /**< Index of the first of its eight cells; 0: it is not divided. */
    uint32_t first_use; /**< Where its tape begins, if it is not divided. */
    uint16_t count;     /**< Number of steps of this tape. */
    uint16_t result;    /**< Register of its result. */
} TapeCell;

/** The octree of a tape. */
typedef struct TapeOctree {
    scalar low[3];       /**< Lowest corner. */
    scalar high[3];      /**< Highest corner. */
    TapeCell *cells;     /**< The cells, the whole first; in its memory. */
    uint32_t cell_count; /**< Number of cells. */
    TapeUse *uses;       /**< The steps of their tapes; in its memory. */
    size_t use_count;    /**< Number of these. */
} TapeOctree;

/** @return Bytes that suffice for the octree of a tape; 0: it has none, as it is short, chooses
 *          between few numbers, or has no box, or a huge one. @param tape Its node. */
size_t tape_octree_size(const SdfNode *tape);

/**
 * Builds the octree of a tape.
 * @param memory       #tape_octree_size bytes, aligned to #SHAPE_ALIGNMENT.
 * @param instruction  The tape, with its steps.
 * @return The octree, in the memory. NULL: the whole tape serves, as the tapes of cells are hardly
 *         shorter, or there is no memory for the work.
 */
const TapeOctree *tape_octree_build(void *memory, const SdfInstruction *instruction);

/** A tape, and points that it is for. */
typedef struct TapeLanes {
    Tape tape;      /**< The tape. */
    unsigned lanes; /**< Bit i: it is for lane i. */
} TapeLanes;

/** @return The tape for the first of some points, and which of them it is for. @param whole The
 *          tape of points outside the octree. @param lanes Bits of the points, at least one. */
TapeLanes tape_octree_find(const TapeOctree *octree, Tape whole, Vec3 p, unsigned lanes);

#endif
