/**
 * @file
 * @brief Speed against accuracy of the methods: what a test costs, and what it leaves of errors.
 */
#ifndef DIOPTRE_LAB_KERNEL_H
#define DIOPTRE_LAB_KERNEL_H

#include "dioptre/lab.h"
#include "lab/experiment.h"

/** Most points: methods times number types. */
enum { KERNEL_POINTS_MAXIMUM = 64 };

/** A method in a number type. */
typedef struct KernelPoint {
    Finding finding; /**< What it does wrong, at a level of stress. */
    double ns;       /**< What a test costs, nanoseconds of the processor: median of the turns. */
    double ns_low;   /**< Its lower quartile. */
    double ns_high;  /**< Its upper quartile. */
    double failures; /**< The largest of its shares of false hits, false misses, leaks, wrong
                          surfaces and what is no number; NaN where none is counted. */
} KernelPoint;

/** All methods of a family. */
typedef struct Kernel {
    KernelPoint points[KERNEL_POINTS_MAXIMUM]; /**< Method by method, type by type. */
    size_t count;                              /**< How many. */
} Kernel;

/**
 * Measures the methods of an experiment, at its level #Experiment.timed.
 * @param experiment   The experiment.
 * @param threads      How many find errors at once; time is measured on one.
 * @param stop         It is given up once this is true; may be NULL.
 * @param[out] kernel  What was found.
 * @param[out] error   What is wrong: #STATUS_INTERRUPTED, or no memory.
 * @return false if anything is wrong.
 */
bool kernel_measure(const Experiment *experiment, int threads, const atomic_bool *stop,
                    Kernel *kernel, Error *error);

/**
 * Keeps what was found: prints a table, writes `kernel-NAME.csv` and `kernel-NAME.svg`.
 * @param kernel          What was found.
 * @param experiment      The experiment.
 * @param request         Where to.
 * @param[out] has_chart  Whether there is an SVG; there is none where gnuplot is missing.
 * @param[out] error      What is wrong.
 * @return false if anything is.
 */
bool kernel_keep(const Kernel *kernel, const Experiment *experiment, const LabRequest *request,
                 bool *has_chart, Error *error);

#endif
