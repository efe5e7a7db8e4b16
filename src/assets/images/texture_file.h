/**
 * @file
 * @brief Reading of the pictures of a scene.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_TEXTURE_FILE_H
#define DIOPTRE_ASSETS_IMAGES_TEXTURE_FILE_H

#include "assets/asset_budget.h"
#include "assets/images/image_format.h"
#include "assets/images/image_worker.h"
#include "dioptre/scene.h"

/** Limit of the processor time of reading a picture of a scene, seconds. */
#define TEXTURE_FILE_TIME_LIMIT 10.0
/** Limit of the data of the libraries for a picture of a scene, bytes. */
#define TEXTURE_FILE_MEMORY_LIMIT ((size_t)2 << 30)
/** Largest size of a decoded picture of a scene, bytes. */
#ifndef TEXTURE_FILE_CAPACITY // A page has less: src/web/memory.h.
#define TEXTURE_FILE_CAPACITY ((size_t)1 << 30)
#endif

/**
 * Checks the extension of a picture file; nothing is opened.
 * @param path        The file.
 * @param[out] error  The known extensions (#STATUS_SCENE), without the path.
 * @return Whether it is that of a readable format.
 */
bool texture_file_check(const char *path, Error *error);

/**
 * Reads a picture file: BMP directly, other formats by the picture module in a worker.
 * @param file          The file.
 * @param[in,out] budget  What the scene has left.
 * @param[out] texture  The picture, to be freed with #texture_release; NULL on errors.
 * @param[out] error    What is wrong, without the path (#STATUS_SCENE; #STATUS_FAILED without
 *                      module, memory or process).
 * @return Whether it was read.
 */
bool texture_file_read(const AssetFile *file, AssetBudget *budget, Texture **texture, Error *error);

#endif
