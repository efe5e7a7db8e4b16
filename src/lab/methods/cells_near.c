/**
 * @file
 * @brief Repetition by the point's cell and all that touch it.
 *
 *   f(P) = least distance to the balls of 27 cells
 */
#include "lab/methods/cells.h"

/** @return The field. @param q The question. @param p A point. */
static real field(const CellsQuestion *q, Vector p) {
    int x = cell_of(p.x), y = cell_of(p.y), z = cell_of(p.z);
    real least = INFINITE;
    for (int i = 0; i < 27; i++) {
        real far = cell_distance(q, p, x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1);
        least = real_min(far, least);
    }
    return least;
}

/** Asks it. See #Method.run. @param question A #CellsQuestion. @param[out] answer A #CellsAnswer.
 */
static void run(const void *question, void *answer) {
    const CellsQuestion *q = question;
    ((CellsAnswer *)answer)->distance = cells_march(q, field);
}

const Method cells_near = {.family = "cells",
                           .name = "27 cells",
                           .label = "27 cells",
                           .inputs = NUMBERS_OF(CellsQuestion),
                           .outputs = NUMBERS_OF(CellsAnswer),
                           .run = run};
