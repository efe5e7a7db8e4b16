/**
 * @file
 * @brief Repetition by the point's own cell alone: report B's way (row B8).
 *
 *   f(P) = distance to the ball of the cell that P is in
 *
 * The ball of the next cell may be nearer. Then f is more than the distance, the step is too long,
 * and the ray jumps into or through that ball.
 */
#include "lab/methods/cells.h"

/** @return The field. @param q The question. @param p A point. */
static real field(const CellsQuestion *q, Vector p) {
    return cell_distance(q, p, cell_of(p.x), cell_of(p.y), cell_of(p.z));
}

/** Asks it. See #Method.run. @param question A #CellsQuestion. @param[out] answer A #CellsAnswer.
 */
static void run(const void *question, void *answer) {
    const CellsQuestion *q = question;
    ((CellsAnswer *)answer)->distance = cells_march(q, field);
}

const Method cells_own = {.family = "cells",
                          .name = "own cell",
                          .label = "own cell",
                          .inputs = NUMBERS_OF(CellsQuestion),
                          .outputs = NUMBERS_OF(CellsAnswer),
                          .run = run};
