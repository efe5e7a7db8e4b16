/**
 * @file
 * @brief From a file to what a child has made of it.
 */
#include "script/launch.h"

#include "assets/child.h"
#include "script/text.h"

#include <libintl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

/**
 * Does in the child what a child is for.
 * @param context  A #Run.
 */
static void work(void *context) {
    run_text(context);
}

/**
 * Reports that a scene was stopped, at the line where it was seen last.
 * @param run    What was run.
 * @param words  Why.
 */
static void stop(const Run *run, const char *words) {
    report_fail(run->report, run->report->location, words, strlen(words));
}

/** @return Whether a scene file is given up. @param request What was asked for. */
static bool is_stopped(const ScriptRequest *request) {
    return request->stop && atomic_load(request->stop);
}

/**
 * Reports why a child has left no report of its own.
 * @param run     What it was to run.
 * @param end     How it ended.
 * @param detail  The signal or the errno.
 */
static void explain(const Run *run, ChildEnd end, int detail) {
    char words[ERROR_MESSAGE_SIZE];
    if (end == CHILD_UNSTARTED) {
        error_set(&run->report->error, STATUS_FAILED, "no process to run a scene in: %s",
                  error_system(detail));
    } else if (end == CHILD_LATE && is_stopped(run->request)) {
        error_set(&run->report->error, STATUS_INTERRUPTED, "interrupted");
    } else if (end == CHILD_LATE) {
        snprintf(words, sizeof words, gettext("the scene ran for more than %g s"),
                 run->request->seconds);
        stop(run, words);
    } else if (end == CHILD_CRASHED && detail == SIGINT) {
        error_set(&run->report->error, STATUS_INTERRUPTED, "interrupted");
    } else {
        snprintf(words, sizeof words, gettext("the process that ran the scene died (%s)"),
                 detail ? strsignal(detail) : gettext("nobody knows why"));
        stop(run, words);
    }
}

bool launch_run(Run *run, Error *error) {
    int detail;
    Report *report = run->report;
    const ChildWatcher watcher = {.stop = run->request->stop};
    ChildEnd end = child_run_watched(work, run, run->request->seconds,
                                     watcher.stop ? &watcher : NULL, &detail);
    if (!report->is_done) {
        explain(run, end, detail);
    }
    bool is_good = report->error.status == STATUS_DONE;
    if (!is_good && error) {
        *error = report->error;
    }
    return is_good;
}

bool launch_read(const char *path, Source *source, Error *error) {
    char shown[TEXT_PATH_SIZE];
    text_clean_path(shown, path);
    if (!source_read(source, path, error)) {
        return error_prefix(error, "%s: ", shown);
    }
    int line;
    if (!source_check_text(source, &line, error)) {
        source_release(source);
        return error_prefix(error, "%s:%d: ", shown, line);
    }
    return true;
}
