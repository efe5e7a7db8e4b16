/**
 * @file
 * @brief What the child does: it runs the text of a scene or of a lesson, and leaves a report.
 */
#ifndef SCRIPT_RUN_H
#define SCRIPT_RUN_H

#include "dioptre/script.h"
#include "script/report.h"
#include "script/source.h"

#include <lua.h>

/** A lesson that is being read; see lesson_words.h. */
typedef struct LessonRun LessonRun;

/** What a text may say. */
typedef struct Vocabulary {
    void (*open)(lua_State *L);  /**< Makes its words known, beyond those of Lua. */
    void (*check)(lua_State *L); /**< Raises an error unless what was said is complete. */
} Vocabulary;

/** What a scene may say. */
extern const Vocabulary scene_vocabulary;

/** Something to be made from a text: a scene, or a lesson. */
typedef struct Run {
    const ScriptRequest *request; /**< What was asked for. */
    const Vocabulary *vocabulary; /**< What the text may say. */
    const Source *source;         /**< The text of the file. */
    Scene *scene;                 /**< What a scene's text adds to; shared with the parent. */
    LessonRun *lesson;            /**< What a lesson's text adds to; NULL: it is a scene. */
    Report *report;               /**< How it went; shared with the parent. */
} Run;

/**
 * Runs a text. To be called in a child process: nothing is given back, and it may take for ever.
 * @param[in,out] run  The text; what it makes is filled, and its report is done.
 */
void run_text(Run *run);

#endif
