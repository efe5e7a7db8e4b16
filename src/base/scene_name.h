/**
 * @file
 * @brief The name of a scene, for titles and names of output files, and its format.
 */
#ifndef DIOPTRE_BASE_SCENE_NAME_H
#define DIOPTRE_BASE_SCENE_NAME_H

#include <stddef.h>

/**
 * Finds the name of a scene: its file name without folder and extension. No file is read.
 * @param path       Path of the scene file; the name of `-`, standard input, is `scene`.
 * @param[out] name  The name, cut to its size.
 * @param size       Size of the name with the final zero, at least 1.
 */
void scene_name_from_path(const char *path, char *name, size_t size);

/** Format of a scene file. */
typedef enum {
    SCENE_FORMAT_NONE, /**< Its name does not say so: read as Lua if a user names it. */
    SCENE_FORMAT_LUA,  /**< The scene language: `.lua`. */
    SCENE_FORMAT_NFF   /**< The Neutral File Format: `.nff`. */
} SceneFormat;

/** @return The format that the ending of a file says. @param path Its path; it is not read. */
SceneFormat scene_format_of(const char *path);

#endif
