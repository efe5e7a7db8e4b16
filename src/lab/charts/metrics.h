/**
 * @file
 * @brief The quantities in the results of experiments.
 */
#ifndef DIOPTRE_LAB_CHARTS_METRICS_H
#define DIOPTRE_LAB_CHARTS_METRICS_H

#include "lab/experiment.h"

/** Kinds of quantities. */
typedef enum {
    METRIC_ERROR,    /**< An error in the experiment's unit. */
    METRIC_ULPS,     /**< An error, in ulps. */
    METRIC_FRACTION, /**< A fraction of samples, 0 to 1. */
    METRIC_COST      /**< A cost of an output. */
} MetricKind;

/** A quantity. */
typedef struct Metric {
    const char *column;  /**< Its column in the CSV. */
    const char *heading; /**< Its name, in English. */
    MetricKind kind;     /**< Its kind. */
    bool is_plotted;     /**< Whether charts have panels of it. */
    /** @return Its value; NaN: none. */
    double (*value)(const Experiment *experiment, const MethodResult *finding);
} Metric;

/** Number of quantities. */
enum { METRIC_COUNT = 13 };

/** @return A quantity. @param index In the order of the CSV's columns. */
const Metric *metric_at(size_t index);

/** Column of the first quantity in the CSV, from 1. */
enum { METRIC_FIRST_COLUMN = 5 };

/** @return Whether any value of a quantity exceeds 0. */
bool metric_is_nonzero(const Metric *metric, const Experiment *experiment,
                       const ExperimentResults *results);

#endif
