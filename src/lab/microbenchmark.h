/**
 * @file
 * @brief Speed and accuracy of methods and of the tracer's engines: time per test, and errors.
 */
#ifndef DIOPTRE_LAB_MICROBENCHMARK_H
#define DIOPTRE_LAB_MICROBENCHMARK_H

#include "dioptre/lab.h"
#include "lab/experiment.h"

/** Most points: methods times number types. */
enum { MICROBENCHMARK_POINTS_MAXIMUM = 64 };

/** A method in a number type. */
typedef struct MicrobenchmarkPoint {
    MethodResult result; /**< Its errors, at a level. */
    Quartiles ns;        /**< Time per test in each turn, nanoseconds of CPU time. */
} MicrobenchmarkPoint;

/** All methods of a family. */
typedef struct Microbenchmark {
    MicrobenchmarkPoint
        points[MICROBENCHMARK_POINTS_MAXIMUM]; /**< Method by method, type by type. */
    size_t count;                              /**< Number of #points. */
} Microbenchmark;

/**
 * Measures the methods of an experiment, at its level #Experiment.timed_level.
 * @param threads  How many threads find errors; time is measured on one.
 * @param stop  It is given up once this is true; may be NULL.
 * @param[out] error  What is wrong: #STATUS_INTERRUPTED, or no memory.
 * @return false if anything is wrong.
 */
bool microbenchmark_measure(const Experiment *experiment, int threads, const atomic_bool *stop,
                            Microbenchmark *benchmark, Error *error);

/**
 * Saves a benchmark: prints a table, writes `kernel-NAME.csv` and `kernel-NAME.svg`.
 * @param[out] has_chart  Whether there is an SVG; there is none where gnuplot is missing.
 * @return false if anything is wrong.
 */
bool microbenchmark_save(const Microbenchmark *benchmark, const Experiment *experiment,
                         const LabRequest *request, bool *has_chart, Error *error);

#endif
