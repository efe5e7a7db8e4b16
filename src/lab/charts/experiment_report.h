/**
 * @file
 * @brief Results of an experiment as tables on the terminal, as CSV, as a chart.
 */
#ifndef DIOPTRE_LAB_CHARTS_EXPERIMENT_REPORT_H
#define DIOPTRE_LAB_CHARTS_EXPERIMENT_REPORT_H

#include "lab/experiment.h"

#include <stdio.h>

/** Prints results, a table per quantity. */
void experiment_report_print(const Experiment *experiment, const ExperimentResults *results,
                             FILE *stream);

/** Writes results as CSV. @return Whether the file is written. */
bool experiment_report_write_csv(const Experiment *experiment, const ExperimentResults *results,
                                 const char *path, Error *error);

/** Files of a chart. */
typedef struct ReportPaths {
    const char *csv; /**< Written by #experiment_report_write_csv. */
    const char *svg; /**< The chart. */
} ReportPaths;

/**
 * Draws results: a column of panels per number type, a row per quantity.
 * @param stop  It is given up once this is true; may be NULL.
 * @return Whether the file is written.
 */
bool experiment_report_draw(const Experiment *experiment, const ExperimentResults *results,
                            const ReportPaths *files, const atomic_bool *stop, Error *error);

#endif
