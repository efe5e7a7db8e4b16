/**
 * @file
 * @brief Whether a picture file is whole.
 *
 * A copy that was interrupted and a disk that was full or lost its power leave files that are
 * empty, cut, or filled with zeros from some byte on. For formats whose end can be recognised, that
 * end is looked at: a decoder takes a thousand times as long, and some decode cut files without an
 * error.
 */
#include "assets/images/image_whole.h"

#include "assets/images/image_file.h"
#include "assets/images/image_format.h"
#include "base/regular_file.h"

#include <stdint.h>
#include <string.h>
#include <unistd.h>

/** @return Whether a file has given bytes at an offset. */
static bool has_bytes(int file, off_t offset, const void *bytes, size_t size) {
    uint8_t found[16];
    return size <= sizeof found && pread(file, found, size, offset) == (ssize_t)size &&
           memcmp(found, bytes, size) == 0;
}

bool image_png_is_whole(int file, off_t size) {
    /** Bytes of the signature, of a chunk besides its data, and of length and type. */
    enum { SIGNATURE_SIZE = 8, CHUNK_OVERHEAD = 12, CHUNK_HEAD_SIZE = 8 };
    off_t offset = SIGNATURE_SIZE;
    uint8_t head[CHUNK_HEAD_SIZE];
    if (!has_bytes(file, 0, "\x89PNG\r\n\x1a\n", SIGNATURE_SIZE) ||
        !has_bytes(file, offset + 4, "IHDR", 4)) {
        return false;
    }
    while (pread(file, head, sizeof head, offset) == (ssize_t)sizeof head) {
        uint32_t length =
            (uint32_t)head[0] << 24 | (uint32_t)head[1] << 16 | (uint32_t)head[2] << 8 | head[3];
        offset += (off_t)length + CHUNK_OVERHEAD;
        if (memcmp(head + 4, "IEND", 4) == 0) {
            return offset == size;
        }
        // A file of zeros would be a million chunks of no type.
        if (head[4] == 0 || offset > size) {
            return false;
        }
    }
    return false;
}

bool image_jpeg_is_whole(int file, off_t size) {
    return has_bytes(file, 0, "\xff\xd8", 2) && size >= 4 &&
           has_bytes(file, size - 2, "\xff\xd9", 2);
}

/** @return Whether a picture can be decoded. */
static bool can_be_read(const char *path) {
    Picture picture;
    bool is_read = image_file_read(path, &picture, NULL);
    picture_deinit(&picture);
    return is_read;
}

bool image_file_is_whole(const char *path) {
    const ImageFormat *format = image_format_by_extension(path);
    struct stat info;
    int file = format ? regular_file_open(path, &info, NULL) : -1;
    if (file < 0) {
        return false;
    }
    bool is_whole = format->is_whole ? format->is_whole(file, info.st_size) : can_be_read(path);
    close(file);
    return is_whole;
}
