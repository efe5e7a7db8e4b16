/**
 * @file
 * @brief Opens the picture module and moves pictures across its border.
 */
#include "assets/images.h"

#include "assets/module.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/** Bytes a pixel in a #Picture. */
enum { CHANNELS = 3 };

/** The picture module. */
static const Module images_module = {.file = "dioptre-images.so",
                                     .symbol = IMAGES_MODULE_SYMBOL,
                                     .version = IMAGES_MODULE_VERSION,
                                     .purpose = "all formats but BMP",
                                     .library = "OpenImageIO",
                                     .to_build = "libopenimageio-dev",
                                     .to_run = "libopenimageio2.4",
                                     .without = "; names that end in .bmp work without it"};

/**
 * Forgets what the user's environment would have OpenImageIO load or do: whoever sends a scene to
 * a class must not choose which code runs there.
 */
static void forget_environment(void) {
    unsetenv("OIIO_LIBRARY_PATH");
    unsetenv("OPENIMAGEIO_OPTIONS");
}

const ImagesModule *images_load_from(const char *folder, Error *error) {
    forget_environment();
    return module_open_from(&images_module, folder, error);
}

const ImagesModule *images_load(Error *error) {
    forget_environment();
    return module_open(&images_module, error);
}

/**
 * Makes a picture file in memory.
 * @param module      The module.
 * @param format      The format.
 * @param is_linear   Whether it holds linear light.
 * @param picture     The picture.
 * @param[out] file   The file, to be given back.
 * @param[out] error  What is wrong.
 * @return Whether it was made.
 */
static bool encode(const ImagesModule *module, const char *format, bool is_linear,
                   const Picture *picture, ImagesFile *file, Error *error) {
    float light[256];
    for (int step = 0; step <= UINT8_MAX; step++) {
        light[step] = (float)encoding_decode(picture->encoding, step);
    }
    ImagesSource source = {
        .width = picture->width,
        .height = picture->height,
        .steps = picture->pixels,
        .light = is_linear ? light : NULL,
    };
    ImagesMessage message;
    return module->encode(format, &source, file, &message) ||
           error_set(error, STATUS_FAILED, "%s", message.text);
}

bool images_write(const ImagesModule *module, const char *format, bool is_linear,
                  const Picture *picture, FILE *stream, Error *error) {
    ImagesFile file;
    if (!encode(module, format, is_linear, picture, &file, error)) {
        return false;
    }
    bool is_fine = fwrite(file.bytes, 1, file.size, stream) == file.size ||
                   error_set(error, STATUS_FAILED, "%s", strerror(errno));
    module->release(&file);
    return is_fine;
}

/** A picture that is being read, band by band. */
typedef struct Reading {
    const ImagesModule *module; /**< The module. */
    ImagesReader *reader;       /**< The open file. */
    ImagesHeader header;        /**< What is known of it. */
    Encoder encoder;            /**< For linear light. */
    float *light;               /**< Room for a band of linear light. */
    Picture *picture;           /**< Where the pixels go. */
} Reading;

/**
 * Reads a band of rows.
 * @param reading       The picture that is being read.
 * @param first         First row.
 * @param[out] message  What is wrong.
 * @return Whether it was read.
 */
static bool read_band(const Reading *reading, int first, ImagesMessage *message) {
    int left = reading->header.height - first;
    int count = left < reading->header.band ? left : reading->header.band;
    size_t row = (size_t)reading->header.width * CHANNELS;
    uint8_t *steps = reading->picture->pixels + (size_t)first * row;
    if (!reading->header.is_linear) {
        return reading->module->read_steps(reading->reader, first, count, steps, message);
    }
    if (!reading->module->read_light(reading->reader, first, count, reading->light, message)) {
        return false;
    }
    for (size_t i = 0; i < row * (size_t)count; i++) {
        steps[i] = encoder_encode(&reading->encoder, reading->light[i]);
    }
    return true;
}

/**
 * Reads all bands.
 * @param reading     The picture that is being read.
 * @param[out] error  What is wrong.
 * @return Whether all were read.
 */
static bool read_bands(const Reading *reading, Error *error) {
    ImagesMessage message;
    for (int first = 0; first < reading->header.height; first += reading->header.band) {
        if (!read_band(reading, first, &message)) {
            return error_set(error, STATUS_SCENE, "%s", message.text);
        }
    }
    return true;
}

/**
 * Takes the memory that a picture needs.
 * @param[in,out] reading  The picture that is being read, its header known.
 * @param[out] error       What is wrong.
 * @return false without memory.
 */
static bool take_memory(Reading *reading, Error *error) {
    const ImagesHeader *header = &reading->header;
    if (!picture_init(reading->picture, header->width, header->height, error)) {
        return false;
    }
    if (header->is_linear) {
        encoder_init(&reading->encoder, ENCODING_SRGB);
        size_t row = (size_t)header->width * CHANNELS * sizeof *reading->light;
        reading->light = calloc((size_t)header->band, row);
    }
    return !header->is_linear || reading->light || error_set(error, STATUS_FAILED, "no memory");
}

bool images_read(const ImagesModule *module, const char *format, const char *path, Picture *picture,
                 Error *error) {
    *picture = (Picture){0};
    ImagesMessage message;
    Reading reading = {.module = module, .picture = picture};
    reading.reader = module->open(path, format, &reading.header, &message);
    if (!reading.reader) {
        return error_set(error, STATUS_SCENE, "%s", message.text);
    }
    bool is_read = take_memory(&reading, error) && read_bands(&reading, error);
    free(reading.light);
    module->close(reading.reader);
    if (!is_read) {
        picture_release(picture);
    }
    return is_read;
}
