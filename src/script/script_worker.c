/**
 * @file
 * @brief Execution of scene and lesson files in a worker process: both sides.
 */
#include "script/script_worker.h"

#include "assets/process/worker_clock.h"
#include "assets/process/worker_process.h"
#include "script/lesson_functions.h"
#include "script/nff.h"
#include "script/script_question.h"
#include "script/script_run.h"

#include <libintl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Start of a request to the worker; the overrides, the text and the names of actions follow. */
typedef struct ScriptJobHead {
    char path[PATH_MAX];     /**< See #ScriptRequest.path. */
    char base_dir[PATH_MAX]; /**< See #ScriptRequest.base_dir. */
    bool has_base_dir;       /**< Whether #ScriptRequest.base_dir is not NULL. */
    double time;             /**< See #ScriptRequest.time. */
    size_t memory_limit;     /**< See #ScriptRequest.memory_limit. */
    void *address;           /**< Address for the scene or lesson. */
    size_t text_size;        /**< Bytes of the text. */
    size_t action_count;     /**< Number of names, each ended by a zero byte. */
    int move_count;          /**< See #ActionNames.move_count. */
    size_t override_count;   /**< See #ScriptRequest.override_count. */
} ScriptJobHead;

/** @return The overrides of a request. */
static SceneOverride *head_overrides(const ScriptJobHead *head) {
    return (SceneOverride *)(uintptr_t)(head + 1);
}

/** @return The text of a request. */
static char *head_text(const ScriptJobHead *head) {
    return (char *)(head_overrides(head) + head->override_count);
}

/** Limit of a run's data outside of Lua, bytes: lists of NFF and of meshes, as long as a scene. */
#define SCRIPT_NATIVE_MEMORY_LIMIT SCENE_MEMORY_SIZE

// --- in the program ------------------------------------------------------------------------------

/**
 * @return Bytes of all names of actions.
 * @param actions     The names.
 * @param[out] count  Number of names.
 */
static size_t action_names_size(const ActionNames *actions, size_t *count) {
    size_t size = 0;
    for (*count = 0; actions && actions->names[*count]; (*count)++) {
        size += strlen(actions->names[*count]) + 1;
    }
    return size;
}

/**
 * Packs a request.
 * @param call       The call.
 * @param[out] size  Its size in bytes.
 * @return The request, to be freed with `free`; NULL without memory.
 */
static void *pack_request(const ScriptCall *call, size_t *size) {
    const ScriptRequest *request = call->request;
    size_t action_count, text_size = call->text->size;
    size_t names_size = action_names_size(call->actions, &action_count);
    size_t overrides_size = request->override_count * sizeof *request->overrides;
    *size = sizeof(ScriptJobHead) + overrides_size + text_size + names_size;
    ScriptJobHead *head = calloc(1, *size);
    if (!head) {
        return NULL;
    }
    *head = (ScriptJobHead){.has_base_dir = request->base_dir,
                            .time = request->time,
                            .memory_limit = request->memory_limit,
                            .address = call->block,
                            .text_size = text_size,
                            .action_count = action_count,
                            .override_count = request->override_count,
                            .move_count = call->actions ? call->actions->move_count : 0};
    snprintf(head->path, sizeof head->path, "%s", request->path);
    snprintf(head->base_dir, sizeof head->base_dir, "%s",
             request->base_dir ? request->base_dir : "");
    if (overrides_size > 0) {
        memcpy(head_overrides(head), request->overrides, overrides_size);
    }
    char *next = mempcpy(head_text(head), call->text->text, text_size);
    for (size_t i = 0; i < action_count; i++) {
        next = stpcpy(next, call->actions->names[i]) + 1;
    }
    return head;
}

/** Reports that a run was stopped, at its last known line. */
static void fail_at_location(ScriptResult *result, const char *message) {
    script_result_fail(result, result->location, message, strlen(message));
}

/** Sets the error of a run that its worker did not complete. */
static void set_failure(const ScriptRequest *request, const WorkerReply *reply,
                        ScriptResult *result) {
    char message[ERROR_MESSAGE_SIZE], reason[WORKER_REASON_SIZE];
    bool is_stopped = request->stop && atomic_load(request->stop);
    if (worker_reply_start_failure(reply, reason)) {
        error_set(&result->error, STATUS_FAILED, "no process to run a scene in: %s", reason);
    } else if (reply->end == WORKER_TIMED_OUT && is_stopped) {
        error_set(&result->error, STATUS_INTERRUPTED, "interrupted");
    } else if (reply->end == WORKER_TIMED_OUT && reply->is_stalled) {
        snprintf(message, sizeof message, gettext("the scene has not ended after %g s"),
                 worker_clock_wall_limit(request->time_limit));
        fail_at_location(result, message);
    } else if (reply->end == WORKER_TIMED_OUT) {
        snprintf(message, sizeof message,
                 gettext("the scene ran for more than %g s of processor time"),
                 request->time_limit);
        fail_at_location(result, message);
    } else if (worker_reply_is_interrupted(reply)) {
        error_set(&result->error, STATUS_INTERRUPTED, "interrupted");
    } else {
        snprintf(message, sizeof message, gettext("the process that ran the scene died (%s)"),
                 reply->detail ? strsignal(reply->detail) : gettext("nobody knows why"));
        fail_at_location(result, message);
    }
}

