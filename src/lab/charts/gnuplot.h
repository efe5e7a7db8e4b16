/**
 * @file
 * @brief Runs gnuplot.
 *
 * The script is piped to it, and the names of files are arguments of their own: nothing in them can
 * become part of the script.
 */
#ifndef DIOPTRE_LAB_CHARTS_GNUPLOT_H
#define DIOPTRE_LAB_CHARTS_GNUPLOT_H

#include "base/error.h"

#include <stdatomic.h>
#include <stddef.h>

/** A script. */
typedef struct GnuplotScript {
    const char *text; /**< `ARG1` is the table in it, `ARG2` the SVG file. */
    size_t size;      /**< Bytes of the text. */
    const char *csv;  /**< The table's file. */
} GnuplotScript;

/** @return Whether gnuplot is installed. */
bool gnuplot_is_available(void);

/**
 * Runs a script.
 * @param path        The SVG file to write; an old one stays whole until the new one is.
 * @param stop        It is given up once this is true; may be NULL.
 * @param[out] error  What is wrong; #STATUS_INTERRUPTED where it was stopped.
 * @return Whether the file is written.
 */
bool gnuplot_run(const GnuplotScript *script, const char *path, const atomic_bool *stop,
                 Error *error);

#endif
