/**
 * @file
 * @brief Picture files. BMP needs no library; OpenImageIO, a module loaded at first use, handles
 * the other formats.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_IMAGE_FILE_H
#define DIOPTRE_ASSETS_IMAGES_IMAGE_FILE_H

#include "base/picture.h"

/**
 * Checks whether a picture can be written to a path, before it is rendered.
 * @param path        The file.
 * @param[out] error  The known extensions, or what is missing (#STATUS_USAGE or #STATUS_FAILED).
 * @return Whether the extension is known, the folder is writable and the module is installed.
 */
bool image_file_check(const char *path, Error *error);

/**
 * @return Whether a file's extension is that of a format of linear light; #Picture.linear is then
 *         written.
 * @param path  The file.
 */
bool image_file_is_linear(const char *path);

/**
 * Writes a picture in the format of the file's extension. It is written to a temporary file and
 * renamed: on failure the old file is intact.
 * @param path        The file.
 * @param picture     The picture.
 * @param[out] error  What is wrong (#STATUS_FAILED; #STATUS_USAGE for an unknown extension).
 * @return Whether the file is complete.
 */
bool image_file_write(const char *path, const Picture *picture, Error *error);

/** Writes a picture like #image_file_write, without waiting for the disk: after a power cut, the
 * new file may be missing or cut. */
bool image_file_write_unsynced(const char *path, const Picture *picture, Error *error);

/**
 * Writes a new file in the format of its extension; never replaces another.
 * @param path         The file.
 * @param picture      The picture.
 * @param[out] exists  Whether it failed because the file exists.
 * @param[out] error   What is wrong.
 * @return Whether the file is complete.
 */
bool image_file_write_new(const char *path, const Picture *picture, bool *exists, Error *error);

/**
 * Reads a picture, at most #IMAGE_SIZE_MAXIMUM pixels wide and high.
 * @param path          The file.
 * @param[out] picture  The picture, to be freed with #picture_deinit; empty on errors.
 * @param[out] error    What is wrong (#STATUS_SCENE).
 * @return Whether it was read.
 */
bool image_file_read(const char *path, Picture *picture, Error *error);

#endif
