/**
 * @file
 * @brief Texts of scenes and lessons, run in a worker process: both ends of it.
 */
#ifndef DIOPTRE_SCRIPT_SCRIPT_WORKER_H
#define DIOPTRE_SCRIPT_SCRIPT_WORKER_H

#include "assets/process/worker_main.h"
#include "dioptre/script.h"
#include "script/script_text.h"

/** Names of the tasks, see #WorkerTask. */
#define SCRIPT_SCENE_TASK "scene"
#define SCRIPT_LESSON_TASK "lesson" /**< See #SCRIPT_SCENE_TASK. */

/** A text to be run in a worker. */
typedef struct ScriptCall {
    const ScriptRequest *request; /**< The request. */
    const char *task;             /**< #SCRIPT_SCENE_TASK or #SCRIPT_LESSON_TASK. */
    const ScriptText *text;       /**< The text of the file. */
    const ActionNames *actions;   /**< What a lesson can name; NULL: it is a scene. */
    void *block;     /**< The scene or lesson. It is made at this address in the worker, so that
                          pointers in it hold here too. */
    size_t capacity; /**< Bytes of #block. */
} ScriptCall;

/**
 * Runs a text in a worker.
 * @param[out] error  What is wrong, with file and line.
 * @return Whether the scene or lesson is complete.
 */
bool script_worker_run(const ScriptCall *call, Error *error);

/** Runs the text of a scene, in a worker. @param shape_keywords The shapes that it may create; NULL
 *  ends the list. */
void script_worker_scene(WorkerJob *job, const Keyword *const *shape_keywords);

/** Runs the text of a lesson, in a worker. */
void script_worker_lesson(WorkerJob *job);

#endif
