/**
 * @file
 * @brief Pictures that a scene names: from the path to a texture.
 */
#include "assets/texture_file.h"

#include "assets/bmp.h"
#include "assets/plain_file.h"

#include <libintl.h>
#include <string.h>
#include <unistd.h>

/** What reading a picture of a scene may take. */
static const ImagesLimits scene_limits = {TEXTURE_FILE_SECONDS, TEXTURE_FILE_MEMORY,
                                          TEXTURE_FILE_ROOM};

/**
 * Finds the format of a file.
 * @param path        The file.
 * @param[out] error  Which endings there are.
 * @return The format, or NULL.
 */
static const ImageFormat *find_format(const char *path, Error *error) {
    const ImageFormat *format = image_format_by_ending(path);
    if (!format) {
        error_set(error, STATUS_SCENE, "a picture's name must end in .%s",
                  gettext(IMAGE_READ_ENDINGS));
    }
    return format;
}

bool texture_file_check(const char *path, Error *error) {
    struct stat found;
    int file = find_format(path, error) ? plain_file_open(path, &found, error) : -1;
    if (file >= 0) {
        close(file);
    }
    return file >= 0;
}

/**
 * Reads an open BMP file.
 * @param file        The file.
 * @param[out] error  What is wrong.
 * @return The picture, or NULL.
 */
static Texture *read_bmp(int file, Error *error) {
    Picture picture;
    Texture *texture = NULL;
    if (bmp_read(file, &picture, error)) {
        texture = texture_create(picture.width, picture.height, false, error);
    }
    if (texture) {
        memcpy(texture_steps(texture), picture.pixels, texture_size(texture) - sizeof *texture);
    }
    picture_release(&picture);
    return texture;
}

bool texture_file_read_open(const ImageFormat *format, int file, const ImagesLimits *limits,
                            Texture **texture, Error *error) {
    char path[sizeof "/proc/self/fd/-2147483648"];
    snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    *texture = NULL;
    const ImagesModule *module = images_load(error);
    return module && images_child_read(module, format->module, path, limits, texture, error);
}

/**
 * Reads an open file.
 * @param format        Its format.
 * @param file          The file.
 * @param[out] texture  The picture.
 * @param[out] error    What is wrong.
 * @return Whether it was read.
 */
static bool read_open(const ImageFormat *format, int file, Texture **texture, Error *error) {
    if (format->module) {
        return texture_file_read_open(format, file, &scene_limits, texture, error);
    }
    *texture = read_bmp(file, error);
    return *texture != NULL;
}

bool texture_file_read(const char *path, Texture **texture, Error *error) {
    *texture = NULL;
    struct stat before;
    const ImageFormat *format = find_format(path, error);
    int file = format ? plain_file_open(path, &before, error) : -1;
    if (file < 0) {
        return false;
    }
    bool is_read = read_open(format, file, texture, error);
    if (is_read && !plain_file_is_same(file, &before, error)) {
        texture_release(*texture);
        *texture = NULL;
        is_read = false;
    }
    close(file);
    return is_read;
}