bool script_worker_run(const ScriptCall *call, size_t *block_size, Error *error) {
    const ScriptRequest *request = call->request;
    size_t size = 0;
    ScriptResult *result = script_result_create(request->path);
    void *bytes = result ? pack_request(call, &size) : NULL;
    bool is_good = bytes || error_set(error, STATUS_FAILED, "no memory to run a scene");
    if (is_good) {
        const WorkerMonitor monitor = {.stop = request->stop};
        ScriptResponder responder = {.request = request, .is_lesson = call->actions};
        const WorkerReply reply =
            worker_process_call_once(&(WorkerCall){.program = request->worker,
                                                   .task = call->task,
                                                   .request = bytes,
                                                   .request_size = size,
                                                   .time_limit = request->time_limit,
                                                   .monitor = request->stop ? &monitor : NULL,
                                                   .answer = script_question_answer,
                                                   .answer_context = &responder,
                                                   .report = result,
                                                   .report_capacity = sizeof *result,
                                                   .block = call->block,
                                                   .block_capacity = call->capacity});
        script_result_repair(result, request->path);
        if (reply.end != WORKER_FINISHED ||
            (result->error.status == STATUS_OK && reply.block_size == 0)) {
            set_failure(request, &reply, result);
        }
        if (responder.is_system_short && result->error.status == STATUS_SCENE) {
            result->error.status = STATUS_FAILED;
        }
        *block_size = reply.block_size;
        is_good = result->error.status == STATUS_OK;
        if (!is_good && error) {
            *error = result->error;
        }
    }
    free(bytes);
    script_result_destroy(result);
    return is_good;
}

// --- in the worker -------------------------------------------------------------------------------

/**
 * Copies the text out of a request, because the run frees it.
 * @return The text; empty without memory.
 */
static ScriptText unpack_text(const ScriptJobHead *head) {
    ScriptText text = {.text = malloc(head->text_size + 1), .size = head->text_size};
    if (!text.text) {
        _Exit(EXIT_FAILURE);
    }
    memcpy(text.text, head_text(head), head->text_size);
    return text;
}

/** Runs the text of a run, and fills its report. */
typedef void ExecuteFunction(ScriptRun *run);

/**
 * Runs a text.
 * @param job             The job; its report is set here, its block by the caller.
 * @param run             The run; its request is set here.
 * @param shape_keywords  The shapes that it may create; NULL ends the list.
 * @param execute         Runs it.
 * @return Whether it ended without an error.
 */
static bool run_job(WorkerJob *job, ScriptRun *run, const Keyword *const *shape_keywords,
                    ExecuteFunction *execute) {
    const ScriptJobHead *head = job->request;
    const ScriptText text = unpack_text(head);
    const ScriptRequest request = {.path = head->path,
                                   .base_dir = head->has_base_dir ? head->base_dir : NULL,
                                   .time = head->time,
                                   .memory_limit = head->memory_limit,
                                   .overrides = head_overrides(head),
                                   .override_count = head->override_count,
                                   .shape_keywords = shape_keywords};
    run->request = &request;
    run->text = &text;
    run->job = job;
    run->result = script_result_create(head->path);
    if (!run->result) {
        _Exit(EXIT_FAILURE);
    }
    job->report = run->result;
    job->report_size = script_result_size(run->result);
    job->owns_report = true;
    worker_job_ready();
    worker_enter_sandbox(head->memory_limit + SCRIPT_NATIVE_MEMORY_LIMIT);
    execute(run);
    return run->result->error.status == STATUS_OK;
}

/**
 * Makes a scene of a text.
 * @param job             The job.
 * @param shape_keywords  The shapes that it may create; NULL ends the list.
 * @param execute         Fills the scene.
 */
static void make_scene(WorkerJob *job, const Keyword *const *shape_keywords,
                       ExecuteFunction *execute) {
    const ScriptJobHead *head = job->request;
    Error error;
    Scene *scene = scene_create_at(head->address, &error);
    if (!scene) {
        worker_exit_to_retry();
    }
    ScriptRun run = {.dialect = &scene_dialect, .scene = scene};
    if (run_job(job, &run, shape_keywords, execute)) {
        job->block = scene;
        job->block_size = scene_block_size(scene);
    }
}

void script_worker_scene(WorkerJob *job, const Keyword *const *shape_keywords) {
    make_scene(job, shape_keywords, script_run_execute);
}

void script_worker_nff(WorkerJob *job) {
    make_scene(job, scene_shape_keywords, nff_execute);
}

/** @return The names of actions in a request, ended by NULL. */
static const char **unpack_action_names(const ScriptJobHead *head) {
    const char **names = calloc(head->action_count + 1, sizeof *names);
    const char *next = head_text(head) + head->text_size;
    for (size_t i = 0; names && i < head->action_count; i++) {
        names[i] = next;
        next += strlen(next) + 1;
    }
    if (!names) {
        _Exit(EXIT_FAILURE);
    }
    return names;
}

void script_worker_lesson(WorkerJob *job) {
    const ScriptJobHead *head = job->request;
    Error error;
    Lesson *lesson = lesson_create_at(head->address, &error);
    if (!lesson) {
        worker_exit_to_retry();
    }
    const ActionNames actions = {.names = unpack_action_names(head),
                                 .move_count = head->move_count};
    LessonBuilder builder = {.lesson = lesson, .actions = &actions};
    ScriptRun run = {.dialect = &lesson_dialect, .lesson_builder = &builder};
    if (run_job(job, &run, NULL, script_run_execute)) {
        job->block = lesson;
        job->block_size = lesson_block_size(lesson);
    }
}
