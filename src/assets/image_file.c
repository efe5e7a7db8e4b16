/**
 * @file
 * @brief Picture files: which ending means which format.
 */
#include "dioptre/image_file.h"

#include "assets/atomic_file.h"
#include "assets/bmp.h"
#include "assets/images_child.h"

#include <errno.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

/** A format, as the ending of a file's name says it. */
typedef struct ImageFormat {
    const char *ending; /**< In small letters, without the dot. */
    const char *module; /**< What the module calls it; NULL: BMP, which needs no module. */
    bool is_linear;     /**< Whether it holds linear light and not 8-bit steps. */
} ImageFormat;

/** All formats; the last has no ending. */
static const ImageFormat formats[] = {
    {.ending = "bmp"},
    {.ending = "png", .module = "png"},
    {.ending = "exr", .module = "openexr", .is_linear = true},
    {.ending = "jpg", .module = "jpeg"},
    {.ending = "jpeg", .module = "jpeg"},
    {.ending = "tif", .module = "tiff"},
    {.ending = "tiff", .module = "tiff"},
    {.ending = "hdr", .module = "hdr", .is_linear = true},
    {0},
};

/** All endings, in words. */
#define ENDINGS "bmp, png, exr, jpg, jpeg, tif, tiff or hdr"

/**
 * Puts what was tried, and with which file, before an error.
 * @param[in,out] error  The error; may be NULL.
 * @param verb           `write` or `read`.
 * @param path           The file.
 * @return false, always.
 */
static bool fail(Error *error, const char *verb, const char *path) {
    return error_prefix(error, "cannot %s '%s': ", verb, path);
}

/**
 * Finds the format that the ending of a file's name says; small and large letters are alike.
 * @param path  The file.
 * @return The format, or NULL.
 */
static const ImageFormat *format_by_ending(const char *path) {
    const char *name = path + place_folder_length(path);
    const char *dot = strrchr(name, '.');
    for (const ImageFormat *format = formats; dot && format->ending; format++) {
        if (strcasecmp(dot + 1, format->ending) == 0) {
            return format;
        }
    }
    return NULL;
}

/**
 * Finds the format that a file is to be written in.
 * @param path        The file; what is no plain file, such as `/dev/stdout`, may have no ending
 *                    and then gets a BMP.
 * @param[out] error  Which endings there are (#STATUS_USAGE).
 * @return The format, or NULL.
 */
static const ImageFormat *format_to_write(const char *path, Error *error) {
    const ImageFormat *format = format_by_ending(path);
    Place place = {.mode = 0};
    if (!format && place_find(&place, path) && place_is_direct(&place)) {
        return &formats[0];
    }
    if (!format) {
        error_set(error, STATUS_USAGE, "its name must end in ." ENDINGS);
    }
    return format;
}

/**
 * Says whether a format's module is there, if it needs one.
 * @param format       The format.
 * @param[out] module  The module; NULL for a format that needs none.
 * @param[out] error   What is missing.
 * @return Whether it is.
 */
static bool load_module(const ImageFormat *format, const ImagesModule **module, Error *error) {
    *module = format->module ? images_load(error) : NULL;
    return *module || !format->module;
}

bool image_file_check(const char *path, Error *error) {
    const ImagesModule *module;
    const ImageFormat *format = format_to_write(path, error);
    bool can_be_written =
        format && atomic_file_check(path, error) && load_module(format, &module, error);
    return can_be_written || fail(error, "write", path);
}

/**
 * Writes a picture in a format.
 * @param format      The format.
 * @param picture     The picture.
 * @param stream      Where to.
 * @param[out] error  Why not.
 * @return Whether all was handed to the stream.
 */
static bool write_format(const ImageFormat *format, const Picture *picture, FILE *stream,
                         Error *error) {
    const ImagesModule *module;
    if (picture->width > IMAGE_SIZE_MAXIMUM || picture->height > IMAGE_SIZE_MAXIMUM) {
        return error_set(error, STATUS_FAILED, "%d x %d pixels: each must be at most %d",
                         picture->width, picture->height, IMAGE_SIZE_MAXIMUM);
    }
    if (!load_module(format, &module, error)) {
        return false;
    }
    return module ? images_write(module, format->module, format->is_linear, picture, stream, error)
                  : bmp_write(picture, stream, error);
}

/**
 * Writes a picture beside its place and moves it there.
 * @param file        The file, begun; ended here.
 * @param format      The format.
 * @param picture     The picture.
 * @param[out] error  Why not.
 * @return Whether it is there, all of it.
 */
static bool fill(AtomicFile *file, const ImageFormat *format, const Picture *picture,
                 Error *error) {
    if (!write_format(format, picture, file->stream, error)) {
        atomic_file_discard(file);
        return false;
    }
    return atomic_file_commit(file, error);
}

bool image_file_write(const char *path, const Picture *picture, Error *error) {
    AtomicFile file;
    const ImageFormat *format = format_to_write(path, error);
    bool is_written = format && atomic_file_open(&file, path, ATOMIC_REPLACE, error) &&
                      fill(&file, format, picture, error);
    return is_written || fail(error, "write", path);
}

bool image_file_write_new(const char *path, const Picture *picture, bool *exists, Error *error) {
    AtomicFile file;
    bool is_written = atomic_file_open(&file, path, ATOMIC_NEW, error) &&
                      fill(&file, &formats[0], picture, error);
    *exists = !is_written && file.exists;
    return is_written || fail(error, "write", path);
}

/**
 * Opens a file to be read. A FIFO or a device, which could keep the program waiting for ever, is
 * refused.
 * @param path        The file.
 * @param[out] error  Why not (#STATUS_SCENE).
 * @return The open file, or NULL.
 */
static FILE *open_plain(const char *path, Error *error) {
    FILE *stream = NULL;
    struct stat found;
    if (stat(path, &found) == 0) {
        if (!S_ISREG(found.st_mode)) {
            error_set(error, STATUS_SCENE, "it is no plain file");
            return NULL;
        }
        stream = fopen(path, "rbe");
    }
    if (!stream) {
        error_set(error, STATUS_SCENE, "%s", strerror(errno));
    }
    return stream;
}

/**
 * Reads a picture in a format.
 * @param format        The format.
 * @param path          The file.
 * @param stream        The same file, open.
 * @param[out] picture  The picture.
 * @param[out] error    What is wrong.
 * @return Whether it was read; otherwise the picture is empty.
 */
static bool read_format(const ImageFormat *format, const char *path, FILE *stream, Picture *picture,
                        Error *error) {
    const ImagesModule *module;
    if (!load_module(format, &module, error)) {
        return false;
    }
    return module ? images_child_read(module, format->module, path, picture, error)
                  : bmp_read(stream, picture, error);
}

bool image_file_read(const char *path, Picture *picture, Error *error) {
    *picture = (Picture){0};
    const ImageFormat *format = format_by_ending(path);
    if (!format) {
        error_set(error, STATUS_SCENE, "its name must end in ." ENDINGS);
        return fail(error, "read", path);
    }
    FILE *stream = open_plain(path, error);
    bool is_read = stream && read_format(format, path, stream, picture, error);
    if (stream) {
        fclose(stream);
    }
    return is_read || fail(error, "read", path);
}
