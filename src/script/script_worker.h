/**
 * @file
 * @brief Execution of scene and lesson files in a worker process: both sides.
 */
#ifndef DIOPTRE_SCRIPT_SCRIPT_WORKER_H
#define DIOPTRE_SCRIPT_SCRIPT_WORKER_H

#include "assets/process/worker_main.h"
#include "dioptre/script.h"
#include "script/script_text.h"

/** Names of the tasks, see #WorkerTask. */
#define SCRIPT_SCENE_TASK "scene"
#define SCRIPT_NFF_TASK "nff"       /**< See #SCRIPT_SCENE_TASK. */
#define SCRIPT_LESSON_TASK "lesson" /**< See #SCRIPT_SCENE_TASK. */

/** A text to run in a worker. */
typedef struct ScriptCall {
    const ScriptRequest *request; /**< The request. */
    const char *task;             /**< One of the names of tasks. */
    const ScriptText *text;       /**< The text. */
    const ActionNames *actions;   /**< What a lesson can name; NULL: the text is a scene. */
    void *block; /**< Memory for the scene or lesson. The worker creates it at the same address, so
                    that its pointers are valid here. */
    size_t capacity; /**< Bytes of #block. */
} ScriptCall;

/**
 * Runs a text in a worker.
 * @param call             The call.
 * @param[out] block_size  Bytes of the scene or lesson, which is not checked yet.
 * @param[out] error       What is wrong, with file and line.
 * @return Whether there is one; if not, #ScriptCall.block may hold anything.
 */
bool script_worker_run(const ScriptCall *call, size_t *block_size, Error *error);

/**
 * Runs the text of a scene; the worker's side.
 * @param job             The job.
 * @param shape_keywords  The shapes that it may create; NULL ends the list.
 */
void script_worker_scene(WorkerJob *job, const Keyword *const *shape_keywords);

/** Reads a scene in NFF; the worker's side. @param job The job. */
void script_worker_nff(WorkerJob *job);

/** Runs the text of a lesson; the worker's side. @param job The job. */
void script_worker_lesson(WorkerJob *job);

#endif
