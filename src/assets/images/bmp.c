/**
 * @file
 * @brief BMP pictures.
 *
 * Format: Microsoft, "Bitmap Storage" (BITMAPFILEHEADER, BITMAPINFOHEADER). Numbers are stored
 * lowest byte first, and each row is filled up to a multiple of four bytes.
 */
#include "assets/images/bmp.h"
#include "dioptre/scene.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/** Where things are in a BMP file, in bytes from its beginning. */
enum {
    AT_FILE_SIZE = 2,    /**< Size of the file, 4 bytes. */
    AT_PIXELS = 10,      /**< Where the pixels begin, 4 bytes. */
    AT_HEADER_SIZE = 14, /**< Size of the header from here on, 4 bytes. */
    AT_WIDTH = 18,       /**< Pixels, 4 bytes with sign. */
    AT_HEIGHT = 22,      /**< Pixels, 4 bytes with sign; negative: the top row comes first. */
    AT_PLANES = 26,      /**< Always 1, 2 bytes. */
    AT_BITS = 28,        /**< Bits a pixel, 2 bytes. */
    AT_COMPRESSION = 30, /**< How the pixels are packed, 4 bytes. */
    AT_IMAGE_SIZE = 34,  /**< Bytes of all rows, 4 bytes. */
    AT_PIXELS_PER_METRE_X = 38, /**< Pixels a metre, 4 bytes. */
    AT_PIXELS_PER_METRE_Y = 42, /**< Pixels a metre, 4 bytes. */
    AT_MASKS = 54,              /**< Which bits are red, green and blue, where #BI_BITFIELDS. */
    HEADER_SIZE = 54,           /**< Bytes of the plain header, with which the file begins. */
    MASKS_SIZE = 12             /**< Bytes of the masks. */
};

/** Ways to pack pixels that are known here. */
enum {
    BI_RGB = 0,      /**< Blue, green, red, and with 32 bits an unused byte. */
    BI_BITFIELDS = 3 /**< As the masks say; only the same order is known here. */
};

/** Bytes of a pixel in a #Picture. */
enum { CHANNELS = 3 };
/** Most bytes of a pixel in a file. */
enum { PIXEL_BYTES_MAXIMUM = 4 };
/** Most bytes of a row in a file. */
enum { ROW_BYTES_MAXIMUM = IMAGE_SIZE_MAXIMUM * PIXEL_BYTES_MAXIMUM };
/** Pixels a metre that are written: 72 an inch, the usual. It means nothing for a drawing. */
enum { PIXELS_PER_METRE = 2835 };

/** What the header of a file says. */
typedef struct BmpHeader {
    uint32_t pixel_offset; /**< Where the pixels begin. */
    int32_t width;         /**< Pixels. */
    int32_t height;        /**< Pixels; negative: the top row comes first. */
    unsigned planes;       /**< Should be 1. */
    unsigned bits;         /**< Bits a pixel. */
    uint32_t compression;  /**< How the pixels are packed. */
    bool is_bgr;           /**< Whether the masks say blue, green, red. */
} BmpHeader;

/** Stores a number of 4 bytes. */
static void store_u32(uint8_t *bytes, uint32_t number) {
    for (int i = 0; i < 4; i++) {
        bytes[i] = (uint8_t)(number >> (8 * i));
    }
}

/** @return A number of 2 bytes. */
static unsigned load_u16(const uint8_t *bytes) {
    return bytes[0] | (unsigned)bytes[1] << 8;
}

/** @return A number of 4 bytes. */
static uint32_t load_u32(const uint8_t *bytes) {
    return load_u16(bytes) | (uint32_t)load_u16(bytes + 2) << 16;
}

/**
 * @return Bytes of a row in a file.
 * @param width        Pixels, 1 to `IMAGE_SIZE_MAXIMUM`.
 * @param pixel_bytes  Bytes a pixel, 3 or 4.
 */
static size_t row_size(int width, unsigned pixel_bytes) {
    return ((size_t)width * pixel_bytes + 3) / 4 * 4;
}

/** Fills in a header. @param picture The picture it is for. */
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
 * Copies pixels and turns the order of their colours round.
 * @param to_bytes  Bytes a pixel there, 3 or 4.
 * @param from_bytes  Bytes a pixel there, 3 or 4.
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

/** Takes a header apart. @param bytes Its bytes, with those of the masks after it. */
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
 * @param stream  The file, at its beginning.
 * @return Whether it is one that is known here.
 */
static bool read_header(FILE *stream, BmpHeader *header, Error *error) {
    uint8_t bytes[HEADER_SIZE + MASKS_SIZE] = {0};
    size_t size = fread(bytes, 1, sizeof bytes, stream);
    if (size < 2 || memcmp(bytes, "BM", 2) != 0) {
        return error_set(error, STATUS_SCENE, "it is no BMP file");
    }
    if (size < HEADER_SIZE) {
        return error_set(error, STATUS_SCENE, "it ends within its header");
    }
    uint32_t header_size = load_u32(bytes + AT_HEADER_SIZE);
    if (header_size < HEADER_SIZE - AT_HEADER_SIZE) {
        return error_set(error, STATUS_SCENE, "its header of %u bytes is of a kind not known here",
                         header_size);
    }
    parse_header(header, bytes);
    return true;
}

/** Says whether the pixels are of a kind that is known here. @return Whether they are. */
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
 * Says whether the size is one that is allowed, and whether the file holds all of the pixels.
 * @param file_size  Size of the file, bytes.
 * @return Whether they are there.
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
 * @param[out] picture  A picture of that size.
 * @return Whether all of them could be read.
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
 * @param stream  The file, at its beginning.
 * @return Whether it was read; otherwise the picture is empty.
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

bool bmp_read(int file, Picture *picture, Error *error) {
    *picture = (Picture){0};
    struct stat info;
    int descriptor = fcntl(file, F_DUPFD_CLOEXEC, 0);
    FILE *stream =
        descriptor >= 0 && fstat(descriptor, &info) == 0 ? fdopen(descriptor, "rb") : NULL;
    if (!stream) {
        error_set(error, STATUS_SCENE, "%s", error_errno_text(errno));
        if (descriptor >= 0) {
            close(descriptor);
        }
        return false;
    }
    bool is_read = read_stream(stream, (uint64_t)info.st_size, picture, error);
    fclose(stream);
    return is_read;
}
