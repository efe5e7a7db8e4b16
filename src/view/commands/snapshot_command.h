/**
 * @file
 * @brief The finished picture into a file, and its view to standard output.
 */
#ifndef DIOPTRE_VIEW_COMMANDS_SNAPSHOT_COMMAND_H
#define DIOPTRE_VIEW_COMMANDS_SNAPSHOT_COMMAND_H

#include "view/app.h"

/**
 * Keeps the picture.
 * @param[in,out] app  The view, with the picture finished.
 * @param folder  Folder for the file, which is numbered.
 * @param name  First part of its name.
 * @return Whether it is done.
 */
bool snapshot_take(App *app, const char *folder, const char *name, Error *error);

#endif
