/**
 * @file
 * @brief The name of a scene: it stands in titles, and in the names of what is made of it.
 */
#ifndef DIOPTRE_BASE_SCENE_NAME_H
#define DIOPTRE_BASE_SCENE_NAME_H

#include <stddef.h>

/**
 * Finds a scene's name: its file's, without folder and ending; no file is looked at.
 * @param path       The scene's file; `-`, standard input, is called `scene`.
 * @param[out] name  The name, cut to its size.
 * @param size       Bytes of the name with the final zero, at least 1.
 */
void scene_name_from_path(const char *path, char *name, size_t size);

#endif
