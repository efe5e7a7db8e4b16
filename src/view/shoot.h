/**
 * @file
 * @brief The finished picture into a file, and its view to standard output.
 */
#ifndef DIOPTRE_VIEW_SHOOT_H
#define DIOPTRE_VIEW_SHOOT_H

#include "view/state.h"

/**
 * Keeps the picture.
 * @param[in,out] view  The view, with the picture finished.
 * @param folder        Folder for the file, which is numbered.
 * @param name          First part of its name.
 * @param[out] error    What is wrong.
 * @return Whether it is done.
 */
bool shoot(View *view, const char *folder, const char *name, Error *error);

#endif
