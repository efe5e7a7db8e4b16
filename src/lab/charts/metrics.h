/**
 * @file
 * @brief The kinds of figures that experiments find: what they are called, and how they are had.
 */
#ifndef DIOPTRE_LAB_CHARTS_METRICS_H
#define DIOPTRE_LAB_CHARTS_METRICS_H

#include "lab/experiment.h"

/** What a figure is of. */
typedef enum {
    METRIC_ERROR,    /**< An error, in the experiment's unit. */
    METRIC_ULPS,     /**< An error, in ulps. */
    METRIC_FRACTION, /**< An outcome, 0 to 1. */
    METRIC_COST      /**< What an answer costs. */
} MetricKind;

/** A kind of figure. */
typedef struct Metric {
    const char *column;  /**< What the CSV calls it. */
    const char *heading; /**< What it is, for people, in English. */
    MetricKind kind;     /**< What of: errors and work, the experiment says more of. */
    bool is_plotted;     /**< Whether it has panels of its own in a chart. */
    /** @return The figure; NaN where there is none. */
    double (*value)(const Experiment *experiment, const MethodResult *finding);
} Metric;

/** How many kinds there are. */
enum { METRIC_COUNT = 13 };

/** @return A kind of figure. @param index Which, in the order of the CSV's columns. */
const Metric *metric_at(size_t index);

/** Column of the CSV that the first kind of figure has, from 1. */
enum { METRIC_FIRST_COLUMN = 5 };

/** @return Whether anything of a kind was found, and was not always 0. */
bool metric_is_nonzero(const Metric *metric, const Experiment *experiment,
                       const ExperimentResults *results);

#endif
