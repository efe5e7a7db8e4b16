/**
 * @file
 * @brief From a file to what a child has made of it: scenes and lessons alike.
 */
#ifndef DIOPTRE_SCRIPT_SANDBOXED_RUN_H
#define DIOPTRE_SCRIPT_SANDBOXED_RUN_H

#include "script/script_run.h"

/**
 * Reads a file that is to be run.
 * @param path         The path.
 * @param[out] text  The text; to be released.
 * @param[out] error   What is wrong.
 * @return Whether it is text.
 */
bool script_text_load(const char *path, ScriptText *text, Error *error);

/**
 * Runs a text in a child, and sees that there is an error unless it was run to its end.
 * @param run         What to run.
 * @param[out] error  What is wrong.
 * @return Whether it is complete.
 */
bool script_run_sandboxed(ScriptRun *run, Error *error);

#endif
