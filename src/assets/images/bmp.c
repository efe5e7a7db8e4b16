/**
 * @file
 * @brief BMP pictures.
 *
 * Format: Microsoft, "Bitmap Storage" (BITMAPFILEHEADER, BITMAPINFOHEADER). Numbers are
 * little-endian, and rows are padded to multiples of four bytes.
 */
#include "assets/images/bmp.h"
#include "dioptre/scene.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/** Byte offsets in a BMP file, and sizes. */
enum {
    AT_FILE_SIZE = 2,    /**< Size of the file, 4 bytes. */
    AT_PIXELS = 10,      /**< Offset of the pixels, 4 bytes. */
    AT_HEADER_SIZE = 14, /**< Size of the header that begins here, 4 bytes. */
    AT_WIDTH = 18,       /**< Width in pixels, 4 bytes, signed. */
    AT_HEIGHT = 22,      /**< Height in pixels, 4 bytes, signed; negative: the top row is first. */
    AT_PLANES = 26,      /**< Always 1, 2 bytes. */
    AT_BITS = 28,        /**< Bits per pixel, 2 bytes. */
    AT_COMPRESSION = 30, /**< Compression, 4 bytes. */
    AT_IMAGE_SIZE = 34,  /**< Size of all rows, 4 bytes. */
    AT_PIXELS_PER_METRE_X = 38, /**< Pixels per metre, 4 bytes. */
    AT_PIXELS_PER_METRE_Y = 42, /**< Pixels per metre, 4 bytes. */
    AT_MASKS = 54,              /**< Masks of the red, green and blue bits, with #BI_BITFIELDS. */
    HEADER_SIZE = 54,           /**< Size of the two headers at the start of a file. */
    MASKS_SIZE = 12             /**< Size of the masks. */
};

/** Supported compressions. */
enum {
    BI_RGB = 0,      /**< Blue, green, red, and an unused byte at 32 bits per pixel. */
    BI_BITFIELDS = 3 /**< As the masks give; only the same order is supported. */
};

/** Largest header from #AT_HEADER_SIZE on: version 5, the last one. */
enum { HEADER_SIZE_MAXIMUM = 124 };
/** Bytes per pixel in a #Picture. */
enum { CHANNELS = 3 };
/** Largest number of bytes per pixel in a file. */
enum { PIXEL_BYTES_MAXIMUM = 4 };
/** Largest size of a row in a file. */
enum { ROW_BYTES_MAXIMUM = IMAGE_SIZE_MAXIMUM * PIXEL_BYTES_MAXIMUM };
/** Pixels per metre in written files: 72 per inch, the usual value. */
enum { PIXELS_PER_METRE = 2835 };

/** Content of the header of a file. */
typedef struct BmpHeader {
    uint32_t pixel_offset; /**< Offset of the pixels in the file. */
    int32_t width;         /**< Width in pixels. */
    int32_t height;        /**< Height in pixels; negative: the top row is first. */
    unsigned planes;       /**< Number of planes; valid: 1. */
    unsigned bits;         /**< Bits per pixel. */
    uint32_t compression;  /**< Compression. */
    bool is_bgr;           /**< Whether the masks give the order blue, green, red. */
} BmpHeader;

/** Stores a 4-byte number, little-endian. */
static void store_u32(uint8_t *bytes, uint32_t number) {
    for (int i = 0; i < 4; i++) {
        bytes[i] = (uint8_t)(number >> (8 * i));
    }
}

/** @return A 2-byte number, little-endian. */
static unsigned load_u16(const uint8_t *bytes) {
    return bytes[0] | (unsigned)bytes[1] << 8;
}

/** @return A 4-byte number, little-endian. */
static uint32_t load_u32(const uint8_t *bytes) {
    return load_u16(bytes) | (uint32_t)load_u16(bytes + 2) << 16;
}

/**
 * @return Size of a row in a file, in bytes.
 * @param width        Pixels, 1 to `IMAGE_SIZE_MAXIMUM`.
 * @param pixel_bytes  Bytes per pixel, 3 or 4.
 */
static size_t row_size(int width, unsigned pixel_bytes) {
    return ((size_t)width * pixel_bytes + 3) / 4 * 4;
}

