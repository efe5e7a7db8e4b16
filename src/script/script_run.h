/**
 * @file
 * @brief Runs the text of a scene or a lesson, in a worker process, and fills a report.
 */
#ifndef DIOPTRE_SCRIPT_SCRIPT_RUN_H
#define DIOPTRE_SCRIPT_SCRIPT_RUN_H

#include "assets/process/worker_main.h"
#include "dioptre/script.h"
#include "script/script_result.h"
#include "script/script_text.h"

#include <lua.h>

/** A lesson that is being read; see lesson_text_localized.h. */
typedef struct LessonBuilder LessonBuilder;

/** What a text may say. */
typedef struct ScriptDialect {
    void (*open)(lua_State *L);  /**< Makes its words known, beyond those of Lua. */
    void (*check)(lua_State *L); /**< Raises an error unless what was said is complete. */
} ScriptDialect;

/** What a scene may say. */
extern const ScriptDialect scene_dialect;

/** Something to be made from a text: a scene, or a lesson. */
typedef struct ScriptRun {
    const ScriptRequest *request;  /**< What was asked for. */
    const ScriptDialect *dialect;  /**< What the text may say. */
    const ScriptText *text;        /**< The text of the file. */
    Scene *scene;                  /**< What a scene's text adds to. */
    LessonBuilder *lesson_builder; /**< What a lesson's text adds to; NULL: it is a scene. */
    ScriptResult *result;          /**< Its report. */
    WorkerJob *job;                /**< The job in whose report it is. */
} ScriptRun;

/**
 * Runs a text. To be called in a worker process: nothing is freed, and it may never return.
 * @param[in,out] run  The text; what it makes is filled, and its report.
 */
void script_run_execute(ScriptRun *run);

#endif
