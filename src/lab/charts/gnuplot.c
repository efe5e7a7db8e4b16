/**
 * @file
 * @brief Has gnuplot draw what somebody writes a script for.
 */
#include "lab/charts/gnuplot.h"

#include "assets/process/pipe_process.h"
#include "base/atomic_file.h"

#include <stdlib.h>

/** The program that draws charts. */
#define PLOT_PROGRAM "gnuplot"

/** How many styles there are. */
enum { STYLE_COUNT = 8 };

bool gnuplot_is_available(void) {
    return pipe_process_is_installed(PLOT_PROGRAM);
}

const char *gnuplot_color(int style) {
    // Dark enough for paper.
    static const char *const colors[STYLE_COUNT] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                    "#E69F00", "#56B4E9", "#7F7F7F", "#000000"};
    return colors[style % STYLE_COUNT];
}

int gnuplot_point_type(int style) {
    static const int signs[STYLE_COUNT] = {7, 5, 9, 13, 4, 6, 8, 3};
    return signs[style % STYLE_COUNT];
}

const char *gnuplot_quote(const char *text, char *quoted, size_t size) {
    size_t at = 0;
    for (; *text && at + 3 < size; text++) {
        if (*text == '\'') {
            quoted[at++] = '\'';
        }
        quoted[at++] = *text == '\n' ? ' ' : *text;
    }
    quoted[at] = '\0';
    return quoted;
}

/**
 * Has a script run.
 * @param stop  Whether to give up.
 * @return Whether it has run to its end.
 */
static bool run_script(const char *script, size_t size, const char *const files[2],
                       const atomic_bool *stop, Error *error) {
    PipeProcess gnuplot;
    const char *const words[] = {PLOT_PROGRAM, "-c", "/dev/stdin", files[0], files[1], NULL};
    if (!pipe_process_start(&gnuplot, stop, words, error)) {
        return false;
    }
    bool is_fed = pipe_process_write(&gnuplot, script, size);
    bool is_done = pipe_process_finish(&gnuplot, error);
    if (stop && atomic_load(stop)) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    return is_done &&
           (is_fed || error_set(error, STATUS_FAILED, "%s did not read all", PLOT_PROGRAM));
}

/**
 * Draws a chart into a file that is open.
 * @param stop  Whether to give up.
 * @return Whether it is there.
 */
static bool draw_to_file(const GnuplotJob *job, const AtomicFile *file, const atomic_bool *stop,
                         Error *error) {
    char *script = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&script, &size);
    if (!stream) {
        return error_set(error, STATUS_FAILED, "no memory for a chart");
    }
    job->write_script(job->context, stream);
    fclose(stream);
    const char *path = file->temporary_path[0] ? file->temporary_path : file->target.path;
    bool is_drawn = run_script(script, size, (const char *const[]){job->csv, path}, stop, error);
    free(script);
    return is_drawn;
}

bool gnuplot_draw(const GnuplotJob *job, const char *path, const atomic_bool *stop, Error *error) {
    AtomicFile file;
    if (!atomic_file_open(&file, path, ATOMIC_REPLACE, error)) {
        return error_prefix(error, "cannot write '%s': ", path);
    }
    if (!draw_to_file(job, &file, stop, error)) {
        atomic_file_discard(&file);
        return error_prefix(error, "cannot write '%s': ", path);
    }
    return atomic_file_commit(&file, error) || error_prefix(error, "cannot write '%s': ", path);
}
