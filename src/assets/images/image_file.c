/**
 * @file
 * @brief Reading and writing of picture files by extension.
 */
#include "assets/images/image_file.h"

#include "assets/images/bmp.h"
#include "assets/images/image_format.h"
#include "assets/images/image_worker.h"
#include "base/atomic_file.h"
#include "base/regular_file.h"
#include "dioptre/scene.h"

#include <libintl.h>
#include <string.h>
#include <unistd.h>

/**
 * Adds the path to an error of reading.
 * @param[in,out] error  The error; may be NULL.
 * @param path           The path.
 * @return false, always.
 */
static bool set_read_error(Error *error, const char *path) {
    return error_prefix(error, "cannot read '%s': ", path);
}

/**
 * Adds the path to an error of writing.
 * @param[in,out] error  The error; may be NULL.
 * @param path           The path.
 * @return false, always.
 */
static bool set_write_error(Error *error, const char *path) {
    return error_prefix(error, "cannot write '%s': ", path);
}

/**
 * Finds the format for writing a file.
 * @param path        The file. Devices and FIFOs, such as `/dev/stdout`, may have no extension:
 *                    BMP.
 * @param[out] error  The known extensions (#STATUS_USAGE).
 * @return The format; NULL: unknown.
 */
static const ImageFormat *format_to_write(const char *path, Error *error) {
    const ImageFormat *format = image_format_by_extension(path);
    OutputPath output = {.mode = 0};
    if (!format && output_path_resolve(&output, path) && output_path_is_direct(&output)) {
        return image_format_bmp();
    }
    if (format && !format->is_read_only) {
        return format;
    }
    error_set(error, STATUS_USAGE, "its name must end in .%s", gettext(IMAGE_WRITE_EXTENSIONS));
    return NULL;
}

bool image_file_is_linear(const char *path) {
    const ImageFormat *format = image_format_by_extension(path);
    return format && format->is_linear;
}

bool image_file_check(const char *path, Error *error) {
    const ImageFormat *format = format_to_write(path, error);
    bool can_be_written = format && atomic_file_check(path, error) &&
                          (!format->plugin_name || image_worker_check(error));
    return can_be_written || set_write_error(error, path);
}

/** Writes a picture in a format. @return Whether all was written to the stream. */
static bool write_format(const ImageFormat *format, const Picture *picture, FILE *stream,
                         Error *error) {
    if (picture->width > IMAGE_SIZE_MAXIMUM || picture->height > IMAGE_SIZE_MAXIMUM) {
        return error_set(error, STATUS_FAILED, "%d x %d pixels: each must be at most %d",
                         picture->width, picture->height, IMAGE_SIZE_MAXIMUM);
    }
    return format->plugin_name
               ? image_worker_write(format->plugin_name, format->is_linear, picture, stream, error)
               : bmp_write(picture, stream, error);
}

/**
 * Writes a picture to a temporary file and renames it.
 * @param file        The open file; ended here.
 * @param format      The format.
 * @param picture     The picture.
 * @param[out] error  What is wrong.
 * @return Whether the file is complete.
 */
static bool write_and_commit(AtomicFile *file, const ImageFormat *format, const Picture *picture,
                             Error *error) {
    if (!write_format(format, picture, file->stream, error)) {
        atomic_file_discard(file);
        return false;
    }
    return atomic_file_commit(file, error);
}

/** Writes a picture that may replace another. See #image_file_write. */
static bool write_replacing(const char *path, AtomicMode mode, const Picture *picture,
                            Error *error) {
    AtomicFile file;
    const ImageFormat *format = format_to_write(path, error);
    bool is_written = format && atomic_file_open(&file, path, mode, error) &&
                      write_and_commit(&file, format, picture, error);
    return is_written || set_write_error(error, path);
}

bool image_file_write(const char *path, const Picture *picture, Error *error) {
    return write_replacing(path, ATOMIC_REPLACE, picture, error);
}

bool image_file_write_unsynced(const char *path, const Picture *picture, Error *error) {
    return write_replacing(path, ATOMIC_REPLACE_UNSYNCED, picture, error);
}

bool image_file_write_new(const char *path, const Picture *picture, bool *exists, Error *error) {
    AtomicFile file;
    const ImageFormat *format = format_to_write(path, error);
    bool is_written = format && atomic_file_open(&file, path, ATOMIC_NEW, error) &&
                      write_and_commit(&file, format, picture, error);
    *exists = format && !is_written && file.exists;
    return is_written || set_write_error(error, path);
}

/** Limits of reading a picture to compare; sufficient for the largest that can be written. */
static const ImageReadLimits compare_limits = {
    .time_limit = 60,
    .memory_limit = (size_t)8 << 30,
    .texture_capacity = sizeof(Texture) + TEXEL_CHANNELS * sizeof(float) *
                                              (size_t)IMAGE_SIZE_MAXIMUM * IMAGE_SIZE_MAXIMUM};

/** Converts an 8-bit texture to a picture. @return false without memory. */
static bool picture_from_texture(const Texture *texture, Picture *picture, Error *error) {
    if (!picture_init(picture, texture->width, texture->height, error)) {
        return false;
    }
    size_t count = (size_t)texture->width * (size_t)texture->height * TEXEL_CHANNELS;
    if (!texture->is_hdr) {
        memcpy(picture->pixels, texture_ldr_texels(texture), count);
        return true;
    }
    Encoder encoder;
    encoder_init(&encoder, ENCODING_SRGB);
    for (size_t i = 0; i < count; i++) {
        picture->pixels[i] = encoder_encode(&encoder, texture_hdr_texels(texture)[i]);
    }
    return true;
}

/** Reads an open picture file. @return Whether it was read; if not, the picture is empty. */
static bool read_open_file(const ImageFormat *format, int file, Picture *picture, Error *error) {
    if (!format->plugin_name) {
        return bmp_read(file, picture, error);
    }
    Texture *texture;
    bool is_read = image_worker_call(NULL, &(ImageSource){format->plugin_name, file},
                                     &compare_limits, NULL, &texture, error) &&
                   picture_from_texture(texture, picture, error);
    texture_release(texture);
    return is_read;
}

bool image_file_read(const char *path, Picture *picture, Error *error) {
    *picture = (Picture){0};
    struct stat found;
    const ImageFormat *format = image_format_by_extension(path);
    if (!format) {
        error_set(error, STATUS_SCENE, "its name must end in .%s", gettext(IMAGE_READ_EXTENSIONS));
        return set_read_error(error, path);
    }
    int file = regular_file_open(path, &found, error);
    bool is_read = file >= 0 && read_open_file(format, file, picture, error);
    if (file >= 0) {
        close(file);
    }
    return is_read || set_read_error(error, path);
}
