/**
 * @file
 * @brief What the child does: it runs the text of a scene or of a lesson, and leaves a report.
 */
#ifndef DIOPTRE_SCRIPT_SCRIPT_RUN_H
#define DIOPTRE_SCRIPT_SCRIPT_RUN_H

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
    Scene *scene;                  /**< What a scene's text adds to; shared with the parent. */
    LessonBuilder *lesson_builder; /**< What a lesson's text adds to; NULL: it is a scene. */
    ScriptResult *result;          /**< How it went; shared with the parent. */
} ScriptRun;

/**
 * Runs a text. To be called in a child process: nothing is given back, and it may take for ever.
 * @param[in,out] run  The text; what it makes is filled, and its report is done.
 */
void script_run_execute(ScriptRun *run);

#endif