/** Fills in a header. @param[out] header The header. @param picture Its picture. */
static void make_header(uint8_t header[HEADER_SIZE], const Picture *picture) {
    size_t size = row_size(picture->width, CHANNELS) * (size_t)picture->height;
    memset(header, 0, HEADER_SIZE);
    memcpy(header, "BM", 2);
    store_u32(header + AT_FILE_SIZE, (uint32_t)(HEADER_SIZE + size));
    store_u32(header + AT_PIXELS, HEADER_SIZE);
    store_u32(header + AT_HEADER_SIZE, HEADER_SIZE - AT_HEADER_SIZE);
    store_u32(header + AT_WIDTH, (uint32_t)picture->width);
    store_u32(header + AT_HEIGHT, (uint32_t)picture->height);
    header[AT_PLANES] = 1;
    header[AT_BITS] = 8 * CHANNELS;
    store_u32(header + AT_IMAGE_SIZE, (uint32_t)size);
    store_u32(header + AT_PIXELS_PER_METRE_X, PIXELS_PER_METRE);
    store_u32(header + AT_PIXELS_PER_METRE_Y, PIXELS_PER_METRE);
}

/**
 * Copies pixels and swaps red and blue.
 * @param[out] to     The copy.
 * @param to_bytes    Bytes per pixel of the copy, 3 or 4.
 * @param from        The pixels.
 * @param from_bytes  Bytes per pixel, 3 or 4.
 * @param count       Number of pixels.
 */
static void copy_swapping_red_blue(uint8_t *to, unsigned to_bytes, const uint8_t *from,
                                   unsigned from_bytes, int count) {
    for (int i = 0; i < count; i++) {
        to[0] = from[2];
        to[1] = from[1];
        to[2] = from[0];
        to += to_bytes;
        from += from_bytes;
    }
}

bool bmp_write(const Picture *picture, FILE *stream, Error *error) {
    uint8_t bytes[ROW_BYTES_MAXIMUM] = {0};
    make_header(bytes, picture);
    bool is_fine = fwrite(bytes, HEADER_SIZE, 1, stream) == 1;
    size_t size = row_size(picture->width, CHANNELS);
    memset(bytes, 0, size);
    for (int y = picture->height - 1; y >= 0 && is_fine; y--) {
        const uint8_t *row = picture->pixels + (size_t)y * (size_t)picture->width * CHANNELS;
        copy_swapping_red_blue(bytes, CHANNELS, row, CHANNELS, picture->width);
        is_fine = fwrite(bytes, size, 1, stream) == 1;
    }
    return is_fine || error_set(error, STATUS_FAILED, "%s", error_errno_text(errno));
}

/**
 * Parses a header.
 * @param[out] header  The result.
 * @param bytes        The bytes of the header and of the masks.
 */
static void parse_header(BmpHeader *header, const uint8_t bytes[HEADER_SIZE + MASKS_SIZE]) {
    *header = (BmpHeader){
        .pixel_offset = load_u32(bytes + AT_PIXELS),
        .width = (int32_t)load_u32(bytes + AT_WIDTH),
        .height = (int32_t)load_u32(bytes + AT_HEIGHT),
        .planes = load_u16(bytes + AT_PLANES),
        .bits = load_u16(bytes + AT_BITS),
        .compression = load_u32(bytes + AT_COMPRESSION),
        .is_bgr = load_u32(bytes + AT_MASKS) == 0xFF0000 &&
                  load_u32(bytes + AT_MASKS + 4) == 0xFF00 &&
                  load_u32(bytes + AT_MASKS + 8) == 0xFF,
    };
}

/**
 * Reads a header.
 * @param stream       The file, at its start.
 * @param[out] header  The header.
 * @param[out] error   What is wrong.
 * @return Whether it is supported.
 */
static bool read_header(FILE *stream, BmpHeader *header, Error *error) {
    uint8_t bytes[HEADER_SIZE + MASKS_SIZE] = {0};
    size_t size = fread(bytes, 1, sizeof bytes, stream);
    if (ferror(stream)) {
        return error_set_errno(error, errno);
    }
    if (size < 2 || memcmp(bytes, "BM", 2) != 0) {
        return error_set(error, STATUS_SCENE, "it is no BMP file");
    }
    if (size < HEADER_SIZE) {
        return error_set(error, STATUS_SCENE, "it ends within its header");
    }
    uint32_t header_size = load_u32(bytes + AT_HEADER_SIZE);
    if (header_size < HEADER_SIZE - AT_HEADER_SIZE || header_size > HEADER_SIZE_MAXIMUM) {
        return error_set(error, STATUS_SCENE, "its header of %u bytes is of a kind not known here",
                         header_size);
    }
    parse_header(header, bytes);
    return true;
}

/** @return Whether the pixel format is supported. */
static bool check_pixel_format(const BmpHeader *header, Error *error) {
    if (header->planes != 1 || (header->bits != 24 && header->bits != 32)) {
        return error_set(error, STATUS_SCENE, "it has %u bits a pixel, not 24 or 32", header->bits);
    }
    bool is_masked = header->compression == BI_BITFIELDS && header->bits == 32;
    if (header->compression != BI_RGB && !(is_masked && header->is_bgr)) {
        return error_set(error, STATUS_SCENE, "its pixels are packed in a way not known here (%u)",
                         header->compression);
    }
    return true;
}

