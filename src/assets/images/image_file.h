/**
 * @file
 * @brief Picture files. BMP is read and written here; every other format by OpenImageIO, whose
 *        module is opened only when such a format is asked for.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_IMAGE_FILE_H
#define DIOPTRE_ASSETS_IMAGES_IMAGE_FILE_H

#include "base/picture.h"

/**
 * Says whether a picture could be written to a path, before time is spent on drawing it.
 * @param path        The file.
 * @param[out] error  Which endings there are, what is missing (#STATUS_USAGE or #STATUS_FAILED).
 * @return Whether the ending is known, the folder can be written and the format's module is there.
 */
bool image_file_check(const char *path, Error *error);

/**
 * Says whether a file holds linear light, so that a picture that is to be written to it should keep
 * its own.
 * @param path  The file.
 * @return Whether its ending names such a format.
 */
bool image_file_is_linear(const char *path);

/**
 * Writes a picture, in the format that the file's ending names. It is written beside its place
 * and renamed into it: the old file stays whole until the new one is.
 * @param path        The file.
 * @param picture     The picture.
 * @param[out] error  What is wrong (#STATUS_FAILED; #STATUS_USAGE for an unknown ending).
 * @return Whether it is there, all of it.
 */
bool image_file_write(const char *path, const Picture *picture, Error *error);

/**
 * Writes a BMP file that must not be there yet: never over another file.
 * @param path        The file.
 * @param picture     The picture.
 * @param[out] exists Whether it failed because there is such a file already.
 * @param[out] error  What is wrong.
 * @return Whether it is there, all of it.
 */
bool image_file_write_new(const char *path, const Picture *picture, bool *exists, Error *error);

/**
 * Reads a picture of at most #IMAGE_SIZE_MAXIMUM by as many pixels.
 * @param path          The file.
 * @param[out] picture  The picture; give it back with #picture_deinit.
 * @param[out] error    What is wrong (#STATUS_SCENE).
 * @return Whether it was read; otherwise the picture is empty.
 */
bool image_file_read(const char *path, Picture *picture, Error *error);

#endif
