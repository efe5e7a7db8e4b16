/**
 * @file
 * @brief From a file to what a child has made of it: scenes and lessons alike.
 */
#ifndef SCRIPT_LAUNCH_H
#define SCRIPT_LAUNCH_H

#include "script/run.h"

/**
 * Reads a file that is to be run.
 * @param path         The path.
 * @param[out] source  The text; to be released.
 * @param[out] error   What is wrong.
 * @return Whether it is text.
 */
bool launch_read(const char *path, Source *source, Error *error);

/**
 * Runs a text in a child, and sees that there is an error unless it was run to its end.
 * @param run         What to run.
 * @param[out] error  What is wrong.
 * @return Whether it is complete.
 */
bool launch_run(Run *run, Error *error);

#endif
