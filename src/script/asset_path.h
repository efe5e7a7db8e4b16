/**
 * @file
 * @brief Opening of the files that a scene names: in its folder or below.
 */
#ifndef DIOPTRE_SCRIPT_ASSET_PATH_H
#define DIOPTRE_SCRIPT_ASSET_PATH_H

#include "dioptre/script.h"

#include <limits.h>
#include <sys/stat.h>

/**
 * Opens a file that a scene names. Symbolic links are followed; their targets must be in the
 * folder. The descriptor itself is checked, so a link that is replaced meanwhile opens nothing
 * outside. A scene does not learn what lies outside: the message is that of a missing file.
 * @param request            The request, with the folder.
 * @param name               Name of the file, relative to the folder of the scene.
 * @param[out] display_path  Its path for messages.
 * @param[out] real_path     Its absolute path without links; where the system has no `/proc`, as
 *                           display_path.
 * @param[out] info          Its properties.
 * @param[out] error         What is wrong.
 * @return A descriptor of a regular file, open for reading; -1 on errors.
 */
int asset_path_open(const ScriptRequest *request, const char *name, char display_path[PATH_MAX],
                    char real_path[PATH_MAX], struct stat *info, Error *error);

#endif
