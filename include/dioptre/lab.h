/**
 * @file
 * @brief The laboratory: experiments that show where numerical methods fail.
 */
#ifndef DIOPTRE_LAB_H
#define DIOPTRE_LAB_H

#include "base/error.h"

#include <stdatomic.h>
#include <stddef.h>
#include <stdio.h>

/** An experiment, as the command line shows it. */
typedef struct LabTest {
    const char *name;   /**< Name on the command line, such as `sphere-distance`. */
    const char *title;  /**< Title: what the experiment shows. */
    bool has_benchmark; /**< Whether #lab_benchmark_test can time its methods. */
} LabTest;

/** Output and computation of an experiment. */
typedef struct LabRequest {
    const char *folder;      /**< Folder of CSV and SVG files; created if necessary. */
    int threads;             /**< Number of threads, at least 1. */
    const atomic_bool *stop; /**< The experiment stops once this is true; may be NULL. */
    FILE *table_stream;      /**< Stream for tables; NULL: none are printed. */
} LabRequest;

/** @return The number of experiments. */
size_t lab_test_count(void);

/** @return An experiment. @param index From 0. */
LabTest lab_test_at(size_t index);

/**
 * Creates the folder of results, and checks that it is writable.
 * @param request     The request.
 * @param[out] error  What is wrong (#STATUS_FAILED).
 * @return Whether results can be written.
 */
bool lab_create_folder(const LabRequest *request, Error *error);

/**
 * Runs an experiment: prints its tables, and writes `NAME.csv` and `NAME.svg`.
 * @param index           From 0.
 * @param[out] has_chart  Whether the SVG is written; it is not if gnuplot is missing.
 * @param[out] error      What is wrong.
 * @return false if anything is wrong.
 */
bool lab_run_test(size_t index, const LabRequest *request, bool *has_chart, Error *error);

/**
 * Times the methods of an experiment: prints a table, and writes `kernel-NAME.csv` and
 * `kernel-NAME.svg`, a chart of errors against times.
 * @param index           From 0, of an experiment with a benchmark.
 * @param[out] has_chart  Whether the SVG is written; it is not if gnuplot is missing.
 * @param[out] error      What is wrong.
 * @return false if anything is wrong.
 */
bool lab_benchmark_test(size_t index, const LabRequest *request, bool *has_chart, Error *error);

#endif
