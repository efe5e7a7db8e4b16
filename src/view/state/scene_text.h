/**
 * @file
 * @brief Camera and lights as text of the scene language.
 */
#ifndef DIOPTRE_VIEW_STATE_SCENE_TEXT_H
#define DIOPTRE_VIEW_STATE_SCENE_TEXT_H

#include "dioptre/scene_override.h"

#include <stdio.h>

/** Prints camera and lights on one line, without its end, to be pasted into a scene file. Numbers
 * have all digits: read again they are equal. */
void scene_text_print(const Scene *scene, FILE *file);

/** @return The text of the value of a field, such as `{1, 0.5, 0}` or `"none"`, owned by the
 * caller; NULL without memory. @param numbers See #parameter_get_numbers. */
char *scene_text_of_value(const Parameter *row, const double *numbers);

/** @return The text of #scene_text_print, owned by the caller; NULL without memory. */
char *scene_text_create(const Scene *scene);

/**
 * Writes an object as the call that makes it, with its material; fields with their defaults are
 * left out.
 * @return The text, to be freed with `free`; NULL without memory, or for a distance field, which is
 *         no value but a program.
 */
char *scene_text_of_object(const Scene *scene, const SceneObject *object);

#endif
