/**
 * @file
 * @brief From a file to what a child has made of it.
 */
#include "script/sandboxed_run.h"

#include "assets/process/sandbox_process.h"
#include "script/sanitize.h"

#include <libintl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

/** Does in the child what a child is for. */
static void sandbox_main(void *context) {
    script_run_execute(context);
}

/** Reports that a scene was stopped, at the line where it was seen last. */
static void fail_at_location(const ScriptRun *run, const char *message) {
    script_result_fail(run->result, run->result->location, message, strlen(message));
}

/** @return Whether a scene file is given up. */
static bool script_is_stopped(const ScriptRequest *request) {
    return request->stop && atomic_load(request->stop);
}

/**
 * Reports why a child has left no report of its own.
 * @param run  What it was to run.
 * @param detail  The signal or the errno.
 */
static void set_failure(const ScriptRun *run, SandboxProcessEnd end, int detail) {
    char message[ERROR_MESSAGE_SIZE];
    if (end == SANDBOX_PROCESS_NOT_STARTED) {
        error_set(&run->result->error, STATUS_FAILED, "no process to run a scene in: %s",
                  error_errno_text(detail));
    } else if (end == SANDBOX_PROCESS_TIMED_OUT && script_is_stopped(run->request)) {
        error_set(&run->result->error, STATUS_INTERRUPTED, "interrupted");
    } else if (end == SANDBOX_PROCESS_TIMED_OUT) {
        snprintf(message, sizeof message, gettext("the scene ran for more than %g s"),
                 run->request->time_limit);
        fail_at_location(run, message);
    } else if (end == SANDBOX_PROCESS_CRASHED && detail == SIGINT) {
        error_set(&run->result->error, STATUS_INTERRUPTED, "interrupted");
    } else {
        snprintf(message, sizeof message, gettext("the process that ran the scene died (%s)"),
                 detail ? strsignal(detail) : gettext("nobody knows why"));
        fail_at_location(run, message);
    }
}

bool script_run_sandboxed(ScriptRun *run, Error *error) {
    int detail;
    ScriptResult *result = run->result;
    const SandboxProcessMonitor monitor = {.stop = run->request->stop};
    SandboxProcessEnd end = sandbox_process_run_monitored(
        sandbox_main, run, run->request->time_limit, monitor.stop ? &monitor : NULL, &detail);
    if (!result->is_done) {
        set_failure(run, end, detail);
    }
    bool is_good = result->error.status == STATUS_OK;
    if (!is_good && error) {
        *error = result->error;
    }
    return is_good;
}

bool script_text_load(const char *path, ScriptText *text, Error *error) {
    char display_path[SANITIZED_PATH_SIZE];
    sanitize_path(display_path, path);
    if (!script_text_read(text, path, error)) {
        return error_prefix(error, "%s: ", display_path);
    }
    int line;
    if (!script_text_check(text, &line, error)) {
        script_text_deinit(text);
        return error_prefix(error, "%s:%d: ", display_path, line);
    }
    return true;
}
