/**
 * @file
 * @brief Fuzz target: reading of BMP files. What is read is written and read again.
 */
#include "fuzz.h"

#include "assets/images/bmp.h"

#include <sys/mman.h>
#include <unistd.h>

/** @return A file in memory with these bytes. */
static int file_of(const void *bytes, size_t size) {
    int file = memfd_create("fuzz", MFD_CLOEXEC);
    FUZZ_REQUIRE(file >= 0 && write(file, bytes, size) == (ssize_t)size);
    FUZZ_REQUIRE(lseek(file, 0, SEEK_SET) == 0);
    return file;
}

/** Writes a picture and reads it again: it must be the same. */
static void check_round_trip(const Picture *picture) {
    char *bytes = NULL;
    size_t size = 0;
    Error error = {0};
    Picture again;
    FILE *stream = open_memstream(&bytes, &size);
    FUZZ_REQUIRE(stream && bmp_write(picture, stream, &error) && fclose(stream) == 0);
    int file = file_of(bytes, size);
    FUZZ_REQUIRE(bmp_read(file, &again, &error));
    FUZZ_REQUIRE(again.width == picture->width && again.height == picture->height);
    size_t pixels = (size_t)picture->width * (size_t)picture->height * 3;
    FUZZ_REQUIRE(memcmp(again.pixels, picture->pixels, pixels) == 0);
    picture_deinit(&again);
    close(file);
    free(bytes);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Error error = {0};
    Picture picture;
    int file = file_of(data, size);
    if (bmp_read(file, &picture, &error)) {
        FUZZ_REQUIRE(picture.width >= 1 && picture.height >= 1 && picture.pixels);
        check_round_trip(&picture);
    } else {
        FUZZ_REQUIRE(error.status == STATUS_SCENE && !picture.pixels);
        fuzz_check_error(&error);
    }
    picture_deinit(&picture);
    close(file);
    return 0;
}
