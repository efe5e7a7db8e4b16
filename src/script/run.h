/**
 * @file
 * @brief What the child does: it runs a scene's text, and leaves a report.
 */
#ifndef SCRIPT_RUN_H
#define SCRIPT_RUN_H

#include "dioptre/script.h"
#include "script/report.h"
#include "script/source.h"

/** A scene to be made from a text. */
typedef struct Run {
    const ScriptRequest *request; /**< What was asked for. */
    const Source *source;         /**< The text of the scene file. */
    Scene *scene;                 /**< What the text adds to; shared with the parent. */
    Report *report;               /**< How it went; shared with the parent. */
} Run;

/**
 * Runs a scene's text. To be called in a child process: nothing is given back, and it may take for
 * ever.
 * @param[in,out] run  The scene; filled, and its report is done.
 */
void run_scene(Run *run);

#endif
