/**
 * @file
 * @brief Reading of the pictures of a scene.
 */
#include "assets/images/texture_file.h"

#include "assets/images/bmp.h"
#include "base/regular_file.h"

#include <libintl.h>
#include <string.h>
#include <unistd.h>

/** Limits of reading a picture of a scene. */
static const ImageReadLimits scene_limits = {TEXTURE_FILE_TIME_LIMIT, TEXTURE_FILE_MEMORY_LIMIT,
                                             TEXTURE_FILE_CAPACITY};

/**
 * Finds the format of a file.
 * @param path        The file.
 * @param[out] error  The known extensions.
 * @return The format; NULL: unknown.
 */
static const ImageFormat *find_format(const char *path, Error *error) {
    const ImageFormat *format = image_format_by_extension(path);
    if (!format) {
        error_set(error, STATUS_SCENE, "a picture's name must end in .%s",
                  gettext(IMAGE_READ_EXTENSIONS));
    }
    return format;
}

bool texture_file_check(const char *path, Error *error) {
    return find_format(path, error) != NULL;
}

/** Reads an open BMP file. @return The texture; NULL on errors. */
static Texture *read_bmp(int file, Error *error) {
    Picture picture;
    Texture *texture = NULL;
    if (bmp_read(file, &picture, error)) {
        texture = texture_create(picture.width, picture.height, false, error);
    }
    if (texture) {
        memcpy(texture_ldr_texels(texture), picture.pixels,
               texture_block_size(texture) - sizeof *texture);
    }
    picture_deinit(&picture);
    return texture;
}

/** Reads an open file. @return Whether it was read. */
static bool read_open_file(const ImageFormat *format, int file, Texture **texture, Error *error) {
    if (format->plugin_name) {
        return image_worker_call(NULL, format->plugin_name, file, &scene_limits, texture, error);
    }
    *texture = read_bmp(file, error);
    return *texture != NULL;
}

bool texture_file_read(const char *path, Texture **texture, Error *error) {
    *texture = NULL;
    struct stat before;
    const ImageFormat *format = find_format(path, error);
    int file = format ? regular_file_open(path, &before, error) : -1;
    if (file < 0) {
        return false;
    }
    bool is_read = read_open_file(format, file, texture, error);
    if (is_read && !regular_file_is_unchanged(file, &before, error)) {
        texture_release(*texture);
        *texture = NULL;
        is_read = false;
    }
    close(file);
    return is_read;
}
