/**
 * @file
 * @brief What an experiment has found: as tables on the terminal, as CSV, as a chart.
 */
#ifndef DIOPTRE_LAB_CHARTS_EXPERIMENT_REPORT_H
#define DIOPTRE_LAB_CHARTS_EXPERIMENT_REPORT_H

#include "lab/experiment.h"

#include <stdio.h>

/** Prints what was found, a table for each kind of figure. */
void experiment_report_print(const Experiment *experiment, const ExperimentResults *results,
                             FILE *stream);

/** Writes what was found as comma-separated values. @return Whether it is there. */
bool experiment_report_write_csv(const Experiment *experiment, const ExperimentResults *results,
                                 const char *path, Error *error);

/** Where a chart comes from and goes to. */
typedef struct ReportPaths {
    const char *csv; /**< What #experiment_report_write_csv has written. */
    const char *svg; /**< The chart. */
} ReportPaths;

/**
 * Draws what was found: a column of panels for each number type, a row for each kind of figure.
 * @param files  From where, and where to.
 * @param stop  It is given up once this is true; may be NULL.
 * @return Whether it is there.
 */
bool experiment_report_draw(const Experiment *experiment, const ExperimentResults *results,
                            const ReportPaths *files, const atomic_bool *stop, Error *error);

#endif
