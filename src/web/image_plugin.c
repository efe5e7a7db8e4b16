/**
 * @file
 * @brief The picture module of the page: PNG, TGA, PNM and HDR by stb_image, JPEG by libjpeg-turbo.
 * It stands in for assets/images/image_plugin.cpp, which is over OpenImageIO.
 *
 * PNG and HDR have one right answer, and JPEG is decoded by the library that OpenImageIO uses: the
 * pixels are the desktop's to the bit. A picture is decoded whole when it is opened.
 */
#include "assets/images/image_plugin.h"

#include "web/libraries/stb.h"

#include <libintl.h>
#include <setjmp.h>
#include <stdio.h>
// After stdio.h, whose FILE it uses.
#include <jpeglib.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/** Colours of a pixel. */
enum { CHANNELS = 3 };
/** Largest value of 16 bits. */
static const float CODE16_MAXIMUM = 65535;

/** A picture file that is open. */
struct ImageReader {
    ImageHeader header; /**< Its properties. */
    void *pixels;       /**< All pixels, of the header's type; owned. */
    bool is_damaged;    /**< Whether some pixels are guesses. */
};

/** Sets a message. @return false, always. */
static bool set_message(ImagePluginMessage *message, const char *text) {
    snprintf(message->text, sizeof message->text, "%s", text);
    return false;
}

/** Reads a file. @param[out] size Its bytes. @return The bytes, to be freed; NULL on errors. */
static unsigned char *read_file(int file, size_t *size) {
    struct stat info;
    unsigned char *bytes = fstat(file, &info) == 0 ? malloc((size_t)info.st_size + 1) : NULL;
    *size = bytes ? (size_t)info.st_size : 0;
    for (size_t done = 0; bytes && done < *size;) {
        ssize_t count = pread(file, bytes + done, *size - done, (off_t)done);
        if (count <= 0) {
            free(bytes);
            return NULL;
        }
        done += (size_t)count;
    }
    return bytes;
}

/** What libjpeg needs to come back from an error. */
typedef struct JpegErrors {
    struct jpeg_error_mgr manager; /**< The library's; first. */
    jmp_buf back;                  /**< Where an error goes on. */
    ImagePluginMessage *message;   /**< Gets the error. */
} JpegErrors;

/** Comes back from an error. See jpeg_error_mgr.error_exit. */
static void jpeg_fail(j_common_ptr jpeg) {
    JpegErrors *errors = (JpegErrors *)jpeg->err;
    char text[JMSG_LENGTH_MAX];
    errors->manager.format_message(jpeg, text);
    set_message(errors->message, text);
    longjmp(errors->back, 1);
}

/** Says nothing: warnings are counted. See jpeg_error_mgr.output_message. */
static void jpeg_be_silent(j_common_ptr jpeg) {
    (void)jpeg;
}

/** @return Whether a JPEG file whose header is read is larger than pictures may be: the size of its
 *  pixels would overflow. Its header alone is read, which is then refused like that of any format.
 */
static bool jpeg_is_too_large(const struct jpeg_decompress_struct *jpeg, ImageReader *reader) {
    reader->header.width = (int)jpeg->image_width;
    reader->header.height = (int)jpeg->image_height;
    return jpeg->image_width > IMAGE_PLUGIN_SIZE_MAXIMUM ||
           jpeg->image_height > IMAGE_PLUGIN_SIZE_MAXIMUM;
}

/** Decodes all rows of a JPEG file whose header is read. */
static void decode_jpeg_rows(struct jpeg_decompress_struct *jpeg, ImageReader *reader) {
    jpeg->out_color_space = JCS_RGB;
    jpeg_start_decompress(jpeg);
    reader->header = (ImageHeader){(int)jpeg->output_width, (int)jpeg->output_height,
                                   PIXEL_FORMAT_SRGB8, (int)jpeg->output_height};
    size_t row_size = (size_t)jpeg->output_width * CHANNELS;
    reader->pixels = malloc(row_size * jpeg->output_height);
    while (reader->pixels && jpeg->output_scanline < jpeg->output_height) {
        JSAMPROW row = (JSAMPROW)reader->pixels + jpeg->output_scanline * row_size;
        jpeg_read_scanlines(jpeg, &row, 1);
    }
    reader->is_damaged = jpeg->err->num_warnings > 0;
}

/** Decodes a JPEG file. @return Whether it was decoded. */
static bool decode_jpeg(const unsigned char *bytes, size_t size, ImageReader *reader,
                        ImagePluginMessage *message) {
    struct jpeg_decompress_struct jpeg;
    JpegErrors errors = {.message = message};
    jpeg.err = jpeg_std_error(&errors.manager);
    errors.manager.error_exit = jpeg_fail;
    errors.manager.output_message = jpeg_be_silent;
    jpeg_create_decompress(&jpeg);
    bool is_decoded = false;
    if (setjmp(errors.back) == 0) {
        jpeg_mem_src(&jpeg, bytes, size);
        jpeg_read_header(&jpeg, TRUE);
        is_decoded = jpeg_is_too_large(&jpeg, reader);
        if (!is_decoded) {
            decode_jpeg_rows(&jpeg, reader);
            is_decoded = reader->pixels || set_message(message, gettext("no memory"));
        }
    }
    jpeg_destroy_decompress(&jpeg);
    return is_decoded;
}

