/**
 * @file
 * @brief The laboratory: where each method fails, and how far the tracer's own holds.
 */
#ifndef DIOPTRE_LAB_H
#define DIOPTRE_LAB_H

#include "dioptre/error.h"

#include <stdatomic.h>
#include <stddef.h>
#include <stdio.h>

/** A test of the laboratory, as people see it. */
typedef struct LabTest {
    const char *name;   /**< As on the command line, such as `sphere-distance`. */
    const char *title;  /**< What it shows. */
    bool has_benchmark; /**< Whether #lab_benchmark_test can say what its methods cost. */
} LabTest;

/** What is to be done. */
typedef struct LabRequest {
    const char *folder;      /**< Where CSV and SVG files go; made where it is not there. */
    int threads;             /**< How many work at once, at least 1. */
    const atomic_bool *stop; /**< It is given up once this is true; may be NULL. */
    FILE *table_stream;      /**< Where tables are printed; NULL: nowhere. */
} LabRequest;

/** @return How many tests there are. */
size_t lab_test_count(void);

/** @return A test. @param index Which, from 0. */
LabTest lab_test_at(size_t index);

/**
 * Finds out whether results can be kept, and makes their folder.
 * @param request     What is to be done.
 * @param[out] error  Why they cannot (#STATUS_FAILED).
 * @return Whether they can.
 */
bool lab_create_folder(const LabRequest *request, Error *error);

/**
 * Makes a test: prints its tables, and writes `NAME.csv` and `NAME.svg`.
 * @param index           Which test, from 0.
 * @param request         How.
 * @param[out] has_chart  Whether there is an SVG; there is none where gnuplot is missing.
 * @param[out] error      What is wrong. What earlier tests have written stays.
 * @return false if anything is wrong.
 */
bool lab_run_test(size_t index, const LabRequest *request, bool *has_chart, Error *error);

/**
 * Holds what the methods of a test cost against their errors: prints a table, and writes
 * `benchmark-NAME.csv` and `benchmark-NAME.svg`.
 * @param index           Which test, from 0; one that is timed.
 * @param request         How.
 * @param[out] has_chart  Whether there is an SVG; there is none where gnuplot is missing.
 * @param[out] error      What is wrong. What earlier tests have written stays.
 * @return false if anything is wrong.
 */
bool lab_benchmark_test(size_t index, const LabRequest *request, bool *has_chart, Error *error);

#endif