/**
 * Checks the size of a picture against the limits and the size of its file.
 * @param header      The header.
 * @param file_size   Size of the file, bytes.
 * @param[out] error  What is wrong.
 * @return Whether the file can contain all pixels.
 */
static bool check_size(const BmpHeader *header, uint64_t file_size, Error *error) {
    int64_t height = header->height < 0 ? -(int64_t)header->height : header->height;
    if (header->width < 1 || header->width > IMAGE_SIZE_MAXIMUM || height < 1 ||
        height > IMAGE_SIZE_MAXIMUM) {
        return error_set(error, STATUS_SCENE, "%d x %lld pixels: each must be 1 to %d",
                         header->width, (long long)height, IMAGE_SIZE_MAXIMUM);
    }
    uint64_t needed = row_size(header->width, header->bits / 8) * (uint64_t)height;
    if (header->pixel_offset < HEADER_SIZE || header->pixel_offset > file_size ||
        file_size - header->pixel_offset < needed) {
        return error_set(error, STATUS_SCENE,
                         "it is cut off: %llu bytes of pixels from byte %u on, in a file of %llu",
                         (unsigned long long)needed, header->pixel_offset,
                         (unsigned long long)file_size);
    }
    return true;
}

/**
 * Reads the pixels.
 * @param stream        The file.
 * @param header        Its header.
 * @param[out] picture  A picture of that size.
 * @return Whether all of them were read.
 */
static bool read_pixels(FILE *stream, const BmpHeader *header, Picture *picture) {
    uint8_t bytes[ROW_BYTES_MAXIMUM];
    unsigned pixel_bytes = header->bits / 8;
    size_t size = row_size(picture->width, pixel_bytes);
    if (fseek(stream, (long)header->pixel_offset, SEEK_SET) != 0) {
        return false;
    }
    for (int i = 0; i < picture->height; i++) {
        if (fread(bytes, size, 1, stream) != 1) {
            return false;
        }
        int y = header->height < 0 ? i : picture->height - 1 - i;
        uint8_t *row = picture->pixels + (size_t)y * (size_t)picture->width * CHANNELS;
        copy_swapping_red_blue(row, CHANNELS, bytes, pixel_bytes, picture->width);
    }
    return true;
}

/**
 * Reads a BMP file.
 * @param stream        The file, at its start.
 * @param file_size     Its size, bytes.
 * @param[out] picture  The picture; empty on errors.
 * @param[out] error    What is wrong.
 * @return Whether it was read.
 */
static bool read_stream(FILE *stream, uint64_t file_size, Picture *picture, Error *error) {
    BmpHeader header = {0};
    if (!read_header(stream, &header, error) || !check_pixel_format(&header, error) ||
        !check_size(&header, file_size, error) ||
        !picture_init(picture, header.width, header.height < 0 ? -header.height : header.height,
                      error)) {
        return false;
    }
    if (!read_pixels(stream, &header, picture)) {
        picture_deinit(picture);
        return error_set(error, STATUS_SCENE, "its pixels cannot be read");
    }
    return true;
}

/**
 * Opens a stream on a copy of a descriptor.
 * @param[out] info  Properties of the file.
 * @return The stream, or NULL.
 */
static FILE *open_stream(int file, struct stat *info, Error *error) {
    int descriptor = fcntl(file, F_DUPFD_CLOEXEC, 0);
    FILE *stream =
        descriptor >= 0 && fstat(descriptor, info) == 0 ? fdopen(descriptor, "rb") : NULL;
    if (!stream) {
        error_set_errno(error, errno);
        if (descriptor >= 0) {
            close(descriptor);
        }
    }
    return stream;
}

bool bmp_is_whole(int file, off_t size) {
    struct stat info;
    BmpHeader header = {0};
    FILE *stream = open_stream(file, &info, NULL);
    bool is_whole = stream && read_header(stream, &header, NULL) &&
                    check_pixel_format(&header, NULL) && check_size(&header, (uint64_t)size, NULL);
    if (stream) {
        fclose(stream);
    }
    return is_whole;
}

bool bmp_read(int file, Picture *picture, Error *error) {
    *picture = (Picture){0};
    struct stat info;
    FILE *stream = open_stream(file, &info, error);
    if (!stream) {
        return false;
    }
    bool is_read = read_stream(stream, (uint64_t)info.st_size, picture, error);
    fclose(stream);
    return is_read;
}
