/**
 * @file
 * @brief Runs gnuplot.
 */
#include "lab/charts/gnuplot.h"

#include "base/atomic_file.h"
#include "base/process/pipe_process.h"

#include <stdio.h>
#include <string.h>

/** The program. */
#define PLOT_PROGRAM "gnuplot"

bool gnuplot_is_available(void) {
    return pipe_process_is_installed(PLOT_PROGRAM);
}

/** @return Whether a file ends as an SVG does. */
static bool is_whole_svg(const char *path) {
    static const char END[] = "</svg>";
    /** Bytes of the end, with white space behind it. */
    enum { TAIL_SIZE = 16 };
    char tail[TAIL_SIZE + 1] = "";
    FILE *file = fopen(path, "rb");
    if (file) {
        if (fseek(file, -(long)TAIL_SIZE, SEEK_END) == 0) {
            tail[fread(tail, 1, TAIL_SIZE, file)] = '\0';
        }
        fclose(file);
    }
    return strstr(tail, END) != NULL;
}

/** Runs a script that writes a file. @return Whether it ran to its end. */
static bool run_into_file(const GnuplotScript *script, const char *svg, const atomic_bool *stop,
                          Error *error) {
    PipeProcess gnuplot;
    const char *const words[] = {PLOT_PROGRAM, "-c", "/dev/stdin", script->csv, svg, NULL};
    if (!pipe_process_start(&gnuplot, stop, words, error)) {
        return false;
    }
    bool is_fed = pipe_process_write(&gnuplot, script->text, script->size);
    bool is_done = pipe_process_finish(&gnuplot, error);
    if (stop && atomic_load(stop)) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    return is_done &&
           (is_fed || error_set(error, STATUS_FAILED, "%s did not read all", PLOT_PROGRAM));
}

bool gnuplot_run(const GnuplotScript *script, const char *path, const atomic_bool *stop,
                 Error *error) {
    AtomicFile file;
    if (!atomic_file_open(&file, path, ATOMIC_REPLACE, error)) {
        return error_prefix(error, "cannot write '%s': ", path);
    }
    const bool is_temporary = file.temporary_path[0] != '\0';
    const char *svg = is_temporary ? file.temporary_path : file.target.path;
    bool is_drawn = run_into_file(script, svg, stop, error);
    // On a full disk gnuplot ends with status 0.
    if (is_drawn && is_temporary && !is_whole_svg(svg)) {
        is_drawn = error_set(error, STATUS_FAILED, "%s has not written all: is the disk full?",
                             PLOT_PROGRAM);
    }
    if (!is_drawn) {
        atomic_file_discard(&file);
        return error_prefix(error, "cannot write '%s': ", path);
    }
    return atomic_file_commit(&file, error) || error_prefix(error, "cannot write '%s': ", path);
}
