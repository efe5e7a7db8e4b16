/**
 * @file
 * @brief From a file to what a child has made of it: scenes and lessons alike.
 */
#ifndef DIOPTRE_SCRIPT_SANDBOXED_RUN_H
#define DIOPTRE_SCRIPT_SANDBOXED_RUN_H

#include "script/script_run.h"

/**
 * Reads a file that is to be run.
 * @param[out] text  The text; to be released.
 * @return Whether it is text.
 */
bool script_text_load(const char *path, ScriptText *text, Error *error);

/** Runs a text in a child, and sees that there is an error unless it was run to its end. @return
 *  Whether it is complete. */
bool script_run_sandboxed(ScriptRun *run, Error *error);

#endif
