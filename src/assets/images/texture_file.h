/**
 * @file
 * @brief Pictures that a scene names: from the path to a texture.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_TEXTURE_FILE_H
#define DIOPTRE_ASSETS_IMAGES_TEXTURE_FILE_H

#include "assets/images/image_format.h"
#include "assets/images/image_worker.h"
#include "dioptre/scene.h"

/** Seconds that reading a picture of a scene may take. */
#define TEXTURE_FILE_TIME_LIMIT 10.0
/** Bytes that the libraries may take for a picture of a scene. */
#define TEXTURE_FILE_MEMORY_LIMIT ((size_t)2 << 30)
/** Bytes that a picture of a scene may take, decoded. */
#define TEXTURE_FILE_CAPACITY ((size_t)1 << 30)

/**
 * Says whether a file may be a picture, by its name and kind; does not read it.
 * @param[out] error  Why not (#STATUS_SCENE), without the path.
 * @return Whether it is a regular file with the ending of a format that can be read.
 */
bool texture_file_check(const char *path, Error *error);

/**
 * Reads a picture file. BMP is read here; every other format by the picture module, in a
 * worker.
 * @param[out] texture  The picture, to be given back with #texture_release; NULL if anything is
 *         wrong.
 * @param[out] error  What is wrong, without the path (#STATUS_SCENE; #STATUS_FAILED without module,
 *         memory or process).
 * @return Whether it was read.
 */
bool texture_file_read(const char *path, Texture **texture, Error *error);

#endif
