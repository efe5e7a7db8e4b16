/**
 * @file
 * @brief Calls of the picture module.
 */
#include "assets/images/image_plugin_io.h"

#include "assets/asset_budget.h"
#include "assets/plugin.h"
#include "base/language.h"

#include <stdlib.h>
#include <string.h>

/** Bytes per pixel in a #Picture. */
enum { CHANNELS = 3 };

/** The picture module. */
static const Plugin image_plugin = {.file = "dioptre-images.so",
                                    .symbol = IMAGE_PLUGIN_SYMBOL,
                                    .version = IMAGE_PLUGIN_VERSION,
                                    .purpose = N_("all formats but BMP"),
                                    .library = "OpenImageIO",
                                    .build_package = "libopenimageio-dev",
                                    .runtime_package = "libopenimageio2.4",
                                    .fallback_hint =
                                        N_("; names that end in .bmp work without it")};

/** Clears the environment variables of OpenImageIO, which could make it load other code. */
static void clear_plugin_environment(void) {
    unsetenv("OIIO_LIBRARY_PATH");
    unsetenv("OPENIMAGEIO_OPTIONS");
}

const ImagePlugin *image_plugin_load_from(const char *folder, Error *error) {
    clear_plugin_environment();
    return plugin_open_from(&image_plugin, folder, error);
}

const ImagePlugin *image_plugin_load(Error *error) {
    clear_plugin_environment();
    return plugin_open(&image_plugin, error);
}

float *image_plugin_decode(const Picture *picture) {
    size_t count = (size_t)picture->width * (size_t)picture->height * CHANNELS;
    float *linear = malloc(count * sizeof *linear), table[UINT8_MAX + 1];
    for (int step = 0; step <= UINT8_MAX; step++) {
        table[step] = (float)encoding_decode(picture->encoding, step);
    }
    for (size_t i = 0; linear && i < count; i++) {
        linear[i] = table[picture->pixels[i]];
    }
    return linear;
}

/** Largest code of the table that decodes numbers of more than 8 bits. */
enum { SRGB16_MAXIMUM = 65535 };

/** A picture being read, strip by strip. */
typedef struct ImageDecoder {
    const ImagePlugin *plugin; /**< The module. */
    ImageReader *reader;       /**< The open file. */
    ImageHeader header;        /**< Its properties. */
    float *decode_table;       /**< For #PIXEL_FORMAT_SRGB16: linear light of the codes 0 to
                                  #SRGB16_MAXIMUM; owned. */
    Texture *texture;          /**< The texture to fill. */
} ImageDecoder;

/**
 * Decodes numbers of more than 8 bits.
 * @param table           Linear light of the codes 0 to #SRGB16_MAXIMUM.
 * @param[in,out] linear  Encoded numbers, 0 to 1; afterwards linear light.
 * @param count           Number of numbers.
 */
static void decode_srgb16(const float *table, float *linear, size_t count) {
    for (size_t i = 0; i < count; i++) {
        float clamped = linear[i] > 0 ? (linear[i] < 1 ? linear[i] : 1) : 0;
        linear[i] = table[(unsigned)(clamped * SRGB16_MAXIMUM + 0.5F)];
    }
}

/**
 * Reads a strip of rows.
 * @param decoder       The picture being read.
 * @param first         First row.
 * @param[out] message  What is wrong.
 * @return Whether it was read.
 */
static bool read_strip(const ImageDecoder *decoder, int first, ImagePluginMessage *message) {
    int left = decoder->header.height - first;
    int count = left < decoder->header.strip_rows ? left : decoder->header.strip_rows;
    size_t row = (size_t)decoder->header.width * CHANNELS, start = (size_t)first * row;
    if (decoder->header.format == PIXEL_FORMAT_SRGB8) {
        uint8_t *encoded = texture_ldr_texels(decoder->texture) + start;
        return decoder->plugin->read_encoded(decoder->reader, first, count, encoded, message);
    }
    float *linear = texture_hdr_texels(decoder->texture) + start;
    bool is_read = decoder->plugin->read_linear(decoder->reader, first, count, linear, message);
    if (is_read && decoder->decode_table) {
        decode_srgb16(decoder->decode_table, linear, row * (size_t)count);
    }
    return is_read;
}

/**
 * Reads all strips.
 * @param decoder     The picture being read.
 * @param[out] error  What is wrong.
 * @return Whether all were read.
 */
static bool read_strips(const ImageDecoder *decoder, Error *error) {
    ImagePluginMessage message;
    for (int first = 0; first < decoder->header.height; first += decoder->header.strip_rows) {
        if (!read_strip(decoder, first, &message)) {
            return error_set(error, STATUS_SCENE, "%s", message.text);
        }
    }
    return true;
}

/**
 * Prepares reading after the header.
 * @param[in,out] decoder  The picture being read.
 * @param request          The request.
 * @param[out] error       What is wrong.
 * @return false if it does not fit, or without memory.
 */
static bool prepare_decoder(ImageDecoder *decoder, const ImageReadRequest *request, Error *error) {
    const ImageHeader *header = &decoder->header;
    Texture head = {.width = header->width,
                    .height = header->height,
                    .is_hdr = header->format != PIXEL_FORMAT_SRGB8,
                    .reference_count = 1};
    if (texture_block_size(&head) > request->texture_capacity) {
        return request->is_capacity_shared
                   ? asset_budget_set_memory_error(error)
                   : error_set(error, STATUS_SCENE, "its %d x %d pixels take more than %zu MiB",
                               head.width, head.height, request->texture_capacity >> 20);
    }
    *decoder->texture = head;
    if (header->format == PIXEL_FORMAT_SRGB16) {
        decoder->decode_table = malloc((SRGB16_MAXIMUM + 1) * sizeof *decoder->decode_table);
        for (int i = 0; decoder->decode_table && i <= SRGB16_MAXIMUM; i++) {
            double step = (double)i * ENCODING_CODE_MAXIMUM / SRGB16_MAXIMUM;
            decoder->decode_table[i] = (float)encoding_decode(ENCODING_SRGB, step);
        }
    }
    return header->format != PIXEL_FORMAT_SRGB16 || decoder->decode_table ||
           error_set(error, STATUS_FAILED, "no memory");
}

bool image_plugin_read(const ImageReadRequest *request, Texture *texture, Error *error) {
    ImagePluginMessage message;
    const ImagePlugin *plugin = request->plugin;
    ImageDecoder decoder = {.plugin = plugin, .texture = texture};
    decoder.reader = plugin->open(request->file, request->format, &decoder.header, &message);
    if (!decoder.reader) {
        return error_set(error, STATUS_SCENE, "%s", message.text);
    }
    bool is_read = prepare_decoder(&decoder, request, error) && read_strips(&decoder, error);
    texture->is_damaged = is_read && plugin->is_damaged(decoder.reader);
    free(decoder.decode_table);
    plugin->close(decoder.reader);
    return is_read;
}
