/**
 * @file
 * @brief A view, camera and lights, as text of the scene language.
 */
#ifndef DIOPTRE_VIEW_STATE_SCENE_TEXT_H
#define DIOPTRE_VIEW_STATE_SCENE_TEXT_H

#include "dioptre/scene.h"

#include <stdio.h>

/** Prints camera and lights on one line, without its end, ready to be pasted into a scene file.
 *  Numbers are printed with all their digits: read again they are the same numbers. @param scene
 *  The scene, as it is seen. */
void scene_text_print(const Scene *scene, FILE *file);

/** @return The same in memory, to be freed; NULL without memory. */
char *scene_text_create(const Scene *scene);

#endif
