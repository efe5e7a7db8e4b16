/**
 * @file
 * @brief Reading of the pictures of a scene.
 */
#include "assets/images/texture_file.h"

#include "assets/images/bmp.h"
#include "base/regular_file.h"

#include <libintl.h>
#include <string.h>

/** Limits of reading a picture of a scene. */
static const ImageReadLimits scene_limits = {.time_limit = TEXTURE_FILE_TIME_LIMIT,
                                             .memory_limit = TEXTURE_FILE_MEMORY_LIMIT,
                                             .texture_capacity = TEXTURE_FILE_CAPACITY};

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

/** Reads a BMP file. @return The texture; NULL on errors. */
static Texture *read_bmp(const AssetFile *file, AssetBudget *budget, Error *error) {
    Picture picture;
    Texture *texture = NULL;
    // Its pixels are not compressed, and the header is checked against the size of the file.
    if (asset_budget_take_memory(budget, (size_t)file->info.st_size, error) &&
        bmp_read(file->descriptor, &picture, error)) {
        texture = texture_create(picture.width, picture.height, false, error);
        if (texture) {
            memcpy(texture_ldr_texels(texture), picture.pixels,
                   texture_block_size(texture) - sizeof *texture);
        }
        picture_deinit(&picture);
    }
    return texture;
}

bool texture_file_read(const AssetFile *file, AssetBudget *budget, Texture **texture,
                       Error *error) {
    *texture = NULL;
    const ImageFormat *format = find_format(file->path, error);
    if (format && format->plugin_name) {
        const ImageSource source = {format->plugin_name, file->descriptor};
        image_worker_call(NULL, &source, &scene_limits, budget, texture, error);
    } else if (format) {
        *texture = read_bmp(file, budget, error);
    }
    if (*texture && !regular_file_is_unchanged(file->descriptor, &file->info, error)) {
        texture_release(*texture);
        *texture = NULL;
    }
    return *texture != NULL;
}
