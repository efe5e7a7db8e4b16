/**
 * @file
 * @brief The kinds of figures that experiments find: what they are called, and how they are had.
 */
#ifndef DIOPTRE_LAB_FIGURES_H
#define DIOPTRE_LAB_FIGURES_H

#include "lab/experiment.h"

/** What a figure is of. */
typedef enum {
    FIGURE_ERROR, /**< An error, in the experiment's unit. */
    FIGURE_ULPS,  /**< An error, in ulps. */
    FIGURE_SHARE, /**< An outcome, 0 to 1. */
    FIGURE_WORK   /**< What an answer costs. */
} FigureKind;

/** A kind of figure. */
typedef struct Figure {
    const char *column;  /**< What the CSV calls it. */
    const char *heading; /**< What it is, for people, in English. */
    FigureKind kind;     /**< What of: errors and work, the experiment says more of. */
    bool is_charted;     /**< Whether it has panels of its own in a chart. */
    /** @return The figure; NaN where there is none. @param experiment The experiment.
     *  @param finding What was found. */
    double (*of)(const Experiment *experiment, const Finding *finding);
} Figure;

/** How many kinds there are. */
enum { FIGURE_COUNT = 13 };

/** @return A kind of figure. @param place Which, in the order of the CSV's columns. */
const Figure *figure_at(size_t place);

/** Column of the CSV that the first kind of figure has, from 1. */
enum { FIGURE_FIRST_COLUMN = 5 };

/** @return Whether anything of a kind was found, and was not always 0. @param figure The kind.
 *  @param experiment The experiment. @param findings What was found. */
bool figure_is_found(const Figure *figure, const Experiment *experiment, const Findings *findings);

#endif
