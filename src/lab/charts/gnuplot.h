/**
 * @file
 * @brief Has gnuplot draw what somebody writes a script for.
 *
 * The script goes through a pipe, and the files' names as arguments of their own: whatever is in
 * them, it is no part of the script.
 */
#ifndef DIOPTRE_LAB_CHARTS_GNUPLOT_H
#define DIOPTRE_LAB_CHARTS_GNUPLOT_H

#include "dioptre/error.h"

#include <stdatomic.h>
#include <stddef.h>
#include <stdio.h>

/** What is to be drawn. */
typedef struct GnuplotJob {
    const void *context; /**< Anything. */
    /** Writes the script. @param script Where to: `ARG1` is there the table, `ARG2` the SVG file.
     */
    void (*write_script)(const void *context, FILE *script);
    const char *csv; /**< The table's file. */
} GnuplotJob;

/** @return Whether charts can be drawn here. */
bool gnuplot_is_available(void);

/**
 * Draws a chart.
 * @param stop  It is given up once this is true; may be NULL.
 * @return Whether it is in its place.
 */
bool gnuplot_draw(const GnuplotJob *job, const char *path, const atomic_bool *stop, Error *error);

/** @return A text that stands in a script between single quotes. */
const char *gnuplot_quote(const char *text, char *quoted, size_t size);

/** @return A colour that the colour-blind can tell apart from the seven others. */
const char *gnuplot_color(int style);

/** @return A sign that goes with the colour. */
int gnuplot_point_type(int style);

#endif
