/**
 * @file
 * @brief Execution of scene and lesson files in a worker process.
 */
#ifndef DIOPTRE_SCRIPT_SCRIPT_RUN_H
#define DIOPTRE_SCRIPT_SCRIPT_RUN_H

#include "assets/process/worker_main.h"
#include "dioptre/script.h"
#include "script/script_result.h"
#include "script/script_text.h"

#include <lua.h>

/** A lesson being read; see script/lesson_functions.h. */
typedef struct LessonBuilder LessonBuilder;

/** The functions of a kind of file: scenes or lessons. */
typedef struct ScriptDialect {
    void (*open)(lua_State *L);  /**< Adds the functions to the globals. */
    void (*check)(lua_State *L); /**< Raises an error if the result is incomplete. */
} ScriptDialect;

/** The functions of scene files. */
extern const ScriptDialect scene_dialect;

/** A run of a scene or lesson file. */
typedef struct ScriptRun {
    const ScriptRequest *request;  /**< The request. */
    const ScriptDialect *dialect;  /**< The functions that the file may use. */
    const ScriptText *text;        /**< Text of the file. */
    Scene *scene;                  /**< The scene to fill. */
    LessonBuilder *lesson_builder; /**< The lesson to fill; NULL: the file is a scene. */
    ScriptResult *result;          /**< The report. */
    WorkerJob *job;                /**< The worker's job, which sends the report. */
} ScriptRun;

/** Sets the C locale for all but messages, so that scenes run the same on every system. */
void script_run_use_c_locale(void);

/**
 * Runs a text. Only for worker processes: it frees nothing, and it may never return.
 * @param[in,out] run  The run; its result and its report are filled.
 */
void script_run_execute(ScriptRun *run);

#endif
