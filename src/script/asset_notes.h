/**
 * @file
 * @brief Notes about what was left out of the files of a scene.
 */
#ifndef DIOPTRE_SCRIPT_ASSET_NOTES_H
#define DIOPTRE_SCRIPT_ASSET_NOTES_H

#include "dioptre/scene.h"

/**
 * Adds a note to a scene for each of its files of which something is missing: polygons that cannot
 * be cut, statements that are not understood, a picture that is cut off.
 * @param[in,out] scene  The scene, with all its files read.
 * @param[out] error     What is wrong.
 * @return false when the scene's memory is full.
 */
bool asset_notes_add(Scene *scene, Error *error);

#endif
