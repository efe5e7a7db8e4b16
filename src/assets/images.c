/**
 * @file
 * @brief Opens the picture module and moves pictures across its border.
 */
#include "assets/images.h"

#include "assets/module.h"
#include "dioptre/language.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/** Bytes a pixel in a #Picture. */
enum { CHANNELS = 3 };

/** The picture module. */
static const Module images_module = {.file = "dioptre-images.so",
                                     .symbol = IMAGES_MODULE_SYMBOL,
                                     .version = IMAGES_MODULE_VERSION,
                                     .purpose = N_("all formats but BMP"),
                                     .library = "OpenImageIO",
                                     .to_build = "libopenimageio-dev",
                                     .to_run = "libopenimageio2.4",
                                     .without = N_("; names that end in .bmp work without it")};

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

/** What is said of a picture that says nothing of itself. */
static const PictureNote no_notes[] = {{0}};

/**
 * @return The light that the steps of a picture stand for, to be freed; NULL without memory.
 * @param picture  The picture.
 */
static float *decode_light(const Picture *picture) {
    size_t count = (size_t)picture->width * (size_t)picture->height * CHANNELS;
    float *light = malloc(count * sizeof *light), table[UINT8_MAX + 1];
    for (int step = 0; step <= UINT8_MAX; step++) {
        table[step] = (float)encoding_decode(picture->encoding, step);
    }
    for (size_t i = 0; light && i < count; i++) {
        light[i] = table[picture->pixels[i]];
    }
    return light;
}

/**
 * Makes a picture file in memory.
 * @param module      The module.
 * @param format      The format.
 * @param picture     The picture.
 * @param light       Its linear light, for a format that holds it; else NULL.
 * @param[out] file   The file, to be given back.
 * @param[out] error  What is wrong.
 * @return Whether it was made.
 */
static bool encode(const ImagesModule *module, const char *format, const Picture *picture,
                   const float *light, ImagesFile *file, Error *error) {
    ImagesSource source = {.width = picture->width,
                           .height = picture->height,
                           .steps = picture->pixels,
                           .light = light,
                           .notes = picture->notes ? picture->notes : no_notes};
    ImagesMessage message;
    return module->encode(format, &source, file, &message) ||
           error_set(error, STATUS_FAILED, "%s", message.text);
}

bool images_write(const ImagesModule *module, const char *format, bool is_linear,
                  const Picture *picture, FILE *stream, Error *error) {
    ImagesFile file;
    float *decoded = is_linear && !picture->light ? decode_light(picture) : NULL;
    const float *light = !is_linear ? NULL : decoded ? decoded : picture->light;
    if (is_linear && !light) {
        return error_set(error, STATUS_FAILED, "no memory");
    }
    bool is_made = encode(module, format, picture, light, &file, error);
    free(decoded);
    if (!is_made) {
        return false;
    }
    bool is_fine = fwrite(file.bytes, 1, file.size, stream) == file.size ||
                   error_set(error, STATUS_FAILED, "%s", error_system(errno));
    module->release(&file);
    return is_fine;
}

/** Steps of the curve that numbers finer than 8 bits are decoded by. */
enum { FINE_STEPS = 65535 };

/** A picture that is being read, band by band. */
typedef struct Reading {
    const ImagesModule *module; /**< The module. */
    ImagesReader *reader;       /**< The open file. */
    ImagesHeader header;        /**< What is known of it. */
    float *curve;               /**< For #IMAGES_FINE: the light of each of #FINE_STEPS; owned. */
    Texture *texture;           /**< Where the texels go. */
} Reading;

/**
 * Decodes numbers of 16 bits and the like.
 * @param curve          The light of each of #FINE_STEPS steps.
 * @param[in,out] light  Numbers from 0 to 1; light afterwards.
 * @param count          How many.
 */
static void decode_fine(const float *curve, float *light, size_t count) {
    for (size_t i = 0; i < count; i++) {
        float inside = light[i] > 0 ? (light[i] < 1 ? light[i] : 1) : 0;
        light[i] = curve[(unsigned)(inside * FINE_STEPS + 0.5F)];
    }
}

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
    size_t row = (size_t)reading->header.width * CHANNELS, start = (size_t)first * row;
    if (reading->header.kind == IMAGES_STEPS) {
        uint8_t *steps = texture_steps(reading->texture) + start;
        return reading->module->read_steps(reading->reader, first, count, steps, message);
    }
    float *light = texture_light(reading->texture) + start;
    bool is_read = reading->module->read_light(reading->reader, first, count, light, message);
    if (is_read && reading->curve) {
        decode_fine(reading->curve, light, row * (size_t)count);
    }
    return is_read;
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
 * Makes ready to read, once the header is known.
 * @param[in,out] reading  The picture that is being read.
 * @param room             Bytes that fit where it goes.
 * @param[out] error       What is wrong.
 * @return false if it does not fit, or without memory.
 */
static bool make_ready(Reading *reading, size_t room, Error *error) {
    const ImagesHeader *header = &reading->header;
    Texture head = {.width = header->width,
                    .height = header->height,
                    .is_light = header->kind != IMAGES_STEPS,
                    .owners = 1};
    if (texture_size(&head) > room) {
        return error_set(error, STATUS_SCENE, "its %d x %d pixels take more than %zu MiB",
                         head.width, head.height, room >> 20);
    }
    *reading->texture = head;
    if (header->kind == IMAGES_FINE) {
        reading->curve = malloc((FINE_STEPS + 1) * sizeof *reading->curve);
        for (int i = 0; reading->curve && i <= FINE_STEPS; i++) {
            double step = (double)i * ENCODING_STEP_MAXIMUM / FINE_STEPS;
            reading->curve[i] = (float)encoding_decode(ENCODING_SRGB, step);
        }
    }
    return header->kind != IMAGES_FINE || reading->curve ||
           error_set(error, STATUS_FAILED, "no memory");
}

bool images_read(const ImagesRequest *request, Texture *texture, Error *error) {
    ImagesMessage message;
    const ImagesModule *module = request->module;
    Reading reading = {.module = module, .texture = texture};
    reading.reader = module->open(request->path, request->format, &reading.header, &message);
    if (!reading.reader) {
        return error_set(error, STATUS_SCENE, "%s", message.text);
    }
    bool is_read = make_ready(&reading, request->room, error) && read_bands(&reading, error);
    free(reading.curve);
    module->close(reading.reader);
    return is_read;
}