/** Decodes 16-bit numbers. @return The pixels, 0 to 1, to be freed; NULL on errors. */
static float *decode_16_bits(const unsigned char *bytes, int size, int *width, int *height) {
    int channels;
    stbi_us *codes = stbi_load_16_from_memory(bytes, size, width, height, &channels, CHANNELS);
    size_t count = codes ? (size_t)*width * (size_t)*height * CHANNELS : 0;
    float *pixels = codes ? malloc(count * sizeof *pixels) : NULL;
    for (size_t i = 0; pixels && i < count; i++) {
        pixels[i] = (float)codes[i] / CODE16_MAXIMUM;
    }
    stbi_image_free(codes);
    return pixels;
}

/** Decodes a file of stb_image's formats. @return Whether it was decoded. */
static bool decode_other(const unsigned char *bytes, size_t size, ImageReader *reader,
                         ImagePluginMessage *message) {
    ImageHeader *header = &reader->header;
    int channels, length = (int)size;
    if (stbi_is_hdr_from_memory(bytes, length)) {
        header->format = PIXEL_FORMAT_LINEAR;
        reader->pixels = stbi_loadf_from_memory(bytes, length, &header->width, &header->height,
                                                &channels, CHANNELS);
    } else if (stbi_is_16_bit_from_memory(bytes, length)) {
        header->format = PIXEL_FORMAT_SRGB16;
        reader->pixels = decode_16_bits(bytes, length, &header->width, &header->height);
    } else {
        header->format = PIXEL_FORMAT_SRGB8;
        reader->pixels = stbi_load_from_memory(bytes, length, &header->width, &header->height,
                                               &channels, CHANNELS);
    }
    header->strip_rows = header->height;
    return reader->pixels || set_message(message, stbi_failure_reason() ? stbi_failure_reason()
                                                                        : gettext("no memory"));
}

/** Closes a file. See ImagePlugin::close. */
static void close_reader(ImageReader *reader) {
    if (reader) {
        free(reader->pixels);
        free(reader);
    }
}

/** Opens and decodes a file. See ImagePlugin::open. */
static ImageReader *open_reader(int file, const char *format, ImageHeader *header,
                                ImagePluginMessage *message) {
    size_t size;
    unsigned char *bytes = read_file(file, &size);
    ImageReader *reader = bytes ? calloc(1, sizeof *reader) : NULL;
    bool is_jpeg = strcmp(format, "jpeg") == 0;
    bool is_open = reader ? is_jpeg ? decode_jpeg(bytes, size, reader, message)
                                    : decode_other(bytes, size, reader, message)
                          : set_message(message, gettext("no memory"));
    free(bytes);
    if (!is_open) {
        close_reader(reader);
        return NULL;
    }
    *header = reader->header;
    return reader;
}

/** Copies rows. See ImagePlugin::read_encoded. */
static bool read_encoded(ImageReader *reader, int first, int count, uint8_t *rgb,
                         ImagePluginMessage *message) {
    (void)message;
    size_t row = (size_t)reader->header.width * CHANNELS;
    memcpy(rgb, (const uint8_t *)reader->pixels + (size_t)first * row, (size_t)count * row);
    return true;
}

/** Copies rows. See ImagePlugin::read_linear. */
static bool read_linear(ImageReader *reader, int first, int count, float *rgb,
                        ImagePluginMessage *message) {
    (void)message;
    size_t row = (size_t)reader->header.width * CHANNELS;
    memcpy(rgb, (const float *)reader->pixels + (size_t)first * row,
           (size_t)count * row * sizeof *rgb);
    return true;
}

/** See ImagePlugin::is_damaged. */
static bool is_damaged(ImageReader *reader) {
    return reader->is_damaged;
}

/** Appends bytes to a file in memory. See stbi_write_func. */
static void append(void *context, void *bytes, int size) {
    EncodedImage *file = context;
    void *grown = realloc(file->owner, file->size + (size_t)size);
    if (grown) {
        memcpy((char *)grown + file->size, bytes, (size_t)size);
        file->size += (size_t)size;
        file->bytes = file->owner = grown;
    }
}

/** Encodes PNG, without metadata. See ImagePlugin::encode. */
static bool encode(const char *format, const ImagePluginSource *source, EncodedImage *file,
                   ImagePluginMessage *message) {
    *file = (EncodedImage){0};
    if (strcmp(format, "png") != 0 || source->linear) {
        return set_message(message, gettext("a page writes .bmp and .png only"));
    }
    int row = source->width * CHANNELS;
    return stbi_write_png_to_func(append, file, source->width, source->height, CHANNELS,
                                  source->encoded, row) ||
           set_message(message, gettext("no memory"));
}

/** Frees a file in memory. See ImagePlugin::free_encoded. */
static void free_encoded(EncodedImage *file) {
    free(file->owner);
    *file = (EncodedImage){0};
}

/** The module. */
extern const ImagePlugin dioptre_image_plugin;
const ImagePlugin dioptre_image_plugin = {.version = IMAGE_PLUGIN_VERSION,
                                          .encode = encode,
                                          .free_encoded = free_encoded,
                                          .open = open_reader,
                                          .read_encoded = read_encoded,
                                          .read_linear = read_linear,
                                          .is_damaged = is_damaged,
                                          .close = close_reader};
