/**
 * @file
 * @brief The files that a scene names: beside it, or in a folder below.
 */
#ifndef SCRIPT_FILE_H
#define SCRIPT_FILE_H

#include "dioptre/script.h"

#include <limits.h>

/**
 * Finds a file that a scene names; symbolic links are followed, and count by where they lead.
 * @param request     What was asked for.
 * @param name        The file's name, from the folder that the scene's files lie in.
 * @param[out] shown  Its path as the user knows it.
 * @param[out] real   Its path without links.
 * @param[out] error  What is wrong.
 * @return false if there is none, or it lies outside.
 */
bool file_find(const ScriptRequest *request, const char *name, char shown[PATH_MAX],
               char real[PATH_MAX], Error *error);

#endif
