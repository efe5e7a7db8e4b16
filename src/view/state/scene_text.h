/**
 * @file
 * @brief Camera and lights as text of the scene language.
 */
#ifndef DIOPTRE_VIEW_STATE_SCENE_TEXT_H
#define DIOPTRE_VIEW_STATE_SCENE_TEXT_H

#include "dioptre/scene.h"

#include <stdio.h>

/** Prints camera and lights on one line, without its end, to be pasted into a scene file. Numbers
 * have all digits: read again they are equal. */
void scene_text_print(const Scene *scene, FILE *file);

/** @return The same text, owned by the caller; NULL without memory. */
char *scene_text_create(const Scene *scene);

#endif
